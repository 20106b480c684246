//! How a choice (a profile, a wear law, a motion, a solver) says what it takes.
//!
//! Every interchangeable part of the program is registered as a [`Choice`]: a name, a list of
//! [`Parameter`]s with their quantity, and a function that builds it from values in SI. Readers of
//! case files, help pages and error messages all work from that declaration, so a new choice needs
//! no reader of its own.

use std::borrow::Cow;
use std::fmt;
use std::ops::Range;

/// The physical quantity of a parameter; decides which units a reader accepts.
#[non_exhaustive]
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
#[non_exhaustive]
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Bound {
    /// Any finite value.
    Any,
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
            Bound::Positive => write!(f, "greater than zero"),
            Bound::NonNegative => write!(f, "zero or greater"),
            Bound::Between(low, high) => write!(f, "between {low} and {high}"),
            Bound::UpTo(low, high) => write!(f, "greater than {low}, and {high} at most"),
        }
    }
}

/// One value a choice takes.
#[non_exhaustive]
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

/// A value in SI.
#[non_exhaustive]
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// A number (SI).
    Number(f64),
    /// Two numbers, along x and y (SI).
    Pair([f64; 2]),
    /// Three numbers, along x, y and z (SI).
    Triple([f64; 3]),
    /// True or false.
    Truth(bool),
    /// A word or a name.
    Word(String),
    /// A formula, and the files that it names in quotes.
    Formula {
        /// The formula, as written.
        text: String,
        /// What the files hold, each file once.
        files: Vec<Columns>,
    },
    /// Keys that are not declared, each with a number or with text that has a unit.
    Constants(Vec<(String, String)>),
    /// A body: 0 for body 1, 1 for body 2; and its name.
    Body(usize, String),
    /// Columns of numbers (SI), each with its name, all of one length.
    Table(Vec<(String, Vec<f64>)>),
    /// A file, with its name as written and what it holds.
    File {
        /// The name, as written.
        name: String,
        /// What the file holds.
        bytes: Vec<u8>,
    },
    /// The values of a table inside the table.
    Section(Values),
}

/// The columns of a file that a formula names.
#[derive(Debug, Clone, PartialEq)]
pub struct Columns {
    /// The name of the file, as written.
    pub file: String,
    /// Where it is, wherever the case is kept.
    pub path: String,
    /// What it holds, all columns of one length.
    pub columns: Vec<Column>,
}

/// A column of numbers that says itself what it measures.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// Its name, without the unit.
    pub name: String,
    /// The unit it is written in; "1" of pure numbers.
    pub unit: String,
    /// The numbers (SI).
    pub values: Vec<f64>,
}

/// The values given for one choice, checked against its declaration.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Values(Vec<(&'static str, Value)>);

impl Values {
    /// Adds a value; the caller has checked it against the declaration.
    pub fn insert(&mut self, name: &'static str, value: Value) {
        self.0.retain(|(known, _)| *known != name);
        self.0.push((name, value));
    }

    /// The values in the order they were given.
    pub fn iter(&self) -> impl Iterator<Item = (&'static str, &Value)> {
        self.0.iter().map(|(name, value)| (*name, value))
    }

    /// The value of that name, if it was given.
    pub fn get(&self, name: &str) -> Option<&Value> {
        self.iter().find_map(|(known, value)| (known == name).then_some(value))
    }

    /// The number of that name, if it was given.
    pub fn number(&self, name: &str) -> Option<f64> {
        match self.get(name) {
            Some(Value::Number(number)) => Some(*number),
            _ => None,
        }
    }

    /// The number of that name, or an error that says it is missing.
    pub fn require(&self, name: &'static str) -> Result<f64, Invalid> {
        self.number(name).ok_or_else(|| Invalid::new(name, format!("`{name}` is missing")))
    }

    /// The two numbers of that name, if they were given.
    pub fn pair(&self, name: &str) -> Option<[f64; 2]> {
        match self.get(name) {
            Some(Value::Pair(pair)) => Some(*pair),
            _ => None,
        }
    }

    /// The three numbers of that name, if they were given.
    pub fn triple(&self, name: &str) -> Option<[f64; 3]> {
        match self.get(name) {
            Some(Value::Triple(triple)) => Some(*triple),
            _ => None,
        }
    }

    /// The values of the table of that name inside the table, if it was given.
    pub fn section(&self, name: &str) -> Option<&Values> {
        match self.get(name) {
            Some(Value::Section(values)) => Some(values),
            _ => None,
        }
    }

    /// The name and the bytes of the file of that name, if it was given.
    pub fn file(&self, name: &str) -> Option<(&str, &[u8])> {
        match self.get(name) {
            Some(Value::File { name, bytes }) => Some((name, bytes)),
            _ => None,
        }
    }

