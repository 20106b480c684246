//! The columns of a file that gives a motion.

use super::Control;
use crate::parameters::{Invalid, Quantity};

/// Columns by name, all of them known.
#[derive(Clone, Copy)]
pub(super) struct Columns<'a>(&'a [(String, Vec<f64>)]);

impl<'a> Columns<'a> {
    /// Those of a file, if it has no other than those that are known.
    pub fn known(
        columns: &'a [(String, Vec<f64>)],
        known: &[(&str, Quantity)],
    ) -> Result<Self, Invalid> {
        let known: Vec<&str> = known.iter().map(|(name, _)| *name).collect();
        if let Some((name, _)) = columns.iter().find(|(name, _)| !known.contains(&name.as_str())) {
            let known = known.join(", ");
            return Err(wrong(format!("the column `{name}` is not known; known here: {known}")));
        }
        Ok(Self(columns))
    }

    /// One of them, if it is there.
    pub fn get(self, name: &str) -> Option<&'a [f64]> {
        self.0.iter().find(|known| known.0 == name).map(|known| &known.1[..])
    }

    /// One of them; `written` is its name with a unit.
    pub fn need(self, name: &str, written: &str) -> Result<&'a [f64], Invalid> {
        self.get(name).ok_or_else(|| wrong(format!("the column `{written}` is missing")))
    }

    /// One of two at most.
    pub fn either(self, [one, other]: [&str; 2]) -> Result<[Option<&'a [f64]>; 2], Invalid> {
        match [self.get(one), self.get(other)] {
            [Some(_), Some(_)] => Err(wrong(format!(
                "the columns `{one}` and `{other}` exclude each other: keep one"
            ))),
            given => Ok(given),
        }
    }

    /// The load or the approach of each line.
    pub fn controls(self) -> Result<Vec<Control>, Invalid> {
        match self.either(["load", "approach"])? {
            [Some(loads), _] => Ok(loads.iter().copied().map(Control::Load).collect()),
            [None, Some(values)] => Ok(values.iter().copied().map(Control::Approach).collect()),
            [None, None] => Err(wrong("one of the columns `load_N` and `approach_um` is needed")),
        }
    }
}

/// What is wrong with the file.
pub(super) fn wrong(message: impl Into<String>) -> Invalid {
    Invalid::new("file", message)
}
