//! The pressure: along the axes at several outputs, and over the frame at the last.

use std::f64::consts::PI;

use anyhow::{Context, Result};
use archard::simulation::history::LOAD;
use archard_case::output::Surface;

use super::CELLS;
use super::HIGH;
use super::SLENDER;
use super::cells::Cells;
use super::figure::{COLOURS, Curves, Map, Panel, Parts, Pen, View, moment};
use super::outline;
use super::results::{Results, reach, within};
use super::scale::{Unit, phrase};
use super::tables::Axis;

/// How far above the later pressures a picture reaches that cuts the first off.
const ABOVE: f64 = 1.3;

/// The pressure along an axis at that many outputs, and Hertz's for the unworn bodies.
pub(crate) fn section(results: &Results, axis: Axis, count: usize) -> Result<Panel> {
    let sections = results.sections(axis, count);
    let progress = results.progress_unit();
    let window = results.window(axis)?;
    let (across, unit) = (Unit::across(reach(window)), Unit::pressure());
    let mut curves = Curves::new();
    let peaks: Vec<f64> = sections.iter().map(|profile| profile.peak()).collect::<Result<_>>()?;
    let top = top(&peaks);
    if let Some(curve) = hertz(results, axis, window)? {
        let points = below(curve, top);
        let points = points.into_iter().map(|(x, p)| (x * across.factor, p * unit.factor));
        let name = if results.wears() { "Hertz, unworn" } else { "Hertz" };
        curves.add(points, Pen::closed_form(), Some(name));
    }
    for (index, profile) in sections.iter().enumerate() {
        let places = profile.table.column("coordinate_m")?.iter();
        let pressures = profile.table.column("pressure_Pa")?;
        let points = places.zip(pressures).filter(|(x, _)| within(window, **x));
        let points = below(points.map(|(x, p)| (*x, *p)).collect(), top);
        let points = points.into_iter().map(|(x, p)| (x * across.factor, p * unit.factor));
        let pen = Pen::line(moment(index, sections.len()));
        curves.add(points, pen, Some(&progress.show(profile.progress)));
    }
    let cut = if top.is_finite() {
        format!(", first {} cut off", unit.show(peaks[0]))
    } else {
        String::new()
    };
    let title = format!("Pressure along {}{cut}", axis.name());
    let labels = [&*title, &across.label(&results.place(axis)), &unit.label("Pressure")];
    Ok(curves.panel(labels, |view| {
        let view = along_axis(view, results, window.map(|end| end * across.factor)).above_y(0.0);
        if top.is_finite() { view.below_y(top * unit.factor) } else { view }
    }))
}

/// The highest pressure (Pa) shown: all, unless the first contact stands so high above the later ones that those would
/// lie flat.
fn top(peaks: &[f64]) -> f64 {
    let later = peaks.iter().skip(1).copied().fold(0.0, f64::max);
    let flat = later > 0.0 && peaks[0] > HIGH * later;
    if flat { ABOVE * later } else { f64::INFINITY }
}

/// The curve as far as a height; what rises beyond is cut there.
fn below(points: Vec<(f64, f64)>, top: f64) -> Vec<(f64, f64)> {
    points.into_iter().map(|(x, y)| (x, y.min(top))).collect()
}

/// The view of sections within a window, with the outputs named next to them.
pub(crate) fn along_axis(view: View, results: &Results, window: [f64; 2]) -> View {
    view.along_x(window).legend_title(phrase(results.progress().0))
}

/// Hertz's pressure (Pa) over the place (m) under the last load, within a window.
fn hertz(results: &Results, axis: Axis, window: [f64; 2]) -> Result<Option<Vec<(f64, f64)>>> {
    let load = results.history.column(LOAD)?.last().copied().unwrap_or_default();
    let Some(hertz) = results.hertz(load) else { return Ok(None) };
    let semi_axis = hertz.semi_axes[axis.index()].min(reach(window));
    let pressure = |place: f64| match axis {
        Axis::X => hertz.pressure([place, 0.0]),
        Axis::Y => hertz.pressure([0.0, place]),
    };
    // Points by angle: dense at the edge, where the curve is steep.
    let angles = (0..=CELLS).map(|point| PI * point as f64 / CELLS as f64);
    let places = angles.map(|angle| -semi_axis * angle.cos()).filter(|x| within(window, *x));
    Ok(Some(places.map(|x| (x, pressure(x))).collect()))
}

