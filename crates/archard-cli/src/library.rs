//! What the command makes of result folders, for a program that shows it by itself, as the Python package does: pages,
//! comparisons, pictures as data, and numbers as they are usually written.

use std::path::{Path, PathBuf};

use archard_surface::HeightMap;
use serde_json::{Value, json};

use crate::arguments::Report;
use crate::failure::Failure;
use crate::plot::results::Results;
use crate::{compare, plot, report};

pub use crate::compare::Options as Comparing;
pub use crate::compare::scans::{ScanWear, Scans};

/// Writes the page of a folder, next to measured tables and other runs, as `archard report` does; returns its file.
///
/// # Errors
/// Why there is no page, in words.
pub fn page(
    dir: &Path,
    others: &[PathBuf],
    output: Option<PathBuf>,
    options: Comparing,
) -> Result<PathBuf, String> {
    let dirs = std::iter::once(dir.to_owned()).chain(others.iter().cloned()).collect();
    let arguments = Report { dirs, output, measured: Vec::new(), options };
    report::run(&arguments).map_err(why)
}

/// What comes of a run next to measured tables and other runs, as `archard compare` prints it, and the picture of it.
///
/// # Errors
/// Why they cannot be compared, in words.
pub fn comparison(
    dir: &Path,
    others: &[PathBuf],
    options: Comparing,
) -> Result<(Vec<String>, Value), String> {
    let (words, picture, mark) = compare::picture(dir, others, &options).map_err(why)?;
    Ok((words, json!({ "mark": mark, "pictures": [picture.json()] })))
}

/// What is worn between two maps of a surface, of these names, as `archard compare --before A --after B` finds it.
///
/// # Errors
/// Why it is not found, in words.
pub fn scans(maps: &[HeightMap; 2], names: [String; 2], scans: &Scans) -> Result<ScanWear, String> {
    compare::scans::found(maps, names, scans).map_err(in_words)
}

/// The pictures that `archard plot` draws of a folder, as data: a mark, and of each picture its name and its panels with
/// all that is drawn, in the units of their axes.
///
/// # Errors
/// Why there is nothing to draw, in words.
pub fn pictures(dir: &Path) -> Result<Value, String> {
    let (pictures, mark) = plot::pictures(dir, &[]).map_err(why)?;
    let pictures: Vec<Value> = pictures.iter().map(plot::Picture::json).collect();
    Ok(json!({ "mark": mark, "pictures": pictures }))
}

/// The numbers at the end of a run as its page has them: a caption, the heads of the columns, the rows.
pub type Numbers = (String, Vec<&'static str>, Vec<Vec<String>>);

/// The numbers at the end of the run in a folder.
///
/// # Errors
/// Why there are none, in words.
pub fn numbers(dir: &Path) -> Result<Numbers, String> {
    Results::read(dir).map(|results| report::numbers(&results)).map_err(why)
}

/// A value in SI as it is usually written: 2.05e-6 m is "2.05 µm".
pub fn quantity(value: f64, unit: &str) -> String {
    report::quantity(value, unit)
}

fn why(error: anyhow::Error) -> String {
    in_words(Failure::because(&error))
}

fn in_words(failure: Failure) -> String {
    match failure {
        Failure::Wrong(message) => message,
        other => other.cause(),
    }
}
