//! Runs that are stepped from Python, into a result folder.

use std::mem::replace;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Instant;

use archard::simulation::{self, Observer, Report, ResumeError, Simulation, row};
use archard_case::output::{self, Claim, Inside, InsideError, ResultFolder, Store, Totals};
use archard_case::verdict::Warning;
use archard_case::{Problem, Task};
use pyo3::exceptions::{PyFileExistsError, PyOSError, PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use rayon::ThreadPool;

use crate::away::{Outcome, away, pool};
use crate::build::{Laws, Samples, settled};
use crate::case::{CaseFile, refused, resolve};
use crate::fields::{Fields, Snapshot};
use crate::law::{Failed, Given, Stopped};

pyo3::import_exception!(archard._errors, NotConverged);
pyo3::import_exception!(archard._errors, RunError);

/// A run and its result folder.
#[pyclass(module = "archard._archard")]
pub struct Run {
    pool: ThreadPool,
    stage: Stage,
    inside: Option<Inside>,
    /// Until they are finished. A step that was left alone finds them gone.
    results: Results,
    failed: Failed,
    warnings: Vec<Warning>,
    doubts: Vec<String>,
    begun: Instant,
}

type Results = Arc<Mutex<Option<ResultFolder>>>;

/// How far a run is.
enum Stage {
    /// Before the initial contact.
    Built(Simulation),
    /// Before it goes on.
    Kept(Simulation, Vec<u8>),
    /// Under way.
    Going(simulation::Run),
    /// At the end of the motion.
    Ended(simulation::Run),
    /// Broken off.
    Gone,
}

/// Why a step did not come to its end.
pub(crate) enum Broken {
    Simulation(simulation::Error),
    NotResumed(ResumeError),
    Output(output::Error),
    /// A function in Python raised what waits in [`Failed`].
    Raised,
}

#[pymethods]
impl Run {
    /// Prepares a run in a folder.
    #[new]
    #[pyo3(signature = (file, folder, *, threads, resume, force, cache, laws, friction, remark))]
    #[allow(clippy::too_many_arguments)]
    fn new(
        py: Python<'_>,
        file: &CaseFile,
        folder: PathBuf,
        threads: Option<usize>,
        resume: bool,
        force: bool,
        cache: Option<PathBuf>,
        laws: Vec<Given>,
        friction: Option<Samples>,
        remark: &str,
    ) -> PyResult<Self> {
        let begun = Instant::now();
        let wide = pool(threads)?;
        let file = file.0.clone();
        let task = away(py, &wide, move || resolve(&file)).unless_interrupted()?;
        let Task::Contact(resolved) = task.map_err(refused)? else {
            let why =
                "a body by itself has no steps, and a wheel on a rail has none: `archard.rail`";
            return Err(PyValueError::new_err(why));
        };
        let failed = Failed::default();
        let laws = Laws { wear: laws, friction, failed: failed.clone() };
        laws.fit(&resolved.case)?;
        let case = &resolved.case;
        let inside = case.inside();
        let files = inside.files(case.bodies.each_ref().map(|body| body.name.as_str()));
        let claim = Claim::take(&folder).map_err(unwritten)?.adding(files);
        let claim = if force { claim.adopting() } else { claim };
        let is_its = |known: &str| {
            known.strip_prefix(remark).is_some_and(|known| resolved.is_printed(known))
        };
        if !resume && !force && claim.holds_another(is_its) {
            return Err(taken(&folder));
        }
        let kept = cache.clone().map(Store::new).or_else(Store::of_user);
        let (resolved, simulation, doubts) = match settled(py, &wide, *resolved, cache, laws) {
            Ok(settled) => settled,
            Err(error) => {
                claim.give_up();
                return Err(error);
            }
        };
        let case = &resolved.case;
        let pool = if threads.is_none() && case.is_small() { pool(Some(1))? } else { wide };
        let (results, stage) = if resume {
            let (results, kept) = claim.resume(&simulation).map_err(|error| match error {
                archard_case::output::Error::NotResumed { .. } => {
                    PyValueError::new_err(error.to_string())
                }
                error => unwritten(error),
            })?;
            (results, Stage::Kept(simulation, kept))
        } else {
            let claim = claim.until(case.until.clone());
            (claim.begin(&format!("{remark}{case}")).map_err(unwritten)?, Stage::Built(simulation))
        };
        let warnings = resolved.warnings.iter().map(Problem::warning_of);
        Ok(Self {
            pool,
            stage,
            inside: Some(inside.keeping(kept)),
            results: Arc::new(Mutex::new(Some(results))),
            failed,
            warnings: warnings.chain(doubts.iter().cloned().map(Warning::from)).collect(),
            doubts,
            begun,
        })
    }

    /// What is doubtful about kept compliances.
    #[getter]
    fn doubts(&self) -> Vec<String> {
        self.doubts.clone()
    }

    /// Number of threads.
    #[getter]
    fn threads(&self) -> usize {
        self.pool.current_num_threads()
    }

    /// Goes on to the next state, the initial contact first; `False` at the end of the motion.
    fn step(&mut self, py: Python<'_>) -> PyResult<bool> {
        let stage = replace(&mut self.stage, Stage::Gone);
        let mut inside = self.inside.take();
        let results = self.results.clone();
        let work = move || {
            let mut stage = stage;
            let outcome = guarded(|| advance(&mut stage, &results, inside.as_mut()));
            (stage, inside, outcome)
        };
        let ((stage, inside, outcome), signal) = match away(py, &self.pool, work) {
            Outcome::Done(done, signal) => (done, signal),
            Outcome::Left(signal) => return Err(signal),
        };
        self.inside = inside;
        match outcome {
            Ok(went) => {
                self.stage = stage;
                signal.map_or(Ok(went), Err)
            }
            Err(broken) => Err(self.error(broken)),
        }
    }

    /// Keeps the run where it is, to go on with later.
    fn keep(&self) -> PyResult<()> {
        let mut results = lock(&self.results);
        match (&self.stage, results.as_mut()) {
            (Stage::Going(run), Some(results)) => {
                results.keep_now(&run.report()).map_err(unwritten)
            }
            _ => Ok(()),
        }
    }

    /// The present state: the row of the history, places and fields.
    fn state<'py>(&self, py: Python<'py>) -> PyResult<(Vec<(String, f64)>, Fields<'py>)> {
        let run = self.run()?;
        let (row, fields) = py.detach(|| {
            self.pool.install(|| {
                let report = run.report();
                (row(&report), Snapshot::of(&report))
            })
        });
        Ok((row, fields.arrays(py)?))
    }

    /// Gives the run up; the file that is on its way is whole before it returns.
    fn close(&mut self, py: Python<'_>) {
        let (results, stage) = (self.results.clone(), replace(&mut self.stage, Stage::Gone));
        py.detach(move || drop((lock(&results).take(), stage)));
    }

    /// How far the motion has gone and goes, in its own unit.
    fn progress(&self) -> PyResult<(f64, f64)> {
        let report = self.run()?.report();
        Ok((report.state.progress, report.extent))
    }

    /// Finishes the results, of a run that came to its end or one that failed.
    #[pyo3(signature = (failure=None))]
    fn finish(&mut self, py: Python<'_>, failure: Option<String>) -> PyResult<()> {
        let Some(results) = lock(&self.results).take() else { return Ok(()) };
        let totals = Totals {
            seconds: results.seconds_before() + self.begun.elapsed().as_secs_f64(),
            threads: self.pool.current_num_threads(),
            warnings: self.warnings.clone(),
            failure,
            command: None,
        };
        let stage = replace(&mut self.stage, Stage::Gone);
        let inside = self.inside.take();
        let work = move || finish(results, totals, (stage, inside));
        // A step that was left alone may still hold the threads of the run.
        let threads = pool(Some(self.pool.current_num_threads()))?;
        let outcome = away(py, &threads, work).unless_interrupted()?;
        outcome.map_err(|error| match error {
            InsideError::Write(error) => unwritten(error),
            other => RunError::new_err(other.to_string()),
        })
    }
}

