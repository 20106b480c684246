//! Stations that a table gives, gone through in cycles: where the contact lies on each surface, under which load, for how long.
//!
//! The frame lies at the contact. On each body the contact goes where the *offsets* say, in the body's own coordinates: the surface of a
//! body whose offset changes moves under the frame by the same length the other way. Body 2 then slides over body 1 by the
//! difference, and all of the contact slides. The shapes of the bodies stay as the frame sees them (a sphere that rolls away from its
//! pole is still a sphere); what is worn belongs to the place on the body.
//!
//! Stations are joined by straight lines, gone through at one speed each, and the last one by the first. Velocities follow from the
//! offsets: given as well, they say whether units and signs are those that were meant.

use super::columns::{Columns, wrong};
use super::merged::{StationLoss, Within, merged};
use super::shift::{CYCLE_COUNT, Cycles, JUMP, JUMP_TOLERANCE};
use super::{
    Control, Lever, MOST_INCREMENTS, Motion, Passage, Planned, Progress, Schedule, Sequence, Slip,
    Stepping, pressing,
};
use crate::frame::Direction;
use crate::parameters::{Choice, Invalid, Parameter, Quantity};

pub(super) const CHOICE: Choice<Planned> = Choice {
    name: "table",
    meaning: "stations from a file, in cycles: load, and where the contact lies on each body, both of which may move in two directions",
    parameters: &[
        Parameter::required(
            "file",
            Quantity::Table(COLUMNS),
            "CSV with columns duration_s, load_N or approach_um, and offset_one_x_mm and the same of y and of body two where they are not zero",
        ),
        WITHIN,
        APART_AT_MOST,
        CYCLE_COUNT,
        JUMP,
        JUMP_TOLERANCE,
    ],
    build: |values| {
        let rows = read(values.table("file").unwrap_or_default())?;
        let table = match (values.number("within"), values.number("apart")) {
            (Some(share), Some(way)) => Table::merging(&rows, Within { share, way })?,
            (None, None) => Table::new(rows)?,
            (Some(_), None) => {
                let message = "how far the contact may move over a body from a station to the next: a part of the size of the contact";
                return Err(Invalid::new("apart", message).beside("within"));
            }
            (None, Some(_)) => {
                let message = "what loads and the distance slid may be off where stations are left out, as 0.01";
                return Err(Invalid::new("within", message).beside("apart"));
            }
        };
        table.over(Cycles::read(values)?)
    },
};

const WITHIN: Parameter = Parameter::optional(
    "within",
    Quantity::Number,
    "for long tables: stations are left out where loads and the distance slid are off by less than that, relative to them, as 0.01",
);
const APART_AT_MOST: Parameter = Parameter::optional(
    "apart",
    Quantity::Length,
    "and where the contact moves over no body by more than that from a station to the next: a part of the size of the contact",
);

/// The columns that a table may have.
const COLUMNS: &[(&str, Quantity)] = &[
    ("duration", Quantity::Time),
    ("load", Quantity::Force),
    ("approach", Quantity::Length),
    ("offset_one_x", Quantity::Length),
    ("offset_one_y", Quantity::Length),
    ("offset_two_x", Quantity::Length),
    ("offset_two_y", Quantity::Length),
    ("velocity_one_x", Quantity::Speed),
    ("velocity_one_y", Quantity::Speed),
    ("velocity_two_x", Quantity::Speed),
    ("velocity_two_y", Quantity::Speed),
    ("turn_one", Quantity::Angle),
    ("turn_two", Quantity::Angle),
];

/// The columns of offsets and of velocities, of both bodies along x and y.
const OFFSETS: [[&str; 2]; 2] =
    [["offset_one_x", "offset_one_y"], ["offset_two_x", "offset_two_y"]];
const VELOCITIES: [[&str; 2]; 2] =
    [["velocity_one_x", "velocity_one_y"], ["velocity_two_x", "velocity_two_y"]];

/// What bodies are called in the columns.
const BODIES: [&str; 2] = ["one", "two"];

/// How far the way by the velocities may be from that by the offsets, over the length of the way: what tables are rounded to.
const APART: f64 = 0.01;

/// A station of a table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// Time (s) to the next station.
    pub duration: f64,
    /// Load or approach.
    pub control: Control,
    /// Where the middle of the frame lies on body 1 and on body 2 (m), along x and y of the body.
    pub offsets: [[f64; 2]; 2],
}

/// Stations, one after the other, the first after the last.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    rows: Vec<Row>,
    merged: Option<StationLoss>,
}

