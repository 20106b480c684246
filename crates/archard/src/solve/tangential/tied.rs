//! Friction where some pairs bear a share of the traction of others.

use super::{FrictionSolver, Outcome, Start, Step};
use crate::compliance::{Coarser, PairStatus, SlipMap};
use crate::frame::Measure;
use crate::numerics::vector::Values;

/// A pair whose traction is that of another times a share. It sticks or slips as the other does: neither its limit
/// nor its slip is asked for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tie {
    /// The pair.
    pub pair: usize,
    /// The other, which is tied to none.
    pub to: usize,
    /// Traction of the pair relative to that of the other, 1 at most, so that it keeps within its limit.
    pub share: f64,
}

/// Solves a step without the unknowns of pairs that are tied, and gives them their tractions.
pub(super) fn solve(
    solver: &dyn FrictionSolver,
    step: &Step<'_>,
    ties: &[Tie],
    start: Option<Start<'_>>,
) -> Outcome {
    if ties.is_empty() {
        return solver.solve(step, start);
    }
    let mut limit = step.limit.to_vec();
    let mut weight: Vec<f64> = (0..limit.len()).map(|pair| step.measure.weight.at(pair)).collect();
    for tie in ties {
        limit[tie.pair] = 0.0;
        weight[tie.to] += tie.share * weight[tie.pair];
    }
    let map = Tied { inner: step.map, ties };
    let measure = Measure { weight: Values::Each(&weight), ..step.measure };
    let step = Step { map: &map, limit: &limit, measure, ..*step };
    let mut outcome = solver.solve(&step, start);
    outcome.traction.iter_mut().for_each(|traction| fill(ties, traction));
    outcome
}

/// Gives tied pairs their part of a field.
fn fill(ties: &[Tie], field: &mut [f64]) {
    for tie in ties {
        field[tie.pair] = tie.share * field[tie.to];
    }
}

/// A map of tractions that fill those of tied pairs.
#[derive(Debug)]
struct Tied<'a> {
    inner: &'a dyn SlipMap,
    ties: &'a [Tie],
}

impl SlipMap for Tied<'_> {
    fn apply(&self, tractions: [&[f64]; 2], slip: [&mut [f64]; 2]) {
        let mut filled = tractions.map(<[f64]>::to_vec);
        filled.iter_mut().for_each(|traction| fill(self.ties, traction));
        self.inner.apply([&filled[0], &filled[1]], slip);
    }

    fn own(&self) -> f64 {
        self.inner.own()
    }

    /// Tied pairs count as those they are tied to, so that what steps up at them is passed on to the pairs behind.
    fn precondition(&self, slip: [&[f64]; 2], status: &[PairStatus], tractions: [&mut [f64]; 2]) {
        let mut status = status.to_vec();
        for tie in self.ties {
            status[tie.pair] = status[tie.to];
        }
        self.inner.precondition(slip, &status, tractions);
    }

    /// Without the ties, which are a matter of the finest elements.
    fn coarser(&self) -> Option<Coarser<'_>> {
        self.inner.coarser()
    }
}
