//! The result folder of a run.

mod behind;
mod checkpoint;
mod claim;
mod lock;
#[cfg(test)]
mod tests;

use std::error::Error as StdError;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;

use behind::Behind;
use checkpoint::{Clock, Kept};
pub use claim::Claim;
use lock::Lock;

use super::evidence::Evidence;
use super::fretting_loop::FrettingLoop;
use super::length_profiles;
use super::summary::{self, Standing};
use super::table::{Table, number};
use super::worn_profiles::WornProfiles;
use super::{COLLECTION, Collection, Error, Image, Surface, Totals, file, sections};
use crate::estimate::Estimator;
use crate::simulation::history::TIME_ERROR;
use crate::simulation::{Observer, Report, row};
use crate::verdict::Verdict;

/// The file of the numbers of every step.
pub(super) const HISTORY: &str = "history.csv";
/// The file of the sections of every output.
const PROFILES: &str = "profiles.csv";
/// The file of the profiles of bodies that roll.
const WORN_PROFILES: &str = "worn_profiles.csv";
/// The file of surfaces that swing, from end to end.
const LENGTH_PROFILES: &str = "length_profiles.csv";
/// The file of force over shift.
const FRETTING_LOOP: &str = "fretting_loop.csv";
/// All tables.
const TABLES: [&str; 5] = [HISTORY, PROFILES, WORN_PROFILES, LENGTH_PROFILES, FRETTING_LOOP];

/// Writes the results of a run into a folder as it goes; see [the module](super) for the files.
#[derive(Debug)]
pub struct ResultFolder {
    dir: PathBuf,
    /// Held until the results are whole.
    _lock: Lock,
    history: Table,
    profiles: Table,
    /// The profiles of bodies that roll, once there are any.
    worn_profiles: Option<Table>,
    /// Surfaces that swing from end to end, once there are any.
    length_profiles: Option<Table>,
    /// The loops of bodies that are shifted, once there are any, and the one under way.
    fretting_loops: Option<Table>,
    fretting_loop: FrettingLoop,
    /// Every output so far, and the last one's fields on their way.
    collection: Collection,
    behind: Behind,
    iterations: usize,
    estimator: Estimator,
    standing: Option<Standing>,
    evidence: Evidence,
    clock: Clock,
    begun: Instant,
    /// Time the run took before it was interrupted (s).
    before: f64,
}

impl ResultFolder {
    /// Makes the folder and starts its files; results of an earlier run in it are removed, anything
    /// else is left alone. [`Claim`] does the same in two steps.
    ///
    /// # Errors
    /// If another run writes into the folder, or the folder or a file in it cannot be written.
    pub fn create(dir: &Path, case_toml: &str) -> Result<Self, Error> {
        Claim::take(dir)?.begin(case_toml)
    }

    fn begin(claim: Claim, case_toml: &str) -> Result<Self, Error> {
        let fields = claim.dir.join("fields");
        fs::create_dir_all(&fields).map_err(|source| Error::Write { path: fields, source })?;
        claim.clear()?;
        let Claim { dir, lock, .. } = claim;
        file::write_whole(&dir.join("case.toml"), case_toml.as_bytes())?;
        Ok(Self {
            history: Table::create(dir.join(HISTORY))?,
            profiles: Table::create(dir.join(PROFILES))?,
            worn_profiles: None,
            length_profiles: None,
            fretting_loops: None,
            fretting_loop: FrettingLoop::default(),
            collection: Collection::default(),
            behind: Behind::default(),
            iterations: 0,
            estimator: Estimator::default(),
            standing: None,
            evidence: Evidence::default(),
            clock: Clock::new(),
            begun: Instant::now(),
            before: 0.0,
            dir,
            _lock: lock,
        })
    }

