//! Fits of cases to measured tests.

use std::path::PathBuf;

use archard::fit::{Request, fit as fit_case};
use archard::measured::Table;
use archard::output::Store;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::away::{away, pool};
use crate::case::CaseFile;

pyo3::import_exception!(archard._errors, NotConverged);

/// A fit as JSON, in words and as CSV; runs go into the folder.
#[pyfunction]
pub fn fit(
    py: Python<'_>,
    case: &CaseFile,
    table: (String, Vec<u8>),
    columns: Vec<(String, String)>,
    parameter: Option<String>,
    uncertain: Vec<(String, f64)>,
    dir: PathBuf,
) -> PyResult<(String, String, String)> {
    let (file, (name, data)) = (case.0.clone(), table);
    let work = move || {
        let names: Vec<(&str, &str)> =
            columns.iter().map(|(name, title)| (name.as_str(), title.as_str())).collect();
        let wrong = |error: String| (false, error);
        let table = Table::read(&name, &data).and_then(|table| table.naming(&names));
        let table = table.map_err(|error| wrong(error.to_string()))?;
        let store = Store::of_user();
        let request = Request {
            parameter: parameter.as_deref(),
            uncertain: &uncertain,
            dir: &dir,
            store: store.as_ref(),
            tell: &mut |_| {},
        };
        let found = fit_case(&file, &table, request);
        let found = found.map_err(|error| (error.is_of_convergence(), error.to_string()))?;
        Ok((found.json().to_string(), found.to_string(), found.csv()))
    };
    away(py, &pool(None)?, work).unless_interrupted()?.map_err(
        |(convergence, why): (bool, String)| {
            if convergence { NotConverged::new_err(why) } else { PyValueError::new_err(why) }
        },
    )
}
