//! The loop over the steps of a motion.

use serde::{Deserialize, Serialize};

use super::adaptive::Adaptive;
use super::checkpoint::digest;
use super::cycles::{Cycles, Setting};
use super::evolution::{Evolution, Increment};
use super::wider::Wider;
use super::{Effort, Error, Report, Simulation};
use crate::motion::{Motion, Stepping};
use crate::problem::{ContactProblem, ContactState};

/// Two values of progress closer than this, relative to the extent, are the same.
pub(super) const SAME: f64 = 1e-9;

/// A run under way: all that its further steps follow from, beside the simulation.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct March {
    /// Of the simulation.
    pub(super) digest: [u8; 32],
    stepper: Stepper,
    /// Frames that were left for wider ones.
    behind: usize,
    /// Outputs that were put out.
    past: usize,
    /// Whether the fields of the present state are due.
    output: bool,
}

/// What carries a motion on.
#[derive(Debug, Clone, Serialize, Deserialize)]
enum Stepper {
    /// Steps of wear, of a given length or by error.
    Steps(Box<Steps>),
    /// Increments, in cycles or once.
    Cycles(Box<Cycles>),
}

/// A motion in steps of wear.
#[derive(Debug, Clone, Serialize, Deserialize)]
struct Steps {
    evolution: Evolution,
    /// Both histories, where steps are chosen by error.
    adaptive: Option<Adaptive>,
    effort: Effort,
}

impl March {
    /// The initial contact; bodies that are pressed together later only touch.
    pub(super) fn begin(simulation: &Simulation) -> Result<Self, Error> {
        for one in simulation.frames() {
            one.check_frame()?;
            one.problem.check_inputs()?;
        }
        let stepper = match &simulation.problem.motion {
            Motion::Shift(shift) => {
                Stepper::Cycles(Box::new(Cycles::begin(Setting { simulation, shift })?))
            }
            Motion::Sliding(_) | Motion::Rolling(_) => {
                Stepper::Steps(Box::new(Steps::begin(simulation)?))
            }
        };
        Ok(Self { digest: digest(simulation), stepper, behind: 0, past: 0, output: true })
    }

    /// Goes on to the next state that is shown; whether there was one.
    pub(super) fn step(&mut self, simulation: &Simulation) -> Result<bool, Error> {
        let simulation = self.widen(simulation)?;
        let schedule = &simulation.schedule;
        let next = schedule.outputs.get(self.past).copied().unwrap_or(schedule.extent);
        let next = next.min(schedule.extent);
        let went = match (&mut self.stepper, &simulation.problem.motion) {
            (Stepper::Steps(steps), _) => steps.step(simulation, next)?,
            (Stepper::Cycles(cycles), Motion::Shift(shift)) => {
                cycles.step(Setting { simulation, shift }, next)?
            }
            (Stepper::Cycles(_), _) => false,
        };
        if went {
            let progress = self.state().progress;
            let margin = SAME * schedule.extent;
            self.output = schedule.extent - progress <= margin;
            let due = |past: &usize| {
                schedule.outputs.get(*past).is_some_and(|&due| due <= progress + margin)
            };
            while due(&self.past) {
                (self.past, self.output) = (self.past + 1, true);
            }
        }
        Ok(went)
    }

    /// The simulation in the frame that the run is in.
    fn present<'a>(&self, simulation: &'a Simulation) -> &'a Simulation {
        simulation.frames().nth(self.behind).unwrap_or(simulation)
    }

    /// Goes over to a wider frame where it is time to; returns what the run goes on with.
    fn widen<'a>(&mut self, simulation: &'a Simulation) -> Result<&'a Simulation, Error> {
        let mut present = self.present(simulation);
        let Stepper::Steps(steps) = &mut self.stepper else { return Ok(present) };
        let margin = SAME * simulation.schedule.extent;
        while let Some(Wider { from, simulation: wider }) = present.wider.as_deref()
            && steps.evolution.state.progress >= from - margin
        {
            steps.widen(&present.problem, wider)?;
            present = wider;
            self.behind += 1;
        }
        Ok(present)
    }

    fn state(&self) -> &ContactState {
        match &self.stepper {
            Stepper::Steps(steps) => &steps.evolution.state,
            Stepper::Cycles(cycles) => &cycles.shown().state,
        }
    }

    /// What the run took, also after the last state shown.
    pub(super) fn effort(&self) -> Effort {
        match &self.stepper {
            Stepper::Steps(steps) => steps.effort,
            Stepper::Cycles(cycles) => cycles.effort(),
        }
    }

    /// The present state.
    pub(super) fn report<'a>(&'a self, simulation: &'a Simulation) -> Report<'a> {
        let (state, schedule) = (self.state(), &simulation.schedule);
        let problem = &self.present(simulation).problem;
        let (effort, prescribed) = match &self.stepper {
            Stepper::Steps(steps) => (steps.effort, schedule.control_at(state.progress)),
            Stepper::Cycles(cycles) => (cycles.shown().effort, cycles.shown().control),
        };
        Report {
            problem,
            state,
            effort,
            output: self.output,
            extent: schedule.extent,
            prescribed,
            stepping: schedule.stepping,
            companion: simulation.companion.as_ref(),
            again: false,
            march: Some(self),
        }
    }
}

