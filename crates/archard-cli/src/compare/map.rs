//! A measured height map next to the worn surface of a run.

use anyhow::{Context, Result, ensure};
use archard::simulation::history::{WORN_VOLUME, of_body};
use archard_case::measured::surface::{Scar, Surface, UnwornSurface};
use archard_case::output::Image;
use archard_case::verdict::Verdict;

use super::profile::Reading;
use super::{Comparison, percent, profile};
use crate::plot::LINE;
use crate::plot::figure::{COLOURS, Curves, PALE, Panel, Pen};
use crate::plot::results::Results;
use crate::plot::scale::Unit;
use crate::plot::tables::{Axis, largest};
use crate::report::quantity;

/// The angle (rad) between a track and its map from which on their mean is not that of the track: 2 degrees.
const ASKEW: f64 = 0.035;

/// Compares the surface of a body with a height map; that of a track by its mean section.
pub(super) fn compare(
    results: &Results,
    surface: &Surface,
    body: usize,
    levelled: bool,
) -> Result<Comparison> {
    ensure!(
        !levelled,
        "height maps are levelled by the surface outside the scar: leave --levelled out"
    );
    let shape = profile::shape(results, body)?;
    let passes = results.passes(body);
    let unworn = UnwornSurface::passing(&shape, passes.map(Axis::index));
    let scar = Scar::find(surface, unworn).with_context(|| surface.source().to_owned())?;
    ensure!(
        scar.angle.abs() < ASKEW,
        "{}: the track lies askew in the map by {:.1} degrees, which makes its mean wider: turn the map until the track runs along an axis",
        surface.source(),
        scar.angle.to_degrees()
    );
    let depths = scar.depths(surface, unworn);
    let level = level(&scar);
    let mut comparison = match passes {
        Some(along) => track(results, (surface, &depths), (body, along.other()), &shape)?,
        None => bowl(results, (surface, &scar, &depths), body)?,
    };
    comparison.lines.splice(1..1, level);
    let depth = (scar.plane.scatter / scar.deepest, "depth".to_owned());
    comparison.state([depth, (scar.uncertainty / scar.worn, "worn volume".to_owned())]);
    if scar.gaps > 0 {
        comparison.doubt(&format!(
            "places in the scar without a reading, or with one far off those around it: {}",
            scar.gaps
        ));
    }
    Ok(comparison)
}

/// What was taken off.
fn level(scar: &Scar) -> Vec<[String; 2]> {
    let plane = &scar.plane;
    let line = |name: &str, value: String| [name.to_owned(), value];
    let [x, y] = plane.tilt.map(|tilt| format!("{:.4}", 1e3 * tilt));
    let beside = format!(
        "{} readings outside the scar, scatter {}",
        plane.used,
        quantity(plane.scatter, "m")
    );
    let [left, low] = scar.middle.map(|place| quantity(place, "m"));
    vec![
        line("levelled by", beside),
        line("tilt taken off", format!("{x} \u{b5}m/mm along x, {y} \u{b5}m/mm along y")),
        line("offset taken off", quantity(plane.offset, "m")),
        line("middle of the scar", format!("({left}, {low})")),
    ]
}

/// The mean over the length of a track, as a profile that is level.
fn track(
    results: &Results,
    (surface, depths): (&Surface, &[[f64; 3]]),
    (body, across): (usize, Axis),
    height: &dyn Fn([f64; 2]) -> f64,
) -> Result<Comparison> {
    let mut lines: Vec<(f64, Vec<f64>)> = vec![];
    let mut sorted = depths.to_vec();
    sorted.sort_by(|one, other| one[across.index()].total_cmp(&other[across.index()]));
    for own in sorted {
        let place = own[across.index()];
        match lines.last_mut().filter(|(last, _)| *last == place) {
            Some((_, depths)) => depths.push(own[2]),
            None => lines.push((place, vec![own[2]])),
        }
    }
    let mean = |(place, depths): &(f64, Vec<f64>)| {
        let unworn = if across == Axis::X { height([*place, 0.0]) } else { height([0.0, *place]) };
        (*place, unworn - depths.iter().sum::<f64>() / depths.len() as f64)
    };
    let readings: Vec<Reading> = lines.iter().map(mean).collect();
    profile::compare(results, (surface.source(), readings), (body, across), true)
}

