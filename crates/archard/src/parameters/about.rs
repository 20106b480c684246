//! What there is to read of a choice besides its declaration.

/// Where a choice is from, and how a case has it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct About {
    /// The name of the choice.
    pub name: &'static str,
    /// Who has published it, where, or what its formula follows from.
    pub source: &'static str,
    /// What it takes, as TOML, with numbers of a size that is met; files that it names are in [`files`](Self::files).
    pub example: &'static str,
    /// The files of the example, each with its name and what it holds.
    pub files: &'static [(&'static str, &'static str)],
}

impl About {
    /// That of a choice whose example needs no files.
    pub const fn new(name: &'static str, source: &'static str, example: &'static str) -> Self {
        Self { name, source, example, files: &[] }
    }

    /// The same, the example reading these files.
    pub const fn reading(self, files: &'static [(&'static str, &'static str)]) -> Self {
        Self { files, ..self }
    }
}
