//! A step of both histories of [`Adaptive`](super::adaptive::Adaptive), and the error that it leaves.
//!
//! The error that remains after extrapolation is estimated from D, the error removed from the coarse
//! history, and c, the relative change of the pressure or of the rate of wear over half of the step. A
//! single step leaves an error of about c D. In steps that grow with the distance most of it is
//! compensated by what both histories were off before. Steps are chosen by 1.3 c D, more if much of D is new.
//! 1.8 times that is stated, and never falls during a run.
//!
//! That is the truncation error of a smooth evolution. Besides, the pressures ripple as the edge of the
//! contact reaches one ring of elements after the other. Steps that pass more than a ring meet the ripple
//! at their ends, each history at its own. The error of that is estimated from the difference between the
//! rates of wear with which both end, times the length of the step.
//!
//! Where coefficients rise or fall with the distance slid, pairs that join the contact wear little at first, or much. When they
//! joined stays in the depths, and the two histories do not agree on it: of what extrapolation removes a share counts
//! as an error that remains.

use std::borrow::Cow;

use super::memory::History;
use crate::problem::{ContactProblem, ContactState};

/// What the error removed counts as steps are chosen, and how much more what a step adds to it.
const REMOVED: f64 = 1.3;
const ADDED: f64 = 2.0;
/// Factor on it in what is stated, where all of the contact slides. With 1.6, the true error of a punch of r^6 was once
/// more than that (`tests/verification/step_by_error.rs`).
pub(super) const STATED: f64 = 1.8;
/// What the wear of a step at the rates that both histories end with differs by counts, and the same where wear is not
/// proportional to the pressure: such laws make ripples larger, and what those leave does not fade. Less was below the true
/// error of a punch of r^6, and of running in and a threshold (`tests/verification/step_by_error.rs`).
const RIPPLE: f64 = 0.36;
const RIPPLE_OF_LAWS: f64 = 5.0;
/// Shares of the error removed that count as one that remains, over the share by which what joins the contact wears less than
/// the deepest place, and by which that wears less than what joins.
const JOINING: [f64; 2] = [2.0, 0.4];
/// Ripples may err by as many tolerances.
const OF_RIPPLES: f64 = 3.0;
/// Lag of the pressure at the deepest point that is allowed, relative to the root of the tolerance.
/// Both the lag and the root of the wear's error grow with the step: 4.4 % go with a tolerance of 1e-3.
const LAG: f64 = 1.4;

/// A step of both histories, before it is accepted.
pub(super) struct Trial {
    pub coarse: History,
    pub fine: History,
    /// Deepest total wear (m), its errors by truncation and by ripples (m).
    pub depth: f64,
    pub truncation: f64,
    pub ripple: f64,
    /// What of the latter this step has made (m): a shorter one would make less.
    pub added: f64,
    /// Relative lag of the pressure where the wear is deepest.
    pub lag: f64,
}

/// Depths worn off body 1 and body 2 (m), one value a pair.
pub(super) type Depths<'a> = [Cow<'a, [f64]>; 2];

/// Those of a state.
pub(super) fn depths(state: &ContactState) -> Depths<'_> {
    [state.worn(0), state.worn(1)]
}

/// What a step began with and came through, as far as its error asks for it.
pub(super) struct Way<'a> {
    pub problem: &'a ContactProblem,
    /// The coarse and the fine history before the step.
    pub before: [&'a ContactState; 2],
    /// Pressures (Pa) and depths (m) of the fine history after its first half.
    pub pressure: &'a [f64],
    pub worn: &'a Depths<'a>,
}

impl Way<'_> {
    /// By what share the pairs that join the contact of the fine history wear less than the deepest one does under the same
    /// pressure, and by what share the deepest one wears less than they do; 0 where no law depends on what was before.
    fn less_wear(&self, end: &ContactState, deepest: usize) -> [f64; 2] {
        if !self.problem.remembers() {
            return [0.0; 2];
        }
        let started = &self.before[1].pressure;
        let worn = depths(end);
        let of = |pair: usize| [both(&worn, pair) - both(self.worn, pair), end.pressure[pair]];
        let joining = (0..started.len()).filter(|&pair| started[pair] == 0.0).map(of);
        let [worn, pressure] = joining.fold([0.0; 2], |sum, one| [0, 1].map(|i| sum[i] + one[i]));
        let [deepest_worn, deepest_pressure] = of(deepest);
        let (rate, deepest_rate) = (worn * deepest_pressure, deepest_worn * pressure);
        let less = |one: f64, other: f64| if one < other { 1.0 - one / other } else { 0.0 };
        [less(rate, deepest_rate), less(deepest_rate, rate)]
    }
}

