//! The power-law punch of the paper's section 6.1.

use super::Profile;
use crate::parameters::{Choice, Parameter, Quantity};

pub(super) const CHOICE: Choice<Box<dyn Profile>> = Choice {
    name: "power",
    meaning: "gap = c (|x|^n + |y|^n): with n = 1 a pyramid",
    parameters: PARAMETERS,
    build: |values| {
        Ok(Box::new(Power {
            coefficient: values.require("coefficient")?,
            exponent: values.require("exponent")?,
        }))
    },
};

/// The factor and the exponent of a power.
pub(super) const PARAMETERS: &[Parameter] = &[
    Parameter::required(
        "coefficient",
        Quantity::PowerFactor { exponent: "exponent" },
        "the factor c",
    ),
    Parameter::required("exponent", Quantity::Number, "the exponent n"),
];

/// recess = c (|x|^n + |y|^n).
#[derive(Debug)]
struct Power {
    /// c (m^(1 - n)).
    coefficient: f64,
    /// n.
    exponent: f64,
}

impl Profile for Power {
    fn recess(&self, x: f64, y: f64) -> f64 {
        self.coefficient * (x.abs().powf(self.exponent) + y.abs().powf(self.exponent))
    }

    fn curvatures(&self) -> Option<[f64; 2]> {
        (self.exponent == 2.0).then_some([2.0 * self.coefficient; 2])
    }
}
