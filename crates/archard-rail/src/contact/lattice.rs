//! A patch of overlap on a grid of its tangent plane.

use archard::body::Profile;
use archard::frame::Rectangle;

use crate::search::{Patch, Search};

/// The gap over the elements of a rectangle of the tangent plane: the recess of the wheel, the rail taken for flat.
#[derive(Debug, Clone)]
pub(super) struct Lattice {
    pub rectangle: Rectangle,
    pub elements: [usize; 2],
    /// Gap (m) of the undeformed bodies, negative where they overlap, x fastest.
    gap: Vec<f64>,
}

impl Lattice {
    /// The grid of so many elements along x and as many along s over the rectangle that holds the overlap. Pressures open
    /// gaps, so that nothing touches beside the overlap.
    pub fn over(search: &Search<'_>, patch: &Patch, elements: usize) -> Self {
        let ranges = [patch.along, patch.across];
        let rectangle = Rectangle {
            centre: ranges.map(|[from, to]| 0.5 * (from + to)),
            size: ranges.map(|[from, to]| to - from),
        };
        let middles = ranges.map(|[from, to]| {
            let middle = |at: usize| from + (to - from) * (at as f64 + 0.5) / elements as f64;
            (0..elements).map(middle).collect::<Vec<f64>>()
        });
        let rows = search.gap(patch).grid(&middles[0], &middles[1]);
        let gap = (0..elements * elements)
            .map(|at| rows[(at % elements) * elements + at / elements])
            .collect();
        Self { rectangle, elements: [elements; 2], gap }
    }

    /// The largest overlap (m).
    pub fn approach(&self) -> f64 {
        -self.gap.iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// Whether wheel and rail reach over all of it.
    pub fn is_whole(&self) -> bool {
        self.gap.iter().all(|gap| gap.is_finite())
    }

    /// s (m) of the middle of a row.
    pub fn across(&self, row: usize) -> f64 {
        let [_, width] = self.rectangle.size;
        self.rectangle.corner()[1] + width * (row as f64 + 0.5) / self.elements[1] as f64
    }
}

impl Profile for Lattice {
    fn recess(&self, x: f64, y: f64) -> f64 {
        let corner = self.rectangle.corner();
        let [column, row] = [0, 1].map(|axis| {
            let share = ([x, y][axis] - corner[axis]) / self.rectangle.size[axis];
            let count = self.elements[axis];
            ((share * count as f64) as usize).min(count - 1)
        });
        self.gap[column + self.elements[0] * row]
    }
}
