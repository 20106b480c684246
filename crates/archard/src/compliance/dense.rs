//! A compliance as a matrix: bodies whose equations were condensed to the pairs.

use std::fmt;

use faer::MatRef;
use rayon::prelude::*;

use super::Compliance;
use crate::frame::{ContactFrame, VectorField};

/// The compliance of both bodies as one matrix on the tractions along t1, t2 and n.
///
/// An application costs O(N^2) in the number of pairs, and so does the memory.
pub struct Dense {
    pairs: usize,
    /// Rows of the matrix one after the other: along t1 of all pairs, along t2, along n; so the columns.
    rows: Vec<f64>,
    normal_self_term: f64,
    tangential_self_term: f64,
    couples: bool,
}

/// Rows that are worth a thread.
const ROWS: usize = 64;
/// Coupling of normal and tangential directions, relative to the largest value, that is rounding.
const ROUNDING: f64 = 1e-12;

impl fmt::Debug for Dense {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Dense").field("pairs", &self.pairs).finish_non_exhaustive()
    }
}

impl Dense {
    /// The sum of the compliances of bodies on a frame, each with row 3 i + d for the displacement (m) of
    /// pair i along direction d of its basis and column 3 j + e for the traction (Pa) of pair j along e.
    ///
    /// Collocation leaves them a little unsymmetric: the mean of the work that two tractions do on each
    /// other's displacements is kept.
    pub fn new(bodies: &[MatRef<'_, f64>], frame: &ContactFrame) -> Self {
        let pairs = frame.len();
        let sum = |row: usize, column: usize| -> f64 {
            bodies.iter().map(|body| body[(row, column)]).sum()
        };
        let areas: Vec<f64> = (0..pairs).map(|pair| frame.area(pair)).collect();
        let mut rows = vec![0.0; 9 * pairs * pairs];
        rows.par_chunks_mut(3 * pairs).enumerate().for_each(|(row, values)| {
            let (d, i) = (row / pairs, row % pairs);
            for (column, value) in values.iter_mut().enumerate() {
                let (e, j) = (column / pairs, column % pairs);
                let back = sum(3 * j + e, 3 * i + d) * areas[j] / areas[i];
                *value = 0.5 * (sum(3 * i + d, 3 * j + e) + back);
            }
        });
        let own = |d: usize| {
            let diagonal = (0..pairs).map(|pair| rows[(d * pairs + pair) * (3 * pairs + 1)]);
            diagonal.fold(0.0, f64::max)
        };
        let (normal_self_term, tangential_self_term) = (own(2), own(0).max(own(1)));
        let coupled = |row: usize, column: usize| {
            rows[row * 3 * pairs + column].abs() > ROUNDING * normal_self_term
        };
        let couples = (0..2 * pairs).any(|row| (2 * pairs..3 * pairs).any(|n| coupled(row, n)));
        Self { pairs, rows, normal_self_term, tangential_self_term, couples }
    }

    /// How far two tractions' work on each other's displacements differs, relative to all of it.
    pub fn asymmetry(body: MatRef<'_, f64>, frame: &ContactFrame) -> f64 {
        let work = |row: usize, column: usize| frame.area(row / 3) * body[(row, column)];
        let (mut difference, mut all) = (0.0, 0.0);
        for row in 0..body.nrows() {
            for column in 0..body.ncols() {
                difference += (work(row, column) - work(column, row)).powi(2);
                all += work(row, column).powi(2);
            }
        }
        f64::sqrt(difference / all)
    }

    /// Adds the part of the displacements in a range of rows that tractions in a range of columns make.
    fn multiply(&self, first_row: usize, first_column: usize, vector: &[f64], image: &mut [f64]) {
        let width = 3 * self.pairs;
        image.par_iter_mut().with_min_len(ROWS).enumerate().for_each(|(row, value)| {
            let start = (first_row + row) * width + first_column;
            *value = dot(&self.rows[start..start + vector.len()], vector);
        });
    }
}

/// Product of two vectors, in an order that does not depend on threads.
fn dot(a: &[f64], b: &[f64]) -> f64 {
    let ((a, a_rest), (b, b_rest)) = (a.as_chunks::<8>(), b.as_chunks::<8>());
    let mut sums = [0.0; 8];
    for (a, b) in a.iter().zip(b) {
        for lane in 0..8 {
            sums[lane] += a[lane] * b[lane];
        }
    }
    let rest: f64 = a_rest.iter().zip(b_rest).map(|(a, b)| a * b).sum();
    sums.iter().sum::<f64>() + rest
}

impl Compliance for Dense {
    fn apply(&self, tractions: &VectorField) -> VectorField {
        let vector = tractions.components().concat();
        let mut displacements = VectorField::zeros(self.pairs);
        let VectorField { t1, t2, n } = &mut displacements;
        for (component, image) in [t1, t2, n].into_iter().enumerate() {
            self.multiply(component * self.pairs, 0, &vector, image);
        }
        displacements
    }

    fn apply_normal(&self, pressure: &[f64], displacement: &mut [f64]) {
        self.multiply(2 * self.pairs, 2 * self.pairs, pressure, displacement);
    }

    fn normal_self_term(&self) -> f64 {
        self.normal_self_term
    }

    fn tangential_self_term(&self, _: &ContactFrame) -> f64 {
        self.tangential_self_term
    }

    fn couples(&self) -> bool {
        self.couples
    }
}
