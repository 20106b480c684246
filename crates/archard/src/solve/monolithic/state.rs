//! An iterate of contact and friction, and how far it is from the solution.

use super::{Mapped, Outcome, Solution, Status};
use crate::frame::VectorField;
use crate::friction::onto_disc;
use crate::motion::Control;
use crate::numerics::vector::map;
use crate::solve::residual::{Measure, norm, relative, worse};

/// Where body 2 moves as the bodies approach, in the axes of the frame.
pub(super) const APPROACH: [f64; 3] = [0.0, 0.0, -1.0];

/// An iterate with its gap and slip.
#[derive(Debug, Clone)]
pub(super) struct State {
    pub solution: Solution,
    /// Gap (m).
    pub gap: Vec<f64>,
    /// Slip (m).
    pub slip: [Vec<f64>; 2],
    /// Displacement (m) of a pair under a unit traction (Pa) on it alone, normal and tangential.
    pub own: [f64; 2],
    pub residual: f64,
}

impl State {
    pub fn new(step: &Mapped<'_>, start: &Solution) -> Self {
        let own = [step.compliance.normal_self_term(), step.compliance.shifting(step.frame).own()];
        let mut solution = start.clone();
        solution.rigid_slip.resize(step.prescribed.len(), 0.0);
        if let Control::Approach(approach) = step.control {
            solution.approach = approach;
        }
        Self::of(solution, own, step)
    }

    fn of(solution: Solution, own: [f64; 2], step: &Mapped<'_>) -> Self {
        let displacement = &solution.displacement;
        let mut moved = APPROACH.map(|component| solution.approach * component);
        for (rigid_slip, prescribed) in solution.rigid_slip.iter().zip(step.prescribed) {
            (0..2).for_each(|axis| moved[axis] += rigid_slip * prescribed.direction[axis]);
        }
        let moved = step.moved(moved);
        let apart = |before: &[f64], moved: &[f64], taken: &[f64]| {
            map([before, moved, taken], |[before, moved, taken]| before + moved - taken)
        };
        let gap = apart(step.gap, &moved.n, &displacement.n);
        let slip = [
            apart(step.rigid[0], &moved.t1, &displacement.t1),
            apart(step.rigid[1], &moved.t2, &displacement.t2),
        ];
        let mut state = Self { solution, gap, slip, own, residual: 0.0 };
        state.residual = state.measure(step);
        state
    }

    /// The state with other tractions and what belongs to them.
    pub fn with(&self, solution: Solution, step: &Mapped<'_>) -> Self {
        Self::of(solution, self.own, step)
    }

    /// The state after a share of a change.
    pub fn moved(&self, change: &Solution, length: f64, step: &Mapped<'_>) -> Self {
        self.with(self.solution.moved(change, length), step)
    }

    /// Pressure (Pa) that gap and pressure of a pair amount to: positive where it is in contact.
    pub fn augmented(&self, pair: usize) -> f64 {
        -self.solution.traction.n[pair] - self.gap[pair] / self.own[0]
    }

    /// Tangential traction (Pa) that slip and traction of a pair amount to: beyond the limit where it slips.
    pub fn augmented_traction(&self, pair: usize) -> [f64; 2] {
        let VectorField { t1, t2, .. } = &self.solution.traction;
        let along = |axis: usize, traction: f64| traction + self.slip[axis][pair] / self.own[1];
        [along(0, t1[pair]), along(1, t2[pair])]
    }

    /// Forces (N) that are missing: the load, if it is given, and those prescribed.
    pub fn missing(&self, step: &Mapped<'_>) -> (Option<f64>, Vec<f64>) {
        let force = step.force(&self.solution.traction);
        let load = match step.control {
            Control::Load(load) => Some(load + force[2]),
            Control::Approach(_) => None,
        };
        let along = |[x, y]: [f64; 2]| x * force[0] + y * force[1];
        let prescribed =
            step.prescribed.iter().map(|prescribed| prescribed.force - along(prescribed.direction));
        (load, prescribed.collect())
    }

    fn measure(&self, step: &Mapped<'_>) -> f64 {
        let (mut off, mut pressed, mut beside, mut borne) = (0.0, 0.0, 0.0, 0.0);
        let (mut total, mut prescribed) = (0.0, 0.0);
        let VectorField { t1, t2, n } = &self.solution.traction;
        let contact = Measure::new(self.own[0], step.control);
        let measure = step.frame.measure();
        for pair in 0..n.len() {
            let (pressure, weight) = (-n[pair], measure.weight.at(pair));
            off += weight * contact.violation(pressure, self.gap[pair], 0.0).powi(2);
            pressed += weight * (pressure * pressure);
            total += weight * pressure.abs();
            let limit = step.friction.at(pair, pressure.max(0.0));
            if limit > 0.0 || t1[pair] != 0.0 || t2[pair] != 0.0 {
                let [x, y] = onto_disc(self.augmented_traction(pair), limit);
                beside += weight * ((t1[pair] - x).powi(2) + (t2[pair] - y).powi(2));
                borne += weight * (limit * limit);
                prescribed += weight * limit;
            }
        }
        let area = measure.area;
        let (load, forces) = self.missing(step);
        let load = relative(load.unwrap_or(0.0).abs(), total * area);
        let force = relative(norm(&forces), prescribed * area);
        let parts = [relative(beside.sqrt(), borne.sqrt()), load, force];
        parts.into_iter().fold(relative(off.sqrt(), pressed.sqrt()), worse)
    }

    /// How it would end: solved to a tolerance, cut off by the frame, or not solved.
    pub fn status(&self, tolerance: f64, step: &Mapped<'_>) -> Status {
        let normal = &self.solution.traction.n;
        let full = !step.frame.measure().closed && normal.iter().all(|&n| n < 0.0);
        match (self.residual <= tolerance, full) {
            (true, false) => Status::Converged,
            (true, true) => Status::FrameFull,
            (false, _) => Status::OutOfIterations,
        }
    }

    /// The state as an outcome.
    pub fn finish(self, status: Status, iterations: usize, applications: usize) -> Outcome {
        let Self { mut solution, gap, residual, .. } = self;
        for n in &mut solution.traction.n {
            // Pressures that are rounding.
            *n = n.min(0.0);
        }
        Outcome { status, solution, gap, iterations, residual, applications }
    }
}
