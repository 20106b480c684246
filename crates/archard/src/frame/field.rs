//! Vectors on the pairs of a frame.

use serde::{Deserialize, Serialize};

use crate::numerics::vector::update;

/// A vector a pair, in the local bases {t1, t2, n}, one array a component.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct VectorField {
    /// Component along t1 (x).
    pub t1: Vec<f64>,
    /// Component along t2 (y).
    pub t2: Vec<f64>,
    /// Component along n.
    pub n: Vec<f64>,
}

impl VectorField {
    /// Zero vectors on that many pairs.
    pub fn zeros(pairs: usize) -> Self {
        Self { t1: vec![0.0; pairs], t2: vec![0.0; pairs], n: vec![0.0; pairs] }
    }

    /// The three components in the order t1, t2, n.
    pub fn components(&self) -> [&[f64]; 3] {
        [&self.t1, &self.t2, &self.n]
    }

    /// Adds another field times a factor.
    pub fn add(&mut self, other: &Self, factor: f64) {
        let Self { t1, t2, n } = self;
        for (part, other) in [t1, t2, n].into_iter().zip(other.components()) {
            update(part, [other], |value, [other]| value + factor * other);
        }
    }
}