impl Run {
    fn run(&self) -> PyResult<&simulation::Run> {
        match &self.stage {
            Stage::Going(run) | Stage::Ended(run) => Ok(run),
            _ => {
                Err(PyRuntimeError::new_err("the run shows no state: it has not begun, or is over"))
            }
        }
    }

    fn error(&self, broken: Broken) -> PyErr {
        match broken {
            Broken::Raised => raised(&self.failed),
            Broken::Output(error @ output::Error::NotFinite { .. }) => {
                NotConverged::new_err(error.to_string())
            }
            Broken::Output(error) => unwritten(error),
            Broken::NotResumed(error) => PyValueError::new_err(error.to_string()),
            Broken::Simulation(error) if error.is_of_convergence() => {
                NotConverged::new_err(error.to_string())
            }
            Broken::Simulation(error) => RunError::new_err(error.to_string()),
        }
    }
}

/// Does something that a law in Python may break off.
pub(crate) fn guarded<T>(work: impl FnOnce() -> Result<T, Broken>) -> Result<T, Broken> {
    catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|panic| {
        if panic.is::<Stopped>() { Err(Broken::Raised) } else { resume_unwind(panic) }
    })
}

/// What a law in Python raised.
pub(crate) fn raised(failed: &Failed) -> PyErr {
    let mut failed = failed.lock().unwrap_or_else(PoisonError::into_inner);
    failed.take().unwrap_or_else(|| PyRuntimeError::new_err("a law raised nothing"))
}