impl Steps {
    fn begin(simulation: &Simulation) -> Result<Self, Error> {
        let schedule = &simulation.schedule;
        let mut effort = Effort::default();
        let mut evolution = Evolution::new(&simulation.problem);
        if !schedule.ramped {
            let increment = Increment { advance: 0.0, progress: 0.0, control: schedule.control };
            evolution.press(simulation, increment, &mut effort)?;
        }
        let adaptive = match schedule.stepping {
            Stepping::Tolerance(tolerance) => {
                Some(Adaptive::new(simulation, &evolution, tolerance)?)
            }
            _ => None,
        };
        Ok(Self { evolution, adaptive, effort })
    }

    /// Goes over from the frame of a problem to a wider one.
    fn widen(&mut self, from: &ContactProblem, to: &Simulation) -> Result<(), Error> {
        match &mut self.adaptive {
            Some(adaptive) => adaptive.widen(from, to, &mut self.effort),
            None => {
                self.evolution = self.evolution.widened(from, to, &mut self.effort)?;
                Ok(())
            }
        }
    }

    /// One accepted step, which ends on an output or before it where steps are chosen by error.
    fn step(&mut self, simulation: &Simulation, next: f64) -> Result<bool, Error> {
        let schedule = &simulation.schedule;
        if self.evolution.state.progress >= schedule.extent {
            return Ok(false);
        }
        self.effort.iterations = 0;
        match (&mut self.adaptive, schedule.stepping) {
            (Some(adaptive), _) => {
                self.evolution = adaptive.step(simulation, next, &mut self.effort)?;
            }
            (None, Stepping::Explicit(step)) => {
                self.fixed(simulation, step, Evolution::explicit)?
            }
            (None, Stepping::Implicit(step) | Stepping::Tolerance(step)) => {
                self.fixed(simulation, step, Evolution::implicit)?;
            }
            (None, Stepping::ToOutputs) => {
                self.to(simulation, next, Evolution::implicit)?;
            }
            // Cycles are gone through elsewhere.
            (None, Stepping::Jumps(_)) => {
                self.fixed(simulation, schedule.extent, Evolution::implicit)?
            }
        }
        self.effort.steps += 1;
        self.effort.load_distance = self.evolution.load_distance;
        let progress = &mut self.evolution.state.progress;
        if schedule.extent - *progress <= SAME * schedule.extent {
            *progress = schedule.extent;
        }
        Ok(true)
    }

    /// One step of a given length, the last one shorter where the extent is not a multiple of it.
    fn fixed(
        &mut self,
        simulation: &Simulation,
        step: f64,
        scheme: fn(&mut Evolution, &Simulation, Increment, &mut Effort) -> Result<(), Error>,
    ) -> Result<(), Error> {
        let extent = simulation.schedule.extent;
        // From the count of steps, so that rounding does not add up.
        let end = ((self.effort.steps + 1) as f64 * step).min(extent);
        let end = if extent - end <= SAME * extent { extent } else { end };
        self.to(simulation, end, scheme)
    }

    /// One step to a place.
    fn to(
        &mut self,
        simulation: &Simulation,
        end: f64,
        scheme: fn(&mut Evolution, &Simulation, Increment, &mut Effort) -> Result<(), Error>,
    ) -> Result<(), Error> {
        let advance = end - self.evolution.state.progress;
        let increment =
            Increment { advance, progress: end, control: simulation.schedule.control_at(end) };
        scheme(&mut self.evolution, simulation, increment, &mut self.effort)
    }
}
