//! Motions that go through increments, once or in cycles: every cycle, or with jumps over most of them.

mod jump;
mod jump_control;
mod rubbing;
mod shifted;
mod solve;
mod spread;
mod touch;
mod unlike;

use std::collections::VecDeque;
use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::growth::Moved;
use super::march::SAME;
use super::{Effort, Error, Simulation};
use crate::motion::{Control, Guide, Shift, Station, Stepping};
use crate::numerics::vector::update;
use crate::problem::ContactState;
use crate::solve::monolithic;

use jump::{Rate, Wear};
use jump_control::{JumpControl, Tried};
use shifted::Shifted;
use solve::WarmStart;

/// Steps within a jump of fixed length, and the fewest in others.
const STEPS: usize = 4;
const FEWEST_STEPS: usize = 1;

/// A motion in increments.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct Cycles {
    position: Position,
    /// The cycle that is gone through.
    open: Option<Open>,
    /// The rate of wear of the cycle before, where jumps follow it.
    rate: Option<Rate>,
    jump_control: JumpControl,
    effort: Effort,
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
    reference: Option<Shifted>,
    /// The pressures (Pa) at the beginning, where that is the same instant of the cycle before.
    begun: Option<Vec<f64>>,
    /// What became of the last increment since the cycle before.
    change: Option<monolithic::Solution>,
}

/// Where a run has arrived.
#[derive(Debug, Clone, Serialize, Deserialize)]
struct Position {
    shifted: Shifted,
    /// The solutions of the last cycle, to start those of the next from.
    memory: Vec<Option<Arc<WarmStart>>>,
    /// Cycles done or jumped over.
    done: usize,
    /// Energy (J) dissipated in them.
    dissipated: f64,
}

/// A jump at one rate.
struct Foreseen {
    wear: Wear,
    steps: usize,
    /// Error that the steps make, relative to the wear made.
    lag: f64,
}

/// A jump, the cycles behind it and the jump once more with what the last of them shows.
struct Jumped {
    foreseen: Wear,
    /// The wear at which the last cycle begins, less what the one before wore.
    landed: Wear,
    corrected: Wear,
    next: Rate,
    /// The states of the last cycle.
    rows: Vec<Shown>,
    lag: f64,
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
        let evolution = &self.shifted.evolution;
        Wear {
            worn: evolution.state.worn.clone(),
            slid: evolution.state.slid.clone(),
            load_distance: evolution.load_distance,
            dissipated: self.dissipated,
        }
    }

    fn take(&mut self, wear: Wear) {
        let evolution = &mut self.shifted.evolution;
        (evolution.state.worn, evolution.load_distance) = (wear.worn, wear.load_distance);
        evolution.state.slid = wear.slid;
        self.dissipated = wear.dissipated;
    }
}

