//! A normal step solved on the part of the frame around its contact, where that is much smaller.
//!
//! What is far from the contact has to stay open: the pressures that were found open the gaps next to the part by one application
//! of the compliance to all pairs whose gap is less than the approach. Where a pair touches there, the part grows, and the step
//! is solved again from where it is.

use std::borrow::Cow;

use super::accept::judged;
use super::start::first_guess;
use super::{Outcome, Solver, Start, Status, Step};
use crate::compliance::normal_displacement;
use crate::frame::{Extent, Measure, Part, Values, extent};
use crate::motion::Control;
use crate::numerics::vector::map;

/// Elements of a part on each side of those that may touch, relative to their number: the contact has room to grow. A choice of
/// cost: what is next to a part is known to be open, whatever its size.
const ROOM: f64 = 1.0 / 16.0;

/// The pressures of a step on a part of the frame; `None` where none is much smaller than the frame, or the compliance
/// has none. The status is that of a full frame where the contact outgrows all parts.
pub(super) fn solve(
    solver: &dyn Solver,
    step: &Step<'_>,
    start: Option<Start<'_>>,
) -> Option<Outcome> {
    let even = Values::All(1.0);
    if step.measure.weight != even || step.measure.closing != even {
        return None;
    }
    let begun = match start {
        Some(start) => (Cow::Borrowed(start.pressure), start.approach),
        None => {
            let (pressure, approach) = first_guess(step);
            (Cow::Owned(pressure), approach)
        }
    };
    let part = choose(step, &begun.0, start)?;
    let known = start.filter(|start| start.part.is_none_or(|known| known.holds(&part.extent())));
    let known = known.map(|start| part.cut(start.displacement));
    let mut outcome = solve_on(&part, solver, step, (&part.cut(&begun.0), known, begun.1))?;
    while let (Status::Converged, Some(part)) = (outcome.status, outcome.part) {
        let solved = (&outcome.pressure[..], outcome.approach);
        let (reach, applications) = reach(step, solved, &part.extent());
        outcome.applications += applications;
        if part.holds(&reach) {
            return Some(beside(outcome, step, start));
        }
        let wider = Part::around(step.elements, &reach, room(&reach));
        let grown = wider.and_then(|part| {
            let pressure = part.cut(&outcome.pressure);
            solve_on(&part, solver, step, (&pressure, None, outcome.approach))
        });
        let Some(grown) = grown else { break };
        outcome = outcome.before(grown);
    }
    let status = match outcome.status {
        Status::Converged => Status::FrameFull,
        status => status,
    };
    Some(Outcome { status, ..outcome })
}

/// The part that was solved on before, where it is neither too small nor too large; otherwise one around what is pressed, and
/// what touches as far as the displacements of the start are known.
fn choose(step: &Step<'_>, pressure: &[f64], start: Option<Start<'_>>) -> Option<Part> {
    let pressed = extent(step.elements, |pair| pressure[pair] > 0.0)?;
    let least = Part::around(step.elements, &pressed, room(&pressed))?;
    let fits = |part: &Part| part.holds(&pressed) && !least.is_worth(part.size());
    let before = start.and_then(|start| start.part).filter(fits);
    before.or_else(|| {
        let touching = start.and_then(|start| {
            let known = |pair: usize| start.part.is_none_or(|part| part.place(pair).is_some());
            touching(step, start.displacement, start.approach, known)
        });
        let reach = touching.map_or(pressed.clone(), |touching| both(&pressed, &touching));
        Part::around(step.elements, &reach, room(&reach))
    })
}

fn room(extent: &Extent) -> [usize; 2] {
    extent.each_ref().map(|range| 1 + (ROOM * range.len() as f64) as usize)
}

/// Solves the step on a part from pressures (Pa), displacements (m) if they are known, and an approach (m); what it finds,
/// put into the frame.
fn solve_on(
    part: &Part,
    solver: &dyn Solver,
    step: &Step<'_>,
    (pressure, known, approach): (&[f64], Option<Vec<f64>>, f64),
) -> Option<Outcome> {
    let compliance = step.compliance.within(part)?;
    let [gap, addition] = [step.gap, step.addition].map(|field| part.cut(field));
    let computed = usize::from(known.is_none());
    let displacement = known.unwrap_or_else(|| normal_displacement(&*compliance, pressure));
    let within = Step {
        compliance: &*compliance,
        gap: &gap,
        addition: &addition,
        elements: part.size(),
        // That all pairs of a part touch is for what is next to it to judge.
        measure: Measure { closed: true, ..step.measure },
        control: step.control,
        hardness: step.hardness,
    };
    let start = Start { pressure, displacement: &displacement, part: None, approach };
    let outcome = judged(solver.solve(&within, Some(start)), &within, solver);
    let apart = map([step.gap], |[gap]| gap - outcome.approach);
    Some(Outcome {
        pressure: part.put(&outcome.pressure),
        displacement: part.put(&outcome.displacement),
        gap: part.pasted(&outcome.gap, apart),
        part: Some(*part),
        applications: outcome.applications + computed,
        ..outcome
    })
}

/// The outcome with what is known next to its part: where the start solved the step but for its load, all that is displaced
/// in proportion.
fn beside(outcome: Outcome, step: &Step<'_>, start: Option<Start<'_>>) -> Outcome {
    let (Some(start), Some(part)) = (start, outcome.part) else { return outcome };
    if outcome.iterations > 0 || start.part.is_some() {
        return outcome;
    }
    let factor = match step.control {
        Control::Load(load) => load / step.measure.load(start.pressure),
        Control::Approach(_) => 1.0,
    };
    let displaced = map([start.displacement], |[displacement]| factor * displacement);
    let approach = outcome.approach;
    let apart = map([step.gap, &displaced], |[gap, displaced]| gap + displaced - approach);
    Outcome {
        displacement: part.pasted(&part.cut(&outcome.displacement), displaced),
        gap: part.pasted(&part.cut(&outcome.gap), apart),
        part: None,
        ..outcome
    }
}

/// An extent and all pairs next to it that touch under these pressures (Pa) at an approach (m), and how often the compliance was
/// applied to know that. Only pairs whose gap is less than the approach can touch, so that the pressures need displace no more
/// than a part around these.
fn reach(step: &Step<'_>, (pressure, approach): (&[f64], f64), inner: &Extent) -> (Extent, usize) {
    let close = extent(step.elements, |pair| step.gap[pair] < approach);
    let Some(around) = close.map(|close| both(inner, &close)).filter(|around| around != inner)
    else {
        return (inner.clone(), 0);
    };
    let part = Part::around(step.elements, &around, [0; 2]);
    let on = part.and_then(|part| Some((part, step.compliance.within(&part)?)));
    let displacement = match on {
        Some((part, within)) => part.put(&normal_displacement(&*within, &part.cut(pressure))),
        None => normal_displacement(step.compliance, pressure),
    };
    let touching = touching(step, &displacement, approach, |pair| step.gap[pair] < approach);
    (touching.map_or(inner.clone(), |touching| both(inner, &touching)), 1)
}

/// The extent of those pairs among some that touch at an approach (m) where they are displaced (m).
fn touching(
    step: &Step<'_>,
    displacement: &[f64],
    approach: f64,
    among: impl Fn(usize) -> bool,
) -> Option<Extent> {
    let touches = |pair: usize| among(pair) && step.gap[pair] + displacement[pair] < approach;
    extent(step.elements, touches)
}

/// The smallest extent that holds both.
fn both(one: &Extent, other: &Extent) -> Extent {
    [0, 1].map(|axis| one[axis].start.min(other[axis].start)..one[axis].end.max(other[axis].end))
}
