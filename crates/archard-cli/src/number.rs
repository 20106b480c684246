//! Numbers as a tribologist reads them.

use archard::kinematics::Progress;
use archard::parameters::Quantity;

/// A number with four significant digits.
pub fn four(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return value.to_string();
    }
    let digits = 3 - value.abs().log10().floor() as i32;
    if (-3..=6).contains(&digits) {
        format!("{value:.*}", digits.max(0) as usize)
    } else {
        format!("{value:.3e}")
    }
}

/// Where a motion is (its own unit): "distance 250 mm".
pub fn progress(progress: Progress, value: f64) -> String {
    match progress.quantity {
        Quantity::Length => format!("{} {} mm", progress.name, four(value * 1e3)),
        _ => format!("{} {}", progress.name, four(value)),
    }
}
