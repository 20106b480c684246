//! Wear in time: one history of wear, carried from step to step by one contact solve a step.

use serde::{Deserialize, Serialize};

use super::collected::Collected;
use super::{Effort, Error, Simulation};
use crate::compliance::Compliance;
use crate::motion::Control;
use crate::numerics::vector;
use crate::problem::{ContactProblem, ContactState, Tangential};
use crate::solve::{self, Outcome, Start, Status, Step};
use crate::wear::Rubbing;

/// Bound on the disagreement between a wear law and its linearisation, relative to the depth worn.
const LINEARISATION: f64 = 1e-9;
/// Linearisations tried before a step counts as not converged.
const PASSES: usize = 50;

/// Direction in which bodies slide.
const ALONG: [f64; 2] = [1.0, 0.0];

/// Where a history has arrived.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct Chain {
    /// The contact and the worn depths.
    pub state: ContactState,
    /// Displacement the compliance makes of the pressure (m).
    pub displacement: Vec<f64>,
    /// Integral of the load over the distance slid (N m); see [`Effort::load_distance`].
    pub load_distance: f64,
}

/// The part of a step that is the same for every chain.
#[derive(Debug, Clone, Copy)]
pub(super) struct Leg {
    /// Length (the motion's unit).
    pub advance: f64,
    /// Progress at its end (the motion's unit).
    pub progress: f64,
    /// Load or approach at its end.
    pub control: Control,
}

impl Chain {
    /// Unworn bodies, just touching.
    pub fn new(problem: &ContactProblem) -> Self {
        let gap = problem.frame.gap();
        Self {
            state: ContactState::untouched(gap),
            displacement: vec![0.0; gap.len()],
            load_distance: 0.0,
        }
    }

    /// Solves the contact with the wear as it is.
    pub fn press(
        &mut self,
        simulation: &Simulation,
        leg: Leg,
        effort: &mut Effort,
    ) -> Result<(), Error> {
        let problem = &simulation.problem;
        let addition = vec![0.0; self.displacement.len()];
        let gap = self.undeformed_gap(problem);
        match problem.motion.rolling() {
            Some(_) => self.roll_on(simulation, leg, &gap, &*problem.compliance, effort),
            None => self.meet(simulation, leg, &gap, &addition, &*problem.compliance, effort),
        }
    }

    /// An implicit step: the pressure at its end does the wear.
    ///
    /// The wear is linearised about the last pressures, which adds its slope to the compliance; for a
    /// law linear in the pressure the first pass is exact.
    pub fn implicit(
        &mut self,
        simulation: &Simulation,
        leg: Leg,
        effort: &mut Effort,
    ) -> Result<(), Error> {
        let problem = &simulation.problem;
        if let Some(rolling) = problem.motion.rolling() {
            return if rolling.swept || !problem.wears() {
                self.press(simulation, leg, effort)
            } else {
                self.wear_planes(simulation, rolling, leg, effort)
            };
        }
        let slip = problem.motion.slip(leg.advance);
        if slip == 0.0 || !problem.wears() {
            self.press(simulation, leg, effort)?;
            self.load_distance += self.prescribed_load(leg) * slip;
            return Ok(());
        }
        let undeformed = self.undeformed_gap(problem);
        for _ in 0..PASSES {
            let line = Linearised::about(&self.state.pressure, slip, problem);
            let gap = vector::map([&undeformed, &line.constant], |[gap, constant]| gap + constant);
            self.meet(simulation, leg, &gap, &line.slope, &*problem.compliance, effort)?;
            if line.holds(&self.state.pressure, slip, problem) {
                self.wear(slip, problem);
                self.load_distance += self.prescribed_load(leg) * slip;
                return Ok(());
            }
        }
        Err(not_converged(simulation, leg, PASSES, f64::NAN))
    }

    /// An explicit step: the pressure at its start does the wear.
    pub fn explicit(
        &mut self,
        simulation: &Simulation,
        leg: Leg,
        effort: &mut Effort,
    ) -> Result<(), Error> {
        let problem = &simulation.problem;
        let slip = problem.motion.slip(leg.advance);
        let before = simulation.schedule.control_at(self.state.progress);
        self.wear(slip, problem);
        self.load_distance += self.prescribed_load(Leg { control: before, ..leg }) * slip;
        self.press(simulation, leg, effort)
    }

    /// Wears both bodies by rubbing under the present pressures over a slip (m).
    fn wear(&mut self, slip: f64, problem: &ContactProblem) {
        let ContactState { pressure, worn, .. } = &mut self.state;
        for (i, &pressure) in pressure.iter().enumerate().filter(|(_, pressure)| **pressure > 0.0) {
            let depths = problem.wear_depths(problem.rubbing(pressure, slip, ALONG));
            worn.iter_mut().zip(depths).for_each(|(worn, depth)| worn[i] += depth);
        }
    }

    /// The load (N) that is given; the one found where the approach is.
    fn prescribed_load(&self, leg: Leg) -> f64 {
        match leg.control {
            Control::Load(load) => load,
            Control::Approach(_) => self.state.load,
        }
    }