impl Setting<'_> {
    /// A station as a symmetric frame has it: nothing moves across a plane of symmetry, whatever the force on
    /// one side of it.
    fn symmetric(self, mut station: Station) -> Station {
        let mirrored = self.simulation.problem.frame.mirrored();
        for (guide, mirrored) in station.guides.iter_mut().zip(mirrored) {
            if mirrored {
                *guide = Guide::Shift(0.0);
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
        let Self { shifted, dissipated, .. } = self;
        effort.load_distance = shifted.evolution.load_distance;
        effort.dissipated = [shifted.rubbed.dissipated, *dissipated];
        Shown { state: shifted.evolution.state.clone(), control, effort: *effort }
    }
}

impl Cycles {
    /// The bodies at rest, or where the first cycle begins.
    pub fn begin(setting: Setting<'_>) -> Result<Self, Error> {
        let Setting { simulation, shift } = setting;
        let mut effort = Effort::default();
        let mut position = Position {
            shifted: Shifted::new(&simulation.problem),
            memory: vec![None; shift.cycle.len()],
            done: 0,
            dissipated: 0.0,
        };
        let problem = &simulation.problem;
        let pressing_rubs = problem.friction.is_some()
            && (problem.compliance.couples() || !problem.frame.is_plane());
        for station in shift.lead(pressing_rubs) {
            let at = (setting.symmetric(*station), 0.0);
            position.shifted.increment(simulation, at, None, &mut effort)?;
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

    /// The same in a larger frame. The solutions of the last cycle are not taken along, nor is its rate of wear.
    pub fn moved(&self, moved: &Moved<'_>, mut effort: Effort) -> Self {
        let shifted = self.position.shifted.moved(moved, &mut effort);
        let memory = vec![None; self.position.memory.len()];
        let open = self.open.as_ref().map(|open| Open {
            index: open.index,
            reference: open.reference.as_ref().map(|own| own.moved(moved, &mut effort)),
            begun: open.begun.as_ref().map(|pressure| moved.field(pressure)),
            change: None,
        });
        let shown = |shown: &Shown| Shown { state: moved.state(&shown.state), ..shown.clone() };
        Self {
            position: Position {
                shifted,
                memory,
                done: self.position.done,
                dissipated: self.position.dissipated,
            },
            open,
            rate: None,
            jump_control: self.jump_control,
            effort,
            shown: shown(&self.shown),
            waiting: self.waiting.iter().map(shown).collect(),
        }
    }

    /// The state to show.
    pub fn shown(&self) -> &Shown {
        &self.shown
    }

    /// What the run took so far.
    pub fn effort(&self) -> Effort {
        self.effort
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

    /// Jumps towards the next output, so many cycles ahead, if jumps are asked for and a cycle shows the rate.
    fn jump_on(&mut self, setting: Setting<'_>, ahead: usize) -> Result<(), Error> {
        let Some(rate) = self.rate.take() else { return Ok(()) };
        // The first cycle comes from the rest: what it rubs is not what the next ones do.
        if self.position.done == 1 && !setting.shift.released {
            return Ok(());
        }
        match setting.simulation.schedule.stepping {
            Stepping::Jumps(every) => {
                // Every so many cycles one is computed, and those that end at an output.
                let length = (every - 1).min(ahead.saturating_sub(1));
                if length > 0 {
                    let start = self.position.wear();
                    let wear = self.jump(setting, [&rate, &rate], &start, (length, STEPS))?;
                    self.land(setting, wear, length)?;
                }
                Ok(())
            }
            Stepping::Tolerance(_) => self.jump_by_error(setting, rate, ahead),
            Stepping::Implicit(_) | Stepping::Explicit(_) | Stepping::ToOutputs => Ok(()),
        }
    }

    /// Jumps over cycles whose number is chosen by the error they make, and goes through those behind.
    fn jump_by_error(
        &mut self,
        setting: Setting<'_>,
        rate: Rate,
        ahead: usize,
    ) -> Result<(), Error> {
        loop {
            let before = self.position.clone();
            let steps_before = self.effort.steps;
            let start = before.wear();
            let length = self.jump_control.jump(ahead);
            let Jumped { foreseen, landed, corrected, next, mut rows, lag } =
                match self.jump_and_compute(setting, &rate, &start, length) {
                    Ok(jumped) => jumped,
                    // Too far on: shorter jumps are tried before the run is given up.
                    Err(error) if error.is_of_length() && length > 0 => {
                        self.effort.steps = steps_before;
                        (self.position, self.open) = (before, None);
                        self.effort.rejected += 1;
                        self.jump_control.shorten(length);
                        continue;
                    }
                    Err(error) => return Err(error),
                };
            let stuck = [&rate.stuck[..], &next.stuck];
            let [off, flipped] = corrected.since(&foreseen, stuck);
            let made = corrected.norm_since(&start);
            let sticks = stuck.map(|stuck| stuck.iter().any(|&stuck| stuck > 0.0));
            let turned = sticks[0] != sticks[1];
            let (done, worn) = (before.done, corrected.total());
            let tried = Tried { length, made, off, flipped, worn, lag, turned, done };
            if !self.jump_control.judge(tried) {
                self.effort.steps = steps_before;
                self.position = before;
                self.effort.rejected += 1;
                continue;
            }
            self.correct(&landed, &corrected, &mut rows);
            self.effort.time_error = Some(self.jump_control.estimate(self.position.wear().total()));
            rows.iter_mut().for_each(|row| row.effort.time_error = self.effort.time_error);
            self.waiting = rows.into();
            self.rate = Some(next);
            return Ok(());
        }
    }

    /// Jumps at a rate, goes through the cycles behind the jump, and takes the jump again with both rates.
    fn jump_and_compute(
        &mut self,
        setting: Setting<'_>,
        rate: &Rate,
        start: &Wear,
        length: usize,
    ) -> Result<Jumped, Error> {
        // Tractions remember what was before the jump: they settle in a first cycle behind it, which also tells most of how
        // the rate has changed.
        let settles = length > 1 && !setting.shift.released;
        let length = length - usize::from(settles);
        let Foreseen { wear: foreseen, steps, lag } = self.foresee(setting, rate, start, length)?;
        self.land(setting, foreseen.clone(), length)?;
        let mut landed = foreseen.clone();
        if settles {
            let (settling, _) = self.cycle(setting)?;
            landed = self.jump(setting, [rate, &settling], start, (length, steps))?;
            self.correct(&foreseen, &landed, &mut []);
            self.adapt(setting)?;
        }
        let (next, rows) = self.cycle(setting)?;
        let corrected = match length {
            0 => foreseen.clone(),
            _ => self.jump(setting, [rate, &next], start, (length, steps))?,
        };
        Ok(Jumped { foreseen, landed, corrected, next, rows, lag })
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
        let shifted = &mut self.position.shifted;
        let fresh = self.position.done == 1 && shift.lead.is_empty();
        if shift.released && !fresh {
            shifted.release(&simulation.problem);
        }
        if !fresh {
            shifted.begin_cycle();
        }
        let comparable = shift.peak() == shift.cycle.len() - 1 && !shift.released;
        let begun = comparable.then(|| shifted.evolution.state.pressure.clone());
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
        let Position { shifted, memory, done, dissipated } = &mut self.position;
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
        let at = (station, progress);
        let warm_start = shifted.increment(simulation, at, known.as_deref(), &mut self.effort)?;
        open.change = known.and_then(|known| known.change_to(&warm_start));
        memory[index] = Some(Arc::new(warm_start));
        let jumps = !matches!(simulation.schedule.stepping, Stepping::Implicit(_));
        if jumps && index == shift.peak() {
            open.reference = Some(shifted.clone());
        }
        self.effort.steps += 1;
        open.index += 1;
        if index == last {
            shifted.end_cycle(&simulation.problem);
            *dissipated += shifted.rubbed.dissipated;
            if jumps {
                let reference = open.reference.take().unwrap_or_else(|| shifted.clone());
                let control = shift.cycle[shift.peak()].control;
                let begun = open.begun.as_deref();
                self.rate = Some(Rate::of(
                    shifted,
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

    /// Wear after a number of cycles in a number of steps, the rate going from the first to the second.
    fn jump(
        &mut self,
        Setting { simulation, .. }: Setting<'_>,
        rates: [&Rate; 2],
        start: &Wear,
        length: (usize, usize),
    ) -> Result<Wear, Error> {
        rates[0].wear_on(rates[1], start, length, simulation, &mut self.effort)
    }

    /// Wear after a jump at one rate, in as many steps as the tolerance asks for. The error that the steps make is
    /// that by which half as many differ.
    fn foresee(
        &mut self,
        setting: Setting<'_>,
        rate: &Rate,
        start: &Wear,
        length: usize,
    ) -> Result<Foreseen, Error> {
        if length == 0 {
            return Ok(Foreseen { wear: start.clone(), steps: 1, lag: 0.0 });
        }
        let mut steps = FEWEST_STEPS;
        let mut coarse = self.jump(setting, [rate, rate], start, (length, steps))?;
        loop {
            steps *= 2;
            let wear = self.jump(setting, [rate, rate], start, (length, steps))?;
            let made = wear.norm_since(start);
            let lag = if made > 0.0 { wear.norm_since(&coarse) / made } else { 0.0 };
            if self.jump_control.resolves(lag, steps, [made, wear.total()]) {
                return Ok(Foreseen { wear, steps, lag });
            }
            coarse = wear;
        }
    }

    /// Goes on by a jump, and brings pressures and tractions to the wear as it is then.
    fn land(&mut self, setting: Setting<'_>, wear: Wear, length: usize) -> Result<(), Error> {
        self.position.done += length;
        self.position.take(wear);
        if length > 0 { self.adapt(setting) } else { Ok(()) }
    }

    /// Brings pressures and tractions to the wear, where they are those of the last cycle.
    fn adapt(&mut self, setting: Setting<'_>) -> Result<(), Error> {
        let Setting { simulation, shift } = setting;
        let (Some(station), false) = (shift.cycle.last(), shift.released) else { return Ok(()) };
        let at = (setting.symmetric(*station), self.position.done as f64 * shift.period());
        self.position.shifted.solve_increment(simulation, at, None, &mut self.effort)?;
        Ok(())
    }

    /// Puts the corrected wear of a jump in the place of the foreseen one.
    fn correct(&mut self, foreseen: &Wear, corrected: &Wear, rows: &mut [Shown]) {
        let further = corrected.load_distance - foreseen.load_distance;
        let dissipated = corrected.dissipated - foreseen.dissipated;
        let states = rows.iter_mut().map(|row| &mut row.state);
        for state in states.chain([&mut self.position.shifted.evolution.state]) {
            for (body, worn) in state.worn.iter_mut().enumerate() {
                let change = [&corrected.worn[body], &foreseen.worn[body]];
                update(worn, [change[0], change[1]], |worn, [new, old]| worn + (new - old));
            }
            for (body, slid) in
                state.slid.iter_mut().enumerate().filter(|(_, slid)| !slid.is_empty())
            {
                let change = [&corrected.slid[body], &foreseen.slid[body]];
                update(slid, [change[0], change[1]], |slid, [new, old]| slid + (new - old));
            }
        }
        self.position.shifted.evolution.load_distance += further;
        self.position.dissipated += dissipated;
        for effort in rows.iter_mut().map(|row| &mut row.effort).chain([&mut self.effort]) {
            effort.load_distance += further;
            effort.dissipated[1] += dissipated;
        }
    }
}
