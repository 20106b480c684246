//! The projection of friction linearised about an iterate.
//!
//! The augmented traction q = t + r s says which pairs stick (|q| within the limit) and which slip. With that fixed, a
//! step makes the slip of the sticking pairs zero and puts the slipping ones on their limit, where what remains unknown
//! is the direction: across q, the change dt of the traction obeys
//!
//! ```text
//! limit / |q| B dt + (1 - limit / |q|) / r dt = s
//! ```
//!
//! so that what a change leaves of the rows is what it leaves, to first order, of the distance of the tractions from
//! those that the slip projects them on.
//!
//! Forces that are given are met exactly: the change begins with what nearly answers to those that are missing, and the
//! iteration goes on among changes that make none.
//!
//! The preconditioner is [`SlipMap::precondition`](crate::compliance::SlipMap::precondition).

use super::pairs::{Pairs, State};
use crate::friction::Beyond;
use crate::numerics::gmres::{self, Solution, System};
use crate::numerics::vector::{map, update};
use crate::solve::semismooth::{Schur, StickSlip};

/// The system. Vectors hold the changes of the tractions (Pa), then those of the slips that are found, in the unit that
/// makes them count like tractions.
pub(super) struct Linear<'p, 'a> {
    pairs: &'p mut Pairs<'a>,
    /// What the pairs in contact do.
    pub stick_slip: StickSlip,
    /// limit / |q| of slipping pairs, one elsewhere.
    share: Vec<f64>,
    /// r (1 - limit / |q|) of slipping pairs (m/Pa), zero elsewhere.
    diagonal: Vec<f64>,
    /// The change that puts slipping pairs on their limit and meets the forces given.
    known: State,
    /// Slip that what is unknown has to take away, and forces that are missing, in its unit (m).
    right: Vec<f64>,
    /// Slip (m) of a rigid slip of one unit.
    unit: f64,
    schur: Schur,
    /// Slip (m) that each change tried takes away.
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
            share: vec![1.0; count],
            diagonal: vec![0.0; count],
            known: State { traction: zeros(), rigid_slip: vec![], slip: zeros() },
            right: zeros(),
            schur: Schur::default(),
            tried: vec![],
        };
        (0..count).for_each(|pair| linear.classify(pair, state));
        linear.pairs.put_status(&linear.stick_slip.status);
        linear.add_border();
        linear.begin(state);
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
        let Beyond { normal, share, .. } = beyond;
        (self.share[pair], self.diagonal[pair]) = (share, own * (1.0 - share));
        self.stick_slip.slip(pair, &beyond, self.diagonal[pair] / share.max(f64::EPSILON));
        let short = limit - (t[0] * normal[0] + t[1] * normal[1]);
        let slip = s[1] * normal[0] - s[0] * normal[1];
        put(&mut self.known.traction, normal.map(|normal| short * normal));
        put(&mut self.right, [-slip * normal[1], slip * normal[0]]);
    }

    /// Prepares what the forces given need.
    fn add_border(&mut self) {
        let prescribed = self.pairs.step.prescribed.len();
        let response = |index: usize| {
            let mut column = vec![0.0; 2 * self.pairs.len()];
            let unit: Vec<f64> = (0..prescribed).map(|i| -f64::from(i == index)).collect();
            self.pairs.add_rigid_slip(&mut column, &unit);
            self.to_rows(&mut column);
            self.precondition_tractions(&column)
        };
        let responses = (0..prescribed).map(response).collect();
        self.schur = Schur::of(responses, |response| self.forces(response));
    }

    /// Meets the forces given, and takes from the rows what the known change leaves.
    fn begin(&mut self, state: &State) {
        let count = self.pairs.len();
        let missing = |traction: &[f64], linear: &Self| -> Vec<f64> {
            let after = map([&state.traction, traction], |[traction, change]| traction + change);
            let per_area = linear.unit / linear.pairs.step.measure.area;
            linear.pairs.missing(&after).iter().map(|missing| per_area * missing).collect()
        };
        let mut unknown = vec![0.0; 2 * count];
        let wanted = missing(&self.known.traction, self);
        self.schur.complete(&mut unknown, &vec![0.0; wanted.len()], &wanted, self.unit);
        let slips = unknown.split_off(2 * count).into_iter();
        self.known.rigid_slip = slips.map(|slip| self.unit * slip).collect();
        update(&mut self.known.traction, [&unknown], |fixed, [change]| fixed + change);
        if self.known.traction.iter().any(|&change| change != 0.0) {
            let taken = self.pairs.apply(&self.known.traction);
            update(&mut self.known.slip, [&taken], |_, [taken]| -taken);
        }
        self.pairs.add_rigid_slip(&mut self.known.slip, &self.known.rigid_slip);
        let mut left = self.known.slip.clone();
        self.to_rows(&mut left);
        update(&mut self.right, [&left], |right, [left]| right + left);
        let mut right = std::mem::take(&mut self.right);
        unknown.iter_mut().for_each(|change| *change = -*change);
        self.add_diagonal(&mut right, &unknown);
        self.right = right;
        self.right.extend(missing(&self.known.traction, self));
    }

    /// The change of tractions, slip and rigid slip that would leave this residual, were the pairs to do what they do,
    /// in so many iterations at most.
    pub fn solve(&mut self, residual: f64, most: usize) -> State {
        let right = std::mem::take(&mut self.right);
        let aim = self.pairs.slip_of(residual);
        let Solution { vector: mut unknown, weights } = gmres::solve(self, &right, aim, most);
        let slips = unknown.split_off(2 * self.pairs.len());
        let mut change = State { traction: unknown, ..self.known.clone() };
        update(&mut change.traction, [&self.known.traction], |unknown, [known]| unknown + known);
        let rigid_slip: Vec<f64> = slips.iter().map(|slip| self.unit * slip).collect();
        update(&mut change.rigid_slip, [&rigid_slip], |known, [slip]| known + slip);
        for (taken, &weight) in self.tried.iter().zip(&weights) {
            update(&mut change.slip, [taken], |slip, [taken]| slip - weight * taken);
        }
        self.pairs.add_rigid_slip(&mut change.slip, &rigid_slip);
        change
    }

    /// What a slip (m) of the pairs is in their rows.
    fn to_rows(&self, slip: &mut [f64]) {
        self.stick_slip.keep_unknown(slip);
        for slip in slip.chunks_mut(self.pairs.len().max(1)) {
            update(slip, [&self.share], |slip, [share]| share * slip);
        }
    }

    /// What tractions (Pa) of slipping pairs add to their rows.
    fn add_diagonal(&self, rows: &mut [f64], tractions: &[f64]) {
        let count = self.pairs.len().max(1);
        for (rows, traction) in rows.chunks_mut(count).zip(tractions.chunks(count)) {
            update(rows, [traction, &self.diagonal], |row, [traction, diagonal]| {
                row + diagonal * traction
            });
        }
    }

    /// What tractions (Pa) make of each force given, in the unit of the rows.
    fn forces(&self, traction: &[f64]) -> Vec<f64> {
        let per_area = self.unit / self.pairs.step.measure.area;
        let prescribed = self.pairs.step.prescribed.iter();
        prescribed.map(|given| per_area * self.pairs.force(traction, given.direction)).collect()
    }

    /// Nearly the tractions that answer to the rows of the pairs, of what is unknown.
    fn precondition_tractions(&mut self, rows: &[f64]) -> Vec<f64> {
        let mut slip = rows.to_vec();
        for slip in slip.chunks_mut(self.pairs.len().max(1)) {
            update(slip, [&self.share], |row, [share]| row / share.max(f64::EPSILON));
        }
        let mut traction = self.pairs.precondition(&slip);
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
        self.to_rows(&mut image);
        self.add_diagonal(&mut image, traction);
        image.extend(self.forces(traction));
        image
    }

    fn precondition(&mut self, image: &[f64]) -> Vec<f64> {
        let (rows, forces) = image.split_at(2 * self.pairs.len());
        let mut traction = self.precondition_tractions(rows);
        let made = self.forces(&traction);
        self.schur.complete(&mut traction, &made, forces, self.unit);
        traction
    }
}
