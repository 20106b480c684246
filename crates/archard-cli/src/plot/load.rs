//! Load over approach, with Hertz beside it.

use anyhow::Result;
use archard::simulation::history::{APPROACH, LOAD};
use kuva::plot::LegendPosition;

use super::figure::{COLOURS, Curves, Panel, Pen};
use super::results::Results;
use super::scale::Unit;
use super::tables::largest;

/// Points of the curve of the closed form.
const POINTS: usize = 100;

/// The load over the approach of the bodies.
pub(super) fn panel(results: &Results) -> Result<Panel> {
    let load = results.history.column(LOAD)?;
    let approach = results.history.column(APPROACH)?;
    let (unit, force) = (Unit::depth(largest(approach)), Unit::force(largest(load)));
    let mut curves = Curves::new();
    let hertz: Vec<_> = (0..=POINTS)
        .map(|point| largest(load) * (point as f64 / POINTS as f64).powi(2))
        .filter_map(|load| results.hertz(load))
        .map(|hertz| (hertz.approach * unit.factor, hertz.load * force.factor))
        .collect();
    if !hertz.is_empty() {
        curves.add(hertz, Pen::closed_form(), Some("Hertz"));
    }
    let points = approach.iter().zip(load).map(|(d, f)| (d * unit.factor, f * force.factor));
    curves.mark(points, COLOURS[1], Some("computed"));
    Ok(curves.panel(["Load", &unit.label("Approach"), &force.label("Load")], |layout| {
        layout.with_legend_position(LegendPosition::InsideTopLeft)
    }))
}
