//! The loop over the steps of a motion, and the frames that it goes through.

use serde::{Deserialize, Serialize};

use super::checkpoint::digest;
use super::cycles::{Cycles, Setting};
use super::growth::{Growth, Moved};
use super::steps::Steps;
use super::surroundings::More;
use super::wider::Wider;
use super::{Effort, Error, Report, Simulation};
use crate::motion::Motion;
use crate::problem::ContactState;

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
    /// What became of the last frame, where the contact came to its rim.
    growth: Option<Growth>,
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

impl March {
    /// The initial contact; bodies that are pressed together later only touch.
    pub(super) fn begin(simulation: &Simulation) -> Result<Self, Error> {
        for one in simulation.frames() {
            one.problem.fits()?;
        }
        let (mut first, mut behind) = (simulation, 0);
        let mut growth: Option<Growth> = None;
        loop {
            let grown = growth.as_ref().and_then(|growth| growth.simulation(first));
            let present = grown.as_deref().unwrap_or(first);
            let stepper = Stepper::begin(present);
            let missed = match &stepper {
                Ok(stepper) => stepper.missed(present),
                Err(error) => all_touches(error, present),
            };
            if let (Some(_), Some(wider)) = (missed, &first.wider) {
                (first, behind) = (&wider.simulation, behind + 1);
                continue;
            }
            let larger = missed.map(|more| Growth::by(first, growth.as_ref(), (more, 0.0)));
            let Some(larger) = larger.transpose()?.flatten() else {
                let (digest, stepper) = (digest(simulation), stepper?);
                return Ok(Self { digest, stepper, behind, growth, past: 0, output: true });
            };
            growth = Some(larger);
        }
    }

    /// Goes on to the next state that is shown; whether there was one.
    pub(super) fn step(&mut self, simulation: &Simulation) -> Result<bool, Error> {
        self.widen(simulation)?;
        let schedule = &simulation.schedule;
        let next = schedule.outputs.get(self.past).copied().unwrap_or(schedule.extent);
        let next = next.min(schedule.extent);
        let went = loop {
            let first = self.first(simulation);
            let grown = self.growth.as_ref().and_then(|growth| growth.simulation(first));
            let present = grown.as_deref().unwrap_or(first);
            let before = present.surroundings().grow().then(|| self.stepper.clone());
            let went = self.stepper.step(present, next);
            let Some(before) = before else { break went? };
            let missed = match &went {
                Ok(true) => self.stepper.missed(present),
                Ok(false) => None,
                Err(error) => all_touches(error, present),
            };
            if let (Some(_), Some(Wider { simulation: wider, .. })) =
                (missed, first.wider.as_deref())
            {
                self.stepper = before;
                self.go_over(first, wider)?;
                continue;
            }
            let at = self.state().progress;
            let larger = missed.map(|more| Growth::by(first, self.growth.as_ref(), (more, at)));
            let Some(larger) = larger.transpose()?.flatten() else { break went? };
            let Some(larger_simulation) = larger.simulation(first) else { break went? };
            let problems = [&present.problem, &larger_simulation.problem];
            let moved = larger.from(self.growth.as_ref(), problems);
            self.stepper = before.moved(&moved, &larger_simulation, self.stepper.effort());
            self.growth = Some(larger);
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

    /// The simulation in the frame that the run went over to last, as it was before it grew.
    fn first<'a>(&self, simulation: &'a Simulation) -> &'a Simulation {
        simulation.frames().nth(self.behind).unwrap_or(simulation)
    }

    /// The simulation in the frame that the run is in.
    fn present<'a>(&'a self, simulation: &'a Simulation) -> &'a Simulation {
        let first = self.first(simulation);
        self.growth.as_ref().and_then(|growth| growth.present(first)).unwrap_or(first)
    }

    /// Whether the frame that the run is in can be made.
    pub(super) fn can_go_on(&self, simulation: &Simulation) -> bool {
        let first = self.first(simulation);
        self.growth.as_ref().is_none_or(|growth| growth.simulation(first).is_some())
    }

