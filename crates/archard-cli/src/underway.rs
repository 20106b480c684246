//! The results of a run that is under way, with all that its summary needs.

use std::ffi::OsString;
use std::path::Path;
use std::sync::OnceLock;
use std::time::Instant;

use archard_case::Problem;
use archard_case::files::{self, Contents};
use archard_case::output::{Error, ResultFolder, Totals};
use archard_case::verdict::{Verdict, Warning};
use indicatif::ProgressBar;
use serde_json::Value;

/// The words of the command line. A process has one; where Python is the program, they are not those of `std::env`.
static WORDS: OnceLock<Vec<OsString>> = OnceLock::new();

/// Tells which words were typed after `archard`.
pub fn typed(words: Vec<OsString>) {
    let _ = WORDS.set(words);
}

/// The command as it was typed, quoted where a shell needs it.
pub fn command() -> String {
    let plain = |word: &str| {
        !word.is_empty() && word.chars().all(|c| c.is_alphanumeric() || "-_./=:,+@%^".contains(c))
    };
    let quoted = |word: String| match plain(&word) {
        true => word,
        false => format!("'{}'", word.replace('\'', "'\\''")),
    };
    let words = WORDS.get().into_iter().flatten();
    let words = words.map(|word| quoted(word.to_string_lossy().into_owned()));
    std::iter::once("archard".to_owned()).chain(words).collect::<Vec<_>>().join(" ")
}

/// The commands of the run in a folder as far as its summary gives them, and the one that goes on with it.
pub fn commands(dir: &Path) -> String {
    let summary = files::read(&dir.join("summary.json"), Contents::Text).ok();
    let summary: Option<Value> = summary.and_then(|text| serde_json::from_slice(&text).ok());
    let before = summary.and_then(|summary| summary["command"].as_str().map(str::to_owned));
    before.into_iter().chain([command()]).collect::<Vec<_>>().join("; ")
}

/// Results under way.
pub struct Underway {
    /// Their folder.
    pub folder: ResultFolder,
    /// When the run began.
    pub begun: Instant,
    /// What asked for them.
    pub command: String,
    /// What the user was warned of.
    pub warnings: Vec<Warning>,
    /// The bar on the terminal, if there is one.
    pub bar: Option<ProgressBar>,
}

/// Totals of what was solved at once, begun at that instant.
pub fn solved(begun: Instant, warnings: &[Problem]) -> Totals {
    Totals {
        seconds: begun.elapsed().as_secs_f64(),
        threads: rayon::current_num_threads(),
        warnings: warnings.iter().map(Problem::warning_of).collect(),
        failure: None,
        command: Some(command()),
    }
}

impl Underway {
    /// The folder.
    pub fn dir(&self) -> &Path {
        self.folder.dir()
    }

    /// Writes the summary of a run that ended, or why it did not; returns what it says and whether it can be
    /// believed.
    ///
    /// # Errors
    /// If a file cannot be written.
    pub fn finish(self, failure: Option<String>) -> Result<(Totals, Verdict), Error> {
        if let Some(bar) = self.bar {
            bar.finish_and_clear();
        }
        let totals = Totals {
            seconds: self.folder.seconds_before() + self.begun.elapsed().as_secs_f64(),
            threads: rayon::current_num_threads(),
            warnings: self.warnings,
            failure,
            command: Some(self.command),
        };
        let verdict = self.folder.finish(&totals)?;
        Ok((totals, verdict))
    }
}
