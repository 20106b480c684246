//! Wear of wheel and rail by T gamma / A.
//!
//! R. Lewis and R. S. Dwyer-Joyce, *Proc. Inst. Mech. Eng. J* 218 (2004) 467, and F. Braghin, R. Lewis, R. S. Dwyer-Joyce
//! and S. Bruni, *Wear* 261 (2006) 1253: twin discs of wheel steel (R8T) on rail steel (900A), dry, lose a mass W per metre
//! rolled and per area of contact, which follows from x = T gamma / A, the work of friction per metre rolled and area. Three
//! regimes,
//!
//! W = a x, then W = b, then W = b + c (x - x2)
//!
//! with a = 5.3 ug/(N m), b = 55 ug/(m mm^2), c = 61.9 ug/(N m) and x2 = 77.2 N/mm^2. Applied pair by pair, x is the work of
//! the tractions on the slip over the distance rolled meanwhile, and the depth is W times that distance over the density.
//!
//! Published with the first regime up to x = 10.4 N/mm^2, where a x = 55.12, W falls by 0.2 % there. Here the first regime
//! ends where it meets the second, at x = b / a = 10.38 N/mm^2, so that W rises or stays everywhere. The third is written so
//! that it sets out from the second; with the constant 4778.7 = 61.9 77.2 that some programs take off it would set out from
//! zero.
//!
//! Limits: these steels, dry, and the slips of the tests, which end at about x = 119 N/mm^2.

use super::{Input, Rubbing, WearLaw};
use crate::parameters::{About, Bound, Choice, Invalid, Parameter, Quantity};

pub(super) const CHOICE: Choice<Box<dyn WearLaw>> = Choice {
    name: "t_gamma",
    meaning: "wheel on rail by x = T gamma / A: W = min(a x, b) + c max(x - x2, 0) worn off a metre rolled, depth = W / density; rolling with friction",
    parameters: &[DENSITY, MILD, SEVERE, CATASTROPHIC, TRANSITION],
    build: |values| {
        let law = TGamma::new(values.require("density")?)?;
        let given = |name, default| values.number(name).unwrap_or(default);
        Ok(Box::new(law.with_regimes(
            given("mild_slope", law.mild),
            given("severe_rate", law.severe),
            given("catastrophic_slope", law.catastrophic),
            given("catastrophic_from", law.transition),
        )?))
    },
};

pub(super) const ABOUT: About = About::new(
    CHOICE.name,
    "R. Lewis and R. S. Dwyer-Joyce, Proc. Inst. Mech. Eng. J 218 (2004) 467; F. Braghin, R. Lewis, R. S. Dwyer-Joyce and S. Bruni, Wear 261 (2006) 1253",
    "{ density = \"7850 kg/m^3\" }",
);

/// Mass over work.
const PER_WORK: Quantity = Quantity::Measured { name: "a mass per work", unit: "kg/J" };
const DENSITY: Parameter = Parameter::required(
    "density",
    Quantity::Measured { name: "a density", unit: "kg/m^3" },
    "density of the body",
);
const MILD: Parameter = Parameter::optional(
    "mild_slope",
    PER_WORK,
    "mass worn off per work, a, in the mild regime; 5.3 ug/(N m) if not given",
)
.bound(Bound::NonNegative);
const SEVERE: Parameter = Parameter::optional(
    "severe_rate",
    Quantity::Measured { name: "a mass per distance and area", unit: "kg/(m m^2)" },
    "mass worn off per metre rolled and area, b, in the severe regime; 55 ug/(m mm^2) if not given",
)
.bound(Bound::NonNegative);
const CATASTROPHIC: Parameter = Parameter::optional(
    "catastrophic_slope",
    PER_WORK,
    "mass worn off per work, c, in the catastrophic regime; 61.9 ug/(N m) if not given",
)
.bound(Bound::NonNegative);
const TRANSITION: Parameter = Parameter::optional(
    "catastrophic_from",
    Quantity::Pressure,
    "T gamma / A from which wear is catastrophic, x2; 77.2 N/mm^2 if not given",
);

/// depth = W(x) times the distance rolled over the density, x the work over the distance rolled.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TGamma {
    /// kg/m^3.
    density: f64,
    /// kg/J.
    mild: f64,
    /// kg/(m m^2).
    severe: f64,
    /// kg/J.
    catastrophic: f64,
    /// Pa.
    transition: f64,
}

