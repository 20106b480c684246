//! Two bodies pressed together, once or again and again.

use super::shift::{CYCLE_COUNT, Cycles, JUMP, JUMP_TOLERANCE, Shift, Station};
use super::{
    APPROACH, Control, INCREMENTS, LOAD, Lever, Motion, Passage, Planned, Progress, Schedule,
    Sequence, Slip, Stepping, control, counted, pressing,
};
use crate::frame::Direction;
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

impl Motion {
    /// Two bodies that a load or an approach presses together, and that do not move.
    ///
    /// # Errors
    /// If the control is not greater than zero.
    pub fn pressed(control: Control) -> Result<Planned, Invalid> {
        let motion = Self {
            progress: Progress::SHARE,
            direction: Direction::X,
            surfaces: [Passage::Stays; 2],
            slip: Slip::Given(0.0, Lever::Even),
            sequence: Sequence::Steady,
            speed: None,
        };
        Ok((motion, Schedule::steady(pressing(control)?, 0.0, Stepping::ToOutputs)))
    }

    /// Two bodies that are pressed together as at a station, and then shifted or pushed there, in so many increments each where
    /// friction makes the way count.
    ///
    /// # Errors
    /// If a value of the station is not one to compute with, or there are no increments or too many of them.
    pub fn shifted(station: Station, increments: usize) -> Result<Planned, Invalid> {
        if !station.is_finite() {
            return Err(Invalid::new("shift", "a shift or a force is not finite"));
        }
        let control = pressing(station.control)?;
        let shift = Shift {
            lead: station.lead(counted(COUNT, increments)?),
            cycle: vec![station],
            places: vec![1.0],
            released: false,
            end_pressure: false,
        };
        let schedule = Schedule::steady(control, 1.0, Stepping::Implicit(1.0));
        Ok((Self::cycle_of(shift, Progress::SHARE), schedule))
    }
}

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
        };
        let progress = if once { Progress::SHARE } else { Progress::CYCLES };
        let schedule = Schedule::steady(control, extent, stepping);
        Ok((Motion::cycle_of(shift, progress), Schedule { ramped: true, ..schedule }))
    }
}
