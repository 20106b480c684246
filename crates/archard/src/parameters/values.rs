//! The values given for a choice.

use std::any::Any;

use super::{Bytes, Invalid};

/// A value in SI.
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
        bytes: Bytes,
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

    /// The name of the file of that name, if it was given, and what its bytes are parsed to once.
    pub fn parsed<T: Any + Clone + Send + Sync>(
        &self,
        name: &str,
        make: impl Fn(&[u8]) -> T,
    ) -> Option<(&str, T)> {
        match self.get(name) {
            Some(Value::File { name, bytes }) => Some((name, bytes.parsed(make))),
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
