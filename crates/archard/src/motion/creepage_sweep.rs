//! Steady rolling at creepages raised step by step: the curve of forces over creepages.

use super::rolling::{
    CREEPAGE, DIRECTION, FORCE, LATERAL_CREEPAGE, LATERAL_FORCE, Rolling, SPEED, SPIN,
};
use super::{
    APPROACH, Control, INCREMENTS, LOAD, Planned, Progress, Schedule, Sequence, Stepping, control,
    counted, pressing,
};
use crate::parameters::{Choice, Invalid, Parameter, Quantity};

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
        SPEED,
        COUNT,
    ],
    build: |values| {
        let increments = values.number("increments").unwrap_or(10.0) as usize;
        Rolling::read(values)?.swept(increments, control(values)?)
    },
};

const COUNT: Parameter =
    Parameter::optional("increments", Quantity::Count, "number of increments; 10 if not given")
        .bound(INCREMENTS);

impl Rolling {
    /// Rolling at creepages, forces and spin raised together in that many equal increments, from nothing to what
    /// they are here, at constant load or approach. Nothing wears.
    ///
    /// # Errors
    /// If there are no increments or too many of them, or a value is not one to compute with.
    pub fn swept(self, increments: usize, control: Control) -> Result<Planned, Invalid> {
        let stepping = Stepping::Implicit(1.0 / counted(COUNT, increments)? as f64);
        let raised = self.checked()?.driven(Sequence::Raised, Progress::SHARE);
        Ok((raised, Schedule::steady(pressing(control)?, 1.0, stepping)))
    }
}
