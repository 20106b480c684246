//! Coulomb's law.
//!
//! A pair bears mu times its pressure and slips once that is reached (the paper's eq. 9).

use super::Friction;
use crate::parameters::{Bound, Choice, Parameter, Quantity};

pub(super) const CHOICE: Choice<Box<dyn Friction>> = Choice {
    name: "coulomb",
    meaning: "Coulomb: the largest traction is mu times the pressure",
    parameters: &[Parameter::required(
        "coefficient",
        Quantity::Number,
        "coefficient of friction mu",
    )
    .bound(Bound::NonNegative)],
    build: |values| Ok(Box::new(Coulomb { coefficient: values.require("coefficient")? })),
};

/// limit = mu p.
#[derive(Debug)]
struct Coulomb {
    /// mu.
    coefficient: f64,
}

impl Friction for Coulomb {
    fn limit(&self, pressure: f64) -> f64 {
        self.coefficient * pressure
    }

    fn slope(&self, _pressure: f64) -> f64 {
        self.coefficient
    }
}
