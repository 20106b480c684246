//! The bodies across the direction of rolling, before and after.

use anyhow::Result;

use super::figure::{COLOURS, Curves, PALE, Panel, Pen};
use super::results::{Results, reach, within};
use super::scale::{Unit, phrase};
use super::tables::Profile;

/// The transverse profiles of both bodies as they were and as they are at the last output.
///
/// Body 1 is drawn above, as the worn shapes are; the files have it below.
pub(crate) fn panel(results: &Results, profile: &Profile) -> Result<Panel> {
    let window = results.window(profile.axis)?;
    let places = profile.table.column("coordinate_m")?;
    let heights = |column: &str| -> Result<Vec<(f64, f64)>> {
        let points = places.iter().zip(profile.table.column(column)?).map(|(x, z)| (*x, -z));
        Ok(points.filter(|(x, _)| within(window, *x)).collect())
    };
    let mut lines = Vec::new();
    for ((body, colour), pale) in results.bodies.iter().zip(&COLOURS[1..]).zip(&PALE[1..]) {
        let before = heights(&format!("height_{body}_before_m"))?;
        let after = heights(&format!("height_{body}_m"))?;
        lines.push((before, Pen::broad(*pale), format!("{body}, new")));
        lines.push((after, Pen::line(*colour), format!("{body}, worn")));
    }
    let largest = |most: f64, (_, z): &(f64, f64)| most.max(z.abs());
    let highest = lines.iter().flat_map(|(points, ..)| points).fold(0.0, largest);
    let (across, height) = (Unit::across(reach(window)), Unit::depth(highest));
    let mut curves = Curves::new();
    for (points, pen, legend) in lines {
        let points = points.into_iter().map(|(x, z)| (x * across.factor, z * height.factor));
        curves.add(points, pen, Some(&legend));
    }
    let (column, _) = results.progress();
    let progress = results.progress_unit().show(profile.progress);
    let after = format!("after {progress} {}", phrase(column).to_lowercase());
    let title = match &*results.bodies {
        [one, other] => format!("{one} above, {other} below, {after}"),
        _ => format!("Profiles {after}"),
    };
    let labels = [&*title, &across.label(profile.axis.name()), &height.label("Height")];
    Ok(curves.panel(labels, |view| view.along_x(window.map(|end| end * across.factor))))
}
