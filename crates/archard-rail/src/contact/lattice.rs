//! A patch of overlap on a grid of its tangent plane.

use archard::body::Profile;
use archard::frame::Rectangle;
use archard::parameters::Invalid;

use super::ContactError;
use crate::search::{Patch, Search};

/// Widths of its widest stretch that a patch may be wide: grids of more would take minutes.
const WIDEST: f64 = 64.0;

/// The gap over the elements of a rectangle of the tangent plane: the recess of the wheel, the rail taken for flat.
#[derive(Debug, Clone)]
pub(super) struct Lattice {
    pub rectangle: Rectangle,
    pub elements: [usize; 2],
    /// Gap (m) of the undeformed bodies, negative where they overlap, x fastest.
    gap: Vec<f64>,
}

impl Lattice {
    /// The grid over the rectangle that holds the overlap: so many elements along x, and along s as many over the widest
    /// stretch. Pressures open gaps, so that nothing touches next to the overlap.
    ///
    /// # Errors
    /// If the wheel or the rail ends within it, or its stretches are too narrow for their distance.
    pub fn over(search: &Search<'_>, patch: &Patch, elements: usize) -> Result<Self, ContactError> {
        let ranges = [patch.along, patch.across];
        let stretches = (patch.across[1] - patch.across[0]) / patch.widest;
        if stretches > WIDEST {
            let message = "stretches of overlap are far apart for their widths: give a smaller one";
            return Err(Invalid::new("join", message).into());
        }
        // The overlap and its stretches are the same on all grids, and so is this number.
        let counts = [elements, elements * stretches.round().max(1.0) as usize];
        let rectangle = Rectangle {
            centre: ranges.map(|[from, to]| 0.5 * (from + to)),
            size: ranges.map(|[from, to]| to - from),
        };
        let [x, s] = [0, 1].map(|axis| {
            let ([from, to], count) = (ranges[axis], counts[axis]);
            let middle = |at: usize| from + (to - from) * (at as f64 + 0.5) / count as f64;
            (0..count).map(middle).collect::<Vec<f64>>()
        });
        let columns = search.gap(patch).grid(&x, &s);
        let turned = |at: usize| columns[(at % counts[0]) * counts[1] + at / counts[0]];
        let gap: Vec<f64> = (0..columns.len()).map(turned).collect();
        if gap.iter().all(|gap| gap.is_finite()) {
            Ok(Self { rectangle, elements: counts, gap })
        } else {
            Err(ContactError::Short { y: patch.reference.y })
        }
    }

    /// The largest overlap (m).
    pub fn approach(&self) -> f64 {
        -self.gap.iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// The overlap (m) on an element, negative where there is a gap.
    pub fn overlap(&self, element: usize) -> f64 {
        -self.gap[element]
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
