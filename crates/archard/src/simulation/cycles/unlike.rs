//! Pressures and friction of unlike bodies, which act on one another.

use super::rig::{Found, Rig, not_converged};
use super::settle::Settled;
use crate::frame::VectorField;
use crate::motion::Station;
use crate::numerics::vector::map;
use crate::simulation::chain::Leg;
use crate::simulation::{Effort, Error, Simulation};
use crate::solve::{Status, joint};

/// Change of the tractions' effect on the gap, relative to the approach, below which pressures and friction
/// that are found in turn agree.
const CONSISTENT: f64 = 1e-8;
/// Turns between them.
const TURNS: usize = 50;

impl Rig {
    /// Pressures and friction at once, where the solver can and it converges; otherwise in turn.
    pub fn solve_jointly(
        &mut self,
        simulation: &Simulation,
        leg: Leg,
        station: Station,
        known: Option<&Settled>,
        effort: &mut Effort,
    ) -> Result<Found, Error> {
        let problem = &simulation.problem;
        let Some(friction) = &problem.friction else { return Ok(Found::default()) };
        let frame = &problem.frame;
        let (rigid, held) = self.rigid_slip(problem, station, None);
        let opened = self.opened_by_shift(problem, station);
        let gap = map([&self.chain.undeformed_gap(problem), &opened], |[gap, opened]| gap + opened);
        let step = joint::Step {
            compliance: &*problem.compliance,
            frame,
            friction: &**friction,
            gap: &gap,
            control: leg.control,
            rigid: [&rigid[0], &rigid[1]],
            held: &held,
            again: known.is_some(),
        };
        let start = match known.and_then(|known| known.joint.clone()) {
            Some(start) => start,
            None => self.joint_start(simulation, leg, station, effort)?,
        };
        let foreseen = known.and_then(|known| known.foreseen.as_ref());
        let solver = &*simulation.friction_solver;
        let Some(outcome) = solver.solve_jointly(&step, &start, foreseen) else {
            if !frame.is_plane() {
                return Err(Error::NotJoint);
            }
            return self.solve_in_turn(simulation, leg, station, known, effort);
        };
        effort.solves += 1;
        effort.iterations += outcome.iterations;
        effort.applications += outcome.applications;
        effort.residual = outcome.residual;
        match outcome.status {
            Status::Converged => {}
            Status::OutOfIterations if !frame.is_plane() => {
                return Err(not_converged(simulation, leg, outcome.iterations, outcome.residual));
            }
            Status::OutOfIterations => {
                return self.solve_in_turn(simulation, leg, station, known, effort);
            }
            Status::FrameFull => {
                let measure = problem.motion.progress();
                return Err(Error::FrameFull { measure, progress: leg.progress });
            }
        }
        let solution = outcome.solution;
        let state = &mut self.chain.state;
        state.pressure = solution.traction.n.iter().map(|n| -n + 0.0).collect();
        state.load = -frame.force(&solution.traction)[2];
        state.approach = solution.approach;
        state.gap = outcome.gap;
        state.progress = leg.progress;
        let limit = state.pressure.iter().map(|&pressure| friction.limit(pressure)).collect();
        let shift = self.shifted(station, &solution.found);
        let traction = [solution.traction.t1.clone(), solution.traction.t2.clone()];
        self.take(problem, traction, shift, solution.displacement.clone());
        Ok(Found { limit, found: solution.found.clone(), joint: Some(solution) })
    }

    /// The present tractions, or frictionless pressures where there are none.
    fn joint_start(
        &mut self,
        simulation: &Simulation,
        leg: Leg,
        station: Station,
        effort: &mut Effort,
    ) -> Result<joint::Solution, Error> {
        let problem = &simulation.problem;
        let pairs = problem.frame.len();
        if self.chain.state.load == 0.0 {
            let apart = self.clone_contact();
            let opened = self.opened_by_shift(problem, station);
            self.press(simulation, leg, &opened, effort)?;
            let state = &mut self.chain.state;
            (state.gap, state.tangential) = (apart.gap, apart.tangential);
        }
        let n: Vec<f64> = self.chain.state.pressure.iter().map(|pressure| -pressure).collect();
        let tangential = self.chain.state.tangential.as_ref();
        let [t1, t2] = tangential.map_or_else(
            || [vec![0.0; pairs], vec![0.0; pairs]],
            |tangential| tangential.traction.clone(),
        );
        let traction = VectorField { t1, t2, n };
        effort.applications += 1;
        let displacement = problem.compliance.apply(&traction);
        let approach = self.chain.state.approach;
        Ok(joint::Solution { traction, displacement, approach, found: vec![], factors: None })
    }

    /// Pressures and friction of unlike bodies, one after the other until they agree.
    fn solve_in_turn(
        &mut self,
        simulation: &Simulation,
        leg: Leg,
        station: Station,
        known: Option<&Settled>,
        effort: &mut Effort,
    ) -> Result<Found, Error> {
        let problem = &simulation.problem;
        let (before, strained) = (self.chain.state.tangential.clone(), self.strained.clone());
        let mut opened = vec![0.0; problem.frame.len()];
        self.chain.find_displacement(problem, effort);
        if before.is_some() {
            effort.applications += 1;
            opened = self.chain.opened_by_friction(problem);
        }
        let mut latest = known.cloned();
        for _ in 0..TURNS {
            self.press(simulation, leg, &opened, effort)?;
            self.chain.state.tangential.clone_from(&before);
            self.strained.clone_from(&strained);
            effort.applications += 1;
            let pressed = self.strain_of(problem, None);
            let found = self.drag(simulation, leg, station, &pressed, latest.as_ref(), effort)?;
            effort.applications += 1;
            let now = self.chain.opened_by_friction(problem);
            let change =
                now.iter().zip(&opened).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
            opened = now;
            if change <= CONSISTENT * self.chain.state.approach.abs() {
                return Ok(found);
            }
            latest = Some(self.settled(found));
        }
        Err(Error::NotConsistent {
            measure: problem.motion.progress(),
            progress: leg.progress,
            passes: TURNS,
        })
    }
}
