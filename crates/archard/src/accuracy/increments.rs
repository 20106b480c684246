//! The increments of a cycle in which bodies rub: they err as elements do, are chosen with them, and companions take fewer.

/// The most that are chosen.
pub const MOST: usize = 400;
/// Those of fretting are a multiple of this.
pub const DIVISOR: f64 = 4.0;
/// The fewest whose error is told by fewer: companions then take eight and four.
pub const FEWEST: usize = 16;

/// That many times fewer.
pub(super) fn fewer(count: usize, ratio: f64) -> usize {
    ((count as f64 / ratio / DIVISOR).floor().max(1.0) * DIVISOR) as usize
}

/// That many times as many, as far as that is allowed.
pub(super) fn more(count: usize, finer: f64) -> usize {
    let more = (finer * count as f64 / DIVISOR).ceil() * DIVISOR;
    (more as usize).min(MOST.max(count))
}
