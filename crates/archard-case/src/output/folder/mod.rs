//! The result folder of a run.

mod behind;
mod checkpoint;
mod claim;
mod lock;
mod route;
#[cfg(test)]
mod tests;

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::error::Error as StdError;
use std::path::{Path, PathBuf};
use std::time::Instant;

use behind::Behind;
pub(in crate::output) use checkpoint::NAME as CHECKPOINT;
use checkpoint::{Clock, Kept};
pub use claim::Claim;
use lock::Lock;
pub use route::RouteKeeper;

use super::distributions::{self, DISTRIBUTIONS};
use super::evidence::Evidence;
use super::fretting_loop::FrettingLoop;
use super::length_profiles;
use super::summary::{self, Standing};
use super::table::{Table, number};
use super::worn_profiles::WornProfiles;
use super::{
    CASE, COLLECTION, Collection, Error, FIELDS, Image, Life, Lives, Manifest, SUMMARY, Stresses,
    Surface, Totals, sections,
};
use crate::verdict::{Verdict, Warning};
use archard::estimate::Estimator;
use archard::simulation::history::TIME_ERROR;
use archard::simulation::{Observer, Report, row};

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
/// All tables; the first two are always there.
const TABLES: [&str; 6] =
    [HISTORY, PROFILES, WORN_PROFILES, LENGTH_PROFILES, FRETTING_LOOP, DISTRIBUTIONS];

/// Writes the results of a run into a folder as it goes; see [the module](super) for the files.
#[derive(Debug)]
pub struct ResultFolder {
    dir: PathBuf,
    manifest: Manifest,
    /// Held until the results are whole.
    _lock: Lock,
    /// Those of [`TABLES`], once there are any.
    tables: BTreeMap<&'static str, Table>,
    /// The loop of bodies that are shifted, under way.
    fretting_loop: FrettingLoop,
    /// Every output so far, and the last one's fields on their way.
    collection: Collection,
    behind: Behind,
    iterations: usize,
    estimator: Estimator,
    standing: Option<Standing>,
    evidence: Evidence,
    life: Life,
    stresses: Stresses,
    clock: Clock,
    begun: Instant,
    /// Time the run took before it was interrupted (s).
    before: f64,
}

impl ResultFolder {
    /// Makes the folder and starts its files; what an earlier run wrote into it is removed, anything
    /// else is left alone. [`Claim`] does the same in two steps.
    ///
    /// # Errors
    /// If another run writes into the folder, something else stands where a file goes, or the folder or a file in it
    /// cannot be written.
    pub fn create(dir: &Path, case_toml: &str) -> Result<Self, Error> {
        Claim::take(dir)?.begin(case_toml)
    }

    fn begin(claim: Claim, case_toml: &str) -> Result<Self, Error> {
        let Claim { dir, lock, mut manifest, until, .. } = claim;
        manifest.begin([CASE, HISTORY, PROFILES])?;
        manifest.write(CASE, case_toml.as_bytes())?;
        let always =
            [HISTORY, PROFILES].map(|name| Ok((name, Table::create(manifest.claim(name)?)?)));
        let tables = always.into_iter().collect::<Result<_, Error>>()?;
        Ok(Self {
            tables,
            fretting_loop: FrettingLoop::default(),
            collection: Collection::default(),
            behind: Behind::default(),
            iterations: 0,
            estimator: Estimator::default(),
            standing: None,
            evidence: Evidence::default(),
            life: Life::until(until),
            stresses: Stresses::default(),
            clock: Clock::new(),
            begun: Instant::now(),
            before: 0.0,
            dir,
            manifest,
            _lock: lock,
        })
    }

    /// Brings the results of a run back to where it was kept.
    fn go_on(mut claim: Claim, kept: Kept) -> Result<Self, Error> {
        let Kept { tables, fretting_loop, outputs, iterations, evidence, life, seconds } = kept;
        claim.manifest.remove_parts(|_| true);
        claim.manifest.remove(SUMMARY)?;
        claim.remove_fields(outputs.len())?;
        // Tables whose rows all were added since.
        for (name, _) in TABLES.iter().zip(&tables).filter(|(_, kept)| kept.is_none()) {
            claim.manifest.remove(name)?;
        }
        let Claim { dir, lock, mut manifest, .. } = claim;
        let there = TABLES.into_iter().zip(tables).filter_map(|(name, kept)| Some((name, kept?)));
        let tables = there
            .map(|(name, kept)| Ok((name, Table::resume(manifest.claim(name)?, kept)?)))
            .collect::<Result<_, Error>>()?;
        Ok(Self {
            tables,
            fretting_loop,
            collection: Collection { outputs },
            behind: Behind::default(),
            iterations,
            estimator: Estimator::default(),
            standing: None,
            evidence,
            life,
            stresses: Stresses::default(),
            clock: Clock::new(),
            begun: Instant::now(),
            before: seconds,
            dir,
            manifest,
            _lock: lock,
        })
    }

