//! Whether pressures keep open what lies next to them.
//!
//! What a pressure opens a gap by has a bound below, which falls with the distance (`Compliance::least_displacement`). The
//! pressures of a cell of elements together open it by no less than if all of them stood at the farthest of those elements, and
//! however small the parts are that the cell is divided into, their bounds come to no more than if all stood at the nearest.
//! Cells are divided in four, the one first whose division can gain most, until the gap is kept open or no division can do that.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use crate::compliance::Compliance;

/// The pressures of a contact (Pa), summed by the cells of a tree.
pub(crate) struct Cells {
    /// From single elements to one cell, each with twice the side of the one before.
    levels: Vec<Level>,
}

struct Level {
    count: [usize; 2],
    sums: Vec<f64>,
}

impl Level {
    fn of_four(&self) -> Self {
        let count = self.count.map(|count| count.div_ceil(2));
        let mut sums = vec![0.0; count[0] * count[1]];
        for (y, row) in self.sums.chunks(self.count[0]).enumerate() {
            for (x, sum) in row.iter().enumerate() {
                sums[x / 2 + count[0] * (y / 2)] += sum;
            }
        }
        Self { count, sums }
    }
}

/// A cell, and what its pressures open a gap by (m): at least, and the most that this can become by division.
struct Opening {
    level: usize,
    cell: [usize; 2],
    least: f64,
    most: f64,
}

impl Opening {
    /// What a division can gain (m).
    fn gain(&self) -> f64 {
        self.most - self.least
    }
}

/// In the order of what divisions can gain.
impl Ord for Opening {
    fn cmp(&self, other: &Self) -> Ordering {
        self.gain().total_cmp(&other.gain())
    }
}

impl PartialOrd for Opening {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Opening {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Opening {}

impl Cells {
    /// Those of the pressures (Pa) of so many elements along x and y.
    pub fn of(elements: [usize; 2], pressure: &[f64]) -> Self {
        let mut levels = vec![Level { count: elements, sums: pressure.to_vec() }];
        while let Some(last) = levels.last().filter(|last| last.count != [1; 2]) {
            levels.push(last.of_four());
        }
        Self { levels }
    }

    /// Whether the gaps of a block of elements stay open that are at least so wide (m) without the pressures; the first and the
    /// last element of the block are given, in the grid or beyond.
    pub fn leave_open(
        &self,
        apart: f64,
        compliance: &dyn Compliance,
        block: [[isize; 2]; 2],
    ) -> bool {
        if apart >= 0.0 {
            return true;
        }
        let quarters = [[0, 0], [1, 0], [0, 1], [1, 1]];
        let mut openings = BinaryHeap::new();
        let [mut least, mut most] = [apart; 2];
        let mut divided = vec![(self.levels.len() - 1, [0; 2])];
        loop {
            for (level, cell) in divided {
                let Some(one) = self.opening(compliance, block, level, cell) else { continue };
                least += one.least;
                most += one.most;
                openings.push(one);
            }
            if least >= 0.0 || most < 0.0 {
                return least >= 0.0;
            }
            let next = openings.pop().filter(|next: &Opening| next.gain() > 0.0);
            let Some(one) = next else { return false };
            least -= one.least;
            most -= one.most;
            let cell = |quarter: [usize; 2]| [0, 1].map(|axis| 2 * one.cell[axis] + quarter[axis]);
            divided = quarters.map(|quarter| (one.level - 1, cell(quarter))).to_vec();
        }
    }

