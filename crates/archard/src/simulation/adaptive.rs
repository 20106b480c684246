//! Wear in steps chosen by error.
//!
//! Two histories of implicit Euler steps run side by side from the unworn start, one in steps twice
//! as long as the other's; neither ever sees the other. Their difference is the first-order error of
//! the coarse one's halves, so that twice the fine less the coarse wear is of second order (L. F.
//! Richardson, *Phil. Trans. R. Soc. A* 210 (1911) 307). Because the extrapolation is never fed back,
//! the pressures stay those of implicit Euler, without a spike at the edge of the growing contact:
//! feeding it back, or any linear second-order step, leaves spikes there.
//!
//! The error that remains after extrapolation is estimated by [`Trial`]; steps are chosen by it.
//!
//! What steps err by early fades, since deeper places wear less from then on. Where all of the contact slides, the steps before
//! the first output may therefore err by more than the tolerance.
//!
//! The pressure of an Euler step lags behind by the order of the step; the two histories show by how
//! much, and the step is kept short enough for that too. At the centre, where no edge passes, the lag is
//! known well enough to be taken off (`Effort::centre_lag`).

use serde::{Deserialize, Serialize};

use super::advance::Scheme;
use super::effort::Effort;
use super::error::Error;
use super::memory::{History, Increment};
use super::moving::{Move, Moving};
use super::setup::Simulation;
use super::trial::{STATED, Trial, Way, depths, extrapolate, relative_change, slides};
use crate::motion::{self, Schedule};
use crate::numerics::control::{Caution, Control};
use crate::numerics::vector::Values;
use crate::problem::{ContactProblem, ContactState, Surface};

/// How steps change: those that are rejected, or whose contact was not found, by the last two.
const CAUTION: Caution = Caution { aim: 0.9, change: [0.2, 2.0], again: 0.8, failed: 0.25 };
/// What steps may err by, over the tolerance, before the first output, and before a tenth of the way.
const LOOSER: f64 = 2.5;
const EARLY: f64 = 0.1;
/// Lag of the pressure at the centre, relative, from which on an edge is thought to pass there.
const EDGE: f64 = 0.1;
/// Bounds on what of it follows the trend of the steps before.
const TREND: (f64, f64) = (0.8, 1.2);
/// The shortest step after another, relative, that ripples ask for.
const SLOWER: f64 = 0.5;
/// Lag of a step over that of the longer one tried before, above which it comes from the steps before.
const INHERITED: f64 = 0.95;
/// Shortest step, relative to the progress, that a lag from the steps before asks for.
const SHORTEST: f64 = 0.06;
/// Smallest step, relative to the extent of the motion.
const SMALLEST: f64 = 1e-10;

/// Two histories of wear and the extrapolation from them.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct Adaptive {
    tolerance: f64,
    coarse: History,
    fine: History,
    /// Surfaces put out: worn by the extrapolation, never falling anywhere, its volume exact.
    surfaces: [Surface; 2],
    /// Length of the next step (the motion's unit).
    step: Control,
    /// Length of the last step (the motion's unit), and its error relative to what was allowed.
    last: Option<[f64; 2]>,
    /// Errors of the deepest wear by truncation and by ripples (m), the largest estimates so far.
    truncation: f64,
    ripple: f64,
}

