//! Values within their bounds.

use archard::parameters::Invalid;

/// The value, if it is finite.
pub(crate) fn finite(parameter: &'static str, value: f64) -> Result<f64, Invalid> {
    if value.is_finite() {
        Ok(value)
    } else {
        Err(Invalid::new(parameter, format!("{value} is not a finite number")))
    }
}

/// The value, if it is finite and greater than zero.
pub(crate) fn positive(parameter: &'static str, value: f64) -> Result<f64, Invalid> {
    if finite(parameter, value)? > 0.0 {
        Ok(value)
    } else {
        Err(Invalid::new(parameter, format!("{value} has to be greater than zero")))
    }
}

/// The value, if its size is below that bound.
pub(crate) fn within(parameter: &'static str, value: f64, bound: f64) -> Result<f64, Invalid> {
    if finite(parameter, value)?.abs() < bound {
        Ok(value)
    } else {
        Err(Invalid::new(parameter, format!("{value} has to lie between -{bound} and {bound}")))
    }
}
