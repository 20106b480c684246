//! Equations of least squares with few unknowns.

use super::placement::PARAMETERS;

/// A matrix of as many rows and columns as a placement has numbers.
pub(super) type Square = [[f64; PARAMETERS]; PARAMETERS];

/// The inverse of a positive matrix of least squares. A number that others or none of the points tell, to rounding, has zeros in its row and
/// column: it stays as it is.
pub(super) fn inverse(matrix: &Square) -> Square {
    let scale: Vec<f64> = (0..PARAMETERS).map(|at| matrix[at][at].sqrt()).collect();
    let mut rows = [[0.0; 2 * PARAMETERS]; PARAMETERS];
    for i in 0..PARAMETERS {
        for j in 0..PARAMETERS {
            let size = scale[i] * scale[j];
            rows[i][j] = if size > 0.0 { matrix[i][j] / size } else { 0.0 };
        }
        rows[i][PARAMETERS + i] = 1.0;
    }
    let mut told = [true; PARAMETERS];
    for at in 0..PARAMETERS {
        let pivot = rows[at];
        // Sums over up to 1e8 points have lost half of their digits.
        if pivot[at] <= f64::EPSILON.sqrt() {
            told[at] = false;
            continue;
        }
        for other in (0..PARAMETERS).filter(|&other| other != at) {
            let share = rows[other][at] / pivot[at];
            rows[other].iter_mut().zip(&pivot).for_each(|(value, pivot)| *value -= share * pivot);
        }
        rows[at].iter_mut().for_each(|value| *value /= pivot[at]);
    }
    let mut found = [[0.0; PARAMETERS]; PARAMETERS];
    for i in (0..PARAMETERS).filter(|&i| told[i]) {
        for j in (0..PARAMETERS).filter(|&j| told[j]) {
            found[i][j] = rows[i][PARAMETERS + j] / (scale[i] * scale[j]);
        }
    }
    found
}

/// A matrix times a vector.
pub(super) fn times(matrix: &Square, vector: &[f64; PARAMETERS]) -> [f64; PARAMETERS] {
    matrix.map(|row| row.iter().zip(vector).map(|(one, other)| one * other).sum())
}

#[cfg(test)]
mod tests {
    use super::{PARAMETERS, inverse, times};

    /// Points that never slope along x tell no shift along it; all else is solved.
    #[test]
    fn what_is_not_told_stays() {
        let points = (0..40).map(|at| {
            let x = f64::from(at);
            [0.0, x.sin(), (2.0 * x).cos(), 1.0, 1e-3 * x, 1e3 * (0.3 * x).sin(), 0.0, 0.0, 0.0]
        });
        let mut matrix = [[0.0; PARAMETERS]; PARAMETERS];
        points.for_each(|own| {
            (0..PARAMETERS)
                .for_each(|i| (0..PARAMETERS).for_each(|j| matrix[i][j] += own[i] * own[j]));
        });
        let solution = [0.0, 1.0, -2.0, 3.0, 4.0, 5.0, 0.0, 0.0, 0.0];
        let found = times(&inverse(&matrix), &times(&matrix, &solution));
        for (one, other) in found.iter().zip(solution) {
            assert!((one - other).abs() < 1e-9, "{found:?}");
        }
    }
}