    /// Keeps the run, if anything was solved and it is time to, or in any case.
    fn keep(&mut self, report: &Report<'_>, anyway: bool) -> Result<(), Error> {
        let ended = report.state.progress >= report.extent || self.life.ends();
        let pairs = report.state.pressure.len();
        let is_due = || report.effort.solves > 0 && self.clock.is_due(report.output, pairs);
        if ended || !anyway && !is_due() {
            return Ok(());
        }
        let begun = Instant::now();
        let Some(run) = report.checkpoint() else { return Ok(()) };
        self.behind.wait()?;
        let mut tables = [None; TABLES.len()];
        for (kept, name) in tables.iter_mut().zip(TABLES) {
            *kept = self.tables.get(name).map(Table::keep).transpose()?;
        }
        let kept = Kept {
            tables,
            fretting_loop: self.fretting_loop.clone(),
            outputs: self.collection.outputs.clone(),
            iterations: self.iterations,
            evidence: self.evidence.clone(),
            life: self.life.clone(),
            seconds: self.before + self.begun.elapsed().as_secs_f64(),
        };
        checkpoint::write(&self.manifest.claim(checkpoint::NAME)?, &kept, &run)?;
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

    /// Where a limit was reached, so far.
    pub fn life(&self) -> &Life {
        &self.life
    }

    /// Puts down how lives scatter from part to part, for the summary.
    pub fn scatter(&mut self, lives: Lives) {
        self.life.scatter(lives);
    }

    /// Puts down the largest stresses inside of bodies, for the summary.
    pub fn stressed(&mut self, stresses: Stresses) {
        self.stresses = stresses;
    }

    /// Time the run took before it was interrupted (s).
    pub fn seconds_before(&self) -> f64 {
        self.before
    }

    /// The folder.
    pub fn dir(&self) -> &Path {
        &self.dir
    }

    /// Whether what was shown so far can be believed, with what the user was warned of.
    pub fn verdict(&self, warnings: &[Warning]) -> Verdict {
        self.own_verdict().warned_of(warnings)
    }

    /// The same without what the user was warned of.
    fn own_verdict(&self) -> Verdict {
        let mut verdict = self.evidence.verdict();
        verdict.lines.extend(self.stresses.lines.iter().cloned());
        verdict
    }

    /// Brings all tables to the disk and writes `summary.json`, after a run that reached its end and after one that
    /// did not; returns what can be believed, warnings included.
    ///
    /// # Errors
    /// If a file cannot be written.
    pub fn finish(mut self, totals: &Totals) -> Result<Verdict, Error> {
        self.behind.wait()?;
        self.tables.values().try_for_each(Table::sync)?;
        let own = self.own_verdict();
        let doubts = own.complaints().map(|line| format!("{line} ({})", line.word().text()));
        let besides = own.besides(&totals.warnings).map(|warning| warning.text.clone());
        let told: Vec<String> = besides.chain(doubts).collect();
        let verdict = self.verdict(&totals.warnings).ended(totals.failure.as_deref());
        let judged = (self.iterations, &verdict);
        let text = summary::text(
            self.standing.as_ref(),
            judged,
            (totals, &told),
            (&self.life, &self.stresses),
        );
        self.manifest.write(SUMMARY, text.as_bytes())?;
        match totals.failure {
            Some(_) => Ok(verdict),
            None => {
                self.manifest.remove(checkpoint::NAME)?;
                self.manifest.settle().map(|()| verdict)
            }
        }
    }

    /// The table of that name, begun if it is not there yet.
    fn table(&mut self, name: &'static str) -> Result<&mut Table, Error> {
        Ok(match self.tables.entry(name) {
            Entry::Occupied(table) => table.into_mut(),
            Entry::Vacant(free) => free.insert(Table::create(self.manifest.claim(name)?)?),
        })
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
        self.life.take(&report.problem.motion, &row)?;
        // Fields are due at the end, wherever that is.
        let report = &Report { output: report.output || self.life.ends(), ..*report };
        let cells: Vec<_> =
            row.iter().map(|(column, value)| (column.as_str(), number(*value))).collect();
        let history = self.table(HISTORY)?;
        history.row(&cells)?;
        history.flush()?;
        history.find()?;
        if report.output {
            self.put_out(report)?;
        }
        if self.fretting_loop.take(report, &row) {
            let fretting_loop = std::mem::take(&mut self.fretting_loop);
            fretting_loop.write(self.table(FRETTING_LOOP)?)?;
            self.fretting_loop = fretting_loop;
        }
        self.evidence.take(report, &row);
        self.iterations += report.effort.iterations;
        self.standing = Some(Standing::of(report, &row, &self.estimator));
        self.keep(report, false)
    }

    /// Writes the fields and sections of a report.
    fn put_out(&mut self, report: &Report<'_>) -> Result<(), Error> {
        self.put_out_fields(report)?;
        for body in 0..2 {
            if let Some(whole) = Image::of_roaming(report.problem, report.state, body) {
                let name = super::names::worn(&report.problem.bodies[body].name);
                whole.write(&self.manifest.claim(&name)?)?;
            }
        }
        let swings = |body: usize| {
            report.problem.motion.amplitude()?;
            Some((body, report.state.surfaces[body].grid.swings()?))
        };
        if let Some(swinging) = (0..2).find_map(swings) {
            let table = self.table(LENGTH_PROFILES)?;
            length_profiles::write(table, (report.problem, report.state), swinging)?;
        }
        if report.problem.is_rough() {
            distributions::write(self.table(DISTRIBUTIONS)?, report.problem, report.state)?;
        }
        match WornProfiles::of(report.problem, report.state) {
            Some(profiles) => profiles.write(self.table(WORN_PROFILES)?),
            None => Ok(()),
        }
    }
}

impl ResultFolder {
    /// Writes the fields of a report and their sections.
    fn put_out_fields(&mut self, report: &Report<'_>) -> Result<(), Error> {
        let Report { problem, state, .. } = report;
        let progress = (problem.motion.progress.column, state.progress);
        let name = format!("{FIELDS}/{:04}", self.collection.outputs.len());
        let through = sections::through(problem, state);
        let uniform = problem.frame.is_uniform();
        let name = format!("{name}.{}", if uniform { "vti" } else { "vtu" });
        let (path, all) = (self.manifest.claim(&name)?, self.manifest.claim(COLLECTION)?);
        self.collection.outputs.push((state.progress, name));
        let collection = self.collection.clone();
        if uniform {
            let image = Image::of(problem, state);
            sections::write(self.table(PROFILES)?, progress, &image, through)?;
            self.behind.write(move || image.write(&path).and_then(|()| collection.write(&all)))
        } else {
            let surface = Surface::of(problem, state);
            sections::write_surface(self.table(PROFILES)?, progress, &surface, through)?;
            self.behind.write(move || surface.write(&path).and_then(|()| collection.write(&all)))
        }
    }
}

impl Observer for ResultFolder {
    fn observe(&mut self, report: &Report<'_>) -> Result<(), Box<dyn StdError + Send + Sync>> {
        Ok(self.take(report)?)
    }

    fn ends(&self) -> bool {
        self.life.ends()
    }
}

/// Says whether all numbers of a step are numbers. Only an error in time may be missing.
fn finite(report: &Report<'_>, row: &[(String, f64)]) -> Result<(), Error> {
    let missing = |column: &str, value: f64| value.is_nan() && column == TIME_ERROR;
    let wrong = row.iter().find(|(column, value)| !value.is_finite() && !missing(column, *value));
    let [one, other] = report.state.surfaces.each_ref().map(|surface| &surface.depth);
    let fields = [("pressure_Pa", &report.state.pressure), ("wear_m", one), ("wear_m", other)];
    let spoilt = |(_, values): &(&str, &Vec<f64>)| values.iter().any(|value| !value.is_finite());
    let field = || fields.into_iter().find(spoilt).map(|(name, _)| name);
    match wrong.map(|(column, _)| column.as_str()).or_else(field) {
        None => Ok(()),
        Some(name) => {
            let place = report.problem.motion.progress.at(report.state.progress);
            Err(Error::NotFinite { name: name.to_owned(), place })
        }
    }
}
