//! How many elements lie across a part of the frame.

use crate::problem::ContactProblem;

/// Elements across the pairs of which something holds: along the axis with the fewest on a grid, the root of their number
/// elsewhere; `None` where there are none. Along an axis with one element nothing is resolved on purpose.
pub(super) fn across(problem: &ContactProblem, holds: impl Fn(usize) -> bool) -> Option<f64> {
    let frame = &problem.frame;
    let elements = frame.elements();
    let (mut low, mut high, mut count) = (elements, [0, 0], 0);
    for pair in (0..frame.len()).filter(|&pair| holds(pair)) {
        count += 1;
        for (axis, index) in
            [pair % elements[0].max(1), pair / elements[0].max(1)].into_iter().enumerate()
        {
            (low[axis], high[axis]) = (low[axis].min(index), high[axis].max(index + 1));
        }
    }
    if count == 0 {
        return None;
    }
    if !frame.is_uniform() {
        let images = frame.mirrored().into_iter().map(|mirrored| if mirrored { 2.0 } else { 1.0 });
        return Some((count as f64 * images.product::<f64>()).sqrt());
    }
    let along = |axis: usize| (elements[axis] > 1).then(|| (high[axis] - low[axis]) as f64);
    Some([along(0), along(1)].into_iter().flatten().fold(f64::INFINITY, f64::min))
        .filter(|n| n.is_finite())
}