    /// Goes over to wider frames where it is time to.
    fn widen(&mut self, simulation: &Simulation) -> Result<(), Error> {
        let margin = SAME * simulation.schedule.extent;
        while let first = self.first(simulation)
            && let Some(Wider { from, simulation: wider }) = first.wider.as_deref()
            && self.state().progress >= from - margin
        {
            self.go_over(first, wider)?;
        }
        Ok(())
    }

    /// Goes over to a wider frame.
    fn go_over(&mut self, from: &Simulation, to: &Simulation) -> Result<(), Error> {
        if let Stepper::Steps(steps) = &mut self.stepper {
            steps.widen(&from.problem, to)?;
        }
        self.behind += 1;
        Ok(())
    }

    fn state(&self) -> &ContactState {
        match &self.stepper {
            Stepper::Steps(steps) => steps.state(),
            Stepper::Cycles(cycles) => &cycles.shown().state,
        }
    }

    /// What the run took, also after the last state shown.
    pub(super) fn effort(&self) -> Effort {
        self.stepper.effort()
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

/// As much more as holds a contact that filled its frame, or swung out of it.
fn all_touches(error: &Error, simulation: &Simulation) -> Option<More> {
    let full = matches!(error, Error::FrameFull { .. } | Error::SwungOut { .. });
    full.then(|| simulation.surroundings().twice(&simulation.problem)).flatten()
}

impl Stepper {
    fn begin(simulation: &Simulation) -> Result<Self, Error> {
        Ok(match &simulation.problem.motion {
            Motion::Shift(shift) => {
                Self::Cycles(Box::new(Cycles::begin(Setting { simulation, shift })?))
            }
            Motion::Sliding(_) | Motion::Rolling(_) => {
                Self::Steps(Box::new(Steps::begin(simulation)?))
            }
        })
    }

    /// Goes on to the next state, and not beyond a place; whether there was one.
    fn step(&mut self, simulation: &Simulation, next: f64) -> Result<bool, Error> {
        match (self, &simulation.problem.motion) {
            (Self::Steps(steps), _) => steps.step(simulation, next),
            (Self::Cycles(cycles), Motion::Shift(shift)) => {
                cycles.step(Setting { simulation, shift }, next)
            }
            (Self::Cycles(_), _) => Ok(false),
        }
    }

    fn effort(&self) -> Effort {
        match self {
            Self::Steps(steps) => steps.effort,
            Self::Cycles(cycles) => cycles.effort(),
        }
    }

    /// What the frame is too small by for the contact of the states that it has come to.
    fn missed(&self, simulation: &Simulation) -> Option<More> {
        let (surroundings, problem) = (simulation.surroundings(), &simulation.problem);
        if !surroundings.grow() {
            return None;
        }
        let of = |state: &ContactState| surroundings.missed(problem, state);
        let all = |one: More, other: More| {
            [0, 1].map(|axis| [0, 1].map(|side| one[axis][side].max(other[axis][side])))
        };
        match self {
            Self::Steps(steps) => steps.contacts().filter_map(of).reduce(all),
            Self::Cycles(cycles) => cycles.states().filter_map(of).reduce(all),
        }
    }

    /// The same in a larger frame, after an attempt that took so much.
    fn moved(&self, moved: &Moved<'_>, simulation: &Simulation, took: Effort) -> Self {
        let Effort { solves, applications, .. } = took;
        let of = |effort: Effort| Effort { solves, applications, ..effort };
        match self {
            Self::Steps(steps) => {
                let mut steps = steps.moved(moved, simulation);
                steps.effort = of(steps.effort);
                Self::Steps(Box::new(steps))
            }
            Self::Cycles(cycles) => {
                Self::Cycles(Box::new(cycles.moved(moved, of(cycles.effort()))))
            }
        }
    }
}