impl Trial {
    /// Extrapolates both histories and estimates the error.
    pub fn of(coarse: History, fine: History, way: &Way<'_>) -> Self {
        let [coarse_worn, fine_worn] = [depths(&coarse.state), depths(&fine.state)];
        let [coarse_began, fine_began] = way.before.map(depths);
        let worn = [0, 1].map(|body| extrapolate(&coarse_worn[body], &fine_worn[body]).into());
        let fine_pressure = &fine.state.pressure;
        let (mut deepest, mut depth, mut square) = (0, 0.0, 0.0);
        for pair in 0..fine_pressure.len() {
            let value = both(&worn, pair);
            // Planes wear evenly: the lag is that of their most pressed pair.
            if value > depth || value == depth && fine_pressure[pair] > fine_pressure[deepest] {
                (deepest, depth) = (pair, value);
            }
            square += value * value;
        }
        let [coarse_before, fine_before] = way.before;
        let last = fine_pressure[deepest];
        let [before, middle] =
            [&fine_before.pressure, way.pressure].map(|pressure| pressure[deepest]);
        // Where a law is not straight in the pressure, or changes by itself, the wear of both halves gives more.
        let worn_in = |from: &Depths<'_>, to: &Depths<'_>| both(to, deepest) - both(from, deepest);
        let halves = [worn_in(&fine_began, way.worn), worn_in(way.worn, &fine_worn)];
        let of_wear = relative_change(halves[0], halves[1]);
        let was_is = [removed(coarse_before, fine_before), removed(&coarse.state, &fine.state)];
        let there = (2.0 * (both(&fine_worn, deepest) - both(&coarse_worn, deepest))).abs();
        let [was, everywhere] = was_is
            .map(|removed| if square > 0.0 { depth * removed / f64::sqrt(square) } else { 0.0 });
        // Elsewhere the edge that counts moves by whole elements: that of what sticks, or of a surface that swings.
        let (resolved, [ripple, added]) = if !slides(way.problem) {
            let of_wear = if way.problem.ages() { (2.0 * of_wear).min(1.0) } else { 0.0 };
            (relative_change(before, last).max(of_wear), [0.0; 2])
        } else {
            let change =
                relative_change(before, middle).max(relative_change(middle, last)).max(of_wear);
            let share = if way.problem.is_proportional(last) { RIPPLE } else { RIPPLE_OF_LAWS };
            // Where coefficients change with the distance, the first half wears otherwise under the same pressure.
            let ages = way.problem.remembers() && middle > 0.0;
            let first = if ages { halves[0] * last / middle } else { halves[1] };
            let differ = worn_in(&coarse_began, &coarse_worn) - (first + halves[1]);
            let less = way.less_wear(&fine.state, deepest);
            let joining = less.iter().zip(JOINING).map(|(less, share)| share * less);
            let joining = joining.sum::<f64>().min(1.0);
            let joined = [everywhere, (everywhere - was).max(0.0)];
            (
                remaining(change, was_is),
                joined.map(|error| (share * differ.abs()).max(joining * error)),
            )
        };
        let truncation = resolved * everywhere.max(there);
        let lag = relative_change(coarse.state.pressure[deepest], last);
        Self { coarse, fine, depth, truncation, ripple, added, lag }
    }

    /// Error relative to what the tolerance allows; of second order in the step.
    pub fn excess(&self, tolerance: f64) -> f64 {
        self.excess_of_depth(tolerance).max(self.lag * self.lag / (LAG * LAG * tolerance))
    }

    /// The same of the depth alone.
    pub fn excess_of_depth(&self, tolerance: f64) -> f64 {
        if self.depth > 0.0 { self.truncation / (tolerance * self.depth) } else { 0.0 }
    }

    /// The same of the ripples that the step makes. They may be larger.
    pub fn excess_of_ripple(&self, tolerance: f64) -> f64 {
        if self.depth > 0.0 { self.added / (OF_RIPPLES * tolerance * self.depth) } else { 0.0 }
    }
}

