//! Dense linear systems.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::lu::partial_pivoting::{factor, solve};
use faer::linalg::solvers::{Llt, Solve};
use faer::linalg::triangular_solve::{
    solve_unit_lower_triangular_in_place, solve_upper_triangular_in_place,
};
use faer::perm::{Perm, permute_rows_in_place, permute_rows_in_place_scratch};
use faer::traits::RealField;
use faer::{Mat, MatMut, Par, Side};
use pulp::bytemuck::Pod;

use super::large::{Large, NoMemory};
use super::single::substitute;

/// Unknowns below which one thread is quicker than several. A choice of cost.
const ALONE: usize = 1024;

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

/// The factors of a square matrix, kept in its place; rows are exchanged for the largest pivots. In single
/// precision they are made, read and kept at half the cost, for systems that are solved by iteration.
#[derive(Debug)]
pub struct Lu<T = f64> {
    factors: Large<T>,
    rows: Perm<usize>,
}

/// Equations that have no solution, or none that could be found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum SolveError {
    /// A matrix that has no inverse.
    #[error("the matrix of {size} unknowns is singular")]
    Singular {
        /// Number of unknowns.
        size: usize,
    },
    /// A matrix that there is no memory for.
    #[error(transparent)]
    NoMemory(#[from] NoMemory),
}

impl<T: RealField + Pod + Into<f64>> Lu<T> {
    /// Factorises a copy of a square matrix.
    ///
    /// # Errors
    /// If a pivot is zero or not a number, or there is no memory.
    pub fn of(matrix: &Mat<T>) -> Result<Self, SolveError> {
        let mut copy = Large::zeros(matrix.nrows(), matrix.ncols())?;
        copy.as_mut().copy_from(matrix);
        Self::new(copy)
    }

    /// Factorises a square matrix in its place.
    ///
    /// # Errors
    /// If a pivot is zero or not a number.
    pub fn new(mut matrix: Large<T>) -> Result<Self, SolveError> {
        let size = matrix.nrows();
        let (mut forward, mut backward) = (vec![0usize; size], vec![0usize; size]);
        let par = if size < ALONE { Par::Seq } else { Par::rayon(0) };
        let need = factor::lu_in_place_scratch::<usize, T>(size, size, par, Default::default());
        let mut memory = MemBuffer::new(need);
        let stack = MemStack::new(&mut memory);
        let settings = Default::default();
        factor::lu_in_place(matrix.as_mut(), &mut forward, &mut backward, par, stack, settings);
        let sound = (0..size).all(|index| {
            let pivot: f64 = matrix.as_ref()[(index, index)].into();
            pivot != 0.0 && pivot.is_finite()
        });
        if !sound {
            return Err(SolveError::Singular { size });
        }
        let rows = Perm::new_checked(forward.into(), backward.into(), size);
        Ok(Self { factors: matrix, rows })
    }

    /// Number of unknowns.
    pub fn size(&self) -> usize {
        self.factors.nrows()
    }

    /// Replaces images by the vectors that have them, one a column.
    pub fn solve_in_place(&self, mut images: MatMut<'_, T>) {
        let (size, columns) = (self.factors.nrows(), images.ncols());
        let par = if columns > 8 { Par::rayon(0) } else { Par::Seq };
        let need = solve::solve_in_place_scratch::<usize, T>(size, columns, par);
        let mut memory = MemBuffer::new(need);
        let factors = self.factors.as_ref();
        let stack = MemStack::new(&mut memory);
        solve::solve_in_place(factors, factors, self.rows.as_ref(), images.as_mut(), par, stack);
    }

    /// Replaces the last `count` rows of images by those of the vectors that have them, one a column; the
    /// others are left without meaning.
    pub fn solve_last(&self, mut images: MatMut<'_, T>, count: usize) {
        let (size, columns) = (self.factors.nrows(), images.ncols());
        let par = if columns > 8 { Par::rayon(0) } else { Par::Seq };
        let need = permute_rows_in_place_scratch::<usize, T>(size, columns);
        let mut memory = MemBuffer::new(need);
        let stack = MemStack::new(&mut memory);
        permute_rows_in_place(images.as_mut(), self.rows.as_ref(), stack);
        let factors = self.factors.as_ref();
        solve_unit_lower_triangular_in_place(factors, images.as_mut(), par);
        let first = size - count.min(size);
        let last = factors.submatrix(first, first, size - first, size - first);
        solve_upper_triangular_in_place(last, images.subrows_mut(first, size - first), par);
    }
}

impl Lu<f32> {
    /// Replaces a single image by the vector that has it.
    pub fn solve(&self, image: &mut [f32]) {
        let (forward, _) = self.rows.as_ref().arrays();
        let permuted: Vec<f32> = forward.iter().map(|&row| image[row]).collect();
        image.copy_from_slice(&permuted);
        substitute(self.factors.as_ref(), image);
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use faer::Mat;

    use super::{Cholesky, Lu};

    #[test]
    fn last_unknowns_are_those_of_all() {
        let size = 50;
        let matrix = || {
            Mat::from_fn(size, size, |i, j| {
                (i * j + 3 * i) as f64 % 7.0 - if i == 9 - j % 9 { 20.0 } else { 0.0 }
                    + f64::from(i == j) * 9.0
            })
        };
        let images = || Mat::from_fn(size, 3, |i, j| (i + j) as f64);
        let lu = Lu::of(&matrix()).expect("regular");
        let (mut all, mut last) = (images(), images());
        lu.solve_in_place(all.as_mut());
        lu.solve_last(last.as_mut(), 20);
        let back = matrix() * &all;
        for column in 0..3 {
            for row in 0..size {
                assert_relative_eq!(back[(row, column)], images()[(row, column)], epsilon = 1e-10);
            }
            for row in 30..size {
                assert_relative_eq!(last[(row, column)], all[(row, column)], epsilon = 1e-12);
            }
        }
        assert!(Lu::of(&Mat::<f64>::zeros(3, 3)).is_err());
        let single = Lu::of(&Mat::from_fn(size, size, |i, j| matrix()[(i, j)] as f32));
        let mut image: Vec<f32> = (0..size).map(|i| images()[(i, 1)] as f32).collect();
        single.expect("regular").solve(&mut image);
        for row in 0..size {
            assert_relative_eq!(f64::from(image[row]), all[(row, 1)], max_relative = 1e-4);
        }
    }

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
