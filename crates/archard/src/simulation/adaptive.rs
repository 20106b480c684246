//! Wear in steps chosen by error.
//!
//! Two histories of implicit Euler steps run side by side from the unworn start, one in steps twice
//! as long as the other's; neither ever sees the other. Their difference is the first-order error of
//! the coarse one's halves, so that twice the fine less the coarse wear is of second order (L. F.
//! Richardson, *Phil. Trans. R. Soc. A* 210 (1911) 307). Because the extrapolation is never fed back,
//! the pressures stay those of implicit Euler, without a spike at the edge of the growing contact:
//! feeding it back, or any linear second-order step, leaves spikes there.
//!
//! The error that remains after extrapolation is estimated from D, the error removed from the coarse
//! history, and c, the relative change of the pressure or of the rate of wear over half of the step. A
//! single step leaves an error of about c D. In steps that grow with the distance most of it is
//! compensated by what both histories were off before. Steps are chosen by 1.3 c D, more if much of D is new.
//! 1.8 times that is stated, and never falls during a run.
//!
//! What steps err by early fades, since deeper places wear less from then on. Where all of the contact slides, the steps before
//! the first output may therefore err by more than the tolerance.
//!
//! That is the truncation error of a smooth evolution. Besides, the pressures ripple as the edge of the
//! contact reaches one ring of elements after the other. Steps that pass more than a ring meet the ripple
//! at their ends, each history at its own. The error of that is estimated from the difference between the
//! rates of wear with which both end, times the length of the step.
//!
//! Where coefficients rise or fall with the distance slid, pairs that join the contact wear little at first, or much. When they
//! joined stays in the depths, and the two histories do not agree on it: of what extrapolation removes a share counts
//! as an error that remains.
//!
//! The pressure of an Euler step lags behind by the order of the step; the two histories show by how
//! much, and the step is kept short enough for that too. At the centre, where no edge passes, the lag is
//! known well enough to be taken off (`Effort::centre_lag`).

use serde::{Deserialize, Serialize};

use super::evolution::{Evolution, Increment};
use super::wider::widened;
use super::{Effort, Error, Simulation};
use crate::motion::{Control, Schedule};
use crate::numerics::vector::Values;
use crate::problem::{ContactProblem, ContactState, Swung};

/// Aim of the controller relative to the tolerance.
const AIM: f64 = 0.9;
/// What the error removed counts as steps are chosen, and how much more what a step adds to it.
const REMOVED: f64 = 1.3;
const ADDED: f64 = 2.0;
/// Factor on it in what is stated, where all of the contact slides. With 1.6, the true error of a punch of r^6 was once
/// more than that (`tests/verification/step_by_error.rs`).
const STATED: f64 = 1.8;
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
/// What steps may err by, over the tolerance, before the first output, and before a tenth of the way.
const LOOSER: f64 = 2.5;
const EARLY: f64 = 0.1;
/// Lag of the pressure at the deepest point that is allowed, relative to the root of the tolerance.
/// Both the lag and the root of the wear's error grow with the step: 4.4 % go with a tolerance of 1e-3.
const LAG: f64 = 1.4;
/// Lag of the pressure at the centre, relative, from which on an edge is thought to pass there.
const EDGE: f64 = 0.1;
/// Bounds on the change of the step from one to the next.
const CHANGE: (f64, f64) = (0.2, 2.0);
/// Bounds on what of it follows the trend of the steps before.
const TREND: (f64, f64) = (0.8, 1.2);
/// The shortest step after another, relative, that ripples ask for.
const SLOWER: f64 = 0.5;
/// Lag of a step over that of the longer one tried before, above which it comes from the steps before.
const INHERITED: f64 = 0.95;
/// Share of a step whose contact was not found that is tried next.
const SHORTER: f64 = 0.25;
/// Shortest step, relative to the progress, that a lag from the steps before asks for.
const SHORTEST: f64 = 0.06;
/// Smallest step, relative to the extent of the motion.
const SMALLEST: f64 = 1e-10;

/// Two histories of wear and the extrapolation from them.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct Adaptive {
    tolerance: f64,
    coarse: Evolution,
    fine: Evolution,
    /// Wear put out: the extrapolation, never falling anywhere, its volume exact (m).
    worn: [Vec<f64>; 2],
    /// The same of the whole surface of a body that swings.
    swung: Option<Swung>,
    /// Length of the next step (the motion's unit).
    step: f64,
    /// Length of the last step (the motion's unit), and its error relative to what was allowed.
    last: Option<[f64; 2]>,
    /// Errors of the deepest wear by truncation and by ripples (m), the largest estimates so far.
    truncation: f64,
    ripple: f64,
}

