//! Factors of the linear system about a solution, kept to precondition the systems about those near it.
//!
//! What pairs do changes little from one cycle to the same place of the next: a few of them join or leave at the
//! edge of the contact, a few more begin or cease to slip, and the directions of slip turn. With the factors of
//! the system as it was, the Krylov iteration has only these to put right. Worth while where the compliance is a
//! matrix; elsewhere there are none.

use std::sync::OnceLock;

use faer::MatMut;
use serde::{Deserialize, Serialize};

use super::Mapped;
use super::regime::{Regime, Sliding};
use super::state::State;
use crate::numerics::dense::Lu;
use crate::numerics::large::Large;

/// Most unknowns whose factors are kept: 9 MiB for each place of a cycle. A choice of memory: factors only precondition.
const MOST: usize = 1536;
/// How far below zero the augmented pressure of a pair may be that nearly touches, relative to the largest. A choice of cost:
/// factors only precondition.
const NEAR: f64 = 0.1;

/// See the module.
#[derive(Debug, Serialize, Deserialize)]
pub struct Factors {
    /// The pairs that were in contact, and those that nearly were.
    pairs: Vec<usize>,
    /// What they did.
    regime: Regime,
    /// In single precision: Newton's steps make up for it. They follow from the others, and are made anew rather than
    /// kept in a checkpoint.
    #[serde(skip)]
    lu: OnceLock<Lu<f32>>,
}

/// Memory (bytes) of what is kept for each place of a cycle with so many pairs in contact.
pub fn factors_memory(in_contact: f64) -> f64 {
    let unknowns = 3.0 * in_contact;
    if unknowns > MOST as f64 { 0.0 } else { 4.0 * unknowns * unknowns }
}

impl Factors {
    /// Of the rows of the pairs in contact, each along t1, t2 and n; `None` where the compliance has no matrix
    /// or it would be too large.
    pub(super) fn of(state: &State, step: &Mapped<'_>) -> Option<Self> {
        let regime = Regime::of(state, step);
        let augmented: Vec<f64> = (0..regime.pairs.len()).map(|i| state.augmented(i)).collect();
        let least = -NEAR * augmented.iter().copied().fold(0.0, f64::max);
        let near = |pair: usize| !regime.is_open(pair) || augmented[pair] > least;
        let pairs: Vec<usize> = (0..augmented.len()).filter(|&pair| near(pair)).collect();
        let count = pairs.len();
        if count == 0 || 3 * count > MOST {
            return None;
        }
        let factors = Self { pairs, regime, lu: OnceLock::new() };
        factors.are_made(step).then_some(factors)
    }

    /// Whether there are factors, made if need be.
    pub(super) fn are_made(&self, step: &Mapped<'_>) -> bool {
        if self.lu.get().is_none()
            && let Some(lu) = self.make(step)
        {
            let _ = self.lu.set(lu);
        }
        self.lu.get().is_some()
    }

    fn make(&self, step: &Mapped<'_>) -> Option<Lu<f32>> {
        let Self { pairs, regime, .. } = self;
        let (count, own) = (pairs.len(), step.compliance.shifting(step.frame).own());
        let whole = step.compliance.matrix(pairs)?;
        let mut system = Large::zeros(3 * count, 3 * count).ok()?;
        system.values_mut().iter_mut().zip(&whole).for_each(|(one, value)| *one = *value as f32);
        for (index, &pair) in pairs.iter().enumerate() {
            let places = [index, count + index, 2 * count + index];
            if let Some(sliding) = regime.sliding(pair) {
                sliding.put_in(system.as_mut(), places, own as f32);
            } else if regime.is_open(pair) {
                leave_out(system.as_mut(), places, own as f32);
            }
        }
        Lu::new(system).ok()
    }

    /// What the pairs did, asking for what a state near theirs lacks.
    pub(super) fn regime(&self, state: &State, step: &Mapped<'_>) -> Regime {
        let mut regime = self.regime.clone();
        regime.aim_at(state, step);
        regime
    }

    /// Replaces, on these pairs, tractions by those that the rows answer to.
    pub(super) fn solve(&self, rows: [&[f64]; 3], tractions: [&mut [f64]; 3]) {
        let mut image = self.gather(rows);
        if let Some(lu) = self.lu.get() {
            lu.solve(&mut image);
        }
        self.scatter(&image, tractions);
    }

    fn gather(&self, parts: [&[f64]; 3]) -> Vec<f32> {
        let values = |part: &'_ [f64]| self.pairs.iter().map(|&pair| part[pair] as f32).collect();
        parts.map(values).into_iter().flat_map(|part: Vec<f32>| part).collect()
    }

    fn scatter(&self, values: &[f32], parts: [&mut [f64]; 3]) {
        for (values, part) in values.chunks(self.pairs.len()).zip(parts) {
            self.pairs.iter().zip(values).for_each(|(&pair, value)| part[pair] = (*value).into());
        }
    }
}

/// Leaves a row and a column of their own to each direction of a pair.
fn leave_out(mut matrix: MatMut<'_, f32>, places: [usize; 3], own: f32) {
    for place in places {
        for other in 0..matrix.nrows() {
            matrix[(place, other)] = 0.0;
            matrix[(other, place)] = 0.0;
        }
        matrix[(place, place)] = own;
    }
}

impl Sliding {
    /// Leaves of the tangential rows and columns of a pair the part across its slip, lets its limit follow its
    /// pressure, and gives the part along its slip, which is known, a row of its own.
    fn put_in(&self, mut matrix: MatMut<'_, f32>, [one, two, n]: [usize; 3], own: f32) {
        let [u, v] = self.along.map(|component| component as f32);
        let (slope, diagonal) = (self.slope as f32, self.diagonal as f32);
        for row in 0..matrix.nrows() {
            let [a, b] = [matrix[(row, one)], matrix[(row, two)]];
            let along = u * a + v * b;
            matrix[(row, n)] -= slope * along;
            (matrix[(row, one)], matrix[(row, two)]) = (a - along * u, b - along * v);
        }
        for column in 0..matrix.ncols() {
            let [a, b] = [matrix[(one, column)], matrix[(two, column)]];
            let along = u * a + v * b;
            (matrix[(one, column)], matrix[(two, column)]) = (a - along * u, b - along * v);
        }
        let parts = [(one, one, u * u), (one, two, u * v), (two, one, u * v), (two, two, v * v)];
        for (row, column, along) in parts {
            let across = f32::from(u8::from(row == column)) - along;
            matrix[(row, column)] += diagonal * across + own * along;
        }
    }
}
