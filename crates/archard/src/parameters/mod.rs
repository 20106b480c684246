//! How a choice (a profile, a wear law, a motion, a solver) says what it takes.
//!
//! Every interchangeable part of the program is registered as a [`Choice`]: a name, a list of
//! [`Parameter`]s with their quantity, and a function that builds it from values in SI. Readers of
//! case files, help pages and error messages all work from that declaration, so a new choice needs
//! no reader of its own.

mod about;
mod bytes;
mod invalid;
mod values;

use std::fmt;

#[doc(hidden)]
pub use about::About;
#[doc(hidden)]
pub use bytes::Bytes;
pub use invalid::Invalid;
#[doc(hidden)]
pub use values::{Column, Columns, OneOf, Value, Values};

/// The physical quantity of a parameter; decides which units a reader accepts.
#[doc(hidden)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Quantity {
    /// A number without unit.
    Number,
    /// A whole number, zero or greater.
    Count,
    /// A length (m).
    Length,
    /// A force (N).
    Force,
    /// A stress, pressure, modulus or hardness (Pa).
    Pressure,
    /// A curvature or spin (1/m).
    Curvature,
    /// A dimensional wear coefficient (1/Pa, the same as m^3/(N m)).
    WearCoefficient,
    /// The factor of a power profile, m^(1 - exponent): its unit depends on the parameter named here.
    PowerFactor {
        /// The name of the parameter that holds the exponent.
        exponent: &'static str,
    },
    /// An angle (rad).
    Angle,
    /// A time (s).
    Time,
    /// A speed (m/s).
    Speed,
    /// How often something happens in a time (1/s).
    Frequency,
    /// An absolute temperature (K).
    Temperature,
    /// Anything else with a unit.
    Measured {
        /// What it is called, with its article: "a work per area".
        name: &'static str,
        /// Its SI unit: "J/m^2".
        unit: &'static str,
    },
    /// The name of one of the bodies.
    Body,
    /// Two values of one quantity, along x and y.
    Pair(&'static Quantity),
    /// Three values of one quantity, along x, y and z.
    Triple(&'static Quantity),
    /// One value of a quantity that counts for all, or three, along x, y and z.
    OneOrThree(&'static Quantity),
    /// A name of the user's.
    Text,
    /// True or false.
    Truth,
    /// A formula; names in quotes within it are those of CSV files.
    Formula,
    /// All keys of the table that are not declared, each a number or text with a unit; the name of the parameter itself
    /// stands for them.
    Constants,
    /// One of a few words.
    Word(&'static [&'static str]),
    /// The name of a file of columns, each headed `name_unit`, with their names and quantities; a
    /// column of another name is taken for a length.
    Table(&'static [(&'static str, Quantity)]),
    /// The name of a file that is read as it is.
    File,
    /// A name of the user's, or a table of parameters.
    TextOr(&'static [Parameter]),
    /// A table of parameters inside the table; the bound of the parameter itself has no meaning.
    Section(&'static [Parameter]),
}

impl Quantity {
    /// The unit of SI it is in; empty where it has none.
    pub fn unit(self) -> &'static str {
        match self {
            Quantity::Length => "m",
            Quantity::Force => "N",
            Quantity::Pressure => "Pa",
            Quantity::Curvature => "1/m",
            Quantity::WearCoefficient => "1/Pa",
            Quantity::PowerFactor { .. } => "m^(1 - exponent)",
            Quantity::Angle => "rad",
            Quantity::Time => "s",
            Quantity::Speed => "m/s",
            Quantity::Frequency => "1/s",
            Quantity::Temperature => "K",
            Quantity::Measured { unit, .. } => unit,
            Quantity::Pair(quantity)
            | Quantity::Triple(quantity)
            | Quantity::OneOrThree(quantity) => quantity.unit(),
            Quantity::Number
            | Quantity::Count
            | Quantity::Body
            | Quantity::Text
            | Quantity::TextOr(_)
            | Quantity::Truth
            | Quantity::Formula
            | Quantity::Constants
            | Quantity::Word(_)
            | Quantity::Table(_)
            | Quantity::File
            | Quantity::Section(_) => "",
        }
    }

    /// The least and the largest size (SI) of a value other than zero that can be computed with: far beyond
    /// what surfaces have, and so that products of a few values neither vanish nor overflow.
    pub fn range(self) -> [f64; 2] {
        match self {
            Quantity::Length => [1e-15, 1e15],
            Quantity::Count => [1.0, 1e9],
            // The size of m^(1 - exponent) says nothing of the lengths behind it.
            Quantity::PowerFactor { .. } => [1e-200, 1e200],
            Quantity::Pair(quantity) | Quantity::Triple(quantity) => quantity.range(),
            _ => [1e-30, 1e30],
        }
    }
}