/// A step of both histories, before it is accepted.
struct Trial {
    coarse: Evolution,
    fine: Evolution,
    /// Extrapolated depths worn off body 1 and body 2 (m).
    worn: [Vec<f64>; 2],
    /// Deepest total wear (m), its errors by truncation and by ripples (m).
    depth: f64,
    truncation: f64,
    ripple: f64,
    /// What of the latter this step has made (m): a shorter one would make less.
    added: f64,
    /// Relative lag of the pressure where the wear is deepest.
    lag: f64,
}

/// What a step began with and came through, as far as its error asks for it.
struct Way<'a> {
    problem: &'a ContactProblem,
    /// The coarse and the fine history before the step.
    before: [&'a ContactState; 2],
    /// Pressures (Pa) and depths (m) of the fine history after its first half.
    pressure: &'a [f64],
    worn: &'a [Vec<f64>; 2],
}

impl Way<'_> {
    /// By what share the pairs that join the contact of the fine history wear less than the deepest one does under the same
    /// pressure, and by what share the deepest one wears less than they do; 0 where no law goes by what was before.
    fn less_wear(&self, end: &ContactState, deepest: usize) -> [f64; 2] {
        if !self.problem.remembers() {
            return [0.0; 2];
        }
        let started = &self.before[1].pressure;
        let of = |pair: usize| [both(&end.worn, pair) - both(self.worn, pair), end.pressure[pair]];
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
    fn of(coarse: Evolution, fine: Evolution, way: &Way<'_>) -> Self {
        let worn = [0, 1].map(|body| extrapolate(&coarse.state.worn[body], &fine.state.worn[body]));
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
        // Where a law is not straight in the pressure, or changes by itself, the wear of both halves tells more.
        let worn_in =
            |from: &[Vec<f64>; 2], to: &[Vec<f64>; 2]| both(to, deepest) - both(from, deepest);
        let halves = [worn_in(&fine_before.worn, way.worn), worn_in(way.worn, &fine.state.worn)];
        let of_wear = relative_change(halves[0], halves[1]);
        let was_is = [removed(coarse_before, fine_before), removed(&coarse.state, &fine.state)];
        let there =
            (2.0 * (both(&fine.state.worn, deepest) - both(&coarse.state.worn, deepest))).abs();
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
            let differ = worn_in(&coarse_before.worn, &coarse.state.worn) - (first + halves[1]);
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
        Self { coarse, fine, worn, depth, truncation, ripple, added, lag }
    }

    /// Error relative to what the tolerance allows; of second order in the step.
    fn excess(&self, tolerance: f64) -> f64 {
        self.excess_of_depth(tolerance).max(self.lag * self.lag / (LAG * LAG * tolerance))
    }

    /// The same of the depth alone.
    fn excess_of_depth(&self, tolerance: f64) -> f64 {
        if self.depth > 0.0 { self.truncation / (tolerance * self.depth) } else { 0.0 }
    }

    /// The same of the ripples that the step makes. They may be larger.
    fn excess_of_ripple(&self, tolerance: f64) -> f64 {
        if self.depth > 0.0 { self.added / (OF_RIPPLES * tolerance * self.depth) } else { 0.0 }
    }
}

impl Adaptive {
    /// Both histories at the initial contact.
    ///
    /// The first step wears the root of the tolerance times the elastic approach: the depth over which
    /// the contact starts to change.
    ///
    /// # Errors
    /// If bodies cannot roll on the frame.
    pub fn new(
        simulation: &Simulation,
        initial: &Evolution,
        tolerance: f64,
    ) -> Result<Self, Error> {
        let extent = simulation.schedule.extent;
        let probe = SMALLEST * extent;
        let problem = &simulation.problem;
        let rate = initial.deepest_wear(problem, probe)? / probe;
        let first = tolerance.sqrt() * initial.state.approach / rate;
        Ok(Self {
            tolerance,
            coarse: initial.clone(),
            fine: initial.clone(),
            worn: initial.state.worn.clone(),
            swung: initial.state.swung.clone(),
            step: if first.is_finite() { first.clamp(probe, extent) } else { extent },
            last: None,
            truncation: 0.0,
            ripple: 0.0,
        })
    }

