//! Fields carried between elements and those of twice the size.

/// Fewest elements along an axis that are worth coarser ones. A choice of cost: a start does not change what is found.
pub(in crate::solve) const FEWEST: usize = 12;

/// Elements and those of twice the size: the first of both begin together.
pub(in crate::solve) struct Blocks {
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

    /// The same of a field that goes on beyond its last elements as it is there.
    pub fn mean_continued(&self, field: &[f64]) -> Vec<f64> {
        let share = |axis: usize, place: usize| (self.fine[axis] - 2 * place).min(2) as f64 / 2.0;
        let mut mean = self.mean(field);
        for (row, values) in mean.chunks_mut(self.coarse[0]).enumerate() {
            for (column, value) in values.iter_mut().enumerate() {
                *value /= share(0, column) * share(1, row);
            }
        }
        mean
    }

    /// A coarse field at the fine elements, even on each coarse one.
    pub fn spread(&self, field: &[f64]) -> Vec<f64> {
        let mut result = Vec::with_capacity(self.fine[0] * self.fine[1]);
        for row in 0..self.fine[1] {
            let values = &field[row / 2 * self.coarse[0]..];
            result.extend((0..self.fine[0]).map(|column| values[column / 2]));
        }
        result
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

#[cfg(test)]
mod tests {
    use super::Blocks;

    /// An odd number of elements: the last coarse one lies half beyond the field.
    #[test]
    fn what_is_even_stays_so_beyond_the_field() {
        let blocks = Blocks { fine: [5, 3], coarse: [3, 2] };
        let even = vec![2.0; 15];
        assert_eq!(blocks.mean_continued(&even), [2.0; 6]);
        assert_eq!(blocks.mean(&even), [2.0, 2.0, 1.0, 1.0, 1.0, 0.5]);
        assert_eq!(blocks.spread(&[2.0; 6]), even);
        let rows = [0.0, 1.0, 2.0, 3.0, 4.0].repeat(3);
        assert_eq!(blocks.mean_continued(&rows), [0.5, 2.5, 4.0].repeat(2));
        let spread = blocks.spread(&blocks.mean_continued(&rows));
        assert_eq!(spread, [0.5, 0.5, 2.5, 2.5, 4.0].repeat(3));
    }
}
