//! A history goes on by an increment: contact, friction and wear from one state to the next.
//!
//! Bodies that slide or roll are seen in one [position](super::position) after the other, most of them in one. What wears in each is
//! known when its contact is: at the end of the increment ([`Scheme::Implicit`]) or at its start. Bodies that are
//! shifted against each other rub between the contact before and the one after ([`Scheme::Between`]). Cycles that are jumped
//! over are implicit steps at the [rate](super::cycles) of one that was gone through.

use super::collector::Collector;
use super::effort::Effort;
use super::error::Error;
use super::memory::{History, Increment};
use super::position::{Position, gap};
use super::positions::positions;
use super::setup::Simulation;
use super::shift::WarmStart;
use super::whole;
use crate::motion::{Sequence, Slip, Station};
use crate::problem::ContactProblem;

/// When the wear of an increment is known.
#[derive(Debug, Clone, Copy)]
pub(super) enum Scheme<'a> {
    /// At its end: the contact there does all the wear.
    Implicit,
    /// At its start.
    Explicit,
    /// On the way to a station, where bodies are shifted; the solution of the same increment of another cycle to start from.
    Between(Station, Option<&'a WarmStart>),
}

impl History {
    /// Goes on by an increment. Bodies that are shifted give a solution to start the same increment of the next cycle from.
    pub fn advance(
        &mut self,
        simulation: &Simulation,
        increment: Increment,
        scheme: Scheme<'_>,
        effort: &mut Effort,
    ) -> Result<Option<WarmStart>, Error> {
        match scheme {
            Scheme::Implicit => self.implicit(simulation, increment, effort)?,
            Scheme::Explicit => self.explicit(simulation, increment, effort)?,
            Scheme::Between(station, known) => {
                let rubs = self.state.tangential.is_some();
                let before = rubs.then(|| self.clone_contact());
                let to = (station, increment.progress);
                let solution = self.solve_increment(simulation, to, known, effort)?;
                if let Some(before) = before {
                    self.take_up(&before, &simulation.problem);
                }
                return Ok(Some(solution));
            }
        }
        Ok(None)
    }

    /// An implicit step: the contact at its end does the wear.
    ///
    /// What wears is foreseen as straight lines in the pressures, which adds their slopes to the compliance, and found
    /// anew where laws or friction are not straight.
    fn implicit(
        &mut self,
        simulation: &Simulation,
        increment: Increment,
        effort: &mut Effort,
    ) -> Result<(), Error> {
        let problem = &simulation.problem;
        let slip = problem.motion.slip(increment.advance);
        let seen = positions(problem);
        // What swings dissipates, whether it wears or not.
        if seen.is_none() && !rubs(problem, increment.advance) {
            self.press(simulation, increment, effort)?;
            let position = Position::middle(problem, slip);
            self.load_distance += self.work(simulation, increment, &position)?;
            return Ok(());
        }
        let way = match &seen {
            Some(seen) => {
                self.forward = !self.forward;
                seen.way(&self.state, self.forward, increment.advance)?
            }
            None => vec![Position::middle(problem, slip)].into(),
        };
        let mut collector = Collector::of(problem)?;
        if let Some(seen) = &seen {
            let step = (simulation, increment);
            collector.coefficients =
                whole::coefficients(self, step, (&**seen, &way), &collector, effort)?;
        }
        for position in &way.positions {
            let increment =
                Increment { control: position.control.unwrap_or(increment.control), ..increment };
            let gap = match &seen {
                Some(seen) => gap(&**seen, (problem, &self.state), position),
                None => Some(self.undeformed_gap(problem)),
            };
            let gap = gap.ok_or_else(|| swung_out(problem, increment))?;
            let made =
                self.contact_and_wear(simulation, increment, position, (&collector, &gap), effort)?;
            if seen.as_ref().is_some_and(|seen| seen.reaches_an_end(&self.state.pressure)) {
                return Err(swung_out(problem, increment));
            }
            collector.wear(&mut self.state, &made, position);
            self.imprint(problem);
            self.load_distance += self.work(simulation, increment, position)?;
        }
        if let Some(seen) = seen {
            // What is shown is the contact in the middle.
            self.press(simulation, increment, effort)?;
            effort.dissipated[0] = seen.dissipated(&self.state, &way);
        }
        Ok(())
    }

    /// An explicit step: the contact at its start does the wear.
    fn explicit(
        &mut self,
        simulation: &Simulation,
        increment: Increment,
        effort: &mut Effort,
    ) -> Result<(), Error> {
        let problem = &simulation.problem;
        let collector = Collector::of(problem)?;
        let before = simulation.schedule.control_at(self.state.progress);
        self.is_fast(problem)?;
        let position = Position::middle(problem, problem.motion.slip(increment.advance));
        let made = collector.collect(&self.state, increment.advance, &position);
        collector.wear(&mut self.state, &made, &position);
        let at_start = Increment { control: before, ..increment };
        self.load_distance += self.work(simulation, at_start, &position)?;
        self.press(simulation, increment, effort)
    }

    /// What a position adds to the [integral of the load over the distance](Effort::load_distance), with the load of an
    /// increment.
    fn work(
        &self,
        simulation: &Simulation,
        increment: Increment,
        position: &Position,
    ) -> Result<f64, Error> {
        let problem = &simulation.problem;
        Ok(match &problem.motion.slip {
            Slip::Sought(drives) if rubs(problem, increment.advance) => {
                let flow = problem.frame.flow(problem.motion.direction)?;
                increment.advance * self.creep_work(problem, drives, flow)
            }
            Slip::Sought(_) => 0.0,
            Slip::Given(..) => {
                self.prescribed_load(increment) * position.distance(&self.state.pressure)
            }
        })
    }
}

fn swung_out(problem: &ContactProblem, increment: Increment) -> Error {
    Error::SwungOut { measure: problem.motion.progress, progress: increment.progress }
}

/// Whether an advance (the motion's unit) wears anything.
fn rubs(problem: &ContactProblem, advance: f64) -> bool {
    problem.wears()
        && match problem.motion.slip {
            Slip::Sought(_) => problem.motion.sequence == Sequence::Steady,
            Slip::Given(..) => problem.motion.slip(advance) != 0.0,
        }
}
