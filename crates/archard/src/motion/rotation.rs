//! Bodies that turn on each other about the normal: a pin that oscillates about its axis, thrust washers, clutches.
//!
//! A pair slides in proportion to its distance from x = y = 0. Where flat bodies have worn in, they wear evenly, so that
//! p r is the same everywhere: the *uniform wear* of clutches.

use std::f64::consts::TAU;

use super::{
    APPROACH, Control, LOAD, Lever, Motion, Passage, Planned, Progress, Schedule, Sequence, Slip,
    Stepping, TOLERANCE, control, few_steps, pressing,
};
use crate::frame::Direction;
use crate::parameters::{Choice, Invalid, Parameter, Quantity};

pub(super) const CHOICE: Choice<Planned> = Choice {
    name: "rotation",
    meaning: "one body turns on the other about z, round or to and fro, the slip growing with the radius (pin in torsion, thrust washer)",
    parameters: &[LOAD, APPROACH, REVOLUTIONS, AMPLITUDE, CYCLES, STEP, TOLERANCE],
    build: |values| {
        let stepping = match values.one_of("step", "tolerance")? {
            (Some(step), _) => Stepping::Implicit(step),
            (None, tolerance) => Stepping::Tolerance(tolerance.unwrap_or_default()),
        };
        let control = control(values)?;
        match (values.number("amplitude"), values.one_of("revolutions", "cycles")?) {
            (None, (Some(revolutions), _)) => {
                Rotation::round().over(revolutions, control, stepping)
            }
            (Some(amplitude), (None, Some(cycles))) => {
                Rotation::to_and_fro(amplitude)?.over(cycles, control, stepping)
            }
            (Some(_), _) => {
                let message = "to and fro by an `amplitude`, bodies turn in `cycles`";
                Err(Invalid::new("revolutions", message).beside("amplitude"))
            }
            (None, _) => Err(Invalid::new("cycles", "`cycles` need an `amplitude`")),
        }
    },
};

const REVOLUTIONS: Parameter =
    Parameter::optional("revolutions", Quantity::Number, "revolutions in all, round and round");
const AMPLITUDE: Parameter = Parameter::optional(
    "amplitude",
    Quantity::Angle,
    "angle from the middle to both sides, where the body turns to and fro",
);
const CYCLES: Parameter =
    Parameter::optional("cycles", Quantity::Number, "number of cycles to and fro, instead");
const STEP: Parameter =
    Parameter::optional("step", Quantity::Number, "revolutions, or cycles, in one step");

/// How one body turns on the other about the normal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rotation {
    /// Angle (rad) by which a pair is rubbed while the motion advances by one revolution, or cycle.
    angle: f64,
    progress: Progress,
}

impl Rotation {
    /// Round and round.
    pub fn round() -> Self {
        Self { angle: TAU, progress: Progress::REVOLUTIONS }
    }

    /// To and fro, by an angle (rad) to both sides.
    ///
    /// # Errors
    /// If the angle is not greater than zero.
    pub fn to_and_fro(amplitude: f64) -> Result<Self, Invalid> {
        Ok(Self { angle: 4.0 * AMPLITUDE.admit(amplitude)?, progress: Progress::CYCLES })
    }

    /// So many revolutions, or cycles, at constant load or approach, in steps of a length or by error.
    ///
    /// # Errors
    /// If a value is not greater than zero, or a step is more than all or far too short.
    pub fn over(
        self,
        extent: f64,
        control: Control,
        stepping: Stepping,
    ) -> Result<Planned, Invalid> {
        let all = if self.progress == Progress::CYCLES { CYCLES } else { REVOLUTIONS };
        let extent = all.admit(extent)?;
        if let Stepping::Implicit(step) | Stepping::Explicit(step) = stepping
            && step > extent
        {
            let message = format!("`step` is more than all `{}`", all.name);
            return Err(Invalid::new("step", message).beside(all.name));
        }
        let stepping = few_steps(stepping, STEP, extent)?;
        let motion = Motion {
            progress: self.progress,
            direction: Direction::X,
            surfaces: [Passage::Stays; 2],
            slip: Slip::Given(self.angle, Lever::Radius),
            sequence: Sequence::Steady,
            speed: None,
        };
        Ok((motion, Schedule::steady(pressing(control)?, extent, stepping)))
    }
}
