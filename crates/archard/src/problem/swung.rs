//! The worn surface of a body that swings past the other one.

use serde::{Deserialize, Serialize};

/// The worn surface of a body that swings, in its own coordinates: as wide as the frame, and longer along the motion, by as
/// much at both ends. In the middle position its middle lies in the frame.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Swung {
    /// The body: 0 or 1.
    pub body: usize,
    /// Where its elements lie.
    pub grid: Long,
    /// Depth worn off (m), one value an element, x running fastest.
    pub worn: Vec<f64>,
    /// Distance (m) that its points slid under pressure; empty where no wear law asks for it.
    pub slid: Vec<f64>,
}

/// The elements of a frame, and more at both ends.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Long {
    /// The axis along which it is longer: 0 for x, 1 for y.
    pub axis: usize,
    /// Elements of the frame along x and y.
    pub frame: [usize; 2],
    /// Elements that it is longer at each end.
    pub margin: usize,
}

impl Long {
    /// Its elements along x and y.
    pub fn elements(self) -> [usize; 2] {
        let mut elements = self.frame;
        elements[self.axis] += 2 * self.margin;
        elements
    }

    /// The element that lies at a pair of the frame when the surface is moved by so many elements along its axis, not more
    /// than the margin.
    pub fn at(self, pair: usize, offset: isize) -> usize {
        let mut place = [pair % self.frame[0], pair / self.frame[0]];
        place[self.axis] = (place[self.axis] + self.margin).saturating_add_signed(-offset);
        place[0] + self.elements()[0] * place[1]
    }
}

impl Swung {
    /// An unworn surface of body 0 or 1.
    pub fn new(body: usize, grid: Long) -> Self {
        let [nx, ny] = grid.elements();
        Self { body, grid, worn: vec![0.0; nx * ny], slid: vec![] }
    }

    /// A field of the surface where it lies in the frame in the middle position, one value a pair.
    pub fn in_frame(&self, field: &[f64]) -> Vec<f64> {
        let [nx, ny] = self.grid.frame;
        (0..nx * ny).map(|pair| field[self.grid.at(pair, 0)]).collect()
    }

    /// Mean and largest depth (m) of each row of elements across the motion, from end to end.
    pub fn along(&self) -> Vec<[f64; 2]> {
        let elements = self.grid.elements();
        let axis = self.grid.axis;
        let across = elements[1 - axis];
        let depth = |along: usize, other: usize| match axis {
            0 => self.worn[along + elements[0] * other],
            _ => self.worn[other + elements[0] * along],
        };
        let row = |along: usize| {
            let depths = (0..across).map(|other| depth(along, other));
            [depths.clone().sum::<f64>() / across as f64, depths.fold(0.0, f64::max)]
        };
        (0..elements[axis]).map(row).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::{Long, Swung};

    #[test]
    fn a_pair_meets_what_was_moved_to_it() {
        let mut along_x = Swung::new(1, Long { axis: 0, frame: [4, 2], margin: 3 });
        let grid = along_x.grid;
        assert_eq!(grid.elements(), [10, 2]);
        assert_eq!([grid.at(0, 0), grid.at(0, 3), grid.at(7, -3)], [3, 0, 19]);
        let along_y = Long { axis: 1, ..grid };
        assert_eq!(along_y.elements(), [4, 8]);
        assert_eq!([along_y.at(0, 0), along_y.at(0, 3), along_y.at(7, -3)], [12, 0, 31]);
        along_x.worn[13] = 2.0;
        assert_eq!(along_x.in_frame(&along_x.worn), [0.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0]);
        assert_eq!(along_x.along()[3], [1.0, 2.0]);
    }
}
