//! A surface from the file of an instrument, as a case names it; and all profiles that a case can name.

use std::sync::LazyLock;

use archard::body::Profile;
use archard::body::profile::{PROFILES, Table};
use archard::parameters::{Choice, Invalid, Parameter, Quantity, Value, Values};
use archard_surface::file::{Format, Scale, read_up_to, unit};
use archard_surface::{HeightMap, Implausible, Level};

use crate::files::free_memory;

/// The profiles of bodies in contact: those of the library, and a measured surface.
pub fn profiles() -> &'static [Choice<Box<dyn Profile>>] {
    static ALL: LazyLock<Vec<Choice<Box<dyn Profile>>>> = LazyLock::new(|| {
        let copied = |choice: &Choice<Box<dyn Profile>>| Choice { ..*choice };
        PROFILES.iter().map(copied).chain([SURFACE]).collect()
    });
    &ALL
}

/// A measured surface by itself, in the table `profile`.
pub(super) const MAPS: &[Choice<HeightMap>] =
    &[Choice { name: NAME, meaning: MEANING, parameters: PARAMETERS, build: prepared }];

const NAME: &str = "surface";
const MEANING: &str =
    "a measured surface from the file of an instrument; its heights point towards the other body";
const PARAMETERS: &[Parameter] = &[FILE, PIXEL, PIXEL_Y, UNIT, LEVEL, HOLES, INVERTED, FLIPPED];

const SURFACE: Choice<Box<dyn Profile>> = Choice {
    name: NAME,
    meaning: MEANING,
    parameters: PARAMETERS,
    build: |values| {
        let map = whole(prepared(values)?)?;
        let places = |axis: usize| {
            (0..map.elements()[axis]).map(|index| map.place(axis, index)).collect::<Vec<f64>>()
        };
        Ok(Box::new(Table::on_grid([places(0), places(1)], map.heights())?))
    },
};

const FILE: Parameter = Parameter::required(
    "file",
    Quantity::File,
    "Digital Surf (.sur), SDF (.sdf), X3P (.x3p), Gwyddion (.gwy), NumPy (.npy), or a matrix of heights (.csv, .txt, .asc)",
);
const PIXEL: Parameter = Parameter::optional(
    "pixel",
    Quantity::Length,
    "distance of points, along x and y if `pixel_y` is not given; that of the file where it tells one",
);
const PIXEL_Y: Parameter =
    Parameter::optional("pixel_y", Quantity::Length, "distance of points along y");
/// Each is a thousand times as large as the next.
const UNITS: &[&str] = &["m", "mm", "um", "nm"];
const UNIT: Parameter = Parameter::optional(
    "unit",
    Quantity::Word(UNITS),
    "unit of the heights of a matrix, whose file does not tell it",
);
const LEVEL: Parameter = Parameter::optional(
    "level",
    Quantity::Word(&["none", "plane", "quadratic"]),
    "what is taken off that fits best: nothing (if not given), a plane, or tilt, bow and twist",
);
const HOLES: Parameter = Parameter::optional(
    "holes",
    Quantity::Word(&["refuse", "fill"]),
    "what becomes of points without a height: refused (if not given), or filled by the harmonic function between the others",
);
const INVERTED: Parameter = Parameter::optional(
    "inverted",
    Quantity::Truth,
    "whether heights of the file point into the body",
);
const FLIPPED: Parameter = Parameter::optional(
    "flipped",
    Quantity::Truth,
    "whether the first row of the file has the highest y, not the lowest",
);

/// The map of a file, prepared as it is asked for.
fn prepared(values: &Values) -> Result<HeightMap, Invalid> {
    let wrong = |message: String| Invalid::new("file", message);
    let Some(Value::File { name, bytes }) = values.get("file") else {
        return Err(wrong("is missing".to_owned()));
    };
    let extension = name.rsplit_once('.').map_or("", |(_, extension)| extension);
    let format = Format::of_extension(extension).ok_or_else(|| {
        let known = "sur, sdf, x3p, gwy, npy, csv, txt, asc, dat";
        wrong(format!("`.{extension}` is no known ending: {known}"))
    })?;
    let pixel = match (values.number("pixel"), values.number("pixel_y")) {
        (None, Some(_)) => {
            let message = "counts along y: give `pixel`, the distance along x, too";
            return Err(Invalid::new("pixel_y", message));
        }
        (along_x, along_y) => along_x.map(|along_x| [along_x, along_y.unwrap_or(along_x)]),
    };
    let unit = values.word("unit").map(unit).transpose();
    let unit = unit.map_err(|error| Invalid::new("unit", error.to_string()))?;
    let most = (free_memory() / BYTES_OF_A_POINT) as usize;
    let map = read_up_to(bytes, format, Scale { pixel, unit }, most)
        .map_err(|error| wrong(error.to_string()))?;
    map.plausible().map_err(|error| in_doubt(values, error))?;
    let map = if values.is_true("inverted") { map.inverted() } else { map };
    let map = if values.is_true("flipped") { map.flipped() } else { map };
    let level = match values.word("level") {
        Some("plane") => Some(Level::Plane),
        Some("quadratic") => Some(Level::Quadratic),
        _ => None,
    };
    let lost = |error: archard_surface::NoMap| Invalid::new("level", error.to_string());
    let map = match level {
        Some(level) => map.levelled(level).map_err(lost)?,
        None => map,
    };
    if values.word("holes") == Some("fill") { map.filled().map_err(lost) } else { Ok(map) }
}

/// Memory (bytes) for a point: its height as it was read, as it is prepared, and in the profile.
const BYTES_OF_A_POINT: f64 = 3.0 * size_of::<f64>() as f64;

/// The key whose unit is wrong, and the one that would be plausible.
fn in_doubt(values: &Values, error: Implausible) -> Invalid {
    let given = values.word("unit").and_then(|unit| UNITS.iter().position(|one| *one == unit));
    let by = match error {
        Implausible::Steep { factor } => (-factor.log10() / 3.0).round() as usize,
        Implausible::Flat { .. } => 0,
    };
    match given {
        Some(given) => {
            let better = UNITS.get(given + by).filter(|_| by > 0);
            let better = better.map_or_else(String::new, |unit| format!(": `unit = \"{unit}\"`?"));
            Invalid::new("unit", format!("{error}{better}"))
        }
        None if values.number("pixel").is_some() => Invalid::new("pixel", error.to_string()),
        None => Invalid::new("file", error.to_string()),
    }
}

/// A map without holes.
fn whole(map: HeightMap) -> Result<HeightMap, Invalid> {
    if map.missing() > 0 {
        let (missing, all) = (map.missing(), map.heights().len());
        let message = format!(
            "{missing} of {all} points have no height: `holes = \"fill\"` takes the harmonic function between the others"
        );
        return Err(Invalid::new("holes", message));
    }
    Ok(map)
}
