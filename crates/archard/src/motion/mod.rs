//! Motions: how the bodies are driven, how slip follows, and how rubbing is collected into wear.
//!
//! A new motion is one file here and one line in [`MOTIONS`].

mod creepage_sweep;
mod fretting;
mod indentation;
mod path;
mod rolling;
mod rotation;
mod shift;
mod similar;
mod sliding;

use serde::{Deserialize, Serialize};

pub use fretting::Fretting;
pub use indentation::Indentation;
pub use path::Path;
pub use rolling::{Drive, Rolling};
pub use rotation::Rotation;
pub use shift::{Cycles, Guide, Shift, Station};
pub use sliding::{Sliding, Track};

use crate::frame::Direction;
use crate::parameters::{Bound, Choice, Invalid, Parameter, Quantity, Values};

/// How the bodies move on each other.
///
/// The *advance* is the motion's own measure of progress: metres for sliding, revolutions for rolling,
/// cycles or seconds for increments.
#[derive(Debug, Clone, PartialEq)]
pub enum Motion {
    /// All pairs in contact slide (gross sliding), the same distance or in proportion to the radius.
    Sliding(Sliding),
    /// Bodies roll: slip follows from the tractions, and all pairs on a line along the motion wear alike.
    Rolling(Rolling),
    /// Bodies are pressed and shifted in increments: each pair slips as far as the tractions let it.
    Shift(Shift),
}

/// Surfaces that pass: their points come through the contact along a line, and all of that line wear alike.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Passing {
    /// Along the motion.
    pub direction: Direction,
    /// Which bodies pass; the others stay.
    pub bodies: [bool; 2],
    /// How often a point passes while the motion advances by one (its own unit).
    pub passages: f64,
    /// How long the surfaces are (m), where they are of one length.
    pub length: Option<f64>,
}

/// Surfaces whose points come through the contact one after the other, at one speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stream {
    /// Where the contact moves over these surfaces.
    pub direction: Direction,
    /// Which bodies they belong to; the contact stays where it is on the other one.
    pub bodies: [bool; 2],
    /// The speed (m/s): of rolling the mean of both bodies. `None` where it is not known.
    pub speed: Option<f64>,
}

impl Motion {
    /// The surfaces that stream through the contact; `None` where none does, or not at one speed as on a stroke.
    pub fn stream(&self) -> Option<Stream> {
        match self {
            Self::Rolling(Rolling { direction, speed, .. }) => {
                Some(Stream { direction: *direction, bodies: [true; 2], speed: *speed })
            }
            Self::Sliding(Sliding {
                swing: None, track: Some(track), direction, speed, ..
            }) => {
                // Body 2 slides along the direction over body 1: over body 2 the contact moves back.
                let direction = if track.body == 1 { direction.back() } else { *direction };
                let bodies = [0, 1].map(|body| body == track.body);
                (!track.strokes).then_some(Stream { direction, bodies, speed: *speed })
            }
            Self::Sliding(_) | Self::Shift(_) => None,
        }
    }

    /// The surfaces that pass, if any do and may wear.
    pub fn passing(&self) -> Option<Passing> {
        match self {
            Self::Rolling(rolling) => (!rolling.swept).then_some(Passing {
                direction: rolling.direction,
                bodies: [true; 2],
                passages: 1.0,
                length: None,
            }),
            // What swings does not pass evenly.
            Self::Sliding(Sliding { swing: Some(_), .. }) => None,
            Self::Sliding(sliding) => sliding.track.map(|track| Passing {
                direction: sliding.direction,
                bodies: [0, 1].map(|body| body == track.body),
                passages: 1.0 / track.length,
                length: Some(track.length),
            }),
            Self::Shift(_) => None,
        }
    }

    /// Along which axes it moves the bodies over planes of symmetry: sliding of surfaces that stay is the same on both sides.
    pub fn moves(&self) -> [bool; 2] {
        match self {
            Self::Rolling(rolling) => rolling.moves(),
            Self::Shift(shift) => shift.moves_along(),
            Self::Sliding(_) => {
                let along = self.passing().map(|passing| passing.direction.axis);
                [0, 1].map(|axis| along == Some(axis))
            }
        }
    }