/// Whether all of the contact slides, and its edge moves on smoothly.
pub(super) fn slides(problem: &ContactProblem) -> bool {
    problem.motion.lever_arm().is_some() && !problem.motion.has_positions()
}

/// What extrapolation removes from the coarse history's wear (m): the root of the sum of its squares over all pairs.
fn removed(coarse: &ContactState, fine: &ContactState) -> f64 {
    let (coarse, fine) = (depths(coarse), depths(fine));
    let [one, two] = [0, 1].map(|body| coarse[body].iter().zip(&*fine[body]));
    let square = |((c1, f1), (c2, f2)): ((&f64, &f64), (&f64, &f64))| {
        (((2.0 * f1 - c1) + (2.0 * f2 - c2)) - (c1 + c2)).powi(2)
    };
    f64::sqrt(one.zip(two).map(square).sum())
}

/// The share of the error removed that remains, by the largest relative change over half of a step, and by what was removed
/// before it and after.
fn remaining(change: f64, [was, is]: [f64; 2]) -> f64 {
    let new = if is > 0.0 { (1.0 - was / is).max(0.0) } else { 0.0 };
    (REMOVED * (1.0 + ADDED * new * new) * change).min(1.0)
}

/// Depth worn off both bodies at a pair (m).
fn both(worn: &Depths<'_>, pair: usize) -> f64 {
    worn[0][pair] + worn[1][pair]
}

/// Change between two pressures, or depths worn, relative to the larger.
pub(super) fn relative_change(one: f64, other: f64) -> f64 {
    let larger = one.max(other);
    if larger > 0.0 { (other - one).abs() / larger } else { 0.0 }
}

/// Twice the fine less the coarse values.
pub(super) fn extrapolate(coarse: &[f64], fine: &[f64]) -> Vec<f64> {
    coarse.iter().zip(fine).map(|(coarse, fine)| 2.0 * fine - coarse).collect()
}

#[cfg(test)]
mod tests {
    use super::{STATED, extrapolate, relative_change, remaining};

    /// An implicit step of w' = w^-m (Newton).
    fn implicit(worn: f64, step: f64, m: f64) -> f64 {
        let mut end = worn + step;
        for _ in 0..60 {
            let gap = end - worn - step * end.powf(-m);
            end -= gap / (1.0 + step * m * end.powf(-m - 1.0));
        }
        end
    }

    /// Of w' = w^-m from w = 1, whose solution is known, the true error of the extrapolation lies below the estimate, in equal
    /// steps and in steps that grow with the distance; in those the estimate is at most 28 times as large.
    #[test]
    fn the_estimate_encloses_what_is_left_of_a_power() {
        for m in [0.5, 1.0, 2.0, 3.0] {
            for growth in [0.0, 0.05, 0.1, 0.2, 0.3] {
                let (mut coarse, mut fine, mut distance) = (1.0, 1.0, 0.0);
                let (mut removed, mut estimate) = (0.0, 0.0f64);
                for _ in 0..40 {
                    let step = 0.1 + growth * distance;
                    let before = fine;
                    coarse = implicit(coarse, step, m);
                    let middle = implicit(fine, 0.5 * step, m);
                    fine = implicit(middle, 0.5 * step, m);
                    distance += step;
                    let found = extrapolate(&[coarse], &[fine])[0];
                    let is: f64 = found - coarse;
                    let rates = [before, middle, fine].map(|worn: f64| worn.powf(-m));
                    let halves = [0, 1].map(|half| relative_change(rates[half], rates[half + 1]));
                    let change = halves[0].max(halves[1]);
                    // It never falls.
                    estimate =
                        estimate.max(STATED * is.abs() * remaining(change, [removed, is.abs()]));
                    removed = is.abs();
                    let exact = (1.0 + (1.0 + m) * distance).powf(1.0 / (1.0 + m));
                    let error = (found - exact).abs();
                    assert!(error <= estimate, "{m} {growth} {distance}: {error} of {estimate}");
                    assert!(
                        growth < 0.1 || estimate <= 28.0 * error,
                        "{m} {growth} {distance}: {error} of {estimate}"
                    );
                }
            }
        }
    }
}
