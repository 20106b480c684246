//! A motion carried through: contact and wear step after step.

mod adaptive;
mod builder;
mod checkpoint;
mod collector;
mod companion;
mod contact;
mod cycles;
mod friction;
pub mod history;
mod march;
mod memory;
mod moving;
mod passing;
mod periodic;
mod placed;
pub mod refusal;
mod rolling;
mod run;
mod scar;
mod second_order;
mod spread;
mod step;
mod steps;
mod surroundings;
mod swing;
mod touch;
mod trial;
mod wider;
mod worn;

use std::error::Error as StdError;
use std::sync::{Arc, OnceLock};

use serde::{Deserialize, Serialize};

pub use builder::{Builder, line_of_contact};
pub use checkpoint::{NotResumed, digest};
pub use companion::{Companion, Companions, Regularity};
pub use contact::Contact;
pub use history::row;
pub use march::March;
pub use passing::WornLine;
pub use periodic::repeats;
pub use refusal::Refused;
pub use run::Run;
pub use scar::{worn_extent, worn_middle};
use surroundings::Surroundings;
pub use swing::solves_of_a_step;
pub use wider::{Wider, can_widen};

use crate::closed_form::flash_temperature::FAST;
use crate::motion::{Control, Progress, Schedule, Stepping};
use crate::numerics::upwind::DegenerateCloud;
use crate::problem::{ContactProblem, ContactState};
use crate::solve::Solver;
use crate::solve::tangential::FrictionSolver;

/// A problem, how to solve it, and what to put it through.
#[non_exhaustive]
#[derive(Debug)]
pub struct Simulation {
    /// The bodies, the frame and the motion.
    pub problem: ContactProblem,
    /// Solver of the contact steps.
    pub solver: Arc<dyn Solver>,
    /// Solver of friction, where the motion tells slip from stick.
    pub friction_solver: Arc<dyn FrictionSolver>,
    /// What the problem is put through.
    pub schedule: Schedule,
    /// The same run on coarser grids, where an accuracy is asked for.
    pub(crate) companions: Option<Companions>,
    /// Lowest gap (m) of pairs beside the frame, which no solve may come closer to; none but in a
    /// [window](placed::Placed::windowed).
    pub(crate) beside: f64,
    /// What it goes on with in a wider frame, where it does: see [`Simulation::widened`].
    pub wider: Option<Box<Wider>>,
    /// Pairs that the frame may grow to.
    pub most: usize,
    /// What lies beyond the frame; made where it is needed.
    surroundings: OnceLock<Surroundings>,
}

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
    pub march: Option<&'a March>,
}

impl Report<'_> {
    /// All that the further steps of the run follow from, for [`Run::resume`].
    pub fn checkpoint(&self) -> Option<Vec<u8>> {
        self.march.map(March::to_bytes)
    }
}

/// What a step took, and what the run took so far.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Effort {
    /// Steps accepted so far.
    pub steps: usize,
    /// Steps rejected so far.
    pub rejected: usize,
    /// Contact solves so far.
    pub solves: usize,
    /// Iterations of this step's solves, rejected ones included.
    pub iterations: usize,
    /// Applications of the compliance so far.
    pub applications: usize,
    /// Residual of the step's last solve.
    pub residual: f64,
    /// Estimate of the relative error of the wear depth that the division into steps has caused;
    /// `None` where no estimate is made.
    pub time_error: Option<f64>,
    /// What the pressure at the centre of the frame lags by (Pa): less this it is of second order in the steps; 0 where
    /// that is not known.
    pub centre_lag: f64,
    /// Increments so far that did not settle on what closing pairs slide before they touch.
    pub unsettled: usize,
    /// Cycles computed so far, those that were jumped over left out.
    pub true_cycles: usize,
    /// Energy (J) that friction has dissipated since the present cycle began, and in all whole cycles.
    pub dissipated: [f64; 2],
    /// Integral of the load over the distance slid (N m), to compare worn volumes with; in rolling, of
    /// the work of the creepages a revolution over the coefficient of friction (N), to compare worn
    /// sections with.
    pub load_distance: f64,
}

