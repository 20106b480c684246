//! One contact of a case, solved once.

use std::sync::{Arc, OnceLock};

use archard::Contact;
use archard::elastic::{Point, PressedHalfSpace};
use archard::motion::Motion;
use archard::simulation::{Derivative, Error};
use archard_case::Task;
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::away::{away, pool};
use crate::case::{CaseFile, refused, resolve};

pyo3::import_exception!(archard._errors, RunError);

type Field<'py> = Bound<'py, PyArray1<f64>>;
type Field2<'py> = Bound<'py, PyArray2<f64>>;

/// Elements along x and y of a grid; `x`, `y`, `pressure`, `gap` and, with friction, `traction_x` and `traction_y`, one value a
/// pair; `approach`, `load`, `area`, `force_x` and `force_y`, all in SI; and both bodies below their surfaces.
type Solved<'py> =
    (Option<[usize; 2]>, Vec<(&'static str, Field<'py>)>, Vec<(&'static str, f64)>, Vec<Inside>);

/// A body of a contact below its surface.
#[pyclass(frozen, module = "archard._archard")]
pub struct Inside {
    /// The user's name for it.
    #[pyo3(get)]
    name: String,
    contact: Arc<Contact>,
    body: usize,
    /// Found where it is asked for: of a body of finite shape that takes equations of their own.
    pressed: OnceLock<Result<PressedHalfSpace, String>>,
}

#[pymethods]
impl Inside {
    /// Stresses (Pa) at places (m), six a place.
    fn at<'py>(&self, py: Python<'py>, places: Vec<[f64; 3]>) -> PyResult<Field2<'py>> {
        let pressed = self.pressed(py)?;
        let point = |(number, place)| Point { name: format!("{number}"), place };
        let points: Vec<Point> = places.into_iter().enumerate().map(point).collect();
        let found = py.detach(|| pressed.points(&points));
        let found = found.map_err(|error| PyValueError::new_err(error.to_string()))?;
        let components = found.iter().flat_map(|own| {
            let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = own.stress;
            [xx, yy, zz, xy, xz, yz]
        });
        PyArray1::from_vec(py, components.collect()).reshape([found.len(), 6])
    }

    /// Stresses (Pa) at a depth (m) below all pairs, six times as many.
    fn plane<'py>(&self, py: Python<'py>, depth: f64) -> PyResult<Field<'py>> {
        let pressed = self.pressed(py)?;
        pressed.check(&[depth]).map_err(|error| PyValueError::new_err(error.to_string()))?;
        let plane = py.detach(|| pressed.plane(depth, &[0.0; 6]));
        Ok(PyArray1::from_vec(py, plane.concat()))
    }
}

/// A derivative: of the pressure (Pa over a unit), one value a pair, and of the approach (m over it); `None` where it is not known.
type Slope<'py> = Option<(Field<'py>, f64)>;

fn slope<'py>(
    py: Python<'py>,
    find: impl Send + FnOnce() -> Result<Option<Derivative>, Error>,
) -> PyResult<Slope<'py>> {
    let found = py.detach(find).map_err(|error| RunError::new_err(error.to_string()))?;
    Ok(found.map(|own| (PyArray1::from_vec(py, own.pressure), own.approach)))
}

/// The derivative of a contact by its load (N).
#[pyfunction]
pub fn by_load<'py>(py: Python<'py>, inside: &Inside) -> PyResult<Slope<'py>> {
    slope(py, || inside.contact.by_load())
}

/// The derivative of a contact by what changes its gap by those values (m over its unit), one a pair.
#[pyfunction]
pub fn by_shape<'py>(py: Python<'py>, inside: &Inside, gap: Vec<f64>) -> PyResult<Slope<'py>> {
    slope(py, || inside.contact.by_shape(&gap))
}

impl Inside {
    fn pressed(&self, py: Python<'_>) -> PyResult<&PressedHalfSpace> {
        let find = || self.contact.below(self.body).map_err(|error| error.to_string());
        let found = py.detach(|| self.pressed.get_or_init(find));
        found.as_ref().map_err(|why| PyValueError::new_err(why.clone()))
    }
}

/// Why there is no contact.
enum Unsolved {
    Case(Vec<crate::case::ProblemParts>),
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
    let contact = Arc::new(contact);
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
    let inside = [0, 1].map(|body| Inside {
        name: contact.problem().bodies[body].name.clone(),
        contact: Arc::clone(&contact),
        body,
        pressed: OnceLock::new(),
    });
    Ok((frame.is_uniform().then(|| frame.elements()), fields.collect(), values, inside.into()))
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
