//! Small borders of a linear system: slips that are found, one for each force that is given.
//!
//! The system of the pairs has a column for what a unit of each slip does to them, and a row for each force. With what nearly
//! answers to the columns, the inverse of the Schur complement is that of a small matrix.

use crate::numerics::vector::update;

/// A border of a system that is nearly solved without it.
#[derive(Default)]
pub(in crate::solve) struct Schur {
    /// Tractions that nearly answer to each column, and the inverse of the forces they make.
    responses: Vec<Vec<f64>>,
    inverse: Vec<Vec<f64>>,
}

impl Schur {
    /// From the tractions that nearly answer to each column and the forces that tractions make.
    pub fn of(responses: Vec<Vec<f64>>, forces: impl Fn(&[f64]) -> Vec<f64>) -> Self {
        let made: Vec<Vec<f64>> = responses.iter().map(|response| forces(response)).collect();
        Self { inverse: inverse_of_columns(&made), responses }
    }

    /// Takes from tractions, which answer to the rows of the pairs and make these forces, what exceeds the forces wanted,
    /// and appends the slips that do it, in their unit.
    pub fn complete(&self, tractions: &mut Vec<f64>, made: &[f64], wanted: &[f64], unit: f64) {
        let excess: Vec<f64> = made.iter().zip(wanted).map(|(made, force)| made - force).collect();
        let slip = |row: &Vec<f64>| row.iter().zip(&excess).map(|(a, b)| a * b).sum();
        let slips: Vec<f64> = self.inverse.iter().map(slip).collect();
        for (response, slip) in self.responses.iter().zip(&slips) {
            update(tractions, [response], |traction, [response]| traction - slip * response);
        }
        tractions.extend(slips.iter().map(|slip| slip / unit));
    }
}

/// The inverse of a small matrix given by its columns; zeros where it has none, as where all pairs slip
/// along a force that is given: no slip changes it then.
fn inverse_of_columns(columns: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let count = columns.len();
    let row = |row: usize| -> Vec<f64> {
        let unit = (0..count).map(|column| f64::from(column == row));
        columns.iter().map(|column| column[row]).chain(unit).collect()
    };
    let mut matrix: Vec<Vec<f64>> = (0..count).map(row).collect();
    for pivot in 0..count {
        let largest = (pivot..count)
            .max_by(|&a, &b| matrix[a][pivot].abs().total_cmp(&matrix[b][pivot].abs()))
            .unwrap_or(pivot);
        matrix.swap(pivot, largest);
        let factor = matrix[pivot][pivot];
        if factor == 0.0 || !factor.is_finite() {
            return vec![vec![0.0; count]; count];
        }
        matrix[pivot].iter_mut().for_each(|value| *value /= factor);
        let lead = matrix[pivot].clone();
        for (_, row) in matrix.iter_mut().enumerate().filter(|(index, _)| *index != pivot) {
            let factor = row[pivot];
            row.iter_mut().zip(&lead).for_each(|(value, lead)| *value -= factor * lead);
        }
    }
    matrix.into_iter().map(|row| row[count..].to_vec()).collect()
}

#[cfg(test)]
mod tests {
    use super::inverse_of_columns;

    #[test]
    fn small_matrices_are_inverted() {
        // Needs a pivot: the first entry is zero.
        let columns = vec![vec![0.0, 2.0, 1.0], vec![1.0, 0.0, 0.0], vec![3.0, 1.0, -1.0]];
        let inverse = inverse_of_columns(&columns);
        for (index, row) in inverse.iter().enumerate() {
            for (other, column) in columns.iter().enumerate() {
                let product: f64 = row.iter().zip(column).map(|(a, b)| a * b).sum();
                assert!((product - f64::from(index == other)).abs() < 1e-14);
            }
        }
        assert_eq!(inverse_of_columns(&[vec![0.0]]), [[0.0]]);
    }
}
