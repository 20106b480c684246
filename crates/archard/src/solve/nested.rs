//! Pressures to start from, found on elements of twice the size, and there on larger ones still.
//!
//! Nested iteration (W. Hackbusch, *Multi-Grid Methods and Applications*, Springer 1985, chapter 5). A coarse element has the
//! mean gap of those that it stands for, and its pressure is the start on each of them: what touches stays what touches.
//! Such a start is off by what a pressure changes by within a coarse element, so that more than that need not be solved there.
//! Where the closed forms of a [first guess](super::start) are as near on coarse elements already, they are no worse on fine
//! ones, and nothing else is solved: smooth bodies pay for one application on coarse elements.

use super::accept::on_the_frame;
use super::blocks::{Blocks, FEWEST};
use super::{ConjugateGradient, Settings, Solver, Start, Status, Step};
use crate::frame::{Measure, Part, Values};

/// Residual of a coarse solution: about what it leaves on elements of half the size. A choice of cost: a start does not change
/// what is found. Between 0.3 and 0.003 it makes a tenth of the applications at most.
const TOLERANCE: f64 = 0.1;

/// What coarser elements say of a step.
pub(super) struct FromCoarser {
    /// Pressure (Pa), one value a pair of the step.
    pressure: Vec<f64>,
    approach: f64,
    nowhere: Part,
    /// Applications of the compliance; those on coarser elements count by their number.
    pub applications: f64,
}

impl FromCoarser {
    /// The start that it is; what the pressures displace is not known.
    pub fn start(&self) -> Start<'_> {
        Start {
            pressure: &self.pressure,
            displacement: &[],
            part: Some(self.nowhere),
            approach: self.approach,
        }
    }
}

/// What the step comes to on coarser elements; `None` where there are none, or where a first guess is as good.
pub(super) fn solve(step: &Step<'_>) -> Option<FromCoarser> {
    let even = Values::All(1.0);
    let fewest = step.elements[0].min(step.elements[1]);
    if fewest < FEWEST || step.measure.weight != even || step.measure.closing != even {
        return None;
    }
    let compliance = step.compliance.coarser()?;
    let blocks = Blocks { fine: step.elements, coarse: step.elements.map(|n| n.div_ceil(2)) };
    let [gap, addition] = [step.gap, step.addition].map(|field| blocks.mean_continued(field));
    let Measure { area, side, .. } = step.measure;
    let coarse = Step {
        compliance,
        gap: &gap,
        addition: &addition,
        elements: blocks.coarse,
        measure: Measure { area: 4.0 * area, side: 2.0 * side, ..step.measure },
        control: step.control,
        hardness: step.hardness,
    };
    let guess = solver(0).solve(&coarse, None);
    if guess.status != Status::OutOfIterations {
        return None;
    }
    let coarser = solve(&coarse);
    let guessed = || Start {
        pressure: &guess.pressure,
        displacement: &guess.displacement,
        part: None,
        approach: guess.approach,
    };
    let start = coarser.as_ref().map_or_else(guessed, FromCoarser::start);
    let outcome = on_the_frame(&solver(gap.len()), &coarse, Some(start));
    let before = coarser.map_or(0.0, |coarser| coarser.applications);
    let share = gap.len() as f64 / step.gap.len() as f64;
    Some(FromCoarser {
        pressure: blocks.spread(&outcome.pressure),
        approach: outcome.approach,
        nowhere: Part::none(step.elements),
        applications: share * (before + (guess.applications + outcome.applications) as f64),
    })
}

fn solver(max_iterations: usize) -> ConjugateGradient {
    ConjugateGradient::new(Settings { tolerance: TOLERANCE, max_iterations })
}
