//! The one number that says all of a law, where there is one.

use super::Subject;
use crate::problem::rubbing;
use crate::wear::Input;

/// Pressures (Pa) and slips (m) from far below to far above what contacts bear, so that no law with a
/// threshold passes, and directions of slip.
const TRIALS: [(f64, f64, [f64; 2]); 9] = [
    (1e8, 1.0, [1.0, 0.0]),
    (1e4, 1.0, [0.0, 1.0]),
    (3e9, 1.0, [1.0, 1.0]),
    (1e8, 1e-6, [1.0, -1.0]),
    (1e6, 1.0, [1.0, 0.0]),
    (1e7, 1.0, [1.0, 0.0]),
    (3e7, 1.0, [1.0, 0.0]),
    (3e8, 1.0, [1.0, 0.0]),
    (1e9, 1.0, [1.0, 0.0]),
];

impl Subject<'_> {
    /// The k (1/Pa) of a body whose depth of wear is k p s; `None` for one that does not wear or wears
    /// by another law, or by the work of a friction that changes.
    pub fn wear_coefficient(&self, body: usize) -> Option<f64> {
        let law = self.bodies[body].wear.as_ref()?;
        // The trials do not age.
        let tried = |input: &Input| matches!(input, Input::Friction | Input::Vectors);
        let friction_changes = self.friction.is_some_and(|friction| !friction.inputs().is_empty());
        if !law.inputs().iter().all(tried) || friction_changes && !law.inputs().is_empty() {
            return None;
        }
        let ratio = |(pressure, slip, direction): (f64, f64, [f64; 2])| {
            law.depth(rubbing(self.friction, pressure, slip, direction)) / (pressure * slip)
        };
        shared(TRIALS.map(ratio))
    }

    /// The k (1/Pa) of both bodies together; `None` where nothing wears, or a body wears by another law.
    pub(super) fn total_wear_coefficient(&self) -> Option<f64> {
        let wears = |&body: &usize| self.bodies[body].wear.is_some();
        let worn = [0, 1].into_iter().filter(wears);
        let both: f64 = worn.map(|body| self.wear_coefficient(body)).sum::<Option<f64>>()?;
        (both > 0.0).then_some(both)
    }

    /// The mu of bodies whose largest traction is mu p in all directions.
    pub fn friction_coefficient(&self) -> Option<f64> {
        self.limit_coefficient()
            .filter(|_| self.friction.is_some_and(|law| law.map().is_identity()))
    }

    /// How much a force along some direction is at most, relative to the load, if the force along x and y is given or
    /// found; `None` where that depends on the pressures.
    pub fn largest_force(&self, direction: [f64; 2], given: [bool; 2]) -> Option<f64> {
        let (limit, map) = (self.limit_coefficient()?, self.friction?.map());
        let length = direction[0].hypot(direction[1]);
        let both = given == [true; 2] && length > 0.0;
        Some(limit * if both { length / map.length(direction) } else { map.resistance(direction) })
    }

    /// The limit of friction over the pressure.
    fn limit_coefficient(&self) -> Option<f64> {
        let law = self.friction.filter(|law| law.inputs().is_empty())?;
        shared(TRIALS.map(|(pressure, ..)| law.limit(pressure) / pressure))
    }
}

/// What all of them are.
fn shared([first, others @ ..]: [f64; 9]) -> Option<f64> {
    others.iter().all(|other| (other - first).abs() <= 1e-12 * first).then_some(first)
}
