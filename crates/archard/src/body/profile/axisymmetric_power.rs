//! The power-law punch of revolution: a cone, a paraboloid, and blunter shapes (Galin; Sneddon).

use super::Profile;
use super::power::PARAMETERS;
use crate::parameters::Choice;

pub(super) const CHOICE: Choice<Box<dyn Profile>> = Choice {
    name: "axisymmetric_power",
    meaning: "gap = c r^n, r the distance from the axis: a cone of slope c with n = 1",
    parameters: PARAMETERS,
    build: |values| {
        Ok(Box::new(AxisymmetricPower {
            coefficient: values.require("coefficient")?,
            exponent: values.require("exponent")?,
        }))
    },
};

/// recess = c r^n.
#[derive(Debug)]
struct AxisymmetricPower {
    /// c (m^(1 - n)).
    coefficient: f64,
    /// n.
    exponent: f64,
}

impl Profile for AxisymmetricPower {
    fn recess(&self, x: f64, y: f64) -> f64 {
        self.coefficient * x.hypot(y).powf(self.exponent)
    }

    fn curvatures(&self) -> Option<[f64; 2]> {
        (self.exponent == 2.0).then_some([2.0 * self.coefficient; 2])
    }
}
