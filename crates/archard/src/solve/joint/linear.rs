//! Contact and friction linearised about an iterate.
//!
//! Pairs whose [augmented pressure](State::augmented) is positive are in contact and keep their gap at
//! zero, the others lose their tractions. In contact, the augmented traction q = t + s / c says which
//! pairs stick and keep their slip at zero; where |q| exceeds the limit they slip: along q the traction
//! is on the limit, which changes with the pressure, and across it
//!
//! ```text
//! (limit / |q|) (C dL) + c (1 - limit / |q|) dt = s
//! ```
//!
//! Loads and forces that are given border the system with the approach and the slips that go with them.

use super::state::State;
use super::{Solution, Step};
use crate::compliance::{Preconditioner, Rub, SlipMap};
use crate::frame::VectorField;
use crate::numerics::gmres::{self, System};
use crate::numerics::vector::{map, update};

/// Residual of the linear system, relative to its right-hand side, while the pairs in contact and those
/// that stick change by more than `SETTLED` of them; after that what the aim needs.
const LOOSE: f64 = 0.1;
const TIGHT: f64 = 0.02;
const SETTLED: f64 = 0.01;
/// Krylov iterations of one step.
const KRYLOV: usize = 80;

/// The system. Vectors hold the unknown tractions (Pa) along t1, t2 and n, then the approach and the
/// slips that are found, in the unit that makes them count like tractions.
pub(super) struct Linear<'s> {
    step: &'s Step<'s>,
    normal: Box<dyn Preconditioner + 's>,
    tangential: Box<dyn SlipMap + 's>,
    rub: Rub,
    /// Two where a pair sticks, one where it slips or only touches, zero where it is open.
    pub touching: Vec<u8>,
    /// Unit vectors along the augmented tractions of slipping pairs.
    along: [Vec<f64>; 2],
    /// How the limit of slipping pairs changes with the pressure.
    slope: Vec<f64>,
    /// limit / |q| of slipping pairs, and c (1 - limit / |q|) (m/Pa); one and zero elsewhere.
    share: Vec<f64>,
    diagonal: Vec<f64>,
    /// The part of the change that is known.
    fixed: VectorField,
    fixed_displacement: Option<VectorField>,
    right: Vec<f64>,
    /// What the unknowns of the border do to the rows.
    columns: Vec<Vec<f64>>,
    /// How the tractions make the forces of the border: weights, and a unit.
    weights: Vec<[f64; 3]>,
    unit: f64,
    loaded: bool,
    responses: Vec<Vec<f64>>,
    inverse: Vec<Vec<f64>>,
    tried: Vec<VectorField>,
    pub applications: usize,
}

fn split(vector: &[f64], pairs: usize) -> [&[f64]; 3] {
    let (t1, rest) = vector.split_at(pairs);
    let (t2, rest) = rest.split_at(pairs);
    [t1, t2, &rest[..pairs]]
}

impl<'s> Linear<'s> {
    pub fn about(state: &State, step: &'s Step<'s>) -> Self {
        let pairs = step.gap.len();
        let zeros = || vec![0.0; pairs];
        let mut linear = Self {
            step,
            normal: step.compliance.normal_preconditioner(0.0),
            tangential: step.compliance.shifting(step.frame),
            rub: Rub { stick: zeros(), slip: zeros(), diagonal: zeros() },
            touching: vec![0; pairs],
            along: [zeros(), zeros()],
            slope: zeros(),
            share: vec![1.0; pairs],
            diagonal: zeros(),
            fixed: VectorField::zeros(pairs),
            fixed_displacement: None,
            right: vec![0.0; 3 * pairs],
            columns: vec![],
            weights: vec![],
            unit: state.own[0],
            loaded: false,
            responses: vec![],
            inverse: vec![],
            tried: vec![],
            applications: 0,
        };
        (0..pairs).for_each(|pair| linear.classify(pair, state));
        linear.apply_fixed();
        linear.add_border(state);
        linear
    }

