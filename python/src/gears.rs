//! Two bodies that touch along a line which passes: gears in mesh, and a cam with its follower.

use archard_case::Task;
use archard_case::output::Rows;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::away::{away, pool};
use crate::case::{CaseFile, refused, resolve};

/// Rows of the files of results, and the body that reaches its limit first with the error of the passages.
type Worn = (Vec<Rows>, Option<(String, f64)>);

/// Solves a case, away from Python.
fn worn(
    py: Python<'_>,
    file: &CaseFile,
    solve: impl FnOnce(Task) -> Option<Result<Worn, String>> + Send + 'static,
    other: &'static str,
) -> PyResult<Worn> {
    let file = file.0.clone();
    let task = away(py, &pool(None)?, move || resolve(&file)).unless_interrupted()?;
    let task = task.map_err(refused)?;
    let solved = away(py, &pool(Some(1))?, move || solve(task)).unless_interrupted()?;
    let solved = solved.ok_or_else(|| PyValueError::new_err(other))?;
    solved.map_err(PyValueError::new_err)
}

/// The flanks of a case with `motion.mesh`, and their course.
#[pyfunction]
pub fn wear_gears(py: Python<'_>, file: &CaseFile) -> PyResult<Worn> {
    let solve = |task: Task| {
        let Task::Gear(resolved) = task else { return None };
        Some(resolved.case.solve().map_err(|problem| problem.title()).map(|results| {
            let life = results.worn.life;
            let life = life.map(|(limit, error)| (results.names[limit.body].clone(), error));
            (vec![results.flanks(), results.course()], life)
        }))
    };
    worn(py, file, solve, "not a case of two gears: `motion.mesh`")
}

/// The cam and the follower of a case with `motion.cam`, and their course.
#[pyfunction]
pub fn wear_cam(py: Python<'_>, file: &CaseFile) -> PyResult<Worn> {
    let solve = |task: Task| {
        let Task::Cam(resolved) = task else { return None };
        Some(resolved.case.solve().map_err(|problem| problem.title()).map(|results| {
            let life = results.worn.life;
            let life = life.map(|(limit, error)| (results.names[limit.body].clone(), error));
            (vec![results.around(), results.face(), results.course()], life)
        }))
    };
    worn(py, file, solve, "not a case of a cam: `motion.cam`")
}
