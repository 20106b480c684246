//! The power-law punch of the paper's section 6.1.

use super::Profile;
use crate::parameters::{Choice, Invalid, Parameter, Quantity};

pub(super) const CHOICE: Choice<Box<dyn Profile>> = Choice {
    name: "power",
    meaning: "gap = c (|x|^n + |y|^n): with n = 1 a pyramid",
    parameters: &PARAMETERS,
    build: |values| {
        let [coefficient, exponent] = ["coefficient", "exponent"].map(|name| values.require(name));
        Ok(Box::new(Power::new(coefficient?, exponent?)?))
    },
};

/// The factor and the exponent of a power.
pub(super) const PARAMETERS: [Parameter; 2] = [
    Parameter::required(
        "coefficient",
        Quantity::PowerFactor { exponent: "exponent" },
        "the factor c",
    ),
    Parameter::required("exponent", Quantity::Number, "the exponent n"),
];

/// recess = c (|x|^n + |y|^n).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Power {
    /// c (m^(1 - n)).
    coefficient: f64,
    /// n.
    exponent: f64,
}

impl Power {
    /// The surface with that factor c (m^(1 - n)) and exponent n.
    ///
    /// # Errors
    /// If one is not greater than zero.
    pub fn new(coefficient: f64, exponent: f64) -> Result<Self, Invalid> {
        let [c, n] = PARAMETERS;
        Ok(Self { coefficient: c.admit(coefficient)?, exponent: n.admit(exponent)? })
    }
}

impl Profile for Power {
    fn recess(&self, x: f64, y: f64) -> f64 {
        self.coefficient * (x.abs().powf(self.exponent) + y.abs().powf(self.exponent))
    }

    fn sharpest(&self) -> f64 {
        self.exponent.min(2.0)
    }

    fn curvatures(&self) -> Option<[f64; 2]> {
        (self.exponent == 2.0).then_some([2.0 * self.coefficient; 2])
    }
}
