//! The result folder of a run that another one has gone through.

use std::path::Path;

use serde_json::{Map, Value, json};

use super::folder::HISTORY;
use super::summary::json_of;
use super::table::{Table, number};
use super::{CASE, Claim, Error, SUMMARY};
use crate::verdict::Verdict;

/// What another run gives of a run.
#[derive(Debug, Clone, Copy)]
pub struct RowsOfRun<'a> {
    /// The rows of its history.
    pub rows: &'a [Vec<(String, f64)>],
    /// Whether the other run could be believed as far as this one goes, with what the user was warned of here.
    pub verdict: &'a Verdict,
    /// The folder of the other run.
    pub from: &'a str,
    /// Why the other run stopped before the end of this one, if it did.
    pub failure: Option<&'a str>,
}

impl RowsOfRun<'_> {
    /// Writes `case.toml`, `history.csv` and `summary.json`; what earlier runs wrote into the folder is removed.
    ///
    /// # Errors
    /// If another run writes into the folder, or a file cannot be written.
    pub fn write(&self, dir: &Path, case_toml: &str) -> Result<(), Error> {
        let mut claim = Claim::take(dir)?.adopting();
        claim.admit()?;
        claim.manifest.begin([CASE, HISTORY, SUMMARY])?;
        claim.manifest.write(CASE, case_toml.as_bytes())?;
        let mut history = Table::create(claim.manifest.claim(HISTORY)?)?;
        for row in self.rows {
            let cells: Vec<_> =
                row.iter().map(|(column, value)| (column.as_str(), number(*value))).collect();
            history.row(&cells)?;
        }
        history.flush()?;
        history.sync()?;
        let last: Option<Map<String, Value>> = self
            .rows
            .last()
            .map(|row| row.iter().map(|(column, value)| (column.clone(), json!(value))).collect());
        let summary = json!({
            "program": "archard",
            "version": env!("CARGO_PKG_VERSION"),
            "complete": self.failure.is_none(),
            "failure": self.failure,
            "verdict": json_of(&self.verdict.clone().ended(self.failure)),
            "last": last,
            "derived_from": self.from,
        });
        // Last of all: a folder with a summary is whole.
        claim.manifest.write(SUMMARY, format!("{summary:#}\n").as_bytes())?;
        Ok(())
    }
}
