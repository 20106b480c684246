//! A uniform grid of pairs.

use super::{Part, Rectangle, Wrap};

/// A uniform rectangular grid.
#[derive(Debug, Clone, Copy)]
pub(super) struct Grid {
    /// What it covers.
    pub rectangle: Rectangle,
    /// Number of elements along x and y.
    pub elements: [usize; 2],
    /// Whether the strain is plane, in each row of elements along x by itself.
    pub line: bool,
    /// Whether all pairs may touch.
    pub closed: bool,
    /// Where values at the centre are read: half elements from the lower sides. A frame that grows keeps the place.
    pub middle: [isize; 2],
    /// What it is drawn on, between bodies that fit into each other.
    pub wrap: Option<Wrap>,
}

impl Grid {
    /// Elements on a rectangle, with the centre in its middle.
    pub fn on(rectangle: Rectangle, elements: [usize; 2], line: bool) -> Self {
        let middle = elements.map(|count| count as isize);
        Self { rectangle, elements, line, closed: false, middle, wrap: None }
    }

    /// The elements of a part of it.
    pub fn within(&self, part: &Part) -> Self {
        let first = part.extent().map(|range| range.start as isize);
        let middle = [0, 1].map(|axis| self.middle[axis] - 2 * first[axis]);
        Self { rectangle: part.rectangle(self.rectangle), elements: part.size(), middle, ..*self }
    }

    /// The grid that it is a part of.
    pub fn around(&self, part: &Part) -> Self {
        let first = part.extent().map(|range| range.start as isize);
        let middle = [0, 1].map(|axis| self.middle[axis] + 2 * first[axis]);
        Self { rectangle: part.whole(self.rectangle), elements: part.frame(), middle, ..*self }
    }

    /// Size of an element along x and y (m).
    pub fn spacing(&self) -> [f64; 2] {
        [0, 1].map(|axis| self.rectangle.size[axis] / self.elements[axis] as f64)
    }

    /// Where values at the centre are read (m).
    pub fn centre(&self) -> [f64; 2] {
        let spacing = self.spacing();
        [0, 1].map(|axis| {
            let steps = self.middle[axis] as f64 - self.elements[axis] as f64;
            self.rectangle.centre[axis] + 0.5 * spacing[axis] * steps
        })
    }

    /// Centre of a pair (m).
    pub fn place(&self, pair: usize) -> [f64; 2] {
        let index = [pair % self.elements[0], pair / self.elements[0]];
        let spacing = self.spacing();
        [0, 1].map(|axis| {
            // Symmetric to the last bit, so that symmetric problems stay symmetric.
            let steps = 2.0 * index[axis] as f64 + 1.0 - self.elements[axis] as f64;
            self.rectangle.centre[axis] + 0.5 * spacing[axis] * steps
        })
    }
}
