//! Friction solved in tractions whose admissible set is a disc.

use super::{Admissible, FrictionSolver, Outcome, PrescribedForce, Start, Step, crop};
use crate::compliance::MappedCompliance;

/// Solves a step of friction for tractions that are admissible. Tractions and slips of the step, the start and the outcome are those of the pairs.
pub fn solve(
    solver: &dyn FrictionSolver,
    step: &Step<'_>,
    Admissible { map, ties, turning }: Admissible<'_>,
    start: Option<Start<'_>>,
) -> Outcome {
    if map.is_identity() {
        return crop::solve(solver, step, (ties, turning), start);
    }
    let inverse = map.inverse();
    let slips = MappedCompliance::new(step.map, map);
    let rigid = map.images(step.rigid);
    let prescribed = |prescribed: &PrescribedForce| PrescribedForce {
        direction: map.apply(prescribed.direction),
        ..*prescribed
    };
    let prescribed: Vec<PrescribedForce> = step.prescribed.iter().map(prescribed).collect();
    let step =
        Step { map: &slips, rigid: [&rigid[0], &rigid[1]], prescribed: &prescribed, ..*step };
    let traction = start.map(|start| inverse.images(start.traction));
    let start = start
        .zip(traction.as_ref())
        .map(|(start, [one, two])| Start { traction: [one, two], ..start });
    let mut outcome = crop::solve(solver, &step, (ties, turning), start);
    let ([t1, t2], [s1, s2]) = (&mut outcome.traction, &mut outcome.slip);
    map.apply_to([t1, t2]);
    inverse.apply_to([s1, s2]);
    outcome
}
