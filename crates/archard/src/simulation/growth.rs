//! A run whose contact comes to the rim of its frame goes on in a larger one.
//!
//! The frame is a part of an endless grid. A step that ends with pairs at the rim under pressure, or with surfaces beyond that
//! may touch, did not see all of the contact: it is taken again in a frame with more elements of the same size, from where
//! it began. What lies beyond was neither pressed nor worn until then, but for lines of surfaces that pass, which are worn all
//! along. So the run is the one that the larger frame would have given from the beginning.

use std::sync::{Arc, OnceLock};

use serde::{Deserialize, Serialize};

use super::evolution::{Evolution, unworn};
use super::surroundings::More;
use super::{Error, Simulation};
use crate::frame::{ContactFrame, Part};
use crate::numerics::vector::map;
use crate::problem::{ContactProblem, ContactState, Gap, Surface, Tangential, Unworn};

/// A frame that has grown.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct Growth {
    /// The frame that the simulation begins with, as a part of the present one.
    began: Part,
    #[serde(skip)]
    simulation: OnceLock<Arc<Simulation>>,
}

impl Growth {
    /// One that has so many elements more than a frame, which may have grown before; `None` where the surfaces end before. The
    /// simulation is that of the frame at the beginning.
    ///
    /// # Errors
    /// If it had more than it may have.
    pub fn by(
        simulation: &Simulation,
        before: Option<&Self>,
        (more, progress): (More, f64),
    ) -> Result<Option<Self>, Error> {
        let elements = simulation.problem.frame.elements();
        let began = before.map_or_else(|| Part::inside(elements, [[0; 2]; 2]), |one| one.began);
        let larger = began.lying_in(&Part::inside(began.frame(), more));
        let [columns, rows] = larger.frame();
        if columns.saturating_mul(rows) > simulation.most {
            let measure = simulation.problem.motion.progress();
            return Err(Error::Outgrown { measure, progress, elements: larger.frame() });
        }
        let one = Self { began: larger, simulation: OnceLock::new() };
        let made = one.simulation(simulation).is_some();
        Ok(made.then_some(one))
    }

    /// The simulation in the present frame, from that at the beginning; `None` where a surface does not reach so far.
    pub fn simulation(&self, simulation: &Simulation) -> Option<Arc<Simulation>> {
        if let Some(present) = self.simulation.get() {
            return Some(Arc::clone(present));
        }
        let made = Arc::new(simulation.around(&self.began)?);
        Some(Arc::clone(self.simulation.get_or_init(|| made)))
    }

    /// The same, where it has been made.
    pub fn present(&self, simulation: &Simulation) -> Option<&Simulation> {
        self.simulation(simulation)?;
        self.simulation.get().map(|present| &**present)
    }

    /// How fields go over from an earlier frame, the one at the beginning or one that had grown, to the present one.
    pub fn from<'a>(&self, before: Option<&Self>, problems: [&'a ContactProblem; 2]) -> Moved<'a> {
        let part = match before {
            Some(before) => self.began.seen_around(&before.began),
            None => self.began,
        };
        let [smaller, problem] = problems;
        Moved { part, smaller, problem }
    }
}

impl Simulation {
    /// The same in a larger frame, of which its own is a part.
    fn around(&self, part: &Part) -> Option<Self> {
        let profiles = self.problem.bodies.each_ref().map(|body| &*body.profile);
        self.on(self.problem.frame.around(part, profiles)?)
    }

    /// The same on another part of its endless grid; `None` where the compliance is none there.
    pub(super) fn on(&self, frame: ContactFrame) -> Option<Self> {
        let Self { problem, solver, friction_solver, schedule, .. } = self;
        Some(Self {
            problem: ContactProblem {
                bodies: problem.bodies.clone(),
                compliance: problem.compliance.on(frame.elements())?,
                frame,
                friction: problem.friction.clone(),
                motion: problem.motion.clone(),
                unworn: Unworn::default(),
            },
            solver: Arc::clone(solver),
            friction_solver: Arc::clone(friction_solver),
            schedule: schedule.clone(),
            companions: None,
            wider: None,
            beside: f64::INFINITY,
            most: self.most,
            surroundings: OnceLock::new(),
        })
    }
}

/// How fields go over from one frame to a larger one.
#[derive(Debug, Clone, Copy)]
pub(super) struct Moved<'a> {
    /// The smaller frame in the larger one.
    part: Part,
    /// The problem in both.
    smaller: &'a ContactProblem,
    problem: &'a ContactProblem,
}

impl<'a> Moved<'a> {
    /// The problem in the smaller frame.
    pub fn smaller(&self) -> &'a ContactProblem {
        self.smaller
    }

    /// The problem in the larger frame.
    pub fn problem(&self) -> &'a ContactProblem {
        self.problem
    }

    /// A field that is zero beyond; an empty one stays empty.
    pub fn field(&self, field: &[f64]) -> Vec<f64> {
        if field.is_empty() { vec![] } else { self.part.put(field) }
    }

    /// Two of them.
    pub fn both(&self, fields: &[Vec<f64>; 2]) -> [Vec<f64>; 2] {
        fields.each_ref().map(|field| self.field(field))
    }

    /// A field with these values beyond.
    pub fn over(&self, field: &[f64], beyond: Vec<f64>) -> Vec<f64> {
        self.part.pasted(field, beyond)
    }

    /// Values of some pairs, others beyond.
    pub fn each<T: Clone + Default>(&self, values: &[T]) -> Vec<T> {
        if values.is_empty() {
            return vec![];
        }
        let all = 0..self.problem.frame.len();
        all.map(|pair| self.part.place(pair).map_or_else(T::default, |own| values[own].clone()))
            .collect()
    }

    /// The surfaces of both bodies, unworn beyond.
    pub fn surfaces(&self, surfaces: &[Surface; 2]) -> [Surface; 2] {
        let first = self.part.extent().map(|range| range.start);
        let grids = unworn(self.problem).map(|one| one.grid);
        [0, 1].map(|body| surfaces[body].moved(first, grids[body]))
    }

    /// A state. Its gap beyond is that without what the pressures open it by.
    pub fn state(&self, state: &ContactState) -> ContactState {
        let surfaces = self.surfaces(&state.surfaces);
        let worn = surfaces.each_ref().map(Surface::worn);
        let apart = map([self.problem.frame.gap(), &worn[0], &worn[1]], |[gap, one, two]| {
            gap + one + two - state.approach
        });
        let known = state.gap.part.map_or(self.part, |inner| inner.lying_in(&self.part));
        ContactState {
            progress: state.progress,
            approach: state.approach,
            load: state.load,
            pressure: self.field(&state.pressure),
            gap: Gap { values: self.part.pasted(&state.gap.values, apart), part: Some(known) },
            surfaces,
            tangential: state.tangential.as_ref().map(|tangential| Tangential {
                traction: self.both(&tangential.traction),
                slip: self.both(&tangential.slip),
                grip: tangential.grip.map(|grip| self.over(grip, vec![1.0; self.pairs()])),
                ..*tangential
            }),
        }
    }

    fn pairs(&self) -> usize {
        self.problem.frame.len()
    }

    /// A history.
    pub fn history(&self, history: &Evolution) -> Evolution {
        let known = history.known.map_or(self.part, |inner| inner.lying_in(&self.part));
        Evolution {
            state: self.state(&history.state),
            displacement: self.field(&history.displacement),
            known: Some(known),
            ..*history
        }
    }
}
