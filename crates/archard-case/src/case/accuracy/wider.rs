//! Where a frame becomes wider on the way, because elements for the first contact would be too many for the last scar.

use super::{BESIDE, Frame, around, locate};
use crate::case::check::Parts;
use crate::case::definition::FrameCase;
use archard::body::Body;
use archard::estimate::Estimator;
use archard::frame::Rectangle;
use archard::numerics::{SAME, counted};
use archard::simulation::can_widen;

/// How many times fewer elements make it worth while. A choice of cost.
const WORTH: f64 = 4.0;

/// The frame about the same centre that begins with elements of a size (m) and keeps so many across the contact, as long
/// as closed forms tell how far that reaches; `None` where one frame does.
pub(super) fn widening(
    parts: &Parts<'_>,
    one: &Frame,
    element: [f64; 2],
    across: f64,
) -> Option<Frame> {
    let odd = one.frame.elements.iter().any(|elements| elements % 2 == 1);
    if odd || !can_widen(&parts.motion) {
        return None;
    }
    let (estimator, extent) = (Estimator::default(), parts.schedule.extent);
    let last = parts.estimate(&estimator, extent);
    if last.cap.is_none() && last.track.is_none() {
        return None;
    }
    let reach = |place: f64| parts.estimate(&estimator, place).reach();
    // By how much the elements could be larger.
    let larger = |place: f64| {
        let reach = reach(place)?;
        Some(
            (0..2)
                .map(|axis| 2.0 * reach[axis] / across / element[axis])
                .fold(f64::INFINITY, f64::min),
        )
    };
    let times = larger(extent).filter(|larger| larger.is_finite())?.log2().floor();
    let mut doubles = vec![];
    for time in 1..=times as i32 {
        doubles.push(first_place(extent, |place| {
            larger(place).is_some_and(|one| one >= 2f64.powi(time))
        }));
    }
    let mut frame = FrameCase { elements: [0; 2], ..one.frame };
    let mut factor = 1.0;
    for place in doubles.iter().copied().chain([extent]) {
        let reach = reach(place)?;
        for axis in 0..2 {
            let element = factor * element[axis];
            let wanted = around(BESIDE * reach[axis], element) / element;
            frame.elements[axis] = frame.elements[axis].max(counted(wanted, 0));
        }
        factor *= 2.0;
    }
    frame.size = [0, 1].map(|axis| element[axis] * frame.elements[axis] as f64);
    let widest = frame.size.map(|side| 0.5 * factor * side);
    let widest = Rectangle { centre: frame.centre, size: widest };
    let pairs = |elements: [usize; 2]| elements[0] as f64 * elements[1] as f64;
    let fits = locate::within(widest, Body::known(&parts.bodies)) == widest;
    let worth = WORTH * pairs(frame.elements) <= pairs(one.frame.elements);
    (fits && worth).then_some(Frame { frame, doubles, found: one.found })
}

/// The first place of a way from which on something holds, which holds at its end.
fn first_place(extent: f64, holds: impl Fn(f64) -> bool) -> f64 {
    let (mut low, mut high) = ((f64::EPSILON * extent).ln(), extent.ln());
    while high - low > SAME {
        let middle = 0.5 * (low + high);
        if holds(middle.exp()) { high = middle } else { low = middle }
    }
    rounded(high.exp()).min(extent)
}

/// A place in three digits.
fn rounded(place: f64) -> f64 {
    format!("{place:.2e}").parse().unwrap_or(place)
}