    /// Along which direction the surface of a body is worn alike, at least far from the ends of a stroke, and which bodies are.
    pub fn worn_along(&self) -> Option<(Direction, [bool; 2])> {
        let passing = self.passing().map(|passing| (passing.direction, passing.bodies));
        let stroke = || {
            let sliding = self.sliding()?;
            let track = sliding.track?;
            Some((sliding.direction, [0, 1].map(|body| body == track.body)))
        };
        passing.or_else(stroke)
    }

    /// Distance (m) that pairs in contact slide over each other while the motion advances by that much, at a unit
    /// [lever](Self::lever); zero where friction decides it.
    pub fn slip(&self, advance: f64) -> f64 {
        match self {
            Self::Sliding(Sliding { rotation: Some(rotation), .. }) => rotation.angle * advance,
            Self::Sliding(Sliding { swing: Some(amplitude), track: None, .. }) => {
                4.0 * amplitude * advance
            }
            Self::Sliding(_) => advance,
            Self::Rolling(_) | Self::Shift(_) => 0.0,
        }
    }

    /// How far a pair at a place (m) slides beside the [slip](Self::slip): one, or where bodies turn the distance from the
    /// axis (m).
    pub fn lever(&self, [x, y]: [f64; 2]) -> f64 {
        if self.turns() { x.hypot(y) } else { 1.0 }
    }

    /// Whether one body turns on the other about the normal.
    pub fn turns(&self) -> bool {
        self.sliding().is_some_and(|sliding| sliding.rotation.is_some())
    }

    /// Speed at which bodies slide that slide the same distance everywhere (m/s), where it is known.
    pub fn speed(&self) -> Option<f64> {
        self.sliding()?.speed
    }

    /// Whether the speed of slip is known where pairs slip.
    pub fn tells_speed(&self) -> bool {
        self.speed().is_some() || self.rolling().is_some_and(|rolling| rolling.speed.is_some())
    }

    /// Along which vector body 2 slides over body 1 at a place (m), if all pairs in contact do.
    pub fn slides(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        if self.turns() && [x, y] != [0.0; 2] {
            return [-y, x];
        }
        self.sliding().map_or(Direction::X, |sliding| sliding.direction).forward()
    }

    /// How the bodies slide, if all pairs in contact do.
    pub fn sliding(&self) -> Option<&Sliding> {
        if let Self::Sliding(sliding) = self { Some(sliding) } else { None }
    }

    /// How the bodies roll, if they do.
    pub fn rolling(&self) -> Option<&Rolling> {
        if let Self::Rolling(rolling) = self { Some(rolling) } else { None }
    }

    /// The axis (0 or 1) along which it rolls; the first one for other motions.
    pub fn axis(&self) -> usize {
        self.rolling().map_or(0, |rolling| rolling.direction.axis)
    }

    /// What drives bodies that roll along x and along y.
    pub fn drives(&self) -> Option<[Drive; 2]> {
        let Rolling { direction, longitudinal, lateral, .. } = *self.rolling()?;
        let along_x = direction.axis == 0;
        Some(if along_x { [longitudinal, lateral] } else { [lateral, longitudinal] })
    }

    /// How the bodies are shifted against each other, if they are.
    pub fn shift(&self) -> Option<&Shift> {
        if let Self::Shift(shift) = self { Some(shift) } else { None }
    }

    /// How far the motion goes in a cycle (its own unit), if it goes through cycles.
    pub fn period(&self) -> Option<f64> {
        self.shift().map(Shift::period)
    }

    /// Whether friction decides which pairs slip, and how far.
    pub fn slips_partly(&self) -> bool {
        !matches!(self, Self::Sliding(_))
    }

    /// Amplitude (m) by which the surfaces swing past each other, if they do.
    pub fn swing(&self) -> Option<f64> {
        self.sliding()?.swing
    }

    /// What progress measures, for result columns and messages.
    pub fn progress(&self) -> Progress {
        match self {
            Self::Sliding(Sliding { rotation: Some(rotation), .. }) => rotation.progress,
            Self::Sliding(Sliding { swing: Some(_), track: None, .. }) => Progress::CYCLES,
            Self::Sliding(_) => Progress::DISTANCE,
            Self::Rolling(rolling) if rolling.swept => Progress::SHARE,
            Self::Rolling(_) => Progress::REVOLUTIONS,
            Self::Shift(shift) => shift.progress,
        }
    }
}

