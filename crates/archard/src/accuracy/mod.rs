//! The grid that an accuracy takes: runs on coarser ones come first, and say how far off the run itself will be.
//!
//! Elements, tolerance of the steps and increments of a cycle are one resolution: finer by a ratio r, the tolerance is smaller by
//! the power of r that is the order of the error, one at an edge and two elsewhere. [`settle`] judges a first [`Grid`] and refines it
//! until the error that [`Companions`](crate::simulation::Companions) foresee is the one that is asked for.

mod builder;
mod grid;
mod increments;
mod regularity;
mod settle;

pub use grid::{Grid, MOST};
pub use increments::{DIVISOR, FEWEST, MOST as MOST_INCREMENTS};
pub use regularity::{has_tip, order};
pub use settle::{
    AccuracyFailure, Build, Enough, Event, FARTHEST, FINER, Failed, SettledRun, Watch, settle,
};

/// The least accuracy that can be asked for.
pub const COARSEST: f64 = 0.2;
/// Tolerance of the steps, relative to the accuracy: with four times as much, a companion differs by three times their error.
pub const TOLERANCE: f64 = 1.0 / 3.0;
/// Elements across the unworn contact, at least: of those of the coarsest companion more than three are left.
pub const UNWORN: f64 = 10.0;

/// Whether a value is an accuracy: a relative error greater than 0 and at most [`COARSEST`].
pub fn admitted(value: f64) -> bool {
    value > 0.0 && value <= COARSEST
}

/// Why a value does not exist.
pub fn refusal() -> String {
    format!("must be greater than 0 and at most {COARSEST}, a relative error")
}