    /// Carries both histories one accepted step on, not beyond `target`; returns the state to put
    /// out.
    pub fn step(
        &mut self,
        simulation: &Simulation,
        target: f64,
        effort: &mut Effort,
    ) -> Result<Evolution, Error> {
        let mut lag_of_longer = f64::INFINITY;
        loop {
            let progress = self.fine.state.progress;
            let length = landing(self.step, target - progress);
            let smallest = SMALLEST * simulation.schedule.extent;
            let trial = match self.attempt(simulation, length, effort) {
                Err(error) if error.is_of_length() && SHORTER * length >= smallest => {
                    effort.rejected += 1;
                    self.step = SHORTER * length;
                    continue;
                }
                attempt => attempt?,
            };
            let tolerance = self.tolerance * looser(simulation, progress + length);
            let with_lag = trial.excess(tolerance);
            let mut excess = with_lag;
            let trend = self.last.map(|[last, its]| length / last * (its / with_lag).sqrt());
            // Planes wear evenly, without an error.
            let trend = trend.filter(|trend| trend.is_finite()).unwrap_or(1.0);
            let trend = trend.clamp(TREND.0, TREND.1);
            let mut change = (trend * (AIM / excess).sqrt()).clamp(CHANGE.0, CHANGE.1);
            let inherited = trial.lag > INHERITED * lag_of_longer;
            if simulation.problem.motion.swing().is_some() || inherited {
                // How the surfaces fit after the last position of a swing, or where each history met the last ring, stays
                // in the pressures, however short the step.
                excess = trial.excess_of_depth(tolerance);
                change = change.max(SHORTEST * progress / length);
            }
            if excess <= 1.0 {
                // Ripples reject no step: else those would be accepted that end where both histories agree by chance.
                let of_ripple = (AIM / trial.excess_of_ripple(tolerance)).sqrt();
                change = change.min(of_ripple.max(SLOWER));
                let shortened = length < 0.9 * self.step && change >= 1.0;
                let next = if shortened { self.step.max(change * length) } else { change * length };
                self.step = next.max(smallest);
                self.last = Some([length, with_lag]);
                let weight = simulation.problem.frame.measure().weight;
                return Ok(self.accept(trial, weight, slides(&simulation.problem), effort));
            }
            effort.rejected += 1;
            lag_of_longer = trial.lag;
            self.step = length * change.min(0.8);
            if self.step < smallest {
                let measure = simulation.problem.motion.progress();
                return Err(Error::StepTooSmall { measure, progress, step: self.step });
            }
        }
    }

    /// What the fine history's pressure at the centre lags by (Pa): half of what the coarse one's does. `at_centre` finds a
    /// field's value there.
    pub fn centre_lag(&self, problem: &ContactProblem, at_centre: impl Fn(&[f64]) -> f64) -> f64 {
        let [coarse, fine] = [&self.coarse, &self.fine].map(|one| at_centre(&one.state.pressure));
        let safe = problem.motion.swing().is_none() && relative_change(coarse, fine) < EDGE;
        if safe { coarse - fine } else { 0.0 }
    }

    /// The larger approach (m) of both histories.
    pub fn approach(&self) -> f64 {
        self.coarse.state.approach.max(self.fine.state.approach)
    }

    /// Both histories.
    pub fn histories(&self) -> [&Evolution; 2] {
        [&self.coarse, &self.fine]
    }

    /// The same in another frame: `history` takes a history there, `worn` what is worn off both bodies.
    pub fn moved(
        &self,
        history: impl Fn(&Evolution) -> Evolution,
        worn: impl Fn(&[Vec<f64>; 2]) -> [Vec<f64>; 2],
        swung: impl Fn(&Swung) -> Option<Swung>,
    ) -> Self {
        Self {
            coarse: history(&self.coarse),
            fine: history(&self.fine),
            worn: worn(&self.worn),
            swung: self.swung.as_ref().and_then(swung),
            ..*self
        }
    }

    /// Both histories go over from the frame of a problem to a wider one.
    pub fn widen(
        &mut self,
        from: &ContactProblem,
        to: &Simulation,
        effort: &mut Effort,
    ) -> Result<(), Error> {
        for history in [&mut self.coarse, &mut self.fine] {
            *history = history.widened(from, to, effort)?;
        }
        for (body, worn) in self.worn.iter_mut().enumerate() {
            *worn = widened(worn, body, from);
        }
        Ok(())
    }

    /// One coarse and two fine steps.
    fn attempt(
        &self,
        simulation: &Simulation,
        length: f64,
        effort: &mut Effort,
    ) -> Result<Trial, Error> {
        let increment = |advance: f64, end: f64| Increment {
            advance,
            progress: end,
            control: simulation.schedule.control_at(end),
        };
        let start = self.fine.state.progress;
        let (half, end) = (start + 0.5 * length, start + length);
        let (mut coarse, mut fine) = (self.coarse.clone(), self.fine.clone());
        coarse.implicit(simulation, increment(length, end), effort)?;
        fine.implicit(simulation, increment(0.5 * length, half), effort)?;
        let middle = fine.state.pressure.clone();
        let worn = fine.state.worn.clone();
        fine.implicit(simulation, increment(0.5 * length, end), effort)?;
        let way = Way {
            problem: &simulation.problem,
            before: [&self.coarse.state, &self.fine.state],
            pressure: &middle,
            worn: &worn,
        };
        let mut trial = Trial::of(coarse, fine, &way);
        if matches!(simulation.schedule.control, Control::Approach(_)) {
            // Pressures fade to nothing as the bodies part: steps are not chosen by what they lag by.
            trial.lag = 0.0;
        }
        Ok(trial)
    }