/// How the progress of a motion is called and shown.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Progress {
    /// What it is, for people: "distance".
    pub name: &'static str,
    /// The result column, unit included: "distance_m".
    pub column: &'static str,
    /// What it measures.
    pub quantity: Quantity,
}

impl Progress {
    /// Distance slid (m).
    pub const DISTANCE: Self =
        Self { name: "distance", column: "distance_m", quantity: Quantity::Length };
    /// Revolutions of body 1.
    pub const REVOLUTIONS: Self =
        Self { name: "revolution", column: "revolutions", quantity: Quantity::Number };
    /// Cycles gone through.
    pub const CYCLES: Self = Self { name: "cycle", column: "cycle", quantity: Quantity::Number };
    /// Time (s).
    pub const TIME: Self = Self { name: "time", column: "time_s", quantity: Quantity::Time };
    /// Share of what is raised: a load, an approach, creepages.
    pub const SHARE: Self = Self { name: "share", column: "share", quantity: Quantity::Number };
    /// What the progress of some motion is.
    pub const ALL: [Self; 5] =
        [Self::DISTANCE, Self::REVOLUTIONS, Self::CYCLES, Self::TIME, Self::SHARE];

    /// A value of it (SI) in words: "distance 0.05 m".
    pub fn at(&self, value: f64) -> String {
        format!("{} {}", self.name, self.length(value))
    }

    /// A difference of two values (SI) in words: "0.05 m".
    pub fn length(&self, value: f64) -> String {
        // Seven digits: a sum of steps is not shown with what rounding made of it.
        let rounded: f64 = format!("{value:.6e}").parse().unwrap_or(value);
        match self.quantity {
            Quantity::Length => format!("{rounded:?} m"),
            Quantity::Time => format!("{rounded:?} s"),
            _ => format!("{rounded:?}"),
        }
    }
}

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

/// The motions a case can name.
pub const MOTIONS: &[Choice<Planned>] = &[
    indentation::CHOICE,
    fretting::CHOICE,
    path::CHOICE,
    sliding::CHOICE,
    rotation::CHOICE,
    rolling::CHOICE,
    creepage_sweep::CHOICE,
];

/// The load, as most motions take it.
const LOAD: Parameter = Parameter::optional("load", Quantity::Force, "normal force");
/// The approach, as most motions take it.
const APPROACH: Parameter =
    Parameter::optional("approach", Quantity::Length, "approach of the bodies from first touch");
/// The tolerance, as most motions take it.
const TOLERANCE: Parameter =
    Parameter::optional("tolerance", Quantity::Number, "relative error allowed in the wear depth")
        .bound(Bound::Between(0.0, 1.0));

/// Increments of a cycle, each of which is kept, and of a sweep.
const MOST_INCREMENTS: f64 = 1e5;
/// The bound of `increments`.
const INCREMENTS: Bound = Bound::UpTo(0.0, MOST_INCREMENTS);

/// That number of increments.
fn counted(parameter: Parameter, increments: usize) -> Result<usize, Invalid> {
    parameter.admit(increments as f64).map(|_| increments)
}
/// Steps of a fixed length, which no run ever gets through beyond this.
const MOST_STEPS: f64 = 1e9;

/// The stepping, if a step divides the motion into no more steps than can be taken.
fn few_steps(stepping: Stepping, step: Parameter, extent: f64) -> Result<Stepping, Invalid> {
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
fn control(values: &Values) -> Result<Control, Invalid> {
    match values.one_of("load", "approach")? {
        (Some(load), _) => Ok(Control::Load(load)),
        (None, approach) => Ok(Control::Approach(approach.unwrap_or_default())),
    }
}

/// The control, if its value is one to press bodies together by.
fn pressing(control: Control) -> Result<Control, Invalid> {
    match control {
        Control::Load(load) => LOAD.admit(load)?,
        Control::Approach(approach) => APPROACH.admit(approach)?,
    };
    Ok(control)
}
