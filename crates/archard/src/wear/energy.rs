//! Wear by the work of friction.
//!
//! S. Fouvry, C. Paulin and T. Liskiewicz, *Tribol. Int.* 40 (2007) 1428: the depth grows in proportion to the work of
//! friction per area W, and in a cycle only by what goes beyond a threshold W0, depth = alpha max(W - W0, 0). Where all
//! slides under Coulomb's law W = mu p s, and the law without threshold is Archard's with k = alpha mu.
//!
//! Limits: all work wears equally, whatever the pressure, the speed and the temperature. Debris is not followed.

use super::{Input, Per, Rubbing, WearLaw};
use crate::parameters::{About, Bound, Choice, Invalid, Parameter, Quantity};

pub(super) const CHOICE: Choice<Box<dyn WearLaw>> = Choice {
    name: "energy",
    meaning: "by the work of friction W per area: depth = alpha W, or alpha max(W - W0, 0) a cycle; any motion with friction, with a threshold in cycles",
    parameters: &[COEFFICIENT, THRESHOLD],
    build: |values| {
        let threshold = values.number("threshold").unwrap_or(0.0);
        Ok(Box::new(Energy::new(values.require("coefficient")?, threshold)?))
    },
};

pub(super) const ABOUT: About = About::new(
    CHOICE.name,
    "S. Fouvry, C. Paulin and T. Liskiewicz, Tribol. Int. 40 (2007) 1428",
    "{ coefficient = \"1e-5 mm^3/J\", threshold = \"100 J/m^2\" }",
);

const COEFFICIENT: Parameter = Parameter::required(
    "coefficient",
    Quantity::WearCoefficient,
    "volume worn off per work of friction, alpha",
)
.bound(Bound::NonNegative);
const THRESHOLD: Parameter = Parameter::optional(
    "threshold",
    Quantity::Measured { name: "a work per area", unit: "J/m^2" },
    "work of friction per area and cycle that wears nothing, W0; 0 if not given",
)
.bound(Bound::NonNegative);

/// depth = alpha max(W - W0, 0), W0 that of a cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Energy {
    coefficient: f64,
    threshold: f64,
}

impl Energy {
    /// The law with the coefficient alpha (1/Pa, the same as m^3/J; 1 mm^3/J is 1e-9 1/Pa) and the work per area
    /// (J/m^2) in a cycle below which nothing wears. With a threshold of zero it takes any part of a motion, otherwise
    /// whole cycles.
    ///
    /// # Errors
    /// If either is negative.
    pub fn new(coefficient: f64, threshold: f64) -> Result<Self, Invalid> {
        Ok(Self {
            coefficient: COEFFICIENT.admit(coefficient)?,
            threshold: THRESHOLD.admit(threshold)?,
        })
    }
}

impl WearLaw for Energy {
    fn inputs(&self) -> &'static [Input] {
        &[Input::Friction]
    }

    fn per(&self) -> Per {
        if self.threshold > 0.0 { Per::Cycle } else { Per::Increment }
    }

    fn depth(&self, rubbing: Rubbing) -> f64 {
        self.coefficient * (rubbing.work - self.threshold).max(0.0)
    }

    fn slope(&self, rubbing: Rubbing) -> f64 {
        let wears = rubbing.work >= self.threshold;
        if wears { self.coefficient * rubbing.friction * rubbing.slip } else { 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::super::{Archard, Per, Rubbing, WearLaw};
    use super::Energy;

    /// Archard's law with k = alpha mu.
    #[test]
    fn under_coulombs_law_it_is_archards() {
        let (energy, archard) = (Energy::new(1e-12, 0.0).unwrap(), Archard::new(0.3e-12).unwrap());
        let rubbing = Rubbing::new(2e8, 0.1).with_friction(0.3 * 2e8 * 0.1, 0.3);
        let millions = |depth: f64| 1e6 * depth;
        let [one, other] = [energy.depth(rubbing), archard.depth(rubbing)].map(millions);
        assert_relative_eq!(one, other, max_relative = 1e-14);
        let [one, other] = [energy.slope(rubbing), archard.slope(rubbing)].map(|k| 1e12 * k);
        assert_relative_eq!(one, other, max_relative = 1e-14);
        assert_eq!(energy.per(), Per::Increment);
    }

    /// A cycle of 600 J/m^2 wears by the 100 beyond the threshold.
    #[test]
    fn a_threshold_counts_once_a_cycle() {
        let energy = Energy::new(1e-12, 500.0).unwrap();
        assert_eq!(energy.per(), Per::Cycle);
        let half = Rubbing::new(1e6, 1e-3).with_friction(300.0, 0.3);
        assert_eq!(energy.depth(half), 0.0);
        assert_relative_eq!(1e10 * energy.depth(half.then(half)), 1.0, max_relative = 1e-14);
        assert_relative_eq!(1e15 * energy.slope(half.then(half)), 0.6, max_relative = 1e-14);
    }
}
