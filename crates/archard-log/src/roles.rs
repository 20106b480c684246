//! What each column is: by its name and its unit.

use crate::error::Error;
use crate::table::{Column, Table, heading, plain};
use crate::unit::{self, Measure};

/// Roles: the name for `--column`, the measure, and names in the order they are preferred.
pub const ROLES: [(&str, Measure, &str); 12] = [
    (
        "time",
        Measure::Time,
        "testtime elapsedtime elapsed runtime testduration versuchszeit messzeit time zeit timestamp temps t",
    ),
    (
        "distance",
        Measure::Length,
        "slidingdistance distance totaldistance distanceslid gleitweg gleitstrecke reibweg weg",
    ),
    (
        "laps",
        Measure::Number,
        "laps lap totalrevolutions numberofrevolutions revolutions revs turns rotations totalcycles numberofcycles cycles umdrehungen zyklen",
    ),
    (
        "speed",
        Measure::Speed,
        "slidingvelocity slidingspeed velocity linearspeed speed gleitgeschwindigkeit geschwindigkeit",
    ),
    (
        "rotation",
        Measure::Rotation,
        "speed velocity rotationalspeed rotationalvelocity rotationspeed spindlespeed discspeed diskspeed rpm drehzahl",
    ),
    ("radius", Measure::Length, "radius trackradius weartrackradius reibradius"),
    ("diameter", Measure::Length, "trackdiameter weartrackdiameter wtd reibspurdurchmesser"),
    (
        "load",
        Measure::Force,
        "load normalload normalforce appliedload appliedforce measuredload fz fn normalkraft last nominalload nominalforce",
    ),
    (
        "friction_force",
        Measure::Force,
        "frictionforce frictionalforce friction tangentialforce fx ft ff reibkraft reibungskraft",
    ),
    (
        "friction",
        Measure::Number,
        "frictioncoefficient coefficientoffriction coefffriction friccoeff coeff cof mu reibwert reibungszahl reibungskoeffizient friction",
    ),
    (
        "wear",
        Measure::Length,
        "weardepth wear linearwear totalwear pinwear verschleisstiefe verschleiss penetrationdepth depth zdepth tiefe weardisplacement displacement lvdt zposition zdisplacement z height hoehe",
    ),
    ("mass", Measure::Mass, "mass deadweight deadload masse"),
];

/// A rig, titles that tell it, and the units of its columns by role.
type Rig = (&'static str, &'static [&'static str], &'static [(&'static str, &'static str)]);

/// Units that rigs leave out of their headings.
const RIGS: [Rig; 3] = [
    (
        "TE67",
        &["This Step", "TOTAL REVOLUTIONS", "Contact Potential"],
        &[
            ("time", "s"),
            ("distance", "m"),
            ("speed", "m/s"),
            ("rotation", "rpm"),
            ("radius", "mm"),
            ("load", "N"),
            ("friction_force", "N"),
            ("wear", "um"),
            ("mass", "g"),
        ],
    ),
    (
        "CSM / Anton Paar",
        &["Laps", "FrictionForce"],
        &[("time", "s"), ("distance", "m"), ("friction_force", "N")],
    ),
    ("FX2", &["RecipeStep", "Timestamp"], &[("time", "s")]),
];

/// A column that was found, in SI.
#[derive(Debug, Clone)]
pub struct LogColumn {
    /// The title in the log.
    pub title: String,
    /// The unit that was taken.
    pub unit: String,
    /// Values in SI.
    pub values: Vec<f64>,
    /// Whether its name says that it grows with wear.
    pub grows: bool,
    /// What is to be said of how it was read.
    pub said: Option<String>,
}

/// The rig by its headings.
pub fn rig(table: &Table) -> Option<&'static str> {
    let has = |title: &str| table.columns.iter().any(|column| column.title == title);
    RIGS.iter().find(|(_, titles, _)| titles.iter().all(|title| has(title))).map(|rig| rig.0)
}

