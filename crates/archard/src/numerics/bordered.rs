//! Systems that grow by a border while the factors of the matrix within stay.
//!
//! ```text
//! [ M  H ] [x]   [b]        S = D - G M^-1 H,   y = S^-1 (c - G M^-1 b),   x = M^-1 b - M^-1 H y
//! [ G  D ] [y] = [c]
//! ```
//!
//! with the Schur complement S of the size of the border (G. H. Golub and C. F. Van Loan, *Matrix Computations*,
//! 4th ed., 2013, sec. 3.2). An unknown is taken out again by a border as well: a column for what its row lacks
//! then, a row that makes it zero.

use faer::{Mat, MatMut, MatRef};

use super::dense::{Lu, SolveError};

/// The factors of a matrix and of its border.
#[derive(Debug)]
pub struct BorderedFactors<'l> {
    within: &'l Lu,
    /// M^-1 H.
    responses: Mat<f64>,
    rows: Mat<f64>,
    complement: Lu,
}

impl<'l> BorderedFactors<'l> {
    /// Around a matrix M that has factors: columns H, rows G and the corner D.
    ///
    /// # Errors
    /// If the whole has no inverse.
    pub fn new(
        within: &'l Lu,
        columns: Mat<f64>,
        rows: Mat<f64>,
        corner: MatRef<'_, f64>,
    ) -> Result<Self, SolveError> {
        let mut responses = columns;
        within.solve_in_place(responses.as_mut());
        let complement = Lu::of(&(corner - &rows * &responses))?;
        Ok(Self { within, responses, rows, complement })
    }

    /// Replaces images by the vectors that have them, one a column: the part within and that of the border.
    pub fn solve_in_place(&self, mut within: MatMut<'_, f64>, mut border: MatMut<'_, f64>) {
        self.within.solve_in_place(within.as_mut());
        border -= &self.rows * within.as_ref();
        self.complement.solve_in_place(border.as_mut());
        within -= &self.responses * border.as_ref();
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;
    use faer::Mat;

    use super::BorderedFactors;
    use crate::numerics::dense::Lu;

    /// Unsymmetric, with a zero corner like that of an unknown taken out.
    #[test]
    fn a_border_changes_nothing_but_the_effort() {
        let size = 12;
        let element = |i: usize, j: usize| {
            if i + j == 22 && i == 11 {
                0.0
            } else {
                1.0 / (1.0 + (3 * i).abs_diff(2 * j) as f64) + f64::from(i == j) * 3.0
            }
        };
        let whole = Mat::from_fn(size, size, element);
        let images = Mat::from_fn(size, 2, |i, j| (i as f64 + 1.0).powi(j as i32));
        let lu = Lu::of(&whole.submatrix(0, 0, 9, 9).to_owned()).expect("regular");
        let columns = whole.submatrix(0, 9, 9, 3).to_owned();
        let rows = whole.submatrix(9, 0, 3, 9).to_owned();
        let bordered =
            BorderedFactors::new(&lu, columns, rows, whole.submatrix(9, 9, 3, 3)).expect("regular");
        let mut found = images.clone();
        let (within, border) = found.as_mut().split_at_row_mut(9);
        bordered.solve_in_place(within, border);
        let back = &whole * &found;
        for column in 0..2 {
            for row in 0..size {
                assert_relative_eq!(back[(row, column)], images[(row, column)], epsilon = 1e-12);
            }
        }
    }
}
