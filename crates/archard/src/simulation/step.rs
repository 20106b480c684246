//! A step of wear: by the pressures at its end, or by those at its start.

use super::collector::{Collected, Collector, Foreseen, Slides};
use super::evolution::{Evolution, Increment, not_converged};
use super::{Effort, Error, Simulation};
use crate::closed_form::flash_temperature::FAST;
use crate::compliance::WornLines;
use crate::motion::Motion;
use crate::numerics::vector::{self, Values};
use crate::problem::{ContactProblem, ContactState};

/// Times a step's wear is foreseen before it counts as not converged.
const PASSES: usize = 50;

impl Evolution {
    /// An implicit step: the contact at its end does the wear.
    ///
    /// What wears is foreseen as straight lines in the pressures, which adds their slopes to the compliance, and found
    /// anew where laws or friction are not straight.
    pub fn implicit(
        &mut self,
        simulation: &Simulation,
        increment: Increment,
        effort: &mut Effort,
    ) -> Result<(), Error> {
        let problem = &simulation.problem;
        if let Some(swung) = self.swing(simulation, increment, effort) {
            return swung;
        }
        if !rubs(problem, increment.advance) {
            self.press(simulation, increment, effort)?;
            self.load_distance += self.distance(simulation, increment, increment)?;
            return Ok(());
        }
        let collector = Collector::of(problem)?;
        let undeformed = self.undeformed_gap(problem);
        let distance = Values::All(problem.motion.slip(increment.advance));
        let slides = Slides { distance, point: &|_, pair| pair };
        let made = self.contact_and_wear(
            simulation,
            (increment, slides),
            &collector,
            &undeformed,
            effort,
        )?;
        collector.wear(&mut self.state, &made);
        self.load_distance += self.distance(simulation, increment, increment)?;
        Ok(())
    }

    /// The contact at the end of an increment in which pairs of surfaces that stay slide, from an undeformed gap (m), and the
    /// wear it makes.
    pub(super) fn contact_and_wear(
        &mut self,
        simulation: &Simulation,
        (increment, slides): (Increment, Slides<'_>),
        collector: &Collector<'_>,
        undeformed: &[f64],
        effort: &mut Effort,
    ) -> Result<Collected, Error> {
        let problem = &simulation.problem;
        let collect =
            |state: &ContactState| collector.collect_sliding(state, increment.advance, slides);
        let mut made = collect(&self.state);
        for _ in 0..PASSES {
            let foreseen = made.foresee(&self.state.pressure);
            let gap = foreseen.gap_by_friction(undeformed, collector.lines());
            self.contact_wearing(simulation, increment, &gap, (collector, &foreseen), effort)?;
            made = collect(&self.state);
            if collector.agrees(&foreseen, &self.state, &made) {
                self.is_fast(problem)?;
                return Ok(made);
            }
        }
        Err(match problem.motion {
            Motion::Rolling(_) => Error::NotConsistent {
                measure: problem.motion.progress(),
                progress: increment.progress,
                passes: PASSES,
            },
            _ => not_converged(simulation, increment, PASSES, f64::NAN),
        })
    }

    /// An explicit step: the contact at its start does the wear.
    pub fn explicit(
        &mut self,
        simulation: &Simulation,
        increment: Increment,
        effort: &mut Effort,
    ) -> Result<(), Error> {
        let collector = Collector::of(&simulation.problem)?;
        let before = simulation.schedule.control_at(self.state.progress);
        self.is_fast(&simulation.problem)?;
        let made = collector.collect(&self.state, increment.advance);
        collector.wear(&mut self.state, &made);
        self.load_distance +=
            self.distance(simulation, increment, Increment { control: before, ..increment })?;
        self.press(simulation, increment, effort)
    }

    /// Whether the contact is passed fast enough for laws that go by the temperature, if there are any.
    fn is_fast(&self, problem: &ContactProblem) -> Result<(), Error> {
        let peclet = problem.flash_for_laws(&self.state).and_then(|flash| flash.peclet);
        match peclet.filter(|peclet| *peclet < FAST) {
            None => Ok(()),
            Some(peclet) => Err(Error::TooSlow {
                measure: problem.motion.progress(),
                progress: self.state.progress,
                peclet,
            }),
        }
    }

    /// Deepest wear (m) that an advance under the present contact makes.
    pub fn deepest_wear(&self, problem: &ContactProblem, advance: f64) -> Result<f64, Error> {
        Ok(Collector::of(problem)?.collect(&self.state, advance).deepest())
    }

    /// The contact under a gap (m) while wear gives way to the pressures.
    fn contact_wearing(
        &mut self,
        simulation: &Simulation,
        increment: Increment,
        gap: &[f64],
        (collector, foreseen): (&Collector<'_>, &Foreseen),
        effort: &mut Effort,
    ) -> Result<(), Error> {
        let problem = &simulation.problem;
        let addition = foreseen.pair_slopes(gap.len());
        let wearing = (gap, &addition[..]);
        let Some((lines, slopes)) = collector.lines().zip(foreseen.line_slopes()) else {
            return self.contact(simulation, increment, wearing, &*problem.compliance, effort);
        };
        let pressure = self.state.pressure.clone();
        let weight = problem.frame.measure().weight;
        let [total] = vector::sum_with([weight], [&pressure], |[w], [pressure]| [w * pressure]);
        let worn = WornLines::new(&*problem.compliance, lines.flow, slopes, &pressure);
        if let Some(foreseen) = worn.foresee(gap, total, &pressure) {
            problem.compliance.apply_normal(&foreseen, &mut self.displacement);
            self.state.pressure = foreseen;
        }
        worn.add_wear(&self.state.pressure, 1.0, &mut self.displacement);
        let worn = match self.contact(simulation, increment, wearing, &worn, effort) {
            Err(Error::NotConverged { .. }) => {
                let worn = worn.steady();
                self.contact(simulation, increment, wearing, &worn, effort)?;
                worn
            }
            other => other.map(|()| worn)?,
        };
        worn.add_wear(&self.state.pressure, -1.0, &mut self.displacement);
        Ok(())
    }

    /// What a step adds to the [integral of the load over the distance](Effort::load_distance), with the load of an increment.
    fn distance(
        &self,
        simulation: &Simulation,
        increment: Increment,
        at: Increment,
    ) -> Result<f64, Error> {
        let problem = &simulation.problem;
        Ok(match &problem.motion {
            Motion::Rolling(rolling) if rubs(problem, increment.advance) => {
                let flow = problem.frame.flow(rolling.direction)?;
                increment.advance * self.creep_work(problem, rolling, flow)
            }
            Motion::Rolling(_) => 0.0,
            motion => self.prescribed_load(at) * motion.slip(increment.advance),
        })
    }
}

/// Whether an advance (the motion's unit) wears anything.
fn rubs(problem: &ContactProblem, advance: f64) -> bool {
    problem.wears()
        && match &problem.motion {
            Motion::Rolling(rolling) => !rolling.swept,
            motion => motion.slip(advance) != 0.0,
        }
}
