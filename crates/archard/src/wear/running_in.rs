//! Archard's law with a coefficient that runs in.
//!
//! k(s) = k1 + (k0 - k1) exp(-s / s0), s the distance that the point itself has slid: the coefficient of fresh surfaces k0
//! decays to that of surfaces that have run in, k1. The depth is the integral of k p over the slip, in closed form.
//!
//! Limits: what runs a surface in is the distance alone, whatever the pressure it was slid under.

use super::{Input, Rubbing, WearLaw};
use crate::parameters::{About, Bound, Choice, Invalid, Parameter, Quantity};

pub(super) const CHOICE: Choice<Box<dyn WearLaw>> = Choice {
    name: "running_in",
    meaning: "Archard with a coefficient that runs in: k = k1 + (k0 - k1) exp(-s / s0), s the point's distance; any motion",
    parameters: &[INITIAL, FINAL, DISTANCE],
    build: |values| {
        let [initial, end, distance] =
            ["initial_coefficient", "final_coefficient", "running_in_distance"]
                .map(|name| values.require(name));
        Ok(Box::new(RunningIn::new([initial?, end?], distance?)?))
    },
};

pub(super) const ABOUT: About = About::new(
    CHOICE.name,
    "Archard's law with a coefficient that decays exponentially over the distance",
    "{ initial_coefficient = \"1e-5 mm^3/(N m)\", final_coefficient = \"1e-6 mm^3/(N m)\", running_in_distance = \"20 m\" }",
);

const INITIAL: Parameter = Parameter::required(
    "initial_coefficient",
    Quantity::WearCoefficient,
    "wear coefficient k0 of the fresh surface",
)
.bound(Bound::NonNegative);
const FINAL: Parameter = Parameter::required(
    "final_coefficient",
    Quantity::WearCoefficient,
    "wear coefficient k1 of the surface that has run in",
)
.bound(Bound::NonNegative);
const DISTANCE: Parameter = Parameter::required(
    "running_in_distance",
    Quantity::Length,
    "distance slid s0 over which the difference falls to 1 / e",
);

/// depth = p (k1 s + (k0 - k1) s0 (1 - exp(-s / s0)) exp(-S / s0)) after a distance S.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RunningIn {
    coefficients: [f64; 2],
    distance: f64,
}

impl RunningIn {
    /// The law with the wear coefficients (1/Pa) of the fresh surface and of the one that has run in, and the distance
    /// slid (m) over which their difference falls to 1 / e.
    ///
    /// # Errors
    /// If a coefficient is negative, or the distance not greater than zero.
    pub fn new([initial, end]: [f64; 2], distance: f64) -> Result<Self, Invalid> {
        Ok(Self {
            coefficients: [INITIAL.admit(initial)?, FINAL.admit(end)?],
            distance: DISTANCE.admit(distance)?,
        })
    }
}

impl WearLaw for RunningIn {
    fn inputs(&self) -> &'static [Input] {
        &[Input::Distance]
    }

    fn depth(&self, rubbing: Rubbing) -> f64 {
        rubbing.pressure * self.slope(rubbing)
    }

    fn slope(&self, Rubbing { slip, distance, .. }: Rubbing) -> f64 {
        let [initial, end] = self.coefficients;
        let left = (-distance / self.distance).exp();
        let run_in = -self.distance * (-slip / self.distance).exp_m1() * left;
        end * slip + (initial - end) * run_in
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::super::{Rubbing, WearLaw};
    use super::RunningIn;

    /// The integral of k(s) p, against a sum of a million parts.
    #[test]
    fn the_depth_is_the_integral_over_the_slip() {
        let law = RunningIn::new([5e-13, 1e-13], 0.2).unwrap();
        let depth = law.depth(Rubbing::new(1e8, 0.5).after(0.1, 0.0));
        let part = 0.5e-6;
        let middles = (0..1_000_000).map(|index| 0.1 + (f64::from(index) + 0.5) * part);
        let sum: f64 = middles.map(|s| 1e-13 + 4e-13 * (-s / 0.2).exp()).sum();
        assert_relative_eq!(1e6 * depth, 1e6 * 1e8 * part * sum, max_relative = 1e-10);
    }

    #[test]
    fn it_begins_and_ends_as_archards() {
        let law = RunningIn::new([5e-13, 1e-13], 0.2).unwrap();
        let slope = |distance| law.slope(Rubbing::new(1e8, 1e-9).after(distance, 0.0));
        assert_relative_eq!(1e22 * slope(0.0), 5.0, max_relative = 1e-8);
        assert_relative_eq!(1e22 * slope(1e3), 1.0, max_relative = 1e-12);
    }
}
