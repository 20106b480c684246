//! Jumps over cycles: at the rate of wear that a cycle shows, as many at once as are given or their error allows.

use super::jump::{Rate, Wear};
use super::jump_control::Tried;
use super::{Cycles, Setting, Shown};
use crate::motion::Stepping;
use crate::numerics::vector::update;
use crate::simulation::error::Error;

/// Steps within a jump of fixed length, and the fewest in others.
const STEPS: usize = 4;
const FEWEST_STEPS: usize = 1;

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

impl Cycles {
    /// Jumps towards the next output, so many cycles ahead, if jumps are asked for and a cycle shows the rate.
    pub(super) fn jump_on(&mut self, setting: Setting<'_>, ahead: usize) -> Result<(), Error> {
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
        // Tractions remember what was before the jump: they settle in a first cycle behind it, which also gives most of how
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
        self.position.history.solve_increment(simulation, at, None, &mut self.effort)?;
        Ok(())
    }

    /// Puts the corrected wear of a jump in the place of the foreseen one.
    fn correct(&mut self, foreseen: &Wear, corrected: &Wear, rows: &mut [Shown]) {
        let further = corrected.load_distance - foreseen.load_distance;
        let dissipated = corrected.dissipated - foreseen.dissipated;
        let states = rows.iter_mut().map(|row| &mut row.state);
        for state in states.chain([&mut self.position.history.state]) {
            for (body, surface) in state.surfaces.iter_mut().enumerate() {
                let [new, old] = [corrected, foreseen].map(|wear| &wear.surfaces[body]);
                let change = |field: &mut [f64], [new, old]: [&[f64]; 2]| {
                    update(field, [new, old], |field, [new, old]| field + (new - old));
                };
                change(&mut surface.depth, [&new.depth, &old.depth]);
                change(&mut surface.slid, [&new.slid, &old.slid]);
            }
        }
        self.position.history.load_distance += further;
        self.position.history.dissipated += dissipated;
        for effort in rows.iter_mut().map(|row| &mut row.effort).chain([&mut self.effort]) {
            effort.load_distance += further;
            effort.dissipated[1] += dissipated;
        }
    }
}
