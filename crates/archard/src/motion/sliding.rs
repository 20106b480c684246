//! Gross sliding: every pair in contact slides the same distance (pin on disc).

use super::{
    APPROACH, Control, LOAD, Motion, Planned, Schedule, Stepping, TOLERANCE, control, few_steps,
    pressing,
};
use crate::parameters::{Choice, Invalid, Parameter, Quantity};

pub(super) const CHOICE: Choice<Planned> = Choice {
    name: "sliding",
    meaning: "sliding at constant load or approach, the same distance everywhere (pin on disc)",
    parameters: &[
        LOAD,
        APPROACH,
        DISTANCE,
        STEP,
        TOLERANCE,
        Parameter::optional(
            "scheme",
            Quantity::Word(&["implicit", "explicit"]),
            "how a fixed step takes the pressure: at its end (implicit, the default) or at its start",
        ),
    ],
    build: |values| {
        let explicit = values.word("scheme") == Some("explicit");
        let stepping = match values.one_of("step", "tolerance")? {
            (Some(step), _) if explicit => Stepping::Explicit(step),
            (Some(step), _) => Stepping::Implicit(step),
            (None, _) if explicit => {
                return Err(Invalid::new(
                    "scheme",
                    "the explicit scheme takes a `step`, not a `tolerance`",
                ));
            }
            (None, tolerance) => Stepping::Tolerance(tolerance.unwrap_or_default()),
        };
        Sliding::over(values.require("distance")?, control(values)?, stepping)
    },
};

const DISTANCE: Parameter = Parameter::required("distance", Quantity::Length, "sliding distance");
const STEP: Parameter = Parameter::optional("step", Quantity::Length, "distance slid in one step");

/// Gross sliding: every pair in contact slides the same distance.
#[derive(Debug)]
pub struct Sliding;

impl Sliding {
    /// Sliding over a distance (m) at constant load or approach, in steps of a length (m) or by error.
    ///
    /// # Errors
    /// If a value is not greater than zero, or a step is longer than the distance or far too short for it.
    pub fn over(distance: f64, control: Control, stepping: Stepping) -> Result<Planned, Invalid> {
        let distance = DISTANCE.admit(distance)?;
        if let Stepping::Implicit(step) | Stepping::Explicit(step) = stepping
            && step > distance
        {
            return Err(Invalid::new("step", "`step` is longer than `distance`"));
        }
        let stepping = few_steps(stepping, STEP, distance)?;
        Ok((Motion::Sliding, Schedule::steady(pressing(control)?, distance, stepping)))
    }
}
