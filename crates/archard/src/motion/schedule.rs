//! Load, extent and steps of motions, and the parameters that most of them take for these.

use serde::{Deserialize, Serialize};

use super::Motion;
use crate::parameters::{Bound, Invalid, Parameter, Quantity, Values};

/// What holds the bodies together.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Control {
    /// The normal force (N); the approach follows.
    Load(f64),
    /// The approach of the bodies from first touch (m); the load follows.
    Approach(f64),
}

impl Control {
    /// The control scaled by that factor.
    pub fn scaled(self, factor: f64) -> Self {
        match self {
            Control::Load(load) => Control::Load(factor * load),
            Control::Approach(approach) => Control::Approach(factor * approach),
        }
    }
}

/// How the advance of a motion is divided into steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Stepping {
    /// Implicit steps of that length (the motion's unit).
    Implicit(f64),
    /// Explicit steps of that length (the motion's unit); stable only below a bound.
    Explicit(f64),
    /// Implicit steps chosen so that the relative error of the depth stays below this; of a motion in
    /// cycles, jumps over cycles chosen likewise.
    Tolerance(f64),
    /// One cycle computed out of that many, the wear of the others taken from it.
    Jumps(usize),
    /// Implicit steps, each to the next of the schedule's outputs; not of motions in cycles.
    ToOutputs,
}

/// Load, extent and steps of a motion.
#[derive(Debug, Clone, PartialEq)]
pub struct Schedule {
    /// What holds the bodies together, at the end of the motion.
    pub control: Control,
    /// Whether the control grows in proportion to the progress instead of being constant.
    pub ramped: bool,
    /// How far the motion goes (its own unit).
    pub extent: f64,
    /// How it is divided into steps.
    pub stepping: Stepping,
    /// Progress at which fields are put out, rising, the end of the motion among them. Steps chosen
    /// by error end on them; fixed steps put out when they first reach or pass one.
    pub outputs: Vec<f64>,
}

impl Schedule {
    /// Under one load or approach throughout, without outputs on the way.
    pub fn steady(control: Control, extent: f64, stepping: Stepping) -> Self {
        Self { control, ramped: false, extent, stepping, outputs: vec![] }
    }

    /// The load or approach at some progress (the motion's unit).
    pub fn control_at(&self, progress: f64) -> Control {
        if self.ramped { self.control.scaled(progress / self.extent) } else { self.control }
    }
}

/// A motion and what it is put through, as a case states them.
pub type Planned = (Motion, Schedule);

/// The load, as most motions take it.
pub(super) const LOAD: Parameter = Parameter::optional("load", Quantity::Force, "normal force");
/// The approach, as most motions take it.
pub(super) const APPROACH: Parameter =
    Parameter::optional("approach", Quantity::Length, "approach of the bodies from first touch");
/// The tolerance, as most motions take it.
pub(super) const TOLERANCE: Parameter =
    Parameter::optional("tolerance", Quantity::Number, "relative error allowed in the wear depth")
        .bound(Bound::Between(0.0, 1.0));

/// Increments of a cycle, each kept, and of a sweep.
pub(super) const MOST_INCREMENTS: f64 = 1e5;
/// The bound of `increments`.
pub(super) const INCREMENTS: Bound = Bound::UpTo(0.0, MOST_INCREMENTS);

/// That number of increments.
pub(super) fn counted(parameter: Parameter, increments: usize) -> Result<usize, Invalid> {
    parameter.admit(increments as f64).map(|_| increments)
}

/// Steps of a fixed length, which no run ever gets through beyond this.
const MOST_STEPS: f64 = 1e9;

/// The stepping, if a step divides the motion into no more steps than can be taken.
pub(super) fn few_steps(
    stepping: Stepping,
    step: Parameter,
    extent: f64,
) -> Result<Stepping, Invalid> {
    let length = match stepping {
        Stepping::Implicit(length) | Stepping::Explicit(length) => step.admit(length)?,
        Stepping::Tolerance(tolerance) => {
            TOLERANCE.admit(tolerance)?;
            return Ok(stepping);
        }
        Stepping::Jumps(_) => {
            return Err(Invalid::new(step.name, "only motions in cycles jump over some"));
        }
        Stepping::ToOutputs => return Ok(stepping),
    };
    if extent / length > MOST_STEPS {
        let message =
            format!("asks for {:.1e} steps, {MOST_STEPS:e} at most can be taken", extent / length);
        return Err(Invalid::new(step.name, message));
    }
    Ok(stepping)
}

/// The control out of `load` and `approach`.
pub(super) fn control(values: &Values) -> Result<Control, Invalid> {
    match values.one_of("load", "approach")? {
        (Some(load), _) => Ok(Control::Load(load)),
        (None, approach) => Ok(Control::Approach(approach.unwrap_or_default())),
    }
}

/// The control, if its value is one to press bodies together by.
pub(super) fn pressing(control: Control) -> Result<Control, Invalid> {
    match control {
        Control::Load(load) => LOAD.admit(load)?,
        Control::Approach(approach) => APPROACH.admit(approach)?,
    };
    Ok(control)
}
