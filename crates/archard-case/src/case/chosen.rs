//! A choice made in a case, with the values given for it.

use std::path::PathBuf;

use archard::parameters::{Choice, Invalid, Values};

/// One of the interchangeable parts (a profile, a law, a motion, a solver) and its values in SI.
#[derive(Debug)]
pub struct ChosenPart<T: 'static> {
    /// What was chosen.
    pub choice: &'static Choice<T>,
    /// The values given (SI).
    pub values: Values,
    /// The files that tables were read from, by parameter.
    pub(super) files: Vec<(&'static str, PathBuf)>,
}

impl<T> ChosenPart<T> {
    /// The choice of that name with no values given, if there is one.
    pub(super) fn named(name: &str, choices: &'static [Choice<T>]) -> Option<Self> {
        let choice = choices.iter().find(|choice| choice.name == name)?;
        Some(Self { choice, values: Values::default(), files: vec![] })
    }

    /// Builds the part.
    ///
    /// # Errors
    /// If values do not fit together; in a checked case they do.
    pub fn build(&self) -> Result<T, Invalid> {
        (self.choice.build)(&self.values)
    }
}

impl<T> Clone for ChosenPart<T> {
    fn clone(&self) -> Self {
        Self { choice: self.choice, values: self.values.clone(), files: self.files.clone() }
    }
}

impl<T> PartialEq for ChosenPart<T> {
    fn eq(&self, other: &Self) -> bool {
        self.choice.name == other.choice.name
            && self.values == other.values
            && self.files == other.files
    }
}
