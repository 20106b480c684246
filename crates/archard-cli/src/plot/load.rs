//! Load over approach, with Hertz next to it.

use anyhow::Result;
use archard::simulation::history::{APPROACH, LOAD};

use super::CELLS;
use super::figure::{Curves, LegendPosition, OTHERS, Panel, Pen};
use super::results::Results;
use super::scale::Unit;
use super::tables::{largest, size};

/// The load over the approach of the bodies; nothing where none exists.
pub(crate) fn panel(results: &Results) -> Result<Option<Panel>> {
    let load = results.history.column(LOAD)?;
    let approach = results.history.column(APPROACH)?;
    if size(load) == 0.0 || size(approach) == 0.0 {
        return Ok(None);
    }
    let (unit, force) = (Unit::depth(largest(approach)), Unit::force(largest(load)));
    let mut curves = Curves::new();
    let hertz: Vec<_> = (0..=CELLS)
        .map(|point| largest(load) * (point as f64 / CELLS as f64).powi(2))
        .filter_map(|load| results.hertz(load))
        .map(|hertz| (hertz.approach * unit.factor, hertz.load * force.factor))
        .collect();
    if !hertz.is_empty() {
        curves.add(hertz, Pen::closed_form(), Some("Hertz"));
    }
    let points = approach.iter().zip(load).map(|(d, f)| (d * unit.factor, f * force.factor));
    curves.mark(points, OTHERS[0], Some("computed"));
    Ok(Some(curves.panel(["Load", &unit.label("Approach"), &force.label("Load")], |view| {
        view.legend(LegendPosition::InsideTopLeft)
    })))
}
