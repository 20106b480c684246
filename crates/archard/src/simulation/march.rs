//! The loop over the steps of a motion.

use serde::{Deserialize, Serialize};

use super::adaptive::Adaptive;
use super::checkpoint::digest;
use super::cycles::{Cycles, Setting};
use super::evolution::{Evolution, Increment};
use super::wider::Wider;
use super::window::Window;
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
    histories: Histories,
    /// Where they live, if not in the whole frame; and the present state in it then.
    window: Option<(Window, ContactState)>,
    effort: Effort,
}

/// What steps of wear go on from.
#[derive(Debug, Clone, Serialize, Deserialize)]
struct Histories {
    evolution: Evolution,
    /// Both histories, where steps are chosen by error.
    adaptive: Option<Adaptive>,
}

/// How a history takes a step.
type Scheme = fn(&mut Evolution, &Simulation, Increment, &mut Effort) -> Result<(), Error>;

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
            && steps.state().progress >= from - margin
        {
            steps.widen(&present.problem, wider)?;
            present = wider;
            self.behind += 1;
        }
        Ok(present)
    }

    fn state(&self) -> &ContactState {
        match &self.stepper {
            Stepper::Steps(steps) => steps.state(),
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
            companions: simulation.companions.as_ref(),
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
        let histories = Histories { evolution, adaptive };
        Ok(Self { histories, window: None, effort }.in_a_window(simulation))
    }

    /// The same with the histories in a window, where there is one.
    fn in_a_window(mut self, simulation: &Simulation) -> Self {
        let window = Window::around(simulation, self.histories.approach());
        self.move_to(window);
        self
    }

    /// Brings histories in the frame to a window.
    fn move_to(&mut self, window: Option<Window>) {
        let Some(window) = window else { return };
        let shown = self.histories.evolution.state.clone();
        let field = |field: &[f64]| window.cut(field);
        self.histories = self.histories.moved(|history| window.cut_history(history), field);
        self.window = Some((window, shown));
    }

    /// Brings histories in a window back to the frame; returns the window.
    fn leave_window(&mut self, problem: &ContactProblem) -> Option<Window> {
        let (window, _) = self.window.take()?;
        let field = |field: &[f64]| window.put(field);
        let history = |history: &Evolution| window.put_history(history, &problem.frame);
        self.histories = self.histories.moved(history, field);
        Some(window)
    }

    /// Takes a larger window, or the frame.
    fn grow(&mut self, simulation: &Simulation) {
        let Some(window) = self.leave_window(&simulation.problem) else { return };
        self.move_to(window.larger(simulation, self.histories.approach()));
    }

    /// The present state in the whole frame.
    fn state(&self) -> &ContactState {
        self.window.as_ref().map_or(&self.histories.evolution.state, |(_, shown)| shown)
    }

    /// Goes over from the frame of a problem to a wider one.
    fn widen(&mut self, from: &ContactProblem, to: &Simulation) -> Result<(), Error> {
        self.leave_window(from);
        let Histories { evolution, adaptive } = &mut self.histories;
        match adaptive {
            Some(adaptive) => adaptive.widen(from, to, &mut self.effort),
            None => {
                *evolution = evolution.widened(from, to, &mut self.effort)?;
                Ok(())
            }
        }
    }

    /// One accepted step, which ends on an output or before it where steps are chosen by error.
    fn step(&mut self, simulation: &Simulation, next: f64) -> Result<bool, Error> {
        let extent = simulation.schedule.extent;
        if self.state().progress >= extent {
            return Ok(false);
        }
        self.effort.iterations = 0;
        let narrow =
            |(window, _): &(Window, _)| window.is_narrow(simulation, self.histories.approach());
        if self.window.as_ref().is_some_and(narrow) {
            self.grow(simulation);
        }
        loop {
            let window = self.window.as_ref();
            let Some(within) = window.and_then(|(window, _)| window.simulation(simulation)) else {
                self.leave_window(&simulation.problem);
                self.histories.step(simulation, next, &mut self.effort)?;
                break;
            };
            // A step that fails may have worn the bodies: an explicit one does so first.
            let before = self.histories.clone();
            match self.histories.step(&within, next, &mut self.effort) {
                Err(Error::FrameFull { .. }) => {
                    self.histories = before;
                    self.grow(simulation);
                }
                went => break went?,
            }
        }
        self.effort.steps += 1;
        let Histories { evolution, adaptive } = &mut self.histories;
        self.effort.load_distance = evolution.load_distance;
        let progress = &mut evolution.state.progress;
        if extent - *progress <= SAME * extent {
            *progress = extent;
        }
        let frame = &simulation.problem.frame;
        if let Some((window, shown)) = &mut self.window {
            *shown = window.put_state(&evolution.state, frame);
        }
        if let Some(adaptive) = adaptive {
            let at_centre = |field: &[f64]| match &self.window {
                Some((window, _)) => frame.at_centre(&window.put(field)),
                None => frame.at_centre(field),
            };
            self.effort.centre_lag = adaptive.centre_lag(&simulation.problem, at_centre);
        }
        Ok(true)
    }
}

