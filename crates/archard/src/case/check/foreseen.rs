//! The lines of a verdict that can be foreseen: elements across the contact, and whether it reaches the edge of its frame.

use super::{Forecast, Parts};
use crate::verdict::{self, Verdict};

/// The verdict on a run, as far as closed forms tell.
pub(super) fn verdict(parts: &Parts<'_>, forecast: &Forecast) -> Verdict {
    let (Some(first), Some(reach)) = (forecast.cells_across, forecast.estimate.reach()) else {
        return Verdict::default();
    };
    if parts.case.is_meshed() {
        return Verdict::default();
    }
    let frame = &parts.case.last_frame();
    let (spacing, elements) = (frame.spacing(), frame.elements);
    let fewest = |across: [f64; 2]| {
        let resolved = (0..2).filter(|&axis| elements[axis] > 1).map(|axis| across[axis]);
        resolved.fold(f64::INFINITY, f64::min)
    };
    let last = [0, 1].map(|axis| (2.0 * reach[axis] / spacing[axis]).min(elements[axis] as f64));
    // Under an ellipsoid of pressures, the share of the load beyond some part of a semi-axis.
    let beyond = |axis: usize| {
        let inner = (0.5 * frame.rectangle().about_origin()[axis] - spacing[axis]) / reach[axis];
        let inner = inner.clamp(0.0, 1.0);
        if reach[axis].is_finite() { 1.0 - 0.5 * inner * (3.0 - inner * inner) } else { 0.0 }
    };
    let rows = [verdict::first_contact(fewest(first)), verdict::contact(fewest(last))];
    let rows = rows.into_iter().filter(|line| line.value.is_finite());
    let edges = verdict::edges(beyond(0) + beyond(1), 0);
    Verdict { lines: rows.chain([edges]).collect() }
}
