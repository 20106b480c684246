//! One increment of bodies that are pressed and shifted against each other.
//!
//! Slip is referred to the last converged state: what the bodies were shifted by since, less what their
//! surfaces were displaced elastically by.

use super::WarmStart;
use crate::frame::VectorField;
use crate::friction::{Grip, Limits};
use crate::motion::{Drive, Shift, Station};
use crate::numerics::vector::{map, update};
use crate::problem::{ContactProblem, ContactState, Tangential};
use crate::simulation::effort::Effort;
use crate::simulation::error::Error;
use crate::simulation::friction;
use crate::simulation::memory::{History, Increment, Rubbed};
use crate::simulation::moving::{Move, Moving};
use crate::simulation::setup::Simulation;
use crate::solve::monolithic;
use crate::solve::tangential::{self, PrescribedForce};

/// What a solve left behind besides the state.
#[derive(Default)]
pub(super) struct Solved {
    /// Largest tractions (Pa) of the pairs.
    pub limit: Vec<f64>,
    /// Slips (m) along the directions whose force is given.
    pub rigid_slip: Vec<f64>,
    pub monolithic: Option<monolithic::Solution>,
}

impl History {
    /// Bodies that just touch, with friction as far as the motion asks for it.
    pub(in crate::simulation) fn untouched(problem: &ContactProblem) -> Self {
        let pairs = problem.frame.len();
        let zeros = || [vec![0.0; pairs], vec![0.0; pairs]];
        let mut history = Self::new(problem);
        let moves = problem.motion.increments().is_some_and(Shift::moves);
        history.state.tangential =
            (moves || problem.friction.is_some() || problem.wears()).then(|| Tangential {
                traction: zeros(),
                slip: zeros(),
                creepage: [0.0; 2],
                shift: [0.0; 2],
                grip: Grip::default(),
            });
        Self { elastic_displacement: zeros(), rubbed: Rubbed::none(pairs), ..history }
    }

    /// The same in a larger frame, with the displacement of all tractions there.
    pub(in crate::simulation) fn strained(&self, to: &Moving<'_>, effort: &mut Effort) -> Self {
        let problem = to.problem();
        let mut moved = self.moved(to);
        moved.find_displacement(problem, effort);
        // Beyond the smaller frame too the surfaces were displaced and opened.
        effort.applications += 1;
        let tangential = moved.state.tangential.as_ref();
        let strain = moved.displacement_under(problem, tangential.map(|one| &one.traction));
        let [x, y] = &self.elastic_displacement;
        moved.elastic_displacement = [to.over(x, strain.t1), to.over(y, strain.t2)];
        let opened = map([&moved.displacement, &strain.n], |[pressed, rubbed]| pressed + rubbed);
        moved.state.gap = moved.state.gap.opened_by(opened).into();
        moved
    }

    /// Takes the bodies apart without rubbing.
    pub(in crate::simulation) fn release(&mut self, problem: &ContactProblem) {
        let apart = Self::untouched(problem);
        let before = std::mem::replace(self, apart);
        let History { state, rubbed, course, load_distance, dissipated, forward, .. } = before;
        self.state.surfaces = state.surfaces;
        (self.rubbed, self.course) = (rubbed, course);
        (self.load_distance, self.dissipated, self.forward) = (load_distance, dissipated, forward);
        let worn = self.state.total_worn();
        update(&mut self.state.gap.values, [&worn], |gap, [worn]| gap + worn);
    }

    /// The same without what friction remembers.
    pub(in crate::simulation) fn pressed_alone(self) -> Self {
        let Self { state, displacement, known, load_distance, dissipated, forward, .. } = self;
        Self { known, load_distance, dissipated, forward, ..Self::at(state, displacement) }
    }

    /// Pressures, tractions and gaps before an increment.
    pub(in crate::simulation) fn clone_contact(&self) -> ContactState {
        let state = &self.state;
        let bare = state.surfaces.each_ref().map(|one| one.map(one.grid, |_| vec![]));
        let tangential = state.tangential.clone();
        let (pressure, gap) = (state.pressure.clone(), state.gap.clone());
        ContactState { pressure, gap, surfaces: bare, tangential, ..*state }
    }

