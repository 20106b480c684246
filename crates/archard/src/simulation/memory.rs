//! What goes on from step to step: the contact, the worn surfaces, and where friction is sought what it remembers.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::effort::Effort;
use super::error::Error;
use super::positions::positions;
use super::setup::Simulation;
use super::touch::Course;
use crate::compliance::Compliance;
use crate::frame::Part;
use crate::motion::{Control, PassingSurfaces};
use crate::numerics::vector;
use crate::problem::{ContactProblem, ContactState, Gap, Grid, Surface, Tangential};
use crate::solve::{self, Outcome, Start, Status, Step};
use crate::wear::Rubbing;

/// Where a history has arrived.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct History {
    /// The contact and the worn depths.
    pub state: ContactState,
    /// Displacement the compliance makes of the pressure (m).
    pub displacement: Vec<f64>,
    /// Where in the frame it is known; everywhere if `None`.
    pub known: Option<Part>,
    /// Tangential displacement (m) that the compliance makes of all tractions, and the approach (m) that goes with it; empty where
    /// nothing sticks to remember it.
    pub elastic_displacement: [Vec<f64>; 2],
    pub approached: f64,
    /// How pairs that close slide meanwhile, as the increments so far show, and what open pairs slide (m) until
    /// they touch in the present one.
    pub course: Option<Arc<Course>>,
    pub until_touch: Option<[Vec<f64>; 2]>,
    /// What rubbing did since the present cycle began.
    pub rubbed: Rubbed,
    /// Integral of the load over the distance slid (N m); see [`Effort::load_distance`].
    pub load_distance: f64,
    /// Energy (J) that friction dissipated in whole cycles.
    pub dissipated: f64,
    /// Of surfaces that swing: whether the last pass went forward.
    pub forward: bool,
}

/// What rubbing did since a cycle began.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub(super) struct Rubbed {
    /// Depth worn off body 1 and body 2 (m), one value a pair.
    pub depths: [Vec<f64>; 2],
    /// The same by the slope of the laws: pressure times the derivative of the depth (m).
    pub slopes: [Vec<f64>; 2],
    /// Distance slid in contact (m), and its integral with the pressure (Pa m), one value a pair.
    pub slip: Vec<f64>,
    pub work: Vec<f64>,
    /// Energy dissipated (J).
    pub dissipated: f64,
    /// All that pairs went through, where a law takes a whole cycle.
    pub whole: Vec<Option<Rubbing>>,
}

impl Rubbed {
    /// Nothing, at so many pairs.
    pub fn none(pairs: usize) -> Self {
        let zeros = || vec![0.0; pairs];
        let [depths, slopes] = [[zeros(), zeros()], [zeros(), zeros()]];
        Self { depths, slopes, slip: zeros(), work: zeros(), dissipated: 0.0, whole: vec![] }
    }
}

/// The part of a step that is the same for every history.
#[derive(Debug, Clone, Copy)]
pub(super) struct Increment {
    /// Length (the motion's unit).
    pub advance: f64,
    /// Progress at its end (the motion's unit).
    pub progress: f64,
    /// Load or approach at its end.
    pub control: Control,
}

/// The surfaces of both bodies before any wear.
pub(super) fn unworn(problem: &ContactProblem) -> [Surface; 2] {
    let frame = problem.frame.elements();
    let mut grids = [Grid::of_pairs(frame); 2];
    if let Some(PassingSurfaces { direction, bodies, .. }) = problem.motion.passing()
        && problem.frame.flow(direction).is_ok_and(|flow| flow.has_rows())
    {
        for (grid, _) in grids.iter_mut().zip(bodies).filter(|(_, passes)| *passes) {
            *grid = Grid::passing(frame, direction.axis);
        }
    }
    if let Some(own) = positions(problem).map(|seen| seen.grids()) {
        grids = [0, 1].map(|body| own[body].unwrap_or(grids[body]));
    }
    let bodies = [0, 1].map(|body| (grids[body], problem.bodies[body].hardness.is_some()));
    bodies.map(|(grid, yields)| Surface::unworn(grid, problem.counts_distance(), yields))
}

