//! A measured surface: its heights, and its power spectra.

use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use archard_case::output::Image;
use archard_surface::{HeightMap, Mode, Spectrum, Texture};
use clap::ValueEnum;

use super::cells::Cells;
use super::draw::{Format, Paper, Sheet, save};
use super::figure::{COLOURS, Curves, Map, Panel, Pen, View};
use super::scale::Unit;
use super::{PANEL, SLENDER};

/// Draws a surface and its spectrum into a file, whose ending says its kind.
///
/// # Errors
/// If the ending is not known, or the file cannot be written.
pub(crate) fn draw(file: &Path, map: &HeightMap, spectrum: &Spectrum) -> Result<Vec<PathBuf>> {
    let paper = Paper { width: None, formats: vec![format_of(file)?] };
    let panels = vec![heights(map), radial(spectrum), along(spectrum)];
    save(file, &Sheet { columns: panels.len(), size: PANEL, paper: &paper }, (panels, None))
}

/// The kind of picture that the ending of a file says.
///
/// # Errors
/// If the ending is not known.
pub(crate) fn format_of(file: &Path) -> Result<Format> {
    let ending = file.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
    Format::from_str(ending, true).ok().with_context(|| {
        format!(
            "`{}` is no picture that can be drawn: end it in .png, .svg or .pdf",
            file.display()
        )
    })
}

/// The heights from their mean, in as many cells as can be told apart; white where points have none.
fn heights(map: &HeightMap) -> Panel {
    let size = map.size();
    let windows = size.map(|size| [-0.5 * size, 0.5 * size]);
    let image = Image {
        origin: windows.map(|[low, _]| low),
        spacing: map.pixel(),
        elements: map.elements(),
        fields: vec![],
    };
    let texture = Texture::of(map);
    let across = Unit::across(0.5 * size[0].max(size[1]));
    let unit = Unit::depth(texture.peak.max(texture.pit));
    let cells = Cells::of(&image, map.heights(), windows);
    let scaled = |row: &Vec<f64>| row.iter().map(|z| (z - texture.mean) * unit.factor).collect();
    let mut curves = Curves::new();
    curves.map(Map {
        edges: cells.edges.map(|edges| edges.map(|place| place * across.factor)),
        rows: cells.rows.iter().map(scaled).collect(),
    });
    let to_scale = size[0].max(size[1]) <= SLENDER * size[0].min(size[1]);
    let labels = [&*unit.label("Height from the mean"), &across.label("x"), &across.label("y")];
    curves.panel(labels, |view| View { to_scale, ..view })
}

fn radial(spectrum: &Spectrum) -> Panel {
    let mut curves = Curves::new();
    curves.add(points(&spectrum.radial(), 1e36), Pen::line(COLOURS[0]), None);
    let labels = ["Power spectrum, mean of all directions", FREQUENCY, "C (nm⁴)"];
    curves.panel(labels, |view| View { log: true, ..view })
}

fn along(spectrum: &Spectrum) -> Panel {
    let mut curves = Curves::new();
    for (axis, name) in ["along x", "along y"].into_iter().enumerate() {
        let pen = Pen::line(COLOURS[1 + axis]);
        curves.add(points(&spectrum.along(axis), 1e27), pen, Some(name));
    }
    let labels = ["Power spectrum of profiles", FREQUENCY, "C (nm³)"];
    curves.panel(labels, |view| View { log: true, ..view })
}

const FREQUENCY: &str = "Frequency, 1 over the wavelength (1/mm)";

/// What a logarithmic axis can show, with the factor of the density from SI: the library that draws takes all below 1e-10 for that.
fn points(modes: &[Mode], factor: f64) -> Vec<(f64, f64)> {
    let positive = modes.iter().filter(|mode| mode.density > 0.0);
    positive.map(|mode| (1e-3 * mode.frequency, factor * mode.density)).collect()
}
