//! Quantities as people write them: "210 GPa" is 210e9.
//!
//! A quantity is a number and a unit: a product of symbols with `*`, `·` or a space between them,
//! `/` dividing by the next factor, parentheses, and powers as `mm^3`, `mm3`, `mm³` or `MPa^-1`.
//! Symbols may carry a prefix ("mm", "GPa"); a symbol that is one by itself is never taken for a
//! prefixed one ("min" is a minute).
//!
//! Degrees Celsius, "20 degC" or "20 °C", are an absolute temperature where they stand alone. In a product, as in
//! "W/(m degC)", they are a difference, the same as K.
//!
//! Powers of ten are applied to the decimal text before it becomes a binary number, so that
//! "0.45 mm" and "0.00045 m" are the same number to the last bit.

mod dimension;
mod symbol;
mod unit;

use std::borrow::Cow;

pub use dimension::Dimension;
use unit::Unit;

/// What a reader expects: the dimension, and how to speak about it.
#[derive(Debug, Clone, PartialEq)]
pub struct Measure {
    /// Its dimension.
    pub dimension: Dimension,
    /// What it is called, with its article: "a length".
    pub name: Cow<'static, str>,
    /// A value as one would write it: "50 mm".
    pub example: Cow<'static, str>,
    /// Two units a number without one is likely to be meant in.
    pub units: [Cow<'static, str>; 2],
    /// The SI unit.
    pub si: Cow<'static, str>,
}

impl Measure {
    /// A pure number.
    pub const NUMBER: Self = Self::of(Dimension::NUMBER, "a pure number", "1", ["1", "1"], "1");
    /// A length (m).
    pub const LENGTH: Self = Self::of(Dimension::LENGTH, "a length", "50 mm", ["mm", "m"], "m");
    /// An area (m^2).
    pub const AREA: Self = Self::of(Dimension::AREA, "an area", "2 mm2", ["mm2", "m2"], "m2");
    /// A volume (m^3).
    pub const VOLUME: Self =
        Self::of(Dimension::VOLUME, "a volume", "0.1 mm3", ["mm3", "m3"], "m3");
    /// A mass (kg).
    pub const MASS: Self = Self::of(Dimension::MASS, "a mass", "2 mg", ["mg", "g"], "kg");
    /// A force (N).
    pub const FORCE: Self = Self::of(Dimension::FORCE, "a force", "10 N", ["N", "kN"], "N");
    /// A load per length (N/m).
    pub const LOAD_PER_LENGTH: Self = Self::of(
        Dimension::LOAD_PER_LENGTH,
        "a load per length",
        "18.5 N/mm",
        ["N/mm", "N/m"],
        "N/m",
    );
    /// A pressure, stress, modulus or hardness (Pa).
    pub const PRESSURE: Self =
        Self::of(Dimension::PRESSURE, "a pressure", "210 GPa", ["GPa", "Pa"], "Pa");
    /// An angle (rad).
    pub const ANGLE: Self = Self::of(Dimension::ANGLE, "an angle", "90 deg", ["deg", "rad"], "rad");
    /// A time (s).
    pub const TIME: Self = Self::of(Dimension::TIME, "a time", "10 s", ["s", "min"], "s");
    /// A speed (m/s).
    pub const SPEED: Self =
        Self::of(Dimension::SPEED, "a speed", "0.1 m/s", ["m/s", "mm/s"], "m/s");
    /// A frequency (1/s).
    pub const FREQUENCY: Self =
        Self::of(Dimension::FREQUENCY, "a frequency", "5 Hz", ["Hz", "rpm"], "Hz");
    /// An absolute temperature (K).
    pub const TEMPERATURE: Self =
        Self::of(Dimension::TEMPERATURE, "a temperature", "20 degC", ["degC", "K"], "K");
    /// A dimensional wear coefficient (1/Pa).
    pub const WEAR_COEFFICIENT: Self = Self::of(
        Dimension::WEAR_COEFFICIENT,
        "a wear coefficient",
        "1e-13 1/Pa",
        ["mm^3/(N m)", "1/Pa"],
        "1/Pa",
    );

    /// Whatever a unit measures: how to speak about it.
    const ANY: Self =
        Self::of(Dimension::NUMBER, "a number, or one with its unit", "30 MPa", ["MPa", "Pa"], "1");