    /// What a pair does, its equations and what of its change is known.
    fn classify(&mut self, pair: usize, state: &State) {
        let pairs = self.touching.len();
        let VectorField { t1, t2, n } = &state.solution.traction;
        let t = [t1[pair], t2[pair]];
        let pressure = state.augmented(pair);
        if pressure <= 0.0 {
            self.fixed.n[pair] = -n[pair];
            (self.fixed.t1[pair], self.fixed.t2[pair]) = (-t[0], -t[1]);
            return;
        }
        self.right[2 * pairs + pair] = state.gap[pair];
        let limit = self.step.friction.limit(pressure);
        let s = [state.slip[0][pair], state.slip[1][pair]];
        let q = [0, 1].map(|axis| t[axis] + s[axis] / state.own[1]);
        let length = q[0].hypot(q[1]);
        if length <= limit {
            self.touching[pair] = 2;
            self.rub.stick[pair] = 1.0;
            (self.right[pair], self.right[pairs + pair]) = (s[0], s[1]);
            return;
        }
        self.touching[pair] = 1;
        let unit = q.map(|value| value / length);
        let (share, slope) = (limit / length, self.step.friction.slope(pressure));
        self.rub.slip[pair] = 1.0;
        self.rub.diagonal[pair] = state.own[1] * (1.0 - share) / share.max(1e-12);
        (self.share[pair], self.diagonal[pair]) = (share, state.own[1] * (1.0 - share));
        (self.along[0][pair], self.along[1][pair], self.slope[pair]) = (unit[0], unit[1], slope);
        // On the limit of the pressure as it is; what the pressure changes by changes the limit.
        let bound = limit + slope * (-n[pair] - pressure);
        let short = bound - (t[0] * unit[0] + t[1] * unit[1]);
        (self.fixed.t1[pair], self.fixed.t2[pair]) = (short * unit[0], short * unit[1]);
        let across = s[1] * unit[0] - s[0] * unit[1];
        (self.right[pair], self.right[pairs + pair]) = (-across * unit[1], across * unit[0]);
    }

    fn apply_fixed(&mut self) {
        let VectorField { t1, t2, n } = &self.fixed;
        if [t1, t2, n].iter().all(|part| part.iter().all(|&value| value == 0.0)) {
            return;
        }
        self.applications += 1;
        let displacement = self.step.compliance.apply(&self.fixed);
        let taken = self.rows(&displacement, &VectorField::zeros(self.touching.len()));
        update(&mut self.right, [&taken], |right, [taken]| right - taken);
        self.fixed_displacement = Some(displacement);
    }

    /// The rows of the pairs under a displacement (m) and unknown tractions (Pa).
    fn rows(&self, displacement: &VectorField, unknown: &VectorField) -> Vec<f64> {
        let pairs = self.touching.len();
        let mut rows = vec![0.0; 3 * pairs];
        for pair in 0..pairs {
            let (x, y) = (displacement.t1[pair], displacement.t2[pair]);
            match self.touching[pair] {
                0 => continue,
                2 => (rows[pair], rows[pairs + pair]) = (x, y),
                _ => {
                    let (a, b) = (-self.along[1][pair], self.along[0][pair]);
                    let across = self.share[pair] * (a * x + b * y)
                        + self.diagonal[pair] * (a * unknown.t1[pair] + b * unknown.t2[pair]);
                    (rows[pair], rows[pairs + pair]) = (a * across, b * across);
                }
            }
            rows[2 * pairs + pair] = displacement.n[pair];
        }
        rows
    }

