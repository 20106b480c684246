//! The worn shapes of the bodies, one above the other.

use anyhow::Result;

use super::SHOWN;
use super::figure::{Curves, Panel, Pen, moment};
use super::pressure::along_axis;
use super::results::{Results, reach, within};
use super::scale::Unit;
use super::tables::{Axis, Profile};

/// The sections of both bodies along an axis at several outputs.
///
/// Body 1 is drawn above, so that a pin stands on its disc; the files have it below.
pub(crate) fn section(results: &Results, axis: Axis) -> Result<Panel> {
    let sections = results.sections(axis, SHOWN);
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
    // Walls next to the scar say nothing of it.
    let scar = scar(&sections, &results.bodies)?;
    let walled = scar > 0.0 && highest > WALL * scar;
    let highest = if walled { BESIDE_WALLS * scar } else { highest };
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
    let labels = [&*title, &across.label(&results.place(axis)), &height.label("Height")];
    let margin = -0.08 * highest * height.factor;
    Ok(curves.panel(labels, |view| {
        let view = along_axis(view, results, window.map(|end| end * across.factor));
        let view = if walled { view.below_y(highest * height.factor) } else { view };
        match (results.worn_below(), walled) {
            (false, _) => view.above_y(margin),
            (true, true) => view.above_y(-highest * height.factor),
            (true, false) => view,
        }
    }))
}

/// How many times as high as in the scar a body is where it rises as a wall, and how much of it is shown then.
const WALL: f64 = 20.0;
const BESIDE_WALLS: f64 = 2.0;

/// The greatest height (m) of the bodies where one of them is worn.
fn scar(sections: &[&Profile], bodies: &[String]) -> Result<f64> {
    let mut highest = 0.0_f64;
    for profile in sections {
        let of = |what: &str, body: &String| profile.table.column(&format!("{what}_{body}_m"));
        let worn = bodies.iter().map(|body| of("wear", body)).collect::<Result<Vec<_>>>()?;
        for body in bodies {
            let heights = of("height", body)?.iter().enumerate();
            let there = heights.filter(|(place, _)| worn.iter().any(|worn| worn[*place] > 0.0));
            highest = there.fold(highest, |highest, (_, z)| highest.max(z.abs()));
        }
    }
    Ok(highest)
}

/// Height over place (m) of a body within the window, upside down.
fn heights(profile: &Profile, body: &str, window: [f64; 2]) -> Result<Vec<(f64, f64)>> {
    let places = profile.table.column("coordinate_m")?.iter();
    let heights = profile.table.column(&format!("height_{body}_m"))?;
    let points = places.zip(heights).map(|(x, z)| (*x, -z));
    Ok(points.filter(|(x, _)| within(window, *x)).collect())
}
