//! Pictures of a result folder, as SVG, PNG and PDF.
//!
//! Everything is read from the files of the folder; no solver is involved, so a folder can be
//! plotted while its run goes on and long after.

mod below;
pub(crate) mod cam;
pub(crate) mod cells;
mod comparison;
mod course;
mod creep_force;
pub(crate) mod draw;
pub(crate) mod figure;
mod fit;
mod fretting_loop;
pub(crate) mod gear;
mod heights;
mod json;
mod lengths;
mod life;
mod load;
pub(crate) mod log;
pub(crate) mod outline;
mod parts;
mod pressure;
pub(crate) mod rail;
mod raster;
pub(crate) mod results;
mod rough;
mod rows;
pub(crate) mod scale;
mod shakedown;
mod study;
pub(crate) mod surface;
pub(crate) mod tables;
mod traction;
mod transverse;
mod wear;

#[cfg(test)]
mod tests;

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, ensure};

use archard::simulation::history::FORCE;
use draw::{Paper, Sheet, places, save};
use figure::Panel;
pub use fit::{admit as admit_fit, draw as draw_fit};
use results::Results;
pub(crate) use study::{Key, quantile};

/// Size (px) of a panel of the figures with few panels.
const PANEL: [f64; 2] = [640.0, 460.0];
/// Size (px) of a map.
const MAP: [f64; 2] = [680.0, 600.0];
/// Size (px) of a panel of an overview.
const OVERVIEW: [f64; 2] = [700.0, 500.0];

/// Parts of an axis that can be told apart, four pixels of a panel each: cells of a map, stretches of a curve.
pub(crate) const CELLS: usize = 160;
/// Less than the width of a line, relative to the axis.
pub(crate) const LINE: f64 = 1e-3;
/// Less than is worth a panel or a curve, relative to the largest of its kind: the width of a few lines.
const NEGLIGIBLE: f64 = 10.0 * LINE;
/// Most panels of a picture, and most curves of a panel.
const SHOWN: usize = 6;
/// How many times as high as all else a curve may be: above that it is cut off, or all else would lie flat.
const HIGH: f64 = 4.0;
/// Share of a limit that a curve has to come to for the limit to be shown.
const NEAR: f64 = 0.25;
/// Length over width from which a map is stretched across: to scale it would be a mere stroke.
pub(crate) const SLENDER: f64 = 4.0;

/// A picture under its name.
pub(crate) struct Picture {
    name: &'static str,
    /// Panels side by side.
    columns: usize,
    /// Size (px) of a panel.
    size: [f64; 2],
    panels: Vec<Panel>,
}

impl Picture {
    /// A picture of panels of the usual size, up to three in a row and four in two rows.
    pub(crate) fn new(name: &'static str, panels: Vec<Panel>) -> Self {
        let columns = if panels.len() > 3 { 2 } else { panels.len() };
        Self { name, columns, size: PANEL, panels }
    }

    /// The same picture with its panels below each other.
    pub(crate) fn stacked(self) -> Self {
        Self { columns: 1, ..self }
    }

    /// The same picture with panels of that size (px).
    fn sized(self, size: [f64; 2]) -> Self {
        Self { size, ..self }
    }
}

/// Draws the pictures that make sense for the results in `dir` into `dir/plots`, and one that compares
/// their wear with that of the runs in `others`, if there are any; returns their files.
///
/// # Errors
/// If a folder is not a result folder, has no results yet, cannot be compared or cannot be written.
pub fn run(dir: &Path, others: &[PathBuf], paper: &Paper) -> anyhow::Result<Vec<PathBuf>> {
    let (pictures, mark) = pictures(dir, others)?;
    write(dir, pictures, (mark.as_deref(), paper))
}

/// The pictures that make sense for a folder, and what they have to say besides what they show.
///
/// # Errors
/// If there is nothing to draw, or it cannot be compared.
pub(crate) fn pictures(
    dir: &Path,
    others: &[PathBuf],
) -> anyhow::Result<(Vec<Picture>, Option<String>)> {
    if study::is_one(dir) {
        ensure!(others.is_empty(), "a study is not compared with runs");
        return study::pictures(dir, &[]);
    }
    if rail::is_one(dir) {
        ensure!(others.is_empty(), "a wheel on a rail is not compared with other runs");
        let found = rail::Rail::read(dir)?;
        return Ok((found.pictures(), found.mark));
    }
    if cam::is_one(dir) {
        ensure!(others.is_empty(), "a cam is not compared with other runs");
        let found = cam::Cam::read(dir)?;
        return Ok((found.pictures(), found.mark));
    }
    if gear::is_one(dir) {
        ensure!(others.is_empty(), "gears are not compared with other runs");
        let found = gear::Gears::read(dir)?;
        return Ok((found.pictures(), found.mark));
    }
    let results = Results::read(dir)?;
    let mut pictures = if results.rolls() { rolling(&results)? } else { sliding(&results)? };
    pictures.extend(below::pictures(&results)?);
    pictures.extend(life::panel(&results).map(|panel| Picture::new("life", vec![panel])));
    if !others.is_empty() {
        let compared = comparison::panel(dir, &results, others)?;
        pictures.push(Picture::new("comparison", vec![compared]).sized([760.0, 520.0]));
    }
    Ok((pictures, results.mark))
}

