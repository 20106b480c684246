//! The loop over the steps of a motion, and the frames that it goes through.

use serde::{Deserialize, Serialize};

use super::cycles::{Cycles, Setting};
use super::digest::digest;
use super::effort::Effort;
use super::error::Error;
use super::moving::{Move, Moving};
use super::placed::Placed;
use super::report::Report;
use super::setup::{SAME, Simulation};
use super::steps::Steps;
use super::surroundings::More;
use crate::problem::ContactState;

/// A run under way: all that its further steps follow from, besides the simulation.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct March {
    /// Of the simulation.
    pub(super) digest: [u8; 32],
    stepper: Stepper,
    /// Where it works.
    placed: Placed,
    /// The present state in the frame, where it works in a window.
    shown: Option<ContactState>,
    /// Outputs that were put out.
    past: usize,
    /// Whether the fields of the present state are due.
    output: bool,
}

/// What carries a motion on.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) enum Stepper {
    /// Steps of wear, of a given length or by error.
    Steps(Box<Steps>),
    /// Increments, in cycles or once.
    Cycles(Box<Cycles>),
}

impl March {
    /// The initial contact; bodies that are pressed together later only touch.
    pub(super) fn begin(simulation: &Simulation) -> Result<Self, Error> {
        let (placed, stepper) = Stepper::begin(simulation)?;
        let digest = digest(simulation);
        let mut march = Self { digest, stepper, placed, shown: None, past: 0, output: true };
        let window = march.placed.windowed(simulation, march.stepper.approach());
        march.go(window, simulation)?;
        Ok(march)
    }

