//! The files of a result folder, read back.

use std::fs;
use std::path::Path;

use anyhow::{Context, bail, ensure};
use archard::closed_form::Hertz;
use archard::output::Image;
use serde_json::Value;

/// What a result folder holds.
pub(super) struct Results {
    /// A value a step and column.
    pub(super) history: Table,
    /// The sections of all outputs, in the order of time.
    pub(super) profiles: Vec<Profile>,
    /// The fields of the last output, if there is one.
    pub(super) image: Option<Image>,
    /// The names of the bodies; body 1 first.
    pub(super) bodies: Vec<String>,
    /// What closed forms start from; null until a run has ended.
    closed_form: Value,
}

/// An axis of the frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Axis {
    /// Along x.
    X,
    /// Along y.
    Y,
}

impl Axis {
    /// As the files and the pictures call it.
    pub(super) fn name(self) -> &'static str {
        match self {
            Axis::X => "x",
            Axis::Y => "y",
        }
    }

    /// Its place in arrays.
    pub(super) fn index(self) -> usize {
        match self {
            Axis::X => 0,
            Axis::Y => 1,
        }
    }
}

/// Numbers by column.
#[derive(Debug, Default)]
pub(super) struct Table {
    columns: Vec<(String, Vec<f64>)>,
}

/// The sections of one output along one axis.
#[derive(Debug)]
pub(super) struct Profile {
    /// Progress of the output (SI).
    pub(super) progress: f64,
    /// Along which axis.
    pub(super) axis: Axis,
    /// `coordinate_m` and the fields.
    pub(super) table: Table,
}

/// A sphere worn on a flat, as eq. 55 takes it.
pub(super) struct WornSphere {
    /// Radius (m).
    pub(super) radius: f64,
    /// Wear coefficient of both bodies together (1/Pa).
    pub(super) coefficient: f64,
}

impl Results {
    /// Reads a result folder.
    pub(super) fn read(dir: &Path) -> anyhow::Result<Self> {
        let history = dir.join("history.csv");
        ensure!(
            history.is_file(),
            "`{}` is not a result folder: it has no history.csv",
            dir.display()
        );
        let history = read_history(&history)?;
        if history.rows() == 0 {
            bail!("`{}` has no results yet: its history.csv has no rows", dir.display());
        }
        let profiles = dir.join("profiles.csv");
        let summary = dir.join("summary.json");
        Ok(Self {
            bodies: history.bodies(),
            profiles: if profiles.is_file() { read_profiles(&profiles)? } else { Vec::new() },
            image: last_image(dir)?,
            closed_form: if summary.is_file() { closed_form(&summary)? } else { Value::Null },
            history,
        })
    }

    /// Whether any body has worn.
    pub(super) fn wears(&self) -> bool {
        self.history.column("wear_depth_m").is_ok_and(|depths| largest(depths) > 0.0)
    }

    /// The column that measures how far the motion has gone.
    pub(super) fn progress(&self) -> (&str, &[f64]) {
        self.history.columns.first().map_or(("", &[]), |(name, values)| (name, values))
    }

    /// Whether body 2 has worn.
    pub(super) fn worn_below(&self) -> bool {
        let column = self.bodies.get(1).map(|body| format!("wear_depth_{body}_m"));
        column
            .and_then(|name| self.history.column(&name).ok())
            .is_some_and(|depths| largest(depths) > 0.0)
    }

    /// The outputs to show along an axis: at most `count`, spread over the run with its first and
    /// last, without those before the bodies touch.
    pub(super) fn sections(&self, axis: Axis, count: usize) -> Vec<&Profile> {
        let touches = |profile: &Profile| {
            profile.table.column("pressure_Pa").is_ok_and(|values| largest(values) > 0.0)
        };
        let all: Vec<&Profile> = self
            .profiles
            .iter()
            .filter(|profile| profile.axis == axis && touches(profile))
            .collect();
        let shown = all.len().min(count);
        (0..shown).map(|i| all[i * (all.len() - 1) / (shown - 1).max(1)]).collect()
    }

