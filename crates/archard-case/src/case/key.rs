//! The place of a value in a case: "body.pin.profile.sphere.radius".

use std::fmt;

/// The keys that lead to a value, from the top of the case.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Key(Vec<Part>);

/// One step on the way to a value.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Part {
    /// Into the table entry of that name.
    Name(String),
    /// Into the array element of that index.
    Index(usize),
}

impl Key {
    /// The key of these names.
    pub fn of<const N: usize>(names: [&str; N]) -> Self {
        names.iter().fold(Self::default(), |key, name| key.child(name))
    }

    /// The key of that name in the table of this key.
    pub fn child(&self, name: &str) -> Self {
        self.with(Part::Name(name.to_owned()))
    }

    /// The element of that index in the array of this key.
    pub fn index(&self, index: usize) -> Self {
        self.with(Part::Index(index))
    }

    /// The parts, outermost first.
    pub(super) fn parts(&self) -> &[Part] {
        &self.0
    }

    fn with(&self, part: Part) -> Self {
        Self(self.0.iter().cloned().chain([part]).collect())
    }
}

impl fmt::Display for Key {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (place, part) in self.0.iter().enumerate() {
            match part {
                Part::Index(index) => write!(f, "[{index}]")?,
                Part::Name(name) => {
                    f.write_str(if place == 0 { "" } else { "." })?;
                    if is_bare(name) { f.write_str(name)? } else { write!(f, "{name:?}")? }
                }
            }
        }
        Ok(())
    }
}

/// Whether TOML lets a key stand without quotes.
pub(super) fn is_bare(name: &str) -> bool {
    !name.is_empty() && name.chars().all(|c| c.is_ascii_alphanumeric() || matches!(c, '_' | '-'))
}
