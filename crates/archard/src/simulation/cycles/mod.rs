//! Motions that go through increments, once or in cycles: every cycle, or with jumps over most of them.

mod jump;
mod rig;
mod rubbing;
mod settle;
mod spread;
mod stride;
mod touch;
mod unlike;

use super::{Effort, Error, Observer, Report, Simulation};
use crate::motion::{Control, Guide, Shift, Station, Stepping};
use crate::numerics::vector::update;
use crate::problem::ContactState;

use jump::{Rate, Wear};
use rig::Rig;
use settle::Settled;
use stride::{Stride, Tried};

/// Two values of progress closer than this, relative to the extent, are the same.
const SAME: f64 = 1e-9;
/// Steps within a jump of fixed length, and the fewest in others.
const STEPS: usize = 8;
const FEWEST_STEPS: usize = 2;

/// A run under way.
pub(super) struct Cycles<'a> {
    simulation: &'a Simulation,
    shift: &'a Shift,
    position: Position,
    effort: Effort,
    total: usize,
    /// Outputs that are still due.
    due: &'a [f64],
}

/// Where a run has arrived.
#[derive(Clone)]
struct Position {
    rig: Rig,
    /// The solutions of the last cycle, to start those of the next from.
    memory: Vec<Option<Settled>>,
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

/// A jump, the cycle behind it and the jump once more with what that cycle shows.
struct Jumped {
    foreseen: Wear,
    corrected: Wear,
    next: Rate,
    /// The states of the cycle.
    rows: Vec<Shown>,
    lag: f64,
}

/// A state on the way, with what it took.
struct Shown {
    state: ContactState,
    control: Control,
    effort: Effort,
}

impl Position {
    fn wear(&self) -> Wear {
        let chain = &self.rig.chain;
        Wear {
            worn: chain.state.worn.clone(),
            load_distance: chain.load_distance,
            dissipated: self.dissipated,
        }
    }

    fn take(&mut self, wear: Wear) {
        let chain = &mut self.rig.chain;
        (chain.state.worn, chain.load_distance) = (wear.worn, wear.load_distance);
        self.dissipated = wear.dissipated;
    }
}

impl<'a> Cycles<'a> {
    pub fn new(simulation: &'a Simulation, shift: &'a Shift) -> Self {
        let total = (simulation.schedule.extent / shift.period()).round().max(1.0);
        Self {
            simulation,
            shift,
            position: Position {
                rig: Rig::new(&simulation.problem),
                memory: vec![None; shift.cycle.len()],
                done: 0,
                dissipated: 0.0,
            },
            effort: Effort::default(),
            total: total as usize,
            due: &simulation.schedule.outputs,
        }
    }

    /// Carries the motion through.
    pub fn run(mut self, observers: &mut [&mut dyn Observer]) -> Result<Effort, Error> {
        let Self { simulation, shift, .. } = self;
        for station in &shift.lead {
            let at = (self.symmetric(*station), 0.0);
            self.position.rig.increment(simulation, at, None, &mut self.effort)?;
        }
        let control = shift.lead.last().map_or(Control::Load(0.0), |station| station.control);
        let begun = self.shown(control);
        self.show(&begun, true, observers)?;
        match simulation.schedule.stepping {
            Stepping::Jumps(every) => self.by_fixed_jumps(every, observers)?,
            Stepping::Tolerance(tolerance) => self.by_error(tolerance, observers)?,
            Stepping::Implicit(_) | Stepping::Explicit(_) => {
                while self.position.done < self.total {
                    self.cycle(&mut |cycles, shown| cycles.put_out(&shown, observers))?;
                }
            }
        }
        Ok(self.effort)
    }

    /// Every so many cycles one is computed, and those that end at an output.
    fn by_fixed_jumps(
        &mut self,
        every: usize,
        observers: &mut [&mut dyn Observer],
    ) -> Result<(), Error> {
        while self.position.done < self.total {
            let rate = self.cycle(&mut |cycles, shown| cycles.put_out(&shown, observers))?;
            let length = (every - 1).min(self.ahead().saturating_sub(1));
            if length > 0 {
                let start = self.position.wear();
                let wear = self.jump([&rate, &rate], &start, (length, STEPS))?;
                self.land(wear, length)?;
            }
        }
        Ok(())
    }

