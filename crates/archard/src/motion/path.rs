//! Loads and displacements as a table gives them over time.

use super::columns::{Columns, wrong};
use super::shift::{CYCLE_COUNT, Cycles, JUMP, JUMP_TOLERANCE, Shift, Station};
use super::{
    Control, Drive, INCREMENTS, MOST_INCREMENTS, Motion, Planned, Progress, Schedule, counted,
};
use crate::parameters::{Choice, Invalid, Parameter, Quantity};

pub(super) const CHOICE: Choice<Planned> = Choice {
    name: "path",
    meaning: "load or approach and tangential displacements or forces over time, from a file",
    parameters: &[
        Parameter::required(
            "file",
            Quantity::Table(COLUMNS),
            "CSV with columns time_s, load_N or approach_um, and shift_x_um or force_x_N and the same along y where it is not zero",
        ),
        COUNT,
        CYCLE_COUNT,
        JUMP,
        JUMP_TOLERANCE,
    ],
    build: |values| {
        let columns = values.table("file").unwrap_or_default();
        let increments = values.number("increments").unwrap_or(1.0) as usize;
        read(columns)?.increments(increments).cycles(Cycles::read(values)?).plan()
    },
};

const COUNT: Parameter = Parameter::optional(
    "increments",
    Quantity::Count,
    "increments between two lines of the file; 1 if not given",
)
.bound(INCREMENTS);

/// The columns a path may have.
const COLUMNS: &[(&str, Quantity)] = &[
    ("time", Quantity::Time),
    ("load", Quantity::Force),
    ("approach", Quantity::Length),
    ("shift_x", Quantity::Length),
    ("shift_y", Quantity::Length),
    ("force_x", Quantity::Force),
    ("force_y", Quantity::Force),
];

/// Loads or approaches and tangential displacements or forces over time.
#[derive(Debug, Clone, PartialEq)]
pub struct Path {
    /// Rising times (s).
    times: Vec<f64>,
    stations: Vec<Station>,
    increments: usize,
    cycles: Cycles,
}

impl Path {
    /// What holds the bodies at rising times (s), the first of them zero, and in proportion in between; gone through
    /// once, an increment from each to the next.
    ///
    /// # Errors
    /// If the times do not begin with zero or do not rise, a value is not finite, a load is negative, or it changes
    /// on the way whether a load or an approach, a displacement or a force is given.
    pub fn new(stations: &[(f64, Station)]) -> Result<Self, Invalid> {
        let (times, stations): (Vec<f64>, Vec<Station>) = stations.iter().copied().unzip();
        let [instant, _] = Quantity::Time.range();
        let rise = |pair: &[f64]| pair[1] - pair[0] >= instant;
        if times.len() < 2 || times[0] != 0.0 || !times.windows(2).all(rise) {
            return Err(wrong("times must begin with zero and rise from line to line"));
        }
        if !stations.iter().all(Station::is_finite) {
            return Err(wrong("loads, approaches, displacements and forces must be finite"));
        }
        let negative =
            |station: &Station| matches!(station.control, Control::Load(load) if load < 0.0);
        if stations.iter().any(negative) {
            return Err(wrong("a load must be zero or greater"));
        }
        if !stations.iter().all(|station| station.is_like(&stations[0])) {
            return Err(wrong(
                "all lines must give the same of load or approach, displacement or force",
            ));
        }
        Ok(Self { times, stations, increments: 1, cycles: Cycles::default() })
    }

    /// The same with that number of increments from each time to the next.
    #[must_use]
    pub fn increments(self, increments: usize) -> Self {
        Self { increments, ..self }
    }

    /// The same in cycles.
    #[must_use]
    pub fn cycles(self, cycles: Cycles) -> Self {
        Self { cycles, ..self }
    }

    /// The motion it makes.
    ///
    /// # Errors
    /// If there are no increments or too many of them, or the cycles are none to compute with.
    pub fn plan(self) -> Result<Planned, Invalid> {
        let all = counted(COUNT, self.increments)? as f64 * self.times.len() as f64;
        if all > MOST_INCREMENTS {
            let message = format!(
                "makes {all:.1e} increments of the lines of the file, {MOST_INCREMENTS} at most can be kept"
            );
            return Err(Invalid::new("increments", message));
        }
        let shift = self.shift();
        let (cycles, stepping) = self.cycles.divided(shift.period() / shift.cycle.len() as f64)?;
        let control = shift.cycle[shift.peak()].control;
        let schedule = Schedule::steady(control, cycles * shift.period(), stepping);
        let motion = Motion::cycle_of(shift, Progress::TIME);
        Ok((motion, Schedule { ramped: true, ..schedule }))
    }

