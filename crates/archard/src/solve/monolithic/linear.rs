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
//! The preconditioner takes the directions apart: that of the normal problem, and
//! [`SlipMap::precondition`](crate::compliance::SlipMap::precondition). Where there are [`Factors`] from a solution nearby, they take
//! the place of both.

use super::border::Border;
use super::factors::Factors;
use super::regime::{Regime, components};
use super::state::State;
use super::{Mapped, Solution};
use crate::compliance::{Preconditioner, SlipMap};
use crate::frame::VectorField;
use crate::numerics::gmres::{self, System};
use crate::numerics::vector::{map, update};
use crate::solve::residual::norm;

/// The system. Vectors hold the unknown tractions (Pa) along t1, t2 and n, then the approach and the slips
/// that are found, in the unit of the border.
pub(super) struct Linear<'s> {
    step: &'s Mapped<'s>,
    inverse: Inverse<'s>,
    pub regime: Regime,
    border: Border,
    fixed_displacement: Option<VectorField>,
    tried: Vec<VectorField>,
    pub applications: usize,
}

/// Nearly the inverse of the rows of the pairs.
struct Inverse<'s> {
    normal: Box<dyn Preconditioner + 's>,
    tangential: Box<dyn SlipMap + 's>,
    factors: Option<&'s Factors>,
}

impl<'s> Linear<'s> {
    pub fn about(
        state: &State,
        step: &'s Mapped<'s>,
        regime: Regime,
        factors: Option<&'s Factors>,
    ) -> Self {
        let inverse = Inverse {
            normal: step.compliance.normal_preconditioner(0.0),
            tangential: step.compliance.shifting(step.frame),
            factors,
        };
        let border = Border::of(state, step, &regime, |rows| inverse.apply(rows, &regime));
        let fixed_displacement = None;
        let (tried, applications) = (vec![], 0);
        let mut linear =
            Self { step, inverse, regime, border, fixed_displacement, tried, applications };
        linear.apply_fixed();
        linear
    }

    fn apply_fixed(&mut self) {
        let fixed = &self.regime.fixed;
        if fixed.components().iter().all(|part| part.iter().all(|&value| value == 0.0)) {
            return;
        }
        self.applications += 1;
        let displacement = self.step.compliance.apply(fixed);
        let taken = self.regime.rows(&displacement, &VectorField::zeros(fixed.n.len()));
        update(&mut self.regime.right, [&taken], |right, [taken]| right - taken);
        self.fixed_displacement = Some(displacement);
    }

    /// The change of tractions, displacement, approach and rigid slip, to a relative residual in so many iterations at most.
    pub fn solve(&mut self, tolerance: f64, most: usize) -> Solution {
        let pairs = self.regime.pairs.len();
        let right = [&self.regime.right[..], &self.border.right].concat();
        let aim = tolerance * norm(&right);
        let gmres::Solution { vector, weights } = gmres::solve(self, &right, aim, most);
        let mut traction = self.regime.tractions(&self.regime.unknown(&vector[..3 * pairs]));
        traction.add(&self.regime.fixed, 1.0);
        let known = self.fixed_displacement.take();
        let mut displacement = known.unwrap_or_else(|| VectorField::zeros(pairs));
        for (tried, &weight) in self.tried.iter().zip(&weights) {
            displacement.add(tried, weight);
        }
        let mut border = vector[3 * pairs..].iter().map(|value| self.border.unit * value);
        let approach = if self.border.loaded { border.next().unwrap_or_default() } else { 0.0 };
        Solution { traction, displacement, approach, rigid_slip: border.collect(), factors: None }
    }
}

impl Inverse<'_> {
    /// Nearly the unknown tractions whose rows are given, the border left out.
    fn apply(&self, rows: &[f64], regime: &Regime) -> Vec<f64> {
        let pairs = regime.pairs.len();
        let [one, two, n] = components(rows, pairs);
        // Rows of slipping pairs were weighed by their share.
        let unweigh = |part: &[f64]| {
            map([part, &regime.share], |[part, share]| part / share.max(f64::EPSILON))
        };
        let (one, two) = (unweigh(one), unweigh(two));
        let mut result = vec![0.0; 3 * pairs];
        let (first, rest) = result.split_at_mut(pairs);
        let (second, third) = rest.split_at_mut(pairs);
        self.tangential.precondition([&one, &two], &regime.pairs.status, [first, second]);
        self.normal.apply(n, third);
        if let Some(factors) = self.factors {
            factors.solve([&one, &two, n], [first, second, third]);
        }
        regime.keep_unknown(&mut result);
        result
    }
}

impl System for Linear<'_> {
    fn apply(&mut self, vector: &[f64]) -> Vec<f64> {
        let (unknown, slips) = vector.split_at(3 * self.regime.pairs.len());
        let unknown = self.regime.unknown(unknown);
        let tractions = self.regime.tractions(&unknown);
        self.applications += 1;
        let displacement = self.step.compliance.apply(&tractions);
        let mut rows = self.regime.rows(&displacement, &unknown);
        self.tried.push(displacement);
        for (column, value) in self.border.columns.iter().zip(slips) {
            let slip = self.border.unit * value;
            update(&mut rows, [column], |row, [column]| row + slip * column);
        }
        rows.extend(self.border.forces(&tractions));
        rows
    }

    fn precondition(&mut self, image: &[f64]) -> Vec<f64> {
        let (rows, forces) = image.split_at(3 * self.regime.pairs.len());
        let mut result = self.inverse.apply(rows, &self.regime);
        let made = self.border.forces_of(&result, &self.regime);
        self.border.schur.complete(&mut result, &made, forces, self.border.unit);
        result
    }
}
