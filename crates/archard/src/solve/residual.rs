//! How far a state is from contact: one measure for every solver.

use super::Step;
use crate::kinematics::Control;
use crate::numerics::vector;

/// The measure for one step.
#[derive(Debug, Clone, Copy)]
pub(super) struct Measure {
    /// Compliance of a pair to its own pressure (m/Pa), the addition apart.
    own: f64,
    /// Gaps that are rounding (m).
    rounding: f64,
}

impl Measure {
    pub fn of(step: &Step<'_>) -> Self {
        // Pressures at a given approach may fade to nothing, those under a load never do.
        let rounding = match step.control {
            Control::Load(_) => 0.0,
            Control::Approach(approach) => f64::EPSILON * approach.abs(),
        };
        Self { own: step.compliance.normal_self_term(), rounding }
    }

    /// min(p, g / c) of a pair (Pa), c its compliance to its own pressure: zero exactly where p >= 0,
    /// g >= 0 and p g = 0; up to rounding.
    pub fn violation(self, pressure: f64, gap: f64, addition: f64) -> f64 {
        let own = self.own + addition;
        (pressure.min(gap / own).abs() - self.rounding / own).max(0.0)
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
        if violations == 0.0 { 0.0 } else { (violations / pressures).sqrt() }
    }
}
