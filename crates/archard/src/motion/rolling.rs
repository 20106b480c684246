//! Steady rolling with creepage and spin (Kalker; the paper's section 2.2): twin discs, wheel on rail.
//!
//! The contact rolls along an axis of the frame, and the material flows through it against that
//! direction. Creepage is positive where the surface of body 1 runs faster than that of body 2: for
//! the paper's eq. 7, xi = (v2 - v1)/V, seen along the direction of rolling, because both surfaces
//! run backwards. Friction then drives body 1 forward: the force on it has the sign of the creepage.

use super::axes::{self, Axis};
use super::{
    APPROACH, Control, Drive, Drives, LOAD, Motion, Passage, Planned, Progress, Schedule, Sequence,
    Slip, Stepping, TOLERANCE, control, few_steps, pressing,
};
use crate::frame::Direction;
use crate::parameters::{Bound, Choice, Invalid, Parameter, Quantity, Values};

pub(super) const CHOICE: Choice<Planned> = Choice {
    name: "rolling",
    meaning: "steady rolling with creepage and spin; both profiles wear evenly around (twin discs)",
    parameters: &[
        LOAD,
        APPROACH,
        CREEPAGE,
        FORCE,
        LATERAL_CREEPAGE,
        LATERAL_FORCE,
        SPIN,
        axes::AXIS_ONE,
        axes::AXIS_TWO,
        DIRECTION,
        SPEED,
        REVOLUTIONS,
        STEP,
        TOLERANCE,
        Parameter::optional(
            "radius",
            Quantity::Word(&["nominal", "worn"]),
            "whether the creepage stays as given (nominal, the default) or follows the worn radii",
        ),
    ],
    build: |values| {
        let revolutions = values.require("revolutions")?;
        let mut rolling = Rolling::read(values)?;
        rolling.drives.axes = axes::read(values)?;
        rolling.drives.worn_radius = values.word("radius") == Some("worn");
        rolling.over(revolutions, control(values)?, stepping(values, revolutions)?)
    },
};

const REVOLUTIONS: Parameter =
    Parameter::required("revolutions", Quantity::Number, "revolutions of both discs")
        .bound(Bound::NonNegative);
const STEP: Parameter = Parameter::optional("step", Quantity::Number, "revolutions in one step");

/// Longitudinal creepage.
pub(super) const CREEPAGE: Parameter = Parameter::optional(
    "creepage",
    Quantity::Number,
    "longitudinal creepage, positive where body 1 is faster; 0 if not given",
)
.bound(Bound::Any);
/// Longitudinal force.
pub(super) const FORCE: Parameter = Parameter::optional(
    "force",
    Quantity::Force,
    "longitudinal force on body 1, forward positive, instead of the creepage",
)
.bound(Bound::Any);
/// Lateral creepage.
pub(super) const LATERAL_CREEPAGE: Parameter =
    Parameter::optional("lateral_creepage", Quantity::Number, "lateral creepage; 0 if not given")
        .bound(Bound::Any);
/// Lateral force.
pub(super) const LATERAL_FORCE: Parameter = Parameter::optional(
    "lateral_force",
    Quantity::Force,
    "lateral force on body 1 instead of the lateral creepage",
)
.bound(Bound::Any);
/// Spin.
pub(super) const SPIN: Parameter =
    Parameter::optional("spin", Quantity::Curvature, "spin; 0 if not given").bound(Bound::Any);
/// Direction of rolling.
pub(super) const DIRECTION: Parameter = Parameter::optional(
    "direction",
    Quantity::Word(&["x", "-x", "y", "-y"]),
    "axis of the frame along which the contact rolls; x if not given",
);

/// Speed of rolling.
pub(super) const SPEED: Parameter = Parameter::optional(
    "speed",
    Quantity::Speed,
    "speed of rolling, the mean of both surfaces; only for laws that depend on the speed or the temperature",
);

fn direction(values: &Values) -> Direction {
    let word = values.word("direction").unwrap_or("x");
    Direction { axis: usize::from(word.ends_with('y')), reversed: word.starts_with('-') }
}

/// The creepage given, or the force.
fn drive(values: &Values, creepage: &'static str, force: &'static str) -> Result<Drive, Invalid> {
    match (values.number(creepage), values.number(force)) {
        (None, None) => Ok(Drive::Slip(0.0)),
        _ => match values.one_of(creepage, force)? {
            (Some(creepage), _) => Ok(Drive::Slip(creepage)),
            (None, force) => Ok(Drive::Force(force.unwrap_or_default())),
        },
    }
}

