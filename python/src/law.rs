//! A wear law as a function in Python, which takes whole columns.

use std::fmt;
use std::panic::resume_unwind;
use std::sync::{Arc, Mutex, PoisonError};

use archard::problem::ContactProblem;
use archard::wear::{Columns, Input, Per, Rubbing, WearLaw};
use numpy::{PyArray1, PyArrayMethods, PyReadonlyArray1, PyUntypedArrayMethods};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

/// The columns a function may name, as formulas do, and what each asks for.
const COLUMNS: &[(&str, Input)] = &[
    ("work", Input::Friction),
    ("mu", Input::Friction),
    ("v", Input::Speed),
    ("distance", Input::Distance),
    ("worn", Input::Depth),
    ("rolled", Input::Rolled),
    ("temperature", Input::Temperature),
    ("cs", Input::CrossShear),
    ("slip_vector", Input::Vectors),
    ("traction", Input::Vectors),
];

/// How far a slope may fall below zero by rounding, relative to depth over pressure.
const ROUNDING: f64 = 1e-6;

/// What a function is unwound by when it has failed; the error waits in [`Failed`].
pub struct Stopped;

/// Where the error of a function waits for those who asked for the step.
pub type Failed = Arc<Mutex<Option<PyErr>>>;

/// A function as it is handed over: the body, the function, what it is called, the columns it names (all there are if
/// not given), and whether it takes a whole cycle at once.
pub type Given = (String, Py<PyAny>, String, Option<Vec<String>>, bool);

/// A wear law in Python.
pub struct Law {
    body: String,
    function: Py<PyAny>,
    name: String,
    columns: Vec<&'static (&'static str, Input)>,
    inputs: Vec<Input>,
    per: Per,
    failed: Failed,
}

/// What a function makes of columns.
struct Returned {
    depth: Vec<f64>,
    slope: Option<Vec<f64>>,
}

impl Law {
    /// The law of a function on the body of that name in a problem.
    pub fn new(problem: &ContactProblem, given: Given, failed: &Failed) -> PyResult<Self> {
        let (body, function, name, named, cycle) = given;
        let there = |input: Input| match input {
            Input::Friction => problem.friction.is_some(),
            Input::Speed => problem.motion.speed.is_some(),
            Input::Rolled => problem.motion.driven(0.0).is_some(),
            // By name only: slow contacts are refused then.
            Input::Temperature => false,
            Input::CrossShear => cycle,
            _ => true,
        };
        let find = |name: &String| {
            COLUMNS.iter().find(|column| column.0 == name).ok_or_else(|| {
                let known: Vec<&str> = COLUMNS.iter().map(|column| column.0).collect();
                let known = known.join(", ");
                PyTypeError::new_err(format!(
                    "the wear law of `{body}` takes `{name}`; after pressure and slip it may take {known}"
                ))
            })
        };
        let columns: Vec<_> = match named {
            Some(named) => named.iter().map(find).collect::<PyResult<_>>()?,
            None => COLUMNS.iter().filter(|column| there(column.1)).collect(),
        };
        let mut inputs: Vec<Input> = vec![];
        for (_, input) in &columns {
            if !inputs.contains(input) {
                inputs.push(*input);
            }
        }
        let per = if cycle { Per::Cycle } else { Per::Increment };
        Ok(Self { body, function, name, columns, inputs, per, failed: failed.clone() })
    }

