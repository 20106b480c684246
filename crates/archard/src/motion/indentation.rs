//! Two bodies pressed together, once or again and again.

use super::shift::{CYCLE_COUNT, Cycles, JUMP, JUMP_TOLERANCE, Shift, Station};
use super::{
    APPROACH, Control, INCREMENTS, LOAD, Motion, Planned, Progress, Schedule, control, counted,
    pressing,
};
use crate::parameters::{Choice, Invalid, Parameter, Quantity};

pub(super) const CHOICE: Choice<Planned> = Choice {
    name: "indentation",
    meaning: "load or approach raised in equal increments, once or in cycles",
    parameters: &[
        LOAD,
        APPROACH,
        COUNT,
        CYCLE_COUNT,
        Parameter::optional(
            "release",
            Quantity::Word(&["free", "rubbing"]),
            "how a cycle ends: taken apart without rubbing (free, the default) or unloaded in increments",
        ),
        Parameter::optional(
            "rubbing",
            Quantity::Word(&["mean", "end"]),
            "which pressure of an increment rubs: the mean, over the slip in contact (the default), or that at its end over all the slip, as in the paper",
        ),
        JUMP,
        JUMP_TOLERANCE,
    ],
    build: |values| {
        Indentation {
            increments: values.number("increments").unwrap_or(1.0) as usize,
            cycles: Cycles::read(values)?,
            rubs_on_release: values.word("release") == Some("rubbing"),
            end_pressure: values.word("rubbing") == Some("end"),
        }
        .under(control(values)?)
    },
};

const COUNT: Parameter =
    Parameter::optional("increments", Quantity::Count, "number of increments; 1 if not given")
        .bound(INCREMENTS);

/// Load or approach raised in equal increments, once or in cycles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Indentation {
    increments: usize,
    cycles: Cycles,
    rubs_on_release: bool,
    end_pressure: bool,
}

impl Indentation {
    /// That many increments, once; bodies are taken apart without rubbing.
    pub fn new(increments: usize) -> Self {
        let cycles = Cycles::default();
        Self { increments, cycles, rubs_on_release: false, end_pressure: false }
    }

    /// The same in cycles.
    #[must_use]
    pub fn cycles(self, cycles: Cycles) -> Self {
        Self { cycles, ..self }
    }

    /// The same, unloaded in increments, on which the bodies rub as well.
    #[must_use]
    pub fn rubbing_on_release(self) -> Self {
        Self { rubs_on_release: true, ..self }
    }

    /// The same, all slip of an increment rubbing under the pressure at its end, as in the paper, instead of the slip
    /// in contact under the mean pressure.
    #[must_use]
    pub fn at_end_pressure(self) -> Self {
        Self { end_pressure: true, ..self }
    }

    /// Up to that load or approach.
    ///
    /// # Errors
    /// If there are no increments or too many of them, or a value is not one to compute with.
    pub fn under(self, control: Control) -> Result<Planned, Invalid> {
        let (count, control) = (counted(COUNT, self.increments)?, pressing(control)?);
        let share = |index: usize| Station::pressed(control.scaled(index as f64 / count as f64));
        let mut cycle: Vec<Station> = (1..=count).map(share).collect();
        if self.rubs_on_release {
            cycle.extend((0..count).rev().map(share));
        }
        let steps = cycle.len();
        let (extent, stepping) = self.cycles.divided(1.0 / steps as f64)?;
        let once = self.cycles.count.is_none();
        let shift = Shift {
            lead: vec![],
            places: (1..=steps).map(|step| step as f64 / steps as f64).collect(),
            cycle,
            released: true,
            end_pressure: self.end_pressure,
            progress: if once { Progress::SHARE } else { Progress::CYCLES },
        };
        let schedule = Schedule::steady(control, extent, stepping);
        Ok((Motion::Shift(shift), Schedule { ramped: true, ..schedule }))
    }
}
