//! Where bodies may touch.

/// A rectangle along x and y.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rectangle {
    /// Its middle (m).
    pub centre: [f64; 2],
    /// Its size (m).
    pub size: [f64; 2],
}

/// A rectangle of that size (m), centred at the origin.
impl From<[f64; 2]> for Rectangle {
    fn from(size: [f64; 2]) -> Self {
        Self { centre: [0.0; 2], size }
    }
}

impl Rectangle {
    /// The size (m) of the largest rectangle in it that is centred at the origin; negative where the origin is outside.
    pub fn about_origin(&self) -> [f64; 2] {
        [0, 1].map(|axis| self.size[axis] - 2.0 * self.centre[axis].abs())
    }

    /// Whether it holds a place (m).
    pub fn holds(&self, place: [f64; 2]) -> bool {
        (0..2).all(|axis| 2.0 * (place[axis] - self.centre[axis]).abs() <= self.size[axis])
    }

    /// Its lowest corner (m).
    pub fn corner(&self) -> [f64; 2] {
        [0, 1].map(|axis| self.centre[axis] - 0.5 * self.size[axis])
    }

    /// All of its corners (m).
    pub fn corners(&self) -> [[f64; 2]; 4] {
        let low = self.corner();
        let corner =
            |shares: [f64; 2]| [0, 1].map(|axis| low[axis] + shares[axis] * self.size[axis]);
        [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]].map(corner)
    }
}
