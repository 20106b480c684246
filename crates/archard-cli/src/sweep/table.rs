//! `sweep.csv`: a row a run, with what was put in, what came out, and whether it can be believed.

use std::io::Cursor;
use std::path::Path;

use archard_case::RunnableCase;
use archard_case::files::{self, Contents};
use archard_case::output::{Claim, Error, Manifest};

use super::design::Design;
use super::row::{folder, holds_another, is_done, summary};
use super::{damage, life, regime};

/// The file of all rows.
pub const SWEEP: &str = "sweep.csv";

/// How far a row is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    /// It came to its end with a result that can be right.
    Done,
    /// It came to its end with a result that cannot be right.
    Wrong,
    /// It stopped before its end.
    Failed,
    /// It has not run, was interrupted or is under way.
    Open,
}

/// What is known of a row.
pub struct RowState {
    status: &'static str,
    /// Whether its result can be believed, in a word.
    pub verdict: String,
    /// Why it is doubtful or wrong.
    reason: String,
    error: String,
    /// The last row of its history by column, if it came to its end, and of fretting what it was.
    last: Vec<(String, String)>,
}

impl RowState {
    /// How far it is.
    pub fn status(&self) -> Status {
        match (self.status, self.verdict.as_str()) {
            ("done", "wrong") => Status::Wrong,
            ("done", _) => Status::Done,
            ("failed", _) => Status::Failed,
            _ => Status::Open,
        }
    }

    /// A number of its last step.
    pub fn number(&self, column: &str) -> Option<f64> {
        self.last.iter().find(|(name, _)| name == column)?.1.parse().ok()
    }
}

/// Writes `sweep.csv` from the folders of all rows, whoever ran them; returns what is known of each.
///
/// # Errors
/// If the table cannot be written.
pub fn collect(study: &Path, design: &Design) -> Result<Vec<RowState>, Error> {
    // The last of several tasks to get the lock sees what all have done.
    let _claim = wait_for(study)?;
    for (index, row) in design.rows.iter().enumerate() {
        let dir = folder(study, index);
        if is_done(&dir, &row.resolved) {
            // Who was killed between the end of its run and that of its folder has left this.
            match Claim::take(&dir).and_then(Claim::tidy) {
                Ok(()) | Err(Error::InUse { .. }) => {}
                Err(error) => return Err(error),
            }
        }
    }
    let known: Vec<RowState> = design
        .rows
        .iter()
        .enumerate()
        .map(|(i, row)| of(&folder(study, i), &row.resolved))
        .collect();
    let mut names: Vec<&str> = vec![];
    for (name, _) in known.iter().flat_map(|row| &row.last) {
        if !names.contains(&name.as_str()) {
            names.push(name);
        }
    }
    let mut table = csv::Writer::from_writer(vec![]);
    let head = ["row"].into_iter().chain(design.columns.iter().map(String::as_str));
    let head =
        head.chain(["status", "verdict", "reason"]).chain(names.iter().copied()).chain(["error"]);
    let mut written = table.write_record(head);
    for (index, (row, known)) in design.rows.iter().zip(&known).enumerate() {
        let cell = |name: &&str| {
            let found = known.last.iter().find(|(other, _)| other == name);
            found.map_or_else(String::new, |(_, value)| value.clone())
        };
        let start = [(index + 1).to_string()].into_iter();
        let start = start.chain(row.cells.iter().cloned());
        let start =
            start.chain([known.status.to_owned(), known.verdict.clone(), known.reason.clone()]);
        let cells = start.chain(names.iter().map(cell)).chain([known.error.clone()]);
        written = written.and_then(|()| table.write_record(cells));
    }
    let path = study.join(SWEEP);
    let refused = |source: std::io::Error| Error::Write { path: path.clone(), source };
    written.map_err(|error| refused(error.into()))?;
    let text =
        table.into_inner().map_err(|error| refused(std::io::Error::other(error.to_string())))?;
    Manifest::read(study)?.write(SWEEP, &text)?;
    Ok(known)
}

/// The lock of the study, as soon as no other task has it.
pub fn wait_for(study: &Path) -> Result<Claim, Error> {
    loop {
        match Claim::take(study) {
            Err(Error::InUse { .. }) => std::thread::sleep(std::time::Duration::from_millis(50)),
            taken => return taken,
        }
    }
}

/// What the folder of a row says. Numbers of a row that stopped before its end are not its results.
pub fn of(dir: &Path, resolved: &RunnableCase) -> RowState {
    let nothing = |status| RowState {
        status,
        verdict: String::new(),
        reason: String::new(),
        error: String::new(),
        last: vec![],
    };
    let Some(summary) = summary(dir).filter(|_| !holds_another(dir, resolved)) else {
        return nothing(if dir.join("history.csv").is_file() { "interrupted" } else { "open" });
    };
    if let Some(why) = summary["failure"].as_str() {
        let first = why.lines().next().unwrap_or_default().to_owned();
        let status = if first == "interrupted" { "interrupted" } else { "failed" };
        return RowState { error: first, ..nothing(status) };
    }
    if let Err(error) = Manifest::read(dir).and_then(|known| known.verify()) {
        return RowState { error: error.to_string(), ..nothing("failed") };
    }
    let verdict = summary["verdict"]["word"].as_str().unwrap_or_default().to_owned();
    match last_row(&dir.join("history.csv")) {
        Some(mut last) => {
            last.extend(regime::of(dir, &last).into_iter().flatten());
            last.extend(life::of(&summary));
            last.extend(damage::of(&summary));
            RowState { verdict, reason: reason(&summary), last, ..nothing("done") }
        }
        None => RowState { error: "`history.csv` has no rows".to_owned(), ..nothing("failed") },
    }
}

/// What a summary says against its result: the lines of its verdict that are not good.
fn reason(summary: &serde_json::Value) -> String {
    let lines = summary["verdict"]["lines"].as_array().into_iter().flatten();
    let doubts = lines.filter(|line| line["word"] != "good");
    let words: Vec<&str> = doubts.filter_map(|line| line["words"].as_str()).collect();
    words.join("; ")
}

/// The last row of a history by column, each number as it stands there.
fn last_row(path: &Path) -> Option<Vec<(String, String)>> {
    let mut reader = csv::Reader::from_reader(Cursor::new(files::read(path, Contents::Text).ok()?));
    let header = reader.headers().ok()?.clone();
    let last = reader.records().last()?.ok()?;
    Some(header.iter().zip(&last).map(|(name, cell)| (name.to_owned(), cell.to_owned())).collect())
}
