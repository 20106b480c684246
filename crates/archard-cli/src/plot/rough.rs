//! Rough surfaces in contact: their area over the load, how pressures are distributed, bearing curves, and how they wear smooth.

use anyhow::Result;
use archard::simulation::history::{CONTACT_AREA, LOAD, of_body};

use super::LINE;
use super::figure::{COLOURS, Curves, OTHERS, PALE, Panel, Pen};
use super::results::Results;
use super::scale::Unit;
use super::tables::{Table, largest, size};

/// The panels of rough surfaces; none of others.
pub(crate) fn panels(results: &Results) -> Result<Vec<Panel>> {
    let [Some(first), Some(last)] = [results.distributions.first(), results.distributions.last()]
    else {
        return Ok(vec![]);
    };
    let mut panels = vec![];
    panels.extend(area(results)?);
    panels.push(pressures(last)?);
    panels.push(bearing_curves(results, [first, last])?);
    panels.extend(roughness(results));
    Ok(panels)
}

/// Area in contact over the load, where that changes.
fn area(results: &Results) -> Result<Option<Panel>> {
    let [load, area] = [results.history.column(LOAD)?, results.history.column(CONTACT_AREA)?];
    let least = load.iter().copied().fold(f64::INFINITY, f64::min);
    if largest(load) - least <= LINE * largest(load) {
        return Ok(None);
    }
    let (force, unit) = (Unit::force(largest(load)), Unit::section(largest(area)));
    let mut curves = Curves::new();
    let points = load.iter().zip(area).map(|(f, a)| (f * force.factor, a * unit.factor));
    curves.mark(points, OTHERS[0], None);
    let labels = ["Real area of contact", &force.label("Load"), &unit.label("Area")];
    Ok(Some(curves.panel(labels, |view| view.above_y(0.0))))
}

/// The pressure that each share of the contact bears or exceeds.
fn pressures(last: &Table) -> Result<Panel> {
    let (share, unit) = (Unit::share(), Unit::pressure());
    let mut curves = Curves::new();
    let points = last.column("fraction")?.iter().zip(last.column("pressure_Pa")?);
    let points = points.map(|(x, p)| (x * share.factor, p * unit.factor));
    curves.add(points, Pen::line(COLOURS[0]), None);
    let labels = [
        "Pressure that a share of the contact reaches",
        &share.label("Share of the contact"),
        &unit.label("Pressure"),
    ];
    Ok(curves.panel(labels, |view| view.above_y(0.0)))
}

/// The height that each share of a surface reaches, at first and at last.
fn bearing_curves(results: &Results, [first, last]: [&Table; 2]) -> Result<Panel> {
    let heights = |table: &Table, body: &str| {
        table.column(&of_body("height_BODY_m", body)).map(<[f64]>::to_vec)
    };
    let mut known = vec![];
    for (index, body) in results.bodies.iter().enumerate() {
        let [before, after] = [heights(first, body)?, heights(last, body)?];
        // A plane has none.
        if size(&before).max(size(&after)) > 0.0 {
            known.push((index, body, before, after));
        }
    }
    let most = known.iter().map(|known| size(&known.2).max(size(&known.3))).fold(0.0, f64::max);
    let (share, unit) = (Unit::share(), Unit::depth(most));
    let fractions = last.column("fraction")?;
    let points = |heights: &[f64]| -> Vec<(f64, f64)> {
        let points = fractions.iter().zip(heights);
        points.map(|(x, z)| (x * share.factor, z * unit.factor)).collect()
    };
    let mut curves = Curves::new();
    for (index, body, before, after) in &known {
        let colour = 1 + index % 2;
        let same = before.iter().zip(after).all(|(one, other)| (one - other).abs() <= LINE * most);
        if !same {
            curves.add(points(before), Pen::line(PALE[colour]), Some(&format!("{body}, at first")));
        }
        curves.add(points(after), Pen::line(COLOURS[colour]), Some(body));
    }
    let labels = [
        "Bearing curve",
        &share.label("Share of the surface at or above"),
        &unit.label("Height from the mean"),
    ];
    Ok(curves.panel(labels, |view| view))
}

/// The rms height of each body over the progress, where it changes.
fn roughness(results: &Results) -> Option<Panel> {
    let (_, progress) = results.progress();
    let named = |body: &String| {
        let column = of_body("rms_height_BODY_m", body);
        results.history.column(&column).ok().map(|values| (body.clone(), values))
    };
    let known: Vec<_> = results.bodies.iter().enumerate().collect();
    let known: Vec<_> = known.into_iter().filter_map(|(i, body)| Some((i, named(body)?))).collect();
    let most = known.iter().map(|(_, (_, values))| size(values)).fold(0.0, f64::max);
    let changes = |values: &[f64]| {
        let first = values.first().copied().unwrap_or_default();
        values.iter().any(|value| (value - first).abs() > LINE * most)
    };
    if !known.iter().any(|(_, (_, values))| changes(values)) {
        return None;
    }
    let (along, unit) = (results.progress_unit(), Unit::depth(most));
    let mut curves = Curves::new();
    for (index, (body, values)) in &known {
        let points = progress.iter().zip(*values);
        let points = points.map(|(s, sq)| (s * along.factor, sq * unit.factor));
        curves.add(points, Pen::line(COLOURS[1 + index % 2]), Some(body));
    }
    let (column, _) = results.progress();
    let labels =
        ["Roughness", &along.label(&super::scale::phrase(column)), &unit.label("Rms height Sq")];
    Some(curves.panel(labels, |view| view.above_y(0.0)))
}
