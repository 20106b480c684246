//! Loads and forces that are given, and the approach and slips that go with them.

use super::Mapped;
use super::regime::Regime;
use super::state::{APPROACH, State};
use crate::frame::VectorField;
use crate::numerics::vector::{Values, sum};
use crate::solve::semismooth::Schur;

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
    pub schur: Schur,
}

impl Border {
    /// `precondition` is nearly the inverse of the rows of the pairs.
    pub fn of(
        state: &State,
        step: &Mapped<'_>,
        regime: &Regime,
        precondition: impl Fn(&[f64]) -> Vec<f64>,
    ) -> Self {
        let (load, forces) = state.missing(step);
        // The gap closes as the approach grows, the slip grows as the bodies are shifted.
        let mut directions: Vec<[f64; 3]> = load.map(|_| APPROACH).into_iter().collect();
        directions.extend(
            step.prescribed.iter().map(|given| [given.direction[0], given.direction[1], 0.0]),
        );
        let zero = VectorField::zeros(regime.pairs.len());
        let column = |direction: &[f64; 3]| {
            regime.rows(&step.moved(direction.map(|component| -component)), &zero)
        };
        let columns: Vec<Vec<f64>> = directions.iter().map(column).collect();
        let measure = step.frame.measure();
        let weigh = |direction: &[f64; 3]| weighed(step.moved(*direction), measure.weight);
        let unit = state.own[0] / (regime.touching().max(1) as f64).sqrt();
        let responses = columns.iter().map(|rows| precondition(rows)).collect();
        let mut border = Self {
            loaded: load.is_some(),
            weights: directions.iter().map(weigh).collect(),
            columns,
            unit,
            right: vec![],
            schur: Schur::default(),
        };
        let missing = load.into_iter().chain(forces).zip(border.forces(&regime.fixed));
        border.right =
            missing.map(|(missing, known)| unit * missing / measure.area - known).collect();
        border.schur = Schur::of(responses, |response| border.forces_of(response, regime));
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

    /// The same of the tractions that belong to unknown ones.
    pub fn forces_of(&self, unknown: &[f64], regime: &Regime) -> Vec<f64> {
        self.forces(&regime.tractions(&regime.unknown(unknown)))
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
