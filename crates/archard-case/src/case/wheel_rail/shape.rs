//! The profiles of a wheel and of a rail, as a case names them.

use archard::parameters::{Choice, Invalid, Parameter, Quantity, Value, Values};
use archard_rail::curve::{Curve, Smoothing};
use archard_rail::file::{Format, read};
use archard_rail::oddity::{Finding, Oddity};
use archard_rail::standard::{rail_60e1, wheel_s1002};
use archard_rail::{Part, Profile};

/// Distance (m) between the points of a profile drawn from its standard, as in the files of measured ones. A choice of cost: the
/// spline between them is off by parts of (distance/radius)^4.
const DRAWN: f64 = 0.2e-3;

/// A profile, and what looks wrong in the file that it is from.
#[derive(Debug, Clone, PartialEq)]
pub struct Shape {
    /// The curve through its points (m).
    pub curve: Curve,
    /// The curves through the same points without a group of them each; none of a standard profile, which has no noise.
    pub samples: Vec<Curve>,
    /// What looks wrong, with the lines of the file.
    pub findings: Vec<Finding>,
    /// The format of the file; SIMPACK's of a standard profile.
    pub format: Format,
}

/// The profile of a wheel.
#[derive(Debug, Clone, PartialEq)]
pub struct WheelShape {
    /// Its curve.
    pub shape: Shape,
    /// Nominal rolling radius (m).
    pub radius: f64,
}

/// The profile of a rail.
#[derive(Debug, Clone, PartialEq)]
pub struct RailShape {
    /// Its curve.
    pub shape: Shape,
    /// Inclination (rad) towards the middle of the track.
    pub cant: f64,
    /// The radius (m) at its top of a rail that is the rim of a roller.
    pub radius: Option<f64>,
}

/// What the profile of a wheel takes.
pub const WHEELS: &[Choice<WheelShape>] = &[Choice {
    name: "wheel",
    meaning: "the profile of a railway wheel, from its standard or from a file",
    parameters: &[FILE, WHEEL_STANDARD, RADIUS, SMOOTHING, UNIT, UPWARDS, MIRRORED],
    build: |values| {
        let radius = values.require("radius")?;
        Ok(WheelShape { shape: shape(values, Part::Wheel, wheel_s1002)?, radius })
    },
}];

/// What the profile of a rail takes.
pub const RAILS: &[Choice<RailShape>] = &[Choice {
    name: "rail",
    meaning: "the profile of a rail, from its standard or from a file",
    parameters: &[FILE, RAIL_STANDARD, CANT, ROLLER, SMOOTHING, UNIT, UPWARDS, MIRRORED],
    build: |values| {
        let cant = values.word("cant").map_or(Ok(0.0), inclination)?;
        let radius = values.number("radius");
        Ok(RailShape { shape: shape(values, Part::Rail, rail_60e1)?, cant, radius })
    },
}];

const FILE: Parameter = Parameter::optional(
    "file",
    Quantity::File,
    "SIMPACK (.prr, .prw), MiniProf (.ban, .whl), or two columns y and z (.csv, .txt)",
);
const WHEEL_STANDARD: Parameter =
    Parameter::optional("standard", Quantity::Word(&["S1002"]), "the standard profile, instead");
const RAIL_STANDARD: Parameter =
    Parameter::optional("standard", Quantity::Word(&["60E1"]), "the standard profile, instead");
const RADIUS: Parameter =
    Parameter::required("radius", Quantity::Length, "nominal rolling radius, where y = 0");
const CANT: Parameter = Parameter::optional(
    "cant",
    Quantity::Text,
    "inclination of the rail towards the middle of the track, \"1:40\"; none if not given",
);
const ROLLER: Parameter = Parameter::optional(
    "radius",
    Quantity::Length,
    "of a roller rig: radius of the roller at the top of the rail, which is straight if not given",
);
const SMOOTHING: Parameter = Parameter::optional(
    "smoothing",
    Quantity::Length,
    "waves of this length keep half of their height, shorter ones less; none if not given",
);
const UNIT: Parameter =
    Parameter::optional("unit", Quantity::Length, "unit of two columns, \"1 mm\" if not given");
const UPWARDS: Parameter =
    Parameter::optional("upwards", Quantity::Truth, "whether z of two columns points upwards");
const MIRRORED: Parameter = Parameter::optional(
    "mirrored",
    Quantity::Truth,
    "whether y of the file points to the middle of the track",
);