    /// What a cell opens the gaps of a block by; `None` where there is no such cell, or nothing presses in it.
    fn opening(
        &self,
        compliance: &dyn Compliance,
        [low, high]: [[isize; 2]; 2],
        level: usize,
        cell: [usize; 2],
    ) -> Option<Opening> {
        let Level { count, sums } = &self.levels[level];
        let [x, y] = cell;
        let sum = (x < count[0] && y < count[1]).then(|| sums[x + count[0] * y])?;
        if sum == 0.0 {
            return None;
        }
        // Cells at the upper sides of the tree may reach beyond the grid. The farthest and the nearest elements of the cell lie
        // so far from the farthest of the block:
        let elements = self.levels[0].count;
        let away = |axis: usize| {
            let edge = |cell: usize| ((cell << level).min(elements[axis])) as isize;
            let (first, last) = (edge(cell[axis]), edge(cell[axis] + 1) - 1);
            let half = (high[axis] - low[axis] + 1) / 2;
            let most = (last - low[axis]).max(high[axis] - first);
            let least = (first - low[axis]).max(high[axis] - last).max(half);
            [most, least].map(|away| away as usize)
        };
        let (x, y) = (away(0), away(1));
        let [least, most] = [0, 1].map(|end| sum * compliance.least_displacement([x[end], y[end]]));
        Some(Opening { level, cell, least, most })
    }
}

#[cfg(test)]
mod tests {
    use super::Cells;
    use crate::body::Material;
    use crate::body::profile::Flat;
    use crate::compliance::{Compliance, HalfSpace};
    use crate::frame::ContactFrame;

    const ELEMENTS: [usize; 2] = [21, 13];

    fn compliance() -> HalfSpace {
        let steel = Material { young: 210e9, poisson: 0.3 };
        let frame = ContactFrame::uniform([2.1e-3, 1.3e-3], ELEMENTS, [&Flat, &Flat]).unwrap();
        HalfSpace::new([Some(&steel), None], &frame)
    }

    /// Pressures (Pa) that vary, on an ellipse off the middle.
    fn pressures() -> Vec<f64> {
        let pressure = |pair: usize| {
            let (x, y) = ((pair % ELEMENTS[0]) as f64, (pair / ELEMENTS[0]) as f64);
            let inside = 1.0 - ((x - 8.0) / 5.0).powi(2) - ((y - 6.0) / 3.0).powi(2);
            1e9 * inside.max(0.0).sqrt() * (1.5 + (x * y).sin())
        };
        (0..ELEMENTS[0] * ELEMENTS[1]).map(pressure).collect()
    }

    /// What all elements open a gap by at least (m), one by one.
    fn opened(compliance: &HalfSpace, pressure: &[f64], [low, high]: [[isize; 2]; 2]) -> f64 {
        let of = |(pair, pressure): (usize, &f64)| {
            let element = [pair % ELEMENTS[0], pair / ELEMENTS[0]].map(|one| one as isize);
            let away = [0, 1].map(|axis| {
                element[axis].abs_diff(low[axis]).max(element[axis].abs_diff(high[axis]))
            });
            pressure * compliance.least_displacement(away)
        };
        pressure.iter().enumerate().map(of).sum()
    }

    /// The tree decides as the sum over all elements does, of single elements and of blocks, within the grid and beyond.
    #[test]
    fn a_tree_of_cells_decides_as_all_elements_do() {
        let (compliance, pressure) = (compliance(), pressures());
        let cells = Cells::of(ELEMENTS, &pressure);
        let places = (-9..30).step_by(3).flat_map(|x| (-7..20).step_by(2).map(move |y| [x, y]));
        for [x, y] in places {
            for [wide, high] in [[0, 0], [7, 7], [4, 0]] {
                let block = [[x, y], [x + wide, y + high]];
                let opened = opened(&compliance, &pressure, block);
                for (share, stays) in [(0.999, true), (1.001, false), (1e-3, true), (50.0, false)] {
                    let open = cells.leave_open(-share * opened, &compliance, block);
                    assert_eq!(open, stays, "{block:?} {share}");
                }
            }
        }
    }

    /// Without pressures nothing opens, and what is open stays so.
    #[test]
    fn nothing_is_opened_by_no_pressure() {
        let cells = Cells::of(ELEMENTS, &[0.0; ELEMENTS[0] * ELEMENTS[1]]);
        let block = [[30, 3]; 2];
        assert!(!cells.leave_open(-1e-12, &compliance(), block));
        assert!(cells.leave_open(0.0, &compliance(), block));
    }
}