/// Someone who follows a run: writes files, draws a bar.
pub trait Observer: Send {
    /// Takes notice of a state. An error stops the run.
    fn observe(&mut self, report: &Report<'_>) -> Result<(), Box<dyn StdError + Send + Sync>>;
}

/// Why a run stopped before its end.
#[non_exhaustive]
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// A contact solve ran out of iterations.
    #[error(
        "the contact at {} did not converge: residual {residual:.1e} after {iterations} iterations, tolerance {tolerance:.1e}; allow more iterations or a larger tolerance in the `solver` table",
        .measure.at(*.progress)
    )]
    NotConverged {
        /// What progress measures.
        measure: Progress,
        /// Progress at the end of the step.
        progress: f64,
        /// Iterations done.
        iterations: usize,
        /// Residual reached.
        residual: f64,
        /// Residual asked for.
        tolerance: f64,
    },
    /// A solve of friction ran out of iterations.
    #[error(
        "friction at {} did not converge: residual {residual:.1e} after {iterations} iterations, tolerance {tolerance:.1e}; a force given has to be less than friction bears, otherwise allow more iterations or a larger tolerance in the `friction_solver` table",
        .measure.at(*.progress)
    )]
    FrictionNotConverged {
        /// What progress measures.
        measure: Progress,
        /// Progress at the end of the step.
        progress: f64,
        /// Iterations done.
        iterations: usize,
        /// Residual reached.
        residual: f64,
        /// Residual asked for.
        tolerance: f64,
    },
    /// Pressure, friction and wear did not agree with each other.
    #[error(
        "at {} pressure, friction and wear did not agree in {passes} passes; take shorter steps",
        .measure.at(*.progress)
    )]
    NotConsistent {
        /// What progress measures.
        measure: Progress,
        /// Progress at the end of the step.
        progress: f64,
        /// Passes done.
        passes: usize,
    },
    /// The contact fills the frame.
    #[error(
        "at {} every element of the frame is in contact: the frame is too small, enlarge `frame.size`, or the zone of the mesh",
        .measure.at(*.progress)
    )]
    FrameFull {
        /// What progress measures.
        measure: Progress,
        /// Progress at the end of the step.
        progress: f64,
    },
    /// The load is more than the surfaces bear where all of them yield.
    #[error(
        "at {} the load is more than the {borne:.4e} N that the surfaces bear where all of them yield; lower it, or give a larger `hardness`",
        .measure.at(*.progress)
    )]
    Overloaded {
        /// What progress measures.
        measure: Progress,
        /// Progress at the end of the step.
        progress: f64,
        /// The hardness over the area of the frame (N).
        borne: f64,
    },
    /// The contact needs a larger frame than there may be.
    #[error(
        "at {} the contact needs a frame of {} x {} elements, which are too many; take larger elements, or let the surfaces repeat themselves (`frame.periodic`)",
        .measure.at(*.progress), .elements[0], .elements[1]
    )]
    Outgrown {
        /// What progress measures.
        measure: Progress,
        /// How far the motion had gone.
        progress: f64,
        /// Number of elements along x and y.
        elements: [usize; 2],
    },
    /// Steps had to become too small.
    #[error(
        "at {} the step fell below {} without meeting the tolerance; allow a larger `tolerance`",
        .measure.at(*.progress),
        .measure.length(*.step)
    )]
    StepTooSmall {
        /// What progress measures.
        measure: Progress,
        /// Progress reached.
        progress: f64,
        /// Length of the last step tried.
        step: f64,
    },
    /// An amplitude that a part of the contact follows elastically.
    #[error(
        "no gross slip: the elastic deflection ({elastic:.3e} m) is too large for the amplitude ({amplitude:.3e} m); use `surfaces = \"stay\"` for partial slip"
    )]
    NoGrossSlip {
        /// The amplitude prescribed (m).
        amplitude: f64,
        /// What elasticity takes up (m).
        elastic: f64,
    },
    /// Surfaces that swing carry the contact beyond the frame, or end within it.
    #[error("{} the contact swings beyond the edge of the frame or of a surface; take a larger one", .measure.at(*.progress))]
    SwungOut {
        /// What progress measures.
        measure: Progress,
        /// Where (the motion's unit).
        progress: f64,
    },
    /// Parts that do not fit together.
    #[error(transparent)]
    Refused(#[from] Refused),
    /// Rolling on pairs that determine no derivative along the direction of rolling.
    #[error("particles do not pass from pair to pair: {0}")]
    NotPassed(#[from] DegenerateCloud),
    /// Friction of unlike bodies on a curved frame by a solver that cannot find it together with the pressures.
    #[error(
        "friction on a curved surface acts on the pressures; use a `friction_solver` that finds both at once: newton"
    )]
    NotMonolithic,
    /// A wear law of the temperature, in a contact that is passed too slowly for it to be known.
    #[error(
        "at {} the Peclet number of the contact is {peclet:.3}: laws that go by the temperature need {FAST} at least, since the flash temperature of fast surfaces does not hold below",
        .measure.at(*.progress)
    )]
    TooSlow {
        /// What progress measures.
        measure: Progress,
        /// Where (the motion's unit).
        progress: f64,
        /// The Peclet number.
        peclet: f64,
    },
    /// A run that was kept does not go on.
    #[error(transparent)]
    NotResumed(#[from] NotResumed),
    /// An observer could not go on.
    #[error(transparent)]
    Observer(Box<dyn StdError + Send + Sync>),
}

impl Error {
    /// Whether a solve, or the choice of a step, did not come to an end.
    pub fn is_of_convergence(&self) -> bool {
        self.is_of_length() || matches!(self, Self::StepTooSmall { .. })
    }

    /// Whether a shorter step, or jump, may do: it was a solve that did not come to an end.
    pub fn is_of_length(&self) -> bool {
        matches!(
            self,
            Self::NotConverged { .. }
                | Self::FrictionNotConverged { .. }
                | Self::NotConsistent { .. }
        )
    }
}
