//! A wheel on a rail: contacts in any attitude, from a case that is read once.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use archard::parameters::Invalid;
use archard_case::output::{RailWear, contact_row};
use archard_case::{PreparedContact, RailError, Task};
use archard_rail::wear::Step;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::away::{away, pool};
use crate::case::{CaseFile, refused, resolve};

pyo3::import_exception!(archard._errors, RunError);

/// A patch: the side of the track, and values by the names of their columns, errors among them.
type Told = (String, Vec<(String, f64)>);

/// A wheel over its rail.
#[pyclass(frozen, module = "archard._archard")]
pub struct WheelRail(PreparedContact);

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
        let work = move || prepared.contacts(&state).map_err(wrong);
        let contacts = away(py, &pool(Some(1))?, work).unless_interrupted()?;
        let contacts = contacts.map_err(raised)?;
        let told = contacts.iter().flat_map(|contact| {
            let side = contact.side.name();
            contact.patches.iter().map(move |patch| (side.to_owned(), contact_row(patch)))
        });
        Ok(told.collect())
    }

    /// The contacts at all points of the route and what wears over it; a route in columns (SI) counts in the place of that of the
    /// case.
    fn travel(
        &self,
        py: Python<'_>,
        route: Option<Columns>,
        threads: Option<usize>,
    ) -> PyResult<RouteResult> {
        let mut prepared = self.0.clone();
        if let Some(route) = route {
            prepared.running.route = route;
            prepared.running.within = None;
        }
        let stop = Arc::new(AtomicBool::new(false));
        let stopped = stop.clone();
        let work = move || {
            let watch = |_, _: &Step<'_>| match stopped.load(Ordering::Relaxed) {
                true => ControlFlow::Break(()),
                false => ControlFlow::Continue(()),
            };
            prepared.solve(watch).map_err(wrong)
        };
        let outcome = away(py, &pool(threads)?, work);
        stop.store(true, Ordering::Relaxed);
        let results = outcome.unless_interrupted()?.map_err(raised)?;
        let contacts = results.contacts.iter().flat_map(|contact| {
            let at = contact.at.map(|at| (at.point, at.worn));
            let side = contact.side.name();
            contact.patches.iter().map(move |patch| (at, (side.to_owned(), contact_row(patch))))
        });
        let wear = results.wear.as_ref();
        let rows = wear.into_iter().flat_map(RailWear::rows);
        let rows = rows.map(|(side, row)| (side.name().to_owned(), row));
        let profiles = wear.into_iter().flat_map(RailWear::profile_wear).map(|one| {
            let columns = one.columns.into_iter();
            let columns = columns.map(|(name, values)| (name.to_owned(), values)).collect();
            (one.body.to_owned(), one.side.name().to_owned(), columns)
        });
        Ok((contacts.collect(), rows.collect(), profiles.collect()))
    }
}

/// Why there is no contact, and whether a value is to blame.
type Wrong = (bool, String);

fn wrong(error: RailError) -> Wrong {
    match error {
        RailError::Invalid(invalid) => (true, invalid.message),
        other => (other.is_of_a_value(), other.to_string()),
    }
}

fn raised((value, message): Wrong) -> PyErr {
    if value { PyValueError::new_err(message) } else { RunError::new_err(message) }
}

/// A row by the names of columns.
type Row = Vec<(String, f64)>;

/// What a route came to: contacts with the point and whether its profiles are worn, rows a step by side, and profiles with their body
/// and side.
type RouteResult =
    (Vec<(Option<(usize, bool)>, Told)>, Vec<(String, Row)>, Vec<(String, String, Columns)>);

/// Columns of a profile.
type Columns = Vec<(String, Vec<f64>)>;
