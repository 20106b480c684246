//! The projection of friction linearised about an iterate.
//!
//! The augmented traction q = t + r s says which pairs stick (|q| within the limit) and which slip. With that fixed, a
//! step makes the slip of the sticking pairs zero and puts the slipping ones on their limit, where what remains unknown
//! is the direction: across q, the change dt of the traction obeys
//!
//! ```text
//! B dt + (|q| - limit) / (r limit) dt = s |q| / limit
//! ```
//!
//! The preconditioner is [`SlipMap::precondition`](crate::compliance::SlipMap::precondition).

use super::pairs::{Pairs, State};
use crate::compliance::PairStatus;
use crate::friction::Beyond;
use crate::numerics::gmres::{self, Solution, System};
use crate::numerics::vector::{map, update};
use crate::solve::semismooth::{Schur, StickSlip, Tolerance};

/// How well to solve, by the share of the sticking pairs that changes.
const TOLERANCE: Tolerance =
    Tolerance { loose: 0.5, tight: 0.05, settled: 0.03, last: 0.0, enough: 0.3 };
/// Krylov iterations of one step.
const KRYLOV: usize = 120;

/// The system. Vectors hold the changes of the tractions (Pa), then those of the slips that are found, in the unit that
/// makes them count like tractions.
pub(super) struct Linear<'p, 'a> {
    pairs: &'p mut Pairs<'a>,
    /// What the pairs in contact do.
    pub stick_slip: StickSlip,
    /// The diagonal beside B of slipping pairs (m/Pa), zeros elsewhere.
    diagonal: Vec<f64>,
    /// Change that puts slipping pairs on their limit (Pa).
    fixed: Vec<f64>,
    /// Slip that what is unknown has to take away, and forces that are missing, in its unit (m).
    right: Vec<f64>,
    /// Slip (m) of a rigid slip of one unit.
    unit: f64,
    schur: Schur,
    /// Slip (m) that the fixed change takes away, and that each change tried does.
    fixed_slip: Vec<f64>,
    tried: Vec<Vec<f64>>,
}

impl<'p, 'a> Linear<'p, 'a> {
    pub fn about(state: &State, pairs: &'p mut Pairs<'a>) -> Self {
        let count = pairs.len();
        let zeros = || vec![0.0; 2 * count];
        let mut linear = Self {
            unit: pairs.own / (count.max(1) as f64).sqrt(),
            pairs,
            stick_slip: StickSlip::open(count),
            diagonal: vec![0.0; count],
            fixed: zeros(),
            right: zeros(),
            schur: Schur::default(),
            fixed_slip: zeros(),
            tried: vec![],
        };
        (0..count).for_each(|pair| linear.classify(pair, state));
        linear.pairs.put_status(&linear.stick_slip.status);
        if linear.fixed.iter().any(|&change| change != 0.0) {
            linear.fixed_slip = linear.pairs.apply(&linear.fixed);
            let mut taken = linear.fixed_slip.clone();
            linear.stick_slip.keep_unknown(&mut taken);
            update(&mut linear.right, [&taken], |right, [taken]| right - taken);
        }
        linear.add_border(state);
        linear
    }

    fn classify(&mut self, pair: usize, state: &State) {
        let (count, own) = (self.pairs.len(), self.pairs.own);
        let at = |vector: &[f64]| [vector[pair], vector[count + pair]];
        let put = |vector: &mut [f64], value: [f64; 2]| {
            [vector[pair], vector[count + pair]] = value;
        };
        let (t, s, limit) = (at(&state.traction), at(&state.slip), self.pairs.limit[pair]);
        let Some(beyond) = Beyond::of([0, 1].map(|axis| t[axis] + s[axis] / own), limit) else {
            self.stick_slip.stick(pair);
            return put(&mut self.right, s);
        };
        let Beyond { normal, length, .. } = beyond;
        self.diagonal[pair] = own * (length - limit) / limit;
        self.stick_slip.slip(pair, &beyond, self.diagonal[pair]);
        let short = limit - (t[0] * normal[0] + t[1] * normal[1]);
        let slip = (s[1] * normal[0] - s[0] * normal[1]) * length / limit;
        put(&mut self.fixed, normal.map(|normal| short * normal));
        put(&mut self.right, [-slip * normal[1], slip * normal[0]]);
    }

