//! Whether surfaces can repeat themselves without end with a frame.

use crate::frame::ContactFrame;
use crate::motion::{Lever, Motion, Passage};
use crate::parameters::Invalid;

/// From the last element to the first the gap changes by at most so many times what it changes by elsewhere. That is one change
/// of as many as there are elements along an axis: of a surface that repeats itself it is seldom the largest, and hardly twice that.
const JUMPS: f64 = 2.0;

/// What keeps surfaces from repeating themselves with a frame, if anything does.
pub fn repeats(motion: &Motion, frame: &ContactFrame) -> Result<(), Invalid> {
    let wrong = |message: &str| Err(Invalid::new("periodic", message));
    if motion.driven(0.0).is_some() {
        return wrong(
            "bodies that roll have one contact: `frame.periodic` is for surfaces that stay",
        );
    }
    if !motion.stays() && !motion.surfaces.contains(&Passage::Recurs) {
        return wrong(
            "surfaces on a track or that swing do not repeat themselves: `frame.periodic` is for those that stay, or slide with `surfaces = \"pass\"`",
        );
    }
    if motion.lever_arm() == Some(Lever::Radius) {
        return wrong(
            "bodies that turn have one axis: `frame.periodic` is for surfaces without one",
        );
    }
    let elements = frame.elements();
    let axes = if frame.is_line() { 1 } else { 2 };
    for axis in 0..axes {
        if elements[axis] % 2 == 1 {
            return wrong("surfaces that repeat themselves take an even number of elements");
        }
        // The largest difference between neighbours, and between the last and the first.
        let [stride, count] = [[1, elements[0]][axis], elements[axis]];
        let (mut within, mut around) = (0.0_f64, 0.0_f64);
        for (pair, gap) in frame.gap().iter().enumerate() {
            let place = pair / stride % count;
            if place + 1 < count {
                within = within.max((frame.gap()[pair + stride] - gap).abs());
            } else {
                around = around.max((frame.gap()[pair - place * stride] - gap).abs());
            }
        }
        if around > JUMPS * within {
            let message = format!(
                "the surfaces do not repeat themselves along {}: from the last element to the first the gap changes by {:.3} um, {:.3} um elsewhere at most",
                ["x", "y"][axis],
                1e6 * around,
                1e6 * within
            );
            return Err(Invalid::new("periodic", message));
        }
    }
    Ok(())
}