impl Adaptive {
    /// Both histories at the initial contact.
    ///
    /// The first step wears the root of the tolerance times the elastic approach: the depth over which
    /// the contact starts to change.
    ///
    /// # Errors
    /// If bodies cannot roll on the frame.
    pub fn new(simulation: &Simulation, initial: &History, tolerance: f64) -> Result<Self, Error> {
        let extent = simulation.schedule.extent;
        let probe = SMALLEST * extent;
        let problem = &simulation.problem;
        let rate = initial.deepest_wear(problem, probe)? / probe;
        let first = tolerance.sqrt() * initial.state.approach / rate;
        Ok(Self {
            tolerance,
            coarse: initial.clone(),
            fine: initial.clone(),
            surfaces: initial.state.surfaces.clone(),
            step: Control::first(if first.is_finite() {
                first.clamp(probe, extent)
            } else {
                extent
            }),
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
    ) -> Result<History, Error> {
        let mut lag_of_longer = f64::INFINITY;
        loop {
            let progress = self.fine.state.progress;
            let length = self.step.towards(target - progress);
            let smallest = SMALLEST * simulation.schedule.extent;
            let trial = match self.attempt(simulation, length, effort) {
                Err(error) if error.is_of_length() && CAUTION.failed * length >= smallest => {
                    effort.rejected += 1;
                    self.step.failed(length, CAUTION);
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
            let mut change = CAUTION.change(excess, trend);
            let inherited = trial.lag > INHERITED * lag_of_longer;
            if simulation.problem.motion.has_positions() || inherited {
                // How the surfaces fit after the last position of a swing, or where each history met the last ring, stays
                // in the pressures, however short the step.
                excess = trial.excess_of_depth(tolerance);
                change = change.max(SHORTEST * progress / length);
            }
            if excess <= 1.0 {
                // Ripples reject no step: else those would be accepted that end where both histories agree by chance.
                let of_ripple = (CAUTION.aim / trial.excess_of_ripple(tolerance)).sqrt();
                change = change.min(of_ripple.max(SLOWER));
                self.step.taken(length, change);
                self.step.at_least(smallest);
                self.last = Some([length, with_lag]);
                let weight = simulation.problem.frame.measure().weight;
                return Ok(self.accept(trial, weight, slides(&simulation.problem), effort));
            }
            effort.rejected += 1;
            lag_of_longer = trial.lag;
            self.step.rejected(length, change, CAUTION);
            let step = self.step.next();
            if step < smallest {
                let measure = simulation.problem.motion.progress;
                return Err(Error::StepTooSmall { measure, progress, step });
            }
        }
    }

    /// What the fine history's pressure at the centre lags by (Pa): half of what the coarse one's does.
    pub fn centre_lag(&self, problem: &ContactProblem) -> f64 {
        let pressures = [&self.coarse, &self.fine].map(|one| &one.state.pressure);
        let [coarse, fine] = pressures.map(|pressure| problem.frame.at_centre(pressure));
        let safe = !problem.motion.has_positions() && relative_change(coarse, fine) < EDGE;
        if safe { coarse - fine } else { 0.0 }
    }

    /// Both histories.
    pub fn histories(&self) -> [&History; 2] {
        [&self.coarse, &self.fine]
    }

    /// Both, to change.
    pub fn histories_mut(&mut self) -> [&mut History; 2] {
        [&mut self.coarse, &mut self.fine]
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
        coarse.advance(simulation, increment(length, end), Scheme::Implicit, effort)?;
        fine.advance(simulation, increment(0.5 * length, half), Scheme::Implicit, effort)?;
        let middle = fine.state.pressure.clone();
        let worn = depths(&fine.state).map(|worn| worn.into_owned().into());
        fine.advance(simulation, increment(0.5 * length, end), Scheme::Implicit, effort)?;
        let way = Way {
            problem: &simulation.problem,
            before: [&self.coarse.state, &self.fine.state],
            pressure: &middle,
            worn: &worn,
        };
        let mut trial = Trial::of(coarse, fine, &way);
        if matches!(simulation.schedule.control, motion::Control::Approach(_)) {
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
    ) -> History {
        self.truncation = self.truncation.max(trial.truncation);
        self.ripple = self.ripple.max(trial.ripple);
        let factor = if slides { STATED } else { 1.0 };
        let error = self.ripple.max(factor * self.truncation);
        effort.time_error = Some(if trial.depth > 0.0 { error / trial.depth } else { 0.0 });
        (self.coarse, self.fine) = (trial.coarse, trial.fine);
        let histories = self.coarse.state.surfaces.iter().zip(&self.fine.state.surfaces);
        for (shown, (coarse, fine)) in self.surfaces.iter_mut().zip(histories) {
            let worn = extrapolate(&coarse.depth, &fine.depth);
            match weight {
                Values::All(_) => raise(&mut shown.depth, &worn, weight),
                Values::Each(weights) => {
                    let weights = fine.gathered(weights);
                    raise(&mut shown.depth, &worn, Values::Each(&weights));
                }
            }
            shown.slid.clone_from(&fine.slid);
            shown.imprint.clone_from(&fine.imprint);
        }
        let load_distance = 2.0 * self.fine.load_distance - self.coarse.load_distance;
        let surfaces = self.surfaces.clone();
        let state = ContactState { surfaces, ..self.fine.state.clone() };
        // Nothing goes on from the state shown: it needs no displacement.
        let forward = self.fine.forward;
        History { load_distance, forward, ..History::at(state, vec![]) }
    }
}

impl Move for Adaptive {
    fn moved(&self, to: &Moving<'_>) -> Self {
        Self {
            coarse: self.coarse.moved(to),
            fine: self.fine.moved(to),
            surfaces: self.surfaces.moved(to),
            ..*self
        }
    }
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