    /// Does something in Python; what is raised there ends the run.
    fn attached<T>(&self, work: impl FnOnce(Python<'_>) -> PyResult<T>) -> T {
        match Python::attach(work) {
            Ok(value) => value,
            Err(error) => {
                let mut failed = self.failed.lock().unwrap_or_else(PoisonError::into_inner);
                failed.get_or_insert(error);
                drop(failed);
                resume_unwind(Box::new(Stopped))
            }
        }
    }

    /// What the function makes of columns: depths, and slopes if it gives them.
    fn call(&self, py: Python<'_>, points: &Columns) -> PyResult<Returned> {
        let array = |values: &[f64]| PyArray1::from_slice(py, values);
        let columns = PyDict::new(py);
        for (name, _) in &self.columns {
            let values = match *name {
                "work" => array(&points.work).into_any(),
                "mu" => array(&coefficients(points)).into_any(),
                "v" => array(&points.speed).into_any(),
                "distance" => array(&points.distance).into_any(),
                "worn" => array(&points.depth).into_any(),
                "rolled" => array(&points.rolled).into_any(),
                "temperature" => array(&points.temperature).into_any(),
                "cs" => array(&points.cross_shear).into_any(),
                "slip_vector" => pair(py, &points.slip_vector)?,
                _ => pair(py, &points.traction)?,
            };
            columns.set_item(name, values)?;
        }
        let (pressure, slip) = (array(&points.pressure), array(&points.slip));
        let returned = self.function.bind(py).call((pressure, slip), Some(&columns))?;
        let values = |own: &Bound<'_, PyAny>, what| self.values(py, own, what, points.len());
        match returned.cast::<PyTuple>() {
            Ok(both) if both.len() == 2 => {
                let depth = values(&both.get_item(0)?, "depth")?;
                let slope = Some(values(&both.get_item(1)?, "slope")?);
                Ok(Returned { depth, slope })
            }
            Ok(other) => Err(PyValueError::new_err(format!(
                "{self} returned {} values; return the depth (m), or the depth and its slope (m/Pa)",
                other.len()
            ))),
            Err(_) => Ok(Returned { depth: values(&returned, "depth")?, slope: None }),
        }
    }

    /// The numbers of an array, one a point.
    fn values(
        &self,
        py: Python<'_>,
        returned: &Bound<'_, PyAny>,
        what: &str,
        points: usize,
    ) -> PyResult<Vec<f64>> {
        let numpy = py.import("numpy")?;
        if numpy.getattr("ma")?.call_method1("is_masked", (returned,))?.is_truthy()? {
            return Err(PyValueError::new_err(format!(
                "{self} returned a {what} with masked points, which have no value; fill them, as by `.filled(0.0)`"
            )));
        }
        // A list is gone through once.
        let plain = numpy.call_method1("asarray", (returned,))?;
        let kind = plain.getattr("dtype")?;
        self.refuse_coarse(&kind)?;
        let numbers = || {
            if kind.getattr("kind")?.eq("c")? {
                return Err(PyTypeError::new_err(format!("they are {kind}")));
            }
            numpy.call_method1("asarray", (&plain, "float64"))
        };
        let array = numbers().map_err(|error| {
            PyValueError::new_err(format!(
                "{self} returned a {what} of other than numbers: {}",
                error.value(py)
            ))
        })?;
        let array = array.extract::<PyReadonlyArray1<'_, f64>>().ok();
        let Some(array) = array.filter(|array| array.len() == points) else {
            let shape = plain.getattr("shape")?;
            return Err(PyValueError::new_err(format!(
                "{self} returned a {what} of shape {shape}; one value a point has shape ({points},)"
            )));
        };
        Ok(array.as_array().to_vec())
    }

    /// Refuses numbers that round more coarsely than steps of wear have to agree.
    fn refuse_coarse(&self, kind: &Bound<'_, PyAny>) -> PyResult<()> {
        if kind.getattr("kind")?.eq("f")? && kind.getattr("itemsize")?.lt(size_of::<f64>())? {
            return Err(PyTypeError::new_err(format!(
                "{self} returned {kind}: steps of wear agree to 1e-9, finer than that rounds; compute and return float64 (of JAX by jax.config.update(\"jax_enable_x64\", True))"
            )));
        }
        Ok(())
    }

    /// Depths, and slopes where they are asked for.
    fn evaluate(
        &self,
        py: Python<'_>,
        points: &Columns,
        depths: &mut [f64],
        slopes: Option<&mut [f64]>,
    ) -> PyResult<()> {
        let Returned { depth, slope } = self.call(py, points)?;
        depths.copy_from_slice(&depth);
        self.hold(points, "depth", depths, |_| 0.0)?;
        let Some(slopes) = slopes else { return Ok(()) };
        slopes.copy_from_slice(&match slope {
            Some(slope) => slope,
            None => self.difference(py, points)?,
        });
        let least = |point: usize| match points.pressure[point] {
            pressure if pressure > 0.0 => ROUNDING * depths[point] / pressure,
            _ => 0.0,
        };
        self.hold(points, "slope", slopes, least)?;
        slopes.iter_mut().for_each(|slope| *slope = slope.max(0.0));
        Ok(())
    }

    /// Slopes by a central difference, as of any law that does not tell its own: over the cube root of the rounding, where the
    /// errors by rounding and by the length are equal.
    fn difference(&self, py: Python<'_>, points: &Columns) -> PyResult<Vec<f64>> {
        let change = |point: usize| f64::EPSILON.cbrt() * points.pressure[point].max(1.0);
        let moved = |sign: f64| {
            let all = 0..points.len();
            let at = all.map(|point| {
                let pressure = points.pressure[point] + sign * change(point);
                points.at(point).under(pressure.max(0.0))
            });
            Columns::of(at, &self.inputs)
        };
        let [low, high] = [-1.0, 1.0].map(moved);
        let [below, above] = [self.call(py, &low)?, self.call(py, &high)?];
        let depths = below.depth.iter().zip(&above.depth);
        let pressures = low.pressure.iter().zip(&high.pressure);
        let slope = |((below, above), (low, high)): ((&f64, &f64), (&f64, &f64))| {
            (above - below) / (high - low)
        };
        Ok(depths.zip(pressures).map(slope).collect())
    }

    /// Refuses numbers that no law may return, with the first point where there is one.
    fn hold(
        &self,
        points: &Columns,
        what: &str,
        values: &[f64],
        below: impl Fn(usize) -> f64,
    ) -> PyResult<()> {
        let wrong = |&point: &usize| {
            let value = values[point];
            !value.is_finite() || value < -below(point)
        };
        let Some(point) = (0..values.len()).find(wrong) else { return Ok(()) };
        let Rubbing { pressure, slip, .. } = points.at(point);
        let unit = if what == "depth" { "m" } else { "m/Pa" };
        Err(PyValueError::new_err(format!(
            "{self} returned a {what} of {:e} {unit} at a pressure of {pressure:e} Pa and a slip of {slip:e} m; it has to be finite and not negative",
            values[point]
        )))
    }
}

/// Coefficients of friction: the work over pressure and slip, the slope of the limit where none exists.
fn coefficients(points: &Columns) -> Vec<f64> {
    let coefficient = |point: usize| {
        let point = points.at(point);
        if point.pressure * point.slip > 0.0 { point.coefficient() } else { point.friction }
    };
    (0..points.len()).map(coefficient).collect()
}

/// Two components, in an array with a row for each.
fn pair<'py>(py: Python<'py>, [x, y]: &[Vec<f64>; 2]) -> PyResult<Bound<'py, PyAny>> {
    let both = PyArray1::from_vec(py, [x.as_slice(), y.as_slice()].concat());
    Ok(both.reshape([2, x.len()])?.into_any())
}

