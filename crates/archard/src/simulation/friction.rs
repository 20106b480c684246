//! Friction under given pressures, and its alternation with the pressures of unlike bodies.

use super::effort::Effort;
use super::error::Error;
use super::memory::Increment;
use super::setup::Simulation;
use crate::solve::Status;
use crate::solve::tangential::{self, Admissible, Outcome, Start, Step};

/// Change of the tractions' effect on the gap, relative to the approach, below which pressures and friction
/// that are found in turn agree.
const CONSISTENT: f64 = 1e-8;
/// Turns between them.
const TURNS: usize = 50;

/// Residual to which friction is solved that only says which pairs slip at first: relative to that of a solution, and at most.
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
        measure: simulation.problem.motion.progress,
        progress: increment.progress,
        iterations,
        residual,
        tolerance: simulation.friction_solver.settings().tolerance,
    }
}

/// Finds pressures and friction in turn until they agree. A turn takes the gap (m) that friction opens, and says which
/// it opens then and what the approach (m) is.
pub(super) fn alternate(
    simulation: &Simulation,
    increment: Increment,
    mut opened: Vec<f64>,
    mut turn: impl FnMut(&[f64]) -> Result<(Vec<f64>, f64), Error>,
) -> Result<(), Error> {
    for _ in 0..TURNS {
        let (now, approach) = turn(&opened)?;
        let changes = now.iter().zip(&opened).map(|(now, before)| (now - before).abs());
        if changes.fold(0.0, f64::max) <= CONSISTENT * approach.abs() {
            return Ok(());
        }
        opened = now;
    }
    Err(Error::NotConsistent {
        measure: simulation.problem.motion.progress,
        progress: increment.progress,
        passes: TURNS,
    })
}
