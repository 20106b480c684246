//! The part of the frame that a run works on, where the rest is far from the contact.
//!
//! Where surfaces stay opposite each other, what is far from the contact neither touches nor wears. The histories of a run live
//! in a window then: the same problem on a part of the frame, with the same elements. Pressures only open the gaps beside it, so
//! that no pair there touches while the approach stays below all of them. A solve that comes closer fails as one that fills its
//! frame does (`Simulation::beside`), and the step is taken again in a larger window. What is shown lies in the frame.

use std::sync::{Arc, OnceLock};

use serde::{Deserialize, Serialize};

use super::Simulation;
use super::evolution::Evolution;
use crate::frame::{ContactFrame, Part, extent};
use crate::motion::Motion;
use crate::numerics::vector::map;
use crate::problem::{ContactProblem, ContactState, Gap};

/// Gaps, over the approach, up to which pairs lie in a window.
const AMPLE: f64 = 2.0;
/// Approach, over the lowest gap beside a window, from which on a larger one is taken.
const NEAR: f64 = 0.8;
/// Elements on each side of those pairs.
const MARGIN: usize = 1;
/// A distance (m) to try on pairs that are open.
const SLIP: f64 = 1e-3;

/// A part of the frame around the contact.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct Window {
    part: Part,
    /// What goes on in it; made where it is needed.
    #[serde(skip)]
    simulation: OnceLock<Arc<Simulation>>,
}

impl Window {
    /// One with room for an approach (m) to grow; `None` where it would be nearly the whole frame, or what is beside it may
    /// count.
    pub fn around(simulation: &Simulation, approach: f64) -> Option<Self> {
        let problem = &simulation.problem;
        let frame = &problem.frame;
        if !stays_apart(problem) {
            return None;
        }
        let near = extent(frame.elements(), |pair| frame.gap()[pair] < AMPLE * approach)?;
        let part = Part::around(frame.elements(), &near, [MARGIN; 2])?;
        let window = Self { part, simulation: OnceLock::new() };
        let within = window.make(simulation)?;
        Some(Self { simulation: OnceLock::from(within), ..window })
    }

    /// The problem in the window, and all else as in a simulation.
    pub fn simulation(&self, simulation: &Simulation) -> Option<Arc<Simulation>> {
        let made = || self.make(simulation);
        self.simulation.get().cloned().or_else(|| {
            let made = made()?;
            Some(Arc::clone(self.simulation.get_or_init(|| made)))
        })
    }

    fn make(&self, simulation: &Simulation) -> Option<Arc<Simulation>> {
        let Simulation { problem, solver, friction_solver, schedule, .. } = simulation;
        let gap = problem.frame.gap();
        let beside = (0..gap.len()).filter(|&pair| self.part.place(pair).is_none());
        Some(Arc::new(Simulation {
            problem: ContactProblem {
                bodies: problem.bodies.clone(),
                frame: problem.frame.within(&self.part)?,
                compliance: problem.compliance.alone_within(&self.part)?,
                friction: problem.friction.clone(),
                motion: problem.motion.clone(),
            },
            solver: Arc::clone(solver),
            friction_solver: Arc::clone(friction_solver),
            schedule: schedule.clone(),
            companion: None,
            wider: None,
            beside: beside.map(|pair| gap[pair]).fold(f64::INFINITY, f64::min),
        }))
    }

    /// A larger one for histories that come to an approach (m); `None` where that is nearly the whole frame.
    pub fn larger(&self, simulation: &Simulation, approach: f64) -> Option<Self> {
        let beside = self.simulation(simulation)?.beside;
        Self::around(simulation, approach.max(beside))
    }

    /// Whether the next step at an approach (m) had better be taken in a larger one.
    pub fn is_narrow(&self, simulation: &Simulation, approach: f64) -> bool {
        self.simulation(simulation).is_none_or(|within| approach > NEAR * within.beside)
    }

    /// A field of the window, zero beside it; an empty one stays empty.
    pub fn put(&self, field: &[f64]) -> Vec<f64> {
        if field.is_empty() { vec![] } else { self.part.put(field) }
    }

    /// What lies in the window of a field of the frame.
    pub fn cut(&self, field: &[f64]) -> Vec<f64> {
        if field.is_empty() { vec![] } else { self.part.cut(field) }
    }

    /// A state of the window in the frame.
    pub fn put_state(&self, state: &ContactState, frame: &ContactFrame) -> ContactState {
        let apart = map([frame.gap()], |[gap]| gap - state.approach);
        let part = state.gap.part.map_or(self.part, |inner| inner.lying_in(&self.part));
        ContactState {
            progress: state.progress,
            approach: state.approach,
            load: state.load,
            pressure: self.put(&state.pressure),
            gap: Gap { values: self.part.pasted(&state.gap.values, apart), part: Some(part) },
            worn: state.worn.each_ref().map(|worn| self.put(worn)),
            slid: state.slid.each_ref().map(|slid| self.put(slid)),
            swung: None,
            tangential: None,
        }
    }

    /// A history in the window, in the frame.
    pub fn put_history(&self, history: &Evolution, frame: &ContactFrame) -> Evolution {
        let known = history.known.map_or(self.part, |inner| inner.lying_in(&self.part));
        Evolution {
            state: self.put_state(&history.state, frame),
            displacement: self.put(&history.displacement),
            known: Some(known),
            ..*history
        }
    }

    /// A history in the frame, in the window.
    pub fn cut_history(&self, history: &Evolution) -> Evolution {
        let state = &history.state;
        // What is known of the window; of a smaller part, that.
        let known = |known: Option<Part>| {
            let part = known.filter(|known| !known.holds(&self.part.extent()))?;
            Some(part.seen_from(&self.part).unwrap_or_else(|| Part::none(self.part.size())))
        };
        Evolution {
            state: ContactState {
                progress: state.progress,
                approach: state.approach,
                load: state.load,
                pressure: self.cut(&state.pressure),
                gap: Gap { values: self.cut(&state.gap.values), part: known(state.gap.part) },
                worn: state.worn.each_ref().map(|worn| self.cut(worn)),
                slid: state.slid.each_ref().map(|slid| self.cut(slid)),
                swung: None,
                tangential: None,
            },
            displacement: self.cut(&history.displacement),
            known: known(history.known),
            ..*history
        }
    }
}

/// Whether nothing happens to pairs that are far from the contact: surfaces stay opposite each other, no heat flows along
/// them, they do not end or repeat themselves, and pairs that are open do not wear.
fn stays_apart(problem: &ContactProblem) -> bool {
    let frame = &problem.frame;
    let motion = &problem.motion;
    let stay = matches!(motion, Motion::Sliding(_))
        && motion.passing().is_none()
        && motion.swing().is_none();
    let plain = frame.is_uniform() && !frame.is_line() && !frame.measure().closed;
    let open = || {
        let rubbing = problem.rubbing(0.0, SLIP, motion.slides());
        problem.wear(std::iter::once(rubbing), [true; 2], |_, _| [0.0; 2])
    };
    stay && plain && !problem.goes_by_temperature() && open().depth(0) == 0.0
}