/// The scar of a body that keeps its place under the contact.
fn bowl(
    results: &Results,
    (surface, scar, depths): (&Surface, &Scar, &[[f64; 3]]),
    body: usize,
) -> Result<Comparison> {
    let name = &results.bodies[body];
    let image = results.image.as_ref().context("the run has no fields to compare a map with")?;
    let worn = image.field(&format!("wear_{name}_m")).context("the run has no wear of the body")?;
    let most = largest(worn);
    ensure!(most > 0.0, "`{name}` has no scar: nothing is worn off it");
    let inside: Vec<(f64, f64)> = depths
        .iter()
        .filter_map(|[x, y, depth]| Some((*depth, at(image, worn, [*x, *y])?)))
        .filter(|(_, computed)| *computed > LINE * most)
        .collect();
    ensure!(inside.len() >= 2, "`{}` has no readings where the run has its scar", surface.source());
    let square = inside.iter().map(|(one, other)| (one - other).powi(2)).sum::<f64>();
    let rms = (square / inside.len() as f64).sqrt();
    let line = |name: &str, value: String| [name.to_owned(), value];
    let mut lines = vec![
        line("readings", format!("{}, {} of them at the scar", depths.len(), inside.len())),
        line(
            "difference, RMS",
            format!(
                "{}, {:.1} % of the deepest",
                quantity(rms, "m"),
                100.0 * rms / most.max(scar.deepest)
            ),
        ),
        line(
            "deepest",
            format!(
                "measured {}, computed {}: {}",
                quantity(scar.deepest, "m"),
                quantity(most, "m"),
                percent(scar.deepest, most)
            ),
        ),
    ];
    let volume = results.history.column(&of_body(WORN_VOLUME, name));
    if let Some(volume) = volume.ok().and_then(|values| values.last().copied()) {
        lines.push(line(
            "worn volume",
            format!(
                "measured {} \u{b1} {}, computed {}: {}",
                quantity(scar.worn, "m3"),
                quantity(scar.uncertainty, "m3"),
                quantity(volume, "m3"),
                percent(scar.worn, volume)
            ),
        ));
    }
    let panels = [Axis::X, Axis::Y]
        .into_iter()
        .map(|axis| panel((name, body, axis), depths, (image, worn), scar))
        .collect();
    let title = format!("{name} compared with the map `{}`", surface.source());
    let verdict = Verdict::default();
    Ok(Comparison { title, lines, remarks: vec![], verdict, panels })
}

/// A field at a place, from the centres of the elements around it; `None` beyond the frame.
fn at(image: &Image, values: &[f64], place: [f64; 2]) -> Option<f64> {
    let [columns, rows] = image.elements;
    let mut corner = [0; 2];
    let mut share = [0.0; 2];
    for axis in 0..2 {
        let along = (place[axis] - image.origin[axis]) / image.spacing[axis];
        if !(0.0..=image.elements[axis] as f64).contains(&along) {
            return None;
        }
        let along = (along - 0.5).clamp(0.0, image.elements[axis] as f64 - 1.0);
        corner[axis] = (along as usize).min(image.elements[axis].saturating_sub(2));
        share[axis] = along - corner[axis] as f64;
    }
    let value = |x: usize, y: usize| {
        values[(corner[0] + x).min(columns - 1) + columns * (corner[1] + y).min(rows - 1)]
    };
    let row = |y: usize| value(0, y) + share[0] * (value(1, y) - value(0, y));
    Some(row(0) + share[1] * (row(1) - row(0)))
}

/// The sections of map and run through the middle along an axis.
fn panel(
    (name, body, axis): (&str, usize, Axis),
    depths: &[[f64; 3]],
    (image, worn): (&Image, &[f64]),
    scar: &Scar,
) -> Panel {
    let (along, across) = (axis.index(), axis.other().index());
    let [low, high] = scar.extent[along].map(|place| place - scar.middle[along]);
    let reach = high.max(-low) * 1.5;
    let nearest = depths.iter().map(|own| own[across].abs()).fold(f64::INFINITY, f64::min);
    let measured: Vec<Reading> = depths
        .iter()
        .filter(|own| own[across].abs() <= nearest * (1.0 + 1e-9) && own[along].abs() <= reach)
        .map(|own| (own[along], own[2]))
        .collect();
    let computed: Vec<Reading> = (-100..=100)
        .filter_map(|i| {
            let mut place = [0.0; 2];
            place[along] = reach * f64::from(i) / 100.0;
            Some((place[along], at(image, worn, place)?))
        })
        .collect();
    let (width, depth) = (Unit::across(reach), Unit::depth(largest(worn).max(scar.deepest)));
    let scaled = |(x, z): &Reading| (x * width.factor, z * depth.factor);
    let mut curves = Curves::new();
    curves.mark(measured.iter().map(scaled), PALE[1 + body % 2], Some("measured"));
    curves.add(computed.iter().map(scaled), Pen::line(COLOURS[1 + body % 2]), Some("computed"));
    let title = format!("Worn off {name}, through the middle along {}", axis.name());
    let labels = [&*title, &width.label(axis.name()), &depth.label("Depth")];
    curves.panel(labels, |view| view)
}
