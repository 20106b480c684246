//! Motions that go through increments, once or in cycles, every cycle or with jumps over most of them.

use super::jump::Rate;
use super::shift::{Rig, Settled};
use super::{Effort, Error, Observer, Report, Simulation};
use crate::kinematics::{Shift, Stepping};
use crate::problem::ContactState;

/// Two values of progress closer than this, relative to the extent, are the same.
const SAME: f64 = 1e-9;
/// Aim of the controller relative to the tolerance, and bounds on the change of a jump to the next.
const AIM: f64 = 0.8;
const CHANGE: (f64, f64) = (0.2, 2.0);

/// A run under way.
pub(super) struct Cycles<'a> {
    simulation: &'a Simulation,
    shift: &'a Shift,
    rig: Rig,
    /// The solutions of the last cycle.
    memory: Vec<Option<Settled>>,
    effort: Effort,
    /// Cycles done or jumped over, and how many there are in all.
    done: usize,
    total: usize,
    /// Outputs that are still due.
    due: &'a [f64],
}

/// A state on the way, to be shown once its cycle is accepted.
struct Shown {
    state: ContactState,
    effort: Effort,
}

impl<'a> Cycles<'a> {
    pub fn new(simulation: &'a Simulation, shift: &'a Shift) -> Self {
        let total = (simulation.schedule.extent / shift.period()).round().max(1.0);
        Self {
            simulation,
            shift,
            rig: Rig::new(&simulation.problem),
            memory: vec![None; shift.cycle.len()],
            effort: Effort::default(),
            done: 0,
            total: total as usize,
            due: &simulation.schedule.outputs,
        }
    }

    /// Carries the motion through.
    pub fn run(mut self, observers: &mut [&mut dyn Observer]) -> Result<Effort, Error> {
        let mut known = None;
        for station in &self.shift.lead {
            let settled =
                self.rig.increment(self.simulation, (*station, 0.0), None, &mut self.effort)?;
            known = Some(settled);
        }
        drop(known);
        self.effort.load_distance = self.rig.chain.load_distance;
        self.effort.dissipated = [self.rig.rubbed.dissipated, 0.0];
        let begun = Shown { state: self.rig.chain.state.clone(), effort: self.effort };
        self.show(&begun, true, observers)?;
        match self.simulation.schedule.stepping {
            Stepping::Jumps(every) => self.by_fixed_jumps(every, observers)?,
            Stepping::Tolerance(tolerance) => self.by_error(tolerance, observers)?,
            Stepping::Implicit(_) | Stepping::Explicit(_) => {
                while self.done < self.total {
                    self.one_by_one(observers)?;
                }
            }
        }
        Ok(self.effort)
    }

    /// One cycle, every increment shown at once.
    fn one_by_one(&mut self, observers: &mut [&mut dyn Observer]) -> Result<(), Error> {
        self.cycle(&mut |cycles, shown| {
            let output = cycles.output_due(shown.state.progress);
            cycles.show(&shown, output, observers)
        })?;
        self.end_cycle();
        Ok(())
    }

    /// Goes through a cycle; its rate of wear.
    fn cycle(
        &mut self,
        show: &mut dyn FnMut(&mut Self, Shown) -> Result<(), Error>,
    ) -> Result<Rate, Error> {
        let start = self.done as f64 * self.shift.period();
        let before = self.effort.dissipated[1];
        let (peak, last) = (self.shift.peak(), self.shift.cycle.len() - 1);
        if self.shift.released {
            self.rig.release(&self.simulation.problem);
        }
        self.rig.begin_cycle();
        let mut reference = None;
        for index in 0..=last {
            self.effort.iterations = 0;
            let progress = if index == last {
                (self.done + 1) as f64 * self.shift.period()
            } else {
                start + self.shift.places[index]
            };
            let station = (self.shift.cycle[index], progress);
            let known = self.memory[index].as_ref();
            let settled = self.rig.increment(self.simulation, station, known, &mut self.effort)?;
            self.memory[index] = Some(settled);
            if index == peak {
                reference = Some(self.rig.clone());
            }
            self.effort.steps += 1;
            let dissipated = self.rig.rubbed.dissipated;
            self.effort.dissipated = [dissipated, before + dissipated];
            self.effort.load_distance = self.rig.chain.load_distance;
            if index == last {
                self.effort.true_cycles += 1;
            }
            let shown = Shown { state: self.rig.chain.state.clone(), effort: self.effort };
            show(self, shown)?;
        }
        let reference = reference.unwrap_or_else(|| self.rig.clone());
        Ok(Rate::of(&self.rig, &reference, self.shift.cycle[peak].control, &self.simulation.problem))
    }

