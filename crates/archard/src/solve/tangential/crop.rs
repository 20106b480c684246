//! Friction solved on the part of the frame that is in contact.

use super::{FrictionSolver, Outcome, Start, Step, Tie, TurningPair, turning};
use crate::frame::{Part, extent};

/// Elements kept free around the contact: material is still rubbed on its way past the trailing edge, over the one element that
/// the upwind difference reaches.
const MARGIN: usize = 1;

/// Solves a step on the part of the frame around its contact, where that is much smaller. Tractions and slip
/// are zero on the rest.
pub(super) fn solve(
    solver: &dyn FrictionSolver,
    step: &Step<'_>,
    (ties, turns): (&[Tie], &[TurningPair]),
    start: Option<Start<'_>>,
) -> Outcome {
    let contact = extent(step.elements, |pair| step.limit[pair] > 0.0);
    let part = contact.and_then(|contact| Part::around(step.elements, &contact, [MARGIN; 2]));
    let part = part.and_then(|part| {
        let map = step.map.within(&part)?;
        Some((part, map))
    });
    let Some((part, map)) = part else { return turning::solve(solver, step, (ties, turns), start) };
    let limit = part.cut(step.limit);
    let rigid = step.rigid.map(|rigid| part.cut(rigid));
    let step = Step {
        map: &*map,
        elements: part.size(),
        limit: &limit,
        rigid: [&rigid[0], &rigid[1]],
        ..*step
    };
    let cut = start.map(|start| {
        (start.traction.map(|traction| part.cut(traction)), part.cut(start.limit), start.rigid_slip)
    });
    let start = cut.as_ref().map(|(traction, limit, rigid_slip)| Start {
        traction: [&traction[0], &traction[1]],
        limit,
        rigid_slip,
    });
    let place =
        |tie: &Tie| Some(Tie { pair: part.place(tie.pair)?, to: part.place(tie.to)?, ..*tie });
    let ties: Vec<Tie> = ties.iter().filter_map(place).collect();
    let place = |turns: &TurningPair| {
        Some(TurningPair { pair: part.place(turns.pair)?, behind: part.place(turns.behind)? })
    };
    let turns: Vec<TurningPair> = turns.iter().filter_map(place).collect();
    let outcome = turning::solve(solver, &step, (&ties, &turns), start);
    let [traction, slip] =
        [&outcome.traction, &outcome.slip].map(|both| both.each_ref().map(|field| part.put(field)));
    Outcome { traction, slip, ..outcome }
}
