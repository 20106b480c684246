//! A motion in steps of wear, of a given length or by error.

use serde::{Deserialize, Serialize};

use super::adaptive::Adaptive;
use super::advance::Scheme;
use super::effort::Effort;
use super::error::Error;
use super::memory::{History, Increment};
use super::moving::{Move, Moving};
use super::setup::{SAME, Simulation};
use crate::motion::Stepping;
use crate::problem::ContactState;

/// A motion in steps of wear.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct Steps {
    history: History,
    /// Both histories, where steps are chosen by error.
    adaptive: Option<Adaptive>,
    pub effort: Effort,
}

impl Steps {
    /// The initial contact.
    pub fn begin(simulation: &Simulation) -> Result<Self, Error> {
        let schedule = &simulation.schedule;
        let mut effort = Effort::default();
        let mut history = History::new(&simulation.problem);
        if !schedule.ramped {
            let increment = Increment { advance: 0.0, progress: 0.0, control: schedule.control };
            history.press(simulation, increment, &mut effort)?;
        }
        let adaptive = match schedule.stepping {
            Stepping::Tolerance(tolerance) => Some(Adaptive::new(simulation, &history, tolerance)?),
            _ => None,
        };
        Ok(Self { history, adaptive, effort })
    }

    /// Goes over to another frame; on elements twice as large the bodies are pressed together anew.
    pub fn go(&mut self, to: &Moving<'_>) -> Result<(), Error> {
        self.history = self.history.moved(to);
        self.adaptive = self.adaptive.moved(to);
        if to.shared.is_some() {
            return Ok(());
        }
        let Self { history, adaptive, effort } = self;
        match adaptive.as_mut().map(Adaptive::histories_mut) {
            Some([coarse, fine]) => {
                coarse.press_anew(to.simulation, effort)?;
                fine.press_anew(to.simulation, effort)
            }
            None => history.press_anew(to.simulation, effort),
        }
    }

    /// The contacts that were found.
    pub fn states(&self) -> impl Iterator<Item = &ContactState> {
        let both = self.adaptive.iter().flat_map(Adaptive::histories);
        both.chain([&self.history]).map(|history| &history.state)
    }

    /// The present state.
    pub fn state(&self) -> &ContactState {
        &self.history.state
    }

    /// One accepted step, which ends on an output or before it where steps are chosen by error.
    pub fn step(&mut self, simulation: &Simulation, next: f64) -> Result<bool, Error> {
        let schedule = &simulation.schedule;
        let extent = schedule.extent;
        if self.state().progress >= extent {
            return Ok(false);
        }
        match (&mut self.adaptive, schedule.stepping) {
            (Some(adaptive), _) => {
                self.history = adaptive.step(simulation, next, &mut self.effort)?;
            }
            (None, Stepping::Explicit(step)) => {
                self.fixed(simulation, step, Scheme::Explicit)?;
            }
            (None, Stepping::Implicit(step) | Stepping::Tolerance(step)) => {
                self.fixed(simulation, step, Scheme::Implicit)?;
            }
            (None, Stepping::ToOutputs) => self.to(simulation, next, Scheme::Implicit)?,
            // Cycles are gone through elsewhere.
            (None, Stepping::Jumps(_)) => self.fixed(simulation, extent, Scheme::Implicit)?,
        }
        self.effort.steps += 1;
        self.effort.load_distance = self.history.load_distance;
        let progress = &mut self.history.state.progress;
        if extent - *progress <= SAME * extent {
            *progress = extent;
        }
        if let Some(adaptive) = &self.adaptive {
            self.effort.centre_lag = adaptive.centre_lag(&simulation.problem);
        }
        Ok(true)
    }

    /// One step of a given length, the last one shorter where the extent is not a multiple of it.
    fn fixed(
        &mut self,
        simulation: &Simulation,
        step: f64,
        scheme: Scheme<'_>,
    ) -> Result<(), Error> {
        let extent = simulation.schedule.extent;
        // From the count of steps, so that rounding does not add up.
        let end = ((self.effort.steps + 1) as f64 * step).min(extent);
        let end = if extent - end <= SAME * extent { extent } else { end };
        self.to(simulation, end, scheme)
    }

    /// One step to a place.
    fn to(&mut self, simulation: &Simulation, end: f64, scheme: Scheme<'_>) -> Result<(), Error> {
        let advance = end - self.history.state.progress;
        let increment =
            Increment { advance, progress: end, control: simulation.schedule.control_at(end) };
        self.history.advance(simulation, increment, scheme, &mut self.effort).map(|_| ())
    }
}
