//! Why a run stops.

use std::error::Error as StdError;

use super::refusal::Refusals;
use crate::closed_form::flash_temperature::FAST;
use crate::motion::Progress;
use crate::numerics::upwind::DegenerateCloud;

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
    Refused(#[from] Refusals),
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
    NotResumed(#[from] ResumeError),
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

/// Why a run does not go on from what was kept.
#[non_exhaustive]
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum ResumeError {
    /// It does not read as a run of this version.
    #[error("what was kept of the run cannot be read; start it anew")]
    Unreadable,
    /// It is of another simulation.
    #[error(
        "what was kept is of another case, or a file that the case names has changed; start it anew"
    )]
    OtherCase,
}
