//! Projection and contraction for monotone operators.
//!
//! B. He and L.-Z. Liao, *J. Optim. Theory Appl.* 112 (2002) 111: a projection predicts, and a step along
//! the direction that it and a second application of the operator give contracts the distance to the
//! solution, whatever the operator, if it is monotone. The length of the projection's step adapts
//! itself. The map is monotone in the product weighted by the areas of the pairs. Forces that are given enter as unknown
//! slips, which adds a skew border to the operator.

use super::pairs::{Pairs, State};
use crate::numerics::vector::{map, sum, update};
use crate::solve::RELAXATION;

/// Ratio of the change of the slip to that of the tractions above which a step is shortened, and below
/// which the next is lengthened.
const RATIO: (f64, f64) = (0.9, 0.5);

/// The state of an iteration.
pub(super) struct Contraction {
    /// The last prediction, within the limits.
    pub state: State,
    /// The iterate, which may lie beyond them.
    iterate: State,
    /// Step of the projection (Pa/m).
    step: f64,
    /// Unit (m/Pa) in which a slip that is found counts against the tractions.
    unit: f64,
}

impl Contraction {
    pub fn new(pairs: &Pairs<'_>, state: State) -> Self {
        let unit = pairs.own / (pairs.len().max(1) as f64).sqrt();
        Self { iterate: state.clone(), state, step: 1.0 / pairs.own, unit }
    }

    /// One iteration: two applications, more where the step has to be shortened.
    pub fn advance(&mut self, pairs: &mut Pairs<'_>) {
        let force = |traction: &[f64], pairs: &Pairs<'_>| -> Vec<f64> {
            let area = pairs.step.measure.area;
            pairs.missing(traction).into_iter().map(|missing| missing / area).collect()
        };
        let missing = force(&self.iterate.traction, pairs);
        loop {
            let Self { iterate, step, unit, .. } = &*self;
            let mut trial = iterate.clone();
            let rigid_slip = map([&missing], |[missing]| step * unit * unit * missing);
            pairs.predict(&mut trial, *step, &rigid_slip);
            let left = force(&trial.traction, pairs);
            // Changes of the unknowns, in Pa, and of the operator's values times the step.
            let [mut moved, mut changed, mut product] = sum(
                [&iterate.traction, &trial.traction, &iterate.slip, &trial.slip, &pairs.weight],
                |[before, after, slip, trial_slip, weight]| {
                    let (e, d) = (before - after, step * (trial_slip - slip));
                    [weight * (e * e), weight * (d * d), weight * (e * d)]
                },
            );
            for index in 0..missing.len() {
                let e = (iterate.rigid_slip[index] - trial.rigid_slip[index]) / unit;
                let d = step * unit * (left[index] - missing[index]);
                moved += e * e;
                changed += d * d;
                product += e * d;
            }
            if moved == 0.0 {
                self.state = trial;
                return;
            }
            let ratio = (changed / moved).sqrt();
            if ratio > RATIO.0 {
                self.step *= 0.7 * (1.0 / ratio).min(1.0);
                continue;
            }
            let length = RELAXATION * (moved - product) / (moved - 2.0 * product + changed);
            let step = *step;
            let mut next = iterate.clone();
            let fields = [&trial.traction[..], &trial.slip, &iterate.slip];
            update(&mut next.traction, fields, |before, [after, trial_slip, slip]| {
                before - length * ((before - after) - step * (trial_slip - slip))
            });
            let fields = [&trial.rigid_slip[..], &left, &missing];
            update(&mut next.rigid_slip, fields, |before, [after, left, missing]| {
                before - length * ((before - after) - step * unit * unit * (left - missing))
            });
            pairs.find_slip(&mut next);
            (self.iterate, self.state) = (next, trial);
            if ratio < RATIO.1 {
                self.step *= 1.3;
            }
            return;
        }
    }
}
