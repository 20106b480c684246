//! The tangential traction along the direction of rolling or of the shift, below the limit that friction sets.

use anyhow::Result;

use super::NEAR;
use super::NEGLIGIBLE;
use super::figure::{Curves, Panel, Pen, moment};
use super::pressure::along_axis;
use super::results::{Results, reach, within};
use super::scale::Unit;
use super::tables::{Axis, Profile, largest};

/// The traction on body 1 along the direction of the motion at that many outputs: a panel for each of
/// its components, but for one that is next to nothing.
pub(crate) fn sections(results: &Results, count: usize) -> Result<Vec<Panel>> {
    let [along, across] = results.axes();
    let sections = results.sections(along, count);
    let largest = |axis: Axis| -> Result<f64> {
        sections.iter().try_fold(0.0_f64, |most, section| {
            Ok(traction(section, axis)?.iter().fold(most, |most, t| most.max(t.abs())))
        })
    };
    let sizes = [largest(along)?, largest(across)?];
    let most = sizes[0].max(sizes[1]);
    let worth = |size: f64| most > 0.0 && size >= NEGLIGIBLE * most;
    let mut axes: Vec<Axis> =
        [along, across].into_iter().zip(sizes).filter(|(_, s)| worth(*s)).map(|(a, _)| a).collect();
    if axes.is_empty() {
        axes.push(along);
    }
    axes.into_iter().map(|axis| panel(results, &sections, axis)).collect()
}

/// The traction (Pa) along an axis on a section.
fn traction(section: &Profile, axis: Axis) -> Result<&[f64]> {
    section.table.column(&format!("traction_{}_Pa", axis.name()))
}

/// One component of the traction.
fn panel(results: &Results, sections: &[&Profile], component: Axis) -> Result<Panel> {
    let [along, _] = results.axes();
    let window = results.window(along)?;
    let (across, unit) = (Unit::across(reach(window)), Unit::pressure());
    let progress = results.progress_unit();
    let mut curves = Curves::new();
    let mut named = false;
    // Where the pressures of bodies that do not roll change, their limits would hide the tractions.
    let limited = if results.rolls() { 0 } else { sections.len().saturating_sub(1) };
    let name = if limited == 0 { "limit" } else { "limit, last" };
    for section in &sections[limited..] {
        for limit in limits(results, section, component)? {
            let points = points(section, &limit, window)?;
            let points = points.into_iter().map(|(x, t)| (x * across.factor, t * unit.factor));
            curves.add(points, Pen::closed_form(), (!named).then_some(name));
            named = true;
        }
    }
    for (index, section) in sections.iter().enumerate() {
        let points = points(section, traction(section, component)?, window)?;
        let points = points.into_iter().map(|(x, t)| (x * across.factor, t * unit.factor));
        let legend = progress.show(section.progress);
        curves.add(points, Pen::line(moment(index, sections.len())), Some(&legend));
    }
    let body = results.bodies.first().map_or("body 1", |body| body);
    let title = format!("Traction along {} on {body}{}", component.name(), towards(results, along));
    let labels = [&*title, &across.label(along.name()), &unit.label("Traction")];
    Ok(curves
        .panel(labels, |view| along_axis(view, results, window.map(|end| end * across.factor))))
}

/// What friction bears (Pa) on a section, on the sides to which the traction points.
fn limits(results: &Results, section: &Profile, component: Axis) -> Result<Vec<Vec<f64>>> {
    let Some(limit) = results.friction_limits(section.table.column("pressure_Pa")?, component)
    else {
        return Ok(Vec::new());
    };
    let traction = traction(section, component)?;
    let least = NEGLIGIBLE * largest(&limit);
    let share = if results.rolls() { 0.0 } else { NEAR };
    let points = |sign: f64| {
        let mut pairs = traction.iter().zip(&limit);
        pairs.any(|(traction, limit)| sign * traction > least.max(share * limit))
    };
    let mut limits = Vec::new();
    if points(1.0) {
        limits.push(limit.clone());
    }
    if points(-1.0) {
        limits.push(limit.iter().map(|limit| -limit).collect());
    }
    Ok(limits)
}

/// Values over places (m) within the window.
fn points(section: &Profile, values: &[f64], window: [f64; 2]) -> Result<Vec<(f64, f64)>> {
    let places = section.table.column("coordinate_m")?.iter();
    let points = places.zip(values).map(|(x, value)| (*x, *value));
    Ok(points.filter(|(x, _)| within(window, *x)).collect())
}

/// Where the contact rolls to, as the end of a title.
fn towards(results: &Results, along: Axis) -> String {
    results.rolling().map_or_else(String::new, |(direction, _)| {
        let sense = if direction.reversed { "\u{2212}" } else { "+" };
        format!(", rolling towards {sense}{}", along.name())
    })
}
