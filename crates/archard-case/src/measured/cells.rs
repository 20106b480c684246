//! Numbers in cells, with a decimal point or a decimal comma.

use archard::units::Scale;

/// The value of a cell (SI); `None` where it is not a finite number.
pub(super) fn value(text: &str, scale: &Scale) -> Option<f64> {
    match text.split_once(',') {
        // A second comma, or a point next to it, would be a separator of thousands.
        Some((whole, rest)) if !rest.contains([',', '.']) && !whole.contains('.') => {
            scale.apply(&format!("{whole}.{rest}"))
        }
        Some(_) => None,
        None => scale.apply(text),
    }
}

/// Whether a cell is a number with that decimal sign.
pub(super) fn has(text: &str, sign: char) -> bool {
    let Some((whole, rest)) = text.split_once(sign) else { return false };
    format!("{whole}.{rest}").parse::<f64>().is_ok()
}

/// Whether a number may be one with a separator of thousands, like 1,500.
pub(super) fn may_be_thousands(text: &str) -> bool {
    text.trim_start_matches(['+', '-']).split_once(',').is_some_and(|(whole, rest)| {
        !whole.starts_with('0') && (1..=3).contains(&whole.len()) && rest.len() == 3
    })
}
