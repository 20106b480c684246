//! What a run begins from: a problem, how to solve it, and what to put it through.

use std::sync::{Arc, OnceLock};

use super::companion::Companions;
use super::surroundings::Surroundings;
use super::wider::Wider;
use crate::motion::Schedule;
use crate::problem::ContactProblem;
use crate::solve::Solver;
use crate::solve::tangential::FrictionSolver;

/// Two values of progress closer than this, relative to the extent, are the same.
pub(super) const SAME: f64 = 1e-9;

/// A problem, how to solve it, and what to put it through.
#[non_exhaustive]
#[derive(Debug)]
pub struct Simulation {
    /// The bodies, the frame and the motion.
    pub problem: ContactProblem,
    /// Solver of the contact steps.
    pub solver: Arc<dyn Solver>,
    /// Solver of friction, where the motion separates slip from stick.
    pub friction_solver: Arc<dyn FrictionSolver>,
    /// What the problem is put through.
    pub schedule: Schedule,
    /// The same run on coarser grids, where an accuracy is asked for.
    pub(crate) companions: Option<Companions>,
    /// Lowest gap (m) of pairs next to the frame, which no solve may come closer to; none but in a
    /// [window](super::placed::Placed::windowed).
    pub(crate) beside: f64,
    /// What it goes on with in a wider frame, where it does: see [`Simulation::widened`].
    pub wider: Option<Box<Wider>>,
    /// Pairs that the frame may grow to.
    pub most: usize,
    /// What lies beyond the frame; made where it is needed.
    pub(super) surroundings: OnceLock<Surroundings>,
}