impl TGamma {
    /// The law of those steels, of that density (kg/m^3).
    ///
    /// # Errors
    /// If the density is not greater than zero.
    pub fn new(density: f64) -> Result<Self, Invalid> {
        Ok(Self {
            density: DENSITY.admit(density)?,
            mild: 5.3e-9,
            severe: 55e-3,
            catastrophic: 61.9e-9,
            transition: 77.2e6,
        })
    }

    /// The law with other regimes: the slope of the mild one (kg/J), the rate of the severe one (kg/m^3), the slope of the
    /// catastrophic one (kg/J) and the work per distance rolled and area (Pa) from which that begins.
    ///
    /// # Errors
    /// If a slope or rate is negative, or the catastrophic regime begins before the mild one has ended.
    pub fn with_regimes(
        self,
        mild: f64,
        severe: f64,
        catastrophic: f64,
        transition: f64,
    ) -> Result<Self, Invalid> {
        if MILD.admit(mild)? * TRANSITION.admit(transition)? < SEVERE.admit(severe)? {
            let message = "the mild regime has not reached the rate of the severe one there";
            return Err(Invalid::new("catastrophic_from", message).beside("severe_rate"));
        }
        let catastrophic = CATASTROPHIC.admit(catastrophic)?;
        Ok(Self { mild, severe, catastrophic, transition, ..self })
    }

    /// Mass (kg) off a square metre per metre rolled.
    fn rate(&self, x: f64) -> f64 {
        (self.mild * x).min(self.severe) + self.catastrophic * (x - self.transition).max(0.0)
    }

    /// Its derivative (kg/J).
    fn rate_slope(&self, x: f64) -> f64 {
        let mild = if self.mild * x < self.severe { self.mild } else { 0.0 };
        mild + if x > self.transition { self.catastrophic } else { 0.0 }
    }
}

impl WearLaw for TGamma {
    fn inputs(&self) -> &'static [Input] {
        &[Input::Friction, Input::Rolled]
    }

    fn depth(&self, Rubbing { work, rolled, .. }: Rubbing) -> f64 {
        if rolled > 0.0 { self.rate(work.max(0.0) / rolled) * rolled / self.density } else { 0.0 }
    }

    fn slope(&self, Rubbing { work, rolled, friction, slip, .. }: Rubbing) -> f64 {
        let slope = if rolled > 0.0 { self.rate_slope(work.max(0.0) / rolled) } else { 0.0 };
        slope * friction * slip / self.density
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::super::{Rubbing, WearLaw};
    use super::TGamma;

    /// Wear (ug) of a metre rolled and a square millimetre, at T gamma / A (N/mm^2).
    fn wear(x: f64) -> f64 {
        let law = TGamma::new(7850.0).unwrap();
        let rubbing = Rubbing::new(1e9, 0.01).with_friction(1e6 * x * 2.0, 0.4).rolling(2.0);
        // A depth (m) on a square millimetre is a volume of 1e-6 m^3, of 7850 kg/m^3.
        law.depth(rubbing) / 2.0 * 1e-6 * 7850.0 * 1e9
    }

    #[test]
    fn the_regimes_meet() {
        assert_relative_eq!(wear(4.0), 5.3 * 4.0, max_relative = 1e-12);
        assert_relative_eq!(wear(10.3), 5.3 * 10.3, max_relative = 1e-12);
        for x in [55.0 / 5.3, 10.4, 30.0, 77.2] {
            assert_relative_eq!(wear(x), 55.0, max_relative = 1e-12);
        }
        assert_relative_eq!(wear(80.3), 55.0 + 61.9 * (80.3 - 77.2), max_relative = 1e-12);
    }

    /// The mild regime is the law of energy with alpha = 5.3e-6 g/(N m) over 7.85e-3 g/mm^3 = 6.75e-4 mm^3/J.
    #[test]
    fn the_mild_regime_goes_by_energy() {
        let law = TGamma::new(7850.0).unwrap();
        let depth = law.depth(Rubbing::new(1e9, 1e-3).with_friction(4e5, 0.4).rolling(1.0));
        assert_relative_eq!(1e9 * depth / 4e5, 6.7516e-4, max_relative = 1e-4);
    }

    #[test]
    fn regimes_do_not_overlap() {
        let law = TGamma::new(7850.0).unwrap();
        assert!(law.with_regimes(5.3e-9, 55e-3, 61.9e-9, 10e6).is_err());
        assert!(law.with_regimes(5.3e-9, 55e-3, 61.9e-9, 11e6).is_ok());
    }
}
