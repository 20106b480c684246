//! `archard report`: a run, a study, a fit or two scans on one page that opens anywhere.
//!
//! The page holds all it needs: its words and tables as HTML, its figures as pictures, the panels of
//! [`plot`](crate::plot) and the fields of all outputs as numbers, and plotly.js, which draws those where scripts may
//! run. Everything is read from the files of the folder.

mod closed_forms;
mod figures;
mod fit;
mod html;
mod line_contact;
mod maps;
mod page;
mod rail;
mod run;
mod scans;
mod stress;
mod study;
mod tables;
mod words;

use std::path::{Path, PathBuf};
use std::time::Duration;

use anyhow::{Context, Result, ensure};

use crate::arguments::Report;
use crate::compare;
use crate::library::Numbers;
use crate::plot;
use crate::plot::results::Results;
pub(crate) use scans::SCANS;
pub(crate) use words::quantity;

/// The name of the page in its folder.
pub const NAME: &str = "report.html";

/// Writes the page of the run, the study or the fit in the first folder, compared with the runs in the others; returns its
/// file.
///
/// # Errors
/// If a folder holds no results, the runs cannot be compared, or the page cannot be written.
pub fn run(arguments: &Report) -> Result<PathBuf> {
    write(arguments, None)
}

/// The same of a run that goes on, whose page reloads after that time where one is given.
///
/// # Errors
/// As [`run`].
pub fn write(arguments: &Report, reload: Option<Duration>) -> Result<PathBuf> {
    let Report { dirs, output, measured, options } = arguments;
    let (dir, others) = dirs.split_first().context("no result folder is named")?;
    let mut others = others.to_vec();
    others.extend_from_slice(measured);
    let alone = |what: &str| {
        ensure!(others.is_empty(), "`{}` is a {what}, which is not compared", dir.display());
        Ok(())
    };
    let page = if plot::is_study(dir) {
        alone("study")?;
        study::page(dir)?
    } else if fit::is_one(dir) {
        alone("fit")?;
        fit::page(dir)?
    } else if scans::is_one(dir) {
        alone("comparison of two scans")?;
        scans::page(dir)?
    } else if plot::rail::is_one(dir) {
        alone("wheel on a rail")?;
        rail::page(dir)?
    } else if plot::gear::is_one(dir) {
        alone("pair of gears")?;
        line_contact::of_gears(dir)?
    } else if plot::cam::is_one(dir) {
        alone("cam with its follower")?;
        line_contact::of_cam(dir)?
    } else {
        let results = Results::read(dir)?;
        let compared = compare::of(dir, &results, &others, options)?;
        run::page(dir, &results, compared)?
    };
    let path = output.clone().unwrap_or_else(|| dir.join(NAME));
    page.write(&path, reload)?;
    Ok(path)
}

/// Writes the page of two scans into their folder; returns its file.
///
/// # Errors
/// If the folder has none, or the page cannot be written.
pub(crate) fn of_scans(dir: &Path) -> Result<PathBuf> {
    let path = dir.join(NAME);
    scans::page(dir)?.write(&path, None)?;
    Ok(path)
}

/// The numbers at the end of a run, as its page has them.
pub(crate) fn numbers(results: &Results) -> Numbers {
    let page::Table { caption, heads, rows } = tables::results(results);
    (caption, heads, rows)
}

/// What a folder is called.
fn name_of(dir: &Path) -> String {
    let dir = dir.canonicalize().unwrap_or_else(|_| dir.to_owned());
    dir.file_name().map_or_else(|| "Run".to_owned(), |name| name.to_string_lossy().into_owned())
}
