//! The symbols of units and prefixes.

use super::dimension::Dimension;
use super::unit::Unit;

/// Symbols, their dimension, their power of ten and what remains of their size in SI.
const SYMBOLS: &[(&str, Dimension, i8, f64)] = &[
    ("m", Dimension::LENGTH, 0, 1.0),
    ("g", Dimension::MASS, -3, 1.0),
    ("s", Dimension::TIME, 0, 1.0),
    ("min", Dimension::TIME, 0, 60.0),
    ("h", Dimension::TIME, 0, 3600.0),
    ("rad", Dimension::ANGLE, 0, 1.0),
    ("deg", Dimension::ANGLE, 0, std::f64::consts::PI / 180.0),
    ("°", Dimension::ANGLE, 0, std::f64::consts::PI / 180.0),
    ("rev", Dimension::ANGLE, 0, std::f64::consts::TAU),
    ("N", Dimension::FORCE, 0, 1.0),
    ("Pa", Dimension::PRESSURE, 0, 1.0),
    ("bar", Dimension::PRESSURE, 5, 1.0),
    ("J", Dimension::ENERGY, 0, 1.0),
    ("Nm", Dimension::ENERGY, 0, 1.0),
    ("W", Dimension::POWER, 0, 1.0),
    ("Hz", Dimension::FREQUENCY, 0, 1.0),
    ("rpm", Dimension::FREQUENCY, 0, 1.0 / 60.0),
    ("K", Dimension::TEMPERATURE, 0, 1.0),
];

/// Degrees Celsius, and their zero (K).
const CELSIUS: [&str; 2] = ["degC", "°C"];
const ICE: f64 = 273.15;

/// Prefixes and their powers of ten; the micro sign is there as the Latin and as the Greek letter.
const PREFIXES: &[(&str, i8)] = &[
    ("T", 12),
    ("G", 9),
    ("M", 6),
    ("k", 3),
    ("h", 2),
    ("d", -1),
    ("c", -2),
    ("m", -3),
    ("u", -6),
    ("\u{b5}", -6),
    ("\u{3bc}", -6),
    ("n", -9),
    ("p", -12),
];

/// The unit of a symbol; whole symbols go before prefixed ones.
pub(super) fn find(text: &str) -> Option<Unit> {
    let whole = |text: &str| {
        let &(_, dimension, tens, factor) = SYMBOLS.iter().find(|symbol| symbol.0 == text)?;
        Some(Unit { dimension, tens: f64::from(tens), factor, zero: 0.0 })
    };
    if CELSIUS.contains(&text) {
        return Some(Unit { zero: ICE, ..whole("K")? });
    }
    whole(text).or_else(|| {
        PREFIXES.iter().find_map(|(prefix, tens)| {
            let unit = whole(text.strip_prefix(prefix)?)?;
            Some(Unit { tens: unit.tens + f64::from(*tens), ..unit })
        })
    })
}