    /// The lines and as many stations between them as makes that many increments.
    fn shift(&self) -> Shift {
        let increments = self.increments;
        let (mut cycle, mut places) = (vec![], vec![]);
        for line in 1..self.times.len() {
            for step in 1..=increments {
                let share = step as f64 / increments as f64;
                let between = |before: f64, after: f64| {
                    if step == increments { after } else { before + share * (after - before) }
                };
                cycle.push(blend(self.stations[line - 1], self.stations[line], between));
                places.push(between(self.times[line - 1], self.times[line]));
            }
        }
        let first = self.stations[0];
        let rests = first == first.share(0.0);
        let lead = if rests { vec![] } else { first.lead(LEAD) };
        Shift { lead, cycle, places, released: false, end_pressure: false }
    }
}

/// Increments of each part of the way from rest to a first line that is not at rest.
const LEAD: usize = 20;

/// The path of the columns of a file.
fn read(columns: &[(String, Vec<f64>)]) -> Result<Path, Invalid> {
    let columns = Columns::known(columns, COLUMNS)?;
    let times = columns.need("time", "time_s")?;
    let controls = columns.controls()?;
    let guided = [columns.either(["shift_x", "force_x"])?, columns.either(["shift_y", "force_y"])?];
    let guide = |line: usize, [shift, force]: [Option<&[f64]>; 2]| match force {
        Some(force) => Drive::Force(force[line]),
        None => Drive::Slip(shift.map_or(0.0, |shift| shift[line])),
    };
    let station = |(line, &time): (usize, &f64)| {
        (time, Station { control: controls[line], guides: guided.map(|one| guide(line, one)) })
    };
    Path::new(&times.iter().enumerate().map(station).collect::<Vec<_>>())
}

/// A station between two of the same kind.
fn blend(before: Station, after: Station, between: impl Fn(f64, f64) -> f64) -> Station {
    let control = match (before.control, after.control) {
        (Control::Load(one), Control::Load(other)) => Control::Load(between(one, other)),
        (Control::Approach(one), Control::Approach(other)) => {
            Control::Approach(between(one, other))
        }
        (_, other) => other,
    };
    let guide = |axis: usize| match (before.guides[axis], after.guides[axis]) {
        (Drive::Slip(one), Drive::Slip(other)) => Drive::Slip(between(one, other)),
        (Drive::Force(one), Drive::Force(other)) => Drive::Force(between(one, other)),
        (_, other) => other,
    };
    Station { control, guides: [guide(0), guide(1)] }
}

#[cfg(test)]
mod tests {
    use super::{Control, Drive, Path};
    use crate::parameters::Invalid;

    fn read(columns: &[(&str, &[f64])]) -> Result<Path, Invalid> {
        let owned: Vec<(String, Vec<f64>)> =
            columns.iter().map(|(name, values)| ((*name).to_owned(), values.to_vec())).collect();
        super::read(&owned)
    }

    #[test]
    fn increments_lie_between_lines() {
        let path = read(&[
            ("time", &[0.0, 1.0, 3.0]),
            ("load", &[0.0, 10.0, 10.0]),
            ("force_x", &[0.0, 0.0, 4.0]),
        ]);
        let shift = path.unwrap().increments(2).shift();
        assert_eq!(shift.places, [0.5, 1.0, 2.0, 3.0]);
        assert_eq!(shift.cycle[0].control, Control::Load(5.0));
        assert_eq!(shift.cycle[2].guides, [Drive::Force(2.0), Drive::Slip(0.0)]);
        assert!(shift.lead.is_empty());
    }

    #[test]
    fn wrong_columns_are_named() {
        let error = |columns: &[(&str, &[f64])]| read(columns).expect_err("a mistake").message;
        let rising: (&str, &[f64]) = ("time", &[0.0, 1.0]);
        let load: (&str, &[f64]) = ("load", &[1.0, 1.0]);
        assert!(error(&[rising, load, ("speed", &[1.0, 1.0])]).contains("`speed` is not known"));
        assert!(error(&[rising]).contains("`load_N`"));
        assert!(error(&[load]).contains("`time_s` is missing"));
        assert!(error(&[("time", &[0.0, 0.0]), load]).contains("rise"));
        assert!(error(&[("time", &[0.0, 5e-324]), load]).contains("rise"));
        assert!(error(&[rising, load, ("approach", &[1.0, 1.0])]).contains("exclude"));
        assert!(error(&[rising, ("load", &[1.0, -1.0])]).contains("zero or greater"));
    }
}
