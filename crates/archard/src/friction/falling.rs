//! Coulomb's law with a coefficient that falls with the speed of sliding.
//!
//! mu = mu_1 + (mu_0 - mu_1) exp(-v / v_0). O. Polach, *Wear* 258 (2005) 992, has it for wheels on rails as
//! mu_0 ((1 - A) exp(-B v) + A): A is mu_1 / mu_0 and B is 1 / v_0. Finite element programs call it exponential decay.

use super::{Circumstance, Circumstances, Friction};
use crate::parameters::{About, Bound, Choice, Invalid, Parameter, Quantity};

pub(super) const CHOICE: Choice<Box<dyn Friction>> = Choice {
    name: "falling",
    meaning: "Coulomb with a coefficient that falls with the speed at which the bodies slide over each other, mu_1 + (mu_0 - mu_1) exp(-v / v_0); any motion that gives it",
    parameters: &[COEFFICIENT, LEAST, SPEED],
    build: |values| {
        let [coefficient, least, speed] =
            ["coefficient", "least", "speed"].map(|name| values.require(name));
        Ok(Box::new(FallingFriction::new(coefficient?, least?, speed?)?))
    },
};

pub(super) const ABOUT: About = About::new(
    CHOICE.name,
    "O. Polach, Wear 258 (2005) 992",
    "{ coefficient = 0.55, least = 0.22, speed = \"1.7 m/s\" }",
);

const COEFFICIENT: Parameter =
    Parameter::required("coefficient", Quantity::Number, "coefficient of friction mu_0 at rest")
        .bound(Bound::NonNegative);
const LEAST: Parameter = Parameter::required(
    "least",
    Quantity::Number,
    "coefficient of friction mu_1 that is left at high speeds",
)
.bound(Bound::NonNegative);
const SPEED: Parameter = Parameter::required(
    "speed",
    Quantity::Speed,
    "speed v_0 at which 1/e of the difference is left",
);

/// limit = (mu_1 + (mu_0 - mu_1) exp(-v / v_0)) p.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FallingFriction {
    coefficient: f64,
    least: f64,
    speed: f64,
}

impl FallingFriction {
    /// The law with coefficients of friction mu_0 at rest and mu_1 at high speeds, and the speed v_0 (m/s).
    ///
    /// # Errors
    /// If a coefficient is negative, or the speed not greater than zero.
    pub fn new(coefficient: f64, least: f64, speed: f64) -> Result<Self, Invalid> {
        Ok(Self {
            coefficient: COEFFICIENT.admit(coefficient)?,
            least: LEAST.admit(least)?,
            speed: SPEED.admit(speed)?,
        })
    }
}

impl Friction for FallingFriction {
    fn limit(&self, pressure: f64) -> f64 {
        pressure
    }

    fn slope(&self, _: f64) -> f64 {
        1.0
    }

    fn inputs(&self) -> &[Circumstance] {
        &[Circumstance::Speed]
    }

    fn factor(&self, at: Circumstances) -> f64 {
        self.least + (self.coefficient - self.least) * (-at.speed / self.speed).exp()
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Circumstances, Friction};
    use super::FallingFriction;

    /// Polach's values of a dry rail: A = 0.4 and B = 0.6 s/m of mu_0 = 0.55.
    #[test]
    fn the_coefficient_is_that_of_polach() {
        let (mu, a, b) = (0.55, 0.4, 0.6);
        let law = FallingFriction::new(mu, a * mu, 1.0 / b).unwrap();
        for speed in [0.0, 0.5, 3.0] {
            let expected = mu * ((1.0 - a) * f64::exp(-b * speed) + a);
            let factor = law.factor(Circumstances { speed, ..Circumstances::default() });
            assert!((factor - expected).abs() < 1e-15, "{factor} {expected}");
        }
        assert!(
            FallingFriction::new(mu, -0.1, 1.0).is_err()
                && FallingFriction::new(mu, 0.1, 0.0).is_err()
        );
    }
}
