//! What those are shown who follow a run.

use std::error::Error as StdError;
use std::fmt;

use super::companion::Companions;
use super::effort::Effort;
use super::worn::worn_volume;
use crate::frame::VectorField;
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
    /// Normal force (N).
    pub fn load(&self) -> f64 {
        self.state.load
    }

    /// Largest pressure (Pa) of a pair.
    pub fn peak_pressure(&self) -> f64 {
        maximum(&self.state.pressure)
    }

    /// Area (m^2) of the pairs under pressure.
    pub fn area(&self) -> f64 {
        self.state.contact_area(self.problem)
    }

    /// Force on body 1 along x and y (N), of friction and, on curved frames, of the pressures; `None` of a motion whose friction is not
    /// sought.
    pub fn force(&self) -> Option<[f64; 2]> {
        let Self { problem, state, .. } = self;
        let own = state.tangential.as_ref()?;
        if problem.frame.is_plane() {
            return Some(own.force(&problem.frame));
        }
        let [t1, t2] = own.traction.clone();
        let n = state.pressure.iter().map(|pressure| -pressure).collect();
        let [x, y, _] = problem.frame.force(&VectorField { t1, t2, n });
        Some([x, y])
    }

    /// Deepest wear (m) of a body, by its index 0 or 1.
    pub fn wear_depth(&self, body: usize) -> f64 {
        maximum(&self.state.surfaces[body].depth)
    }

    /// Volume (m^3) worn off a body, by its index 0 or 1, off the whole track of one that passes; `None` in rolling.
    pub fn worn_volume(&self, body: usize) -> Option<f64> {
        worn_volume(self, body)
    }

    /// All that the further steps of the run follow from, for [`Run::resume`](super::Run::resume).
    pub fn checkpoint(&self) -> Option<Vec<u8>> {
        self.march.map(Kept::to_bytes)
    }
}

/// Largest value, zero at least.
pub(super) fn maximum(field: &[f64]) -> f64 {
    field.iter().copied().fold(0.0, f64::max)
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