    /// Jumps over cycles whose number is chosen by the error they make.
    fn by_error(
        &mut self,
        tolerance: f64,
        observers: &mut [&mut dyn Observer],
    ) -> Result<(), Error> {
        let mut stride = Stride::new(tolerance);
        let mut rate = self.cycle(&mut |cycles, shown| cycles.put_out(&shown, observers))?;
        while self.position.done < self.total {
            let before = self.position.clone();
            let steps_before = self.effort.steps;
            let start = before.wear();
            let length = stride.jump(self.ahead());
            let Jumped { foreseen, corrected, next, mut rows, lag } =
                match self.jump_and_compute(&rate, &start, length, &stride) {
                    Ok(jumped) => jumped,
                    // Too far on: shorter jumps are tried before the run is given up.
                    Err(error) if error.is_of_length() && length > 0 => {
                        self.effort.steps = steps_before;
                        self.position = before;
                        self.effort.rejected += 1;
                        stride.shorten(length);
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
            if !stride.judge(tried) {
                self.effort.steps = steps_before;
                self.position = before;
                self.effort.rejected += 1;
                continue;
            }
            self.correct(&foreseen, &corrected, &mut rows);
            self.effort.time_error = Some(stride.estimate(self.position.wear().total()));
            for mut row in rows {
                row.effort.time_error = self.effort.time_error;
                self.put_out(&row, observers)?;
            }
            rate = next;
        }
        Ok(())
    }

    /// Jumps at a rate, goes through the cycle behind the jump, and takes the jump again with both rates.
    fn jump_and_compute(
        &mut self,
        rate: &Rate,
        start: &Wear,
        length: usize,
        stride: &Stride,
    ) -> Result<Jumped, Error> {
        let Foreseen { wear: foreseen, steps, lag } = self.foresee(rate, start, length, stride)?;
        self.land(foreseen.clone(), length)?;
        let mut rows = vec![];
        let next = self.cycle(&mut |_, shown| {
            rows.push(shown);
            Ok(())
        })?;
        let corrected = match length {
            0 => foreseen.clone(),
            _ => self.jump([rate, &next], start, (length, steps))?,
        };
        Ok(Jumped { foreseen, corrected, next, rows, lag })
    }

    /// Goes through a cycle; its rate of wear.
    fn cycle(
        &mut self,
        show: &mut dyn FnMut(&mut Self, Shown) -> Result<(), Error>,
    ) -> Result<Rate, Error> {
        let Self { simulation, shift, .. } = *self;
        let (peak, last) = (shift.peak(), shift.cycle.len() - 1);
        let done = self.position.done;
        self.position.done += 1;
        self.effort.true_cycles += 1;
        if shift.released {
            self.position.rig.release(&simulation.problem);
        }
        self.position.rig.begin_cycle();
        let comparable = peak == last && !shift.released;
        let begun = comparable.then(|| self.position.rig.chain.state.pressure.clone());
        let (mut reference, mut change) = (None, None);
        for (index, station) in shift.cycle.iter().enumerate() {
            let station = self.symmetric(*station);
            let Position { rig, memory, .. } = &mut self.position;
            self.effort.iterations = 0;
            let progress = if index == last {
                (done + 1) as f64 * shift.period()
            } else {
                done as f64 * shift.period() + shift.places[index]
            };
            let mut known = memory[index].take();
            if let (Some(known), Some(change)) = (&mut known, &change) {
                known.foresee(change);
            }
            let at = (station, progress);
            let settled = rig.increment(simulation, at, known.as_ref(), &mut self.effort)?;
            change = known.and_then(|known| known.change_to(&settled));
            memory[index] = Some(settled);
            if index == peak {
                reference = Some(rig.clone());
            }
            if index == last {
                self.position.dissipated += rig.rubbed.dissipated;
            }
            self.effort.steps += 1;
            let shown = self.shown(station.control);
            show(self, shown)?;
        }
        let rig = &self.position.rig;
        let reference = reference.unwrap_or_else(|| rig.clone());
        let control = shift.cycle[peak].control;
        Ok(Rate::of(rig, reference, begun.as_deref(), control, &simulation.problem))
    }

    /// A station as a symmetric frame has it: nothing moves across a plane of symmetry, whatever the force on
    /// one side of it.
    fn symmetric(&self, mut station: Station) -> Station {
        let mirrored = self.simulation.problem.frame.mirrored();
        for (guide, mirrored) in station.guides.iter_mut().zip(mirrored) {
            if mirrored {
                *guide = Guide::Shift(0.0);
            }
        }
        station
    }

    /// Cycles up to the next output, or to the end.
    fn ahead(&self) -> usize {
        let cycle = |place: f64| (place / self.shift.period() - SAME).ceil().max(0.0) as usize;
        let next = self.due.first().map_or(self.total, |&place| cycle(place).min(self.total));
        next.saturating_sub(self.position.done)
    }

    /// Wear after a number of cycles in a number of steps, the rate going from the first to the second.
    fn jump(
        &mut self,
        rates: [&Rate; 2],
        start: &Wear,
        length: (usize, usize),
    ) -> Result<Wear, Error> {
        rates[0].wear_on(rates[1], start, length, self.simulation, &mut self.effort)
    }

    /// Wear after a jump at one rate, in as many steps as the tolerance asks for. The error that the steps make is
    /// that by which half as many differ: implicit steps are of first order.
    fn foresee(
        &mut self,
        rate: &Rate,
        start: &Wear,
        length: usize,
        stride: &Stride,
    ) -> Result<Foreseen, Error> {
        if length == 0 {
            return Ok(Foreseen { wear: start.clone(), steps: 1, lag: 0.0 });
        }
        let mut steps = FEWEST_STEPS;
        let mut coarse = self.jump([rate, rate], start, (length, steps))?;
        loop {
            steps *= 2;
            let wear = self.jump([rate, rate], start, (length, steps))?;
            let made = wear.norm_since(start);
            let lag = if made > 0.0 { wear.norm_since(&coarse) / made } else { 0.0 };
            if stride.resolves(lag, steps) {
                return Ok(Foreseen { wear, steps, lag });
            }
            coarse = wear;
        }
    }

    /// Goes on by a jump, and brings pressures and tractions to the wear as it is then.
    fn land(&mut self, wear: Wear, length: usize) -> Result<(), Error> {
        self.position.done += length;
        self.position.take(wear);
        let (Some(station), false) = (self.shift.cycle.last(), self.shift.released || length == 0)
        else {
            return Ok(());
        };
        let at = (self.symmetric(*station), self.position.done as f64 * self.shift.period());
        self.position.rig.settle(self.simulation, at, None, &mut self.effort)?;
        Ok(())
    }

    /// Puts the corrected wear of a jump in the place of the foreseen one.
    fn correct(&mut self, foreseen: &Wear, corrected: &Wear, rows: &mut [Shown]) {
        let further = corrected.load_distance - foreseen.load_distance;
        let dissipated = corrected.dissipated - foreseen.dissipated;
        let states = rows.iter_mut().map(|row| &mut row.state);
        for state in states.chain([&mut self.position.rig.chain.state]) {
            for (body, worn) in state.worn.iter_mut().enumerate() {
                let change = [&corrected.worn[body], &foreseen.worn[body]];
                update(worn, [change[0], change[1]], |worn, [new, old]| worn + (new - old));
            }
        }
        self.position.rig.chain.load_distance += further;
        self.position.dissipated += dissipated;
        for effort in rows.iter_mut().map(|row| &mut row.effort).chain([&mut self.effort]) {
            effort.load_distance += further;
            effort.dissipated[1] += dissipated;
        }
    }

    /// The present state.
    fn shown(&mut self, control: Control) -> Shown {
        let Position { rig, dissipated, .. } = &self.position;
        self.effort.load_distance = rig.chain.load_distance;
        self.effort.dissipated = [rig.rubbed.dissipated, *dissipated];
        Shown { state: rig.chain.state.clone(), control, effort: self.effort }
    }

    /// Shows a state, with its fields if they are due.
    fn put_out(&mut self, shown: &Shown, observers: &mut [&mut dyn Observer]) -> Result<(), Error> {
        let (progress, extent) = (shown.state.progress, self.simulation.schedule.extent);
        let margin = SAME * extent;
        let mut output = extent - progress <= margin;
        while self.due.first().is_some_and(|&due| due <= progress + margin) {
            (self.due, output) = (&self.due[1..], true);
        }
        self.show(shown, output, observers)
    }

    fn show(
        &self,
        shown: &Shown,
        output: bool,
        observers: &mut [&mut dyn Observer],
    ) -> Result<(), Error> {
        let report = Report {
            problem: &self.simulation.problem,
            state: &shown.state,
            effort: shown.effort,
            output,
            extent: self.simulation.schedule.extent,
            prescribed: shown.control,
            stepping: self.simulation.schedule.stepping,
        };
        observers
            .iter_mut()
            .try_for_each(|observer| observer.observe(&report).map_err(Error::Observer))
    }
}
