//! A wheel on a rail: contacts in any attitude, from a case that is read once.

use archard_case::output::contact_row;
use archard_case::{Prepared, RailError, Running, Task};
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
        let prepared = prepared.map_err(|invalid| PyValueError::new_err(invalid.message))?;
        Ok(Self(prepared))
    }

    /// The patches with some values (SI) of the motion in place of those of the case.
    fn contact(&self, py: Python<'_>, values: Vec<(String, f64)>) -> PyResult<Vec<Told>> {
        let mut running = self.0.running.clone();
        for (name, value) in values {
            put(&mut running, &name, value)?;
        }
        let prepared = self.0.clone();
        let work = move || {
            prepared.contacts(&running).map_err(|error| match error {
                RailError::Invalid(invalid) => Wrong::Value(invalid.message),
                RailError::Contact(error) => Wrong::Contact(error.to_string()),
            })
        };
        let contacts = away(py, &pool(Some(1))?, work).unless_interrupted()?;
        let contacts = contacts.map_err(|wrong| match wrong {
            Wrong::Value(message) => PyValueError::new_err(message),
            Wrong::Contact(message) => RunError::new_err(message),
        })?;
        let told = contacts.iter().flat_map(|contact| {
            contact.patches.iter().map(|patch| (contact.name().to_owned(), contact_row(patch)))
        });
        Ok(told.collect())
    }
}

/// Why there is no contact.
enum Wrong {
    Value(String),
    Contact(String),
}

/// Puts a value (SI) in the place of one of the case.
fn put(running: &mut Running, name: &str, value: f64) -> PyResult<()> {
    let Running { attitude, velocity, load, rolls, .. } = running;
    let place = match name {
        "wheel_load" => load,
        "shift" => &mut attitude.shift,
        "yaw" => &mut attitude.yaw,
        "roll" => {
            *rolls = true;
            &mut attitude.roll
        }
        "speed" => &mut velocity.forward,
        "lateral_speed" => &mut velocity.lateral,
        "vertical_speed" => &mut velocity.vertical,
        "pitch_rate" => &mut velocity.pitch,
        "yaw_rate" => &mut velocity.yaw,
        "roll_rate" => &mut velocity.roll,
        _ => return Err(PyValueError::new_err(format!("`{name}` is no value of the motion"))),
    };
    *place = value;
    Ok(())
}
