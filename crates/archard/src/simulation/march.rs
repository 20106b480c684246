//! The loop over the steps of a motion.

use serde::{Deserialize, Serialize};

use super::adaptive::Adaptive;
use super::checkpoint::digest;
use super::cycles::{Cycles, Setting};
use super::evolution::{Evolution, Increment};
use super::growth::{Growth, Moved};
use super::surroundings::More;
use super::wider::Wider;
use super::window::Window;
use super::{Effort, Error, Report, Simulation};
use crate::motion::{Motion, Stepping};
use crate::problem::{ContactProblem, ContactState, Swung};

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

    /// The same in a larger frame.
    fn moved(&self, moved: &Moved<'_>, simulation: &Simulation) -> Self {
        let mut within = self.clone();
        within.leave_window(moved.smaller());
        let histories = within.histories.moved(
            |history| moved.history(history),
            |worn| moved.of_bodies(worn),
            |swung| moved.swung(swung),
        );
        Self { histories, window: None, effort: self.effort }.in_a_window(simulation)
    }

    /// The contacts that were found: in the frame where there is no window, which holds them otherwise.
    fn contacts(&self) -> impl Iterator<Item = &ContactState> {
        let Histories { evolution, adaptive } = &self.histories;
        let both = adaptive.iter().flat_map(Adaptive::histories).map(|history| &history.state);
        let all = both.chain([&evolution.state]);
        let within = self.window.is_some();
        all.filter(move |_| !within).chain(self.window.iter().map(|(_, shown)| shown))
    }

    /// Brings histories in the frame to a window.
    fn move_to(&mut self, window: Option<Window>) {
        let Some(window) = window else { return };
        let shown = self.histories.evolution.state.clone();
        let field = |field: &[f64]| window.cut(field);
        self.histories = self.histories.moved(
            |history| window.cut_history(history),
            |worn| worn.each_ref().map(|worn| field(worn)),
            |_| None,
        );
        self.window = Some((window, shown));
    }

    /// Brings histories in a window back to the frame; returns the window.
    fn leave_window(&mut self, problem: &ContactProblem) -> Option<Window> {
        let (window, _) = self.window.take()?;
        let field = |field: &[f64]| window.put(field);
        let history = |history: &Evolution| window.put_history(history, &problem.frame);
        let worn = |worn: &[Vec<f64>; 2]| worn.each_ref().map(|worn| field(worn));
        self.histories = self.histories.moved(history, worn, |_| None);
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

    /// The same in another frame: see [`Adaptive::moved`].
    fn moved(
        &self,
        history: impl Fn(&Evolution) -> Evolution,
        worn: impl Fn(&[Vec<f64>; 2]) -> [Vec<f64>; 2],
        swung: impl Fn(&Swung) -> Option<Swung>,
    ) -> Self {
        Self {
            evolution: history(&self.evolution),
            adaptive: self.adaptive.as_ref().map(|adaptive| adaptive.moved(history, worn, swung)),
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
