//! Pressures and friction at once, for unlike bodies, whose tangential tractions open and close the gap
//! and whose pressures make them slip.
//!
//! The problem is that of the [normal step](crate::solve) and that of [friction](crate::solve::tangential)
//! together: gap = undeformed gap - approach + (C L)_n and slip = rigid slip - (C L)_t, with L the
//! tractions of all three directions and limits that follow from the pressures. On curved frames approach and
//! shift both open gaps and make pairs slip, each as the bases of the pairs have it.

mod border;
mod factors;
mod linear;
mod mapped;
mod regime;
mod state;

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::semismooth::{Forcing, shorten};
use super::{Settings, Status};
use crate::compliance::Compliance;
use crate::frame::{ContactFrame, VectorField};
use crate::friction::Limits;
use crate::motion::Control;
use crate::numerics::vector::update;
use crate::solve::tangential::PrescribedForce;

pub use factors::{Factors, factors_memory};
use linear::Linear;
use mapped::Mapped;
pub(super) use mapped::solve;
use regime::Regime;
use state::State;

/// One step of contact and friction.
#[derive(Debug, Clone, Copy)]
pub struct Step<'a> {
    /// How the bodies deform.
    pub compliance: &'a dyn Compliance,
    /// The pairs.
    pub frame: &'a ContactFrame,
    /// What tangential traction the pairs bear.
    pub friction: Limits<'a>,
    /// Gap of the undeformed surfaces at zero approach, wear included (m), one value a pair.
    pub gap: &'a [f64],
    /// The given load or approach.
    pub control: Control,
    /// Slip at zero approach before any traction (m), along t1 and t2, one value a pair.
    pub rigid: [&'a [f64]; 2],
    /// Directions along which the force is given, two at most.
    pub prescribed: &'a [PrescribedForce],
    /// Whether it comes again, nearly the same, so that it is worth while to keep what makes that faster.
    pub again: bool,
}

/// Tractions and what belongs to them.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Solution {
    /// Tractions on body 1 (Pa); the normal ones are zero or negative.
    pub traction: VectorField,
    /// Relative displacement the compliance makes of them (m).
    pub displacement: VectorField,
    /// Approach (m).
    pub approach: f64,
    /// Uniform slip (m) along each direction whose force is given.
    pub rigid_slip: Vec<f64>,
    /// What is kept to solve others near it faster.
    pub factors: Option<Arc<Factors>>,
}

impl Solution {
    /// With a share of a change, without what is kept for others near it.
    pub fn moved(&self, change: &Self, length: f64) -> Self {
        let mut moved = Self { factors: None, ..self.clone() };
        moved.traction.add(&change.traction, length);
        moved.displacement.add(&change.displacement, length);
        moved.approach += length * change.approach;
        let rigid_slip = &change.rigid_slip;
        update(&mut moved.rigid_slip, [rigid_slip], |from, [by]| from + length * by);
        moved
    }
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

/// Applications in one Newton step beyond which new factors pay at the next occasion. A choice of cost: factors only precondition.
const STALE: usize = 9;

/// Semismooth Newton steps on pressures and friction together, each by Krylov iterations (P. Alart and A.
/// Curnier, *Comput. Methods Appl. Mech. Engrg.* 92 (1991) 353), from a solution known or foreseen, whichever is
/// nearer.
fn newton(
    step: &Mapped<'_>,
    start: &Solution,
    foreseen: Option<&Solution>,
    settings: Settings,
) -> Outcome {
    let known = State::new(step, start);
    let foreseen = foreseen
        .map(|foreseen| State::new(step, foreseen))
        .filter(|foreseen| foreseen.residual < known.residual);
    let repeats = foreseen.is_none();
    let mut newton = Newton {
        step,
        settings,
        factors: start.factors.clone().filter(|factors| factors.are_made(step)),
        state: foreseen.unwrap_or(known),
        forcing: Forcing::default(),
        count: 0,
        applications: 0,
        most: 0,
    };
    if repeats {
        newton.repeat();
    }
    while newton.unfinished() && newton.advance() {}
    newton.finish()
}

/// Newton steps under way.
struct Newton<'s> {
    step: &'s Mapped<'s>,
    settings: Settings,
    factors: Option<Arc<Factors>>,
    state: State,
    forcing: Forcing,
    count: usize,
    /// Applications of the compliance, and the most that one step took.
    applications: usize,
    most: usize,
}

impl Newton<'_> {
    fn unfinished(&self) -> bool {
        self.state.residual > self.settings.tolerance && self.count < self.settings.max_iterations
    }

    /// A step in which the pairs do what they did where the factors are from, if that brings them nearer.
    fn repeat(&mut self) {
        let Some(factors) = self.factors.clone().filter(|_| self.unfinished()) else { return };
        let left = self.forcing.next(self.state.residual, self.settings.tolerance);
        let change = self.change(factors.regime(&self.state, self.step), left);
        let next = self.state.moved(&change, 1.0, self.step);
        if next.residual < self.state.residual {
            self.state = next;
        } else {
            self.forcing = Forcing::default();
        }
    }

    /// A step, and whether it brought anything. Where it lowers no residual, its linear system is solved better.
    fn advance(&mut self) -> bool {
        let (residual, aim) = (self.state.residual, self.settings.tolerance);
        let mut term = Some(self.forcing.next(residual, aim));
        while let Some(left) = term.filter(|_| self.unfinished()) {
            let change = self.change(Regime::of(&self.state, self.step), left);
            let moved = |length: f64| {
                let next = self.state.moved(&change, length, self.step);
                let residual = next.residual;
                (next, residual)
            };
            if let Some((next, _)) = shorten(residual, moved) {
                self.state = next;
                return true;
            }
            term = self.forcing.again(residual, aim);
        }
        false
    }

    /// The change that the pairs ask for while they do something, to a relative residual.
    fn change(&mut self, regime: Regime, left: f64) -> Solution {
        let mut linear = Linear::about(&self.state, self.step, regime, self.factors.as_deref());
        let change = linear.solve(left, self.settings.max_iterations);
        self.count += 1;
        self.applications += linear.applications;
        self.most = self.most.max(linear.applications);
        change
    }

    fn finish(mut self) -> Outcome {
        let Self { step, ref state, .. } = self;
        if step.again && self.most > STALE {
            self.factors = Factors::of(state, step).map(Arc::new);
        }
        let status = state.status(self.settings.tolerance, step);
        let mut state = self.state;
        state.solution.factors = self.factors;
        state.finish(status, self.count, self.applications)
    }
}
