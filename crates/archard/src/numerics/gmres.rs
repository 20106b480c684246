//! Generalised minimal residuals for linear maps of no particular symmetry.
//!
//! Y. Saad and M. H. Schultz, *SIAM J. Sci. Stat. Comput.* 7 (1986) 856, preconditioned from the right
//! (Y. Saad, *SIAM J. Sci. Comput.* 14 (1993) 461), so that the residual it watches is the true one.

use super::vector::{sum, update};

/// A linear system.
pub trait System {
    /// The image of a vector.
    fn apply(&mut self, vector: &[f64]) -> Vec<f64>;

    /// Nearly the vector whose image is given.
    fn precondition(&mut self, image: &[f64]) -> Vec<f64>;
}

/// What the iteration found.
#[derive(Debug, Clone, PartialEq)]
pub struct Solution {
    /// The vector.
    pub vector: Vec<f64>,
    /// How much of each vector the map was applied to there is in it, in their order.
    pub weights: Vec<f64>,
}

/// Solves until the residual (2-norm) is no larger than the one aimed at, or until the given number of iterations is done;
/// then the vector is the best of those tried.
pub fn solve(system: &mut impl System, right: &[f64], aim: f64, max_iterations: usize) -> Solution {
    let norm = dot(right, right).sqrt();
    let mut space = Space::default();
    let mut residual = norm;
    if norm > 0.0 {
        space.basis.push(scaled(right, 1.0 / norm));
        space.projected.push(norm);
    }
    while residual > aim && space.directions.len() < max_iterations {
        let last = &space.basis[space.directions.len()];
        let direction = system.precondition(last);
        let image = system.apply(&direction);
        if !space.extend(direction, image) {
            break;
        }
        residual = space.projected[space.directions.len()].abs();
    }
    space.combine(right.len())
}

/// An orthonormal basis of the images, and the small triangular system they amount to.
#[derive(Default)]
struct Space {
    basis: Vec<Vec<f64>>,
    directions: Vec<Vec<f64>>,
    /// Columns of the triangular matrix.
    columns: Vec<Vec<f64>>,
    /// Cosines and sines of the rotations that made it triangular.
    rotations: Vec<[f64; 2]>,
    /// The right-hand side in the rotated basis; its last value is the residual.
    projected: Vec<f64>,
}

impl Space {
    /// Takes up a direction and its image; `false` if the image adds nothing.
    fn extend(&mut self, direction: Vec<f64>, mut image: Vec<f64>) -> bool {
        let mut column = Vec::with_capacity(self.basis.len() + 1);
        for vector in &self.basis {
            let part = dot(vector, &image);
            update(&mut image, [vector], |value, [vector]| value - part * vector);
            column.push(part);
        }
        let norm = dot(&image, &image).sqrt();
        column.push(norm);
        for (row, [cosine, sine]) in self.rotations.iter().enumerate() {
            let (upper, lower) = (column[row], column[row + 1]);
            column[row] = cosine * upper + sine * lower;
            column[row + 1] = cosine * lower - sine * upper;
        }
        let row = self.rotations.len();
        let length = column[row].hypot(norm);
        if !(length > 0.0 && length.is_finite()) {
            return false;
        }
        let [cosine, sine] = [column[row] / length, norm / length];
        column.truncate(row);
        column.push(length);
        let value = self.projected[row];
        self.projected[row] = cosine * value;
        self.projected.push(-sine * value);
        self.rotations.push([cosine, sine]);
        self.columns.push(column);
        self.directions.push(direction);
        // A vanishing rest means that the residual has vanished too.
        self.basis.push(scaled(&image, if norm > 0.0 { 1.0 / norm } else { 0.0 }));
        true
    }

    /// The combination of the directions with the smallest residual.
    fn combine(&self, length: usize) -> Solution {
        let count = self.directions.len();
        let mut weights = self.projected[..count].to_vec();
        for row in (0..count).rev() {
            for column in row + 1..count {
                weights[row] -= self.columns[column][row] * weights[column];
            }
            weights[row] /= self.columns[row][row];
        }
        let mut vector = vec![0.0; length];
        for (direction, &weight) in self.directions.iter().zip(&weights) {
            update(&mut vector, [direction], |value, [direction]| value + weight * direction);
        }
        Solution { vector, weights }
    }
}

fn dot(one: &[f64], other: &[f64]) -> f64 {
    let [sum] = sum([one, other], |[one, other]| [one * other]);
    sum
}

fn scaled(vector: &[f64], factor: f64) -> Vec<f64> {
    vector.iter().map(|value| factor * value).collect()
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::{Solution, System, solve};

    /// A matrix by rows, preconditioned by its diagonal or not at all.
    struct Matrix {
        rows: Vec<Vec<f64>>,
        diagonal: bool,
    }

    impl System for Matrix {
        fn apply(&mut self, vector: &[f64]) -> Vec<f64> {
            let image = |row: &Vec<f64>| row.iter().zip(vector).map(|(a, b)| a * b).sum();
            self.rows.iter().map(image).collect()
        }

        fn precondition(&mut self, image: &[f64]) -> Vec<f64> {
            let scale = |row: usize| if self.diagonal { self.rows[row][row] } else { 1.0 };
            image.iter().enumerate().map(|(row, value)| value / scale(row)).collect()
        }
    }

    /// Skew but for its diagonal, as rolling is.
    fn skew(diagonal: bool) -> Matrix {
        let element = |i: usize, j: usize| match i.cmp(&j) {
            std::cmp::Ordering::Equal => 1.0 + i as f64,
            std::cmp::Ordering::Less => 1.0 / (j - i) as f64,
            std::cmp::Ordering::Greater => -1.0 / (i - j) as f64,
        };
        Matrix { rows: (0..9).map(|i| (0..9).map(|j| element(i, j)).collect()).collect(), diagonal }
    }

    #[test]
    fn a_system_is_solved_in_as_many_iterations_as_it_has_rows() {
        for diagonal in [false, true] {
            let mut matrix = skew(diagonal);
            let expected: Vec<f64> = (0..9).map(|i| f64::from(i).sin()).collect();
            let right = matrix.apply(&expected);
            let Solution { vector, weights } = solve(&mut matrix, &right, 1e-13, 50);
            assert!(weights.len() <= 9, "{}", weights.len());
            for (found, expected) in vector.iter().zip(&expected) {
                assert_relative_eq!(found, expected, epsilon = 1e-11);
            }
        }
    }

    #[test]
    fn few_iterations_leave_the_smallest_residual_and_nothing_takes_none() {
        let mut matrix = skew(true);
        let right = vec![1.0; 9];
        let residual = |matrix: &mut Matrix, count: usize| {
            let solution = solve(matrix, &right, 0.0, count);
            let image = matrix.apply(&solution.vector);
            image.iter().zip(&right).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
        };
        let residuals: Vec<f64> = (0..6).map(|count| residual(&mut matrix, count)).collect();
        assert!(residuals.windows(2).all(|pair| pair[1] < pair[0]), "{residuals:?}");
        assert!(solve(&mut matrix, &[0.0; 9], 1e-6, 5).weights.is_empty());
    }
}
