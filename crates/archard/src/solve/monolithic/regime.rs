//! What each pair does, and what of its tractions is unknown then.

use serde::{Deserialize, Serialize};

use super::Mapped;
use super::state::State;
use crate::compliance::PairStatus;
use crate::frame::VectorField;
use crate::friction::Beyond;
use crate::numerics::vector::{map, update};
use crate::solve::semismooth::StickSlip;

/// How a slipping pair slips.
pub(super) struct Sliding {
    /// Unit vector along the augmented traction.
    pub along: [f64; 2],
    /// How the limit changes with the pressure.
    pub slope: f64,
    /// c (|q| - limit) / limit (m/Pa).
    pub diagonal: f64,
}

/// What the pairs do, and how their equations read. Vectors hold values along t1, t2 and n.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct Regime {
    pub pairs: StickSlip,
    /// How the limits of slipping pairs change with the pressure; zero elsewhere.
    slope: Vec<f64>,
    /// limit / |q| of slipping pairs, one elsewhere; and c (1 - limit / |q|) (m/Pa), zero elsewhere.
    pub share: Vec<f64>,
    diagonal: Vec<f64>,
    /// The part of the change that is known (Pa).
    pub fixed: VectorField,
    /// Right-hand sides of the rows (m).
    pub right: Vec<f64>,
}

impl Regime {
    pub fn of(state: &State, step: &Mapped<'_>) -> Self {
        let pairs = step.gap.len();
        let zeros = || vec![0.0; pairs];
        let mut regime = Self {
            pairs: StickSlip::open(pairs),
            slope: zeros(),
            share: vec![1.0; pairs],
            diagonal: zeros(),
            fixed: VectorField::zeros(pairs),
            right: vec![0.0; 3 * pairs],
        };
        (0..pairs).for_each(|pair| regime.classify(pair, state, step));
        regime.aim_at(state, step);
        regime
    }

    fn classify(&mut self, pair: usize, state: &State, step: &Mapped<'_>) {
        let pressure = state.augmented(pair);
        if pressure <= 0.0 {
            return;
        }
        let limit = step.friction.at(pair, pressure);
        let Some(beyond) = Beyond::of(state.augmented_traction(pair), limit) else {
            return self.pairs.stick(pair);
        };
        let Beyond { share, .. } = beyond;
        (self.share[pair], self.diagonal[pair]) = (share, state.own[1] * (1.0 - share));
        self.pairs.slip(pair, &beyond, self.diagonal[pair] / share.max(f64::EPSILON));
        self.slope[pair] = step.friction.slope(pair, pressure);
    }

    /// Sets the right-hand side for a state: the one that the rows were made from, or one near it.
    pub fn aim_at(&mut self, state: &State, step: &Mapped<'_>) {
        let pairs = self.pairs.len();
        let VectorField { t1, t2, n } = &state.solution.traction;
        for pair in 0..pairs {
            let t = [t1[pair], t2[pair]];
            let s = [state.slip[0][pair], state.slip[1][pair]];
            let (fixed, slip) = match self.pairs.status[pair] {
                PairStatus::Open => {
                    self.fixed.n[pair] = -n[pair];
                    (t.map(|t| -t), [0.0; 2])
                }
                PairStatus::Stick => ([0.0; 2], s),
                PairStatus::Slip { .. } => {
                    let unit = self.pairs.along(pair);
                    let pressure = state.augmented(pair).max(0.0);
                    // On the limit of the pressure as it is; what the pressure changes by changes the limit.
                    let change = self.slope[pair] * (-n[pair] - pressure);
                    let bound = step.friction.at(pair, pressure) + change;
                    let short = bound - (t[0] * unit[0] + t[1] * unit[1]);
                    let across = |[x, y]: [f64; 2]| y * unit[0] - x * unit[1];
                    let slip = self.share[pair] * across(s) - self.diagonal[pair] * across(t);
                    (unit.map(|unit| short * unit), [-slip * unit[1], slip * unit[0]])
                }
            };
            [self.fixed.t1[pair], self.fixed.t2[pair]] = fixed;
            [self.right[pair], self.right[pairs + pair]] = slip;
            if !self.is_open(pair) {
                self.right[2 * pairs + pair] = state.gap[pair];
            }
        }
    }

    /// How a pair slips; `None` where it does not.
    pub fn sliding(&self, pair: usize) -> Option<Sliding> {
        let PairStatus::Slip { diagonal } = self.pairs.status[pair] else { return None };
        Some(Sliding { along: self.pairs.along(pair), slope: self.slope[pair], diagonal })
    }

    /// Whether a pair is not in contact.
    pub fn is_open(&self, pair: usize) -> bool {
        self.pairs.status[pair] == PairStatus::Open
    }

    /// Number of pairs in contact.
    pub fn touching(&self) -> usize {
        (0..self.pairs.len()).filter(|&pair| !self.is_open(pair)).count()
    }

    /// Keeps the part of a vector along what is unknown.
    pub fn keep_unknown(&self, vector: &mut [f64]) {
        self.pairs.keep_unknown(vector);
        let pairs = self.pairs.len();
        (0..pairs)
            .filter(|&pair| self.is_open(pair))
            .for_each(|pair| vector[2 * pairs + pair] = 0.0);
    }

    /// The rows of the pairs under a displacement (m) and unknown tractions (Pa).
    pub fn rows(&self, displacement: &VectorField, unknown: &VectorField) -> Vec<f64> {
        let mut rows = displacement.components().concat();
        for (row, unknown) in rows.chunks_mut(self.pairs.len()).zip([&unknown.t1, &unknown.t2]) {
            let fields = [unknown, &self.share, &self.diagonal];
            update(row, fields.map(Vec::as_slice), |displacement, [unknown, share, diagonal]| {
                share * displacement + diagonal * unknown
            });
        }
        self.keep_unknown(&mut rows);
        rows
    }

    /// The unknown part of tractions.
    pub fn unknown(&self, vector: &[f64]) -> VectorField {
        let mut t1 = vector.to_vec();
        self.keep_unknown(&mut t1);
        let n = t1.split_off(2 * self.pairs.len());
        let t2 = t1.split_off(self.pairs.len());
        VectorField { t1, t2, n }
    }

    /// The tractions that an unknown part brings along: limits follow the pressure.
    pub fn tractions(&self, unknown: &VectorField) -> VectorField {
        let follow = |part: &[f64], along: &[f64]| {
            map([part, along, &self.slope, &unknown.n], |[part, along, slope, n]| {
                part - slope * n * along
            })
        };
        let [one, two] = &self.pairs.along;
        VectorField {
            t1: follow(&unknown.t1, one),
            t2: follow(&unknown.t2, two),
            n: unknown.n.clone(),
        }
    }
}

/// The components of a vector along t1, t2 and n.
pub(super) fn components(vector: &[f64], pairs: usize) -> [&[f64]; 3] {
    [0, 1, 2].map(|component| &vector[component * pairs..(component + 1) * pairs])
}
