//! Friction of pairs that go by the mean of two slips.

use super::{FrictionSolver, Outcome, Start, Step, Tie, tied};
use crate::compliance::{Coarser, PairStatus, SlipMap};
use crate::numerics::vector::map;

/// A pair whose friction depends on the mean of its slip and that of the pair behind.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TurningPair {
    /// The pair.
    pub pair: usize,
    /// The pair behind.
    pub behind: usize,
}

/// Solves a step in which pairs go by means of slips. The slips of the outcome are those of the pairs themselves.
pub(super) fn solve(
    solver: &dyn FrictionSolver,
    step: &Step<'_>,
    (ties, turning): (&[Tie], &[TurningPair]),
    start: Option<Start<'_>>,
) -> Outcome {
    if turning.is_empty() {
        return tied::solve(solver, step, ties, start);
    }
    let mut rigid = step.rigid.map(<[f64]>::to_vec);
    rigid.iter_mut().for_each(|slip| average(turning, slip));
    let means = Means { inner: step.map, turning };
    let mean = Step { map: &means, rigid: [&rigid[0], &rigid[1]], ..*step };
    let mut outcome = tied::solve(solver, &mean, ties, start);
    let [one, two] = &mut outcome.slip;
    step.map.apply(outcome.traction.each_ref().map(|traction| &traction[..]), [one, two]);
    for (axis, slip) in outcome.slip.iter_mut().enumerate() {
        let along = step.prescribed.iter().map(|given| given.direction[axis]);
        let moved: f64 = along.zip(&outcome.rigid_slip).map(|(unit, slip)| unit * slip).sum();
        *slip = map([step.rigid[axis], slip], |[rigid, taken]| rigid + moved - taken);
    }
    outcome.applications += 1;
    outcome
}

/// Makes means of the slips of the pairs that go by them.
fn average(turning: &[TurningPair], slip: &mut [f64]) {
    let mean = |one: &TurningPair| 0.5 * (slip[one.pair] + slip[one.behind]);
    let means: Vec<f64> = turning.iter().map(mean).collect();
    turning.iter().zip(means).for_each(|(one, mean)| slip[one.pair] = mean);
}

/// A map to slips, some of them means.
#[derive(Debug)]
struct Means<'a> {
    inner: &'a dyn SlipMap,
    turning: &'a [TurningPair],
}

impl SlipMap for Means<'_> {
    fn apply(&self, tractions: [&[f64]; 2], [one, two]: [&mut [f64]; 2]) {
        self.inner.apply(tractions, [&mut *one, &mut *two]);
        [one, two].into_iter().for_each(|slip| average(self.turning, slip));
    }

    fn own(&self) -> f64 {
        self.inner.own()
    }

    fn precondition(&self, slip: [&[f64]; 2], status: &[PairStatus], tractions: [&mut [f64]; 2]) {
        self.inner.precondition(slip, status, tractions);
    }

    /// Without the means, which are a matter of the finest elements.
    fn coarser(&self) -> Option<Coarser<'_>> {
        self.inner.coarser()
    }
}
