//! The part of the frame that a run works on, where the rest is far from the contact.
//!
//! Where surfaces stay opposite each other, what is far from the contact neither touches nor wears. The histories of a run live
//! in a window then: the same problem on a part of the frame, with the same elements. Pressures only open the gaps beside it,
//! within the frame and beyond, so that no pair there touches while the approach stays below all of them. A solve that comes
//! closer fails as one that fills its frame does (`Simulation::beside`), and the step is taken again in a larger window. What is
//! shown lies in the frame.

use std::sync::{Arc, OnceLock};

use serde::{Deserialize, Serialize};

use super::Simulation;
use super::evolution::Evolution;
use crate::frame::{ContactFrame, Part, extent};
use crate::motion::Motion;
use crate::numerics::vector::map;
use crate::problem::{ContactProblem, ContactState, Gap, Grid, Surface};

/// Gaps, over the approach, up to which pairs lie in a window.
const AMPLE: f64 = 2.0;
/// Approach, over the lowest gap beside a window, from which on a larger one is taken, or none where that gap is beyond the frame.
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
        if !stays_apart(problem) || approach > NEAR * simulation.surroundings().least() {
            return None;
        }
        let near = extent(frame.elements(), |pair| frame.gap()[pair] < AMPLE * approach)?;
        let part = Part::around(frame.elements(), &near, [MARGIN; 2])?;
        let window = Self { part, simulation: OnceLock::new() };
        window.simulation(simulation)?;
        Some(window)
    }

    /// The problem in the window, and all else as in a simulation.
    pub fn simulation(&self, simulation: &Simulation) -> Option<Arc<Simulation>> {
        if let Some(within) = self.simulation.get() {
            return Some(Arc::clone(within));
        }
        let made = self.make(simulation)?;
        Some(Arc::clone(self.simulation.get_or_init(|| made)))
    }

    fn make(&self, simulation: &Simulation) -> Option<Arc<Simulation>> {
        let gap = simulation.problem.frame.gap();
        let beside = (0..gap.len()).filter(|&pair| self.part.place(pair).is_none());
        let beyond = simulation.surroundings().least();
        let within = simulation.on(simulation.problem.frame.within(&self.part)?)?;
        let beside = beside.map(|pair| gap[pair]).fold(beyond, f64::min);
        Some(Arc::new(Simulation { beside, ..within }))
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

    fn cut(&self, field: &[f64]) -> Vec<f64> {
        if field.is_empty() { vec![] } else { self.part.cut(field) }
    }

    /// A surface of the window in the frame, unworn beside it.
    pub fn put_surface(&self, surface: &Surface) -> Surface {
        surface.map(Grid::of_pairs(self.part.frame()), |field| self.part.put(field))
    }

    /// What lies in the window of a surface of the frame.
    pub fn cut_surface(&self, surface: &Surface) -> Surface {
        surface.map(Grid::of_pairs(self.part.size()), |field| self.part.cut(field))
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
            surfaces: state.surfaces.each_ref().map(|one| self.put_surface(one)),
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
                surfaces: state.surfaces.each_ref().map(|one| self.cut_surface(one)),
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
        let rubbing = problem.rubbing(0.0, SLIP, motion.slides([0.0; 2]));
        problem.wear(std::iter::once(rubbing), [true; 2], |_, _| [0.0; 2])
    };
    stay && plain && !problem.goes_by_temperature() && open().depth(0) == 0.0
}

#[cfg(test)]
mod tests {
    use super::Window;
    use crate::body::profile::{Flat, Sphere};
    use crate::body::{Body, Material};
    use crate::frame::Part;
    use crate::motion::{Control, Sliding, Stepping};
    use crate::simulation::evolution::{Evolution, Increment};
    use crate::simulation::{Effort, Simulation};
    use crate::wear::Archard;

    /// What a history says it knows of displacements and gaps, in the frame and in windows of two sizes, is so.
    #[test]
    fn what_is_known_stays_true() {
        let steel = Material::new(210e9, 0.3).unwrap();
        let ball = Body::new("ball", Sphere::new(50e-3).unwrap()).material(steel);
        let ball = ball.wear(Archard::new(1.33e-13).unwrap());
        let control = Control::Load(10.2);
        let sliding = Sliding::new().over(1.0, control, Stepping::Implicit(1.0)).unwrap();
        let simulation = Simulation::builder([ball, Body::new("flat", Flat)], sliding)
            .frame([2.4e-3, 2.0e-3], [96, 80])
            .build()
            .unwrap();
        let problem = &simulation.problem;
        let mut history = Evolution::new(problem);
        let press = Increment { advance: 0.0, progress: 0.0, control };
        history.press(&simulation, press, &mut Effort::default()).unwrap();
        let narrow = Window::around(&simulation, history.state.approach).unwrap();
        let wide = Window::around(&simulation, 2.5 * history.state.approach).unwrap();
        assert!(wide.part.holds(&narrow.part.extent()) && !narrow.part.holds(&wide.part.extent()));
        let expected = history.state.gap_of(problem).into_owned();
        let is_true = |history: &Evolution, simulation: &Simulation, what: &str| {
            let problem = &simulation.problem;
            let mut displacement = vec![0.0; problem.frame.len()];
            problem.compliance.apply_normal(&history.state.pressure, &mut displacement);
            let known =
                |pair: usize| history.known.is_none_or(|part: Part| part.place(pair).is_some());
            let mut count = 0;
            for pair in (0..displacement.len()).filter(|&pair| known(pair)) {
                let off = (history.displacement[pair] - displacement[pair]).abs();
                assert!(off < 1e-12, "{what}, {pair}: {off:e}");
                count += 1;
            }
            assert!(count > 0, "{what}");
            let gap = history.state.gap_of(problem).into_owned();
            for (pair, gap) in gap.iter().enumerate() {
                let undeformed = problem.frame.gap()[pair] - history.state.approach;
                let off = (gap - undeformed - displacement[pair]).abs();
                assert!(off < 1e-12, "gap, {what}, {pair}: {off:e}");
            }
        };
        is_true(&history, &simulation, "frame");
        let completed = {
            let mut whole = history.clone();
            whole.complete(problem, &mut Effort::default());
            whole
        };
        for (name, history) in [("solved", &history), ("completed", &completed)] {
            let first = narrow.cut_history(history);
            is_true(&first, &narrow.simulation(&simulation).unwrap(), name);
            let back = narrow.put_history(&first, &problem.frame);
            is_true(&back, &simulation, name);
            let second = wide.cut_history(&back);
            is_true(&second, &wide.simulation(&simulation).unwrap(), name);
            let shown = wide.put_state(&second.state, &problem.frame);
            for (one, other) in shown.gap_of(problem).iter().zip(&expected) {
                assert!((one - other).abs() < 1e-12, "{name}: {one:e} {other:e}");
            }
        }
    }
}
