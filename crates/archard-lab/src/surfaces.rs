//! Readings that are whole surfaces: profiles and height maps in files that a table names, and what is worn off in them.

use std::fmt;
use std::path::Path;

use serde_json::{Value, json};

use super::Error;
use super::computed::Shapes;
use super::quantity::{Kind, Quantity};
use archard::body::profile::Profile;
use archard_case::Case;
use archard_case::files::{self, Contents};
use archard_case::measured::Table;
use archard_case::measured::surface::{Scar, Surface, UnwornSurface};
use archard_case::verdict::four;
use archard_surface::scar::{NoScar, Scar as ProfileScar};

/// Runs that a profile is held against, at most: the second has its section as far as wear follows a power of its coefficient.
const RUNS: usize = 3;

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
pub struct MeasuredFile {
    /// The line of the table that names it.
    pub line: u64,
    /// The file, as the table has it.
    pub file: String,
    /// What was taken from it: the name of the quantity, a factor from SI to the unit shown, and that unit.
    pub quantity: (String, f64, &'static str),
    /// What the file gives, a volume or a section, and its body.
    kind: Kind,
    body: (usize, String),
    /// The scar.
    pub scar: ScarReading,
}

/// A scar as a file has it.
#[derive(Debug, Clone, PartialEq)]
pub enum ScarReading {
    /// On a map, by what lies next to it.
    Map(Box<Scar>),
    /// On a profile, held against a computed section along an axis (0: x, 1: y).
    Profile(Box<ProfileScar>, usize),
    /// On a profile that is not yet held against any.
    Unmeasured,
}

/// Readings by rows of a table, with their standard uncertainties where they have any: SI.
pub(super) struct Column {
    pub quantity: Quantity,
    pub values: Vec<Option<f64>>,
    pub uncertainties: Option<Vec<Option<f64>>>,
}

/// What is worn off a body in the files that a column names: a column for each quantity that they tell.
///
/// Profiles are held against the shapes of runs; without them their values are one, which says that there will be some.
pub(super) fn read(
    (table, name): (&Table, &str),
    (case, body): (&Case, usize),
    files: Files<'_>,
    mut shapes: Option<&mut Shapes<'_, '_>>,
) -> Result<(Vec<Column>, Vec<MeasuredFile>), Error> {
    let shape = Shape::of(case, body)?;
    let (mut columns, mut all): (Vec<Column>, Vec<MeasuredFile>) = (vec![], vec![]);
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
        let scar = match (surface.axis(), shapes.as_deref_mut()) {
            (None, _) => shape.on_map(&surface).map_err(refuse)?,
            (Some(_), None) => ScarReading::Unmeasured,
            (Some(axis), Some(shapes)) => {
                shape.on_profile((&surface, axis), (shapes, body), &refuse)?
            }
        };
        let (worn, uncertainty) = scar.worn();
        let quantity = Quantity { name: shape.name(kind, name), kind, body };
        let place = columns.iter().position(|own| own.quantity == quantity).unwrap_or_else(|| {
            let none = vec![None; table.len()];
            let (values, uncertainties) = (none.clone(), Some(none));
            columns.push(Column { quantity: quantity.clone(), values, uncertainties });
            columns.len() - 1
        });
        columns[place].values[row] = Some(worn);
        if let Some(all) = &mut columns[place].uncertainties {
            all[row] = Some(uncertainty);
        }
        let (factor, unit) = kind.shown();
        let quantity = (quantity.name, factor, unit);
        all.push(MeasuredFile {
            line,
            file: (*file).to_owned(),
            quantity,
            kind,
            body: (body, shape.body.to_owned()),
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
pub(super) fn refuse_shape(surfaces: &[MeasuredFile], key: &str) -> Result<(), Error> {
    let own = |of: &&MeasuredFile| key.starts_with(&format!("body.{}.profile.", of.body.1));
    match surfaces.iter().find(own) {
        None => Ok(()),
        Some(MeasuredFile { file, .. }) => Err(Error::Mismatch(format!(
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

    /// What a surface gives: a profile (its axis) or a map.
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

    fn on_map(&self, surface: &Surface) -> Result<ScarReading, String> {
        let height = |[x, y]: [f64; 2]| -self.profile.recess(x, y);
        let scar = Scar::find(surface, UnwornSurface::passing(&height, self.passes));
        scar.map(|scar| ScarReading::Map(Box::new(scar))).map_err(|error| error.to_string())
    }

    /// The scar on a profile, held against that of a run which wears about as much.
    fn on_profile(
        &self,
        (surface, axis): (&Surface, usize),
        (shapes, body): (&mut Shapes<'_, '_>, usize),
        refuse: &dyn Fn(String) -> Error,
    ) -> Result<ScarReading, Error> {
        let height = |place: f64| match axis {
            0 => -self.profile.recess(place, 0.0),
            _ => -self.profile.recess(0.0, place),
        };
        let readings: Vec<[f64; 2]> =
            surface.readings().iter().map(|own| [own[axis], own[2]]).collect();
        let mut factor = 1.0;
        for _ in 0..RUNS {
            let settings = shapes.scaled(factor);
            let shape = shapes.at((body, axis), (&settings, 1.0))?;
            match ProfileScar::find(&readings, &height, &shape) {
                Ok(scar) => return Ok(ScarReading::Profile(Box::new(scar), axis)),
                Err(NoScar::OtherSize { grown }) => factor *= grown,
                Err(why) => return Err(refuse(why.to_string())),
            }
        }
        Err(refuse(format!(
            "its scar has {factor:.3} times the section of the run of the case, and runs with that wear show another one again: put a coefficient into \
             the case with which it wears about as much"
        )))
    }

    /// `file_disc` gives `profile_y_disc`, `track_section_disc` or `map_volume_disc`.
    fn name(&self, kind: Kind, column: &str) -> String {
        let of = match kind {
            Kind::Middle(axis) => ["profile_x", "profile_y"][axis],
            Kind::Section => "track_section",
            _ => "map_volume",
        };
        column.replacen(COLUMN, of, 1)
    }
}

impl ScarReading {
    /// What is worn off and its standard uncertainty (SI): by half of the 95 % interval of a profile, which has few independent readings.
    fn worn(&self) -> (f64, f64) {
        match self {
            ScarReading::Map(scar) => (scar.worn, scar.uncertainty),
            ScarReading::Profile(scar, _) => (scar.section.value, scar.section.normal()),
            ScarReading::Unmeasured => (1.0, 1.0),
        }
    }
}

impl MeasuredFile {
    /// What is worn off, a section (m^2) or a volume (m^3), and its standard uncertainty.
    pub fn worn(&self) -> (f64, f64) {
        self.scar.worn()
    }

    /// The scar of a profile, with its body and axis, where it stands in a line.
    pub(super) fn profile_in(&self, line: u64) -> Option<((usize, usize), &ProfileScar)> {
        match &self.scar {
            ScarReading::Profile(scar, axis) if self.line == line => {
                Some(((self.body.0, *axis), scar))
            }
            _ => None,
        }
    }

    /// As `fit.json` has it: SI.
    pub fn json(&self) -> Value {
        let unit = match self.kind {
            Kind::Volume => "m3",
            _ => "m2",
        };
        let (worn, uncertainty) = self.scar.worn();
        let mut all = json!({
            "line": self.line, "file": self.file, "quantity": self.quantity.0, format!("worn_{unit}"): worn,
            format!("uncertainty_{unit}"): uncertainty,
        });
        let own = match &self.scar {
            ScarReading::Map(scar) => {
                let Scar { plane, middle, extent, deepest, angle, gaps, .. } = &**scar;
                json!({
                    "deepest_m": deepest, "from_to_m": extent, "middle_m": middle, "angle_rad": angle, "tilt": plane.tilt,
                    "offset_m": plane.offset, "readings_beside": plane.used, "scatter_m": plane.scatter, "gaps": gaps,
                })
            }
            ScarReading::Profile(scar, axis) => {
                let along = |value: f64| if *axis == 0 { [value, 0.0] } else { [0.0, value] };
                let ends = scar.extent.map(along);
                let extent = [0, 1].map(|axis| ends.map(|end: [f64; 2]| end[axis]));
                json!({
                    "axis": if *axis == 0 { "x" } else { "y" }, "middle_m": along(scar.place.value),
                    "uncertainty_of_middle_m": scar.place.standard,
                    "depth_m": scar.depth.map(|own| own.value), "width_m": scar.width.map(|own| own.value),
                    "from_to_m": extent, "tilt": along(scar.tilt),
                    "offset_m": scar.height, "scatter_m": scar.texture.hypot(scar.noise),
                    "correlation_length_m": scar.length, "misfit": scar.misfit, "spikes": scar.spikes, "debris": scar.debris,
                })
            }
            ScarReading::Unmeasured => json!({}),
        };
        if let (Some(all), Value::Object(own)) = (all.as_object_mut(), own) {
            all.extend(own);
        }
        all
    }
}

/// In words.
impl fmt::Display for MeasuredFile {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (worn, uncertainty) = self.scar.worn();
        let (name, factor, unit) = &self.quantity;
        write!(
            f,
            "`{}`: {name} {} {unit} +- {:.1} %",
            self.file,
            four(worn * factor),
            100.0 * uncertainty / worn
        )?;
        match &self.scar {
            ScarReading::Map(scar) => map_in_words(f, scar),
            ScarReading::Profile(scar, axis) => profile_in_words(f, (scar, ["x", "y"][*axis])),
            ScarReading::Unmeasured => Ok(()),
        }
    }
}

fn map_in_words(f: &mut fmt::Formatter<'_>, scar: &Scar) -> fmt::Result {
    let Scar { plane, middle, deepest, angle, gaps, .. } = scar;
    let [x, y] = plane.tilt.map(|tilt| four(1e3 * tilt));
    write!(
        f,
        ", {} um deep around ({}, {}) mm; tilt ({x}, {y}) um/mm and offset {} um taken off by {} readings beside it, which \
         scatter by {} um",
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

fn profile_in_words(f: &mut fmt::Formatter<'_>, (scar, axis): (&ProfileScar, &str)) -> fmt::Result {
    if let Some(depth) = &scar.depth {
        write!(f, ", {} um deep", four(1e6 * depth.value))?;
    }
    write!(
        f,
        " around {axis} = {} mm; tilt {} um/mm and offset {} um taken off, about which the surface scatters by {} um; the computed section \
         differs by {:.1} % of its depth",
        four(1e3 * scar.place.value),
        four(1e3 * scar.tilt),
        four(1e6 * scar.height),
        four(1e6 * scar.texture.hypot(scar.noise)),
        100.0 * scar.misfit,
    )?;
    if scar.spikes > 0 {
        write!(f, "; {} of {} readings are spikes, left out", scar.spikes, scar.readings)?;
    }
    if scar.debris > 0.0 {
        write!(
            f,
            "; {:.0} % of the profile is debris next to the scar, left out",
            100.0 * scar.debris
        )?;
    }
    Ok(())
}
