//! Motions that go through increments, once or in cycles: every cycle, or with jumps over most of them.

mod jump;
mod jump_control;
mod over;

use std::collections::VecDeque;
use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::advance::Scheme;
use super::effort::Effort;
use super::error::Error;
use super::moving::{Move, Moving};
use super::setup::{SAME, Simulation};
use super::shift::WarmStart;
use crate::motion::{Control, Drive, Shift, Station, Stepping};
use crate::problem::ContactState;
use crate::simulation::memory::{History, Increment};
use crate::solve::monolithic;

use jump::{Rate, Wear};
use jump_control::JumpControl;

/// A motion in increments.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct Cycles {
    position: Position,
    /// The cycle that is gone through.
    open: Option<Open>,
    /// The rate of wear of the cycle before, where jumps follow it.
    rate: Option<Rate>,
    jump_control: JumpControl,
    /// What the run took so far.
    pub effort: Effort,
    shown: Shown,
    /// States behind a jump that are to be shown.
    waiting: VecDeque<Shown>,
}

/// What the increments of a motion go by.
#[derive(Clone, Copy)]
pub(super) struct Setting<'a> {
    pub simulation: &'a Simulation,
    pub shift: &'a Shift,
}

/// A cycle under way.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
struct Open {
    /// Increments done.
    index: usize,
    /// The bodies at the most pressed instant.
    reference: Option<History>,
    /// The pressures (Pa) at the beginning, where that is the same instant of the cycle before.
    begun: Option<Vec<f64>>,
    /// What became of the last increment since the cycle before.
    change: Option<monolithic::Solution>,
}

/// Where a run has arrived.
#[derive(Debug, Clone, Serialize, Deserialize)]
struct Position {
    history: History,
    /// The solutions of the last cycle, to start those of the next from.
    memory: Vec<Option<Arc<WarmStart>>>,
    /// Cycles done or jumped over.
    done: usize,
}

/// A state on the way, with what it took.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct Shown {
    pub state: ContactState,
    pub control: Control,
    pub effort: Effort,
}

impl Position {
    fn wear(&self) -> Wear {
        let History { state, load_distance, dissipated, .. } = &self.history;
        Wear {
            surfaces: state.surfaces.clone(),
            load_distance: *load_distance,
            dissipated: *dissipated,
        }
    }

    fn take(&mut self, wear: Wear) {
        let Wear { surfaces, load_distance, dissipated } = wear;
        self.history.state.surfaces = surfaces;
        (self.history.load_distance, self.history.dissipated) = (load_distance, dissipated);
    }
}

impl Setting<'_> {
    /// A station as a symmetric frame has it: nothing moves across a plane of symmetry, whatever the force on
    /// one side of it.
    fn symmetric(self, mut station: Station) -> Station {
        let mirrored = self.simulation.problem.frame.mirrored();
        for (guide, mirrored) in station.guides.iter_mut().zip(mirrored) {
            if mirrored {
                *guide = Drive::Slip(0.0);
            }
        }
        station
    }

    /// Cycles up to a place of the motion.
    fn cycles_to(self, place: f64) -> usize {
        (place / self.shift.period() - SAME).ceil().max(0.0) as usize
    }

    /// Cycles in all.
    fn total(self) -> usize {
        (self.simulation.schedule.extent / self.shift.period()).round().max(1.0) as usize
    }
}

impl Position {
    fn shown(&self, control: Control, effort: &mut Effort) -> Shown {
        let History { state, rubbed, load_distance, dissipated, .. } = &self.history;
        effort.load_distance = *load_distance;
        effort.dissipated = [rubbed.dissipated, *dissipated];
        Shown { state: state.clone(), control, effort: *effort }
    }
}

impl Cycles {
    /// The bodies at rest, or where the first cycle begins.
    pub fn begin(setting: Setting<'_>) -> Result<Self, Error> {
        let Setting { simulation, shift } = setting;
        let mut effort = Effort::default();
        let mut position = Position {
            history: History::untouched(&simulation.problem),
            memory: vec![None; shift.cycle.len()],
            done: 0,
        };
        let problem = &simulation.problem;
        let pressing_rubs = problem.friction.is_some()
            && (problem.compliance.couples() || !problem.frame.is_plane());
        for station in shift.lead(pressing_rubs) {
            let station = setting.symmetric(*station);
            let increment = Increment { advance: 0.0, progress: 0.0, control: station.control };
            let scheme = Scheme::Between(station, None);
            position.history.advance(simulation, increment, scheme, &mut effort)?;
        }
        let control = shift.lead.last().map_or(Control::Load(0.0), |station| station.control);
        let tolerance = match simulation.schedule.stepping {
            Stepping::Tolerance(tolerance) => tolerance,
            _ => 0.0,
        };
        Ok(Self {
            shown: position.shown(control, &mut effort),
            position,
            open: None,
            rate: None,
            jump_control: JumpControl::new(tolerance),
            effort,
            waiting: VecDeque::new(),
        })
    }

