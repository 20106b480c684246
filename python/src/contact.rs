//! One contact of a case, solved once.

use archard::Contact;
use archard::motion::Motion;
use archard_case::Task;
use numpy::PyArray1;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::away::{away, pool};
use crate::case::{CaseFile, refused, resolve};

pyo3::import_exception!(archard._errors, RunError);

type Field<'py> = Bound<'py, PyArray1<f64>>;

/// Elements along x and y of a grid; `x`, `y`, `pressure`, `gap` and, with friction, `traction_x` and `traction_y`, one value a
/// pair; and `approach`, `load`, `area`, `force_x` and `force_y`, all in SI.
type Solved<'py> = (Option<[usize; 2]>, Vec<(&'static str, Field<'py>)>, Vec<(&'static str, f64)>);

/// Why there is no contact.
enum Unsolved {
    Case(Vec<crate::case::Told>),
    Other(&'static str),
    Run(String),
}

/// The contact of a case before any wear: rolling or shifted where its motion does so from the beginning, pressed together by its
/// load or approach otherwise.
#[pyfunction]
pub fn solve_contact<'py>(py: Python<'py>, file: &CaseFile) -> PyResult<Solved<'py>> {
    let file = file.0.clone();
    let work = move || match resolve(&file).map_err(Unsolved::Case)? {
        Task::Contact(resolved) => solve(resolved.case.build().map_err(said)?),
        _ => Err(Unsolved::Other("not a case of two bodies in contact")),
    };
    let contact = away(py, &pool(None)?, work).unless_interrupted()?;
    let contact = contact.map_err(|why| match why {
        Unsolved::Case(problems) => refused(problems),
        Unsolved::Other(message) => PyValueError::new_err(message),
        Unsolved::Run(message) => RunError::new_err(message),
    })?;
    let frame = &contact.problem().frame;
    let place = |axis: usize| (0..frame.len()).map(|pair| frame.place(pair)[axis]).collect();
    let mut fields = vec![
        ("x", place(0)),
        ("y", place(1)),
        ("pressure", contact.pressure().to_vec()),
        ("gap", contact.gap()),
    ];
    if let Some([x, y]) = contact.traction() {
        fields.extend([("traction_x", x.clone()), ("traction_y", y.clone())]);
    }
    let [x, y] = contact.force();
    let values = vec![
        ("approach", contact.approach()),
        ("load", contact.load()),
        ("area", contact.area()),
        ("force_x", x),
        ("force_y", y),
    ];
    let fields = fields.into_iter().map(|(name, field)| (name, PyArray1::from_vec(py, field)));
    Ok((frame.is_uniform().then(|| frame.elements()), fields.collect(), values))
}

fn solve(mut simulation: archard::Simulation) -> Result<Contact, Unsolved> {
    if simulation.schedule.ramped {
        if simulation.problem.friction.is_some() {
            return Err(Unsolved::Other(
                "friction depends on the way to this load: run the case, or leave out its `friction`",
            ));
        }
        let pressed = Motion::pressed(simulation.schedule.control).map_err(said)?;
        (simulation.problem.motion, simulation.schedule) = pressed;
    }
    if simulation.problem.motion.increments().is_some() {
        // The way to the first cycle would rub.
        simulation.problem.bodies.iter_mut().for_each(|body| body.wear = None);
    }
    Contact::at_first(simulation).map_err(said)
}

fn said(error: impl std::fmt::Display) -> Unsolved {
    Unsolved::Run(error.to_string())
}