impl Table {
    /// Of stations.
    ///
    /// # Errors
    /// If there are fewer than two or far too many, a value is not finite, a time or a load is not greater than zero, it changes whether
    /// a load or an approach is given, or no body slides on the other.
    pub fn new(rows: Vec<Row>) -> Result<Self, Invalid> {
        if rows.len() < 2 || rows.len() as f64 > MOST_INCREMENTS {
            let count = rows.len();
            return Err(wrong(format!(
                "has {count} stations: from 2 to {MOST_INCREMENTS} can be gone through"
            )));
        }
        rows.iter().enumerate().try_for_each(|(index, row)| checked(index, row, &rows[0]))?;
        let table = Self { rows, merged: None };
        if table.way() > 0.0 {
            return Ok(table);
        }
        Err(wrong(
            "no body slides on the other: the offsets of both change by the same, or not at all",
        ))
    }

    /// Of as few of many stations as a tolerance takes.
    ///
    /// # Errors
    /// As [`Table::new`], or if a tolerance is not one.
    pub fn merging(rows: &[Row], within: Within) -> Result<Self, Invalid> {
        // All of them, however many, have to be stations.
        rows.iter().enumerate().try_for_each(|(index, row)| checked(index, row, &rows[0]))?;
        let (kept, merged) = merged(rows, within)?;
        Ok(Self { merged: Some(merged), ..Self::new(kept)? })
    }

    /// What it has lost of the stations it was made of, where some were left out.
    pub fn merged(&self) -> Option<StationLoss> {
        self.merged
    }

    /// The motion that it makes, in cycles.
    ///
    /// # Errors
    /// If there are no cycles to compute.
    pub fn over(self, cycles: Cycles) -> Result<Planned, Invalid> {
        let (extent, stepping) = cycles.divided(1.0)?;
        let stepping = match stepping {
            Stepping::Jumps(cycles) => Stepping::Implicit(cycles as f64),
            other => other,
        };
        let schedule = Schedule::steady(self.rows[self.shown()].control, extent, stepping);
        let passage = |body| if self.moves(body) { Passage::Roams } else { Passage::Stays };
        let motion = Motion {
            progress: Progress::CYCLES,
            direction: Direction::X,
            surfaces: [0, 1].map(passage),
            slip: Slip::Given(self.way(), Lever::Even),
            speed: Some(self.way() / self.period()),
            sequence: Sequence::Table(self),
        };
        Ok((motion, schedule))
    }

    /// The stations.
    pub fn rows(&self) -> &[Row] {
        &self.rows
    }

    /// The station whose contact is shown: the first of those under the largest load, or approach.
    pub fn shown(&self) -> usize {
        let pressed = |index: usize| match self.rows[index].control {
            Control::Load(value) | Control::Approach(value) => value,
        };
        (1..self.rows.len())
            .fold(0, |most, row| if pressed(row) > pressed(most) { row } else { most })
    }

    /// Whether the contact moves over a body.
    pub fn moves(&self, body: usize) -> bool {
        self.rows.iter().any(|row| row.offsets[body] != self.rows[0].offsets[body])
    }

    /// Slip (m) of body 2 over body 1 from a station to the next.
    pub fn slip(&self, row: usize) -> [f64; 2] {
        let [here, next] = [row, row + 1].map(|row| &self.rows[row % self.rows.len()]);
        Self::slips(here, next)
    }

    /// The same from one station to another.
    pub(super) fn slips(here: &Row, next: &Row) -> [f64; 2] {
        let moved =
            |body: usize| [0, 1].map(|axis| next.offsets[body][axis] - here.offsets[body][axis]);
        let [one, two] = [moved(0), moved(1)];
        [one[0] - two[0], one[1] - two[1]]
    }

    /// Distance (m) slid in a cycle.
    pub fn way(&self) -> f64 {
        (0..self.rows.len()).map(|row| self.slip(row)).map(|[x, y]| x.hypot(y)).sum()
    }

    /// Time (s) of a cycle.
    pub fn period(&self) -> f64 {
        self.rows.iter().map(|row| row.duration).sum()
    }

    /// Least and largest offset (m) on a body along an axis.
    pub fn reach(&self, body: usize, axis: usize) -> [f64; 2] {
        let offsets = || self.rows.iter().map(|row| row.offsets[body][axis]);
        [offsets().fold(f64::INFINITY, f64::min), offsets().fold(f64::NEG_INFINITY, f64::max)]
    }
}

