//! Two gears in mesh.

use archard_case::Task;
use archard_case::output::GearResults;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::away::{away, pool};
use crate::case::{CaseFile, refused, resolve};

/// Rows by the names of columns.
type Rows = Vec<Vec<(String, f64)>>;
/// Rows of the flanks, rows of the course, and the gear that reaches its limit first with the error of the meshes.
type Worn = (Rows, Rows, Option<(String, f64)>);

/// The flanks of a case with `motion.mesh`.
#[pyfunction]
pub fn wear_gears(py: Python<'_>, file: &CaseFile) -> PyResult<Worn> {
    let file = file.0.clone();
    let task = away(py, &pool(None)?, move || resolve(&file)).unless_interrupted()?;
    let Task::Gear(resolved) = task.map_err(refused)? else {
        return Err(PyValueError::new_err("not a case of two gears: `motion.mesh`"));
    };
    let work = move || resolved.case.solve().map_err(|problem| problem.title());
    let results = away(py, &pool(Some(1))?, work).unless_interrupted()?;
    let results = results.map_err(PyValueError::new_err)?;
    let GearResults { names, worn, .. } = &results;
    let life = worn.life.map(|(limit, error)| (names[limit.body].clone(), error));
    Ok((results.flanks(), results.course(), life))
}