    /// Prepares what the forces given need.
    fn add_border(&mut self, state: &State) {
        let after = map([&state.traction, &self.fixed], |[traction, change]| traction + change);
        let per_area = self.unit / self.pairs.step.measure.area;
        self.right.extend(self.pairs.missing(&after).iter().map(|missing| per_area * missing));
        let prescribed = self.pairs.step.prescribed.len();
        let response = |index: usize| {
            let mut column = vec![0.0; 2 * self.pairs.len()];
            let unit: Vec<f64> = (0..prescribed).map(|i| -f64::from(i == index)).collect();
            self.pairs.add_rigid_slip(&mut column, &unit);
            self.stick_slip.keep_unknown(&mut column);
            self.precondition_tractions(&column)
        };
        let responses = (0..prescribed).map(response).collect();
        self.schur = Schur::of(responses, |response| self.forces(response));
    }

    /// How well to solve where the pairs had a status before: roughly where they had none.
    pub fn tolerance(&self, last: &[PairStatus], residual: f64, aim: f64) -> f64 {
        let sticks = |status: &&PairStatus| **status == PairStatus::Stick;
        let sticking = self.stick_slip.status.iter().filter(sticks).count();
        let changed = if last.is_empty() { sticking } else { self.stick_slip.changed(last) };
        TOLERANCE.of(changed, sticking, residual, aim)
    }

    /// The change of tractions, slip and rigid slip.
    pub fn solve(&mut self, tolerance: f64) -> State {
        let right = std::mem::take(&mut self.right);
        let Solution { vector: mut traction, weights } =
            gmres::solve(self, &right, tolerance, KRYLOV);
        let rigid_slip = traction.split_off(2 * self.pairs.len());
        let rigid_slip: Vec<f64> = rigid_slip.iter().map(|slip| self.unit * slip).collect();
        update(&mut traction, [&self.fixed], |change, [fixed]| change + fixed);
        let mut slip: Vec<f64> = self.fixed_slip.iter().map(|taken| -taken).collect();
        for (taken, &weight) in self.tried.iter().zip(&weights) {
            update(&mut slip, [taken], |slip, [taken]| slip - weight * taken);
        }
        self.pairs.add_rigid_slip(&mut slip, &rigid_slip);
        State { traction, rigid_slip, slip }
    }

    /// What tractions (Pa) make of each force given, in the unit of the rows.
    fn forces(&self, traction: &[f64]) -> Vec<f64> {
        let per_area = self.unit / self.pairs.step.measure.area;
        let prescribed = self.pairs.step.prescribed.iter();
        prescribed.map(|given| per_area * self.pairs.force(traction, given.direction)).collect()
    }

    /// Nearly the tractions that take a slip away, of what is unknown.
    fn precondition_tractions(&mut self, slip: &[f64]) -> Vec<f64> {
        let mut traction = self.pairs.precondition(slip);
        self.stick_slip.keep_unknown(&mut traction);
        traction
    }
}

impl System for Linear<'_, '_> {
    fn apply(&mut self, vector: &[f64]) -> Vec<f64> {
        let (traction, slips) = vector.split_at(2 * self.pairs.len());
        let mut image = self.pairs.apply(traction);
        self.tried.push(image.clone());
        let taken: Vec<f64> = slips.iter().map(|slip| -self.unit * slip).collect();
        self.pairs.add_rigid_slip(&mut image, &taken);
        self.stick_slip.keep_unknown(&mut image);
        let count = self.pairs.len();
        for (image, traction) in image.chunks_mut(count).zip(traction.chunks(count)) {
            update(image, [traction, &self.diagonal], |image, [traction, diagonal]| {
                image + diagonal * traction
            });
        }
        image.extend(self.forces(traction));
        image
    }

    fn precondition(&mut self, image: &[f64]) -> Vec<f64> {
        let (slip, forces) = image.split_at(2 * self.pairs.len());
        let mut traction = self.precondition_tractions(slip);
        let made = self.forces(&traction);
        self.schur.complete(&mut traction, &made, forces, self.unit);
        traction
    }
}