    /// The states found since the last one that was shown, and that one.
    pub fn states(&self) -> impl Iterator<Item = &ContactState> {
        self.waiting.iter().chain([&self.shown]).map(|shown| &shown.state)
    }

    /// Goes over to a larger frame. The solutions of the last cycle are not taken along, nor is its rate of wear.
    pub fn go(&mut self, to: &Moving<'_>) {
        let Self { position, open, effort, .. } = self;
        position.history = position.history.strained(to, effort);
        position.memory.fill(None);
        if let Some(open) = open {
            open.reference = open.reference.as_ref().map(|own| own.strained(to, effort));
            (open.begun, open.change) = (open.begun.moved(to), None);
        }
        self.rate = None;
        for shown in self.waiting.iter_mut().chain([&mut self.shown]) {
            shown.state = shown.state.moved(to);
        }
    }

    /// The state to show.
    pub fn shown(&self) -> &Shown {
        &self.shown
    }

    /// Goes on to the next state, in jumps up to a place where fields are due; whether there was one.
    pub fn step(&mut self, setting: Setting<'_>, next: f64) -> Result<bool, Error> {
        if self.waiting.is_empty() {
            if self.open.is_none() {
                if self.position.done >= setting.total() {
                    return Ok(false);
                }
                let ahead = setting.cycles_to(next).min(setting.total());
                self.jump_on(setting, ahead.saturating_sub(self.position.done))?;
            }
            if self.waiting.is_empty() {
                let shown = self.increment(setting)?;
                self.waiting.push_back(shown);
            }
        }
        let shown = self.waiting.pop_front();
        Ok(shown.map(|shown| self.shown = shown).is_some())
    }

    /// Goes through a cycle, which gives its rate of wear and the states in it.
    fn cycle(&mut self, setting: Setting<'_>) -> Result<(Rate, Vec<Shown>), Error> {
        let mut rows = vec![];
        loop {
            rows.push(self.increment(setting)?);
            if let Some(rate) = self.rate.take() {
                return Ok((rate, rows));
            }
        }
    }

    /// Begins a cycle.
    fn open(&mut self, Setting { simulation, shift }: Setting<'_>) -> Open {
        self.position.done += 1;
        self.effort.true_cycles += 1;
        let history = &mut self.position.history;
        let fresh = self.position.done == 1 && shift.lead.is_empty();
        if shift.released && !fresh {
            history.release(&simulation.problem);
        }
        if !fresh {
            history.begin_cycle();
        }
        let comparable = shift.peak() == shift.cycle.len() - 1 && !shift.released;
        let begun = comparable.then(|| history.state.pressure.clone());
        Open { begun, ..Open::default() }
    }

    /// Goes on by an increment of the cycle under way, or of the next. Its end gives the rate of wear.
    fn increment(&mut self, setting: Setting<'_>) -> Result<Shown, Error> {
        let Setting { simulation, shift } = setting;
        let mut open = match self.open.take() {
            Some(open) => open,
            None => self.open(setting),
        };
        let (index, last) = (open.index, shift.cycle.len() - 1);
        let station = setting.symmetric(shift.cycle[index]);
        let Position { history, memory, done } = &mut self.position;
        self.effort.iterations = 0;
        let progress = if index == last {
            *done as f64 * shift.period()
        } else {
            (*done - 1) as f64 * shift.period() + shift.places[index]
        };
        let mut known = memory[index].take();
        if let (Some(known), Some(change)) = (&mut known, &open.change) {
            Arc::make_mut(known).foresee(change);
        }
        let increment = Increment { advance: 0.0, progress, control: station.control };
        let scheme = Scheme::Between(station, known.as_deref());
        let found = history.advance(simulation, increment, scheme, &mut self.effort)?;
        open.change = known.zip(found.as_ref()).and_then(|(known, found)| known.change_to(found));
        memory[index] = found.map(Arc::new);
        let jumps = !matches!(simulation.schedule.stepping, Stepping::Implicit(_));
        if jumps && index == shift.peak() {
            open.reference = Some(history.clone());
        }
        self.effort.steps += 1;
        open.index += 1;
        if index == last {
            history.end_cycle(&simulation.problem);
            if jumps {
                let reference = open.reference.take().unwrap_or_else(|| history.clone());
                let control = shift.cycle[shift.peak()].control;
                let begun = open.begun.as_deref();
                self.rate = Some(Rate::of(
                    history,
                    reference,
                    (*done, begun),
                    control,
                    &simulation.problem,
                ));
            }
        } else {
            self.open = Some(open);
        }
        Ok(self.position.shown(station.control, &mut self.effort))
    }
}
