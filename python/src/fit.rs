//! Fits of cases to measured tests.

use std::error::Error as StdError;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use archard::simulation::{Observer, Report};
use archard_case::measured::Table;
use archard_case::measured::surface::Surface;
use archard_case::output::Store;
use archard_lab::{Files, Request, RunFollower, fit as fit_case, next_test, together};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::away::{away, pool};
use crate::case::CaseFile;

pyo3::import_exception!(archard._errors, NotConverged);

/// Ends the runs once nobody waits for them any more.
pub(crate) struct Waited(pub(crate) Arc<AtomicBool>);

impl Observer for Waited {
    fn observe(&mut self, _: &Report<'_>) -> Result<(), Box<dyn StdError + Send + Sync>> {
        if self.0.load(Ordering::Relaxed) { Err("interrupted".into()) } else { Ok(()) }
    }
}

impl RunFollower for Waited {
    fn begins(&mut self, _: usize, _: &str) {}

    fn ended(&mut self, _: usize, _: &str, _: Option<f64>) {}

    fn observer(&mut self) -> &mut dyn Observer {
        self
    }

    fn stops(&mut self) -> Option<Box<dyn StdError + Send + Sync>> {
        self.0.load(Ordering::Relaxed).then(|| "interrupted".into())
    }
}

/// A fit as JSON, in words and as CSV, by what is uncertain and what is assumed; runs go into the folder.
#[pyfunction]
pub fn fit(
    py: Python<'_>,
    case: &CaseFile,
    table: (String, Vec<u8>, PathBuf),
    columns: Vec<(String, String)>,
    parameters: Vec<String>,
    told: (Vec<(String, f64)>, Vec<String>),
    dir: PathBuf,
) -> PyResult<(String, String, String)> {
    let (file, (name, data, folder), (uncertain, assumed)) = (case.0.clone(), table, told);
    let left = Arc::new(AtomicBool::new(false));
    let mut following = Waited(left.clone());
    let work = move || {
        let names = columns.iter().map(|(name, title)| (name.as_str(), title.as_str()));
        let (of_files, names): (Vec<_>, Vec<_>) =
            names.partition(|(name, _)| Surface::has_column(name));
        let wrong = |error: String| (false, error);
        let table = Table::read(&name, &data).and_then(|table| table.naming(&names));
        let table = table.map_err(|error| wrong(error.to_string()))?;
        let store = Store::of_user();
        let request = Request {
            parameters: &parameters,
            uncertain: &uncertain,
            assumed: &assumed,
            files: Files { folder: &folder, columns: &of_files },
            dir: &dir,
            store: store.as_ref(),
            following: &mut following,
        };
        let found = fit_case(&file, &table, request);
        let found = found.map_err(|error| (error.is_of_convergence(), error.to_string()))?;
        Ok((found.json().to_string(), found.to_string(), found.csv()))
    };
    let outcome = away(py, &pool(None)?, work).unless_interrupted();
    left.store(true, Ordering::Relaxed);
    outcome?.map_err(|(convergence, why): (bool, String)| {
        if convergence { NotConverged::new_err(why) } else { PyValueError::new_err(why) }
    })
}

/// Coefficients of the next tests, each by its median, the scale of its logarithm and its degrees of freedom: a row for each
/// point, whose coordinates lie between zero and one. The first two go together.
#[pyfunction]
pub fn next_tests(
    coefficients: Vec<[f64; 3]>,
    correlation: f64,
    points: Vec<Vec<f64>>,
) -> Vec<Vec<f64>> {
    let row = |mut point: Vec<f64>| {
        if let [one, other, ..] = &mut point[..] {
            *other = together([*one, *other], correlation);
        }
        let all = coefficients.iter().zip(point);
        all.map(|(own, share)| next_test(*own, share)).collect()
    };
    points.into_iter().map(row).collect()
}
