//! Surfaces that swing, from end to end: how deep they are worn.

use anyhow::Result;

use super::figure::{COLOURS, Curves, Panel, Pen};
use super::results::Results;
use super::scale::{Unit, phrase};
use super::tables::{Profile, largest, size};

/// The deepest wear over the length of the motion at the last output; nothing where nothing has worn.
pub(crate) fn panel(results: &Results, profile: &Profile) -> Result<Option<Panel>> {
    let places = profile.table.column("coordinate_m")?;
    let worn = results.bodies.iter().enumerate().filter_map(|(index, body)| {
        let depths = profile.table.column(&format!("depth_{body}_m")).ok()?;
        (largest(depths) > 0.0).then_some((index, body, depths))
    });
    let worn: Vec<_> = worn.collect();
    let deepest = worn.iter().map(|worn| largest(worn.2)).fold(0.0, f64::max);
    if worn.is_empty() {
        return Ok(None);
    }
    let (across, unit) = (Unit::across(size(places)), Unit::depth(deepest));
    let mut curves = Curves::new();
    for (index, body, depths) in worn {
        let points = places.iter().zip(depths);
        let points = points.map(|(x, depth)| (x * across.factor, depth * unit.factor));
        curves.add(points, Pen::line(COLOURS[1 + index % 2]), Some(body));
    }
    let (column, _) = results.progress();
    let progress = results.progress_unit().show(profile.progress);
    let title = format!("Depth from end to end, {} {progress}", phrase(column).to_lowercase());
    let labels = [&*title, &across.label(profile.axis.name()), &unit.label("Depth")];
    Ok(Some(curves.panel(labels, |view| view.above_y(0.0))))
}
