//! Pictures of a result folder, as SVG and PNG.
//!
//! Everything is read from the files of the folder; no solver is involved, so a folder can be
//! plotted while its run goes on and long after.

mod cells;
mod figure;
mod heights;
mod load;
mod pressure;
mod raster;
mod results;
mod scale;
mod wear;

#[cfg(test)]
mod tests;

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::Context;

use figure::{Panel, save};
use results::{Axis, Results};

/// Size (px) of a panel of the figures with few panels.
const PANEL: [f64; 2] = [640.0, 460.0];

/// Draws the pictures that make sense for the results in `dir` into `dir/plots` and returns their
/// files.
///
/// # Errors
/// If `dir` is not a result folder, has no results yet or cannot be written.
pub fn run(dir: &Path) -> anyhow::Result<Vec<PathBuf>> {
    let results = Results::read(dir)?;
    let plots = dir.join("plots");
    fs::create_dir_all(&plots).with_context(|| format!("cannot make `{}`", plots.display()))?;
    let mut files = Vec::new();
    let mut draw = |name: &str, columns: usize, size: [f64; 2], panels: Vec<Panel>| {
        files.extend(save(&plots.join(name), columns, size, panels)?);
        anyhow::Ok(())
    };
    if results.wears() {
        draw("wear", 2, PANEL, vec![wear::depth(&results)?, wear::volume(&results)?])?;
    } else {
        draw("load", 1, PANEL, vec![load::panel(&results)?])?;
    }
    if !results.profiles.is_empty() {
        draw("profiles", 2, PANEL, profiles(&results)?)?;
    }
    if results.image.is_some() {
        draw("pressure_map", 1, [680.0, 600.0], vec![pressure::map(&results)?])?;
        draw("overview", 2, [700.0, 500.0], overview(&results)?)?;
    }
    Ok(files)
}

/// Worn profiles above pressures, along x and along y.
fn profiles(results: &Results) -> anyhow::Result<Vec<Panel>> {
    let mut panels = Vec::new();
    if results.wears() {
        panels.push(heights::section(results, Axis::X)?);
        panels.push(heights::section(results, Axis::Y)?);
    }
    panels.push(pressure::section(results, Axis::X)?);
    panels.push(pressure::section(results, Axis::Y)?);
    Ok(panels)
}

/// Four panels that say what a run was about.
fn overview(results: &Results) -> anyhow::Result<Vec<Panel>> {
    let map = pressure::map(results)?;
    let along_x = pressure::section(results, Axis::X)?;
    if results.wears() {
        Ok(vec![wear::depth(results)?, map, heights::section(results, Axis::X)?, along_x])
    } else {
        Ok(vec![load::panel(results)?, map, along_x, pressure::section(results, Axis::Y)?])
    }
}
