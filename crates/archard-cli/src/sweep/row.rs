//! One row of a study: its run, in a result folder of its own.

use std::error::Error as StdError;
use std::path::{Path, PathBuf};
use std::time::Instant;

use archard::accuracy::Event;
use archard::simulation::{Observer, Report, Simulation};
use archard_case::files::{self, Contents};
use archard_case::output::{Claim, Error, ResultFolder, Store};
use archard_case::{BuildError, Case, Problem, RunnableCase};

use crate::interrupt::{Interruption, Requests};
use crate::underway::{self, Underway};

/// What came of a row.
#[derive(Debug)]
pub enum Outcome {
    /// It is done, now or before.
    Done,
    /// It stopped before its end, or cannot be written.
    Failed(String),
    /// The user stopped it.
    Interrupted,
    /// Another process runs it.
    Elsewhere,
}

/// The folder of a row, by its number from zero on.
pub fn folder(study: &Path, index: usize) -> PathBuf {
    study.join("rows").join(format!("{:04}", index + 1))
}

/// The summary in a folder, if there is a whole one.
pub fn summary(dir: &Path) -> Option<serde_json::Value> {
    serde_json::from_slice(&files::read(&dir.join("summary.json"), Contents::Text).ok()?).ok()
}

/// Whether a folder holds a run of that case that came to its end.
pub fn is_done(dir: &Path, resolved: &RunnableCase) -> bool {
    let same = kept(dir).is_some_and(|known| resolved.is_printed(&known));
    same && summary(dir).is_some_and(|summary| summary["complete"] == true)
}

/// Whether a folder holds another case.
pub fn holds_another(dir: &Path, resolved: &RunnableCase) -> bool {
    kept(dir).is_some_and(|known| !resolved.is_printed(&known))
}

/// The case in a folder, if there is one.
fn kept(dir: &Path) -> Option<String> {
    files::read_text(&dir.join("case.toml")).ok()
}

/// Runs a row, or goes on with it where it was interrupted.
pub fn run(
    resolved: &RunnableCase,
    dir: &Path,
    (requests, store): (&Requests, Option<&Store>),
) -> Outcome {
    if is_done(dir, resolved) {
        return Outcome::Done;
    }
    match attempt(resolved, dir, (requests, store)) {
        Err(Error::InUse { .. }) => Outcome::Elsewhere,
        Err(error) => Outcome::Failed(error.to_string()),
        Ok(outcome) => outcome,
    }
}

fn attempt(
    resolved: &RunnableCase,
    dir: &Path,
    (requests, store): (&Requests, Option<&Store>),
) -> Result<Outcome, Error> {
    let begun = Instant::now();
    let claim = Claim::take(dir)?.adopting();
    let mut stop = |_: Event<'_>| if requests.any() { Err(Interruption.into()) } else { Ok(()) };
    let built = resolved.clone().settle(&mut |case| Ok(build(case, store)?), &mut stop);
    if requests.any() {
        claim.give_up();
        return Ok(Outcome::Interrupted);
    }
    let (resolved, built) = match built {
        Ok((settled, simulation)) => (settled, Ok(simulation)),
        Err(error) => (resolved.clone(), Err(error.to_string())),
    };
    let resolved = &resolved;
    let (folder, kept) = begin(claim, resolved, built.as_ref().ok())?;
    let mut results = StoppableOutput { folder, requests };
    let beside = store.map(|store| Store::new(store.folder()));
    let mut inside = resolved.case.inside().keeping(beside);
    let failure = built.and_then(|simulation| {
        let observers: &mut [&mut dyn Observer] = &mut [&mut results, &mut inside];
        let ran = match &kept {
            Some(run) => simulation.resume(run, observers),
            None => simulation.run(observers),
        };
        ran.map_err(|error| error.to_string())?;
        let written = inside.write(dir, &simulation.problem);
        results.folder.stressed(written.map_err(|error| error.to_string())?);
        Ok(())
    });
    let outcome = match &failure {
        Ok(()) => Outcome::Done,
        Err(_) if requests.any() => Outcome::Interrupted,
        Err(why) => Outcome::Failed(why.clone()),
    };
    finish(results.folder, resolved, begun, failure.err())?;
    Ok(outcome)
}

/// The results of a row, from the start or from where they were interrupted.
fn begin(
    claim: Claim,
    resolved: &RunnableCase,
    simulation: Option<&Simulation>,
) -> Result<(ResultFolder, Option<Vec<u8>>), Error> {
    let (dir, case_toml) = (claim.dir().to_owned(), resolved.case.to_string());
    let until = || resolved.case.until.clone();
    let goes_on =
        dir.join("checkpoint").is_file() && kept(&dir).is_some_and(|known| known == case_toml);
    let Some(simulation) = simulation.filter(|_| goes_on) else {
        return Ok((claim.until(until()).begin(&case_toml)?, None));
    };
    match claim.resume(simulation) {
        Ok((folder, run)) => Ok((folder, Some(run))),
        // What cannot be gone on with begins anew.
        Err(Error::NoCheckpoint { .. } | Error::NotResumed { .. }) => {
            Ok((Claim::take(&dir)?.adopting().until(until()).begin(&case_toml)?, None))
        }
        Err(error) => Err(error),
    }
}

/// The simulation of a case.
pub fn build(case: &Case, store: Option<&Store>) -> Result<Simulation, BuildError> {
    store.map_or_else(|| case.build(), |store| case.build_keeping(store))
}

/// Writes the summary of results.
pub fn finish(
    folder: ResultFolder,
    resolved: &RunnableCase,
    begun: Instant,
    failure: Option<String>,
) -> Result<(), Error> {
    let warnings = resolved.warnings.iter().map(Problem::warning_of).collect();
    let command = underway::command();
    Underway { folder, begun, command, warnings, bar: None }.finish(failure).map(|_| ())
}

/// Results that end where a stop is asked for.
pub struct StoppableOutput<'a> {
    /// The results.
    pub folder: ResultFolder,
    /// Whether a stop was asked for.
    pub requests: &'a Requests,
}

impl Observer for StoppableOutput<'_> {
    fn observe(&mut self, report: &Report<'_>) -> Result<(), Box<dyn StdError + Send + Sync>> {
        self.folder.observe(report)?;
        if self.requests.any() {
            self.folder.keep_now(report)?;
            return Err(Interruption.into());
        }
        Ok(())
    }

    fn ends(&self) -> bool {
        self.folder.ends()
    }
}