/// What values of a numeric parameter are allowed.
#[doc(hidden)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Bound {
    /// Any finite value.
    Any,
    /// Any finite value but zero.
    NonZero,
    /// Greater than zero.
    Positive,
    /// Zero or greater.
    NonNegative,
    /// Strictly between the two.
    Between(f64, f64),
    /// Greater than the first and no more than the second.
    UpTo(f64, f64),
}

impl Bound {
    /// Whether `value` is finite and within the bound.
    pub fn admits(self, value: f64) -> bool {
        value.is_finite()
            && match self {
                Bound::Any => true,
                Bound::NonZero => value != 0.0,
                Bound::Positive => value > 0.0,
                Bound::NonNegative => value >= 0.0,
                Bound::Between(low, high) => value > low && value < high,
                Bound::UpTo(low, high) => value > low && value <= high,
            }
    }
}

impl fmt::Display for Bound {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Bound::Any => write!(f, "a finite number"),
            Bound::NonZero => write!(f, "other than zero"),
            Bound::Positive => write!(f, "greater than zero"),
            Bound::NonNegative => write!(f, "zero or greater"),
            Bound::Between(low, high) => write!(f, "between {low} and {high}"),
            Bound::UpTo(low, high) => write!(f, "greater than {low}, and {high} at most"),
        }
    }
}

/// One value a choice takes.
#[doc(hidden)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameter {
    /// The key, as written in a case file.
    pub name: &'static str,
    /// What it measures.
    pub quantity: Quantity,
    /// Which values are allowed.
    pub bound: Bound,
    /// Whether it must be given.
    pub required: bool,
    /// One phrase for help pages and error messages.
    pub meaning: &'static str,
}

impl Parameter {
    /// A parameter that must be given and be greater than zero.
    pub const fn required(name: &'static str, quantity: Quantity, meaning: &'static str) -> Self {
        Self { name, quantity, bound: Bound::Positive, required: true, meaning }
    }

    /// A parameter that may be left out; greater than zero where it is given.
    pub const fn optional(name: &'static str, quantity: Quantity, meaning: &'static str) -> Self {
        Self { required: false, ..Self::required(name, quantity, meaning) }
    }

    /// The same parameter with another bound.
    pub const fn bound(self, bound: Bound) -> Self {
        Self { bound, ..self }
    }

    /// The value (SI), where it is within the bound and of a size that can be computed with.
    ///
    /// # Errors
    /// If it is not, with what it has to be.
    pub fn admit(&self, value: f64) -> Result<f64, Invalid> {
        let [least, most] = self.quantity.range();
        let message = if !value.is_finite() {
            format!("must be a finite number, not {value}")
        } else if self.quantity == Quantity::Temperature && value <= 0.0 {
            "must be above absolute zero, -273.15 degC".to_owned()
        } else if !self.bound.admits(value) {
            format!("must be {}", self.bound)
        } else if value != 0.0 && value.abs() > most {
            format!("{value:e} in SI units is too large to compute with: {most:e} at most")
        } else if value != 0.0 && value.abs() < least {
            format!("{value:e} in SI units is too small to compute with: {least:e} at least")
        } else {
            return Ok(value);
        };
        Err(Invalid::new(self.name, message))
    }
}

/// One entry of a list of interchangeable parts: how it is called, what it takes, how it is built.
#[doc(hidden)]
#[derive(Debug)]
pub struct Choice<T> {
    /// The name of its table in a case file.
    pub name: &'static str,
    /// One phrase on what it is.
    pub meaning: &'static str,
    /// What it takes.
    pub parameters: &'static [Parameter],
    /// Builds it from values that passed the declaration.
    pub build: fn(&Values) -> Result<T, Invalid>,
}
