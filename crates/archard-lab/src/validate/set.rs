//! A set of measured tests: a folder with a case, a table of tests, the files that it names, and `set.toml`.

use std::path::{Path, PathBuf};

use serde::Deserialize;

use archard_case::files::{self, Contents};

/// The file of a set.
pub const FILE: &str = "set.toml";

/// A set of measured tests, as its `set.toml` has it.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Set {
    /// What was tested.
    pub title: String,
    /// Where the measurements were published.
    pub source: String,
    /// Under which terms they are copied.
    pub licence: String,
    /// What was read, from where, and how well.
    pub read: String,
    /// The case, a path from the folder.
    #[serde(default = "case")]
    pub case: PathBuf,
    /// The table of tests, as a fit reads it.
    #[serde(default = "tests")]
    pub tests: PathBuf,
    /// Keys of wear that are taken from the case though no test determines them.
    #[serde(default)]
    pub assume: Vec<String>,
    /// Where the coefficients of the case are from; without it each test is predicted by the others.
    pub coefficient: Option<ReportedCoefficients>,
    /// Its folder.
    #[serde(skip)]
    pub dir: PathBuf,
}

/// Coefficients that others found.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ReportedCoefficients {
    /// Who found them, and how.
    pub source: String,
    /// Their standard uncertainty, relative.
    pub uncertainty: f64,
}

fn case() -> PathBuf {
    "case.toml".into()
}

fn tests() -> PathBuf {
    "tests.csv".into()
}

impl Set {
    /// The set in a folder.
    ///
    /// # Errors
    /// If its file cannot be read, or has what no set has.
    pub fn read(dir: &Path) -> Result<Self, String> {
        let path = dir.join(FILE);
        let name = path.display();
        let bytes = files::read(&path, Contents::Text)
            .map_err(|error| format!("{name}: cannot read it: {error}"))?;
        let text = String::from_utf8(bytes).map_err(|_| format!("{name}: no text"))?;
        let set: Self = toml::from_str(&text).map_err(|error| format!("{name}: {error}"))?;
        if let Some(ReportedCoefficients { uncertainty, .. }) = &set.coefficient
            && !(*uncertainty > 0.0 && uncertainty.is_finite())
        {
            return Err(format!(
                "{name}: coefficient.uncertainty: a number above zero, relative to the coefficient"
            ));
        }
        Ok(Self { dir: dir.to_owned(), ..set })
    }

    /// The sets in a folder, or the one that it is, by name.
    ///
    /// # Errors
    /// As [`Set::read`], or if none exists.
    pub fn all(dir: &Path) -> Result<Vec<Self>, String> {
        if dir.join(FILE).is_file() {
            return Ok(vec![Self::read(dir)?]);
        }
        let name = dir.display();
        let entries =
            std::fs::read_dir(dir).map_err(|error| format!("{name}: cannot read it: {error}"))?;
        let mut dirs: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
        dirs.retain(|dir| dir.join(FILE).is_file());
        dirs.sort();
        if dirs.is_empty() {
            return Err(format!(
                "{name}: no set of measured tests: a set is a folder with `{FILE}`, a case and a table of tests"
            ));
        }
        dirs.iter().map(|dir| Self::read(dir)).collect()
    }
}
