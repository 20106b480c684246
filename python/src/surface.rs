//! Measured surfaces as a case prepares them.

use archard_case::Problem;
use archard_surface::Texture;
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;

use crate::away::{away, pool};
use crate::case::{CaseFile, refused, told};

/// Heights in rows along x, the size of a pixel, and parameters by their names.
type Read<'py> = (Bound<'py, PyArray2<f64>>, [f64; 2], Vec<(&'static str, f64)>);

/// The surface that `profile.surface` of a case describes by itself, in SI.
#[pyfunction]
pub fn read_surface<'py>(py: Python<'py>, file: &CaseFile) -> PyResult<Read<'py>> {
    let case = file.0.clone();
    let work = move || {
        let map = case.surface().map_err(|problems| {
            problems.iter().map(|one: &Problem| told(&case, one)).collect::<Vec<_>>()
        })?;
        let texture = Texture::of(&map);
        Ok((map, texture))
    };
    let (map, of) = away(py, &pool(None)?, work).unless_interrupted()?.map_err(refused)?;
    let [nx, ny] = map.elements();
    let heights = PyArray1::from_slice(py, map.heights()).reshape([ny, nx])?;
    let parameters = vec![
        ("Sa", of.mean_deviation),
        ("Sq", of.rms),
        ("Ssk", of.skewness),
        ("Sku", of.kurtosis),
        ("Sp", of.peak),
        ("Sv", of.pit),
        ("Sz", of.height()),
        ("Sdq", of.rms_gradient),
        ("Sdr", of.developed),
    ];
    Ok((heights, map.pixel(), parameters))
}
