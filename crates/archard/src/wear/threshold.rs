//! Archard's law beyond a threshold of pressure.
//!
//! depth = k max(p - pc, 0) s: Archard's law, shifted by the pressure that a surface bears without measurable wear. The
//! threshold of a work per cycle belongs to the law `energy`.
//!
//! Limits: pressures up to the threshold never wear, however far a pair slides.

use super::{Rubbing, WearLaw};
use crate::parameters::{About, Bound, Choice, Invalid, Parameter, Quantity};

pub(super) const CHOICE: Choice<Box<dyn WearLaw>> = Choice {
    name: "threshold",
    meaning: "Archard beyond a pressure: depth = k max(p - pc, 0) s; any motion",
    parameters: &[COEFFICIENT, THRESHOLD],
    build: |values| {
        let [coefficient, threshold] =
            ["coefficient", "threshold"].map(|name| values.require(name));
        Ok(Box::new(Threshold::new(coefficient?, threshold?)?))
    },
};

pub(super) const ABOUT: About = About::new(
    CHOICE.name,
    "Archard's law, shifted by the pressure that wears nothing",
    "{ coefficient = \"1e-6 mm^3/(N m)\", threshold = \"50 MPa\" }",
);

const COEFFICIENT: Parameter =
    Parameter::required("coefficient", Quantity::WearCoefficient, "wear coefficient k")
        .bound(Bound::NonNegative);
const THRESHOLD: Parameter =
    Parameter::required("threshold", Quantity::Pressure, "pressure pc up to which nothing wears")
        .bound(Bound::NonNegative);

/// depth = k max(p - pc, 0) s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Threshold {
    coefficient: f64,
    threshold: f64,
}

impl Threshold {
    /// The law with a wear coefficient k (1/Pa) and the pressure pc (Pa) up to which nothing wears.
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

impl WearLaw for Threshold {
    fn depth(&self, rubbing: Rubbing) -> f64 {
        self.coefficient * (rubbing.pressure - self.threshold).max(0.0) * rubbing.slip
    }

    fn slope(&self, rubbing: Rubbing) -> f64 {
        let wears = rubbing.pressure >= self.threshold;
        if wears { self.coefficient * rubbing.slip } else { 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::super::{Rubbing, WearLaw};
    use super::Threshold;

    #[test]
    fn only_what_is_beyond_the_threshold_wears() {
        let law = Threshold::new(1e-13, 3e7).unwrap();
        assert_eq!(law.depth(Rubbing::new(3e7, 1.0)), 0.0);
        assert_eq!(law.slope(Rubbing::new(2e7, 1.0)), 0.0);
        let depth = law.depth(Rubbing::new(5e7, 2.0));
        assert_relative_eq!(1e6 * depth, 4.0, max_relative = 1e-14);
    }
}
