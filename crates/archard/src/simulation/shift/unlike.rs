//! Pressures and friction of unlike bodies, which act on one another.

use super::shifted::Solved;
use super::solve::WarmStart;
use crate::friction::Limits;
use crate::motion::Station;
use crate::numerics::vector::map;
use crate::simulation::effort::Effort;
use crate::simulation::error::Error;
use crate::simulation::friction::{alternate, not_converged};
use crate::simulation::memory::{History, Increment};
use crate::simulation::setup::Simulation;
use crate::solve::{Status, monolithic};

impl History {
    /// Pressures and friction at once, where the solver can and it converges; otherwise in turn.
    pub(super) fn solve_jointly(
        &mut self,
        simulation: &Simulation,
        increment: Increment,
        station: Station,
        known: Option<&WarmStart>,
        effort: &mut Effort,
    ) -> Result<Solved, Error> {
        let problem = &simulation.problem;
        let Some(friction) = &problem.friction else { return Ok(Solved::default()) };
        let frame = &problem.frame;
        let (rigid, prescribed) = self.slip_of_shift(problem, station, None);
        let gap_by_friction = self.opened_by_shift(problem, station);
        let gap =
            map([&self.undeformed_gap(problem), &gap_by_friction], |[gap, gap_by_friction]| {
                gap + gap_by_friction
            });
        let grip = problem.grip_of_shift(&**friction, &self.state);
        let limits = Limits::new(&**friction, &grip);
        let step = monolithic::Step {
            compliance: &*problem.compliance,
            frame,
            friction: limits,
            gap: &gap,
            control: increment.control,
            rigid: [&rigid[0], &rigid[1]],
            prescribed: &prescribed,
            again: known.is_some(),
        };
        let start = match known.and_then(|known| known.monolithic.clone()) {
            Some(start) => start,
            None => self.joint_start(simulation, increment, station, effort)?,
        };
        let foreseen = known.and_then(|known| known.foreseen.as_ref());
        let solver = &*simulation.friction_solver;
        let Some(outcome) = solver.solve_jointly(&step, &start, foreseen) else {
            if !frame.is_plane() {
                return Err(Error::NotMonolithic);
            }
            return self.solve_in_turn(simulation, increment, station, known, effort);
        };
        effort.solves += 1;
        effort.iterations += outcome.iterations;
        effort.applications += outcome.applications;
        effort.residual = outcome.residual;
        match outcome.status {
            Status::Converged => {}
            Status::OutOfIterations if !frame.is_plane() => {
                return Err(not_converged(
                    simulation,
                    increment,
                    outcome.iterations,
                    outcome.residual,
                ));
            }
            Status::OutOfIterations => {
                return self.solve_in_turn(simulation, increment, station, known, effort);
            }
            Status::FrameFull => {
                let measure = problem.motion.progress;
                return Err(Error::FrameFull { measure, progress: increment.progress });
            }
        }
        let solution = outcome.solution;
        let state = &mut self.state;
        state.pressure = solution.traction.n.iter().map(|n| -n + 0.0).collect();
        state.load = -frame.force(&solution.traction)[2];
        state.approach = solution.approach;
        state.gap = outcome.gap.into();
        state.progress = increment.progress;
        let limit = limits.all(&state.pressure);
        let shift = self.shift_at(station, &solution.rigid_slip);
        let traction = [solution.traction.t1.clone(), solution.traction.t2.clone()];
        self.take_tractions(
            problem,
            (traction, grip.clone()),
            shift,
            solution.displacement.clone(),
        );
        Ok(Solved { limit, rigid_slip: solution.rigid_slip.clone(), monolithic: Some(solution) })
    }

    /// The present tractions, or frictionless pressures where there are none.
    fn joint_start(
        &mut self,
        simulation: &Simulation,
        increment: Increment,
        station: Station,
        effort: &mut Effort,
    ) -> Result<monolithic::Solution, Error> {
        let problem = &simulation.problem;
        if self.state.load == 0.0 {
            let apart = self.clone_contact();
            let gap_by_friction = self.opened_by_shift(problem, station);
            self.press_under(simulation, increment, &gap_by_friction, effort)?;
            let state = &mut self.state;
            (state.gap, state.tangential) = (apart.gap, apart.tangential);
        }
        let traction = self.state.tractions();
        effort.applications += 1;
        let displacement = problem.compliance.apply(&traction);
        let approach = self.state.approach;
        Ok(monolithic::Solution {
            traction,
            displacement,
            approach,
            rigid_slip: vec![],
            factors: None,
        })
    }

    /// Pressures and friction of unlike bodies, one after the other until they agree.
    fn solve_in_turn(
        &mut self,
        simulation: &Simulation,
        increment: Increment,
        station: Station,
        known: Option<&WarmStart>,
        effort: &mut Effort,
    ) -> Result<Solved, Error> {
        let problem = &simulation.problem;
        let (before, elastic_displacement) =
            (self.state.tangential.clone(), self.elastic_displacement.clone());
        let mut gap_by_friction = vec![0.0; problem.frame.len()];
        self.find_displacement(problem, effort);
        if before.is_some() {
            effort.applications += 1;
            gap_by_friction = self.opened_by_friction(problem);
        }
        let (mut latest, mut solved) = (known.cloned(), None);
        alternate(simulation, increment, gap_by_friction, |gap_by_friction| {
            if let Some(solved) = solved.take() {
                latest = Some(self.warm_start(solved));
            }
            self.press_under(simulation, increment, gap_by_friction, effort)?;
            self.state.tangential.clone_from(&before);
            self.elastic_displacement.clone_from(&elastic_displacement);
            effort.applications += 1;
            let pressed = self.displacement_under(problem, None);
            let latest = latest.as_ref();
            let found =
                self.solve_friction(simulation, increment, station, &pressed, latest, effort)?;
            solved = Some(found);
            effort.applications += 1;
            Ok((self.opened_by_friction(problem), self.state.approach))
        })?;
        Ok(solved.unwrap_or_default())
    }
}
