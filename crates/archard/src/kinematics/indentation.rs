//! Two bodies pressed together, without sliding.

use super::{APPROACH, Kinematics, LOAD, Motion, Progress, Stepping, control};
use crate::parameters::{Choice, Parameter, Quantity};

pub(super) const CHOICE: Choice<Motion> = Choice {
    name: "indentation",
    meaning: "load or approach raised in equal increments",
    parameters: &[
        LOAD,
        APPROACH,
        Parameter::optional("increments", Quantity::Count, "number of increments; 1 if not given"),
    ],
    build: |values| {
        let increments = values.number("increments").unwrap_or(1.0);
        Ok(Motion {
            kinematics: Box::new(Indentation),
            control: control(values)?,
            ramped: true,
            extent: 1.0,
            stepping: Stepping::Implicit(1.0 / increments),
        })
    },
};

/// Nothing slides; progress is the share of the load or approach applied.
#[derive(Debug)]
struct Indentation;

impl Kinematics for Indentation {
    fn slip(&self, _advance: f64) -> f64 {
        0.0
    }

    fn progress(&self) -> Progress {
        Progress { name: "share", column: "share", quantity: Quantity::Number }
    }
}