    fn end_cycle(&mut self) {
        self.done += 1;
    }

    /// Every so many cycles one.
    fn by_fixed_jumps(
        &mut self,
        every: usize,
        observers: &mut [&mut dyn Observer],
    ) -> Result<(), Error> {
        while self.done < self.total {
            let mut rows = vec![];
            let rate = self.cycle(&mut |_, shown| {
                rows.push(shown);
                Ok(())
            })?;
            self.end_cycle();
            self.show_cycle(&rows, observers)?;
            let left = self.cycles_to_output().saturating_sub(1);
            let length = (every - 1).min(left);
            if length > 0 {
                self.jump([&rate, &rate], length, JUMP_STEPS)?;
                self.done += length;
                self.settle()?;
            }
        }
        Ok(())
    }

    /// Cycles up to the next output, or to the end.
    fn cycles_to_output(&self) -> usize {
        let period = self.shift.period();
        let cycle = |place: f64| (place / period - SAME).ceil().max(0.0) as usize;
        let next = self.due.first().map_or(self.total, |&place| cycle(place).min(self.total));
        next.saturating_sub(self.done)
    }

    /// Wears the bodies for that many cycles, the rate going from the first to the second.
    fn jump(&mut self, rates: [&Rate; 2], length: usize, steps: usize) -> Result<f64, Error> {
        rates[0].wear_on(rates[1], &mut self.rig, (length, steps), self.simulation, &mut self.effort)
    }

    /// Brings pressures and tractions to the wear as it is now.
    fn settle(&mut self) -> Result<(), Error> {
        if self.shift.released {
            return Ok(());
        }
        let last = self.shift.cycle.len() - 1;
        let progress = self.done as f64 * self.shift.period();
        let station = (self.shift.cycle[last], progress);
        self.rig.settle(self.simulation, station, None, &mut self.effort).map(|_| ())
    }

    /// Jumps chosen by their error.
    ///
    /// The cycles of a jump are worn at the rate of the cycle before it. The cycle computed behind it
    /// shows how the rate has changed; the wear of the jump is then taken again with a rate that changes
    /// evenly, and the difference is the error of the first, an upper bound for that of the second.
    fn by_error(
        &mut self,
        tolerance: f64,
        observers: &mut [&mut dyn Observer],
    ) -> Result<(), Error> {
        let (rows, mut rate) = self.buffered()?;
        self.end_cycle();
        self.show_cycle(&rows, observers)?;
        let (mut stride, mut error) = (2.0f64, 0.0f64);
        while self.done < self.total {
            let ahead = self.cycles_to_output().max(1);
            let length = landing(stride, ahead) - 1;
            let (rig, memory) = (self.rig.clone(), self.memory.clone());
            let (done, effort) = (self.done, self.effort);
            let steps = self.jump_lengths(&rate, length, tolerance)?;
            let foreseen = self.rig.chain.state.worn.clone();
            self.done += length;
            if length > 0 {
                self.settle()?;
            }
            let (mut rows, next) = self.buffered()?;
            let after = self.rig.clone();
            let mut relative = 0.0;
            if length > 0 {
                self.rig = rig.clone();
                self.jump([&rate, &next], length, steps)?;
                let corrected = self.rig.chain.state.worn.clone();
                self.rig = after;
                let made = distance(&corrected, &rig.chain.state.worn);
                let off = distance(&corrected, &foreseen);
                relative = if made > 0.0 { off / made } else { 0.0 };
                let change = (AIM * tolerance.sqrt() / relative).clamp(CHANGE.0, CHANGE.1);
                let regime = rate.sticks != next.sticks && length > 1;
                if relative * relative > tolerance || regime && length as f64 > tolerance * done as f64 {
                    let spent = self.effort;
                    (self.rig, self.memory, self.done, self.effort) = (rig, memory, done, effort);
                    self.effort.applications = spent.applications;
                    self.effort.solves = spent.solves;
                    self.effort.rejected += 1;
                    self.effort.true_cycles = spent.true_cycles;
                    stride = (1.0 + length as f64 * change.min(0.5)).max(2.0);
                    if length == 1 {
                        stride = 1.0;
                    }
                    continue;
                }
                error += made * (relative * relative + LAG * tolerance);
                let shortened = (length as f64) < 0.8 * stride && change >= 1.0;
                let grown = 1.0 + change * length as f64;
                stride = if shortened { stride.max(grown) } else { grown };
                self.correct(&corrected, &foreseen, &mut rows);
            } else {
                stride = 2.0;
            }
            let _ = relative;
            self.end_cycle();
            let worn = distance(&self.rig.chain.state.worn, &Default::default());
            let estimate = if worn > 0.0 { error / worn } else { 0.0 };
            self.effort.time_error = Some(estimate);
            rows.iter_mut().for_each(|row| row.effort.time_error = Some(estimate));
            self.show_cycle(&rows, observers)?;
            rate = next;
        }
        Ok(())
    }

