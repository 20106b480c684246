//! The result folder of a run.

mod claim;
mod lock;
#[cfg(test)]
mod tests;

use std::error::Error as StdError;
use std::fs;
use std::path::{Path, PathBuf};

pub use claim::Claim;
use lock::Lock;

use super::closed_forms;
use super::evidence::Evidence;
use super::fretting_loop::FrettingLoop;
use super::summary::{self, Standing};
use super::table::{Table, number};
use super::worn_profiles::WornProfiles;
use super::{Error, Image, Surface, Totals, file, pvd, sections};
use crate::estimate::Estimator;
use crate::simulation::history::TIME_ERROR;
use crate::simulation::{Observer, Report, row};
use crate::verdict::Verdict;

/// The file of the numbers of every step.
const HISTORY: &str = "history.csv";
/// The file of the sections of every output.
const PROFILES: &str = "profiles.csv";
/// The file of the profiles of bodies that roll.
const WORN_PROFILES: &str = "worn_profiles.csv";
/// The file of force over shift.
const FRETTING_LOOP: &str = "fretting_loop.csv";

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
    /// The loops of bodies that are shifted, once there are any, and the one under way.
    fretting_loops: Option<Table>,
    fretting_loop: FrettingLoop,
    /// Progress and file of every output so far.
    outputs: Vec<(f64, String)>,
    iterations: usize,
    estimator: Estimator,
    standing: Option<Standing>,
    evidence: Evidence,
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
            fretting_loops: None,
            fretting_loop: FrettingLoop::default(),
            outputs: Vec::new(),
            iterations: 0,
            estimator: Estimator::default(),
            standing: None,
            evidence: Evidence::default(),
            dir,
            _lock: lock,
        })
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
    pub fn finish(self, totals: &Totals) -> Result<(), Error> {
        let more = [&self.worn_profiles, &self.fretting_loops];
        let mut tables =
            [&self.history, &self.profiles].into_iter().chain(more.into_iter().flatten());
        tables.try_for_each(Table::sync)?;
        let verdict = self.verdict();
        let text = summary::text(self.standing.as_ref(), (self.iterations, &verdict), totals);
        file::write_whole(&self.dir.join("summary.json"), text.as_bytes())
    }

    /// Takes up a report.
    fn take(&mut self, report: &Report<'_>) -> Result<(), Error> {
        let row = row(report);
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
        let closed_forms = closed_forms::of(report, &self.estimator);
        self.standing = Some(Standing::of(report, &row, closed_forms));
        Ok(())
    }

    /// Writes the fields and sections of a report.
    fn put_out(&mut self, report: &Report<'_>) -> Result<(), Error> {
        self.put_out_fields(report)?;
        let collection = pvd::collection(&self.outputs);
        file::write_whole(&self.dir.join("fields.pvd"), collection.as_bytes())?;
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
        let progress = (problem.kinematics.progress().column, state.progress);
        let name = format!("fields/{:04}", self.outputs.len());
        let name = if problem.frame.is_uniform() {
            let (image, name) = (Image::of(problem, state), format!("{name}.vti"));
            image.write(&self.dir.join(&name))?;
            sections::write(&mut self.profiles, progress, &image)?;
            name
        } else {
            let (surface, name) = (Surface::of(problem, state), format!("{name}.vtu"));
            surface.write(&self.dir.join(&name))?;
            sections::write_surface(&mut self.profiles, progress, &surface)?;
            name
        };
        self.outputs.push((state.progress, name));
        Ok(())
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
            let place = report.problem.kinematics.progress().at(report.state.progress);
            Err(Error::NotFinite { name: name.to_owned(), place })
        }
    }
}
