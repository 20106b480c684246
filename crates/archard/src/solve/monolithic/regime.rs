//! What each pair does, and what of its tractions is unknown then.

use serde::{Deserialize, Serialize};

use super::Mapped;
use super::state::State;
use crate::compliance::StickSlip;
use crate::frame::VectorField;
use crate::numerics::vector::map;

/// What a pair does.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub(super) enum Touch {
    Open,
    Slips,
    Sticks,
}

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
    pub touch: Vec<Touch>,
    pub rub: StickSlip,
    /// Unit vectors along the augmented tractions q of slipping pairs.
    along: [Vec<f64>; 2],
    /// How their limits change with the pressure.
    slope: Vec<f64>,
    /// limit / |q| of theirs, one elsewhere; and c (1 - limit / |q|) (m/Pa), zero elsewhere.
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
            touch: vec![Touch::Open; pairs],
            rub: StickSlip { stick: zeros(), slip: zeros(), diagonal: zeros() },
            along: [zeros(), zeros()],
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
        let limit = step.friction.limit(pressure);
        let q = state.augmented_traction(pair);
        let length = q[0].hypot(q[1]);
        if length <= limit {
            self.touch[pair] = Touch::Sticks;
            self.rub.stick[pair] = 1.0;
            return;
        }
        self.touch[pair] = Touch::Slips;
        let share = limit / length;
        self.rub.slip[pair] = 1.0;
        self.rub.diagonal[pair] = state.own[1] * (1.0 - share) / share.max(LEAST);
        (self.share[pair], self.diagonal[pair]) = (share, state.own[1] * (1.0 - share));
        (self.along[0][pair], self.along[1][pair]) = (q[0] / length, q[1] / length);
        self.slope[pair] = step.friction.slope(pressure);
    }

    /// Sets the right-hand side for a state: the one that the rows were made from, or one near it.
    pub fn aim_at(&mut self, state: &State, step: &Mapped<'_>) {
        let pairs = self.touch.len();
        let VectorField { t1, t2, n } = &state.solution.traction;
        for pair in 0..pairs {
            let t = [t1[pair], t2[pair]];
            let s = [state.slip[0][pair], state.slip[1][pair]];
            let (fixed, slip) = match self.touch[pair] {
                Touch::Open => {
                    self.fixed.n[pair] = -n[pair];
                    (t.map(|t| -t), [0.0; 2])
                }
                Touch::Sticks => ([0.0; 2], s),
                Touch::Slips => {
                    let unit = [self.along[0][pair], self.along[1][pair]];
                    let pressure = state.augmented(pair).max(0.0);
                    // On the limit of the pressure as it is; what the pressure changes by changes the limit.
                    let change = self.slope[pair] * (-n[pair] - pressure);
                    let bound = step.friction.limit(pressure) + change;
                    let short = bound - (t[0] * unit[0] + t[1] * unit[1]);
                    let across = |[x, y]: [f64; 2]| y * unit[0] - x * unit[1];
                    let slip = self.share[pair] * across(s) - self.diagonal[pair] * across(t);
                    (unit.map(|unit| short * unit), [-slip * unit[1], slip * unit[0]])
                }
            };
            [self.fixed.t1[pair], self.fixed.t2[pair]] = fixed;
            [self.right[pair], self.right[pairs + pair]] = slip;
            if self.touch[pair] != Touch::Open {
                self.right[2 * pairs + pair] = state.gap[pair];
            }
        }
    }

    /// How a pair slips; `None` where it does not.
    pub fn sliding(&self, pair: usize) -> Option<Sliding> {
        (self.touch[pair] == Touch::Slips).then(|| Sliding {
            along: [self.along[0][pair], self.along[1][pair]],
            slope: self.slope[pair],
            diagonal: self.rub.diagonal[pair],
        })
    }

    /// Number of pairs in contact.
    pub fn touching(&self) -> usize {
        self.touch.iter().filter(|&&touch| touch != Touch::Open).count()
    }

    /// The part of two tangential values of a pair that is unknown: across q where it slips.
    fn part(&self, pair: usize, [x, y]: [f64; 2]) -> [f64; 2] {
        match self.touch[pair] {
            Touch::Open => [0.0; 2],
            Touch::Sticks => [x, y],
            Touch::Slips => {
                let across = [-self.along[1][pair], self.along[0][pair]];
                let length = across[0] * x + across[1] * y;
                across.map(|unit| length * unit)
            }
        }
    }

    /// The rows of the pairs under a displacement (m) and unknown tractions (Pa).
    pub fn rows(&self, displacement: &VectorField, unknown: &VectorField) -> Vec<f64> {
        let pairs = self.touch.len();
        let mut rows = vec![0.0; 3 * pairs];
        for pair in (0..pairs).filter(|&pair| self.touch[pair] != Touch::Open) {
            let (share, diagonal) = (self.share[pair], self.diagonal[pair]);
            let x = share * displacement.t1[pair] + diagonal * unknown.t1[pair];
            let y = share * displacement.t2[pair] + diagonal * unknown.t2[pair];
            [rows[pair], rows[pairs + pair]] = self.part(pair, [x, y]);
            rows[2 * pairs + pair] = displacement.n[pair];
        }
        rows
    }

    /// The unknown part of tractions.
    pub fn unknown(&self, vector: &[f64]) -> VectorField {
        let pairs = self.touch.len();
        let [t1, t2, n] = components(vector, pairs);
        let mut field = VectorField::zeros(pairs);
        for pair in (0..pairs).filter(|&pair| self.touch[pair] != Touch::Open) {
            [field.t1[pair], field.t2[pair]] = self.part(pair, [t1[pair], t2[pair]]);
            field.n[pair] = n[pair];
        }
        field
    }

    /// The tractions that an unknown part brings along: limits follow the pressure.
    pub fn tractions(&self, unknown: &VectorField) -> VectorField {
        let follow = |axis: usize, part: &[f64]| {
            map([part, &self.along[axis], &self.slope, &unknown.n], |[part, along, slope, n]| {
                part - slope * n * along
            })
        };
        VectorField { t1: follow(0, &unknown.t1), t2: follow(1, &unknown.t2), n: unknown.n.clone() }
    }
}

/// The least share that is divided by.
pub(super) const LEAST: f64 = 1e-12;

/// The components of a vector along t1, t2 and n.
pub(super) fn components(vector: &[f64], pairs: usize) -> [&[f64]; 3] {
    [0, 1, 2].map(|component| &vector[component * pairs..(component + 1) * pairs])
}
