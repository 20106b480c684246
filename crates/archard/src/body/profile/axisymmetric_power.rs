//! The power-law punch of revolution: a cone, a paraboloid, and blunter shapes (Galin; Sneddon).

use super::Profile;
use super::power::PARAMETERS;
use crate::parameters::{Choice, Invalid};

pub(super) const CHOICE: Choice<Box<dyn Profile>> = Choice {
    name: "axisymmetric_power",
    meaning: "gap = c r^n, r the distance from the axis: a cone of slope c with n = 1",
    parameters: &PARAMETERS,
    build: |values| {
        let [coefficient, exponent] = ["coefficient", "exponent"].map(|name| values.require(name));
        Ok(Box::new(AxisymmetricPower::new(coefficient?, exponent?)?))
    },
};

/// recess = c r^n.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AxisymmetricPower {
    /// c (m^(1 - n)).
    coefficient: f64,
    /// n.
    exponent: f64,
}

impl AxisymmetricPower {
    /// The surface with that factor c (m^(1 - n)) and exponent n.
    ///
    /// # Errors
    /// If one is not greater than zero.
    pub fn new(coefficient: f64, exponent: f64) -> Result<Self, Invalid> {
        let [c, n] = PARAMETERS;
        Ok(Self { coefficient: c.admit(coefficient)?, exponent: n.admit(exponent)? })
    }
}

impl Profile for AxisymmetricPower {
    fn recess(&self, x: f64, y: f64) -> f64 {
        self.coefficient * x.hypot(y).powf(self.exponent)
    }

    fn sharpest(&self) -> f64 {
        self.exponent.min(2.0)
    }

    fn curvatures(&self) -> Option<[f64; 2]> {
        (self.exponent == 2.0).then_some([2.0 * self.coefficient; 2])
    }
}
