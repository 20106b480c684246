//! The loop over the steps of a motion.

use super::adaptive::Adaptive;
use super::chain::{Chain, Leg};
use super::cycles::Cycles;
use super::{Effort, Error, Observer, Report, Simulation};
use crate::motion::Stepping;
use crate::numerics::vector::in_pool;

/// Two values of progress closer than this, relative to the extent, are the same.
const SAME: f64 = 1e-9;

impl Simulation {
    /// Carries the motion through, showing the initial contact and every step to the observers.
    ///
    /// # Errors
    /// If the frame does not suit the motion, a wear law lacks what it asks for, a contact does not converge or fills
    /// the frame, or an observer cannot go on.
    pub fn run(&self, observers: &mut [&mut dyn Observer]) -> Result<Effort, Error> {
        // Within the pool once, not anew for each of many small solves.
        in_pool(|| self.carry_through(observers))
    }

    fn carry_through(&self, observers: &mut [&mut dyn Observer]) -> Result<Effort, Error> {
        self.check_frame()?;
        self.problem.check_inputs()?;
        if let Some(shift) = self.problem.motion.shift() {
            return Cycles::new(self, shift).run(observers);
        }
        let mut march = March::begin(self)?;
        march.show(observers)?;
        while march.chain.state.progress < self.schedule.extent {
            march.step()?;
            march.show(observers)?;
        }
        Ok(march.effort)
    }
}

/// A run under way.
struct March<'a> {
    simulation: &'a Simulation,
    chain: Chain,
    /// Both histories, where steps are chosen by error.
    adaptive: Option<Adaptive>,
    effort: Effort,
    /// Outputs that are still due.
    due: &'a [f64],
    output: bool,
}

impl<'a> March<'a> {
    /// The initial contact; bodies that are pressed together later only touch.
    fn begin(simulation: &'a Simulation) -> Result<Self, Error> {
        let schedule = &simulation.schedule;
        let mut effort = Effort::default();
        let mut chain = Chain::new(&simulation.problem);
        if !schedule.ramped {
            let leg = Leg { advance: 0.0, progress: 0.0, control: schedule.control };
            chain.press(simulation, leg, &mut effort)?;
        }
        let adaptive = match schedule.stepping {
            Stepping::Tolerance(tolerance) => Some(Adaptive::new(simulation, &chain, tolerance)?),
            Stepping::Implicit(_) | Stepping::Explicit(_) | Stepping::Jumps(_) => None,
        };
        Ok(Self { simulation, chain, adaptive, effort, due: &schedule.outputs, output: true })
    }

    /// One accepted step.
    fn step(&mut self) -> Result<(), Error> {
        let schedule = &self.simulation.schedule;
        self.effort.iterations = 0;
        let target = self.due.first().copied().unwrap_or(schedule.extent).min(schedule.extent);
        match (&mut self.adaptive, schedule.stepping) {
            (Some(adaptive), _) => {
                self.chain = adaptive.step(self.simulation, target, &mut self.effort)?;
            }
            (None, Stepping::Explicit(step)) => self.fixed(step, Chain::explicit)?,
            (None, Stepping::Implicit(step) | Stepping::Tolerance(step)) => {
                self.fixed(step, Chain::implicit)?;
            }
            // Cycles are gone through elsewhere.
            (None, Stepping::Jumps(_)) => self.fixed(schedule.extent, Chain::implicit)?,
        }
        self.effort.steps += 1;
        self.effort.load_distance = self.chain.load_distance;
        self.output = false;
        let progress = &mut self.chain.state.progress;
        let margin = SAME * schedule.extent;
        if schedule.extent - *progress <= margin {
            (*progress, self.output, self.due) = (schedule.extent, true, &[]);
        }
        while self.due.first().is_some_and(|&due| due <= *progress + margin) {
            (self.due, self.output) = (&self.due[1..], true);
        }
        Ok(())
    }

    /// One step of a given length, the last one shorter where the extent is not a multiple of it.
    fn fixed(
        &mut self,
        step: f64,
        scheme: fn(&mut Chain, &Simulation, Leg, &mut Effort) -> Result<(), Error>,
    ) -> Result<(), Error> {
        let extent = self.simulation.schedule.extent;
        // From the count of steps, so that rounding does not add up.
        let end = ((self.effort.steps + 1) as f64 * step).min(extent);
        let end = if extent - end <= SAME * extent { extent } else { end };
        let advance = end - self.chain.state.progress;
        let leg = Leg { advance, progress: end, control: self.simulation.schedule.control_at(end) };
        scheme(&mut self.chain, self.simulation, leg, &mut self.effort)
    }

    /// Shows the present state to the observers.
    fn show(&self, observers: &mut [&mut dyn Observer]) -> Result<(), Error> {
        let report = Report {
            problem: &self.simulation.problem,
            state: &self.chain.state,
            effort: self.effort,
            output: self.output,
            extent: self.simulation.schedule.extent,
            prescribed: self.simulation.schedule.control_at(self.chain.state.progress),
            stepping: self.simulation.schedule.stepping,
        };
        observers
            .iter_mut()
            .try_for_each(|observer| observer.observe(&report).map_err(Error::Observer))
    }
}