/// A station that can be gone through, numbered from 0; the first says whether loads or approaches are given.
fn checked(index: usize, row: &Row, first: &Row) -> Result<(), Invalid> {
    let [instant, _] = Quantity::Time.range();
    let at = |what: &str| wrong(format!("station {}: {what}", index + 1));
    if !row.offsets.iter().flatten().all(|offset| offset.is_finite()) {
        return Err(at("offsets must be finite"));
    }
    if !(row.duration.is_finite() && row.duration >= instant) {
        return Err(at("the duration must be greater than zero"));
    }
    pressing(row.control).map_err(|invalid| at(&invalid.message))?;
    if std::mem::discriminant(&row.control) != std::mem::discriminant(&first.control) {
        return Err(at("all stations must give a load, or all an approach"));
    }
    Ok(())
}

/// The stations in the columns of a file.
fn read(columns: &[(String, Vec<f64>)]) -> Result<Vec<Row>, Invalid> {
    let columns = Columns::known(columns, COLUMNS)?;
    let durations = columns.need("duration", "duration_s")?;
    let controls = columns.controls()?;
    let column = |name: &str| columns.get(name);
    for name in ["turn_one", "turn_two"] {
        let turns = column(name).unwrap_or_default();
        if turns.iter().any(|turn| *turn != turns[0]) {
            let message = format!(
                "`{name}` changes: bodies that turn about the normal are not followed by a table, which takes bodies that keep their direction"
            );
            return Err(wrong(message));
        }
    }
    let offset = |line: usize, name: &str| column(name).map_or(0.0, |offsets| offsets[line]);
    let row = |line: usize| Row {
        duration: durations[line],
        control: controls[line],
        offsets: OFFSETS.map(|body| body.map(|name| offset(line, name))),
    };
    let rows: Vec<Row> = (0..durations.len()).map(row).collect();
    for (body, names) in VELOCITIES.iter().enumerate() {
        for (axis, name) in names.iter().enumerate() {
            column(name).map_or(Ok(()), |given| agree(&rows, (body, axis), given))?;
        }
    }
    Ok(rows)
}

