//! Friction solved in tractions whose admissible set is a disc.

use super::{FrictionSolver, Held, Outcome, Start, Step, crop};
use crate::compliance::Mapped;
use crate::friction::Map;

/// Solves a step of friction, whose limits are the radii of the discs that `map` stretches to the admissible sets.
/// Tractions and slips of the step, the start and the outcome are those of the pairs.
pub fn solve(
    solver: &dyn FrictionSolver,
    step: &Step<'_>,
    map: Map,
    start: Option<Start<'_>>,
) -> Outcome {
    if map.is_identity() {
        return crop::solve(solver, step, start);
    }
    let inverse = map.inverse();
    let slips = Mapped::new(step.map, map);
    let rigid = map.images(step.rigid);
    let held = |held: &Held| Held { direction: map.apply(held.direction), ..*held };
    let held: Vec<Held> = step.held.iter().map(held).collect();
    let step = Step { map: &slips, rigid: [&rigid[0], &rigid[1]], held: &held, ..*step };
    let traction = start.map(|start| inverse.images(start.traction));
    let start = start
        .zip(traction.as_ref())
        .map(|(start, [one, two])| Start { traction: [one, two], ..start });
    let mut outcome = crop::solve(solver, &step, start);
    let ([t1, t2], [s1, s2]) = (&mut outcome.traction, &mut outcome.slip);
    map.apply_to([t1, t2]);
    inverse.apply_to([s1, s2]);
    outcome
}
