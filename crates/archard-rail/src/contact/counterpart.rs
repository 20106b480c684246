//! The same patch on another grid.
//!
//! The height at which the wheel bears its load differs a little from grid to grid, and so do overlaps: a grid may miss a patch of another
//! one, or join two of its patches. The counterpart of a patch is the patch over the same width of rail. Where a grid has none there is a
//! gap: the counterpart bears nothing, at the place that would touch first.

use super::Pressed;

/// The counterpart of a patch among those of a grid; `None` where that has none.
pub(super) fn on<'a>(grid: &'a [Pressed], pressed: &Pressed) -> Option<&'a Pressed> {
    let shared = |other: &Pressed| {
        let [own, other] = [pressed, other].map(width);
        own[1].min(other[1]) - own[0].max(other[0])
    };
    let widest = grid.iter().max_by(|one, other| shared(one).total_cmp(&shared(other)));
    widest.filter(|other| shared(other) > 0.0)
}

/// The least and the largest y (m) of the overlap in the track.
fn width(pressed: &Pressed) -> [f64; 2] {
    let patch = &pressed.patch;
    patch.across.map(|s| patch.reference.y + s * patch.angle.cos())
}