    /// Takes a trial over and returns the state to put out: the fine history's contact with the
    /// extrapolated wear.
    fn accept(
        &mut self,
        trial: Trial,
        weight: Values<'_>,
        slides: bool,
        effort: &mut Effort,
    ) -> Evolution {
        self.truncation = self.truncation.max(trial.truncation);
        self.ripple = self.ripple.max(trial.ripple);
        let factor = if slides { STATED } else { 1.0 };
        let error = self.ripple.max(factor * self.truncation);
        effort.time_error = Some(if trial.depth > 0.0 { error / trial.depth } else { 0.0 });
        for (shown, worn) in self.worn.iter_mut().zip(&trial.worn) {
            raise(shown, worn, weight);
        }
        (self.coarse, self.fine) = (trial.coarse, trial.fine);
        let histories = self.coarse.state.swung.as_ref().zip(self.fine.state.swung.as_ref());
        if let Some((shown, (coarse, fine))) = self.swung.as_mut().zip(histories) {
            raise(&mut shown.worn, &extrapolate(&coarse.worn, &fine.worn), Values::All(1.0));
        }
        let load_distance = 2.0 * self.fine.load_distance - self.coarse.load_distance;
        let (worn, swung) = (self.worn.clone(), self.swung.clone());
        let mut state = ContactState { worn, swung, ..self.fine.state.clone() };
        state.show_swung();
        // Nothing goes on from the state shown: it needs no displacement.
        let forward = self.fine.forward;
        Evolution { state, displacement: vec![], known: None, load_distance, forward }
    }
}

/// A step that ends on the next target, alone or with one more of its length, if it comes near it.
fn landing(step: f64, rest: f64) -> f64 {
    let count = (rest / step - 0.1).ceil().max(1.0);
    if count <= 2.0 { rest / count } else { step }
}

/// Whether all of the contact slides, and its edge moves on smoothly.
fn slides(problem: &ContactProblem) -> bool {
    !problem.motion.slips_partly() && problem.motion.swing().is_none()
}

/// Factor on the tolerance of a step that ends there: more than 1 before the first output.
fn looser(simulation: &Simulation, end: f64) -> f64 {
    if !slides(&simulation.problem) {
        return 1.0;
    }
    let Schedule { extent, outputs, .. } = &simulation.schedule;
    let first = outputs.iter().copied().find(|output| *output > 0.0);
    (first.unwrap_or(*extent).min(EARLY * extent) / end).clamp(1.0, LOOSER)
}

/// What extrapolation removes from the coarse history's wear (m): the root of the sum of its squares over all pairs.
fn removed(coarse: &ContactState, fine: &ContactState) -> f64 {
    let [one, two] = [0, 1].map(|body| coarse.worn[body].iter().zip(&fine.worn[body]));
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
fn both(worn: &[Vec<f64>; 2], pair: usize) -> f64 {
    worn[0][pair] + worn[1][pair]
}

/// Change between two pressures, or depths worn, relative to the larger.
fn relative_change(one: f64, other: f64) -> f64 {
    let larger = one.max(other);
    if larger > 0.0 { (other - one).abs() / larger } else { 0.0 }
}

/// Twice the fine less the coarse values.
fn extrapolate(coarse: &[f64], fine: &[f64]) -> Vec<f64> {
    coarse.iter().zip(fine).map(|(coarse, fine)| 2.0 * fine - coarse).collect()
}

/// Raises `shown` towards `worn` without lowering it anywhere and to the same volume: in a few pairs at
/// the rim, which only the coarse history has reached, the extrapolation falls.
fn raise(shown: &mut [f64], worn: &[f64], weight: Values<'_>) {
    let rise = |(pair, (shown, worn)): (usize, (&f64, &f64))| weight.at(pair) * (worn - shown);
    let rises = || shown.iter().zip(worn).enumerate().map(rise);
    let net: f64 = rises().sum();
    let positive: f64 = rises().filter(|rise| *rise > 0.0).sum();
    if net > 0.0 {
        let share = net / positive;
        shown
            .iter_mut()
            .zip(worn)
            .for_each(|(shown, worn)| *shown += share * (worn - *shown).max(0.0));
    }
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
