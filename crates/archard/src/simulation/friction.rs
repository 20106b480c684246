//! Friction under given pressures, and its alternation with the pressures of unlike bodies.

use std::mem;

use super::evolution::Increment;
use super::{Effort, Error, Simulation};
use crate::solve::Status;
use crate::solve::tangential::{self, Admissible, Outcome, Start, Step};

/// Change of the tractions' effect on the gap, relative to the approach, below which pressures and friction
/// that are found in turn agree.
const CONSISTENT: f64 = 1e-8;
/// Turns between them.
const TURNS: usize = 50;

/// Residual to which friction is solved that only says how the slip turns: relative to that of a solution, and at most.
const ESTIMATE: (f64, f64) = (1e3, 1e-3);

/// A way to solve a step of friction.
pub(super) type Solve = fn(
    &Simulation,
    Increment,
    Admissible<'_>,
    (&Step<'_>, Option<Start<'_>>),
    &mut Effort,
) -> Result<Outcome, Error>;

/// Solves a step of friction nearly.
pub(super) fn estimate(
    simulation: &Simulation,
    _: Increment,
    admissible: Admissible<'_>,
    (step, start): (&Step<'_>, Option<Start<'_>>),
    effort: &mut Effort,
) -> Result<Outcome, Error> {
    let solver = &simulation.friction_solver;
    let tolerance = solver.settings().tolerance;
    let solver = solver.with_tolerance((ESTIMATE.0 * tolerance).min(ESTIMATE.1).max(tolerance));
    let outcome = tangential::solve(&*solver, step, admissible, start);
    effort.iterations += outcome.iterations;
    effort.applications += outcome.applications;
    Ok(outcome)
}

/// Solves a step of friction.
pub(super) fn solve(
    simulation: &Simulation,
    increment: Increment,
    admissible: Admissible<'_>,
    (step, start): (&Step<'_>, Option<Start<'_>>),
    effort: &mut Effort,
) -> Result<Outcome, Error> {
    let outcome = tangential::solve(&*simulation.friction_solver, step, admissible, start);
    effort.iterations += outcome.iterations;
    effort.applications += outcome.applications;
    effort.residual = effort.residual.max(outcome.residual);
    match outcome.status {
        Status::Converged => Ok(outcome),
        _ => Err(not_converged(simulation, increment, outcome.iterations, outcome.residual)),
    }
}

pub(super) fn not_converged(
    simulation: &Simulation,
    increment: Increment,
    iterations: usize,
    residual: f64,
) -> Error {
    Error::FrictionNotConverged {
        measure: simulation.problem.motion.progress(),
        progress: increment.progress,
        iterations,
        residual,
        tolerance: simulation.friction_solver.settings().tolerance,
    }
}

/// Finds pressures and friction in turn until they agree. A turn takes the gap (m) that friction opens, and whether turns have
/// begun to find what the last but one did; it says which gap friction opens then and what the approach (m) is.
pub(super) fn alternate(
    simulation: &Simulation,
    increment: Increment,
    mut opened: Vec<f64>,
    mut turn: impl FnMut(&[f64], bool) -> Result<(Vec<f64>, f64), Error>,
) -> Result<(), Error> {
    let change = |now: &[f64], before: &[f64]| {
        now.iter().zip(before).map(|(now, before)| (now - before).abs()).fold(0.0, f64::max)
    };
    let (mut last_but_one, mut returns): (Option<Vec<f64>>, _) = (None, false);
    for _ in 0..TURNS {
        let (now, approach) = turn(&opened, returns)?;
        let agrees = |one: &[f64]| change(&now, one) <= CONSISTENT * approach.abs();
        if agrees(&opened) {
            return Ok(());
        }
        returns |= last_but_one.is_some_and(|one| agrees(&one));
        last_but_one = Some(mem::replace(&mut opened, now));
    }
    Err(Error::NotConsistent {
        measure: simulation.problem.motion.progress(),
        progress: increment.progress,
        passes: TURNS,
    })
}
