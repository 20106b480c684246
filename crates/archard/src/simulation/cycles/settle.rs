//! An increment brought to its end: pressures and friction that belong together.
//!
//! Pairs that close bear friction from where they touch on. [What they slid before](super::touch) is found with the
//! increment: it is solved again until what it was given is what it shows.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::rig::{Found, Rig};
use super::touch::{Before, Course};
use crate::motion::{Control, Station};
use crate::problem::ContactState;
use crate::simulation::chain::Leg;
use crate::simulation::{Effort, Error, Simulation};
use crate::solve::joint;

/// Disagreement of what closing pairs slide before they touch with what an increment shows, relative to the largest,
/// that is let pass at once, and after it was found anew.
const AT_FIRST: f64 = 0.02;
const LATER: f64 = 0.005;
/// Times an increment is solved for it at most.
const TOUCHES: usize = 9;

/// A solution to start the same increment of another cycle from.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct Settled {
    pub state: ContactState,
    pub displacement: Vec<f64>,
    pub limit: Vec<f64>,
    pub found: Vec<f64>,
    pub joint: Option<joint::Solution>,
    /// Where the increment before went, from one cycle to the next, this one may go too.
    pub foreseen: Option<joint::Solution>,
    /// How closing pairs slid.
    course: Option<Arc<Course>>,
}

impl Settled {
    /// What became of it in another cycle.
    pub fn change_to(&self, other: &Self) -> Option<joint::Solution> {
        let (from, to) = (self.joint.as_ref()?, other.joint.as_ref()?);
        (from.found.len() == to.found.len()).then(|| to.moved(from, -1.0))
    }

    /// Foresees that it changes as another did.
    pub fn foresee(&mut self, change: &joint::Solution) {
        let joint = self.joint.as_ref();
        let joint = joint.filter(|joint| joint.found.len() == change.found.len());
        self.foreseen = joint.map(|joint| joint.moved(change, 1.0));
    }
}

impl Rig {
    /// The same without rubbing.
    pub fn settle(
        &mut self,
        simulation: &Simulation,
        (station, progress): (Station, f64),
        known: Option<&Settled>,
        effort: &mut Effort,
    ) -> Result<Settled, Error> {
        let leg = Leg { advance: 0.0, progress, control: station.control };
        if station.control == Control::Load(0.0) {
            let shift = self.shifted(station, &[]);
            self.release(&simulation.problem);
            self.chain.state.progress = progress;
            if let Some(tangential) = &mut self.chain.state.tangential {
                tangential.shift = shift;
            }
            return Ok(self.settled(Found::default()));
        }
        let problem = &simulation.problem;
        let ends = problem.motion.shift().is_some_and(|shift| shift.end_pressure);
        if problem.friction.is_none() || ends {
            let found = self.solve(simulation, leg, station, known, effort)?;
            return Ok(self.settled(found));
        }
        self.settle_from_touch(simulation, (leg, station), known, effort)
    }

    /// The same with friction, which pairs that close bear from where they touch on.
    fn settle_from_touch(
        &mut self,
        simulation: &Simulation,
        (leg, station): (Leg, Station),
        known: Option<&Settled>,
        effort: &mut Effort,
    ) -> Result<Settled, Error> {
        let frame = &simulation.problem.frame;
        let before = Before::of(&self.chain.state);
        let (tangential, strained) = (self.chain.state.tangential.clone(), self.strained.clone());
        let approached = self.approached;
        if let Some(course) = known.and_then(|known| known.course.clone()) {
            self.course = Some(course);
        }
        let (mut latest, mut pass) = (None, 0);
        let mut earlier: Option<Option<Arc<Course>>> = None;
        loop {
            pass += 1;
            self.until_touch = before.until_touch(self.course.as_deref());
            let found = self.solve(simulation, leg, station, latest.as_ref().or(known), effort)?;
            let settled = self.settled(found);
            let state = &self.chain.state;
            let Some(course) = before.course(state, frame) else { return Ok(settled) };
            let apart = before.apart(state, [self.course.as_deref(), Some(&course)]);
            let enough = if pass == 1 { AT_FIRST } else { LATER };
            if apart <= enough || pass == TOUCHES {
                effort.unsettled += usize::from(apart > enough);
                return Ok(settled);
            }
            // Every second pass goes on from where the two before lead.
            let used = self.course.take();
            let next = match (earlier.take(), &used) {
                (Some(first), Some(used)) => before.limit(state, first.as_deref(), [used, &course]),
                _ => {
                    earlier = Some(used);
                    course
                }
            };
            self.course = Some(Arc::new(next));
            self.chain.state.tangential.clone_from(&tangential);
            self.strained.clone_from(&strained);
            self.approached = approached;
            latest = Some(settled);
        }
    }

    /// Pressures and friction of an increment.
    fn solve(
        &mut self,
        simulation: &Simulation,
        leg: Leg,
        station: Station,
        known: Option<&Settled>,
        effort: &mut Effort,
    ) -> Result<Found, Error> {
        let problem = &simulation.problem;
        let curved = !problem.frame.is_plane();
        if problem.friction.is_some() && (curved || problem.compliance.couples()) {
            return self.solve_jointly(simulation, leg, station, known, effort);
        }
        self.start_from(leg, known);
        let opened = self.opened_by_shift(problem, station);
        self.press(simulation, leg, &opened, effort)?;
        let pressed = self.strain_of(problem, None);
        self.drag(simulation, leg, station, &pressed, known, effort)
    }

    pub fn settled(&self, found: Found) -> Settled {
        let Found { limit, found, joint } = found;
        let displacement = self.chain.displacement.clone();
        let (state, course) = (self.clone_contact(), self.course.clone());
        Settled { state, displacement, limit, found, joint, foreseen: None, course }
    }

    /// Takes the pressures of a known solution to start from, where the load differs from the present one.
    fn start_from(&mut self, leg: Leg, known: Option<&Settled>) {
        let same = match leg.control {
            Control::Load(load) => (load - self.chain.state.load).abs() <= 1e-9 * load,
            Control::Approach(approach) => approach == self.chain.state.approach,
        };
        if let Some(known) = known.filter(|_| !same) {
            let ContactState { pressure, approach, load, .. } = &known.state;
            self.chain.displacement.clone_from(&known.displacement);
            let state = &mut self.chain.state;
            (state.approach, state.load) = (*approach, *load);
            state.pressure.clone_from(pressure);
        }
    }
}