fn stepping(values: &Values, revolutions: f64) -> Result<Stepping, Invalid> {
    if revolutions == 0.0 && values.number("step").is_none() && values.number("tolerance").is_none()
    {
        return Ok(Stepping::Implicit(1.0));
    }
    match values.one_of("step", "tolerance")? {
        (Some(step), _) => Ok(Stepping::Implicit(step)),
        (None, tolerance) => Ok(Stepping::Tolerance(tolerance.unwrap_or_default())),
    }
}

/// Steady rolling; progress is the number of revolutions, or the share of the drives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rolling {
    direction: Direction,
    drives: Drives,
    speed: Option<f64>,
}

impl Rolling {
    /// Free of creepage and spin, in that direction.
    pub fn along(direction: Direction) -> Self {
        Self { direction, drives: Drives::FREE, speed: None }
    }

    /// The same with that drive along the direction.
    #[must_use]
    pub fn longitudinal(self, drive: Drive) -> Self {
        Self { drives: Drives { longitudinal: drive, ..self.drives }, ..self }
    }

    /// The same with that drive across the direction.
    #[must_use]
    pub fn lateral(self, drive: Drive) -> Self {
        Self { drives: Drives { lateral: drive, ..self.drives }, ..self }
    }

    /// The same with that spin (1/m).
    #[must_use]
    pub fn spin(self, spin: f64) -> Self {
        Self { drives: Drives { spin, ..self.drives }, ..self }
    }

    /// The same whose longitudinal creepage gains so much (1/m^2) with the square of the place across.
    #[must_use]
    pub fn bow(self, bow: f64) -> Self {
        Self { drives: Drives { bow, ..self.drives }, ..self }
    }

    /// The same of bodies that turn about axes, body 1 first: spin and bow follow from these and from their shapes.
    #[must_use]
    pub fn about(self, axes: [Axis; 2]) -> Self {
        Self { drives: Drives { axes: Some(axes), ..self.drives }, ..self }
    }

    /// The same at that speed of rolling (m/s).
    #[must_use]
    pub fn at_speed(self, speed: f64) -> Self {
        Self { speed: Some(speed), ..self }
    }

    /// The same, its longitudinal creepage following the worn radii.
    #[must_use]
    pub fn with_worn_radius(self) -> Self {
        Self { drives: Drives { worn_radius: true, ..self.drives }, ..self }
    }

    /// Steady rolling over a number of revolutions at constant load or approach, in implicit steps of so many
    /// revolutions or by error. With no revolutions at all, the contact alone.
    ///
    /// # Errors
    /// If a value is not one to compute with, a step is more than all revolutions or far too short for them, or
    /// the steps are explicit.
    pub fn over(
        self,
        revolutions: f64,
        control: Control,
        stepping: Stepping,
    ) -> Result<Planned, Invalid> {
        let revolutions = REVOLUTIONS.admit(revolutions)?;
        match stepping {
            Stepping::Implicit(step) if revolutions > 0.0 && step > revolutions => {
                let message = "`step` is more than all `revolutions`";
                return Err(Invalid::new("step", message).beside("revolutions"));
            }
            Stepping::Explicit(_) => {
                return Err(Invalid::new("step", "steps of rolling are implicit"));
            }
            _ => {}
        }
        let stepping = few_steps(stepping, STEP, revolutions)?;
        let schedule = Schedule::steady(pressing(control)?, revolutions, stepping);
        Ok((self.checked()?.driven(Sequence::Steady, Progress::REVOLUTIONS), schedule))
    }

    /// It, if its drives and spin can be computed with.
    pub(super) fn checked(self) -> Result<Self, Invalid> {
        let Drives { longitudinal, lateral, spin, .. } = self.drives;
        let drives =
            [(longitudinal, [CREEPAGE, FORCE]), (lateral, [LATERAL_CREEPAGE, LATERAL_FORCE])];
        for (drive, [creepage, force]) in drives {
            match drive {
                Drive::Slip(value) => creepage.admit(value)?,
                Drive::Force(value) => force.admit(value)?,
            };
        }
        SPIN.admit(spin)?;
        self.speed.map(|speed| SPEED.admit(speed)).transpose()?;
        Ok(self)
    }

    /// What most rolling motions take.
    pub(super) fn read(values: &Values) -> Result<Self, Invalid> {
        let rolling = Self::along(direction(values))
            .longitudinal(drive(values, "creepage", "force")?)
            .lateral(drive(values, "lateral_creepage", "lateral_force")?)
            .spin(values.number("spin").unwrap_or(0.0));
        Ok(Self { speed: values.number("speed"), ..rolling })
    }

    /// Both surfaces pass once a revolution.
    pub(super) fn driven(self, sequence: Sequence, progress: Progress) -> Motion {
        let Self { direction, drives, speed } = self;
        let surfaces = [Passage::Passes(None); 2];
        Motion { progress, direction, surfaces, slip: Slip::Sought(drives), sequence, speed }
    }
}
