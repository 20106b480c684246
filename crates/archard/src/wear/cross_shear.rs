//! Archard's law with a coefficient that grows where directions of slip cross, as of polyethylene in joints.
//!
//! The molecules of ultra-high molecular weight polyethylene turn into the direction of sliding and resist it there; what
//! slides across them wears. Over a cycle the integral M of p e e^T over the slip, e the direction of slip, has the
//! principal orientation as the vector of its larger eigenvalue, and CS = l2 / (l1 + l2) is the share of the sliding across it:
//! 0 along one line, 1/2 in all directions equally. Where directions are spread evenly over +-a from a line,
//! CS = (1 - sin(2 a) / (2 a)) / 2, the factor of A. Wang, *Wear* 248 (2001) 38: his k = 2 k1 CS. L. Kang, A. L. Galvin,
//! T. D. Brown, Z. Jin and J. Fisher, *J. Biomech.* 41 (2008) 340, have k grow with CS from a value of its own in one line.
//!
//! depth = k p s, k = k0 + (k1 - k0) (2 CS)^n
//!
//! Limits: what turns the molecules is one cycle, not what went before; k does not depend on the pressure, and the polymer
//! does not creep.

use super::{Input, Per, Rubbing, WearLaw};
use crate::parameters::{About, Bound, Choice, Invalid, Parameter, Quantity};

pub(super) const CHOICE: Choice<Box<dyn WearLaw>> = Choice {
    name: "cross_shear",
    meaning: "Archard with a coefficient that grows where slip crosses itself: k = k0 + (k1 - k0) (2 CS)^n, CS the share of slip across the main direction of a cycle; cycles",
    parameters: &[ALONG, ACROSS, EXPONENT],
    build: |values| {
        let [along, across] = ["unidirectional_coefficient", "multidirectional_coefficient"]
            .map(|name| values.require(name));
        let law = CrossShear::new([along?, across?])?;
        Ok(Box::new(law.with_exponent(values.number("exponent").unwrap_or(1.0))?))
    },
};

pub(super) const ABOUT: About = About::new(
    CHOICE.name,
    "A. Wang, Wear 248 (2001) 38; L. Kang, A. L. Galvin, T. D. Brown, Z. Jin and J. Fisher, J. Biomech. 41 (2008) 340",
    "{ unidirectional_coefficient = \"1e-8 mm^3/(N m)\", multidirectional_coefficient = \"1e-6 mm^3/(N m)\" }",
);

const ALONG: Parameter = Parameter::required(
    "unidirectional_coefficient",
    Quantity::WearCoefficient,
    "wear coefficient k0 of slip along one line",
)
.bound(Bound::NonNegative);
const ACROSS: Parameter = Parameter::required(
    "multidirectional_coefficient",
    Quantity::WearCoefficient,
    "wear coefficient k1 of slip, the same in all directions",
)
.bound(Bound::NonNegative);
const EXPONENT: Parameter =
    Parameter::optional("exponent", Quantity::Number, "exponent n; 1 if not given");

/// depth = (k0 + (k1 - k0) (2 CS)^n) p s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CrossShear {
    coefficients: [f64; 2],
    exponent: f64,
}

impl CrossShear {
    /// The law with the wear coefficients (1/Pa) of slip along one line and of slip in all directions equally, linear in
    /// between.
    ///
    /// # Errors
    /// If a coefficient is negative.
    pub fn new([along, across]: [f64; 2]) -> Result<Self, Invalid> {
        Ok(Self { coefficients: [ALONG.admit(along)?, ACROSS.admit(across)?], exponent: 1.0 })
    }

    /// The law with another exponent.
    ///
    /// # Errors
    /// If it is not greater than zero.
    pub fn with_exponent(self, exponent: f64) -> Result<Self, Invalid> {
        Ok(Self { exponent: EXPONENT.admit(exponent)?, ..self })
    }
}

impl WearLaw for CrossShear {
    fn inputs(&self) -> &'static [Input] {
        &[Input::CrossShear]
    }

    fn per(&self) -> Per {
        Per::Cycle
    }

    fn depth(&self, rubbing: Rubbing) -> f64 {
        self.slope(rubbing) * rubbing.pressure
    }

    fn slope(&self, rubbing: Rubbing) -> f64 {
        let [along, across] = self.coefficients;
        let share = (2.0 * rubbing.cross_shear()).powf(self.exponent);
        (along + (across - along) * share) * rubbing.slip
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::super::{Rubbing, WearLaw};
    use super::CrossShear;

    /// A cycle of many short slips of one length (m) in directions (rad).
    fn cycle(directions: impl Iterator<Item = f64>) -> Rubbing {
        let part = |angle: f64| {
            let (sin, cos) = angle.sin_cos();
            Rubbing::new(2e6, 1e-4).with_vectors([1e-4 * cos, 1e-4 * sin], [0.0; 2])
        };
        directions.map(part).reduce(Rubbing::then).expect("a slip")
    }

    /// Directions spread evenly over +-a.
    fn spread(half: f64) -> Rubbing {
        cycle((0..2000).map(|part| half * ((f64::from(part) + 0.5) / 1000.0 - 1.0) + 0.4))
    }

    #[test]
    fn spread_directions_have_wangs_factor() {
        for half in [0.1_f64, 0.5, 1.0, 1.5] {
            let expected = 0.5 * (1.0 - (2.0 * half).sin() / (2.0 * half));
            assert_relative_eq!(spread(half).cross_shear(), expected, max_relative = 2e-5);
        }
    }

    #[test]
    fn lines_wear_by_the_one_coefficient_and_circles_by_the_other() {
        let law = CrossShear::new([1e-16, 5e-16]).unwrap().with_exponent(0.2).unwrap();
        let per = |rubbing: Rubbing| 1e16 * law.depth(rubbing) / (rubbing.pressure * rubbing.slip);
        let turn = std::f64::consts::PI;
        let there_and_back = cycle((0..10).map(|part| 0.7 + turn * f64::from(part)));
        assert_eq!(there_and_back.cross_shear(), 0.0);
        assert_relative_eq!(per(there_and_back), 1.0, max_relative = 1e-12);
        assert_relative_eq!(per(spread(turn)), 5.0, max_relative = 1e-12);
        assert_eq!(law.depth(Rubbing::new(2e6, 0.0).with_vectors([0.0; 2], [0.0; 2])), 0.0);
    }

    /// More pressure on the same path crosses it no more.
    #[test]
    fn pressure_leaves_the_directions() {
        let (one, law) = (spread(0.8), CrossShear::new([1e-16, 5e-16]).unwrap());
        let other = one.under(3.0 * one.pressure);
        assert_relative_eq!(one.cross_shear(), other.cross_shear(), max_relative = 1e-12);
        assert_relative_eq!(1e9 * law.depth(other), 3e9 * law.depth(one), max_relative = 1e-12);
    }
}
