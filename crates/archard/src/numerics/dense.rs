//! Dense linear systems.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::lu::partial_pivoting::{factor, solve};
use faer::linalg::solvers::{Llt, Solve};
use faer::perm::Perm;
use faer::{Mat, MatMut, Par, Side};

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

/// The factors of a square matrix, kept in its place; rows are exchanged for the largest pivots.
#[derive(Debug)]
pub struct Lu {
    factors: Mat<f64>,
    rows: Perm<usize>,
}

/// A matrix that has no inverse.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("the matrix of {size} unknowns is singular")]
pub struct Singular {
    /// Number of unknowns.
    pub size: usize,
}

impl Lu {
    /// Factorises a square matrix in its place.
    ///
    /// # Errors
    /// If a pivot is zero or not a number.
    pub fn new(mut matrix: Mat<f64>) -> Result<Self, Singular> {
        let size = matrix.nrows();
        let (mut forward, mut backward) = (vec![0usize; size], vec![0usize; size]);
        let par = Par::rayon(0);
        let need = factor::lu_in_place_scratch::<usize, f64>(size, size, par, Default::default());
        let mut memory = MemBuffer::new(need);
        let stack = MemStack::new(&mut memory);
        let settings = Default::default();
        factor::lu_in_place(matrix.as_mut(), &mut forward, &mut backward, par, stack, settings);
        let sound = (0..size).all(|index| {
            let pivot = matrix[(index, index)];
            pivot != 0.0 && pivot.is_finite()
        });
        if !sound {
            return Err(Singular { size });
        }
        let rows = Perm::new_checked(forward.into(), backward.into(), size);
        Ok(Self { factors: matrix, rows })
    }

    /// Replaces images by the vectors that have them, one a column.
    pub fn solve_in_place(&self, mut images: MatMut<'_, f64>) {
        let (size, columns) = (self.factors.nrows(), images.ncols());
        let par = if columns > 8 { Par::rayon(0) } else { Par::Seq };
        let need = solve::solve_in_place_scratch::<usize, f64>(size, columns, par);
        let mut memory = MemBuffer::new(need);
        let factors = self.factors.as_ref();
        let stack = MemStack::new(&mut memory);
        solve::solve_in_place(factors, factors, self.rows.as_ref(), images.as_mut(), par, stack);
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
