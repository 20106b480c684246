//! What the command makes of result folders: pages, comparisons, pictures, numbers as they are written.

use std::path::PathBuf;

use archard::units::Scale;
use archard_case::output::Manifest;
use archard_cli::library::{self, Comparing, Numbers};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::away::{away, pool};

/// How a run is compared: columns of measured tables as "name=title", the body that was measured, whether profiles are level
/// and placed, and where what is in memory was written.
type Options = (Vec<String>, Option<String>, bool, PathBuf);

/// Does some work on a thread of its own.
fn done<T: Send + 'static>(
    py: Python<'_>,
    work: impl FnOnce() -> Result<T, String> + Send + 'static,
) -> PyResult<T> {
    away(py, &pool(Some(1))?, work).unless_interrupted()?.map_err(PyValueError::new_err)
}

fn comparing((columns, body, levelled, place): Options) -> Comparing {
    Comparing { columns, body, levelled, place: Some(place) }
}

/// Writes the page of a folder, next to measured tables and other runs; returns its file.
#[pyfunction]
pub fn page(
    py: Python<'_>,
    dir: PathBuf,
    others: Vec<PathBuf>,
    output: PathBuf,
    options: Options,
) -> PyResult<PathBuf> {
    done(py, move || library::page(&dir, &others, Some(output), comparing(options)))
}

/// What comes of a run next to measured tables and other runs: lines of words, and the picture as JSON.
#[pyfunction]
pub fn comparison(
    py: Python<'_>,
    dir: PathBuf,
    others: Vec<PathBuf>,
    options: Options,
) -> PyResult<(Vec<String>, String)> {
    let (words, picture) =
        done(py, move || library::comparison(&dir, &others, comparing(options)))?;
    Ok((words, picture.to_string()))
}

/// The pictures of a folder as JSON.
#[pyfunction]
pub fn pictures(py: Python<'_>, dir: PathBuf) -> PyResult<String> {
    done(py, move || library::pictures(&dir).map(|pictures| pictures.to_string()))
}

/// The numbers at the end of a run: a caption, heads and rows.
#[pyfunction]
pub fn numbers(py: Python<'_>, dir: PathBuf) -> PyResult<Numbers> {
    done(py, move || library::numbers(&dir))
}

/// Holds the files of a run that is done against the sums they were written with.
#[pyfunction]
pub fn verify(py: Python<'_>, dir: PathBuf) -> PyResult<()> {
    let known = move || Manifest::read(&dir).and_then(|known| known.verify());
    done(py, move || known().map_err(|error| error.to_string()))
}

/// Whether case files know the symbol of a unit.
#[pyfunction]
pub fn knows_unit(symbol: &str) -> bool {
    symbol.is_empty() || Scale::read_any(symbol).is_ok()
}

/// A value in SI as it is usually written.
#[pyfunction]
pub fn quantity(value: f64, unit: &str) -> String {
    library::quantity(value, unit)
}

/// Memory (bytes) that this process may still take.
#[pyfunction]
pub fn free_memory() -> f64 {
    archard_case::files::free_memory()
}
