//! Fields of a state as NumPy arrays.

use archard::simulation::Report;
use archard_case::output::{Field, Image, Surface};
use numpy::{PyArray1, PyArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Places and fields: `x`, `y` along the axes and `[ny, nx]` arrays on a grid; one value a pair elsewhere.
pub type Fields<'py> = (Bound<'py, PyDict>, Bound<'py, PyDict>);

/// Fields as they are put out.
pub enum Snapshot {
    /// On a uniform grid.
    Image(Image),
    /// On pairs of any kind.
    Surface(Surface),
}

impl Snapshot {
    /// Of a state.
    pub fn of(report: &Report<'_>) -> Self {
        let Report { problem, state, .. } = report;
        if problem.frame.is_uniform() {
            Snapshot::Image(Image::of(problem, state))
        } else {
            Snapshot::Surface(Surface::of(problem, state))
        }
    }

    /// As arrays.
    pub fn arrays(self, py: Python<'_>) -> PyResult<Fields<'_>> {
        let (places, fields) = (PyDict::new(py), PyDict::new(py));
        match self {
            Snapshot::Image(image) => {
                let [nx, ny] = image.elements;
                for (axis, name) in ["x", "y"].into_iter().enumerate() {
                    let centres = (0..image.elements[axis]).map(|index| image.centre(axis, index));
                    places.set_item(name, PyArray1::from_vec(py, centres.collect()))?;
                }
                for Field { name, values } in image.fields {
                    fields.set_item(name, PyArray1::from_vec(py, values).reshape([ny, nx])?)?;
                }
            }
            Snapshot::Surface(surface) => {
                for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
                    let along = surface.places.iter().map(|place| place[axis]);
                    places.set_item(name, PyArray1::from_vec(py, along.collect()))?;
                }
                for Field { name, values } in surface.fields {
                    fields.set_item(name, PyArray1::from_vec(py, values))?;
                }
                for (name, vectors) in surface.vectors {
                    let pairs = vectors.len();
                    let values = PyArray1::from_vec(py, vectors.into_iter().flatten().collect());
                    fields.set_item(name, values.reshape([pairs, 3])?)?;
                }
            }
        }
        Ok((places, fields))
    }
}

/// The fields in the bytes of a file that a run put out, `.vti` or `.vtu`.
#[pyfunction]
pub fn read_fields<'py>(py: Python<'py>, name: &str, bytes: &[u8]) -> PyResult<Fields<'py>> {
    let read = if name.ends_with(".vtu") {
        Surface::from_bytes(bytes).map(Snapshot::Surface)
    } else {
        Image::from_bytes(bytes).map(Snapshot::Image)
    };
    let damaged =
        |what| PyValueError::new_err(format!("`{name}` is not a file of this program: {what}"));
    read.map_err(damaged)?.arrays(py)
}
