//! Loads and forces that are given, and the approach and slips that go with them.

use super::Mapped;
use super::regime::Regime;
use super::state::{APPROACH, State};
use crate::frame::VectorField;
use crate::numerics::vector::{Values, sum};

/// The border of the system: one row and one column for the load, if it is given, and for each force.
pub(super) struct Border {
    /// Whether the first is the load.
    pub loaded: bool,
    /// How the tractions along t1, t2 and n make each force: by the direction in which it acts, and the area of
    /// each pair relative to the mean.
    weights: Vec<VectorField>,
    /// What a unit of each approach or slip does to the rows of the pairs.
    pub columns: Vec<Vec<f64>>,
    /// Approach or slip (m) of one unit, which makes it count like a traction.
    pub unit: f64,
    /// Right-hand sides of its rows.
    pub right: Vec<f64>,
    /// Tractions that nearly answer to each column, and the inverse of the forces they make.
    responses: Vec<Vec<f64>>,
    inverse: Vec<Vec<f64>>,
}

impl Border {
    /// `precondition` is nearly the inverse of the rows of the pairs.
    pub fn of(
        state: &State,
        step: &Mapped<'_>,
        regime: &Regime,
        precondition: impl Fn(&[f64]) -> Vec<f64>,
    ) -> Self {
        let pairs = regime.touch.len();
        let (load, forces) = state.missing(step);
        // The gap closes as the approach grows, the slip grows as the bodies are shifted.
        let mut directions: Vec<[f64; 3]> = load.map(|_| APPROACH).into_iter().collect();
        directions.extend(
            step.prescribed
                .iter()
                .map(|prescribed| [prescribed.direction[0], prescribed.direction[1], 0.0]),
        );
        let zero = VectorField::zeros(pairs);
        let column = |direction: &[f64; 3]| {
            regime.rows(&step.moved(direction.map(|component| -component)), &zero)
        };
        let columns: Vec<Vec<f64>> = directions.iter().map(column).collect();
        let measure = step.frame.measure();
        let weigh = |direction: &[f64; 3]| weighed(step.moved(*direction), measure.weight);
        let weights = directions.iter().map(weigh).collect();
        let mut border = Self {
            loaded: load.is_some(),
            weights,
            unit: state.own[0] / (regime.touching().max(1) as f64).sqrt(),
            right: vec![],
            responses: columns.iter().map(|rows| precondition(rows)).collect(),
            columns,
            inverse: vec![],
        };
        let known = border.forces(&regime.fixed);
        let area = measure.area;
        let missing = load.into_iter().chain(forces).zip(known);
        border.right =
            missing.map(|(missing, known)| border.unit * missing / area - known).collect();
        let made: Vec<Vec<f64>> = border
            .responses
            .iter()
            .map(|response| border.forces(&regime.tractions(&regime.unknown(response))))
            .collect();
        border.inverse = inverse_of_columns(&made);
        border
    }

    /// What tractions (Pa) make of each force, in the unit of the rows.
    pub fn forces(&self, tractions: &VectorField) -> Vec<f64> {
        let force = |weights: &VectorField| {
            let [a, b, c] = weights.components();
            let [x, y, z] = tractions.components();
            let [force] = sum([a, b, c, x, y, z], |[a, b, c, x, y, z]| [a * x + b * y + c * z]);
            force
        };
        self.weights.iter().map(|weights| self.unit * force(weights)).collect()
    }

    /// Takes from tractions, whose forces exceed those wanted, what puts that right; the approach and slips
    /// (m) that do it.
    pub fn relieve(&self, tractions: &mut [f64], excess: &[f64]) -> Vec<f64> {
        let slip = |row: &Vec<f64>| row.iter().zip(excess).map(|(a, b)| a * b).sum();
        let slips: Vec<f64> = self.inverse.iter().map(slip).collect();
        for (response, slip) in self.responses.iter().zip(&slips) {
            for (traction, response) in tractions.iter_mut().zip(response) {
                *traction -= slip * response;
            }
        }
        slips
    }
}

/// A field times the weights of the pairs.
fn weighed(field: VectorField, weight: Values<'_>) -> VectorField {
    let VectorField { mut t1, mut t2, mut n } = field;
    for part in [&mut t1, &mut t2, &mut n] {
        part.iter_mut().enumerate().for_each(|(pair, value)| *value *= weight.at(pair));
    }
    VectorField { t1, t2, n }
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
