//! What those are shown who follow a run.

use std::error::Error as StdError;
use std::fmt;

use super::companion::Companions;
use super::effort::Effort;
use crate::motion::{Control, Stepping};
use crate::problem::{ContactProblem, ContactState};

/// What an observer is shown after the initial contact and after every accepted step.
#[derive(Debug, Clone, Copy)]
pub struct Report<'a> {
    /// The problem in the present frame, to which all fields belong: frames grow, and become wider.
    pub problem: &'a ContactProblem,
    /// What is known now.
    pub state: &'a ContactState,
    /// What it took.
    pub effort: Effort,
    /// Whether fields are due: at the start, at the schedule's outputs and at the end.
    pub output: bool,
    /// How far the motion goes (its own unit).
    pub extent: f64,
    /// The load or approach prescribed for this state.
    pub prescribed: Control,
    /// How the motion is divided into steps.
    pub stepping: Stepping,
    /// The same run on coarser grids, where an accuracy is asked for.
    pub companions: Option<&'a Companions>,
    /// Whether it is shown for the second time, by a run that goes on after an interruption.
    pub again: bool,
    /// The run, where it can be kept.
    pub march: Option<&'a dyn Kept>,
}

impl Report<'_> {
    /// All that the further steps of the run follow from, for [`Run::resume`](super::Run::resume).
    pub fn checkpoint(&self) -> Option<Vec<u8>> {
        self.march.map(Kept::to_bytes)
    }
}

/// A run that can be kept.
pub trait Kept: fmt::Debug + Sync {
    /// All that its further steps follow from.
    fn to_bytes(&self) -> Vec<u8>;
}

/// Someone who follows a run: writes files, draws a bar.
pub trait Observer: Send {
    /// Takes notice of a state. An error stops the run.
    fn observe(&mut self, report: &Report<'_>) -> Result<(), Box<dyn StdError + Send + Sync>>;

    /// Whether the run is to end where it was last shown, before the end of the motion.
    fn ends(&self) -> bool {
        false
    }
}