/// Draws the pictures of a study of these columns of the history; returns their files.
///
/// # Errors
/// If the folder is not that of a study, or its rows have no such column.
pub fn of_study(dir: &Path, columns: &[String], paper: &Paper) -> anyhow::Result<Vec<PathBuf>> {
    ensure!(study::is_one(dir), "--quantity is what the pictures of a study show");
    study::run(dir, columns, paper)
}

/// Writes pictures into `dir/plots`, each below a mark if there is one; not through a link, which may lead anywhere.
pub(crate) fn write(
    dir: &Path,
    pictures: Vec<Picture>,
    (mark, paper): (Option<&str>, &Paper),
) -> anyhow::Result<Vec<PathBuf>> {
    let plots = dir.join("plots");
    let linked = plots.is_symlink();
    ensure!(!linked, "`{}` is a link, through which nothing is written", plots.display());
    fs::create_dir_all(&plots).with_context(|| format!("cannot make `{}`", plots.display()))?;
    // Where one has no place, none is written.
    pictures.iter().try_for_each(|one| places(&plots.join(one.name), paper).map(|_| ()))?;
    let mut files = Vec::new();
    for Picture { name, columns, size, panels } in pictures {
        let sheet = Sheet { columns, size, paper };
        files.extend(save(&plots.join(name), &sheet, (panels, mark))?);
    }
    Ok(files)
}

/// Whether a folder is that of a study.
pub(crate) fn is_study(dir: &Path) -> bool {
    study::is_one(dir)
}

