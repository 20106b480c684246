//! Steady rolling at creepages raised step by step: the curve of forces over creepages.

use super::rolling::{CREEPAGE, DIRECTION, FORCE, LATERAL_CREEPAGE, LATERAL_FORCE, Rolling, SPIN};
use super::{APPROACH, INCREMENTS, LOAD, Motion, Stepping, control};
use crate::parameters::{Choice, Parameter, Quantity};

pub(super) const CHOICE: Choice<Motion> = Choice {
    name: "creepage_sweep",
    meaning: "steady rolling at creepages, forces and spin raised together in equal increments",
    parameters: &[
        LOAD,
        APPROACH,
        CREEPAGE,
        FORCE,
        LATERAL_CREEPAGE,
        LATERAL_FORCE,
        SPIN,
        DIRECTION,
        Parameter::optional("increments", Quantity::Count, "number of increments; 10 if not given")
            .bound(INCREMENTS),
    ],
    build: |values| {
        let increments = values.number("increments").unwrap_or(10.0);
        Ok(Motion {
            kinematics: Box::new(Rolling { swept: true, ..Rolling::read(values)? }),
            control: control(values)?,
            ramped: false,
            extent: 1.0,
            stepping: Stepping::Implicit(1.0 / increments),
        })
    },
};