impl Histories {
    /// The largest approach (m) of all.
    fn approach(&self) -> f64 {
        let adaptive = self.adaptive.as_ref().map_or(f64::NEG_INFINITY, Adaptive::approach);
        self.evolution.state.approach.max(adaptive)
    }

    /// The same in another frame: `history` takes a history there, `field` a field.
    fn moved(
        &self,
        history: impl Fn(&Evolution) -> Evolution,
        field: impl Fn(&[f64]) -> Vec<f64>,
    ) -> Self {
        Self {
            evolution: history(&self.evolution),
            adaptive: self.adaptive.as_ref().map(|adaptive| adaptive.moved(history, field)),
        }
    }

    /// One accepted step.
    fn step(
        &mut self,
        simulation: &Simulation,
        next: f64,
        effort: &mut Effort,
    ) -> Result<(), Error> {
        let schedule = &simulation.schedule;
        match (&mut self.adaptive, schedule.stepping) {
            (Some(adaptive), _) => self.evolution = adaptive.step(simulation, next, effort)?,
            (None, Stepping::Explicit(step)) => {
                self.fixed(simulation, step, Evolution::explicit, effort)?
            }
            (None, Stepping::Implicit(step) | Stepping::Tolerance(step)) => {
                self.fixed(simulation, step, Evolution::implicit, effort)?;
            }
            (None, Stepping::ToOutputs) => {
                self.to(simulation, next, Evolution::implicit, effort)?;
            }
            // Cycles are gone through elsewhere.
            (None, Stepping::Jumps(_)) => {
                self.fixed(simulation, schedule.extent, Evolution::implicit, effort)?
            }
        }
        Ok(())
    }

    /// One step of a given length, the last one shorter where the extent is not a multiple of it.
    fn fixed(
        &mut self,
        simulation: &Simulation,
        step: f64,
        scheme: Scheme,
        effort: &mut Effort,
    ) -> Result<(), Error> {
        let extent = simulation.schedule.extent;
        // From the count of steps, so that rounding does not add up.
        let end = ((effort.steps + 1) as f64 * step).min(extent);
        let end = if extent - end <= SAME * extent { extent } else { end };
        self.to(simulation, end, scheme, effort)
    }

    /// One step to a place.
    fn to(
        &mut self,
        simulation: &Simulation,
        end: f64,
        scheme: Scheme,
        effort: &mut Effort,
    ) -> Result<(), Error> {
        let advance = end - self.evolution.state.progress;
        let increment =
            Increment { advance, progress: end, control: simulation.schedule.control_at(end) };
        scheme(&mut self.evolution, simulation, increment, effort)
    }
}