/// The pressure over the frame at the last output, white where none exists; of meshed bodies on their own elements.
pub(crate) fn map(results: &Results) -> Result<Panel> {
    let windows = [results.map_window(Axis::X)?, results.map_window(Axis::Y)?];
    let (across, unit) = (Unit::across(reach(windows[0]).max(reach(windows[1]))), Unit::pressure());
    let mut curves = Curves::new();
    let scale = (across.factor, unit.factor);
    let outline = match &results.surface {
        Some(surface) => on_elements(&mut curves, surface, windows, scale)?,
        None => on_cells(&mut curves, results, windows, scale)?,
    };
    let outlined = if outline.is_empty() { "" } else { ", stick outlined" };
    outline.into_iter().for_each(|line| curves.add(line, Pen::line(COLOURS[2]), None));
    let name = unit.label("Pressure");
    let title = match results.profiles.last() {
        Some(last) => {
            let (column, _) = results.progress();
            let progress = results.progress_unit().show(last.progress);
            format!("{name}, {} {progress}", phrase(column).to_lowercase())
        }
        None => name,
    };
    let title = title + outlined;
    let [x, y] = [Axis::X, Axis::Y].map(|axis| across.label(&results.place(axis)));
    let labels = [&*title, &x, &y];
    let [one, other] = windows.map(|[low, high]| high - low);
    let to_scale = one.max(other) <= SLENDER * one.min(other);
    Ok(curves.panel(labels, |view| View { to_scale, ..view }))
}

/// Draws the pressure on cells of the frame; the outline of what sticks.
fn on_cells(
    curves: &mut Curves,
    results: &Results,
    windows: [[f64; 2]; 2],
    (across, unit): (f64, f64),
) -> Result<Vec<outline::Line>> {
    let image = results.image.as_ref().context("there is no output of fields")?;
    let pressure = image.field("pressure_Pa").context(NO_PRESSURE)?;
    let cells = Cells::of(image, pressure, windows);
    let edges = cells.edges.map(|edges| edges.map(|place| place * across));
    let scaled = |row: &Vec<f64>| row.iter().map(|p| p * unit).collect();
    curves.map(Map { edges, rows: cells.rows.iter().map(scaled).collect() });
    let stick = image.field("stick").map(|stick| Cells::of(image, stick, windows).rows);
    Ok(stick.map(|rows| outline::around(&rows, edges)).unwrap_or_default())
}

const NO_PRESSURE: &str = "the fields have no `pressure_Pa`";

/// Draws the pressure on the elements of a mesh; the outline of what sticks.
fn on_elements(
    curves: &mut Curves,
    surface: &Surface,
    windows: [[f64; 2]; 2],
    (across, unit): (f64, f64),
) -> Result<Vec<outline::Line>> {
    let seen = |corners: &[[f64; 2]]| {
        let inside = |axis: usize| {
            let places = corners.iter().map(|corner| corner[axis]);
            let middle = places.sum::<f64>() / corners.len().max(1) as f64;
            within(windows[axis], middle)
        };
        inside(0) && inside(1)
    };
    let scaled = |name: &str, factor: f64| -> Option<Vec<(Vec<[f64; 2]>, f64)>> {
        let parts = surface.parts(name)?.into_iter().filter(|(corners, _)| seen(corners));
        let scaled = parts.map(|(corners, value)| {
            (corners.iter().map(|corner| corner.map(|x| x * across)).collect(), value * factor)
        });
        Some(scaled.collect())
    };
    let parts = scaled("pressure_Pa", unit).context(NO_PRESSURE)?;
    let edges = [0, 1].map(|axis| {
        let places = parts.iter().flat_map(|(corners, _)| corners).map(|corner| corner[axis]);
        places.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], one| {
            [low.min(one), high.max(one)]
        })
    });
    curves.parts(Parts { edges, parts });
    Ok(scaled("stick", 1.0).map(|stick| outline::of_parts(&stick)).unwrap_or_default())
}
