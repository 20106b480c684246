//! A surface from the file of an instrument, as a case names it; and all profiles that a case can name.

mod prepare;

use std::sync::LazyLock;

use archard::body::Profile;
use archard::body::profile::{PROFILES, Table};
use archard::parameters::{Choice, Invalid, Parameter, Quantity, Value, Values};
use archard_surface::file::{Format, Scale, read_up_to, unit};
use archard_surface::{HeightMap, Implausible};

use crate::files::free_memory;
use prepare::{FORM, HOLES, LEVEL, OUTLIERS, Preparing, RADIUS, ROUGH, SMOOTH, SPACING};
pub use prepare::{Preparation, PreparedSurface};

/// The profiles of bodies in contact: those of the library, and a measured surface.
pub fn profiles() -> &'static [Choice<Box<dyn Profile>>] {
    static ALL: LazyLock<Vec<Choice<Box<dyn Profile>>>> = LazyLock::new(|| {
        let copied = |choice: &Choice<Box<dyn Profile>>| Choice { ..*choice };
        PROFILES.iter().map(copied).chain([SURFACE]).collect()
    });
    &ALL
}

/// A measured surface by itself, in the table `profile`.
pub(super) const MAPS: &[Choice<PreparedSurface>] = &[Choice {
    name: NAME,
    meaning: MEANING,
    parameters: PARAMETERS,
    build: |values| {
        let Preparing { map, steps } = prepared(values, Some(vec![]))?;
        Ok(PreparedSurface { map, steps: steps.unwrap_or_default() })
    },
}];

const NAME: &str = "surface";
const MEANING: &str =
    "a measured surface from the file of an instrument; its heights point towards the other body";
const PARAMETERS: &[Parameter] = &[
    FILE, PIXEL, PIXEL_Y, UNIT, INVERTED, FLIPPED, OUTLIERS, LEVEL, FORM, RADIUS, SMOOTH, ROUGH,
    SPACING, HOLES,
];

const SURFACE: Choice<Box<dyn Profile>> = Choice {
    name: NAME,
    meaning: MEANING,
    parameters: PARAMETERS,
    build: |values| {
        let map = whole(prepared(values, None)?.map)?;
        let places = |axis: usize| {
            (0..map.elements()[axis]).map(|index| map.place(axis, index)).collect::<Vec<f64>>()
        };
        Ok(Box::new(Table::on_grid([places(0), places(1)], map.heights())?))
    },
};

const FILE: Parameter = Parameter::required(
    "file",
    Quantity::File,
    "Digital Surf (.sur), SDF (.sdf), X3P (.x3p), Gwyddion (.gwy), NetCDF (.nc), NumPy (.npy), or a matrix of heights (.csv, .txt, .asc)",
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

/// The map of a file, prepared as it is asked for; what was done is added to the steps, if there are any.
fn prepared(values: &Values, steps: Option<Vec<Preparation>>) -> Result<Preparing, Invalid> {
    let mut preparing = Preparing { map: read_map(values)?, steps };
    if values.is_true("inverted") {
        let map = preparing.map.inverted();
        preparing.done("inverted", map, |_, _| "hills for pits".to_owned());
    }
    if values.is_true("flipped") {
        let map = preparing.map.flipped();
        preparing.done("flipped", map, |_, _| "first row at the highest y".to_owned());
    }
    preparing.prepare(values)?;
    Ok(preparing)
}

/// The map of a file.
fn read_map(values: &Values) -> Result<HeightMap, Invalid> {
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
    Ok(map)
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
