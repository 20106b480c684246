//! The tables of a result folder, read back.

use std::path::Path;

use anyhow::{Context, bail};
use archard::numerics::WRITTEN;
use archard::simulation::history::{BODY_DEPTH, body_of};
use archard_case::files::{self, Contents};

/// An axis of the frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Axis {
    /// Along x.
    X,
    /// Along y.
    Y,
}

impl Axis {
    /// The one across.
    pub(crate) fn other(self) -> Self {
        match self {
            Axis::X => Axis::Y,
            Axis::Y => Axis::X,
        }
    }

    /// As the files and the pictures call it.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Axis::X => "x",
            Axis::Y => "y",
        }
    }

    /// Its place in arrays.
    pub(crate) fn index(self) -> usize {
        match self {
            Axis::X => 0,
            Axis::Y => 1,
        }
    }
}

/// Numbers by column.
#[derive(Debug, Default)]
pub(crate) struct Table {
    columns: Vec<(String, Vec<f64>)>,
}

/// The sections of one output along one axis.
#[derive(Debug)]
pub(crate) struct Profile {
    /// Progress of the output (SI).
    pub(crate) progress: f64,
    /// Along which axis.
    pub(crate) axis: Axis,
    /// `coordinate_m` and the fields.
    pub(crate) table: Table,
}

impl Profile {
    /// The highest pressure (Pa).
    pub(crate) fn peak(&self) -> anyhow::Result<f64> {
        Ok(largest(self.table.column("pressure_Pa")?))
    }
}

impl Table {
    /// The values of a column.
    pub(crate) fn column(&self, name: &str) -> anyhow::Result<&[f64]> {
        let column = self.columns.iter().find(|(known, _)| known == name);
        column.map(|(_, values)| &**values).with_context(|| format!("there is no column `{name}`"))
    }

    /// The names of all columns.
    pub(crate) fn names(&self) -> impl Iterator<Item = &str> {
        self.columns.iter().map(|(name, _)| &**name)
    }

    /// The first column with its name.
    pub(crate) fn first(&self) -> (&str, &[f64]) {
        self.columns.first().map_or(("", &[]), |(name, values)| (name, values))
    }

    /// Number of rows.
    pub(crate) fn rows(&self) -> usize {
        self.columns.first().map_or(0, |(_, values)| values.len())
    }

    /// The names of the bodies, out of the columns named after them.
    pub(crate) fn bodies(&self) -> Vec<String> {
        self.columns
            .iter()
            .filter_map(|(name, _)| body_of(BODY_DEPTH, name))
            .map(str::to_owned)
            .collect()
    }

    /// Adds a row below columns of the same names.
    fn push<'a>(&mut self, cells: impl Iterator<Item = (&'a str, f64)>) {
        for (place, (name, value)) in cells.enumerate() {
            if place == self.columns.len() {
                self.columns.push((name.to_owned(), Vec::new()));
            }
            self.columns[place].1.push(value);
        }
    }
}

/// Largest value that is a number.
pub(crate) fn largest(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::NEG_INFINITY, f64::max)
}

/// Largest value regardless of its sign, zero at least.
pub(crate) fn size(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, value| most.max(value.abs()))
}

/// Reads a CSV file row by row, as cells under their columns' names.
fn read_rows(
    path: &Path,
    mut take: impl FnMut(&[(&str, &str)]) -> anyhow::Result<()>,
) -> anyhow::Result<()> {
    let context = || format!("cannot read `{}`", path.display());
    let mut text = files::read(path, Contents::Text).with_context(context)?;
    // A run that is under way, or was killed, may leave half a row at the end.
    text.truncate(text.iter().rposition(|&byte| byte == b'\n').map_or(0, |end| end + 1));
    let mut reader = csv::Reader::from_reader(&text[..]);
    let header = reader.headers().with_context(context)?.clone();
    for record in reader.records() {
        let record = record.with_context(context)?;
        let cells: Vec<_> = header.iter().zip(record.iter()).collect();
        take(&cells).with_context(context)?;
    }
    Ok(())
}

