//! The one number that says all of a law, where there is one.

use super::Subject;
use crate::problem::rubbing;

/// Pressures (Pa) and slips (m) from far below to far above what contacts bear, so that no law with a
/// threshold passes.
const TRIALS: [(f64, f64); 4] = [(1e8, 1.0), (1e4, 1.0), (3e9, 1.0), (1e8, 1e-6)];

impl Subject<'_> {
    /// The k (1/Pa) of a body whose depth of wear is k p s; `None` for one that does not wear or wears
    /// by another law.
    pub fn wear_coefficient(&self, body: usize) -> Option<f64> {
        let law = self.bodies[body].wear.as_ref()?;
        let ratio = |(pressure, slip): (f64, f64)| {
            law.depth(rubbing(self.friction, pressure, slip)) / (pressure * slip)
        };
        shared(TRIALS.map(ratio))
    }

    /// The k (1/Pa) of both bodies together; `None` where nothing wears.
    pub(super) fn total_wear_coefficient(&self) -> Option<f64> {
        let both: f64 = [0, 1].into_iter().filter_map(|body| self.wear_coefficient(body)).sum();
        (both > 0.0).then_some(both)
    }

    /// The mu of bodies whose largest traction is mu p.
    pub fn friction_coefficient(&self) -> Option<f64> {
        let law = self.friction?;
        shared(TRIALS.map(|(pressure, _)| law.limit(pressure) / pressure))
    }
}

/// What all of them are.
fn shared([first, others @ ..]: [f64; 4]) -> Option<f64> {
    others.iter().all(|other| (other - first).abs() <= 1e-12 * first).then_some(first)
}