impl History {
    /// Unworn bodies, just touching.
    pub fn new(problem: &ContactProblem) -> Self {
        let untouched = ContactState::untouched(&problem.frame);
        let state = ContactState { surfaces: unworn(problem), ..untouched };
        let displacement = vec![0.0; problem.frame.len()];
        Self::at(state, displacement)
    }

    /// In a state whose pressures displace the surfaces by that much (m).
    pub fn at(state: ContactState, displacement: Vec<f64>) -> Self {
        Self {
            state,
            displacement,
            known: None,
            elastic_displacement: [vec![], vec![]],
            approached: 0.0,
            course: None,
            until_touch: None,
            rubbed: Rubbed::default(),
            load_distance: 0.0,
            dissipated: 0.0,
            forward: false,
        }
    }

    /// Solves the contact with the wear as it is.
    pub fn press(
        &mut self,
        simulation: &Simulation,
        increment: Increment,
        effort: &mut Effort,
    ) -> Result<(), Error> {
        let problem = &simulation.problem;
        let addition = vec![0.0; self.displacement.len()];
        let gap = self.undeformed_gap(problem);
        self.contact(simulation, increment, (&gap, &addition), &*problem.compliance, effort)?;
        self.imprint(problem);
        Ok(())
    }

    /// Solves the contact anew, where only pressures and wear are known.
    pub fn press_anew(
        &mut self,
        simulation: &Simulation,
        effort: &mut Effort,
    ) -> Result<(), Error> {
        self.find_displacement(&simulation.problem, effort);
        let progress = self.state.progress;
        let control = simulation.schedule.control_at(progress);
        self.press(simulation, Increment { advance: 0.0, progress, control }, effort)
    }

    /// Where bodies bear the hardness and overlap, the softer one keeps the overlap as an imprint; both do by half where they are as
    /// hard.
    pub(super) fn imprint(&mut self, problem: &ContactProblem) {
        let hardness = problem.hardness();
        if hardness.is_infinite() {
            return;
        }
        let soft = problem.bodies.each_ref().map(|body| body.hardness == Some(hardness));
        let share = 1.0 / soft.into_iter().filter(|soft| *soft).count() as f64;
        let state = &mut self.state;
        for (surface, _) in state.surfaces.iter_mut().zip(soft).filter(|(_, soft)| *soft) {
            let fields: [&[f64]; 2] = [&state.gap.values, &state.pressure];
            vector::update(&mut surface.imprint, fields, |imprint, [gap, pressure]| {
                if pressure >= hardness { imprint + share * (-gap).max(0.0) } else { imprint }
            });
        }
        vector::update(&mut state.gap.values, [&state.pressure], |gap, [pressure]| {
            if pressure >= hardness { gap.max(0.0) } else { gap }
        });
    }

    /// Pressures, and friction where the bodies roll, under a gap (m), with what pairs give way next to the compliance
    /// (m/Pa).
    pub(super) fn contact(
        &mut self,
        simulation: &Simulation,
        increment: Increment,
        (gap, addition): (&[f64], &[f64]),
        compliance: &dyn Compliance,
        effort: &mut Effort,
    ) -> Result<(), Error> {
        if simulation.problem.motion.driven(increment.progress).is_some() {
            return self.solve_rolling(simulation, increment, (gap, addition), compliance, effort);
        }
        if let Some(wrap) = simulation.problem.frame.wrap() {
            let body = (compliance, wrap);
            return self.solve_free(simulation, increment, (gap, addition), body, effort);
        }
        self.solve_normal(simulation, increment, gap, addition, compliance, effort)
    }

    /// The load (N) that is given; the one found where the approach is.
    pub(super) fn prescribed_load(&self, increment: Increment) -> f64 {
        match increment.control {
            Control::Load(load) => load,
            Control::Approach(_) => self.state.load,
        }
    }

