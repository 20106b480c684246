//! The piece of a surface that is worn: what lies below the level by more than chance, and has lost most.

use super::Surface;
use crate::measured::plane::BEYOND_CHANCE;

/// Parts of the extent that depths are averaged over.
const PARTS: usize = 50;

impl Surface {
    /// Cells on either side that a depth is averaged over.
    fn reach(&self) -> [usize; 2] {
        [0, 1].map(|axis| self.places[axis].len() / (2 * PARTS))
    }

    /// Depths averaged over the cells around each; those of gaps over what is there.
    pub(super) fn smoothed(&self, depths: &[f64]) -> Vec<f64> {
        let [columns, rows] = [0, 1].map(|axis| self.places[axis].len());
        // Sums over all cells before each, along both axes.
        let mut sums = vec![[0.0; 2]; (columns + 1) * (rows + 1)];
        let at = |column: usize, row: usize| row * (columns + 1) + column;
        for row in 0..rows {
            for column in 0..columns {
                let depth = depths[row * columns + column];
                let own = if depth.is_finite() { [depth, 1.0] } else { [0.0; 2] };
                sums[at(column + 1, row + 1)] = [0, 1].map(|i| {
                    own[i] + sums[at(column, row + 1)][i] + sums[at(column + 1, row)][i]
                        - sums[at(column, row)][i]
                });
            }
        }
        let reach = self.reach();
        let mean = |cell: usize| {
            let [column, row] = [cell % columns, cell / columns];
            let [left, low] = [column.saturating_sub(reach[0]), row.saturating_sub(reach[1])];
            let [right, high] =
                [(column + reach[0] + 1).min(columns), (row + reach[1] + 1).min(rows)];
            let [sum, count] = [0, 1].map(|i| {
                sums[at(right, high)][i] - sums[at(left, high)][i] - sums[at(right, low)][i]
                    + sums[at(left, low)][i]
            });
            // Without a reading the sum is what rounding left of it.
            if count > 0.0 { sum / count } else { f64::NAN }
        };
        (0..columns * rows).map(mean).collect()
    }

    /// First and last cell along each axis of the piece that lies below the level by more than chance and has lost most, by the
    /// scatter of a reading (m) and in how many there is one that is independent.
    pub(super) fn largest_piece(
        &self,
        depths: &[f64],
        [scatter, repeats]: [f64; 2],
    ) -> Option<[[usize; 2]; 2]> {
        let [columns, rows] = [0, 1].map(|axis| self.places[axis].len());
        let mut smoothed = self.smoothed(depths);
        let averaged = self.reach().iter().map(|reach| 2.0 * *reach as f64 + 1.0).product::<f64>();
        let least = BEYOND_CHANCE * scatter * (repeats / averaged).min(1.0).sqrt();
        self.bridge(&mut smoothed, least);
        let mut free: Vec<bool> = smoothed.iter().map(|depth| *depth > least).collect();
        let mut best: Option<(f64, [[usize; 2]; 2])> = None;
        for start in 0..free.len() {
            if !std::mem::take(&mut free[start]) {
                continue;
            }
            let (mut lost, mut reaches) = (0.0, [[usize::MAX, 0]; 2]);
            let mut open = vec![start];
            while let Some(cell) = open.pop() {
                lost += smoothed[cell];
                let place = [cell % columns, cell / columns];
                for (reach, index) in reaches.iter_mut().zip(place) {
                    *reach = [reach[0].min(index), reach[1].max(index)];
                }
                let [column, row] = place;
                for other_row in row.saturating_sub(1)..=(row + 1).min(rows - 1) {
                    for other in column.saturating_sub(1)..=(column + 1).min(columns - 1) {
                        let next = other_row * columns + other;
                        if std::mem::take(&mut free[next]) {
                            open.push(next);
                        }
                    }
                }
            }
            if best.is_none_or(|(most, _)| lost > most) {
                best = Some((lost, reaches));
            }
        }
        best.map(|(_, reaches)| reaches)
    }

    /// Puts depths into gaps between worn cells of a row or column: a scar goes on behind them.
    fn bridge(&self, depths: &mut [f64], least: f64) {
        let [columns, rows] = [0, 1].map(|axis| self.places[axis].len());
        let along_x = (0..rows).map(|row| (row * columns, 1, columns));
        let along_y = (0..columns).map(|column| (column, columns, rows));
        for (start, step, count) in along_x.chain(along_y) {
            // The last worn cell, with nothing but gaps behind it.
            let mut worn: Option<usize> = None;
            for cell in (0..count).map(|index| start + index * step) {
                let own = depths[cell];
                if own > least {
                    if let Some(last) = worn {
                        let between = own.min(depths[last]);
                        (last + step..cell).step_by(step).for_each(|gap| depths[gap] = between);
                    }
                    worn = Some(cell);
                } else if !own.is_nan() {
                    worn = None;
                }
            }
        }
    }
}
