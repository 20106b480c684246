//! Runs of the case, and what they say of the readings.

use std::error::Error as StdError;
use std::path::{Path, PathBuf};
use std::time::Instant;

use super::curve::Curve;
use super::kept::{self, Kept, Row};
use super::quantity::{Kind, Quantity};
use super::{Error, Expectation};
use archard::motion::{Motion, Schedule, Stepping};
use archard::numerics::WRITTEN;
use archard::simulation::{self, Observer, Report, Simulation, history};
use archard_case::output::{Claim, ResultFolder, Store, Totals};
use archard_case::verdict::{Verdict, Word};
use archard_case::{BuildError, Case, CaseFile, Problem, RunnableCase, Severity};

/// What follows the runs of a fit.
pub trait RunFollower {
    /// A run begins, the first being 1, with what was put into the case.
    fn begins(&mut self, run: usize, settings: &str);

    /// It has ended after so many seconds; `None` where it was done before an interruption.
    fn ended(&mut self, run: usize, settings: &str, seconds: Option<f64>);

    /// What observes it: an error ends the fit.
    fn observer(&mut self) -> &mut dyn Observer;

    /// Why a route that it does not observe has to end, if it has to.
    fn stops(&mut self) -> Option<Box<dyn StdError + Send + Sync>> {
        None
    }
}

/// Runs a case with values in place of its own.
pub(super) struct Runner<'a> {
    pub file: &'a CaseFile,
    pub quantities: &'a [Quantity],
    /// Columns of the history that may say how far readings are, best first.
    pub columns: &'a [&'a str],
    pub dir: &'a Path,
    pub store: Option<&'a Store>,
    pub following: &'a mut dyn RunFollower,
    /// Number of runs so far, and the files they are kept in.
    pub count: usize,
    pub kept: Vec<PathBuf>,
}

/// The simulation of a case.
pub(super) fn built(case: &Case, store: Option<&Store>) -> Result<Simulation, BuildError> {
    store.map_or_else(|| case.build(), |store| case.build_keeping(store))
}

/// How a run differs from what the case says.
#[derive(Debug, Clone, Default)]
pub(super) struct Changes {
    /// Keys with the values put there.
    pub settings: Vec<(String, f64, String)>,
    /// Places, relative to the end, that steps end at.
    pub shares: Vec<f64>,
    /// Steps of twice the length, or four times the tolerance.
    pub coarse_steps: bool,
    /// Half the elements along each axis.
    pub coarse_elements: bool,
}

/// What came out.
#[derive(Debug, Clone)]
pub(super) struct Run {
    /// Each quantity over how far the run was.
    pub curves: Vec<Curve>,
    /// How far it went, by the column of the readings.
    pub end: f64,
    /// What is doubtful about it, in words.
    pub doubts: Vec<String>,
}

impl Run {
    /// What it says of a quantity at a place.
    pub fn at(&self, quantity: usize, place: f64) -> Expectation {
        self.curves[quantity].at(place)
    }
}