    /// A measure with names known beforehand.
    const fn of(
        dimension: Dimension,
        name: &'static str,
        example: &'static str,
        units: [&'static str; 2],
        si: &'static str,
    ) -> Self {
        Self {
            dimension,
            name: Cow::Borrowed(name),
            example: Cow::Borrowed(example),
            units: [Cow::Borrowed(units[0]), Cow::Borrowed(units[1])],
            si: Cow::Borrowed(si),
        }
    }

    /// A power of length, the exponent any number (m^exponent).
    pub fn length_to_the(exponent: f64) -> Self {
        let unit = |symbol: &str| format!("{symbol}^{exponent}").into();
        Self {
            dimension: Dimension::LENGTH.to_the(exponent),
            name: format!("a value in m^{exponent}").into(),
            example: format!("2 m^{exponent}").into(),
            units: [unit("mm"), unit("m")],
            si: unit("m"),
        }
    }

    /// Anything of that name, with its article, and SI unit; `None` where that is no unit, or none of SI.
    pub fn in_si(name: &'static str, unit: &'static str) -> Option<Self> {
        let Unit { dimension, tens, factor, zero } = unit::parse(unit).ok()?;
        let example = Cow::Owned(format!("1 {unit}"));
        let si = (tens, factor, zero) == (0.0, 1.0, 0.0);
        si.then(|| Self { example, ..Self::of(dimension, name, "", [unit, unit], unit) })
    }

    /// Both readings of a number written without its unit: `"50 mm" or "50 m"`.
    fn readings(&self, number: &str) -> String {
        let [one, other] = &self.units;
        let one = format!("\"{number} {one}\"");
        if *other == self.units[0] { one } else { format!("{one} or \"{number} {other}\"") }
    }
}

/// Why a text is not the quantity expected.
#[non_exhaustive]
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Error {
    /// It does not begin with a number.
    #[error("expected {} (for example \"{}\"), found `{text}`", .expected.name, .expected.example)]
    NoNumber {
        /// What was written.
        text: String,
        /// What was expected.
        expected: Box<Measure>,
    },
    /// The number has no unit.
    #[error("needs a unit: write {}", .expected.readings(.number))]
    NoUnit {
        /// The number as written.
        number: String,
        /// What was expected.
        expected: Box<Measure>,
    },
    /// A comma where the decimal point should be.
    #[error("`{text}`: write a decimal point, not a comma")]
    DecimalComma {
        /// What was written.
        text: String,
    },
    /// The number is not finite or too large.
    #[error("`{number}` is not a finite number")]
    NotFinite {
        /// The number as written.
        number: String,
    },
    /// A symbol that is no unit.
    #[error("`{symbol}` is not a known unit; {} is written like \"{}\"", .expected.name, .expected.example)]
    UnknownSymbol {
        /// The symbol.
        symbol: String,
        /// What was expected.
        expected: Box<Measure>,
    },
    /// A unit that cannot be read.
    #[error("cannot read the unit `{unit}`: {reason}")]
    Malformed {
        /// The unit as written.
        unit: String,
        /// What is wrong with it.
        reason: &'static str,
    },
    /// Degrees Celsius where it is not known to be an absolute temperature.
    #[error(
        "degrees Celsius may be a temperature or a difference here: write it in K, 20 degC being 293.15 K"
    )]
    NoAbsolute,
    /// A unit of something else.
    #[error("expected {} (for example \"{}\"), found {found}", .expected.name, .expected.example)]
    WrongDimension {
        /// What was expected.
        expected: Box<Measure>,
        /// What was found.
        found: Dimension,
    },
}

/// The value in SI of a text like "50 mm", which must be of that measure.
///
/// # Errors
/// If the text is not a number with a unit of that measure.
pub fn read(text: &str, expected: &Measure) -> Result<f64, Error> {
    let text = text.trim();
    let (number, unit) = text.split_at(number_length(text));
    if number.is_empty() {
        return Err(Error::NoNumber {
            text: text.to_owned(),
            expected: Box::new(expected.clone()),
        });
    }
    if unit.starts_with(',') {
        return Err(Error::DecimalComma { text: text.to_owned() });
    }
    if unit.trim().is_empty() {
        return Err(Error::NoUnit {
            number: number.to_owned(),
            expected: Box::new(expected.clone()),
        });
    }
    scale(number, &read_unit(unit, expected)?)
}

/// The value in SI of a text like "30 MPa", and what it measures; without a unit, a pure number.
///
/// # Errors
/// If the text is not a number, or has a unit that is not known, or degrees Celsius alone.
pub fn measured(text: &str) -> Result<(f64, Dimension), Error> {
    let text = text.trim();
    let (number, unit) = text.split_at(number_length(text));
    let expected = || Box::new(Measure::ANY);
    if number.is_empty() {
        return Err(Error::NoNumber { text: text.to_owned(), expected: expected() });
    }
    if unit.starts_with(',') {
        return Err(Error::DecimalComma { text: text.to_owned() });
    }
    let unit = if unit.trim().is_empty() { "1" } else { unit };
    let unit = parse_unit(unit, &Measure::ANY)?;
    if unit.zero != 0.0 {
        return Err(Error::NoAbsolute);
    }
    Ok((scale(number, &unit)?, unit.dimension))
}