/// Panels under the name of their picture.
type Named = (&'static str, Vec<Panel>);

/// The panels of a study by the name of their picture, and what they have to say of rows that are left out.
///
/// # Errors
/// If the study has no results.
pub(crate) fn panels_of_study(dir: &Path) -> anyhow::Result<(Vec<Named>, Option<String>)> {
    let (pictures, mark) = study::pictures(dir, &[])?;
    Ok((pictures.into_iter().map(|picture| (picture.name, picture.panels)).collect(), mark))
}

/// The wear of a run next to that of others.
///
/// # Errors
/// If one of them is no result folder, or they cannot be compared.
pub(crate) fn compared(dir: &Path, results: &Results, others: &[PathBuf]) -> anyhow::Result<Panel> {
    comparison::panel(dir, results, others)
}

/// All panels that make sense for a run, under the names of the sections of a report.
pub(crate) fn groups(
    results: &Results,
) -> anyhow::Result<Vec<(&'static str, &'static str, Vec<Panel>)>> {
    let mut history = Vec::new();
    if results.wears() {
        history.extend([wear::depth(results)?, wear::worn_off(results)?]);
    } else if results.loops.is_empty() && !results.rolls() {
        history.extend(load::panel(results)?);
    }
    if results.sweeps() {
        history.push(creep_force::panel(results)?);
    }
    history.extend(course::panels(results)?);
    history.extend(life::panel(results));
    let loops = fretting_loop::panels(results)?;
    let (mut profiles, mut tractions) = (Vec::new(), Vec::new());
    if !results.profiles.is_empty() {
        let axes = results.shown_axes();
        for axis in &axes {
            profiles.push(pressure::section(results, *axis, SHOWN)?);
        }
        if results.wears() {
            for axis in &axes {
                profiles.push(heights::section(results, *axis)?);
            }
        }
        if results.rubs() || results.rolls() && results.history.column(FORCE[0]).is_ok() {
            tractions = traction::sections(results, SHOWN)?;
        }
    }
    if let Some(profile) = results.worn_profile.as_ref().filter(|_| results.wears()) {
        profiles.push(transverse::panel(results, profile)?);
    }
    if let Some(profile) = &results.lengths {
        profiles.extend(lengths::panel(results, profile)?);
    }
    let below = below::pictures(results)?.into_iter().flat_map(|own| own.panels).collect();
    let groups = [
        ("history", "History", history),
        ("loops", "Fretting loops", loops),
        ("rough", "Rough surfaces", rough::panels(results)?),
        ("profiles", "Profiles", profiles),
        ("tractions", "Tractions", tractions),
        ("below", "Sections below the surface", below),
    ];
    Ok(groups.into_iter().filter(|(_, _, panels)| !panels.is_empty()).collect())
}

/// The pictures of bodies that slide or are pressed and shifted against each other.
fn sliding(results: &Results) -> anyhow::Result<Vec<Picture>> {
    let mut pictures = Vec::new();
    if results.wears() {
        pictures.push(Picture::new("wear", vec![wear::depth(results)?, wear::worn_off(results)?]));
    } else if results.loops.is_empty() {
        let panels: Vec<Panel> = load::panel(results)?.into_iter().collect();
        if !panels.is_empty() {
            pictures.push(Picture::new("load", panels));
        }
    }
    let loops = fretting_loop::panels(results)?;
    if !loops.is_empty() {
        pictures.push(Picture::new("fretting_loop", loops));
    }
    if !results.profiles.is_empty() {
        let [along, _] = results.axes();
        if results.rubs() {
            let mut panels = vec![pressure::section(results, along, SHOWN)?];
            panels.extend(traction::sections(results, SHOWN)?);
            pictures.push(Picture::new("traction", panels));
        }
        let mut panels = Vec::new();
        let axes = results.shown_axes();
        if results.wears() {
            for axis in &axes {
                panels.push(heights::section(results, *axis)?);
            }
        }
        for axis in &axes {
            panels.push(pressure::section(results, *axis, SHOWN)?);
        }
        pictures.push(Picture::new("profiles", panels));
    }
    let panels = rough::panels(results)?;
    if !panels.is_empty() {
        pictures.push(Picture::new("rough", panels));
    }
    if results.image.is_some() {
        if results.shown_axes().len() > 1 {
            pictures.push(Picture::new("pressure_map", vec![pressure::map(results)?]).sized(MAP));
        }
        pictures.push(Picture::new("overview", sliding_overview(results)?).sized(OVERVIEW));
    }
    Ok(pictures)
}

/// Four panels that say what a run of bodies that slide or are pressed and shifted was about.
fn sliding_overview(results: &Results) -> anyhow::Result<Vec<Panel>> {
    let [along, across] = results.axes();
    let fretting = fretting_loop::panels(results)?.into_iter().next();
    let traction = match results.rubs() {
        true => traction::sections(results, SHOWN)?.into_iter().next(),
        false => None,
    };
    let pressed = pressure::section(results, along, SHOWN)?;
    let line = results.shown_axes().len() < 2;
    if results.wears() {
        let map = if line { wear::worn_off(results)? } else { pressure::map(results)? };
        let last = fretting.or(traction).unwrap_or(pressed);
        let shapes = heights::section(results, results.shape_axis())?;
        return Ok(vec![wear::depth(results)?, map, shapes, last]);
    }
    let first = match fretting {
        Some(fretting) => Some(fretting),
        None => load::panel(results)?,
    };
    let mut panels: Vec<Panel> = first.into_iter().collect();
    if !line {
        panels.push(pressure::map(results)?);
    }
    panels.push(pressed);
    match traction {
        Some(traction) => panels.push(traction),
        None if line => {}
        None => panels.push(pressure::section(results, across, SHOWN)?),
    }
    Ok(panels)
}

/// The pictures of bodies that roll.
fn rolling(results: &Results) -> anyhow::Result<Vec<Picture>> {
    let [along, across] = results.axes();
    let swept = results.sweeps();
    let mut pictures = Vec::new();
    if results.wears() {
        let panels = vec![wear::depth(results)?, wear::worn_off(results)?];
        pictures.push(Picture::new("wear", panels));
    }
    if swept {
        pictures.push(Picture::new("creep_force", vec![creep_force::panel(results)?]));
    }
    if let Some(profile) = results.worn_profile.as_ref().filter(|_| results.wears()) {
        let panels = vec![transverse::panel(results, profile)?];
        pictures.push(Picture::new("worn_profiles", panels).sized([860.0, 520.0]));
    }
    if results.profiles.is_empty() {
        return Ok(pictures);
    }
    // What is swept does not change the pressure, but everything in between matters.
    let moments = if swept { SHOWN } else { 2 };
    let mut panels = vec![pressure::section(results, along, 2)?];
    panels.extend(traction::sections(results, moments)?);
    pictures.push(Picture::new("traction", panels));
    let line = results.is_one_element(across);
    let mut panels = vec![pressure::section(results, along, SHOWN)?];
    if !line {
        panels.push(pressure::section(results, across, SHOWN)?);
    }
    if results.wears() {
        if !line {
            panels.push(heights::section(results, across)?);
        }
        panels.extend(traction::sections(results, SHOWN)?.into_iter().next());
    }
    pictures.push(Picture::new("profiles", panels));
    if results.image.is_some() {
        if !line {
            pictures.push(Picture::new("pressure_map", vec![pressure::map(results)?]).sized(MAP));
        }
        pictures.push(Picture::new("overview", rolling_overview(results)?).sized(OVERVIEW));
    }
    Ok(pictures)
}

/// Four panels that say what a run of bodies that roll was about.
fn rolling_overview(results: &Results) -> anyhow::Result<Vec<Panel>> {
    let [along, across] = results.axes();
    let swept = results.sweeps();
    let line = results.is_one_element(across);
    let first = match (results.wears(), swept) {
        (true, _) => Some(wear::depth(results)?),
        (false, true) => Some(creep_force::panel(results)?),
        (false, false) if line => None,
        (false, false) => Some(pressure::section(results, across, SHOWN)?),
    };
    let map = if line { None } else { Some(pressure::map(results)?) };
    let third = match results.worn_profile.as_ref().filter(|_| results.wears()) {
        Some(profile) => transverse::panel(results, profile)?,
        None => pressure::section(results, along, SHOWN)?,
    };
    let mut panels: Vec<Panel> = first.into_iter().chain(map).chain([third]).collect();
    panels.extend(traction::sections(results, SHOWN)?.into_iter().next());
    Ok(panels)
}
