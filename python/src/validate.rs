//! Measured tests next to what is predicted of them.

use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use archard_case::output::Store;
use archard_lab::validate::{Set, validate as validate_set};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::away::{away, pool};
use crate::fit::{NotConverged, Waited};

/// What came of each set in a folder, as JSON and in words; runs go into another folder.
#[pyfunction]
pub fn validate(py: Python<'_>, folder: PathBuf, dir: PathBuf) -> PyResult<Vec<(String, String)>> {
    let left = Arc::new(AtomicBool::new(false));
    let mut following = Waited(left.clone());
    let work = move || {
        let store = Store::of_user();
        let sets = Set::all(&folder).map_err(|why| (false, why))?;
        let mut all = vec![];
        for (at, set) in sets.iter().enumerate() {
            let found =
                validate_set(set, (&dir.join(at.to_string()), store.as_ref()), &mut following);
            let found = found.map_err(|error| (error.is_of_convergence(), error.to_string()))?;
            all.push((found.json().to_string(), found.to_string()));
        }
        Ok(all)
    };
    let outcome = away(py, &pool(None)?, work).unless_interrupted();
    left.store(true, Ordering::Relaxed);
    outcome?.map_err(|(convergence, why): (bool, String)| {
        if convergence { NotConverged::new_err(why) } else { PyValueError::new_err(why) }
    })
}