impl Runner<'_> {
    /// Runs the case into a folder of that name.
    pub fn run(&mut self, changes: &Changes, name: &str) -> Result<Run, Error> {
        let settings = described(&changes.settings);
        let mut resolved = self.resolve(changes)?;
        if changes.coarse_elements {
            resolved.case.frame.elements = resolved.case.frame.elements.map(|n| n.div_ceil(2));
        }
        let failed = |why: String| Error::Run { settings: settings.clone(), why };
        let mut simulation =
            built(&resolved.case, self.store).map_err(|error| failed(error.to_string()))?;
        if changes.coarse_steps {
            simulation.schedule.stepping = match simulation.schedule.stepping {
                Stepping::Implicit(step) => Stepping::Implicit(2.0 * step),
                Stepping::Tolerance(tolerance) => Stepping::Tolerance(4.0 * tolerance),
                other => other,
            };
        }
        simulation.schedule =
            passing(&simulation.problem.motion, &simulation.schedule, &changes.shares);
        let of = (&resolved.case, &simulation);
        let file = kept::file(self.dir, of, (self.quantities, self.columns));
        self.count += 1;
        self.kept.push(file.clone());
        if let Some(known) = Kept::read(&file) {
            self.following.ended(self.count, &settings, None);
            return self.curves(known);
        }
        self.following.begins(self.count, &settings);
        let (rows, verdict) = self.follow(simulation, (&resolved, name, &settings))?;
        if verdict.word() == Word::Wrong {
            let why: Vec<String> = verdict.complaints().map(ToString::to_string).collect();
            return Err(failed(format!("it cannot be right: {}", why.join("; "))));
        }
        let doubt = |line: &archard_case::verdict::Line| format!("{}: {line}", line.word().text());
        let kept = Kept { rows, doubts: verdict.complaints().map(doubt).collect() };
        kept.write(&file);
        self.curves(kept)
    }

    /// The steps of a run, and what can be believed of it; its results go into the folder of that name.
    fn follow(
        &mut self,
        simulation: Simulation,
        (resolved, name, settings): (&RunnableCase, &str, &str),
    ) -> Result<(Vec<Row>, Verdict), Error> {
        let failed = |why: String| Error::Run { settings: settings.to_owned(), why };
        let begun = Instant::now();
        let claim =
            Claim::take(&self.dir.join(name)).map_err(|error| Error::Folder(error.into()))?;
        let folder = claim.begin(&resolved.case.to_string());
        let folder = folder.map_err(|error| Error::Folder(error.into()))?;
        let mut recorder =
            Recorder { folder, quantities: self.quantities, columns: self.columns, rows: vec![] };
        let ran = simulation.run(&mut [&mut recorder, self.following.observer()]);
        let totals = Totals {
            seconds: begun.elapsed().as_secs_f64(),
            threads: rayon::current_num_threads(),
            warnings: resolved.warnings.iter().map(Problem::warning_of).collect(),
            failure: ran.as_ref().err().map(ToString::to_string),
            ..Totals::default()
        };
        let rows = recorder.rows;
        let verdict = recorder.folder.finish(&totals).map_err(|error| failed(error.to_string()))?;
        match ran {
            Ok(_) => {
                self.following.ended(self.count, settings, Some(totals.seconds));
                Ok((rows, verdict))
            }
            Err(simulation::Error::Observer(cause)) => {
                Err(Error::Stopped { cause, runs: self.count - 1 })
            }
            Err(error) => Err(failed(error.to_string())),
        }
    }

    /// The case with the changes.
    fn resolve(&self, changes: &Changes) -> Result<RunnableCase, Error> {
        let file = changes.settings.iter().fold(self.file.clone(), put);
        file.resolve().map_err(|problems| {
            let errors = problems.iter().filter(|problem| problem.severity == Severity::Error);
            let why: Vec<String> = errors.map(|problem| file.describe(problem)).collect();
            Error::Case { settings: described(&changes.settings), why: why.join("; ") }
        })
    }

    fn curves(&self, Kept { rows, doubts }: Kept) -> Result<Run, Error> {
        let last = rows.last().map(|row| row.far.clone()).unwrap_or_default();
        let Some(column) = last.iter().position(Option::is_some) else {
            return Err(Error::Mismatch(format!(
                "runs of the case do not tell `{}`; give how far readings are as its motion does",
                self.columns.join("` or `")
            )));
        };
        let curve = |(place, quantity): (usize, &Quantity)| {
            let there = |row: &Row| Some([row.far[column]?, row.values[place]?]);
            let points: Vec<[f64; 2]> = rows.iter().filter_map(there).collect();
            if points.is_empty() {
                return Err(Error::Mismatch(format!(
                    "runs of the case do not tell the `{}` of this body; `volume`, `depth` or `section` may do",
                    quantity.name
                )));
            }
            let stepped = matches!(quantity.kind, Kind::Width | Kind::Length | Kind::Diameter);
            Curve::through(points.into_iter(), stepped).ok_or_else(|| {
                Error::Mismatch(format!("in runs of the case `{}` stays zero", quantity.name))
            })
        };
        let curves = self.quantities.iter().enumerate().map(curve).collect::<Result<_, _>>()?;
        Ok(Run { curves, end: last[column].unwrap_or_default(), doubts })
    }
}

/// A case with a value (SI) at a key, and its unit.
pub(super) fn put(file: CaseFile, (key, value, unit): &(String, f64, String)) -> CaseFile {
    let value =
        if unit.is_empty() { format!("{value:e}") } else { format!("\"{value:e} {unit}\"") };
    file.set(format!("{key}={value}"))
}

/// Settings in words.
pub(super) fn described(settings: &[(String, f64, String)]) -> String {
    let one = |(key, value, unit): &(String, f64, String)| format!("{key} = {value:.4e} {unit}");
    let all: Vec<String> = settings.iter().map(|own| one(own).trim_end().to_owned()).collect();
    if all.is_empty() { "as it is".to_owned() } else { all.join(", ") }
}

/// The schedule with steps that end at these shares of its extent, where steps can be put.
pub(super) fn passing(motion: &Motion, schedule: &Schedule, shares: &[f64]) -> Schedule {
    let mut shares: Vec<f64> =
        shares.iter().copied().filter(|share| *share < 1.0 - WRITTEN).collect();
    shares.push(1.0);
    shares.sort_by(f64::total_cmp);
    shares.dedup_by(|next, last| *next - *last <= WRITTEN * *next);
    if motion.is_steady() && schedule.is_steady() {
        return schedule.through(&shares);
    }
    let mut outputs: Vec<f64> = shares.iter().map(|share| share * schedule.extent).collect();
    outputs.extend(&schedule.outputs);
    outputs.sort_by(f64::total_cmp);
    outputs.dedup_by(|next, last| *next - *last <= WRITTEN * *next);
    Schedule { outputs, ..schedule.clone() }
}

/// Keeps what readings are held against, and writes the results.
struct Recorder<'a> {
    folder: ResultFolder,
    quantities: &'a [Quantity],
    columns: &'a [&'a str],
    rows: Vec<Row>,
}

impl Observer for Recorder<'_> {
    fn observe(&mut self, report: &Report<'_>) -> Result<(), Box<dyn StdError + Send + Sync>> {
        let row = history::row(report);
        self.rows.push(Row {
            far: self.columns.iter().map(|column| history::number(&row, column)).collect(),
            values: self.quantities.iter().map(|own| own.value(report, &row)).collect(),
        });
        // Fields at both ends alone: places of readings are no outputs of the case.
        let progress = report.state.progress;
        let output = report.output && (progress == 0.0 || progress >= report.extent);
        self.folder.observe(&Report { output, ..*report })
    }
}
