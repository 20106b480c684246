//! An increment brought to its end: pressures and friction that belong together.
//!
//! Pairs that close bear friction from where they touch on. [What they slid before](super::touch) is found with the
//! increment: it is solved again until what it was given is what it shows.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::shifted::Solved;
use crate::motion::{Control, Station};
use crate::problem::ContactState;
use crate::simulation::effort::Effort;
use crate::simulation::error::Error;
use crate::simulation::memory::{History, Increment};
use crate::simulation::setup::Simulation;
use crate::simulation::touch::{Before, Course};
use crate::solve::monolithic;

/// Disagreement of what closing pairs slide before they touch with what an increment shows, relative to the largest,
/// that is let pass at once, and after it was found anew.
const AT_FIRST: f64 = 0.02;
const LATER: f64 = 0.005;
/// Times an increment is solved for it at most.
const TOUCHES: usize = 9;

/// A solution to start the same increment of another cycle from.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(in crate::simulation) struct WarmStart {
    pub state: ContactState,
    pub displacement: Vec<f64>,
    pub limit: Vec<f64>,
    pub rigid_slip: Vec<f64>,
    pub monolithic: Option<monolithic::Solution>,
    /// Where the increment before went, from one cycle to the next, this one may go too.
    pub foreseen: Option<monolithic::Solution>,
    /// How closing pairs slid.
    course: Option<Arc<Course>>,
}

impl WarmStart {
    /// What became of it in another cycle.
    pub fn change_to(&self, other: &Self) -> Option<monolithic::Solution> {
        let (from, to) = (self.monolithic.as_ref()?, other.monolithic.as_ref()?);
        (from.rigid_slip.len() == to.rigid_slip.len()).then(|| to.moved(from, -1.0))
    }

    /// Foresees that it changes as another did.
    pub fn foresee(&mut self, change: &monolithic::Solution) {
        let monolithic = self.monolithic.as_ref();
        let monolithic =
            monolithic.filter(|monolithic| monolithic.rigid_slip.len() == change.rigid_slip.len());
        self.foreseen = monolithic.map(|monolithic| monolithic.moved(change, 1.0));
    }
}

impl History {
    /// The same without rubbing.
    pub(in crate::simulation) fn solve_increment(
        &mut self,
        simulation: &Simulation,
        (station, progress): (Station, f64),
        known: Option<&WarmStart>,
        effort: &mut Effort,
    ) -> Result<WarmStart, Error> {
        let increment = Increment { advance: 0.0, progress, control: station.control };
        if station.control == Control::Load(0.0) {
            let shift = self.shift_at(station, &[]);
            self.release(&simulation.problem);
            self.state.progress = progress;
            if let Some(tangential) = &mut self.state.tangential {
                tangential.shift = shift;
            }
            return Ok(self.warm_start(Solved::default()));
        }
        let problem = &simulation.problem;
        let ends = problem.motion.increments().is_some_and(|shift| shift.end_pressure);
        if problem.friction.is_none() || ends {
            let rigid_slip = self.solve(simulation, increment, station, known, effort)?;
            self.imprint(problem);
            return Ok(self.warm_start(rigid_slip));
        }
        self.settle_from_touch(simulation, (increment, station), known, effort)
    }

    /// The same with friction, which pairs that close bear from where they touch on.
    fn settle_from_touch(
        &mut self,
        simulation: &Simulation,
        (increment, station): (Increment, Station),
        known: Option<&WarmStart>,
        effort: &mut Effort,
    ) -> Result<WarmStart, Error> {
        let frame = &simulation.problem.frame;
        let before = Before::of(&self.state);
        let (tangential, elastic_displacement) =
            (self.state.tangential.clone(), self.elastic_displacement.clone());
        let approached = self.approached;
        if let Some(course) = known.and_then(|known| known.course.clone()) {
            self.course = Some(course);
        }
        let (mut latest, mut pass) = (None, 0);
        let mut earlier: Option<Option<Arc<Course>>> = None;
        loop {
            pass += 1;
            self.until_touch = before.until_touch(self.course.as_deref());
            let rigid_slip =
                self.solve(simulation, increment, station, latest.as_ref().or(known), effort)?;
            let warm_start = self.warm_start(rigid_slip);
            let state = &self.state;
            let Some(course) = before.course(state, frame) else { return Ok(warm_start) };
            let apart = before.apart(state, [self.course.as_deref(), Some(&course)]);
            let enough = if pass == 1 { AT_FIRST } else { LATER };
            if apart <= enough || pass == TOUCHES {
                effort.unsettled += usize::from(apart > enough);
                return Ok(warm_start);
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
            self.state.tangential.clone_from(&tangential);
            self.elastic_displacement.clone_from(&elastic_displacement);
            self.approached = approached;
            latest = Some(warm_start);
        }
    }

    /// Pressures and friction of an increment.
    fn solve(
        &mut self,
        simulation: &Simulation,
        increment: Increment,
        station: Station,
        known: Option<&WarmStart>,
        effort: &mut Effort,
    ) -> Result<Solved, Error> {
        let problem = &simulation.problem;
        let curved = !problem.frame.is_plane();
        if problem.friction.is_some() && (curved || problem.compliance.couples()) {
            return self.solve_jointly(simulation, increment, station, known, effort);
        }
        self.start_from(increment, known);
        let gap_by_friction = self.opened_by_shift(problem, station);
        self.press_under(simulation, increment, &gap_by_friction, effort)?;
        if self.state.tangential.is_none() {
            return Ok(Solved::default());
        }
        let pressed = self.displacement_under(problem, None);
        self.solve_friction(simulation, increment, station, &pressed, known, effort)
    }

    pub(super) fn warm_start(&self, rigid_slip: Solved) -> WarmStart {
        let Solved { limit, rigid_slip, monolithic } = rigid_slip;
        let displacement = self.displacement.clone();
        let (state, course) = (self.clone_contact(), self.course.clone());
        WarmStart { state, displacement, limit, rigid_slip, monolithic, foreseen: None, course }
    }

    /// Takes the pressures of a known solution to start from, where the load differs from the present one.
    fn start_from(&mut self, increment: Increment, known: Option<&WarmStart>) {
        let same = match increment.control {
            Control::Load(load) => (load - self.state.load).abs() <= 1e-9 * load,
            Control::Approach(approach) => approach == self.state.approach,
        };
        if let Some(known) = known.filter(|_| !same) {
            let ContactState { pressure, approach, load, .. } = &known.state;
            self.displacement.clone_from(&known.displacement);
            let state = &mut self.state;
            (state.approach, state.load) = (*approach, *load);
            state.pressure.clone_from(pressure);
        }
    }
}