    /// Deepest wear (m) that an advance under the present contact makes.
    pub fn deepest_wear(&self, problem: &ContactProblem, advance: f64) -> Result<f64, Error> {
        if let Some(rolling) = problem.motion.rolling() {
            let flow = problem.frame.flow(rolling.direction)?;
            return Ok(advance * Collected::of(&self.state, problem, flow).deepest());
        }
        let slip = problem.motion.slip(advance);
        let depth = |&pressure: &f64| total_depth(problem, problem.rubbing(pressure, slip, ALONG));
        Ok(self.state.pressure.iter().map(depth).fold(0.0, f64::max))
    }

    /// Gap of the worn, undeformed surfaces at zero approach (m), shifted as they are.
    pub(super) fn undeformed_gap(&self, problem: &ContactProblem) -> Vec<f64> {
        let [first, second] = &self.state.worn;
        let frame = &problem.frame;
        let mut gap =
            vector::map([frame.gap(), first, second], |[gap, first, second]| gap + first + second);
        if let Some(Tangential { shift: [x, y], .. }) = &self.state.tangential
            && !frame.is_plane()
        {
            let opened = frame.moved([*x, *y, 0.0]).n;
            vector::update(&mut gap, [&opened], |gap, [opened]| gap + opened);
        }
        gap
    }

    /// Computes the displacement anew, where the pressures come from a solve that does not know it: that of
    /// pressures and friction at once.
    pub(super) fn find_displacement(&mut self, problem: &ContactProblem, effort: &mut Effort) {
        effort.applications += 1;
        problem.compliance.apply_normal(&self.state.pressure, &mut self.displacement);
    }

    /// Lets pressures go on as they did since earlier ones (Pa), to start the next solve from.
    pub(super) fn foresee(
        &mut self,
        earlier: &[f64],
        problem: &ContactProblem,
        effort: &mut Effort,
    ) {
        vector::update(&mut self.state.pressure, [earlier], |now, [earlier]| {
            if now > 0.0 { (2.0 * now - earlier).max(0.0) } else { 0.0 }
        });
        self.find_displacement(problem, effort);
    }

    /// Takes a solution over.
    fn take(&mut self, outcome: Outcome, simulation: &Simulation, leg: Leg) {
        let Outcome { pressure, displacement, gap, approach, .. } = outcome;
        self.displacement = displacement;
        let load = simulation.problem.frame.measure().load(&pressure);
        let worn = std::mem::take(&mut self.state.worn);
        let tangential = self.state.tangential.take();
        let progress = leg.progress;
        self.state = ContactState { progress, approach, load, pressure, gap, worn, tangential };
    }

    /// Finds the pressures that close a gap (m).
    pub(super) fn meet(
        &mut self,
        simulation: &Simulation,
        leg: Leg,
        gap: &[f64],
        addition: &[f64],
        compliance: &dyn Compliance,
        effort: &mut Effort,
    ) -> Result<(), Error> {
        let problem = &simulation.problem;
        let step = Step {
            compliance,
            gap,
            addition,
            measure: problem.frame.measure(),
            control: leg.control,
        };
        let ContactState { pressure, approach, .. } = &self.state;
        let start = Start { pressure, displacement: &self.displacement, approach: *approach };
        let outcome = solve::press(&*simulation.solver, &step, Some(start));
        effort.solves += 1;
        effort.iterations += outcome.iterations;
        effort.applications += outcome.applications;
        effort.residual = outcome.residual;
        match outcome.status {
            Status::Converged => {
                self.take(outcome, simulation, leg);
                Ok(())
            }
            Status::FrameFull => {
                Err(Error::FrameFull { measure: problem.motion.progress(), progress: leg.progress })
            }
            Status::OutOfIterations => {
                Err(not_converged(simulation, leg, outcome.iterations, outcome.residual))
            }
        }
    }
}

/// The total wear of a step as a straight line in the pressure of each pair.
struct Linearised {
    /// Depth at zero pressure (m).
    constant: Vec<f64>,
    /// Slope (m/Pa).
    slope: Vec<f64>,
}

impl Linearised {
    fn about(pressure: &[f64], slip: f64, problem: &ContactProblem) -> Self {
        let line = |&pressure: &f64| {
            let rubbing = problem.rubbing(pressure, slip, ALONG);
            let slope = problem.wear_slope(rubbing);
            (total_depth(problem, rubbing) - slope * pressure, slope)
        };
        let (constant, slope) = pressure.iter().map(line).unzip();
        Self { constant, slope }
    }

    /// Whether the line agrees with the law at these pressures (Pa).
    fn holds(&self, pressure: &[f64], slip: f64, problem: &ContactProblem) -> bool {
        let (mut error, mut deepest) = (0.0f64, 0.0f64);
        for ((constant, slope), &pressure) in self.constant.iter().zip(&self.slope).zip(pressure) {
            let depth = total_depth(problem, problem.rubbing(pressure, slip, ALONG));
            error = error.max((constant + slope * pressure - depth).abs());
            deepest = deepest.max(depth);
        }
        error <= LINEARISATION * deepest
    }
}

/// Depth worn off both bodies (m).
fn total_depth(problem: &ContactProblem, rubbing: Rubbing) -> f64 {
    problem.wear_depths(rubbing).iter().sum()
}

fn not_converged(simulation: &Simulation, leg: Leg, iterations: usize, residual: f64) -> Error {
    Error::NotConverged {
        measure: simulation.problem.motion.progress(),
        progress: leg.progress,
        iterations,
        residual,
        tolerance: simulation.solver.settings().tolerance,
    }
}