/// A unit of a measure, to read many numbers in.
#[derive(Debug, Clone, PartialEq)]
pub struct Scale(Unit);

impl Scale {
    /// Reads a unit like "mm", which must be of that measure.
    ///
    /// # Errors
    /// If the text is not a unit of that measure.
    pub fn read(unit: &str, expected: &Measure) -> Result<Self, Error> {
        read_unit(unit, expected).map(Self)
    }

    /// Reads any unit, and what it measures.
    ///
    /// # Errors
    /// If the text is not a unit.
    pub fn read_any(unit: &str) -> Result<(Self, Dimension), Error> {
        let unit = parse_unit(unit, &Measure::ANY)?;
        Ok((Self(unit), unit.dimension))
    }

    /// Whether it is one of absolute temperatures, as degrees Celsius are.
    pub fn is_absolute(&self) -> bool {
        self.0.zero != 0.0
    }

    /// The value in SI of a number written in that unit; `None` where it is not a finite number.
    pub fn apply(&self, number: &str) -> Option<f64> {
        let number = number.trim();
        (!number.is_empty() && number_length(number) == number.len())
            .then(|| scale(number, &self.0).ok())
            .flatten()
    }
}

/// Reads a unit, whatever it measures; messages speak of what is expected.
fn parse_unit(text: &str, expected: &Measure) -> Result<Unit, Error> {
    unit::parse(text.trim()).map_err(|error| match error {
        unit::Error::Unknown(symbol) => {
            Error::UnknownSymbol { symbol, expected: Box::new(expected.clone()) }
        }
        unit::Error::Malformed(reason) => Error::Malformed { unit: text.trim().to_owned(), reason },
    })
}

/// Reads a unit and checks its dimension.
fn read_unit(text: &str, expected: &Measure) -> Result<Unit, Error> {
    let unit = parse_unit(text, expected)?;
    if !unit.dimension.agrees_with(expected.dimension) {
        if meant_in_parentheses(text, expected) {
            let reason =
                "`/` divides by the next factor only: put all it divides by in parentheses";
            return Err(Error::Malformed { unit: text.trim().to_owned(), reason });
        }
        return Err(Error::WrongDimension {
            expected: Box::new(expected.clone()),
            found: unit.dimension,
        });
    }
    if unit.zero != 0.0 && *expected != Measure::TEMPERATURE {
        return Err(Error::NoAbsolute);
    }
    Ok(unit)
}

/// Whether a unit is of the expected measure once all behind its `/` is taken together, as in
/// "mm^3/N m".
fn meant_in_parentheses(text: &str, expected: &Measure) -> bool {
    text.split_once('/')
        .and_then(|(above, below)| unit::parse(&format!("{above}/({below})")).ok())
        .is_some_and(|unit| unit.dimension.agrees_with(expected.dimension))
}

/// Length of the decimal number a text begins with (bytes), zero if it does not.
fn number_length(text: &str) -> usize {
    let bytes = text.as_bytes();
    let digits = |from: usize| bytes[from..].iter().take_while(|b| b.is_ascii_digit()).count();
    let sign = |at: usize| usize::from(matches!(bytes.get(at), Some(b'+' | b'-')));
    let start = sign(0);
    let whole = digits(start);
    let mut end = start + whole;
    let mut fraction = 0;
    if bytes.get(end) == Some(&b'.') {
        fraction = digits(end + 1);
        end += 1 + fraction;
    }
    if whole + fraction == 0 {
        return 0;
    }
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let from = end + 1 + sign(end + 1);
        let exponent = if from <= bytes.len() { digits(from) } else { 0 };
        if exponent > 0 {
            end = from + exponent;
        }
    }
    end
}

/// The number of a decimal text in a unit, in SI: the power of ten goes into the decimal exponent,
/// where it costs no rounding.
fn scale(number: &str, unit: &Unit) -> Result<f64, Error> {
    let not_finite = || Error::NotFinite { number: number.to_owned() };
    let (mantissa, exponent) = number.split_once(['e', 'E']).unwrap_or((number, "0"));
    let exponent: i64 = exponent.parse().map_err(|_| not_finite())?;
    let shift = unit.tens.round();
    let text = format!("{mantissa}e{}", exponent.saturating_add(shift as i64));
    let value: f64 = text.parse().map_err(|_| not_finite())?;
    let value = match unit.factor * 10f64.powf(unit.tens - shift) {
        1.0 => value,
        factor => value * factor,
    };
    // Of any other unit the zero is zero, and its values keep their sign.
    let value = if unit.zero == 0.0 { value } else { value + unit.zero };
    if value.is_finite() { Ok(value) } else { Err(not_finite()) }
}

#[cfg(test)]
mod tests;