    /// The unknown part of tractions: all where pairs stick, across q and the pressure where they slip.
    fn unknown(&self, vector: &[f64]) -> VectorField {
        let pairs = self.touching.len();
        let [t1, t2, n] = split(vector, pairs);
        let mut field = VectorField::zeros(pairs);
        for pair in 0..pairs {
            match self.touching[pair] {
                0 => continue,
                2 => (field.t1[pair], field.t2[pair]) = (t1[pair], t2[pair]),
                _ => {
                    let (a, b) = (-self.along[1][pair], self.along[0][pair]);
                    let across = a * t1[pair] + b * t2[pair];
                    (field.t1[pair], field.t2[pair]) = (a * across, b * across);
                }
            }
            field.n[pair] = n[pair];
        }
        field
    }

    /// The tractions an unknown part brings along: limits that follow the pressure.
    fn tractions(&self, unknown: &VectorField) -> VectorField {
        let follow = |axis: usize, part: &[f64]| {
            map([part, &self.along[axis], &self.slope, &unknown.n], |[part, along, slope, n]| {
                part - slope * n * along
            })
        };
        VectorField { t1: follow(0, &unknown.t1), t2: follow(1, &unknown.t2), n: unknown.n.clone() }
    }

    /// Unknown slips and approach, and the forces they have to make.
    fn add_border(&mut self, state: &State) {
        let pairs = self.touching.len();
        let area = self.step.frame.element_area();
        let touching = self.touching.iter().filter(|&&touching| touching > 0).count();
        self.unit /= (touching.max(1) as f64).sqrt();
        let (load, forces) = state.missing(self.step);
        self.loaded = load.is_some();
        // The gap closes as the approach grows, the slip grows as the bodies are shifted.
        self.weights.extend(load.map(|_| [0.0, 0.0, -1.0]));
        let along = self.step.held.iter().map(|held| [held.direction[0], held.direction[1], 0.0]);
        self.weights.extend(along);
        let missing: Vec<f64> = load.into_iter().chain(forces).collect();
        let zero = VectorField::zeros(pairs);
        let column = |[x, y, n]: [f64; 3]| {
            let [t1, t2, n] = [x, y, n].map(|weight| vec![-weight; pairs]);
            self.rows(&VectorField { t1, t2, n }, &zero)
        };
        self.columns = self.weights.iter().map(|weights| column(*weights)).collect();
        for (index, missing) in missing.iter().enumerate() {
            let made = self.force(index, &self.fixed);
            self.right.push(self.unit * (missing / area - made));
        }
        self.responses = self.columns.iter().map(|rows| self.undo(rows)).collect();
        let count = self.weights.len();
        let gains: Vec<Vec<f64>> = (0..count)
            .map(|row| {
                (0..count)
                    .map(|column| {
                        let tractions = self.tractions(&self.unknown(&self.responses[column]));
                        self.unit * self.force(row, &tractions)
                    })
                    .collect()
            })
            .collect();
        self.inverse = inverted(gains);
    }

    /// Sum of tractions (Pa) that a force of the border weighs.
    fn force(&self, index: usize, tractions: &VectorField) -> f64 {
        let [x, y, n] = self.weights[index];
        let total = |weight: f64, part: &[f64]| {
            if weight == 0.0 { 0.0 } else { weight * part.iter().sum::<f64>() }
        };
        total(x, &tractions.t1) + total(y, &tractions.t2) + total(n, &tractions.n)
    }

    /// Nearly the unknown tractions whose rows are given, without the border.
    fn undo(&self, rows: &[f64]) -> Vec<f64> {
        let pairs = self.touching.len();
        let [one, two, n] = split(rows, pairs);
        // Rows of slipping pairs were weighed by their share.
        let unweigh = |part: &[f64]| map([part, &self.share], |[part, share]| part / share.max(1e-12));
        let (one, two) = (unweigh(one), unweigh(two));
        let mut result = vec![0.0; 3 * pairs];
        let (first, rest) = result.split_at_mut(pairs);
        let (second, third) = rest.split_at_mut(pairs);
        self.tangential.undo([&one, &two], &self.rub, [first, second]);
        self.normal.apply(n, third);
        let VectorField { t1, t2, n } = self.unknown(&result);
        [t1, t2, n].concat()
    }

