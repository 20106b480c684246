//! A step of wear: by the pressures at its end, or by those at its start.

use super::chain::{Chain, Leg, not_converged};
use super::collector::{Collector, Foreseen};
use super::{Effort, Error, Simulation};
use crate::compliance::WornPlanes;
use crate::motion::Motion;
use crate::numerics::vector;
use crate::problem::ContactProblem;

/// Times a step's wear is foreseen before it counts as not converged.
const PASSES: usize = 50;

impl Chain {
    /// An implicit step: the contact at its end does the wear.
    ///
    /// What wears is foreseen as straight lines in the pressures, which adds their slopes to the compliance, and found
    /// anew where laws or friction are not straight.
    pub fn implicit(
        &mut self,
        simulation: &Simulation,
        leg: Leg,
        effort: &mut Effort,
    ) -> Result<(), Error> {
        let problem = &simulation.problem;
        if !rubs(problem, leg.advance) {
            self.press(simulation, leg, effort)?;
            self.load_distance += self.distance(simulation, leg, leg)?;
            return Ok(());
        }
        let collector = Collector::of(problem)?;
        let undeformed = self.undeformed_gap(problem);
        let mut made = collector.collect(&self.state, leg.advance);
        for _ in 0..PASSES {
            let foreseen = made.foresee(&self.state.pressure);
            let gap = foreseen.opened(&undeformed, collector.lines());
            self.contact_wearing(simulation, leg, &gap, (&collector, &foreseen), effort)?;
            made = collector.collect(&self.state, leg.advance);
            if collector.agrees(&foreseen, &self.state, &made) {
                collector.wear(&mut self.state, &made);
                self.load_distance += self.distance(simulation, leg, leg)?;
                return Ok(());
            }
        }
        Err(match problem.motion {
            Motion::Rolling(_) => Error::NotConsistent {
                measure: problem.motion.progress(),
                progress: leg.progress,
                passes: PASSES,
            },
            _ => not_converged(simulation, leg, PASSES, f64::NAN),
        })
    }

    /// An explicit step: the contact at its start does the wear.
    pub fn explicit(
        &mut self,
        simulation: &Simulation,
        leg: Leg,
        effort: &mut Effort,
    ) -> Result<(), Error> {
        let collector = Collector::of(&simulation.problem)?;
        let before = simulation.schedule.control_at(self.state.progress);
        let made = collector.collect(&self.state, leg.advance);
        collector.wear(&mut self.state, &made);
        self.load_distance += self.distance(simulation, leg, Leg { control: before, ..leg })?;
        self.press(simulation, leg, effort)
    }

    /// Deepest wear (m) that an advance under the present contact makes.
    pub fn deepest_wear(&self, problem: &ContactProblem, advance: f64) -> Result<f64, Error> {
        Ok(Collector::of(problem)?.collect(&self.state, advance).deepest())
    }

    /// The contact under a gap (m) while wear gives way to the pressures.
    fn contact_wearing(
        &mut self,
        simulation: &Simulation,
        leg: Leg,
        gap: &[f64],
        (collector, foreseen): (&Collector<'_>, &Foreseen),
        effort: &mut Effort,
    ) -> Result<(), Error> {
        let problem = &simulation.problem;
        let addition = foreseen.pair_slopes(gap.len());
        let wearing = (gap, &addition[..]);
        let Some((lines, slopes)) = collector.lines().zip(foreseen.line_slopes()) else {
            return self.contact(simulation, leg, wearing, &*problem.compliance, effort);
        };
        let pressure = self.state.pressure.clone();
        let weight = problem.frame.measure().weight;
        let [total] = vector::sum_with([weight], [&pressure], |[w], [pressure]| [w * pressure]);
        let worn = WornPlanes::new(&*problem.compliance, lines.flow, slopes, &pressure);
        if let Some(foreseen) = worn.foresee(gap, total, &pressure) {
            problem.compliance.apply_normal(&foreseen, &mut self.displacement);
            self.state.pressure = foreseen;
        }
        worn.add_wear(&self.state.pressure, 1.0, &mut self.displacement);
        let worn = match self.contact(simulation, leg, wearing, &worn, effort) {
            Err(Error::NotConverged { .. }) => {
                let worn = worn.steady();
                self.contact(simulation, leg, wearing, &worn, effort)?;
                worn
            }
            other => other.map(|()| worn)?,
        };
        worn.add_wear(&self.state.pressure, -1.0, &mut self.displacement);
        Ok(())
    }

    /// What a step adds to the [integral of the load over the distance](Effort::load_distance), with the load of a leg.
    fn distance(&self, simulation: &Simulation, leg: Leg, at: Leg) -> Result<f64, Error> {
        let problem = &simulation.problem;
        Ok(match &problem.motion {
            Motion::Rolling(rolling) if rubs(problem, leg.advance) => {
                let flow = problem.frame.flow(rolling.direction)?;
                leg.advance * self.creep_work(problem, rolling, flow)
            }
            Motion::Rolling(_) => 0.0,
            motion => self.prescribed_load(at) * motion.slip(leg.advance),
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
