//! Small symmetric matrices and their powers.

use faer::{Mat, Side};

/// Rows of a square matrix.
pub type Matrix = Vec<Vec<f64>>;

/// A matrix of zeros.
pub fn zeros(size: usize) -> Matrix {
    vec![vec![0.0; size]; size]
}

/// The sum of two matrices, the second so many times.
pub fn plus(one: &Matrix, other: &Matrix, times: f64) -> Matrix {
    let row =
        |(a, b): (&Vec<f64>, &Vec<f64>)| a.iter().zip(b).map(|(a, b)| a + times * b).collect();
    one.iter().zip(other).map(row).collect()
}

/// The product of two matrices.
pub fn product(one: &Matrix, other: &Matrix) -> Matrix {
    let entry = |row: &[f64], j: usize| row.iter().zip(other).map(|(a, b)| a * b[j]).sum();
    one.iter().map(|row| (0..row.len()).map(|j| entry(row, j)).collect()).collect()
}

/// The product with a vector.
pub fn times(matrix: &Matrix, vector: &[f64]) -> Vec<f64> {
    matrix.iter().map(|row| dot(row, vector)).collect()
}

/// The product of two vectors.
pub fn dot(one: &[f64], other: &[f64]) -> f64 {
    one.iter().zip(other).map(|(a, b)| a * b).sum()
}

/// Adds the product of a column with itself, so many times.
pub fn add_square(matrix: &mut Matrix, column: &[f64], times: f64) {
    for (row, a) in matrix.iter_mut().zip(column) {
        row.iter_mut().zip(column).for_each(|(cell, b)| *cell += times * a * b);
    }
}

/// The eigenvalues of a symmetric matrix with their vectors of length one, the least first; none of one that is not finite.
pub fn eigen(matrix: &Matrix) -> Vec<(f64, Vec<f64>)> {
    let size = matrix.len();
    let whole = Mat::from_fn(size, size, |i, j| matrix[i][j]);
    let Ok(found) = whole.self_adjoint_eigen(Side::Lower) else { return vec![] };
    let (values, vectors) = (found.S().column_vector(), found.U());
    (0..size).map(|j| (values[j], (0..size).map(|i| vectors[(i, j)]).collect())).collect()
}

/// A power of a symmetric matrix without negative eigenvalues; those below a share of the largest one count for nothing.
pub fn power(matrix: &Matrix, exponent: f64, least: f64) -> Matrix {
    let all = eigen(matrix);
    let bound = least * all.last().map_or(0.0, |own| own.0);
    let mut result = zeros(matrix.len());
    for (value, vector) in all.iter().filter(|own| own.0 > bound) {
        add_square(&mut result, vector, value.powf(exponent));
    }
    result
}

#[cfg(test)]
mod tests {
    use super::{eigen, power, product};

    #[test]
    fn powers_are_those_of_the_eigenvalues() {
        let matrix = vec![vec![4.0, 1.0, 0.5], vec![1.0, 3.0, -0.2], vec![0.5, -0.2, 1.0]];
        let root = power(&matrix, -0.5, 0.0);
        let one = product(&product(&root, &matrix), &root);
        for (i, row) in one.iter().enumerate() {
            for (j, cell) in row.iter().enumerate() {
                assert!((cell - f64::from(u8::from(i == j))).abs() < 1e-12, "{one:?}");
            }
        }
        // The eigenvalues of [[2, 1], [1, 2]] are 1 and 3.
        let all = eigen(&vec![vec![2.0, 1.0], vec![1.0, 2.0]]);
        assert!((all[0].0 - 1.0).abs() < 1e-14 && (all[1].0 - 3.0).abs() < 1e-14);
    }
}
