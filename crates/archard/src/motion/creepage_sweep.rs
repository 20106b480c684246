//! Steady rolling at creepages raised step by step: the curve of forces over creepages.

use super::rolling::{CREEPAGE, DIRECTION, FORCE, LATERAL_CREEPAGE, LATERAL_FORCE, Rolling, SPIN};
use super::{APPROACH, INCREMENTS, LOAD, Motion, Planned, Stepping, steady};
use crate::parameters::{Choice, Parameter, Quantity};

pub(super) const CHOICE: Choice<Planned> = Choice {
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
        let rolling = Rolling { swept: true, ..Rolling::read(values)? };
        let stepping = Stepping::Implicit(1.0 / increments);
        Ok((Motion::Rolling(rolling), steady(values, 1.0, stepping)?))
    },
};
