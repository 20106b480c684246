//! Along which axes the shape of the bodies does not change.

use super::ContactProblem;
use crate::frame::Rectangle;
use crate::numerics::SAME;

impl ContactProblem {
    /// Whether the profiles do not change along an axis: an infinitely long line contact is cut off anywhere.
    pub fn is_even(&self, axis: usize) -> bool {
        let Rectangle { centre, size } = self.frame.rectangle();
        let gap = |along: f64, across: f64| -> Option<f64> {
            let mut place = centre;
            place[axis] += along * size[axis];
            place[1 - axis] += across * size[1 - axis];
            let recess = |index: usize| self.bodies[index].profile.recess(place[0], place[1]);
            let gap = recess(0) + recess(1);
            gap.is_finite().then_some(gap)
        };
        // Within the outermost elements, where tables still have values.
        let reach = 0.5 - 0.5 / self.frame.elements()[axis].max(2) as f64;
        [-0.4, -0.1, 0.0, 0.2, 0.45].into_iter().all(|across| {
            let [low, middle, high] = [-reach, 0.0, reach].map(|along| gap(along, across));
            let (Some(low), Some(middle), Some(high)) = (low, middle, high) else { return false };
            let scale = size[axis].max(low.abs()).max(high.abs()) * SAME;
            (low - middle).abs() <= scale && (high - middle).abs() <= scale
        })
    }
}
