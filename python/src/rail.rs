//! A wheel on a rail: contacts in any attitude, from a case that is read once.

use archard::parameters::Invalid;
use archard_case::output::contact_row;
use archard_case::{Prepared, RailError, Task};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::away::{away, pool};
use crate::case::{CaseFile, refused, resolve};

pyo3::import_exception!(archard._errors, RunError);

/// A patch: the side of the track, and values by the names of their columns, errors among them.
type Told = (String, Vec<(String, f64)>);

/// A wheel over its rail.
#[pyclass(frozen, module = "archard._archard")]
pub struct WheelRail(Prepared);

#[pymethods]
impl WheelRail {
    /// Of a case with `motion.wheel_rail`.
    #[new]
    fn new(py: Python<'_>, file: &CaseFile) -> PyResult<Self> {
        let file = file.0.clone();
        let work = move || resolve(&file);
        let task = away(py, &pool(None)?, work).unless_interrupted()?.map_err(refused)?;
        let Task::WheelRail(resolved) = task else {
            return Err(PyValueError::new_err(
                "not a case of a wheel on a rail: `motion.wheel_rail`",
            ));
        };
        let prepared = resolved.case.prepare();
        let prepared = prepared.map_err(|problem| PyValueError::new_err(problem.title()))?;
        Ok(Self(prepared))
    }

    /// The patches with some values (SI) of the motion in place of those of the case.
    fn contact(&self, py: Python<'_>, values: Vec<(String, f64)>) -> PyResult<Vec<Told>> {
        let mut state = self.0.running.state;
        for (name, value) in values {
            let wrong = |invalid: Invalid| PyValueError::new_err(invalid.message);
            state.set(&name, value).map_err(wrong)?;
        }
        let prepared = self.0.clone();
        let work = move || {
            prepared.contacts(&state).map_err(|error| match error {
                RailError::Invalid(invalid) => Wrong::Value(invalid.message),
                other => Wrong::Contact(other.to_string()),
            })
        };
        let contacts = away(py, &pool(Some(1))?, work).unless_interrupted()?;
        let contacts = contacts.map_err(|wrong| match wrong {
            Wrong::Value(message) => PyValueError::new_err(message),
            Wrong::Contact(message) => RunError::new_err(message),
        })?;
        let told = contacts.iter().flat_map(|contact| {
            let side = contact.side.name();
            contact.patches.iter().map(move |patch| (side.to_owned(), contact_row(patch)))
        });
        Ok(told.collect())
    }
}

/// Why there is no contact.
enum Wrong {
    Value(String),
    Contact(String),
}
