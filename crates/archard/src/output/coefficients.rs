//! The one number that says all of a law, where there is one.

use crate::problem::ContactProblem;

/// Pressures (Pa) and slips (m) from far below to far above what contacts bear, so that no law with a
/// threshold passes, and directions of slip.
const TRIALS: [(f64, f64, [f64; 2]); 4] = [
    (1e8, 1.0, [1.0, 0.0]),
    (1e4, 1.0, [0.0, 1.0]),
    (3e9, 1.0, [1.0, 1.0]),
    (1e8, 1e-6, [1.0, -1.0]),
];

/// The k (1/Pa) of a body whose depth of wear is k p s; `None` for one that does not wear or wears
/// by another law.
pub(super) fn of_wear(problem: &ContactProblem, body: usize) -> Option<f64> {
    let law = problem.bodies[body].wear.as_ref()?;
    let ratio = |(pressure, slip, direction): (f64, f64, [f64; 2])| {
        law.depth(problem.rubbing(pressure, slip, direction)) / (pressure * slip)
    };
    shared(TRIALS.map(ratio))
}

/// The k (1/Pa) of both bodies together.
pub(super) fn of_all_wear(problem: &ContactProblem) -> f64 {
    [0, 1].into_iter().filter_map(|body| of_wear(problem, body)).sum()
}

/// The mu of bodies whose largest traction is mu p.
pub(super) fn of_friction(problem: &ContactProblem) -> Option<f64> {
    let law = problem.friction.as_ref()?;
    let isotropic = law.map().is_identity();
    shared(TRIALS.map(|(pressure, ..)| law.limit(pressure) / pressure)).filter(|_| isotropic)
}

/// What all of them are.
fn shared([first, others @ ..]: [f64; 4]) -> Option<f64> {
    others.iter().all(|other| (other - first).abs() <= 1e-12 * first).then_some(first)
}
