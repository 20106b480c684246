//! Solvers of friction under known pressures.
//!
//! The problem: on every pair the traction t is bounded, |t| <= limit, and where the slip s is not
//! zero t has that length and the direction of s. The slip is that of the rigid bodies less what
//! the tractions take away, s = rigid - B t. Instead of a rigid slip along some direction the force
//! along it may be given; the slip follows. Pairs that are [tied](Tie) to others or go by [means](TurningPair)
//! of slips, and the ellipse of
//! admissible tractions that a friction law makes of the disc |t| <= limit by its [map](crate::friction::Map), are seen by
//! [`solve`] alone.
//!
//! A new solver is one file here and one line in [`FRICTION_SOLVERS`].

mod contraction;
mod crop;
mod linear;
mod mapped;
mod newton;
mod pairs;
mod tied;
mod turning;
mod uzawa;

use std::fmt::Debug;

pub use mapped::solve;
pub use newton::Newton;
#[doc(hidden)]
pub use tied::Tie;
#[doc(hidden)]
pub use turning::TurningPair;
pub use uzawa::Uzawa;

use super::{Settings, Status, monolithic};
use crate::compliance::SlipMap;
use crate::frame::Measure;
use crate::friction::Map;
use crate::parameters::Choice;

/// One step of friction.
#[derive(Debug, Clone, Copy)]
pub struct Step<'a> {
    /// How tractions change the slip.
    pub map: &'a dyn SlipMap,
    /// Number of elements along x and y.
    pub elements: [usize; 2],
    /// How the pairs count.
    pub measure: Measure<'a>,
    /// Largest traction (Pa), one value a pair; zero outside the contact.
    pub limit: &'a [f64],
    /// Slip of the rigid bodies (m), along t1 and t2, one value a pair.
    pub rigid: [&'a [f64]; 2],
    /// Directions along which the force is given, two at most.
    pub prescribed: &'a [PrescribedForce],
}

/// Which tractions are admissible, the limits apart.
#[doc(hidden)]
#[derive(Debug, Clone, Copy)]
pub struct Admissible<'a> {
    /// Stretches the discs whose radii are the limits to the admissible sets.
    pub map: Map,
    /// Pairs whose tractions are shares of those of others.
    pub ties: &'a [Tie],
    /// Pairs whose friction depends on the mean of two slips.
    pub turning: &'a [TurningPair],
}

impl From<Map> for Admissible<'_> {
    fn from(map: Map) -> Self {
        Self { map, ties: &[], turning: &[] }
    }
}

/// A force that is given instead of a slip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PrescribedForce {
    /// Vector along which the bodies slip as far as it takes; of length one where tractions are those of the pairs.
    pub direction: [f64; 2],
    /// Sum over the contact of the tractions on body 1 times this vector (N): the force along it.
    pub force: f64,
}

/// A solution to start an iteration from.
#[derive(Debug, Clone, Copy)]
pub struct Start<'a> {
    /// Tractions (Pa), along t1 and t2, one value a pair.
    pub traction: [&'a [f64]; 2],
    /// Largest tractions (Pa) they had to keep to, one value a pair.
    pub limit: &'a [f64],
    /// Uniform slip (m) along each direction whose force is given.
    pub rigid_slip: &'a [f64],
}

/// What a solve found and what it took.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// How it ended; the fields hold the last iterate in any case.
    pub status: Status,
    /// Tractions on body 1 (Pa), along t1 and t2, one value a pair.
    pub traction: [Vec<f64>; 2],
    /// Slip of body 2 over body 1 (m), along t1 and t2, one value a pair; outside the contact, what the
    /// surfaces slide over each other without touching.
    pub slip: [Vec<f64>; 2],
    /// Uniform slip (m) along each direction whose force is given.
    pub rigid_slip: Vec<f64>,
    /// Iterations done.
    pub iterations: usize,
    /// Distance of the tractions from those that the slip projects them on, relative to the limits
    /// (2-norms over the area), or of the forces from those given, relative to the largest force.
    pub residual: f64,
    /// How often the map was applied; applications on coarser elements count by their number.
    pub applications: usize,
}

/// Solves one step of friction.
pub trait FrictionSolver: Debug + Send + Sync {
    /// Finds the tractions of a step, from those of an earlier one where there is one.
    fn solve(&self, step: &Step<'_>, start: Option<Start<'_>>) -> Outcome;

    /// Finds pressures and tractions at once, where the solver can, from known ones or those foreseen; `None`
    /// where they are to be found in turn.
    fn solve_jointly(
        &self,
        _step: &monolithic::Step<'_>,
        _start: &monolithic::Solution,
        _foreseen: Option<&monolithic::Solution>,
    ) -> Option<monolithic::Outcome> {
        None
    }

    /// The same solver with another bound on the residual.
    fn with_tolerance(&self, tolerance: f64) -> Box<dyn FrictionSolver>;

    /// What it was told.
    fn settings(&self) -> Settings;
}

/// The solvers of friction a case can name; the first is the default.
pub const FRICTION_SOLVERS: &[Choice<Box<dyn FrictionSolver>>] = &[newton::CHOICE, uzawa::CHOICE];

/// Bound on the residual where a case gives none.
const TOLERANCE: f64 = 1e-6;
