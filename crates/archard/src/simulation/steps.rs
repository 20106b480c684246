//! A motion in steps of wear, of a given length or by error.

use serde::{Deserialize, Serialize};

use super::adaptive::Adaptive;
use super::evolution::{Evolution, Increment};
use super::growth::Moved;
use super::march::SAME;
use super::window::Window;
use super::{Effort, Error, Simulation};
use crate::motion::Stepping;
use crate::problem::{ContactProblem, ContactState, Surface};

/// A motion in steps of wear.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct Steps {
    histories: Histories,
    /// Where they live, if not in the whole frame; and the present state in it then.
    window: Option<(Window, ContactState)>,
    pub effort: Effort,
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

impl Steps {
    /// The initial contact.
    pub fn begin(simulation: &Simulation) -> Result<Self, Error> {
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
    pub fn moved(&self, moved: &Moved<'_>, simulation: &Simulation) -> Self {
        let mut within = self.clone();
        within.leave_window(moved.smaller());
        let histories = within
            .histories
            .moved(|history| moved.history(history), |surfaces| moved.surfaces(surfaces));
        Self { histories, window: None, effort: self.effort }.in_a_window(simulation)
    }

    /// The contacts that were found: in the frame where there is no window, which holds them otherwise.
    pub fn contacts(&self) -> impl Iterator<Item = &ContactState> {
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
        self.histories = self.histories.moved(
            |history| window.cut_history(history),
            |surfaces| surfaces.each_ref().map(|one| window.cut_surface(one)),
        );
        self.window = Some((window, shown));
    }

    /// Brings histories in a window back to the frame; returns the window.
    fn leave_window(&mut self, problem: &ContactProblem) -> Option<Window> {
        let (window, _) = self.window.take()?;
        self.histories = self.histories.moved(
            |history| window.put_history(history, &problem.frame),
            |surfaces| surfaces.each_ref().map(|one| window.put_surface(one)),
        );
        Some(window)
    }

    /// Takes a larger window, or the frame.
    fn grow(&mut self, simulation: &Simulation) {
        let Some(window) = self.leave_window(&simulation.problem) else { return };
        self.move_to(window.larger(simulation, self.histories.approach()));
    }

    /// The present state in the whole frame.
    pub fn state(&self) -> &ContactState {
        self.window.as_ref().map_or(&self.histories.evolution.state, |(_, shown)| shown)
    }

    /// Goes over from the frame of a problem to a wider one.
    pub fn widen(&mut self, from: &ContactProblem, to: &Simulation) -> Result<(), Error> {
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
    pub fn step(&mut self, simulation: &Simulation, next: f64) -> Result<bool, Error> {
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
        surfaces: impl Fn(&[Surface; 2]) -> [Surface; 2],
    ) -> Self {
        Self {
            evolution: history(&self.evolution),
            adaptive: self.adaptive.as_ref().map(|adaptive| adaptive.moved(history, surfaces)),
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