    /// How far (m) from the centre pictures need to reach along an axis: a quarter beyond the widest
    /// contact of any output, within the frame.
    pub(super) fn window(&self, axis: Axis) -> anyhow::Result<f64> {
        let (mut contact, mut frame) = (0.0_f64, 0.0_f64);
        for profile in self.profiles.iter().filter(|profile| profile.axis == axis) {
            let places = profile.table.column("coordinate_m")?;
            let pressures = profile.table.column("pressure_Pa")?;
            for (place, pressure) in places.iter().zip(pressures) {
                frame = frame.max(place.abs());
                if *pressure > 0.0 {
                    contact = contact.max(place.abs());
                }
            }
        }
        Ok(if contact > 0.0 { frame.min(1.25 * contact) } else { frame })
    }

    /// The Hertz contact of the unworn bodies under a load (N), where they have one.
    pub(super) fn hertz(&self, load: f64) -> Option<Hertz> {
        let curvature = |axis: usize| self.closed_form["curvatures_per_m"][axis].as_f64();
        let modulus = self.closed_form["contact_modulus_Pa"].as_f64()?;
        Hertz::from_load([curvature(0)?, curvature(1)?], modulus, load)
    }

    /// The worn sphere of eq. 55, where the run was one.
    pub(super) fn worn_sphere(&self) -> Option<WornSphere> {
        let block = &self.closed_form["pin_on_disc"];
        Some(WornSphere {
            radius: block["radius_m"].as_f64()?,
            coefficient: block["coefficient_per_Pa"].as_f64()?,
        })
    }
}

impl Table {
    /// The values of a column.
    pub(super) fn column(&self, name: &str) -> anyhow::Result<&[f64]> {
        let column = self.columns.iter().find(|(known, _)| known == name);
        column.map(|(_, values)| &**values).with_context(|| format!("there is no column `{name}`"))
    }

    /// Number of rows.
    fn rows(&self) -> usize {
        self.columns.first().map_or(0, |(_, values)| values.len())
    }

    /// The names of the bodies, out of the columns named after them.
    fn bodies(&self) -> Vec<String> {
        self.columns
            .iter()
            .filter_map(|(name, _)| name.strip_prefix("worn_volume_")?.strip_suffix("_m3"))
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
pub(super) fn largest(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::NEG_INFINITY, f64::max)
}

/// Reads a CSV file row by row, as cells under their columns' names.
fn read_rows(
    path: &Path,
    mut take: impl FnMut(&[(&str, &str)]) -> anyhow::Result<()>,
) -> anyhow::Result<()> {
    let context = || format!("cannot read `{}`", path.display());
    let mut reader = csv::Reader::from_path(path).with_context(context)?;
    let header = reader.headers().with_context(context)?.clone();
    for record in reader.records() {
        let record = record.with_context(context)?;
        let cells: Vec<_> = header.iter().zip(record.iter()).collect();
        take(&cells).with_context(context)?;
    }
    Ok(())
}

/// A cell as a number; an empty one is none.
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
fn read_history(path: &Path) -> anyhow::Result<Table> {
    let mut table = Table::default();
    read_rows(path, |cells| {
        table.push(numbers(cells)?.into_iter());
        Ok(())
    })?;
    Ok(table)
}

/// The sections of a run: rows of the same progress and axis belong together.
fn read_profiles(path: &Path) -> anyhow::Result<Vec<Profile>> {
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

/// The last output that the collection lists.
fn last_image(dir: &Path) -> anyhow::Result<Option<Image>> {
    let path = dir.join("fields.pvd");
    if !path.is_file() {
        return Ok(None);
    }
    let text =
        fs::read_to_string(&path).with_context(|| format!("cannot read `{}`", path.display()))?;
    let last = text.rsplit_once("file=\"").and_then(|(_, rest)| rest.split_once('"'));
    Ok(last.map(|(name, _)| Image::read(&dir.join(name))).transpose()?)
}

/// The block of closed forms in a summary.
fn closed_form(path: &Path) -> anyhow::Result<Value> {
    let context = || format!("cannot read `{}`", path.display());
    let text = fs::read_to_string(path).with_context(context)?;
    let mut summary: Value = serde_json::from_str(&text).with_context(context)?;
    Ok(summary["closed_form"].take())
}