    /// Finds the pressures under a gap (m) that friction opens next to.
    pub(super) fn press_under(
        &mut self,
        simulation: &Simulation,
        increment: Increment,
        gap_by_friction: &[f64],
        effort: &mut Effort,
    ) -> Result<(), Error> {
        let problem = &simulation.problem;
        let gap =
            map([&self.undeformed_gap(problem), gap_by_friction], |[gap, gap_by_friction]| {
                gap + gap_by_friction
            });
        let addition = vec![0.0; gap.len()];
        self.solve_normal(simulation, increment, &gap, &addition, &*problem.compliance, effort)?;
        // What open pairs slide until they touch asks for the gap of all of them.
        self.complete(problem, effort);
        Ok(())
    }

    /// Displacement (m) under the present pressures and these tractions (Pa): tangential, and how far it
    /// opens the gap next to the pressures' own.
    pub(super) fn displacement_under(
        &self,
        problem: &ContactProblem,
        traction: Option<&[Vec<f64>; 2]>,
    ) -> VectorField {
        let pairs = problem.frame.len();
        let zeros = || [vec![0.0; pairs], vec![0.0; pairs]];
        let couples = problem.compliance.couples();
        if couples {
            let [t1, t2] = traction.cloned().unwrap_or_else(zeros);
            let n = self.state.pressure.iter().map(|pressure| -pressure).collect();
            let mut strain = problem.compliance.apply(&VectorField { t1, t2, n });
            for (n, own) in strain.n.iter_mut().zip(&self.displacement) {
                *n = -*n - own;
            }
            return strain;
        }
        let mut strain = VectorField::zeros(pairs);
        if let Some([one, two]) = traction.filter(|_| problem.friction.is_some()) {
            let map = problem.compliance.shifting(&problem.frame);
            map.apply([one, two], [&mut strain.t1, &mut strain.t2]);
        }
        strain
    }

    /// Slip (m) before any tangential traction, with the strains of the pressures taken off, and the
    /// directions in which a force is given.
    pub(super) fn slip_of_shift(
        &self,
        problem: &ContactProblem,
        station: Station,
        pressed: Option<&VectorField>,
    ) -> ([Vec<f64>; 2], Vec<PrescribedForce>) {
        let [x, y] = self.shifted_since(station);
        // Where pressures are found with friction, so is the approach.
        let approach = if pressed.is_some() { self.state.approach } else { 0.0 };
        let moved = problem.frame.moved([x, y, self.approached - approach]);
        let mut rigid = [0, 1].map(|axis| {
            let (elastic_displacement, moved) =
                (&self.elastic_displacement[axis], [&moved.t1, &moved.t2][axis]);
            match pressed {
                Some(pressed) => {
                    let pressed = [&pressed.t1, &pressed.t2][axis];
                    map(
                        [moved, elastic_displacement, pressed],
                        |[moved, elastic_displacement, pressed]| {
                            moved + elastic_displacement - pressed
                        },
                    )
                }
                None => map([moved, elastic_displacement], |[moved, elastic_displacement]| {
                    moved + elastic_displacement
                }),
            }
        });
        if let Some(until_touch) = &self.until_touch {
            for (rigid, slid) in rigid.iter_mut().zip(until_touch) {
                update(rigid, [slid], |rigid, [slid]| rigid - slid);
            }
        }
        let prescribed = [0, 1].into_iter().filter_map(|axis| match station.guides[axis] {
            Drive::Slip(_) => None,
            Drive::Force(force) => {
                let mut direction = [0.0; 2];
                direction[axis] = 1.0;
                Some(PrescribedForce { direction, force })
            }
        });
        (rigid, prescribed.collect())
    }

    /// What the bodies are shifted by until a station (m), where that is given.
    fn shifted_since(&self, station: Station) -> [f64; 2] {
        let shift = self.shift();
        [0, 1].map(|axis| match station.guides[axis] {
            Drive::Slip(target) => target - shift[axis],
            Drive::Force(_) => 0.0,
        })
    }

    /// Gap (m) that a shift which is given opens until a station: on curved frames.
    pub(super) fn opened_by_shift(&self, problem: &ContactProblem, station: Station) -> Vec<f64> {
        let [x, y] = self.shifted_since(station);
        if problem.frame.is_plane() || [x, y] == [0.0; 2] {
            return vec![0.0; problem.frame.len()];
        }
        problem.frame.moved([x, y, 0.0]).n
    }