    /// Goes on with the results of a run that was kept; the run itself comes with them.
    fn resume(claim: Claim) -> Result<(Self, Vec<u8>), Error> {
        let (kept, run) = checkpoint::read(&claim.dir)?;
        claim.remove_parts();
        let Claim { dir, lock, .. } = claim;
        let Kept { tables, fretting_loop, outputs, iterations, evidence, seconds } = kept;
        let mut tables = TABLES.into_iter().zip(tables).map(|(name, kept)| {
            let path = dir.join(name);
            match kept {
                Some(kept) => Table::resume(path, kept).map(Some),
                // Rows that were added since.
                None => file::remove(&path).map(|()| None),
            }
        });
        let mut next = || tables.next().unwrap_or(Ok(None));
        let [history, profiles, worn_profiles, length_profiles, fretting_loops] =
            [next()?, next()?, next()?, next()?, next()?];
        drop(tables);
        let (Some(history), Some(profiles)) = (history, profiles) else {
            let why = "its checkpoint is damaged; start the run anew";
            return Err(Error::NoCheckpoint { dir, why });
        };
        file::remove(&dir.join("summary.json"))?;
        claim::remove_fields(&dir.join("fields"), outputs.len())?;
        let folder = Self {
            history,
            profiles,
            worn_profiles,
            length_profiles,
            fretting_loops,
            fretting_loop,
            collection: Collection { outputs },
            behind: Behind::default(),
            iterations,
            estimator: Estimator::default(),
            standing: None,
            evidence,
            clock: Clock::new(),
            begun: Instant::now(),
            before: seconds,
            dir,
            _lock: lock,
        };
        Ok((folder, run))
    }

    /// Keeps the run, if it is time to, or in any case.
    fn keep(&mut self, report: &Report<'_>, anyway: bool) -> Result<(), Error> {
        let ended = report.state.progress >= report.extent;
        let pairs = report.state.pressure.len();
        if ended || !anyway && !self.clock.is_due(report.output, pairs) {
            return Ok(());
        }
        let begun = Instant::now();
        let Some(run) = report.checkpoint() else { return Ok(()) };
        self.behind.wait()?;
        let keep = |table: Option<&Table>| table.map(Table::keep).transpose();
        let tables = [
            keep(Some(&self.history))?,
            keep(Some(&self.profiles))?,
            keep(self.worn_profiles.as_ref())?,
            keep(self.length_profiles.as_ref())?,
            keep(self.fretting_loops.as_ref())?,
        ];
        let kept = Kept {
            tables,
            fretting_loop: self.fretting_loop.clone(),
            outputs: self.collection.outputs.clone(),
            iterations: self.iterations,
            evidence: self.evidence.clone(),
            seconds: self.before + self.begun.elapsed().as_secs_f64(),
        };
        checkpoint::write(&self.dir, &kept, &run)?;
        self.clock.was_kept(begun);
        Ok(())
    }

    /// Keeps the run where it is shown, whether it is time to or not: nothing of it is lost then.
    ///
    /// # Errors
    /// If the checkpoint cannot be written.
    pub fn keep_now(&mut self, report: &Report<'_>) -> Result<(), Error> {
        self.keep(report, true)
    }

    /// Time the run took before it was interrupted (s).
    pub fn seconds_before(&self) -> f64 {
        self.before
    }

    /// The folder.
    pub fn dir(&self) -> &Path {
        &self.dir
    }

    /// Whether what was shown so far can be believed.
    pub fn verdict(&self) -> Verdict {
        self.evidence.verdict()
    }

    /// Brings all tables to the disk and writes `summary.json`, after a run that reached its end and after one that
    /// did not.
    ///
    /// # Errors
    /// If a file cannot be written.
    pub fn finish(mut self, totals: &Totals) -> Result<(), Error> {
        self.behind.wait()?;
        let more = [&self.worn_profiles, &self.length_profiles, &self.fretting_loops];
        let mut tables =
            [&self.history, &self.profiles].into_iter().chain(more.into_iter().flatten());
        tables.try_for_each(Table::sync)?;
        let verdict = self.verdict();
        let text = summary::text(self.standing.as_ref(), (self.iterations, &verdict), totals);
        file::write_whole(&self.dir.join("summary.json"), text.as_bytes())?;
        match totals.failure {
            Some(_) => Ok(()),
            None => file::remove(&self.dir.join(checkpoint::NAME)),
        }
    }