    /// Goes on to the next state that is shown; whether there was one. A step that missed something is taken again in a
    /// larger place.
    pub(super) fn step(&mut self, simulation: &Simulation) -> Result<bool, Error> {
        let schedule = &simulation.schedule;
        let margin = SAME * schedule.extent;
        let next = schedule.outputs.get(self.past).copied().unwrap_or(schedule.extent);
        let next = next.min(schedule.extent);
        while let Some(doubled) = self.placed.doubled(simulation, self.state().progress + margin) {
            self.go(doubled, simulation)?;
        }
        if self.placed.is_narrow(simulation, self.stepper.approach()) {
            self.go(self.placed.roomier(simulation, self.stepper.approach()), simulation)?;
        }
        self.stepper.count_anew(schedule.extent);
        let went = loop {
            let present = self.placed.simulation(simulation).unwrap_or(simulation);
            let may_miss = self.placed.is_window() || present.surroundings().grow();
            // A step that fails may have worn the bodies: an explicit one does so first.
            let before = may_miss.then(|| self.stepper.clone());
            let went = self.stepper.step(present, next);
            if went.is_ok() {
                self.show(simulation);
            }
            let Some(before) = before else { break went? };
            let Some(place) = self.larger(simulation, &went, before.approach())? else {
                break went?;
            };
            let took = std::mem::replace(&mut self.stepper, before).effort();
            let in_frame = self.placed.whole().to(&place.whole(), simulation).is_none();
            self.stepper.count(took, in_frame);
            self.go(place, simulation)?;
        };
        if went {
            let progress = self.state().progress;
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

    /// A place that holds what an attempt to go on missed; `None` where it missed nothing, or none holds more. The histories
    /// went on from an approach (m).
    fn larger(
        &self,
        simulation: &Simulation,
        went: &Result<bool, Error>,
        approach: f64,
    ) -> Result<Option<Placed>, Error> {
        let frame = self.placed.in_frame(simulation).unwrap_or(simulation);
        let more = match (went, &self.shown) {
            (Ok(false), _) => None,
            (Ok(true), Some(shown)) => missed(frame, [shown]),
            (Ok(true), None) => missed(frame, self.stepper.states()),
            (Err(Error::FrameFull { .. }), Some(_)) => {
                return Ok(Some(self.placed.roomier(simulation, approach)));
            }
            (Err(error), _) => all_touches(error, frame),
        };
        let reached = [self.state().progress, approach];
        let larger = more.map(|more| self.placed.larger(simulation, more, reached));
        Ok(larger.transpose()?.flatten())
    }

    /// Goes over to another place.
    fn go(&mut self, place: Placed, simulation: &Simulation) -> Result<(), Error> {
        self.go_straight(self.placed.whole(), simulation)?;
        self.go_straight(place.whole(), simulation)?;
        self.shown = place.is_window().then(|| self.stepper.state().clone());
        self.go_straight(place, simulation)
    }

    fn go_straight(&mut self, place: Placed, simulation: &Simulation) -> Result<(), Error> {
        if let Some(to) = self.placed.to(&place, simulation) {
            self.stepper.go(&to)?;
        }
        self.placed = place;
        Ok(())
    }

    /// Takes the present state from a window to the frame.
    fn show(&mut self, simulation: &Simulation) {
        let Some(shown) = &mut self.shown else { return };
        if let Some(to) = self.placed.to(&self.placed.whole(), simulation) {
            *shown = self.stepper.state().moved(&to);
        }
    }

    /// Whether the frame and the window that the run is in can be made.
    pub(super) fn can_go_on(&self, simulation: &Simulation) -> bool {
        self.placed.simulation(simulation).is_some()
    }

    fn state(&self) -> &ContactState {
        self.shown.as_ref().unwrap_or_else(|| self.stepper.state())
    }

    /// What the run took, also after the last state shown.
    pub(super) fn effort(&self) -> Effort {
        self.stepper.effort()
    }

    /// The present state.
    pub(super) fn report<'a>(&'a self, simulation: &'a Simulation) -> Report<'a> {
        let (state, schedule) = (self.state(), &simulation.schedule);
        let problem = &self.placed.in_frame(simulation).unwrap_or(simulation).problem;
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

/// As much more as holds a contact that filled its frame, or swung out of it.
fn all_touches(error: &Error, simulation: &Simulation) -> Option<More> {
    let full = matches!(error, Error::FrameFull { .. } | Error::SwungOut { .. });
    full.then(|| simulation.surroundings().twice(&simulation.problem)).flatten()
}

/// How much more a frame needs that holds the contact of states in it.
fn missed<'a>(
    simulation: &Simulation,
    states: impl IntoIterator<Item = &'a ContactState>,
) -> Option<More> {
    let (surroundings, problem) = (simulation.surroundings(), &simulation.problem);
    let all = |one: More, other: More| {
        [0, 1].map(|axis| [0, 1].map(|side| one[axis][side].max(other[axis][side])))
    };
    let grows = surroundings.grow();
    let states = states.into_iter().filter(|_| grows);
    states.filter_map(|state| surroundings.missed(problem, state)).reduce(all)
}

impl Stepper {
    /// The initial contact, in a frame that holds it; bodies that are pressed together later only touch.
    pub(super) fn begin(simulation: &Simulation) -> Result<(Placed, Self), Error> {
        for one in simulation.frames() {
            one.problem.fits()?;
        }
        let mut placed = Placed::default();
        loop {
            let frame = placed.in_frame(simulation).unwrap_or(simulation);
            let stepper = Self::within(frame);
            let missed = match &stepper {
                Ok(stepper) => missed(frame, stepper.states()),
                Err(error) => all_touches(error, frame),
            };
            let apart = [0.0, f64::NEG_INFINITY];
            let larger = missed.map(|more| placed.larger(simulation, more, apart));
            let Some(larger) = larger.transpose()?.flatten() else { return Ok((placed, stepper?)) };
            placed = larger;
        }
    }

    fn within(simulation: &Simulation) -> Result<Self, Error> {
        Ok(match simulation.problem.motion.increments() {
            Some(shift) => Self::Cycles(Box::new(Cycles::begin(Setting { simulation, shift })?)),
            None => Self::Steps(Box::new(Steps::begin(simulation)?)),
        })
    }

    /// Goes on to the next state, and not beyond a place; whether there was one.
    fn step(&mut self, simulation: &Simulation, next: f64) -> Result<bool, Error> {
        match (self, simulation.problem.motion.increments()) {
            (Self::Steps(steps), _) => steps.step(simulation, next),
            (Self::Cycles(cycles), Some(shift)) => cycles.step(Setting { simulation, shift }, next),
            (Self::Cycles(_), None) => Ok(false),
        }
    }

    pub(super) fn effort(&self) -> Effort {
        match self {
            Self::Steps(steps) => steps.effort,
            Self::Cycles(cycles) => cycles.effort,
        }
    }

    /// Begins to count the iterations of a step, where one is to come.
    fn count_anew(&mut self, extent: f64) {
        if let Self::Steps(steps) = self
            && steps.state().progress < extent
        {
            steps.effort.iterations = 0;
        }
    }

    /// Counts what an attempt took that led nowhere: all of it in the same frame, solves and applications of a smaller one.
    fn count(&mut self, took: Effort, in_frame: bool) {
        let effort = match self {
            Self::Steps(steps) => &mut steps.effort,
            Self::Cycles(cycles) => &mut cycles.effort,
        };
        let Effort { solves, applications, .. } = took;
        *effort = if in_frame { took } else { Effort { solves, applications, ..*effort } };
    }

    /// The present state.
    pub(super) fn state(&self) -> &ContactState {
        match self {
            Self::Steps(steps) => steps.state(),
            Self::Cycles(cycles) => &cycles.shown().state,
        }
    }

    /// The states that it has come to.
    fn states(&self) -> Vec<&ContactState> {
        match self {
            Self::Steps(steps) => steps.states().collect(),
            Self::Cycles(cycles) => cycles.states().collect(),
        }
    }

    /// The largest approach (m) of them.
    fn approach(&self) -> f64 {
        let approaches = self.states().into_iter().map(|state| state.approach);
        approaches.fold(f64::NEG_INFINITY, f64::max)
    }

    /// Goes over to another frame.
    fn go(&mut self, to: &Moving<'_>) -> Result<(), Error> {
        match self {
            Self::Steps(steps) => steps.go(to)?,
            Self::Cycles(cycles) => cycles.go(to),
        }
        Ok(())
    }
}