    fn shift(&self) -> [f64; 2] {
        self.state.tangential.as_ref().map_or([0.0; 2], |tangential| tangential.shift)
    }

    /// The shift after an increment, given or found.
    pub(super) fn shift_at(&self, station: Station, rigid_slip: &[f64]) -> [f64; 2] {
        let (before, mut rigid_slip) = (self.shift(), rigid_slip.iter());
        [0, 1].map(|axis| match station.guides[axis] {
            Drive::Slip(shift) => shift,
            Drive::Force(_) => before[axis] + rigid_slip.next().copied().unwrap_or(0.0),
        })
    }

    /// Finds the friction under the present pressures, whose own tangential displacement is given.
    pub(super) fn solve_friction(
        &mut self,
        simulation: &Simulation,
        increment: Increment,
        station: Station,
        pressed: &VectorField,
        known: Option<&WarmStart>,
        effort: &mut Effort,
    ) -> Result<Solved, Error> {
        let problem = &simulation.problem;
        let frame = &problem.frame;
        let (rigid, prescribed) = self.slip_of_shift(problem, station, Some(pressed));
        let Some(law) = &problem.friction else {
            let traction = [vec![0.0; frame.len()], vec![0.0; frame.len()]];
            self.elastic_displacement = [pressed.t1.clone(), pressed.t2.clone()];
            self.approached = self.state.approach;
            let shift = self.shift_at(station, &[]);
            let creepage = [0.0; 2];
            self.state.tangential =
                Some(Tangential { traction, slip: rigid, creepage, shift, grip: Grip::default() });
            return Ok(Solved::default());
        };
        let grip = problem.grip_of_shift(&**law, &self.state);
        let limit = Limits::new(&**law, &grip).all(&self.state.pressure);
        let shifting = problem.compliance.shifting(frame);
        let step = tangential::Step {
            map: &*shifting,
            elements: frame.elements(),
            measure: frame.measure(),
            limit: &limit,
            rigid: [&rigid[0], &rigid[1]],
            prescribed: &prescribed,
        };
        let now = self.state.tangential.as_ref();
        let rigid_slip = vec![0.0; prescribed.len()];
        let start = match known.and_then(|known| Some((known.state.tangential.as_ref()?, known))) {
            Some((tangential, known)) => {
                Some((&tangential.traction, &known.limit, &known.rigid_slip))
            }
            None => now.map(|tangential| (&tangential.traction, &limit, &rigid_slip)),
        };
        let start = start.map(|([one, two], limit, rigid_slip)| tangential::Start {
            traction: [one, two],
            limit,
            rigid_slip,
        });
        let tangential::Outcome { traction, rigid_slip, .. } =
            friction::solve(simulation, increment, law.map().into(), (&step, start), effort)?;
        let shift = self.shift_at(station, &rigid_slip);
        effort.applications += 1;
        let strain = self.displacement_under(problem, Some(&traction));
        self.take_tractions(problem, (traction, grip), shift, strain);
        Ok(Solved { limit, rigid_slip, monolithic: None })
    }

    /// Takes tractions over that were found with a grip, with the slip since the last state.
    pub(super) fn take_tractions(
        &mut self,
        problem: &ContactProblem,
        (traction, grip): ([Vec<f64>; 2], Grip),
        shift: [f64; 2],
        strain: VectorField,
    ) {
        let before = self.shift();
        let [x, y] = [0, 1].map(|axis| shift[axis] - before[axis]);
        let approach = self.state.approach;
        let moved = problem.frame.moved([x, y, self.approached - approach]);
        let elastic_displacement = [strain.t1, strain.t2];
        let slip = [0, 1].map(|axis| {
            let moved = [&moved.t1, &moved.t2][axis];
            map(
                [moved, &self.elastic_displacement[axis], &elastic_displacement[axis]],
                |[moved, before, after]| moved + before - after,
            )
        });
        self.elastic_displacement = elastic_displacement;
        self.approached = approach;
        self.state.tangential =
            Some(Tangential { traction, slip, creepage: [0.0; 2], shift, grip });
    }
}