/// Goes on to the next state and shows it; `false` at the end of the motion.
fn advance(
    stage: &mut Stage,
    results: &Results,
    inside: Option<&mut Inside>,
) -> Result<bool, Broken> {
    let (next, shown) = match replace(stage, Stage::Gone) {
        Stage::Built(simulation) => {
            let run = simulation::Run::begin(simulation).map_err(Broken::Simulation)?;
            (Stage::Going(run), Shown::New)
        }
        Stage::Kept(simulation, kept) => {
            let run = simulation::Run::resume(simulation, &kept).map_err(Broken::NotResumed)?;
            (Stage::Going(run), Shown::Again)
        }
        Stage::Going(run) if lock(results).as_ref().is_some_and(Observer::ends) => {
            (Stage::Ended(run), Shown::Nothing)
        }
        Stage::Going(mut run) => match run.step().map_err(Broken::Simulation)? {
            true => (Stage::Going(run), Shown::New),
            false => (Stage::Ended(run), Shown::Nothing),
        },
        other => (other, Shown::Nothing),
    };
    *stage = next;
    let (Stage::Going(run), again) = (&*stage, shown == Shown::Again) else { return Ok(false) };
    let report = Report { again, ..run.report() };
    if let Some(results) = lock(results).as_mut() {
        results.observe(&report).map_err(not_observed)?;
    }
    if let Some(inside) = inside {
        inside.observe(&report).map_err(not_observed)?;
    }
    Ok(true)
}

/// What there is to show after a step.
#[derive(PartialEq)]
enum Shown {
    New,
    /// A state that was shown before the run was interrupted.
    Again,
    Nothing,
}

/// Finishes results; stresses inside of bodies only where the run came to its end.
fn finish(
    mut results: ResultFolder,
    totals: Totals,
    (stage, inside): (Stage, Option<Inside>),
) -> Result<(), InsideError> {
    if let (Stage::Ended(run), Some(inside), None) = (&stage, inside, &totals.failure) {
        let stresses = inside.write(results.dir(), &run.simulation().problem)?;
        results.stressed(stresses);
    }
    results.finish(&totals)?;
    Ok(())
}

fn not_observed(error: Box<dyn std::error::Error + Send + Sync>) -> Broken {
    match error.downcast::<output::Error>() {
        Ok(error) => Broken::Output(*error),
        Err(error) => Broken::Simulation(simulation::Error::Observer(error)),
    }
}

pub(crate) fn unwritten(error: output::Error) -> PyErr {
    PyOSError::new_err(error.to_string())
}

fn lock(results: &Results) -> MutexGuard<'_, Option<ResultFolder>> {
    results.lock().unwrap_or_else(PoisonError::into_inner)
}

pub(crate) fn taken(folder: &Path) -> PyErr {
    PyFileExistsError::new_err(format!(
        "`{}` holds another case or its results; choose another folder, or replace them with force=True",
        folder.display()
    ))
}
