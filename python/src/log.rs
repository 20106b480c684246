//! Logs of tribometers.

use std::path::PathBuf;

use archard_case::files::{self, Contents};
use archard_log::{Log, Options};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// Names and what they are set to.
type Pairs = Vec<(String, String)>;

/// What a log gives, as JSON in SI; `columns` by role, `values` by name.
#[pyfunction]
pub fn read_log(py: Python<'_>, file: PathBuf, columns: Pairs, values: Pairs) -> PyResult<String> {
    let read = py.detach(|| {
        let bytes = files::read(&file, Contents::Numbers)
            .map_err(|error| format!("cannot read `{}`: {error}", file.display()))?;
        let options = Options { columns, values, profile: false };
        Log::read(&file.display().to_string(), &bytes, &options).map_err(|error| error.to_string())
    });
    Ok(read.map_err(PyValueError::new_err)?.json().to_string())
}
