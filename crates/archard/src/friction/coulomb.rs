//! Coulomb's law.
//!
//! A pair bears mu times its pressure and slips once that is reached (the paper's eq. 9).

use super::Friction;
use crate::parameters::{About, Bound, Choice, Invalid, Parameter, Quantity};

pub(super) const CHOICE: Choice<Box<dyn Friction>> = Choice {
    name: "coulomb",
    meaning: "Coulomb: the largest traction is mu times the pressure; any motion",
    parameters: &[COEFFICIENT],
    build: |values| Ok(Box::new(Coulomb::new(values.require("coefficient")?)?)),
};

pub(super) const ABOUT: About = About::new(
    CHOICE.name,
    "C. A. Coulomb, Theorie des machines simples (1785)",
    "{ coefficient = 0.3 }",
);

const COEFFICIENT: Parameter =
    Parameter::required("coefficient", Quantity::Number, "coefficient of friction mu")
        .bound(Bound::NonNegative);

/// limit = mu p.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coulomb {
    coefficient: f64,
}

impl Coulomb {
    /// The law with that coefficient of friction mu.
    ///
    /// # Errors
    /// If the coefficient is negative.
    pub fn new(coefficient: f64) -> Result<Self, Invalid> {
        Ok(Self { coefficient: COEFFICIENT.admit(coefficient)? })
    }
}

impl Friction for Coulomb {
    fn limit(&self, pressure: f64) -> f64 {
        self.coefficient * pressure
    }

    fn slope(&self, _pressure: f64) -> f64 {
        self.coefficient
    }
}
