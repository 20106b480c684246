//! Units of the columns of logs, in SI.

/// What a unit measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Measure {
    /// Time (s).
    Time,
    /// Length (m).
    Length,
    /// Area (m2).
    Area,
    /// Force (N).
    Force,
    /// Mass (kg).
    Mass,
    /// Speed (m/s).
    Speed,
    /// Rotational speed (1/s).
    Rotation,
    /// A number.
    Number,
}

/// Standard acceleration of free fall (m/s2), 3rd CGPM 1901: defines the kilogram-force and what a dead weight loads.
pub const FREE_FALL: f64 = 9.806_65;

const UNITS: [(Measure, &[&str], f64); 31] = [
    (Measure::Time, &["s", "sec", "secs", "second", "seconds", "sek"], 1.0),
    (Measure::Time, &["ms"], 1e-3),
    (Measure::Time, &["min", "minute", "minutes"], 60.0),
    (Measure::Time, &["h", "hr", "hour", "hours"], 3600.0),
    (Measure::Length, &["m", "meter", "metre", "meters", "metres"], 1.0),
    (Measure::Length, &["mm", "millimeter", "millimeters", "millimetre", "millimetres"], 1e-3),
    (
        Measure::Length,
        &["um", "micron", "microns", "micrometer", "micrometers", "micrometre", "micrometres"],
        1e-6,
    ),
    (Measure::Length, &["nm"], 1e-9),
    (Measure::Length, &["cm"], 1e-2),
    (Measure::Length, &["km"], 1e3),
    (Measure::Length, &["in", "inch"], 0.0254),
    (Measure::Area, &["mm2", "mm^2"], 1e-6),
    (Measure::Area, &["m2", "m^2"], 1.0),
    (Measure::Area, &["cm2", "cm^2"], 1e-4),
    (Measure::Force, &["n", "newton", "newtons"], 1.0),
    (Measure::Force, &["mn"], 1e-3),
    (Measure::Force, &["kn"], 1e3),
    (Measure::Force, &["kgf", "kp"], FREE_FALL),
    (Measure::Force, &["gf", "p"], FREE_FALL * 1e-3),
    (Measure::Mass, &["g", "gram"], 1e-3),
    (Measure::Mass, &["kg"], 1.0),
    (Measure::Mass, &["mg"], 1e-6),
    (Measure::Speed, &["m/s", "ms-1", "m s-1"], 1.0),
    (Measure::Speed, &["mm/s"], 1e-3),
    (Measure::Speed, &["cm/s"], 1e-2),
    (Measure::Speed, &["m/min"], 1.0 / 60.0),
    (Measure::Rotation, &["rpm", "1/min", "u/min", "min-1", "rev/min", "r/min"], 1.0 / 60.0),
    (Measure::Rotation, &["1/s", "hz", "rps", "rev/s"], 1.0),
    (
        Measure::Number,
        &["1", "-", "", "--", "mu", "laps", "lap", "rev", "revs", "cycles", "turns"],
        1.0,
    ),
    (Measure::Number, &["%"], 1e-2),
    (Measure::Number, &["k", "degc", "c", "v", "mv", "rad", "deg"], f64::NAN),
];

impl Measure {
    /// Its name in messages.
    pub fn name(self) -> &'static str {
        match self {
            Self::Time => "time",
            Self::Length => "length",
            Self::Area => "area",
            Self::Force => "force",
            Self::Mass => "mass",
            Self::Speed => "speed",
            Self::Rotation => "rotational speed",
            Self::Number => "a plain number",
        }
    }
}

/// A unit as it is written here: `um` for µm and μm, `mm2` for mm², without spaces and brackets around it.
pub fn plain(unit: &str) -> String {
    let unit = unit.trim().trim_start_matches(['[', '(', '/']).trim_end_matches([']', ')']).trim();
    unit.replace(['\u{b5}', '\u{3bc}'], "u").replace('\u{b2}', "2").replace('\u{b0}', "deg")
}

/// What a unit measures, and its size in SI. `mN` and `N` are told by their capital: `mn` alone is read as millinewton.
pub fn known(unit: &str) -> Option<(Measure, f64)> {
    let unit = plain(unit).to_lowercase();
    let found = UNITS.iter().find(|(_, names, _)| names.contains(&&*unit));
    found.map(|(measure, _, size)| (*measure, *size))
}

/// The same of a unit that stands behind a name without brackets: one that could not be a word or a number of its own.
pub fn stands_alone(unit: &str) -> Option<(Measure, f64)> {
    known(unit.trim_start_matches('(')).filter(|(measure, size)| {
        let own = plain(unit);
        size.is_finite()
            && *measure != Measure::Number
            && !own.is_empty()
            && !["h", "p", "in", "g"].contains(&&*own)
    })
}

/// A quantity like `5 N`, in SI; none where its number can be read in two ways.
pub fn quantity(text: &str) -> Option<(Measure, f64)> {
    let text = text.trim().trim_matches('"');
    let end = text.find(|letter: char| !(letter.is_ascii_digit() || "+-.,eE".contains(letter)));
    let (number, unit) = text.split_at(end?);
    let [point, comma] = ['.', ','].map(|sign| crate::number::number(number, sign));
    // `5,000 N` is five or five thousand.
    let two_ways = number.contains(',') && point.is_some() && comma.is_some();
    let value = point.or(comma).filter(|_| !two_ways)?;
    let (measure, size) = known(unit)?;
    (value.is_finite() && size.is_finite()).then_some((measure, value * size))
}

#[cfg(test)]
mod tests {
    use super::{Measure, known, quantity};

    #[test]
    fn units_are_known_as_they_are_written() {
        for unit in ["\u{b5}m", "[\u{3bc}m]", "(um)", "/ \u{b5}m", "microns"] {
            assert_eq!(known(unit), Some((Measure::Length, 1e-6)), "{unit}");
        }
        assert_eq!(known("furlong"), None);
        assert_eq!(quantity("5 N"), Some((Measure::Force, 5.0)));
        assert_eq!(quantity("0,5 mm"), Some((Measure::Length, 0.5e-3)));
        assert_eq!(quantity("1.500e-3 m"), Some((Measure::Length, 1.5e-3)));
        assert_eq!(quantity("5.000 N"), Some((Measure::Force, 5.0)));
        for text in ["5", "5,000 N", ""] {
            assert_eq!(quantity(text), None, "{text}");
        }
    }
}