/// Whether the velocities (m/s) of a surface through the frame along an axis lead where its offsets do: a surface moves against its
/// offset.
fn agree(rows: &[Row], (body, axis): (usize, usize), velocities: &[f64]) -> Result<(), Invalid> {
    let next = |line: usize| (line + 1) % rows.len();
    let moved = |line: usize| rows[line].offsets[body][axis] - rows[next(line)].offsets[body][axis];
    let flown =
        |line: usize| 0.5 * (velocities[line] + velocities[next(line)]) * rows[line].duration;
    let way: f64 = (0..rows.len()).map(|line| moved(line).abs().max(flown(line).abs())).sum();
    let [name, offset] = [VELOCITIES[body][axis], OFFSETS[body][axis]];
    let (mut by_velocity, mut by_offset) = (0.0, 0.0);
    for line in 0..rows.len() {
        by_velocity += flown(line);
        by_offset += moved(line);
        if (by_velocity - by_offset).abs() > APART * way {
            let message = format!(
                "`{name}` contradicts `{offset}` at station {}: by the velocities the surface of body {} has come {:.4e} m from the first station, by the offsets {by_offset:.4e} m (it moves against its offset)",
                next(line) + 1,
                BODIES[body],
                by_velocity
            );
            return Err(wrong(message));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use approx::assert_relative_eq;

    use super::{Control, Row, Table, read};
    use crate::parameters::Invalid;

    /// A circle of 2 mm on body 2 in that many stations of a tenth of a second.
    fn circle(stations: usize) -> Vec<(String, Vec<f64>)> {
        let angle = |station: usize| TAU * station as f64 / stations as f64;
        let column = |name: &str, of: &dyn Fn(usize) -> f64| {
            (name.to_owned(), (0..stations).map(of).collect())
        };
        vec![
            column("duration", &|_| 0.1),
            column("load", &|station| 10.0 + station as f64),
            column("offset_two_x", &|station| 2e-3 * angle(station).cos()),
            column("offset_two_y", &|station| 2e-3 * angle(station).sin()),
        ]
    }

    fn message(columns: &[(String, Vec<f64>)]) -> String {
        let made = read(columns).and_then(Table::new);
        made.expect_err("a mistake").message
    }

    #[test]
    fn a_circle_slides_its_polygon() {
        let table = Table::new(read(&circle(36)).unwrap()).unwrap();
        let side = 4e-3 * (TAU / 72.0).sin();
        assert_relative_eq!(table.way(), 36.0 * side, max_relative = 1e-12);
        assert_relative_eq!(table.period(), 3.6, max_relative = 1e-12);
        assert_eq!((table.shown(), table.moves(0), table.moves(1)), (35, false, true));
        // Where the contact goes along y on body 2, this slides back over body 1.
        let [x, y] = table.slip(0);
        assert!(y < 0.0 && x > 0.0);
    }

    #[test]
    fn velocities_lead_where_offsets_do() {
        let stations = 36;
        let angle = |station: usize| TAU * station as f64 / stations as f64;
        let with = |sign: f64| {
            let mut columns = circle(stations);
            let speed = 2e-3 * TAU / 3.6;
            let velocities = (0..stations).map(|one| sign * speed * angle(one).sin()).collect();
            columns.push(("velocity_two_x".to_owned(), velocities));
            columns
        };
        assert!(read(&with(1.0)).is_ok());
        assert!(message(&with(-1.0)).contains("`velocity_two_x` contradicts `offset_two_x`"));
        assert!(message(&with(1e3)).contains("contradicts"));
    }

    /// Long tables, with all digits and with rounded ones, are held to their velocities as short ones are: a sign, a unit, an axis or a
    /// body that is another one shows, and rounding does not.
    #[test]
    fn velocities_of_long_tables_lead_where_offsets_do() {
        for stations in [1_000, 10_000, 100_000] {
            let time = 1.0 / stations as f64;
            let angle = |station: usize| TAU * station as f64 * time;
            let columns = |digits: i32, wrong: &dyn Fn(f64, f64) -> [f64; 2]| {
                let ten = 10f64.powi(digits);
                let rounded = |value: f64| (value * ten).round() / ten;
                let column = |name: &str, of: &dyn Fn(usize) -> f64| {
                    (name.to_owned(), (0..stations).map(|one| rounded(of(one))).collect())
                };
                let velocity = |axis: usize| {
                    move |one: usize| {
                        let (sin, cos) = angle(one).sin_cos();
                        wrong(2e-3 * TAU * sin, -2e-3 * TAU * cos)[axis]
                    }
                };
                vec![
                    ("duration".to_owned(), vec![time; stations]),
                    ("load".to_owned(), vec![10.0; stations]),
                    column("offset_two_x", &|one| 2e-3 * angle(one).cos()),
                    column("offset_two_y", &|one| 2e-3 * angle(one).sin()),
                    column("velocity_two_x", &velocity(0)),
                    column("velocity_two_y", &velocity(1)),
                ]
            };
            for digits in [6, 12] {
                assert!(read(&columns(digits, &|x, y| [x, y])).is_ok(), "{stations} {digits}");
                let wrongs: [&dyn Fn(f64, f64) -> [f64; 2]; 5] = [
                    &|x, y| [-x, y],
                    &|x, y| [x, -y],
                    &|x, y| [1e3 * x, 1e3 * y],
                    &|x, y| [y, x],
                    &|x, y| [1.05 * x, y],
                ];
                for (which, wrong) in wrongs.iter().enumerate() {
                    let told = message(&columns(digits, *wrong));
                    assert!(told.contains("contradicts"), "{stations} {digits} {which}: {told}");
                }
            }
        }
    }

    #[test]
    fn wrong_tables_are_told() {
        let changed = |name: &str, value: f64| {
            let mut columns = circle(8);
            let found = columns.iter_mut().find(|column| column.0 == name);
            found.expect("the column").1[3] = value;
            message(&columns)
        };
        assert!(changed("duration", 0.0).contains("station 4: the duration"));
        assert!(changed("load", 0.0).contains("station 4"));
        assert!(changed("offset_two_x", f64::NAN).contains("finite"));
        let without = |name: &str| {
            message(&circle(8).into_iter().filter(|column| column.0 != name).collect::<Vec<_>>())
        };
        assert!(without("duration").contains("`duration_s` is missing"));
        assert!(without("load").contains("`load_N`"));
        let still: Vec<_> = circle(8).into_iter().take(2).collect();
        assert!(message(&still).contains("no body slides"));
        let mut turned = circle(8);
        turned.push(("turn_two".to_owned(), (0..8).map(f64::from).collect()));
        assert!(message(&turned).contains("`turn_two` changes"));
        let row = Row { duration: 1.0, control: Control::Load(1.0), offsets: [[0.0; 2]; 2] };
        let made: Result<Table, Invalid> = Table::new(vec![row]);
        assert!(made.expect_err("one station").message.contains("1 stations"));
    }
}