    /// Jumps in as many steps as keep the pressures' lag small beside the tolerance; how many.
    fn jump_lengths(&mut self, rate: &Rate, length: usize, tolerance: f64) -> Result<usize, Error> {
        if length == 0 {
            return Ok(1);
        }
        let rig = self.rig.clone();
        let mut steps = 2;
        loop {
            let change = self.jump([rate, rate], length, steps)?;
            let needed = (0.5 * change / (LAG * tolerance)).ceil().min(MOST_STEPS as f64) as usize;
            if needed <= steps {
                return Ok(steps);
            }
            self.rig = rig.clone();
            steps = needed;
        }
    }

    /// Puts the corrected wear of a jump in the place of the foreseen one.
    fn correct(&mut self, corrected: &[Vec<f64>; 2], foreseen: &[Vec<f64>; 2], rows: &mut [Shown]) {
        let states = rows.iter_mut().map(|row| &mut row.state);
        for state in states.chain([&mut self.rig.chain.state]) {
            for body in 0..2 {
                for (pair, worn) in state.worn[body].iter_mut().enumerate() {
                    *worn += corrected[body][pair] - foreseen[body][pair];
                }
            }
        }
    }

    /// A cycle whose states are kept to be shown later.
    fn buffered(&mut self) -> Result<(Vec<Shown>, Rate), Error> {
        let mut rows = vec![];
        let rate = self.cycle(&mut |_, shown| {
            rows.push(shown);
            Ok(())
        })?;
        Ok((rows, rate))
    }

    fn show_cycle(
        &mut self,
        rows: &[Shown],
        observers: &mut [&mut dyn Observer],
    ) -> Result<(), Error> {
        for row in rows {
            let output = self.output_due(row.state.progress);
            self.show(row, output, observers)?;
        }
        Ok(())
    }

    /// Whether fields are due at that progress, which is then taken off the list.
    fn output_due(&mut self, progress: f64) -> bool {
        let margin = SAME * self.simulation.schedule.extent;
        let mut output = self.simulation.schedule.extent - progress <= margin;
        while self.due.first().is_some_and(|&due| due <= progress + margin) {
            (self.due, output) = (&self.due[1..], true);
        }
        output
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
        };
        observers
            .iter_mut()
            .try_for_each(|observer| observer.observe(&report).map_err(Error::Observer))
    }
}

/// Steps of a jump of fixed length.
const JUMP_STEPS: usize = 8;
/// Most steps of a jump.
const MOST_STEPS: usize = 64;
/// Lag of the pressures in a step of a jump, relative to the tolerance.
const LAG: f64 = 0.2;

/// Cycles to the end of the next one computed: the stride, or what lands on the next output.
fn landing(stride: f64, ahead: usize) -> usize {
    let stride = stride.max(1.0);
    let count = (ahead as f64 / stride - 0.1).ceil().max(1.0);
    let length = if count <= 2.0 { ahead as f64 / count } else { stride };
    (length.round() as usize).clamp(1, ahead)
}

/// 2-norm of the difference of two worn depths (m); against nothing, of the first.
fn distance(one: &[Vec<f64>; 2], other: &[Vec<f64>; 2]) -> f64 {
    let total = |worn: &[Vec<f64>; 2], pair: usize| {
        worn.iter().filter_map(|body| body.get(pair)).sum::<f64>()
    };
    let square = |pair: usize| (total(one, pair) - total(other, pair)).powi(2);
    (0..one[0].len()).map(square).sum::<f64>().sqrt()
}
