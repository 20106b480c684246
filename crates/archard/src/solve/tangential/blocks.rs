//! Fields carried between elements and those of twice the size.

/// Elements and those of twice the size, the first of which begin together.
pub(super) struct Blocks {
    pub fine: [usize; 2],
    pub coarse: [usize; 2],
}

impl Blocks {
    /// The mean of a field over the elements that each coarse one covers; zero beyond the field.
    pub fn mean(&self, field: &[f64]) -> Vec<f64> {
        let mut mean = vec![0.0; self.coarse[0] * self.coarse[1]];
        for (row, values) in field.chunks(self.fine[0]).enumerate() {
            for (column, value) in values.iter().enumerate() {
                mean[column / 2 + self.coarse[0] * (row / 2)] += 0.25 * value;
            }
        }
        mean
    }

    /// A coarse field at the fine elements, linear between the centres of the coarse ones.
    pub fn interpolate(&self, field: &[f64]) -> Vec<f64> {
        let along = |axis: usize, index: usize| {
            let near = index / 2;
            let far = if index.is_multiple_of(2) { near.saturating_sub(1) } else { near + 1 };
            [near, far.min(self.coarse[axis] - 1)]
        };
        let mut result = Vec::with_capacity(self.fine[0] * self.fine[1]);
        for row in 0..self.fine[1] {
            let rows = along(1, row).map(|row| &field[row * self.coarse[0]..]);
            for column in 0..self.fine[0] {
                let [near, far] = along(0, column);
                let value = |row: &[f64]| 0.75 * row[near] + 0.25 * row[far];
                result.push(0.75 * value(rows[0]) + 0.25 * value(rows[1]));
            }
        }
        result
    }
}
