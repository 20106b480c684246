//! Measured surfaces as a case prepares them.

use archard_case::Problem;
use archard_cli::library::{self, ScanWear, Scans};
use archard_surface::{HeightMap, Texture};
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::exceptions::PyValueError;
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

/// What the command prints and all its numbers as JSON; changes (m) and regions in rows along x, and the size of a pixel (m).
type Worn<'py> =
    (Vec<String>, String, Bound<'py, PyArray2<f64>>, Bound<'py, PyArray2<i8>>, [f64; 2]);

/// What is worn between two surfaces that cases describe by themselves: of these names, with the part where wear is to be found (as four
/// lengths), the largest turn (degrees), and whether both are placed.
#[pyfunction]
pub fn scan_difference<'py>(
    py: Python<'py>,
    files: [PyRef<'py, CaseFile>; 2],
    names: [String; 2],
    options: (Option<String>, f64, bool),
) -> PyResult<Worn<'py>> {
    let (worn, turn, placed) = options;
    let cases = files.each_ref().map(|file| file.0.clone());
    let work = move || -> Result<Result<ScanWear, String>, Vec<_>> {
        let read = |case: &archard_case::CaseFile| -> Result<HeightMap, Vec<_>> {
            case.surface().map_err(|problems| {
                problems.iter().map(|one: &Problem| told(case, one)).collect::<Vec<_>>()
            })
        };
        let maps = [read(&cases[0])?, read(&cases[1])?];
        let scans = Scans { worn, turn, placed, ..Scans::default() };
        Ok(library::scans(&maps, names, &scans))
    };
    let found = away(py, &pool(None)?, work).unless_interrupted()?.map_err(refused)?;
    let ScanWear { lines, numbers, change, regions } = found.map_err(PyValueError::new_err)?;
    let [nx, ny] = change.elements();
    let changes = PyArray1::from_slice(py, change.heights()).reshape([ny, nx])?;
    let regions = PyArray1::from_slice(py, &regions).reshape([ny, nx])?;
    Ok((lines, numbers.to_string(), changes, regions, change.pixel()))
}
