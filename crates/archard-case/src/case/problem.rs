//! What is wrong with a case, as data: the key, the message, where it stands and what to do.

use std::fmt;
use std::ops::Range;

use super::Key;
use super::told::told;
use crate::verdict::{self, Warning};

/// How much a problem matters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Severity {
    /// The case cannot be run.
    Error,
    /// The case can be run, the result may not be what was meant.
    Warning,
}

impl fmt::Display for Severity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Severity::Error => "error",
            Severity::Warning => "warning",
        })
    }
}

/// Which text a location is in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Source {
    /// The case file.
    File,
    /// The `--set` option of that index.
    Option(usize),
}

/// A stretch of text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Location {
    /// The text.
    pub source: Source,
    /// The bytes of it.
    pub span: Range<usize>,
}

/// One thing that is wrong, or doubtful.
#[non_exhaustive]
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Problem {
    /// How much it matters.
    pub severity: Severity,
    /// The key it is about; empty where the text is not TOML.
    pub key: Key,
    /// What is wrong, without the key.
    pub message: String,
    /// What to do about it.
    pub help: Option<String>,
    /// Where it stands; `None` where nothing is written that one could point at.
    pub location: Option<Location>,
    /// The bytes of the text at the key that it is about; `None` for all of it.
    pub(super) within: Option<Box<Range<usize>>>,
    /// What the location should show.
    pub(super) target: Target,
    /// The subject of the line of a verdict that judges the same in results: its place among all, which keeps problems small.
    pub(super) judged: Option<u8>,
}

/// What a problem points at once its key is looked up.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Target {
    /// The value.
    Value,
    /// The key.
    Name,
    /// The table that lacks the key.
    Missing,
}

impl Problem {
    pub(super) fn error(key: Key, message: impl Into<String>) -> Self {
        Self {
            severity: Severity::Error,
            key,
            message: message.into(),
            help: None,
            location: None,
            within: None,
            target: Target::Value,
            judged: None,
        }
    }

    pub(super) fn warning(key: Key, message: impl Into<String>) -> Self {
        Self { severity: Severity::Warning, ..Self::error(key, message) }
    }

    pub(super) fn missing(key: Key, message: impl Into<String>) -> Self {
        Self { target: Target::Missing, ..Self::error(key, message) }
    }

    pub(super) fn help(self, help: impl Into<String>) -> Self {
        Self { help: Some(help.into()), ..self }
    }

    pub(super) fn at_name(self) -> Self {
        Self { target: Target::Name, ..self }
    }

    /// The same as that of a line in the verdict on results.
    pub(super) fn judged(self, subject: &str) -> Self {
        Self { judged: verdict::place_of(subject), ..self }
    }

    /// What a verdict is told of it.
    pub fn warning_of(&self) -> Warning {
        Warning { text: self.title(), judged: self.judged.and_then(verdict::subject_at) }
    }

    /// The key and what is wrong: "frame.size: ...".
    pub fn title(&self) -> String {
        if self.key.parts().is_empty() {
            self.message.clone()
        } else {
            told(format!("`{}`: {}", self.key, self.message))
        }
    }
}
