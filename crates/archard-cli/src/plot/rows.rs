//! Tables of numbers and words, as result folders have them.

use std::path::Path;

use anyhow::{Context, Result};
use archard_case::files;

/// Rows of a table of numbers and words.
#[derive(Debug, Default)]
pub(super) struct Rows {
    names: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Rows {
    /// The rows of a file; none where there is no file.
    pub fn read(path: &Path) -> Result<Self> {
        if !path.is_file() {
            return Ok(Self::default());
        }
        let context = || format!("cannot read `{}`", path.display());
        let text = files::read_text(path).with_context(context)?;
        let mut reader = csv::Reader::from_reader(text.as_bytes());
        let names = reader.headers().with_context(context)?.iter().map(str::to_owned).collect();
        let rows = reader.records().map(|row| Ok(row?.iter().map(str::to_owned).collect()));
        let rows = rows.collect::<csv::Result<Vec<Vec<String>>>>().with_context(context)?;
        Ok(Self { names, rows })
    }

    /// Those with that word in a column.
    pub fn with(&self, column: &str, word: &str) -> Self {
        let at = self.names.iter().position(|name| name == column);
        let has =
            |row: &&Vec<String>| at.is_some_and(|at| row.get(at).is_some_and(|cell| cell == word));
        Self { names: self.names.clone(), rows: self.rows.iter().filter(has).cloned().collect() }
    }

    /// The different words of a column, in the order of the rows.
    pub fn words(&self, column: &str) -> Vec<String> {
        let mut words: Vec<String> = vec![];
        for word in self.cells(column) {
            if !words.contains(word) {
                words.push(word.clone());
            }
        }
        words
    }

    pub fn cells(&self, column: &str) -> impl Iterator<Item = &String> {
        let at = self.names.iter().position(|name| name == column);
        self.rows.iter().filter_map(move |row| row.get(at?))
    }

    /// The numbers of a column, times a factor; NaN where a cell has no number.
    pub fn numbers(&self, column: &str, factor: f64) -> Vec<f64> {
        self.cells(column).map(|cell| factor * cell.parse().unwrap_or(f64::NAN)).collect()
    }

    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }
}
