//! Two bodies pressed together, once or again and again.

use super::shift::{CYCLE_COUNT, JUMP, JUMP_TOLERANCE, Shift, Station};
use super::{APPROACH, INCREMENTS, LOAD, Motion, Planned, Progress, Schedule, control, jumps};
use crate::parameters::{Choice, Parameter, Quantity};

pub(super) const CHOICE: Choice<Planned> = Choice {
    name: "indentation",
    meaning: "load or approach raised in equal increments, once or in cycles",
    parameters: &[
        LOAD,
        APPROACH,
        Parameter::optional("increments", Quantity::Count, "number of increments; 1 if not given")
            .bound(INCREMENTS),
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
        let count = values.number("increments").unwrap_or(1.0) as usize;
        let control = control(values)?;
        let share = |index: usize| Station::pressed(control.scaled(index as f64 / count as f64));
        let mut cycle: Vec<Station> = (1..=count).map(share).collect();
        if values.word("release") == Some("rubbing") {
            cycle.extend((0..count).rev().map(share));
        }
        let cycles = values.number("cycles");
        let steps = cycle.len();
        let shift = Shift {
            lead: vec![],
            places: (1..=steps).map(|step| step as f64 / steps as f64).collect(),
            cycle,
            released: true,
            end_pressure: values.word("rubbing") == Some("end"),
            progress: if cycles.is_some() { Progress::CYCLES } else { Progress::SHARE },
        };
        let stepping = jumps(values, 1.0 / steps as f64)?;
        let schedule = Schedule::steady(control, cycles.unwrap_or(1.0), stepping);
        Ok((Motion::Shift(shift), Schedule { ramped: true, ..schedule }))
    },
};