    /// How well to solve: roughly while contact and stick still change much.
    pub fn tolerance(&self, last: &[u8], residual: f64, aim: f64) -> f64 {
        let touching = self.touching.iter().filter(|&&touching| touching > 0).count();
        let changed = if last.is_empty() {
            0
        } else {
            self.touching.iter().zip(last).filter(|(now, before)| now != before).count()
        };
        let enough = 0.2 * aim / residual;
        let settled = changed as f64 <= (SETTLED * touching as f64).max(1.0);
        let tolerance = if settled { TIGHT.min(residual) } else { LOOSE };
        tolerance.max(enough).min(LOOSE)
    }

    /// The change of tractions, displacement, approach and found slips.
    pub fn solve(&mut self, tolerance: f64) -> Solution {
        let pairs = self.touching.len();
        let right = std::mem::take(&mut self.right);
        let gmres::Solution { vector, weights } = gmres::solve(self, &right, tolerance, KRYLOV);
        let mut traction = self.tractions(&self.unknown(&vector));
        let mut displacement =
            self.fixed_displacement.take().unwrap_or_else(|| VectorField::zeros(pairs));
        add(&mut traction, &self.fixed, 1.0);
        for (tried, weight) in self.tried.iter().zip(weights) {
            add(&mut displacement, tried, weight);
        }
        let border: Vec<f64> = vector[3 * pairs..].iter().map(|value| self.unit * value).collect();
        let (approach, found) =
            if self.loaded { (border[0], border[1..].to_vec()) } else { (0.0, border) };
        Solution { traction, displacement, approach, found }
    }
}

impl System for Linear<'_> {
    fn apply(&mut self, vector: &[f64]) -> Vec<f64> {
        let unknown = self.unknown(vector);
        let tractions = self.tractions(&unknown);
        let displacement = self.step.compliance.apply(&tractions);
        self.applications += 1;
        let mut rows = self.rows(&displacement, &unknown);
        self.tried.push(displacement);
        let pairs = self.touching.len();
        for (column, value) in self.columns.iter().zip(&vector[3 * pairs..]) {
            let slip = self.unit * value;
            update(&mut rows, [column], |row, [column]| row + slip * column);
        }
        rows.extend((0..self.weights.len()).map(|index| self.unit * self.force(index, &tractions)));
        rows
    }

    fn precondition(&mut self, image: &[f64]) -> Vec<f64> {
        let pairs = self.touching.len();
        let mut result = self.undo(image);
        let count = self.weights.len();
        if count == 0 {
            return result;
        }
        let tractions = self.tractions(&self.unknown(&result));
        // Rows: response to the tractions plus columns times slips; forces of the tractions.
        let excess: Vec<f64> = (0..count)
            .map(|index| self.unit * self.force(index, &tractions) - image[3 * pairs + index])
            .collect();
        let found: Vec<f64> = self
            .inverse
            .iter()
            .map(|row| row.iter().zip(&excess).map(|(a, b)| a * b).sum())
            .collect();
        for (response, &found) in self.responses.iter().zip(&found) {
            update(&mut result, [response], |value, [response]| value - found * response);
        }
        result.extend(found.iter().map(|found| found / self.unit));
        result
    }
}

fn add(field: &mut VectorField, other: &VectorField, weight: f64) {
    let VectorField { t1, t2, n } = field;
    for (part, other) in [t1, t2, n].into_iter().zip(other.components()) {
        update(part, [other], |value, [other]| value + weight * other);
    }
}

/// The inverse of a small matrix; zeros where it has none.
fn inverted(mut matrix: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    let count = matrix.len();
    for (index, row) in matrix.iter_mut().enumerate() {
        row.extend((0..count).map(|column| f64::from(column == index)));
    }
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
