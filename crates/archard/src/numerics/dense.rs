//! Dense linear systems.

use faer::linalg::solvers::{Llt, Solve};
use faer::{Mat, Side};

/// The factors of a symmetric positive definite matrix.
#[derive(Debug, Clone)]
pub struct Cholesky(Llt<f64>);

impl Cholesky {
    /// Factorises the matrix of that size with these elements; `None` if it is not positive definite.
    pub fn new(size: usize, element: impl Fn(usize, usize) -> f64) -> Option<Self> {
        Mat::from_fn(size, size, element).llt(Side::Lower).ok().map(Self)
    }

    /// The vector whose image is given.
    pub fn solve(&self, image: &[f64]) -> Vec<f64> {
        let mut vector = Mat::from_fn(image.len(), 1, |row, _| image[row]);
        self.0.solve_in_place(&mut vector);
        (0..image.len()).map(|row| vector[(row, 0)]).collect()
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::Cholesky;

    #[test]
    fn systems_are_solved_and_others_refused() {
        let element = |i: usize, j: usize| 1.0 / (1.0 + i.abs_diff(j) as f64);
        let expected: Vec<f64> = (0..7).map(|i| f64::from(i).cos()).collect();
        let image: Vec<f64> =
            (0..7).map(|i| (0..7).map(|j| element(i, j) * expected[j]).sum()).collect();
        let found = Cholesky::new(7, element).expect("positive definite").solve(&image);
        for (a, b) in found.iter().zip(&expected) {
            assert_relative_eq!(a, b, epsilon = 1e-12);
        }
        assert!(Cholesky::new(2, |i, j| if i == j { 1.0 } else { 2.0 }).is_none());
    }
}
