//! Wear of laws that take a whole cycle, of bodies whose surfaces are seen in one position after the other.
//!
//! What a place on a body goes through in a cycle is known at its end, and wear is laid down on the way. So a cycle is first gone through
//! without wear. What it wears by the law, over the pressure times the slip there, is a coefficient of the place for the step.

use super::collector::{Coefficients, Collector};
use super::effort::Effort;
use super::error::Error;
use super::memory::{History, Increment};
use super::position::{Positions, Way, gap};
use super::setup::Simulation;
use crate::wear::{Per, Rubbing};

/// Those of both bodies for a step of that advance (cycles) on some way, at the surfaces as they are.
///
/// # Errors
/// If a contact is not found.
pub(super) fn coefficients(
    history: &History,
    (simulation, increment): (&Simulation, Increment),
    (positions, way): (&dyn Positions, &Way),
    collector: &Collector<'_>,
    effort: &mut Effort,
) -> Result<[Coefficients; 2], Error> {
    let problem = &simulation.problem;
    let wearing = problem.wearing([true; 2], Per::Cycle);
    if wearing == [false; 2] {
        return Ok([None, None]);
    }
    let mut history = history.clone();
    let mut whole = history.state.surfaces.each_ref().map(|one| vec![None; one.depth.len()]);
    let rigid = vec![0.0; problem.frame.len()];
    for position in &way.positions {
        let control = position.control.unwrap_or(increment.control);
        let gap = gap(positions, (problem, &history.state), position);
        let gap = gap.ok_or(Error::SwungOut {
            measure: problem.motion.progress,
            progress: increment.progress,
        })?;
        let pressed = Increment { control, ..increment };
        history.contact(simulation, pressed, (&gap, &rigid), &*problem.compliance, effort)?;
        let state = &history.state;
        let rubbing = collector.rubbing(state, increment.advance, position);
        for pair in (0..rigid.len()).filter(|&pair| state.pressure[pair] > 0.0) {
            let once = rubbing(pair).share(1.0 / increment.advance);
            for body in (0..2).filter(|&body| wearing[body]) {
                let of = (body, state.surfaces[body].grid);
                position.swept(of, pair, |place, share, axis| {
                    let part = once.share(share);
                    let part = axis.map_or(part, |axis| part.along(axis));
                    let before: &mut Option<Rubbing> = &mut whole[body][place];
                    *before = Some(before.map_or(part, |before| before.then(part)));
                });
            }
        }
    }
    Ok([0, 1].map(|body| {
        let law = problem.bodies[body].wear.as_ref().filter(|_| wearing[body])?;
        let surface = &history.state.surfaces[body];
        let worn = |(place, rubbed): (usize, &Option<Rubbing>)| {
            let rubbed = (*rubbed)?;
            let [distance, depth] = surface.before(place);
            let work = rubbed.pressure * rubbed.slip;
            (work > 0.0).then(|| [law.depth(rubbed.after(distance, depth)), work])
        };
        let worn: Vec<_> = whole[body].iter().enumerate().map(worn).collect();
        // Places that the contact comes to only as it wears wear as the others do in the mean.
        let [depth, work] = worn.iter().flatten().fold([0.0; 2], |[a, b], [c, d]| [a + c, b + d]);
        let mean = if work > 0.0 { depth / work } else { 0.0 };
        Some(worn.into_iter().map(|one| one.map_or(mean, |[depth, work]| depth / work)).collect())
    }))
}
