//! How far coefficients may be off by what tests show, whatever the model of their scatter.
//!
//! Each test is one observation: the covariance is that of its scores, freed of the bias that fitting gives them, and Student's t
//! has the degrees of freedom that match it (R. M. Bell and D. F. McCaffrey, Survey Methodology 28 (2002) 169; J. E. Pustejovsky
//! and E. Tipton, J. Bus. Econ. Stat. 36 (2018) 672). Of tests that are read equally this is the standard error of the mean, with
//! as many degrees of freedom as there are tests but one.

use super::matrix::{Matrix, add_square, dot, eigen, power, product, times, zeros};
use super::mixed::{JointFit, NOTHING};

/// Share of all that is known of a direction, in one test, from which on the others say nothing of it.
const ALONE: f64 = 1.0 - 1e-6;

/// A covariance of coefficients by their tests.
#[derive(Debug, Clone, PartialEq)]
pub struct Covariance {
    /// Of the logarithms of the coefficients.
    pub matrix: Matrix,
    /// Degrees of freedom of each.
    pub degrees: Vec<f64>,
    /// A test that alone gives a coefficient: the places of both.
    pub alone: Option<(usize, usize)>,
}

impl Covariance {
    /// Of two tests or more.
    pub fn of(fitted: &JointFit) -> Self {
        let size = fitted.change.len();
        let root = power(&fitted.inverse, 0.5, NOTHING);
        let mut alone = None;
        let mut sum = zeros(size);
        // What each test has of all information, and the root that frees its score of bias.
        let mut parts: Vec<(Matrix, Matrix)> = vec![];
        for (place, own) in fitted.told.iter().enumerate() {
            let share = product(&product(&root, &own.information), &root);
            let mut freed = zeros(size);
            for (value, vector) in eigen(&share) {
                if value < ALONE {
                    add_square(&mut freed, &vector, (1.0 - value).powf(-0.5));
                    continue;
                }
                let of = times(&root, &vector);
                let largest = (0..size).max_by(|&a, &b| of[a].abs().total_cmp(&of[b].abs()));
                alone = alone.or(largest.map(|coefficient| (place, coefficient)));
            }
            let moved = times(&own.information, &fitted.change);
            let score: Vec<f64> = own.score.iter().zip(moved).map(|(a, b)| a - b).collect();
            add_square(&mut sum, &times(&freed, &times(&root, &score)), 1.0);
            parts.push((share, freed));
        }
        let matrix = product(&product(&root, &sum), &root);
        let degrees = (0..size).map(|i| degrees(&parts, &root[i])).collect();
        Self { matrix, degrees, alone }
    }
}

/// Degrees of freedom of the variance in a direction, by Satterthwaite under the model.
fn degrees(parts: &[(Matrix, Matrix)], direction: &[f64]) -> f64 {
    let (mut trace, mut squares) = (0.0, 0.0);
    for (i, (share, freed)) in parts.iter().enumerate() {
        let left = times(share, &times(freed, direction));
        for (j, (other, other_freed)) in parts.iter().enumerate() {
            let right = times(other_freed, direction);
            let mut entry = -dot(&left, &times(other, &right));
            if i == j {
                entry += dot(&left, &right);
                trace += entry;
            }
            squares += entry * entry;
        }
    }
    if squares > 0.0 { trace * trace / squares } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::super::mixed::{JointFit, Rows, Variances};
    use super::Covariance;

    /// Tests read equally: the standard error of the mean and n - 1, of any textbook.
    #[test]
    fn tests_read_alike_are_a_sample() {
        let values = [1.0, 2.0, 4.0, 5.0];
        let rows = |value: &f64| Rows {
            slopes: vec![vec![1.0]],
            left: vec![*value],
            unit: vec![1.0],
            group: vec![0],
        };
        let tests: Vec<Rows> = values.iter().map(rows).collect();
        let variances = Variances { between: vec![0.7], readings: vec![0.2] };
        let fitted = JointFit::of(&tests, &variances);
        let found = Covariance::of(&fitted);
        assert_relative_eq!(fitted.change[0], 3.0, max_relative = 1e-12);
        // The sum of squares about 3 is 10.
        assert_relative_eq!(found.matrix[0][0], 10.0 / 3.0 / 4.0, max_relative = 1e-12);
        assert_relative_eq!(found.degrees[0], 3.0, max_relative = 1e-12);
        assert_eq!(found.alone, None);
    }
}
