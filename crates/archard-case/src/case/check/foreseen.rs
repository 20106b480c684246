//! The lines of a verdict that can be foreseen: elements across the contact, and what a plane frame neglects.

use super::{Forecast, Parts};
use crate::output::Stations;
use crate::verdict::{self, Line, Verdict};
use archard::estimate::ConformingEdge;

/// The verdict on a run, as far as closed forms tell.
pub(super) fn verdict(parts: &Parts<'_>, forecast: &Forecast) -> Verdict {
    let width = forecast.estimate.reach().map(|[x, y]| 2.0 * x.min(y));
    let stations = parts.motion.table().and_then(Stations::of);
    let stations = stations.iter().flat_map(|stations| stations.lines(width));
    Verdict { lines: of_contact(parts, forecast).into_iter().chain(stations).collect() }
}

/// How finely the contact is divided, and what a plane frame neglects.
fn of_contact(parts: &Parts<'_>, forecast: &Forecast) -> Vec<Line> {
    let (Some(first), Some(reach)) = (forecast.cells_across, forecast.estimate.reach()) else {
        return vec![];
    };
    if parts.case.is_meshed() {
        return vec![];
    }
    let frame = &parts.case.last_frame();
    let (spacing, elements) = (frame.spacing(), frame.elements);
    let fewest = |across: [f64; 2]| {
        let resolved = (0..2).filter(|&axis| elements[axis] > 1).map(|axis| across[axis]);
        resolved.fold(f64::INFINITY, f64::min)
    };
    // Frames grow, but along contacts that do not end.
    let last = [0, 1].map(|axis| match reach[axis].is_finite() {
        true => 2.0 * reach[axis] / spacing[axis],
        false => elements[axis] as f64,
    });
    let rows = [verdict::first_contact(fewest(first)), verdict::contact(fewest(last))];
    let rows = rows.into_iter().filter(|line| line.value.is_finite());
    rows.chain(neglected(parts, reach)).collect()
}

/// What a plane frame neglects of half-spaces that conform, where their contact reaches so far (m) along x and y.
pub(super) fn neglected(parts: &Parts<'_>, reach: [f64; 2]) -> impl Iterator<Item = Line> + use<> {
    let conforming = ConformingEdge::of(&parts.bodies, reach).filter(|_| !parts.case.is_meshed());
    let lines = conforming
        .map(|ConformingEdge { form, slope }| [verdict::form(form), verdict::slope(slope)]);
    lines.into_iter().flatten()
}