/// The angle (rad) of an inclination such as 1:40.
fn inclination(text: &str) -> Result<f64, Invalid> {
    let wrong = || Invalid::new("cant", format!("`{text}` is no inclination such as \"1:40\""));
    let (rise, run) = text.split_once(':').ok_or_else(wrong)?;
    let number = |part: &str| part.trim().parse::<f64>().ok().filter(|one| one.is_finite());
    match (number(rise), number(run)) {
        (Some(rise), Some(run)) if run > 0.0 => Ok((rise / run).atan()),
        _ => Err(wrong()),
    }
}

/// The curve of a file, or of the standard.
fn shape(
    values: &Values,
    part: Part,
    drawn: impl Fn(f64) -> Result<Profile, Invalid>,
) -> Result<Shape, Invalid> {
    let (profile, findings, format) = match (values.get("file"), values.word("standard")) {
        (Some(_), Some(_)) => return Err(Invalid::exclusive("standard", "file", "keep one")),
        (Some(Value::File { name, bytes }), None) => file(values, part, (name, bytes))?,
        (None, Some(_)) => {
            let drawn = drawn(DRAWN).map_err(|error| of(error, "standard"))?;
            (drawn, vec![], Format::Simpack(part))
        }
        _ => return Err(Invalid::new("file", "one of `file` and `standard` is needed")),
    };
    let smoothing = values.number("smoothing").map_or(Smoothing::NONE, Smoothing::wavelength);
    let curve = profile.curve(smoothing).map_err(|error| of(error, "file"))?;
    let groups = values.get("file").map(|_| profile.without_groups());
    let samples = groups.iter().flatten().map(|one| one.curve(smoothing));
    let samples = samples.collect::<Result<_, _>>().map_err(|error| of(error, "file"))?;
    Ok(Shape { curve, samples, findings, format })
}

/// The curve of another profile, as it is measured after wear, with the keys of one.
pub(super) fn other(
    values: &Values,
    part: Part,
    (name, bytes): (&str, &[u8]),
) -> Result<Curve, Invalid> {
    let (profile, ..) = file(values, part, (name, bytes))?;
    let smoothing = values.number("smoothing").map_or(Smoothing::NONE, Smoothing::wavelength);
    profile.curve(smoothing).map_err(|error| of(error, "file"))
}

/// The profile in a file, and what looks wrong in it.
fn file(
    values: &Values,
    part: Part,
    (name, bytes): (&str, &[u8]),
) -> Result<(Profile, Vec<Finding>, Format), Invalid> {
    let extension = name.rsplit_once('.').map_or("", |(_, extension)| extension);
    let unit = values.number("unit").unwrap_or(1e-3);
    let format = Format::of_extension(extension, part, unit).ok_or_else(|| {
        let known = "prr, prw, ban, whl, csv, txt, dat";
        Invalid::new("file", format!("`.{extension}` is no known ending: {known}"))
    })?;
    let (up, mirror) = (values.is_true("upwards"), values.is_true("mirrored"));
    let format = match format {
        Format::Columns { part, unit, comma, .. } => {
            Format::Columns { part, unit, upwards: up, mirrored: mirror, comma }
        }
        Format::MiniProf { part, flavour, .. } => {
            Format::MiniProf { part, mirrored: mirror, flavour }
        }
        other => other,
    };
    let document = read(bytes, format).map_err(|error| Invalid::new("file", error.to_string()))?;
    // No wheel and no rail has such a width: nothing that is computed of it holds.
    let size = document.findings.iter().find(|one| matches!(one.oddity, Oddity::Size { .. }));
    if let Some(size) = size {
        let remedy = match format {
            Format::Columns { .. } => {
                "state the unit of its columns, as unit = \"25.4 mm\" of inches or \"1 m\" of metres"
            }
            _ => "correct the unit in its head",
        };
        return Err(Invalid::new("file", format!("{size}: {remedy}")));
    }
    Ok((document.profile, document.findings, format))
}

/// What is wrong with a profile, at a parameter of the case.
fn of(error: Invalid, parameter: &'static str) -> Invalid {
    Invalid::new(parameter, error.message)
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::inclination;

    #[test]
    fn inclinations_are_ratios() {
        assert_relative_eq!(inclination("1:40").unwrap(), 0.025_f64.atan());
        assert_relative_eq!(inclination(" 1 : 20").unwrap(), 0.05_f64.atan());
        for wrong in ["", "40", "1:0", "1:x", "1:-40"] {
            assert!(inclination(wrong).is_err(), "{wrong}");
        }
    }
}
