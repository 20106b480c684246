//! Elastic bodies by themselves.

use std::path::PathBuf;
use std::time::Instant;

use archard_case::output::{self, Claim, Totals};
use archard_case::{Problem, Task};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::away::{away, pool};
use crate::case::{CaseFile, resolve};
use crate::run::{taken, unwritten};

pyo3::import_exception!(archard._errors, RunError);

/// Computes an elastic body by itself and writes its results into a folder.
#[pyfunction]
#[pyo3(signature = (file, folder, *, threads, force))]
pub fn solve_elastic(
    py: Python<'_>,
    file: &CaseFile,
    folder: PathBuf,
    threads: Option<usize>,
    force: bool,
) -> PyResult<()> {
    let (pool, file) = (pool(threads)?, file.0.clone());
    let threads = pool.current_num_threads();
    let work = move || -> Result<(), Unsolved> {
        let Task::Elastic(resolved) = resolve(&file).map_err(|_| Unsolved::Case)? else {
            return Err(Unsolved::Case);
        };
        let (case, case_toml) = (&resolved.case, resolved.case.to_string());
        let task = Task::Elastic(resolved.clone());
        let claim = Claim::take(&folder).map_err(Unsolved::Output)?.adding(task.files());
        let mut claim = if force { claim.adopting() } else { claim };
        if !force && claim.holds_another(|known| known == case_toml) {
            return Err(Unsolved::Taken(folder));
        }
        let begun = Instant::now();
        let body = case.build().map_err(|error| Unsolved::Body(error.to_string()))?;
        let deformed = body.solve().map_err(|error| Unsolved::Body(error.to_string()))?;
        let totals = Totals {
            seconds: begun.elapsed().as_secs_f64(),
            threads,
            warnings: resolved.warnings.iter().map(Problem::warning_of).collect(),
            failure: None,
            command: None,
        };
        output::write_elastic(&mut claim, &case_toml, (&body, &deformed), &totals)
            .map(|_| ())
            .map_err(Unsolved::Output)
    };
    let outcome = away(py, &pool, work).unless_interrupted()?;
    outcome.map_err(|unsolved| match unsolved {
        Unsolved::Case => PyValueError::new_err("not a case of one body by itself"),
        Unsolved::Taken(folder) => taken(&folder),
        Unsolved::Output(error) => unwritten(error),
        Unsolved::Body(message) => RunError::new_err(message),
    })
}

/// Why a body has no results.
enum Unsolved {
    Case,
    Taken(PathBuf),
    Output(output::Error),
    Body(String),
}
