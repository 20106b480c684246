//! What is wrong with values.

/// A value that cannot be used, named by its parameter.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("`{parameter}`: {message}")]
pub struct Invalid {
    /// The parameter to change.
    pub parameter: &'static str,
    /// What is wrong and what to do.
    pub message: String,
}

impl Invalid {
    /// An error at that parameter.
    pub fn new(parameter: &'static str, message: impl Into<String>) -> Self {
        Self { parameter, message: message.into() }
    }

    /// The value, if it is finite.
    pub(crate) fn finite(parameter: &'static str, value: f64) -> Result<f64, Self> {
        if value.is_finite() {
            Ok(value)
        } else {
            Err(Self::new(parameter, format!("{value} is not a finite number")))
        }
    }

    /// The value, if it is finite and greater than zero.
    pub(crate) fn positive(parameter: &'static str, value: f64) -> Result<f64, Self> {
        if Self::finite(parameter, value)? > 0.0 {
            Ok(value)
        } else {
            Err(Self::new(parameter, format!("{value} has to be greater than zero")))
        }
    }

    /// The value, if its size is below that bound.
    pub(crate) fn within(parameter: &'static str, value: f64, bound: f64) -> Result<f64, Self> {
        if Self::finite(parameter, value)?.abs() < bound {
            Ok(value)
        } else {
            Err(Self::new(parameter, format!("{value} has to lie between -{bound} and {bound}")))
        }
    }
}