/// A cell as a number; an empty one is not a number.
fn number(cell: &str) -> anyhow::Result<f64> {
    if cell.is_empty() {
        return Ok(f64::NAN);
    }
    cell.parse().with_context(|| format!("`{cell}` is not a number"))
}

/// Numbers out of cells.
fn numbers<'a>(cells: &[(&'a str, &str)]) -> anyhow::Result<Vec<(&'a str, f64)>> {
    cells.iter().map(|(name, cell)| Ok((*name, number(cell)?))).collect()
}

/// The history of a run.
pub(crate) fn read_history(path: &Path) -> anyhow::Result<Table> {
    let mut table = Table::default();
    read_rows(path, |cells| {
        table.push(numbers(cells)?.into_iter());
        Ok(())
    })?;
    Ok(table)
}

/// The sections of a run: rows of the same progress and axis belong together.
pub(crate) fn read_profiles(path: &Path) -> anyhow::Result<Vec<Profile>> {
    let mut profiles: Vec<Profile> = Vec::new();
    read_rows(path, |cells| {
        let [(_, progress), (_, axis), fields @ ..] = cells else {
            bail!("a row has fewer than two cells");
        };
        let (progress, axis) = (number(progress)?, if *axis == "x" { Axis::X } else { Axis::Y });
        if profiles.last().is_none_or(|last| last.progress != progress || last.axis != axis) {
            profiles.push(Profile { progress, axis, table: Table::default() });
        }
        if let Some(profile) = profiles.last_mut() {
            profile.table.push(numbers(fields)?.into_iter());
        }
        Ok(())
    })?;
    Ok(profiles)
}

/// The rows of each output of a run, whose first column is the progress.
pub(crate) fn read_outputs(path: &Path) -> anyhow::Result<Vec<Table>> {
    let mut outputs: Vec<(f64, Table)> = Vec::new();
    read_rows(path, |cells| {
        let cells = numbers(cells)?;
        let progress = cells.first().map_or(0.0, |cell| cell.1);
        if outputs.last().is_none_or(|last| last.0 != progress) {
            outputs.push((progress, Table::default()));
        }
        if let Some((_, table)) = outputs.last_mut() {
            table.push(cells.into_iter());
        }
        Ok(())
    })?;
    Ok(outputs.into_iter().map(|(_, table)| table).collect())
}

/// The loops of force over shift, one a cycle.
pub(crate) fn read_loops(path: &Path) -> anyhow::Result<Vec<Table>> {
    let mut loops: Vec<Table> = Vec::new();
    let mut before = 0.0_f64;
    read_rows(path, |cells| {
        let cells = numbers(cells)?;
        let cycle = cells.first().map_or(0.0, |cell| cell.1);
        // A loop ends with a whole cycle; the next may begin with the same one.
        let whole = (before - before.round()).abs() < WRITTEN;
        let begins = whole && loops.last().is_some_and(|last| last.rows() > 1);
        if loops.is_empty() || begins {
            loops.push(Table::default());
        }
        before = cycle;
        if let Some(table) = loops.last_mut() {
            table.push(cells.into_iter());
        }
        Ok(())
    })?;
    Ok(loops)
}

/// The last of the transverse profiles of a run.
pub(crate) fn last_profile(path: &Path) -> anyhow::Result<Option<Profile>> {
    let mut last: Option<Profile> = None;
    read_rows(path, |cells| {
        let [(_, progress), (across, place), heights @ ..] = cells else {
            bail!("a row has fewer than two cells");
        };
        let (progress, axis) =
            (number(progress)?, if *across == "x_m" { Axis::X } else { Axis::Y });
        if last.as_ref().is_none_or(|last| last.progress != progress) {
            last = Some(Profile { progress, axis, table: Table::default() });
        }
        if let Some(profile) = &mut last {
            let place = ("coordinate_m", number(place)?);
            profile.table.push([place].into_iter().chain(numbers(heights)?));
        }
        Ok(())
    })?;
    Ok(last)
}
