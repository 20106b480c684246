//! Pressures and friction at once, for unlike bodies, whose tangential tractions open and close the gap
//! and whose pressures make them slip.
//!
//! The problem is that of the [normal step](crate::solve) and that of [friction](crate::solve::tangential)
//! together: gap = undeformed gap - approach + (C L)_n and slip = rigid slip - (C L)_t, with L the
//! tractions of all three directions and limits that follow from the pressures. On curved frames approach and
//! shift both open gaps and make pairs slip, each as the bases of the pairs have it.

mod border;
mod linear;
mod regime;
mod state;

use super::{Settings, Status};
use crate::compliance::Compliance;
use crate::frame::{ContactFrame, VectorField};
use crate::friction::Friction;
use crate::kinematics::Control;
use crate::solve::tangential::Held;

use linear::Linear;
use state::State;

/// One step of contact and friction.
#[derive(Debug, Clone, Copy)]
pub struct Step<'a> {
    /// How the bodies deform.
    pub compliance: &'a dyn Compliance,
    /// The pairs.
    pub frame: &'a ContactFrame,
    /// What tangential traction the pairs bear.
    pub friction: &'a dyn Friction,
    /// Gap of the undeformed surfaces at zero approach, wear included (m), one value a pair.
    pub gap: &'a [f64],
    /// The given load or approach.
    pub control: Control,
    /// Slip at zero approach before any traction (m), along t1 and t2, one value a pair.
    pub rigid: [&'a [f64]; 2],
    /// Directions along which the force is given, two at most.
    pub held: &'a [Held],
}

/// Tractions and what belongs to them.
#[derive(Debug, Clone, PartialEq)]
pub struct Solution {
    /// Tractions on body 1 (Pa); the normal ones are zero or negative.
    pub traction: VectorField,
    /// Relative displacement the compliance makes of them (m).
    pub displacement: VectorField,
    /// Approach (m).
    pub approach: f64,
    /// Uniform slip (m) along each direction whose force is given.
    pub found: Vec<f64>,
}

/// What a solve found and what it took.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// How it ended; the solution is the last iterate in any case.
    pub status: Status,
    /// The solution.
    pub solution: Solution,
    /// Gap (m), one value a pair.
    pub gap: Vec<f64>,
    /// Newton steps done.
    pub iterations: usize,
    /// The larger of the residuals of [pressures](Settings::tolerance) and
    /// [friction](crate::solve::tangential::Outcome::residual).
    pub residual: f64,
    /// How often the compliance was applied.
    pub applications: usize,
}

/// Shortest step tried.
const SHORTEST: f64 = 0.05;

/// Semismooth Newton steps on pressures and friction together, each by Krylov iterations (P. Alart and A.
/// Curnier, *Comput. Methods Appl. Mech. Engrg.* 92 (1991) 353).
pub(super) fn solve(step: &Step<'_>, start: &Solution, settings: Settings) -> Outcome {
    let mut state = State::new(step, start);
    let (mut count, mut applications) = (0, 0);
    let mut last = vec![];
    while state.residual > settings.tolerance && count < settings.max_iterations {
        count += 1;
        let mut linear = Linear::about(&state, step);
        let tolerance = linear.tolerance(&last, state.residual, settings.tolerance);
        last.clone_from(&linear.regime.touch);
        let change = linear.solve(tolerance);
        applications += linear.applications;
        let Some(next) = shorten(&state, &change, step) else { break };
        state = next;
    }
    let converged = state.residual <= settings.tolerance;
    let full = !step.frame.measure().closed && state.solution.traction.n.iter().all(|&n| n < 0.0);
    let status = match (converged, full) {
        (true, false) => Status::Converged,
        (true, true) => Status::FrameFull,
        (false, _) => Status::OutOfIterations,
    };
    state.finish(status, count, applications)
}

/// The state after as much of a change as lowers the residual; `None` where hardly any does.
fn shorten(state: &State, change: &Solution, step: &Step<'_>) -> Option<State> {
    let mut length = 1.0;
    while length >= SHORTEST {
        let next = state.moved(change, length, step);
        if next.residual < (1.0 - 1e-4 * length) * state.residual {
            return Some(next);
        }
        length *= 0.5;
    }
    None
}
