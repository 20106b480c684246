//! How far a state is from contact: one measure for every solver.

use super::Step;
use crate::motion::Control;
use crate::numerics::vector;

/// The measure for one step.
#[derive(Debug, Clone, Copy)]
pub(super) struct Measure {
    /// Compliance of a pair to its own pressure (m/Pa), the addition apart.
    own: f64,
    /// Gaps that are rounding (m).
    rounding: f64,
    /// Largest pressure (Pa).
    hardness: f64,
}

impl Measure {
    pub fn of(step: &Step<'_>) -> Self {
        let measure = Self::new(step.compliance.normal_self_term(), step.control);
        Self { hardness: step.hardness, ..measure }
    }

    /// For pairs of a compliance (m/Pa) to their own pressure.
    pub fn new(own: f64, control: Control) -> Self {
        // Pressures at a given approach may fade to nothing, those under a load never do.
        let rounding = match control {
            Control::Load(_) => 0.0,
            Control::Approach(approach) => f64::EPSILON * approach.abs(),
        };
        Self { own, rounding, hardness: f64::INFINITY }
    }

    /// By how much the pressure of a pair (Pa) is off p - g / c cut off below 0 and above the hardness, c its compliance to its own
    /// pressure: zero exactly where p >= 0, g >= 0 and p g = 0, or p is the hardness and g <= 0; up to rounding.
    pub fn violation(self, pressure: f64, gap: f64, addition: f64) -> f64 {
        let own = self.own + addition;
        let overlap = gap / own;
        // What is not a number stays so: `min` and `max` would hide it.
        let off = if pressure < overlap {
            pressure
        } else if pressure - overlap > self.hardness {
            pressure - self.hardness
        } else {
            overlap
        };
        let beyond = off.abs() - self.rounding / own;
        if beyond < 0.0 { 0.0 } else { beyond }
    }

    /// Violations of all pairs relative to their pressures (2-norms over the area).
    pub fn residual(self, step: &Step<'_>, pressure: &[f64], gap: &[f64]) -> f64 {
        let fields = [pressure, gap, step.addition];
        let [violations, pressures] = vector::sum_with(
            [step.measure.weight],
            fields,
            |[weight], [pressure, gap, addition]| {
                let violation = self.violation(pressure, gap, addition);
                [weight * (violation * violation), weight * (pressure * pressure)]
            },
        );
        Self::relative(violations, pressures)
    }

    /// The residual from the sums of squares. Bodies apart have none; overlaps without any pressure,
    /// one without bound.
    pub fn relative(violations: f64, pressures: f64) -> f64 {
        if violations == 0.0 && pressures.is_finite() {
            0.0
        } else {
            (violations / pressures).sqrt()
        }
    }
}

/// One value relative to another; nothing is nothing relative to nothing too.
pub(super) fn relative(one: f64, other: f64) -> f64 {
    if one == 0.0 { 0.0 } else { one / other }
}

/// The 2-norm of forces (N) that are missing.
pub(super) fn norm(forces: &[f64]) -> f64 {
    forces.iter().map(|force| force * force).sum::<f64>().sqrt()
}

/// The larger of two residuals; what is not a number is worse than any.
pub(super) fn worse(one: f64, other: f64) -> f64 {
    if one > other || one.is_nan() { one } else { other }
}

#[cfg(test)]
mod tests {
    use super::{Measure, worse};

    #[test]
    fn what_is_not_a_number_is_never_solved() {
        let measure = Measure { own: 1.0, rounding: 0.0, hardness: f64::INFINITY };
        assert!(measure.violation(1.0, f64::NAN, 0.0).is_nan());
        assert!(Measure::relative(0.0, f64::NAN).is_nan());
        assert_eq!(Measure::relative(0.0, 0.0), 0.0);
        assert_eq!(Measure::relative(1.0, 0.0), f64::INFINITY);
        assert!(worse(f64::NAN, 1.0).is_nan() && worse(1.0, f64::NAN).is_nan());
        assert_eq!((worse(1.0, 2.0), worse(2.0, 1.0)), (2.0, 2.0));
    }
}