/// The column of a role, if there is one.
///
/// # Errors
/// If an option names none, two of a name differ, or the unit is missing or of another measure.
pub fn choose(
    table: &Table,
    role: &'static str,
    options: &[(String, String)],
) -> Result<Option<LogColumn>, Error> {
    let (_, measure, names) =
        ROLES.iter().find(|known| known.0 == role).expect("the role is listed");
    let (log, line) = (table.source.clone(), table.heading);
    let given = options.iter().find(|(name, _)| name == role).map(|(_, title)| title.as_str());
    let of_rig = rig(table).and_then(|own| RIGS.iter().find(|known| known.0 == own));
    let of_rig = of_rig.and_then(|own| own.2.iter().find(|unit| unit.0 == role)).map(|unit| unit.1);
    let fits = |column: &Column| match &column.unit {
        _ if column.is_clock => *measure == Measure::Time,
        // A coefficient may name in brackets what it is made of.
        Some(unit) => match unit::known(unit) {
            Some((of, _)) => of == *measure || is_weight(role, of),
            None => role == "friction",
        },
        // Without a unit one name may be of two measures: the speed of a rig is the linear one if it has both.
        None => *measure != Measure::Number || role != "friction" || column.name != "friction",
    };
    let (column, sign, stated) = if let Some(given) = given {
        let (sign, title) = given.strip_prefix('-').map_or((1.0, given), |rest| (-1.0, rest));
        let (title, nth) = match title.rsplit_once('#') {
            Some((title, nth)) => (title, nth.parse::<usize>().unwrap_or(1).max(1) - 1),
            None => (title, 0),
        };
        let (bare, unit) = match title.rsplit_once('[') {
            Some((bare, unit)) => (bare.trim(), Some(unit::plain(unit))),
            None => (title, None),
        };
        let all = |is: &dyn Fn(&&Column) -> bool| -> Vec<&Column> {
            table.columns.iter().filter(is).collect()
        };
        let named = all(&|column| column.title == title || column.title == bare);
        let named = match named.is_empty() {
            true => all(&|column| column.name == plain(heading(title).0.as_str())),
            false => named,
        };
        let Some(column) = named.get(nth).copied() else {
            let titles = table.titles();
            return Err(Error::NoColumn { log, line, title: given.to_owned(), titles });
        };
        (column, sign, unit)
    } else {
        let named = |name: &str| table.columns.iter().find(|own| own.name == name && fits(own));
        let Some(column) = names.split(' ').find_map(named) else { return Ok(None) };
        let twin = table.columns.iter().rfind(|own| own.title == column.title);
        let differ = twin.and_then(|twin| {
            let pairs = column.values.iter().zip(&twin.values);
            pairs.into_iter().position(|(one, other)| one != other && !one.is_nan())
        });
        if let Some(row) = differ {
            let (title, differ) = (column.title.clone(), table.lines[row]);
            return Err(Error::TwoOfAName { log, line, title, differ, role });
        }
        (column, 1.0, None)
    };
    let rigs_own = of_rig.filter(|_| column.unit.is_none());
    let other = column.unit.as_deref().or(rigs_own).zip(stated.as_deref());
    if let Some((known, asked)) =
        other.filter(|(known, asked)| unit::known(known) != unit::known(asked))
    {
        let (title, known, asked) = (column.title.clone(), known.to_owned(), asked.to_owned());
        return Err(Error::TwoUnits { log, line, title, known, asked, role });
    }
    let unit = match (&column.unit, stated) {
        _ if column.is_clock => "s".to_owned(),
        (Some(unit), _) if role == "friction" && unit::known(unit).is_none() => "1".to_owned(),
        (Some(unit), _) => unit.clone(),
        (None, Some(unit)) => unit,
        (None, None) => match (of_rig, measure) {
            (Some(unit), _) => unit.to_owned(),
            (None, Measure::Number) => "1".to_owned(),
            (None, _) if given.is_none() && !["distance", "load", "wear"].contains(&role) => {
                return Ok(None);
            }
            (None, _) => {
                let unit = match measure {
                    Measure::Force => "N",
                    Measure::Length if role == "wear" => "um",
                    Measure::Length => "m",
                    _ => "s",
                };
                return Err(Error::NoUnit { log, line, title: column.title.clone(), role, unit });
            }
        },
    };
    let mut said = None;
    let size = match unit::known(&unit) {
        Some((of, size)) if of == *measure => size * sign,
        Some((of, size)) if is_weight(role, of) => {
            said = Some(format!("a dead weight: times {} m/s2", unit::FREE_FALL));
            size * sign * unit::FREE_FALL
        }
        _ => {
            let (title, measure) = (column.title.clone(), measure.name());
            return Err(Error::OtherMeasure { log, line, title, unit, measure, role });
        }
    };
    let values = column.values.iter().map(|value| value * size).collect();
    let grows = given.is_some_and(|given| given.starts_with('-'))
        || ["wear", "verschleiss", "depth", "tiefe"].iter().any(|word| column.name.contains(word));
    Ok(Some(LogColumn { title: column.title.clone(), unit, values, grows, said }))
}

/// Whether a column of this measure holds the dead weight that is the load.
fn is_weight(role: &str, of: Measure) -> bool {
    role == "load" && of == Measure::Mass
}
