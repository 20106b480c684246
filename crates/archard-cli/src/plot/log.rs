//! Logs of tribometers: the depth over the distance with the rate of the steady part, and friction.

use std::path::{Path, PathBuf};

use anyhow::{Result, ensure};
use archard_log::{Log, Rate, Step};

use super::draw::{Paper, Sheet, save};
use super::figure::{COLOURS, Curves, LegendPosition, PALE, Panel, Pen};
use super::scale::Unit;
use super::surface::format_of;
use super::{CELLS, PANEL, SHOWN};

/// Draws the steps of logs into a file, whose ending says its kind: depths, and friction where there is room.
///
/// # Errors
/// If the ending is not known, there is nothing to draw, or the file cannot be written.
pub(crate) fn draw(file: &Path, logs: &[Log]) -> Result<Vec<PathBuf>> {
    let paper = Paper { width: None, formats: vec![format_of(file)?] };
    let steps = || logs.iter().flat_map(|log| log.steps.iter().map(move |step| (log.name(), step)));
    let mut panels: Vec<Panel> = steps().filter_map(|(name, step)| depth(&name, step)).collect();
    let frictions = steps().filter_map(|(name, step)| friction(&name, step));
    if panels.len() < 2 {
        panels.extend(frictions);
    }
    ensure!(
        !panels.is_empty(),
        "the logs hold neither depth nor friction under load and in motion"
    );
    let all = panels.len();
    panels.truncate(SHOWN);
    let mark = (all > SHOWN).then(|| format!("The first {SHOWN} of {all} steps"));
    let columns = if panels.len() > 3 { 2 } else { panels.len() };
    save(file, &Sheet { columns, size: PANEL, paper: &paper }, (panels, mark.as_deref()))
}

/// Readings in as many cells as can be told apart, each from the lowest to the highest.
fn readings(points: &[[f64; 2]], [x, y]: [f64; 2]) -> Vec<[f64; 3]> {
    let per_cell = points.len().div_ceil(CELLS).max(1);
    let cell = |cell: &[[f64; 2]]| {
        let low = cell.iter().map(|point| point[1]).fold(f64::INFINITY, f64::min);
        let high = cell.iter().map(|point| point[1]).fold(f64::NEG_INFINITY, f64::max);
        let middle = 0.5 * (cell[0][0] + cell[cell.len() - 1][0]);
        [middle * x, low * y, high * y]
    };
    points.chunks(per_cell).map(cell).collect()
}

fn depth(name: &str, step: &Step) -> Option<Panel> {
    let points = &step.course.depth;
    let (first, last) = (points.first()?, points.last()?);
    let largest = points.iter().map(|point| (point[1] - first[1]).abs()).fold(0.0, f64::max);
    let (along, unit) = (Unit::of_column("distance_m", last[0]), Unit::depth(largest));
    let from_zero = |all: &[[f64; 2]]| -> Vec<[f64; 2]> {
        all.iter().map(|[at, depth]| [*at, depth - first[1]]).collect()
    };
    let points = from_zero(points);
    let mut curves = Curves::new();
    let read = readings(&points, [along.factor, unit.factor]);
    let lines = read.iter().flat_map(|[x, low, high]| [(*x, *low), (*x, *high)]);
    curves.add(lines, Pen::line(PALE[0]), Some("readings"));
    if let Some(rate) = &step.steady {
        let [low, middle, high] = fitted(step, rate, &points);
        let scaled = |line: &[(f64, f64)]| -> Vec<(f64, f64)> {
            line.iter().map(|(x, y)| (x * along.factor, y * unit.factor)).collect()
        };
        let ends = scaled(&low).into_iter().zip(scaled(&high));
        let ends = ends.map(|((x, one), (_, other))| [x, one.min(other), one.max(other)]);
        curves.band(ends, COLOURS[1], 0.3, None);
        let per_metre = Unit::depth(rate.rate.abs());
        let words = format!("steady, {} per m", per_metre.show(rate.rate));
        curves.add(scaled(&middle), Pen::line(COLOURS[1]), Some(&words));
    }
    let spikes = from_zero(&step.course.spikes);
    if !spikes.is_empty() {
        let words = format!("{} spikes, left out", spikes.len());
        let spikes = spikes.iter().map(|[x, y]| (x * along.factor, y * unit.factor));
        curves.mark(spikes, COLOURS[2], Some(&words));
    }
    let title = step
        .load
        .map_or(name.to_owned(), |load| format!("{name}, {}", Unit::force(load).show(load)));
    let labels = [&*title, &along.label("Distance"), &unit.label("Depth")];
    Some(curves.panel(labels, |view| view.legend(LegendPosition::InsideTopLeft)))
}

/// The line of the steady rate and those of the ends of its interval, through the middle of its readings, with the jumps.
fn fitted(step: &Step, rate: &Rate, points: &[[f64; 2]]) -> [Vec<(f64, f64)>; 3] {
    let [from, to] = rate.part;
    let jumped = |at: f64| -> f64 {
        step.jumps.iter().filter(|(place, _)| *place <= at).map(|(_, height)| height).sum()
    };
    let own: Vec<&[f64; 2]> =
        points.iter().filter(|point| (from..=to).contains(&point[0])).collect();
    let n = own.len().max(1) as f64;
    let middle = own.iter().map(|point| point[0]).sum::<f64>() / n;
    let level = own.iter().map(|[at, depth]| depth - jumped(*at)).sum::<f64>() / n;
    let jumps = step.jumps.iter().map(|(place, _)| *place).filter(|at| (from..to).contains(at));
    let mut places = vec![from, middle, to];
    // A reading before a jump stands a bit of a metre before it.
    places.extend(jumps.flat_map(|at| [at - 1e-9 * (to - from), at]));
    places.sort_by(f64::total_cmp);
    let line = |slope: f64| {
        places.iter().map(|at| (*at, level + slope * (at - middle) + jumped(*at))).collect()
    };
    [line(rate.interval[0]), line(rate.rate), line(rate.interval[1])]
}

fn friction(name: &str, step: &Step) -> Option<Panel> {
    let points = &step.course.friction;
    let along = Unit::of_column("distance_m", points.last()?[0]);
    let mut curves = Curves::new();
    let read = readings(points, [along.factor, 1.0]);
    let lines = read.iter().flat_map(|[x, low, high]| [(*x, *low), (*x, *high)]);
    curves.add(lines, Pen::line(PALE[0]), Some("readings"));
    let part = step.steady.map_or([points[0][0], points[points.len() - 1][0]], |rate| rate.part);
    if let Some((mean, [low, high])) = step.friction {
        let ends = part.map(|at| at * along.factor);
        curves.band(ends.map(|at| [at, low, high]), COLOURS[1], 0.3, None);
        let words = format!("mean {mean:.3}");
        curves.add(ends.map(|at| (at, mean)), Pen::line(COLOURS[1]), Some(&words));
    }
    let labels = [name, &along.label("Distance"), "Friction coefficient"];
    Some(curves.panel(labels, |view| view.above_y(0.0).legend(LegendPosition::InsideBottomRight)))
}
