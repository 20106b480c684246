//! Linear least squares for few unknowns and many points, by normal equations that are summed point by point.
//!
//! The equations are scaled to a diagonal of ones and solved by their eigenvectors. Combinations of unknowns that the points leave
//! open, whose eigenvalue is within rounding of zero, become zero: the solution of Moore and Penrose.

use faer::{Mat, Side};

/// The sums over points.
#[derive(Debug, Clone)]
pub(crate) struct Normal {
    matrix: Mat<f64>,
    right: Vec<f64>,
}

impl Normal {
    /// No point yet, of so many unknowns.
    pub(crate) fn new(unknowns: usize) -> Self {
        Self { matrix: Mat::zeros(unknowns, unknowns), right: vec![0.0; unknowns] }
    }

    /// Adds a point with what each unknown counts there, and its value.
    pub(crate) fn add(&mut self, terms: &[f64], value: f64) {
        for (column, one) in terms.iter().enumerate() {
            self.right[column] += one * value;
            for (row, other) in terms.iter().enumerate().take(column + 1) {
                self.matrix[(column, row)] += one * other;
            }
        }
    }

    /// Whether any point was added, one of whose terms is a constant.
    pub(crate) fn holds_points(&self) -> bool {
        self.matrix[(0, 0)] > 0.0
    }

    /// The sums without those of a part of the points.
    pub(crate) fn without(&self, part: &Self) -> Self {
        let right = self.right.iter().zip(&part.right).map(|(all, part)| all - part);
        Self { matrix: &self.matrix - &part.matrix, right: right.collect() }
    }

    /// How much the sum of squares falls on the way to a solution.
    pub(crate) fn gain(&self, solution: &[f64]) -> f64 {
        self.right.iter().zip(solution).map(|(right, one)| right * one).sum()
    }

    /// The unknowns; not numbers where the sums are none.
    pub(crate) fn solved(&self) -> Vec<f64> {
        self.solved_for(&self.right)
    }

    /// The same of another right side.
    pub(crate) fn solved_for(&self, right: &[f64]) -> Vec<f64> {
        let size = self.right.len();
        let scale: Vec<f64> = (0..size)
            .map(|at| self.matrix[(at, at)].sqrt())
            .map(|root| if root > 0.0 { 1.0 / root } else { 0.0 })
            .collect();
        let scaled = Mat::from_fn(size, size, |row, column| {
            scale[row] * scale[column] * self.lower(row, column)
        });
        let Ok(found) = scaled.self_adjoint_eigen(Side::Lower) else {
            return vec![f64::NAN; size];
        };
        let (vectors, values) = (found.U(), found.S().column_vector());
        let least = size as f64 * f64::EPSILON * values[size - 1];
        let mut solution = vec![0.0; size];
        for at in (0..size).filter(|&at| values[at] > least) {
            let share: f64 =
                (0..size).map(|row| vectors[(row, at)] * scale[row] * right[row]).sum();
            for (row, value) in solution.iter_mut().enumerate() {
                *value += scale[row] * vectors[(row, at)] * share / values[at];
            }
        }
        solution
    }

    fn lower(&self, row: usize, column: usize) -> f64 {
        self.matrix[(row.max(column), row.min(column))]
    }
}

#[cfg(test)]
mod tests {
    use super::Normal;

    /// Three unknowns, and points that give only a sum of two: both get half of it.
    #[test]
    fn what_points_leave_open_is_shared() {
        let mut normal = Normal::new(3);
        for at in 0..10 {
            let x = f64::from(at);
            normal.add(&[1.0, x, x], 3.0 + 4.0 * x);
        }
        let solution = normal.solved();
        for (found, expected) in solution.iter().zip([3.0, 2.0, 2.0]) {
            assert!((found - expected).abs() < 1e-12, "{solution:?}");
        }
    }
}
