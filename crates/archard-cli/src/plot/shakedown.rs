//! Johnson's map: a contact's peak pressure over the yield stress in shear, and its friction.

use anyhow::Result;
use archard::closed_form::shakedown::{Limits, REACH};
use archard::simulation::history::{FORCE, LOAD, PEAK_PRESSURE};

use super::figure::{COLOURS, Curves, PALE, Panel, Pen};
use super::results::Results;

/// Places along the axis of friction.
const STEPS: usize = 100;
/// Semi-axes of a contact that is no more than this much longer one way is about a circle: a choice of what the map of a ball is shown for.
const ROUND: f64 = 1.1;

/// The map with the bodies on it; `None` where no strength is known, and of contacts that are neither lines nor circles.
pub(crate) fn panel(results: &Results) -> Result<Option<Panel>> {
    let last = |column: &str| Some(*results.history.column(column).ok()?.last()?);
    let line = results.case.as_ref().is_some_and(|case| case.frame.line);
    let hertz = last(LOAD).and_then(|load| results.hertz(load));
    let round = hertz.is_some_and(|own| {
        let [x, y] = own.semi_axes;
        x.max(y) <= ROUND * x.min(y)
    });
    let (Some(peak), true) = (last(PEAK_PRESSURE), line || round) else { return Ok(None) };
    let known = |body: &String| {
        let block = &results.summary["stress"][body];
        let bare = block["layers"].is_null();
        block["yield"]["strength_Pa"].as_f64().filter(|_| bare)
    };
    let bodies: Vec<(usize, f64)> = results
        .bodies
        .iter()
        .enumerate()
        .filter_map(|(index, body)| Some((index, known(body)?)))
        .collect();
    if bodies.is_empty() {
        return Ok(None);
    }
    let friction = friction(results, peak)?;
    let map = (0..=STEPS).filter_map(|step| {
        let friction = REACH * step as f64 / STEPS as f64;
        Some((friction, Limits::of(line, friction)?))
    });
    let map: Vec<(f64, Limits)> = map.collect();
    let mut curves = Curves::new();
    let [low, high] = [0, 1].map(|end| map.iter().map(move |(x, own)| (*x, own.shakedown[end])));
    match line {
        true => curves.add(low, Pen::line(COLOURS[0]), Some("shakedown (Melan)")),
        false => {
            let (low, high): (Vec<_>, Vec<_>) = (low.collect(), high.collect());
            let band = low.iter().zip(&high).map(|((x, low), (_, high))| [*x, *low, *high]);
            curves.band(band, PALE[0], 0.5, None);
            let pen = || Pen { width: 1.2, ..Pen::line(COLOURS[0]) };
            curves.add(low, pen(), Some("shakedown, an estimate"));
            curves.add(high, pen(), None);
        }
    }
    let yields = map.iter().map(|(x, own)| (*x, own.first_yield));
    curves.add(yields, Pen::line(PALE[0]), Some("first yield, Poisson's ratio 0.3"));
    for (index, strength) in bodies {
        let over = peak * 3f64.sqrt() / strength;
        let colour = COLOURS[1 + index % 2];
        curves.mark([(friction, over)], colour, Some(&results.bodies[index]));
    }
    let labels = [
        if line {
            "Johnson's map of a line of contact"
        } else {
            "Johnson's map of a round contact, an estimate"
        },
        "Friction over pressure",
        "Peak pressure over yield stress in shear",
    ];
    Ok(Some(curves.panel(labels, |view| view.above_y(0.0))))
}

/// The friction that is used: the largest force along the surface over the load, or what slides.
fn friction(results: &Results, peak: f64) -> Result<f64> {
    let columns = [FORCE[0], FORCE[1], LOAD].map(|name| results.history.column(name).ok());
    if let [Some(x), Some(y), Some(load)] = columns {
        let each = x.iter().zip(y).zip(load).filter(|(_, load)| **load > 0.0);
        return Ok(each.map(|((x, y), load)| x.hypot(*y) / load).fold(0.0, f64::max));
    }
    let along = results.axes()[0];
    let limits = results.friction_limits(&[peak], along);
    Ok(limits.map_or(0.0, |limits| limits[0] / peak))
}
