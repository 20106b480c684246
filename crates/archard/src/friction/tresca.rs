//! Coulomb's law up to the shear strength of the softer surface.
//!
//! E. Orowan, *Proc. Inst. Mech. Eng.* 150 (1943) 140: a pair bears mu times its pressure, but no more than the material
//! below it, limit = min(mu p, tau_max).

use super::Friction;
use crate::parameters::{About, Bound, Choice, Invalid, Parameter, Quantity};

pub(super) const CHOICE: Choice<Box<dyn Friction>> = Choice {
    name: "tresca",
    meaning: "Coulomb up to a shear strength: the largest traction is min(mu p, tau_max); any motion",
    parameters: &[COEFFICIENT, STRENGTH],
    build: |values| {
        let [coefficient, strength] =
            ["coefficient", "shear_strength"].map(|name| values.require(name));
        Ok(Box::new(Tresca::new(coefficient?, strength?)?))
    },
};

pub(super) const ABOUT: About = About::new(
    CHOICE.name,
    "E. Orowan, Proc. Inst. Mech. Eng. 150 (1943) 140",
    "{ coefficient = 0.6, shear_strength = \"400 MPa\" }",
);

const COEFFICIENT: Parameter =
    Parameter::required("coefficient", Quantity::Number, "coefficient of friction mu")
        .bound(Bound::NonNegative);
const STRENGTH: Parameter =
    Parameter::required("shear_strength", Quantity::Pressure, "largest traction tau_max");

/// limit = min(mu p, tau_max).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tresca {
    coefficient: f64,
    strength: f64,
}

impl Tresca {
    /// The law with that coefficient of friction mu and shear strength tau_max (Pa).
    ///
    /// # Errors
    /// If the coefficient is negative, or the strength not greater than zero.
    pub fn new(coefficient: f64, strength: f64) -> Result<Self, Invalid> {
        Ok(Self {
            coefficient: COEFFICIENT.admit(coefficient)?,
            strength: STRENGTH.admit(strength)?,
        })
    }
}

impl Friction for Tresca {
    fn limit(&self, pressure: f64) -> f64 {
        (self.coefficient * pressure).min(self.strength)
    }

    fn slope(&self, pressure: f64) -> f64 {
        if self.coefficient * pressure < self.strength { self.coefficient } else { 0.0 }
    }
}
