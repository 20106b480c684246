//! Readings that are whole surfaces: profiles and height maps in files that a table names, and what is worn off in them.

use std::fmt;
use std::path::Path;

use serde_json::{Value, json};

use super::Error;
use super::quantity::{Kind, Quantity};
use archard::body::profile::Profile;
use archard_case::Case;
use archard_case::files::{self, Contents};
use archard_case::measured::Table;
use archard_case::measured::surface::{Scar, Surface, Unworn};
use archard_case::verdict::four;

/// The name of the column.
pub(super) const COLUMN: &str = "file";

/// Where the files are that a table names, and how their columns are titled.
#[derive(Debug, Clone, Copy)]
pub struct Files<'a> {
    /// The folder that paths start from.
    pub folder: &'a Path,
    /// Names (`x`, `y`, `z`) with the titles of the columns meant.
    pub columns: &'a [(&'a str, &'a str)],
}

/// What came of a file.
#[derive(Debug, Clone, PartialEq)]
pub struct Measured {
    /// The line of the table that names it.
    pub line: u64,
    /// The file, as the table has it.
    pub file: String,
    /// What was taken from it: the name of the quantity, a factor from SI to the unit shown, and that unit.
    pub quantity: (String, f64, &'static str),
    /// What the file tells, a volume or a section, and of which body.
    kind: Kind,
    body: String,
    /// The scar.
    pub scar: Scar,
}

/// Readings by rows of a table, with their standard uncertainties where they have any: SI.
pub(super) struct Column {
    pub quantity: Quantity,
    pub values: Vec<Option<f64>>,
    pub uncertainties: Option<Vec<Option<f64>>>,
}

/// What is worn off a body in the files that a column names: a column for each quantity that they tell.
pub(super) fn read(
    (table, name): (&Table, &str),
    (case, body): (&Case, usize),
    files: Files<'_>,
) -> Result<(Vec<Column>, Vec<Measured>), Error> {
    let shape = Shape::of(case, body)?;
    let (mut columns, mut all): (Vec<Column>, Vec<Measured>) = (vec![], vec![]);
    let texts = table.texts(name).unwrap_or_default();
    for (row, (file, line)) in texts.iter().zip(table.lines()).enumerate() {
        if file.is_empty() {
            continue;
        }
        let refuse = |why: String| Error::Reading {
            table: table.source().to_owned(),
            line,
            why: format!("`{file}`: {why}"),
        };
        let bytes = files::read(&files.folder.join(file), Contents::Text)
            .map_err(|error| refuse(format!("cannot read it: {error}")))?;
        // These errors begin with the name of the file.
        let unread = |why: String| Error::Reading { table: table.source().to_owned(), line, why };
        let surface = match Surface::of_file(file, &bytes, files::free_memory()) {
            Some(surface) => surface.map_err(|error| unread(error.to_string()))?,
            None => in_a_table((file, &bytes), files.columns).map_err(unread)?,
        };
        let kind = shape.kind(surface.axis()).map_err(refuse)?;
        let scar = shape.scar(&surface).map_err(|error| refuse(error.to_string()))?;
        let quantity = Quantity { name: shape.name(kind, name), kind, body };
        let place = columns.iter().position(|own| own.quantity == quantity).unwrap_or_else(|| {
            let none = vec![None; table.len()];
            let (values, uncertainties) = (none.clone(), Some(none));
            columns.push(Column { quantity: quantity.clone(), values, uncertainties });
            columns.len() - 1
        });
        columns[place].values[row] = Some(scar.worn);
        if let Some(all) = &mut columns[place].uncertainties {
            all[row] = Some(scar.uncertainty);
        }
        let (factor, unit) = kind.shown();
        let quantity = (quantity.name, factor, unit);
        all.push(Measured {
            line,
            file: (*file).to_owned(),
            quantity,
            kind,
            body: shape.body.to_owned(),
            scar,
        });
    }
    Ok((columns, all))
}

/// The surface in a table, whose columns have other titles.
fn in_a_table((file, bytes): (&str, &[u8]), columns: &[(&str, &str)]) -> Result<Surface, String> {
    let table = Table::read(file, bytes).map_err(|error| error.to_string())?;
    // A profile along one axis has no place along the other.
    let there = |(name, title): &&(&str, &str)| table.has(title) || name.starts_with(['z', 'Z']);
    let names: Vec<_> = columns.iter().filter(there).copied().collect();
    let table = table.naming(&names).map_err(|error| error.to_string())?;
    Surface::of(&table).map_err(|error| error.to_string())
}

/// Refuses a key of the shape that surfaces were levelled by: runs with another value would be held against sections and
/// volumes taken with this one.
pub(super) fn refuse_shape(surfaces: &[Measured], key: &str) -> Result<(), Error> {
    let own = |of: &&Measured| key.starts_with(&format!("body.{}.profile.", of.body));
    match surfaces.iter().find(own) {
        None => Ok(()),
        Some(Measured { file, .. }) => Err(Error::Mismatch(format!(
            "`{key}` is of the shape that `{file}` was levelled by, and what was taken from the file goes by it: put the other \
             value into the case, fit again, and see by how much the coefficient changes"
        ))),
    }
}

/// The shape of a body before it wears, and how its scar lies.
struct Shape<'a> {
    body: &'a str,
    profile: Box<dyn Profile>,
    /// The axis along which it passes.
    passes: Option<usize>,
}