    /// The word of that name, if it was given.
    pub fn word(&self, name: &str) -> Option<&str> {
        match self.get(name) {
            Some(Value::Word(word)) => Some(word),
            _ => None,
        }
    }

    /// The formula of that name and the files that it names, if it was given.
    pub fn formula(&self, name: &str) -> Option<(&str, &[Columns])> {
        match self.get(name) {
            Some(Value::Formula { text, files }) => Some((text, files)),
            _ => None,
        }
    }

    /// Whether the value of that name was given as true.
    pub fn is_true(&self, name: &str) -> bool {
        self.get(name) == Some(&Value::Truth(true))
    }

    /// The keys, with their values as text, that the parameter of that name stands for.
    pub fn constants(&self, name: &str) -> &[(String, String)] {
        match self.get(name) {
            Some(Value::Constants(constants)) => constants,
            _ => &[],
        }
    }

    /// The body of that name, 0 for body 1 and 1 for body 2, if it was given.
    pub fn body(&self, name: &str) -> Option<usize> {
        match self.get(name) {
            Some(Value::Body(index, _)) => Some(*index),
            _ => None,
        }
    }

    /// The columns of that name, if they were given.
    pub fn table(&self, name: &str) -> Option<&[(String, Vec<f64>)]> {
        match self.get(name) {
            Some(Value::Table(columns)) => Some(columns),
            _ => None,
        }
    }

    /// The one of the two that was given, as `(first, None)` or `(None, second)`; an error if both or
    /// neither were.
    pub fn one_of(&self, first: &'static str, second: &'static str) -> Result<OneOf<f64>, Invalid> {
        only_one([(first, self.number(first)), (second, self.number(second))])
    }

    /// [`Self::one_of`] for pairs.
    pub fn one_pair_of(
        &self,
        first: &'static str,
        second: &'static str,
    ) -> Result<OneOf<[f64; 2]>, Invalid> {
        only_one([(first, self.pair(first)), (second, self.pair(second))])
    }
}

/// One of two values that exclude each other.
pub type OneOf<T> = (Option<T>, Option<T>);

fn only_one<T>(values: [(&'static str, Option<T>); 2]) -> Result<OneOf<T>, Invalid> {
    let [(first, one), (second, other)] = values;
    match (one, other) {
        (None, None) => {
            Err(Invalid::new(first, format!("one of `{first}` and `{second}` is needed")))
        }
        (Some(_), Some(_)) => Err(Invalid::exclusive(second, first, "keep one")),
        given => Ok(given),
    }
}

/// Values that do not fit together, named by the parameter to change.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
#[error("`{parameter}`: {message}")]
pub struct Invalid {
    /// The parameter to point at; one of a table inside the table is written `table.parameter`.
    pub parameter: Cow<'static, str>,
    /// The bytes of the text of that parameter that it is about; `None` for all of it.
    pub within: Option<Range<usize>>,
    /// What is wrong and what to do.
    pub message: String,
    /// What to do, where the message leaves it open.
    pub help: Option<Box<str>>,
    /// Parameters beside it that the error is about, too: any of them may be the one to change.
    pub beside: Vec<&'static str>,
    /// Whether only one of them and it may be given.
    pub exclusive: bool,
}

impl Invalid {
    /// An error at that parameter.
    pub fn new(parameter: impl Into<Cow<'static, str>>, message: impl Into<String>) -> Self {
        Self {
            parameter: parameter.into(),
            within: None,
            message: message.into(),
            help: None,
            beside: vec![],
            exclusive: false,
        }
    }

    /// The same error, about some bytes of the text of the parameter.
    #[must_use]
    pub fn within(self, bytes: Range<usize>) -> Self {
        Self { within: Some(bytes), ..self }
    }

    /// The same error with what to do about it.
    #[must_use]
    pub fn help(self, help: impl Into<Box<str>>) -> Self {
        Self { help: Some(help.into()), ..self }
    }

    /// The same error, about another parameter too.
    #[must_use]
    pub fn beside(mut self, parameter: &'static str) -> Self {
        self.beside.push(parameter);
        self
    }

    /// Two parameters, of which only one may be given, and what to do about it.
    pub fn exclusive(parameter: &'static str, other: &'static str, advice: &str) -> Self {
        let message = format!("`{other}` and `{parameter}` exclude each other: {advice}");
        Self { exclusive: true, ..Self::new(parameter, message).beside(other) }
    }
}

/// One entry of a list of interchangeable parts: how it is called, what it takes, how it is built.
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
