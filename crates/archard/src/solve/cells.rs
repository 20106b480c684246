//! Whether pressures keep open what lies beside them.
//!
//! The pressures of a cell open a gap by more than they would if all of them stood as far away as the farthest of the cell, and
//! by less than if all stood as near as the nearest. Cells are divided in four, the one first between whose bounds the most
//! lies, until one of both sums decides.

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

/// A cell, and between which values (m) its pressures open a gap.
struct Opening {
    level: usize,
    cell: [usize; 2],
    least: f64,
    most: f64,
}

impl Opening {
    fn between(&self) -> f64 {
        self.most - self.least
    }
}

impl Ord for Opening {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.between().total_cmp(&other.between())
    }
}

impl PartialOrd for Opening {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
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

    /// Whether the gaps of elements stay open, the first and the last of which are given, that are at least so wide (m) without
    /// the pressures. They lie beside the contact, maybe beyond the grid.
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
        let mut between = [apart; 2];
        let mut divided = vec![(self.levels.len() - 1, [0; 2])];
        loop {
            for (level, cell) in divided {
                let Some(one) = self.opening(compliance, block, level, cell) else { continue };
                between = [between[0] + one.least, between[1] + one.most];
                openings.push(one);
            }
            if between[0] >= 0.0 {
                return true;
            }
            let largest = openings.pop().filter(|one| between[1] >= 0.0 && one.between() > 0.0);
            let Some(one) = largest else { return false };
            between = [between[0] - one.least, between[1] - one.most];
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
