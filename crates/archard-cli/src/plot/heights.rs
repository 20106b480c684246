//! The worn shapes of the bodies, one above the other.

use anyhow::Result;

use super::figure::{Curves, Panel, Pen, moment};
use super::pressure::{MOMENTS, along_axis};
use super::results::{Results, reach, within};
use super::scale::Unit;
use super::tables::{Axis, Profile};

/// The sections of both bodies along an axis at several outputs.
///
/// Body 1 is drawn above, so that a pin stands on its disc; the files have it below.
pub(crate) fn section(results: &Results, axis: Axis) -> Result<Panel> {
    let sections = results.sections(axis, MOMENTS);
    let window = results.worn_window(axis)?;
    let mut highest = 0.0_f64;
    let mut lines = Vec::new();
    for profile in &sections {
        for body in &results.bodies {
            let line = heights(profile, body, window)?;
            highest = line.iter().fold(highest, |highest, (_, z)| highest.max(z.abs()));
            lines.push((profile, line));
        }
    }
    let (across, height) = (Unit::across(reach(window)), Unit::depth(highest));
    let progress = results.progress_unit();
    let mut curves = Curves::new();
    let bodies = results.bodies.len().max(1);
    for (index, (profile, line)) in lines.into_iter().enumerate() {
        let legend = progress.show(profile.progress);
        let points = line.into_iter().map(|(x, z)| (x * across.factor, z * height.factor));
        let pen = Pen::line(moment(index / bodies, sections.len()));
        curves.add(points, pen, (index % bodies == 0).then_some(&*legend));
    }
    let title = match &*results.bodies {
        [one, other] => format!("Worn shape: {one} above, {other} below"),
        _ => "Worn shape".to_owned(),
    };
    let labels = [&*title, &across.label(axis.name()), &height.label("Height")];
    let margin = -0.08 * highest * height.factor;
    Ok(curves.panel(labels, |view| {
        let view = along_axis(view, results, window.map(|end| end * across.factor));
        if results.worn_below() { view } else { view.above_y(margin) }
    }))
}

/// Height over place (m) of a body within the window, upside down.
fn heights(profile: &Profile, body: &str, window: [f64; 2]) -> Result<Vec<(f64, f64)>> {
    let places = profile.table.column("coordinate_m")?.iter();
    let heights = profile.table.column(&format!("height_{body}_m"))?;
    let points = places.zip(heights).map(|(x, z)| (*x, -z));
    Ok(points.filter(|(x, _)| within(window, *x)).collect())
}
