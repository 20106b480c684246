//! One normal step through any solver, with what was prescribed held against what came out.
//!
//! A solver judges itself by the gaps and pressures it computed. Here the load it carries is compared
//! with the one prescribed, and no number that is not finite passes. A solve that fails from an earlier
//! solution is tried once more from nothing.

use super::residual::worse;
use super::{Outcome, Solver, Start, Status, Step};
use crate::kinematics::Control;

/// The pressures of a step, from those of an earlier one where they bear anything.
pub fn press(solver: &dyn Solver, step: &Step<'_>, start: Option<Start<'_>>) -> Outcome {
    if step.control == Control::Load(0.0) {
        return apart(step);
    }
    let bears = |start: &Start<'_>| {
        let load = step.measure.load(start.pressure);
        load > 0.0 && load.is_finite() && start.approach.is_finite()
    };
    let start = start.filter(bears);
    let first = judged(solver.solve(step, start), step, solver);
    if start.is_none() || first.status != Status::OutOfIterations {
        return first;
    }
    let second = judged(solver.solve(step, None), step, solver);
    Outcome {
        iterations: first.iterations + second.iterations,
        applications: first.applications + second.applications,
        ..second
    }
}

/// Bodies that just touch.
fn apart(step: &Step<'_>) -> Outcome {
    let closing = |pair: usize| step.measure.closing.at(pair);
    let touches = |pair: usize| step.gap[pair] / closing(pair);
    let pairs = 0..step.gap.len();
    let closed = pairs.clone().filter(|&pair| closing(pair) > 0.0);
    let approach = closed.map(touches).fold(f64::INFINITY, f64::min);
    Outcome {
        status: Status::Converged,
        pressure: vec![0.0; step.gap.len()],
        displacement: vec![0.0; step.gap.len()],
        gap: pairs.map(|pair| step.gap[pair] - closing(pair) * approach).collect(),
        approach,
        iterations: 0,
        residual: 0.0,
        applications: 0,
    }
}

/// An outcome whose residual counts what is missing of the load.
fn judged(outcome: Outcome, step: &Step<'_>, solver: &dyn Solver) -> Outcome {
    let carried = step.measure.load(&outcome.pressure);
    let missing = match step.control {
        // By how much the approach would be off, which grows with the load to the power 2/3.
        Control::Load(load) => ((carried / load).abs().cbrt().powi(2) - 1.0).abs(),
        Control::Approach(_) => 0.0,
    };
    let known = carried.is_finite() && outcome.approach.is_finite();
    let residual = if known { worse(outcome.residual, missing) } else { f64::NAN };
    let solved = residual <= solver.settings().tolerance;
    let status = match outcome.status {
        Status::Converged if !solved => Status::OutOfIterations,
        status => status,
    };
    Outcome { status, residual, ..outcome }
}