    /// Gap of the worn, undeformed surfaces at zero approach (m), shifted as they are.
    pub(super) fn undeformed_gap(&self, problem: &ContactProblem) -> Vec<f64> {
        let [first, second] = [self.state.lowered(0), self.state.lowered(1)];
        let frame = &problem.frame;
        let mut gap = vector::map([frame.gap(), &first, &second], |[gap, first, second]| {
            gap + first + second
        });
        if let Some(Tangential { shift: [x, y], .. }) = &self.state.tangential
            && !frame.is_plane()
        {
            let gap_by_friction = frame.moved([*x, *y, 0.0]).n;
            vector::update(&mut gap, [&gap_by_friction], |gap, [gap_by_friction]| {
                gap + gap_by_friction
            });
        }
        gap
    }

    /// Computes the displacement anew, where the pressures come from a solve that does not know it: that of
    /// pressures and friction at once.
    pub(super) fn find_displacement(&mut self, problem: &ContactProblem, effort: &mut Effort) {
        effort.applications += 1;
        problem.compliance.apply_normal(&self.state.pressure, &mut self.displacement);
        self.known = None;
    }

    /// Finds displacement and gap also where the last solve did not look.
    pub(super) fn complete(&mut self, problem: &ContactProblem, effort: &mut Effort) {
        if self.known.is_some() {
            self.find_displacement(problem, effort);
        }
        if self.state.gap.part.is_some() {
            self.state.gap = self.state.gap.opened_by(self.displacement.clone()).into();
        }
    }

    /// Lets pressures go on as they did since earlier ones (Pa), to start the next solve from.
    pub(super) fn foresee(&mut self, earlier: &[f64], problem: &ContactProblem) {
        vector::update(&mut self.state.pressure, [earlier], |now, [earlier]| {
            if now > 0.0 { (2.0 * now - earlier).max(0.0) } else { 0.0 }
        });
        self.known = Some(Part::none(problem.frame.elements()));
    }

    /// Takes a solution over.
    fn take(&mut self, outcome: Outcome, simulation: &Simulation, increment: Increment) {
        let Outcome { pressure, displacement, gap, part, approach, .. } = outcome;
        let gap = Gap { values: gap, part };
        (self.displacement, self.known) = (displacement, part);
        let load = simulation.problem.frame.measure().load(&pressure);
        let state = &mut self.state;
        (state.progress, state.approach, state.load) = (increment.progress, approach, load);
        (state.pressure, state.gap) = (pressure, gap);
    }

    /// Finds the pressures that close a gap (m).
    pub(super) fn solve_normal(
        &mut self,
        simulation: &Simulation,
        increment: Increment,
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
            elements: problem.frame.elements(),
            measure: problem.frame.measure(),
            control: increment.control,
            hardness: problem.hardness(),
        };
        let ContactState { pressure, approach, .. } = &self.state;
        let start = Start {
            pressure,
            displacement: &self.displacement,
            part: self.known,
            approach: *approach,
        };
        let outcome = solve::press(&*simulation.solver, &step, Some(start));
        effort.solves += 1;
        effort.iterations += outcome.iterations;
        effort.applications += outcome.applications;
        effort.residual = outcome.residual;
        match outcome.status {
            Status::Converged if outcome.approach <= simulation.beside => {
                self.take(outcome, simulation, increment);
                Ok(())
            }
            // Surfaces that end or repeat themselves with the frame are full of nothing but yielding pairs.
            Status::FrameFull if step.measure.closed => Err(Error::Overloaded {
                measure: problem.motion.progress,
                progress: increment.progress,
                borne: step.most(),
            }),
            Status::Converged | Status::FrameFull => Err(Error::FrameFull {
                measure: problem.motion.progress,
                progress: increment.progress,
            }),
            Status::OutOfIterations => {
                Err(not_converged(simulation, increment, outcome.iterations, outcome.residual))
            }
        }
    }
}

fn not_converged(
    simulation: &Simulation,
    increment: Increment,
    iterations: usize,
    residual: f64,
) -> Error {
    Error::NotConverged {
        measure: simulation.problem.motion.progress,
        progress: increment.progress,
        iterations,
        residual,
        tolerance: simulation.solver.settings().tolerance,
    }
}
