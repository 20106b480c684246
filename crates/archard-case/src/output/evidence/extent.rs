//! How many elements lie across a part of the frame.

use archard::frame::ContactFrame;
use archard::problem::ContactProblem;

/// Elements across the pairs that something holds for: along the axis with the fewest on a grid; elsewhere the root of their
/// number, or what fits of their edges along an axis, if that is less: a ring of many narrow elements resolves nothing across.
/// `None` where there are none. Along an axis with one element nothing is resolved on purpose.
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
        let images = frame.mirrored().map(|mirrored| if mirrored { 2.0 } else { 1.0 });
        let root = (count as f64 * images.iter().product::<f64>()).sqrt();
        return Some(root.min(fitting(frame, images, holds)));
    }
    let along = |axis: usize| (elements[axis] > 1).then(|| (high[axis] - low[axis]) as f64);
    Some([along(0), along(1)].into_iter().flatten().fold(f64::INFINITY, f64::min))
        .filter(|n| n.is_finite())
}

/// How many elements fit between the outermost of some pairs, and these, along the axis with the fewest. The longest edge of
/// half a square is root 2 times its side.
fn fitting(frame: &ContactFrame, images: [f64; 2], holds: impl Fn(usize) -> bool) -> f64 {
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    let (mut longest, mut count) = (0.0, 0.0);
    for pair in (0..frame.len()).filter(|&pair| holds(pair)) {
        let outline = frame.outline(pair);
        let ends = outline.iter().zip(outline.iter().cycle().skip(1));
        let edges = ends.map(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1]).hypot(a[2] - b[2]));
        longest += edges.fold(0.0, f64::max);
        count += 1.0;
        let place = frame.place(pair);
        for axis in 0..2 {
            let least = if images[axis] > 1.0 { 0.0 } else { place[axis] };
            (low[axis], high[axis]) = (low[axis].min(least), high[axis].max(place[axis]));
        }
    }
    let along = |axis: usize| images[axis] * (high[axis] - low[axis]);
    1.0 + 2f64.sqrt() * along(0).min(along(1)) * count / longest
}
