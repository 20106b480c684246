//! Gross sliding: every pair in contact slides the same distance (pin on disc).

use super::{APPROACH, LOAD, Motion, Planned, Stepping, TOLERANCE, few_steps, steady};
use crate::parameters::{Choice, Invalid, Parameter, Quantity};

pub(super) const CHOICE: Choice<Planned> = Choice {
    name: "sliding",
    meaning: "sliding at constant load or approach, the same distance everywhere (pin on disc)",
    parameters: &[
        LOAD,
        APPROACH,
        Parameter::required("distance", Quantity::Length, "sliding distance"),
        Parameter::optional("step", Quantity::Length, "distance slid in one step"),
        TOLERANCE,
        Parameter::optional(
            "scheme",
            Quantity::Word(&["implicit", "explicit"]),
            "how a fixed step takes the pressure: at its end (implicit, the default) or at its start",
        ),
    ],
    build: |values| {
        let distance = values.require("distance")?;
        let explicit = values.word("scheme") == Some("explicit");
        let stepping = match values.one_of("step", "tolerance")? {
            (Some(step), _) if step > distance => {
                return Err(Invalid::new("step", "`step` is longer than `distance`"));
            }
            (Some(step), _) if explicit => Stepping::Explicit(few_steps(step, distance)?),
            (Some(step), _) => Stepping::Implicit(few_steps(step, distance)?),
            (None, _) if explicit => {
                return Err(Invalid::new(
                    "scheme",
                    "the explicit scheme takes a `step`, not a `tolerance`",
                ));
            }
            (None, tolerance) => Stepping::Tolerance(tolerance.unwrap_or_default()),
        };
        Ok((Motion::Sliding, steady(values, distance, stepping)?))
    },
};