impl WearLaw for Law {
    fn inputs(&self) -> &[Input] {
        &self.inputs
    }

    fn per(&self) -> Per {
        self.per
    }

    fn depth(&self, rubbing: Rubbing) -> f64 {
        let (points, mut depth) = (Columns::of([rubbing], &self.inputs), [0.0]);
        self.attached(|py| self.evaluate(py, &points, &mut depth, None));
        depth[0]
    }

    fn slope(&self, rubbing: Rubbing) -> f64 {
        let (points, mut depth, mut slope) = (Columns::of([rubbing], &self.inputs), [0.0], [0.0]);
        self.attached(|py| self.evaluate(py, &points, &mut depth, Some(&mut slope)));
        slope[0]
    }

    fn depths(&self, points: &Columns, depths: &mut [f64], slopes: &mut [f64]) {
        if !points.is_empty() {
            self.attached(|py| self.evaluate(py, points, depths, Some(slopes)));
        }
    }
}

impl fmt::Display for Law {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the wear law of `{}`, `{}`,", self.body, self.name)
    }
}

/// What a run that is kept knows of it: the name alone.
impl fmt::Debug for Law {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let inputs: Vec<&str> = self.columns.iter().map(|column| column.0).collect();
        write!(f, "Python({}, {inputs:?}, {:?})", self.name, self.per)
    }
}