    /// Takes up a report.
    fn take(&mut self, report: &Report<'_>) -> Result<(), Error> {
        let row = row(report);
        if report.again {
            // All else of it was kept.
            self.standing = Some(Standing::of(report, &row, &self.estimator));
            return Ok(());
        }
        finite(report, &row)?;
        let cells: Vec<_> =
            row.iter().map(|(column, value)| (column.as_str(), number(*value))).collect();
        self.history.row(&cells)?;
        self.history.flush()?;
        self.history.find()?;
        if report.output {
            self.put_out(report)?;
        }
        if self.fretting_loop.take(report, &row) {
            let table = begun(&mut self.fretting_loops, &self.dir.join(FRETTING_LOOP))?;
            self.fretting_loop.write(table)?;
        }
        self.evidence.take(report, &row);
        self.iterations += report.effort.iterations;
        self.standing = Some(Standing::of(report, &row, &self.estimator));
        self.keep(report, false)
    }

    /// Writes the fields and sections of a report.
    fn put_out(&mut self, report: &Report<'_>) -> Result<(), Error> {
        self.put_out_fields(report)?;
        if let Some(swung) = &report.state.swung {
            let table = begun(&mut self.length_profiles, &self.dir.join(LENGTH_PROFILES))?;
            length_profiles::write(table, (report.problem, report.state), swung)?;
        }
        match WornProfiles::of(report.problem, report.state) {
            Some(profiles) => {
                profiles.write(begun(&mut self.worn_profiles, &self.dir.join(WORN_PROFILES))?)
            }
            None => Ok(()),
        }
    }
}

impl ResultFolder {
    /// Writes the fields of a report and their sections.
    fn put_out_fields(&mut self, report: &Report<'_>) -> Result<(), Error> {
        let Report { problem, state, .. } = report;
        let progress = (problem.motion.progress().column, state.progress);
        let name = format!("fields/{:04}", self.collection.outputs.len());
        let through = sections::through(problem, state);
        let uniform = problem.frame.is_uniform();
        let name = format!("{name}.{}", if uniform { "vti" } else { "vtu" });
        let (path, all) = (self.dir.join(&name), self.dir.join(COLLECTION));
        self.collection.outputs.push((state.progress, name));
        let collection = self.collection.clone();
        if uniform {
            let image = Image::of(problem, state);
            sections::write(&mut self.profiles, progress, &image, through)?;
            self.behind.write(move || image.write(&path).and_then(|()| collection.write(&all)))
        } else {
            let surface = Surface::of(problem, state);
            sections::write_surface(&mut self.profiles, progress, &surface, through)?;
            self.behind.write(move || surface.write(&path).and_then(|()| collection.write(&all)))
        }
    }
}

/// A table, begun at that path if it is not there yet.
fn begun<'a>(table: &'a mut Option<Table>, path: &Path) -> Result<&'a mut Table, Error> {
    let begun = match table.take() {
        Some(begun) => begun,
        None => Table::create(path.to_owned())?,
    };
    Ok(table.insert(begun))
}

impl Observer for ResultFolder {
    fn observe(&mut self, report: &Report<'_>) -> Result<(), Box<dyn StdError + Send + Sync>> {
        Ok(self.take(report)?)
    }
}

/// Says whether all numbers of a step are numbers. Only an error in time may be missing.
fn finite(report: &Report<'_>, row: &[(String, f64)]) -> Result<(), Error> {
    let missing = |column: &str, value: f64| value.is_nan() && column == TIME_ERROR;
    let wrong = row.iter().find(|(column, value)| !value.is_finite() && !missing(column, *value));
    let [one, other] = &report.state.worn;
    let fields = [("pressure_Pa", &report.state.pressure), ("wear_m", one), ("wear_m", other)];
    let spoilt = |(_, values): &(&str, &Vec<f64>)| values.iter().any(|value| !value.is_finite());
    let field = || fields.into_iter().find(spoilt).map(|(name, _)| name);
    match wrong.map(|(column, _)| column.as_str()).or_else(field) {
        None => Ok(()),
        Some(name) => {
            let place = report.problem.motion.progress().at(report.state.progress);
            Err(Error::NotFinite { name: name.to_owned(), place })
        }
    }
}
