//! The pressure: along the axes at several outputs, and over the frame at the last.

use std::f64::consts::PI;

use anyhow::{Context, Result};
use archard::simulation::history::LOAD;

use super::cells::Cells;
use super::figure::{COLOURS, Curves, Map, Panel, Pen, View, moment};
use super::outline;
use super::results::{Results, reach, within};
use super::scale::{Unit, phrase};
use super::tables::Axis;

/// Most outputs shown in one panel.
pub(crate) const MOMENTS: usize = 6;
/// Length over width from which a map is stretched across: to scale it would be a mere stroke.
const SLENDER: f64 = 4.0;
/// How far above the later pressures the first may be for all to be shown, and how far above them a picture reaches that
/// cuts it off.
const HIGH: f64 = 3.0;
const ABOVE: f64 = 1.3;
/// Points of the curve of the closed form.
const POINTS: usize = 200;

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
    let labels = [&*title, &across.label(axis.name()), &unit.label("Pressure")];
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

/// The view of sections within a window, with the outputs named beside them.
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
    let angles = (0..=POINTS).map(|point| PI * point as f64 / POINTS as f64);
    let places = angles.map(|angle| -semi_axis * angle.cos()).filter(|x| within(window, *x));
    Ok(Some(places.map(|x| (x, pressure(x))).collect()))
}

/// The pressure over the frame at the last output, white where there is none.
pub(crate) fn map(results: &Results) -> Result<Panel> {
    let image = results.image.as_ref().context("there is no output of fields")?;
    let pressure = image.field("pressure_Pa").context("the fields have no `pressure_Pa`")?;
    let windows = [results.window(Axis::X)?, results.window(Axis::Y)?];
    let cells = Cells::of(image, pressure, windows);
    let (across, unit) = (Unit::across(reach(windows[0]).max(reach(windows[1]))), Unit::pressure());
    let [x, y] = cells.edges.map(|edges| edges.map(|place| place * across.factor));
    let scaled = |row: &Vec<f64>| row.iter().map(|p| p * unit.factor).collect();
    let mut curves = Curves::new();
    curves.map(Map { edges: [x, y], rows: cells.rows.iter().map(scaled).collect() });
    let stick = image.field("stick").map(|stick| Cells::of(image, stick, windows).rows);
    let outline = stick.map(|rows| outline::around(&rows, [x, y])).unwrap_or_default();
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
    let labels = [&*title, &across.label("x"), &across.label("y")];
    let [one, other] = windows.map(|[low, high]| high - low);
    let to_scale = one.max(other) <= SLENDER * one.min(other);
    Ok(curves.panel(labels, |view| View { to_scale, ..view }))
}
