//! Numbers in units people read.

/// A number with three significant digits.
pub(super) fn three(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return value.to_string();
    }
    let digits = 2 - value.abs().log10().floor() as i32;
    if (-3..=6).contains(&digits) {
        format!("{value:.*}", digits.max(0) as usize)
    } else {
        format!("{value:.2e}")
    }
}

/// A length (m) in mm, or in um below a tenth of one.
pub(super) fn length(metres: f64) -> String {
    if metres.abs() < 1e-4 {
        format!("{} um", three(metres * 1e6))
    } else {
        format!("{} mm", three(metres * 1e3))
    }
}

/// A radius (m) in mm to six digits, by which nearly conforming ones differ.
pub(super) fn radius(metres: f64) -> String {
    let millimetres: f64 = format!("{:.5e}", metres * 1e3).parse().unwrap_or(metres * 1e3);
    format!("{millimetres} mm")
}

/// A pressure (Pa) in MPa.
pub(super) fn pressure(pascals: f64) -> String {
    format!("{} MPa", three(pascals * 1e-6))
}

/// Sizes (m) as a case file takes them, rounded down.
pub(super) fn size_list(sizes: [f64; 2]) -> String {
    list(sizes, f64::floor)
}

/// Sizes (m) as a case file takes them, rounded up.
pub(super) fn size_list_up(sizes: [f64; 2]) -> String {
    list(sizes, f64::ceil)
}

/// Sizes (m) in mm with two significant digits.
fn list(sizes: [f64; 2], round: fn(f64) -> f64) -> String {
    let [x, y] = sizes.map(|size| {
        let millimetres = size * 1e3;
        let digits = 1_i32.saturating_sub(millimetres.log10().floor() as i32);
        let unit = 10f64.powi(digits);
        format!("{:.*}", digits.max(0) as usize, round(millimetres * unit) / unit)
    });
    format!("[\"{x} mm\", \"{y} mm\"]")
}

/// "a", "a and b", "a, b and c".
pub(super) fn both(words: &[&str]) -> String {
    match words {
        [] => String::new(),
        [one] => (*one).to_owned(),
        [rest @ .., last] => format!("{} and {last}", rest.join(", ")),
    }
}