impl<'a> Shape<'a> {
    fn of(case: &'a Case, body: usize) -> Result<Self, Error> {
        let own = &case.bodies[body];
        let wrong = |why: String| Error::Mismatch(why);
        if own.finite.is_some() {
            return Err(wrong(format!(
                "`{}` is meshed: profiles and maps are levelled by the shape of a body that is a profile; give `volume` or \
                 `depth`",
                own.name
            )));
        }
        let profile = own.profile.build().map_err(|error| wrong(error.to_string()))?;
        let (motion, _) = case.motion.build().map_err(|error| wrong(error.to_string()))?;
        let along = motion.grooves().filter(|(_, bodies)| bodies[body]);
        Ok(Self { body: &own.name, profile, passes: along.map(|(along, _)| along.axis) })
    }

    /// What a surface tells: a profile (its axis) or a map.
    fn kind(&self, axis: Option<usize>) -> Result<Kind, String> {
        match (axis, self.passes) {
            (Some(axis), Some(passes)) if axis == passes => Err(format!(
                "`{}` passes along {}, and its track is as deep all along: a profile across it goes along {}; if this is one, \
                 title its places so",
                self.body,
                ["x", "y"][axis],
                ["y", "x"][axis]
            )),
            (_, Some(_)) => Ok(Kind::Section),
            (Some(axis), None) => Ok(Kind::Middle(axis)),
            (None, None) => Ok(Kind::Volume),
        }
    }

    fn scar(&self, surface: &Surface) -> Result<Scar, archard_case::measured::surface::NoScar> {
        let height = |[x, y]: [f64; 2]| -self.profile.recess(x, y);
        Scar::find(surface, Unworn::passing(&height, self.passes))
    }

    /// `file_disc` tells `profile_y_disc`, `track_section_disc` or `map_volume_disc`.
    fn name(&self, kind: Kind, column: &str) -> String {
        let of = match kind {
            Kind::Middle(axis) => ["profile_x", "profile_y"][axis],
            Kind::Section => "track_section",
            _ => "map_volume",
        };
        column.replacen(COLUMN, of, 1)
    }
}

impl Measured {
    /// As `fit.json` has it: SI.
    pub fn json(&self) -> Value {
        let Scar { plane, middle, extent, worn, uncertainty, deepest, angle, gaps } = &self.scar;
        let unit = match self.kind {
            Kind::Volume => "m3",
            _ => "m2",
        };
        json!({
            "line": self.line, "file": self.file, "quantity": self.quantity.0, format!("worn_{unit}"): worn,
            format!("uncertainty_{unit}"): uncertainty, "deepest_m": deepest, "from_to_m": extent, "middle_m": middle,
            "angle_rad": angle, "tilt": plane.tilt, "offset_m": plane.offset, "readings_beside": plane.used,
            "scatter_m": plane.scatter, "gaps": gaps,
        })
    }
}

/// In words.
impl fmt::Display for Measured {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Scar { plane, middle, worn, uncertainty, deepest, angle, gaps, .. } = &self.scar;
        let (name, factor, unit) = &self.quantity;
        let [x, y] = plane.tilt.map(|tilt| four(1e3 * tilt));
        write!(
            f,
            "`{}`: {name} {} {unit} +- {:.1} %, {} um deep around ({}, {}) mm; tilt ({x}, {y}) um/mm and offset {} um taken \
             off by {} readings beside it, which scatter by {} um",
            self.file,
            four(worn * factor),
            100.0 * uncertainty / worn,
            four(1e6 * deepest),
            four(1e3 * middle[0]),
            four(1e3 * middle[1]),
            four(1e6 * plane.offset),
            plane.used,
            four(1e6 * plane.scatter),
        )?;
        if *angle != 0.0 {
            let degrees = four(angle.to_degrees());
            write!(
                f,
                "; the track lies askew in its map by {degrees} degrees, and its section is that square to it"
            )?;
        }
        if *gaps > 0 {
            write!(f, "; {gaps} places in it have no reading, or one far off those around it")?;
        }
        Ok(())
    }
}
