//! Where a run works: in which frame, and in which window of it.
//!
//! The frame is a part of an endless grid. A step that ends with pairs at the rim under pressure, or with surfaces beyond that
//! may touch, did not see all of the contact: it is taken again in a frame with more elements of the same size, or in one of
//! [elements twice as large](super::wider), from where it began. So the run is the one that the larger frame would have given
//! from the beginning.
//!
//! Where surfaces stay opposite each other, what is far from the contact neither touches nor wears. The histories of a run live
//! in a window then: the same problem on a part of the frame, with the same elements. Pressures only open the gaps next to it,
//! within the frame and beyond, so that no pair there touches while the approach stays below all of them. A solve that comes
//! closer fails as one that fills its frame does (`Simulation::beside`), and the step is taken again in a larger window. What is
//! shown lies in the frame.

use std::sync::{Arc, OnceLock};

use serde::{Deserialize, Serialize};

use super::error::Error;
use super::moving::Moving;
use super::setup::Simulation;
use super::surroundings::More;
use super::wider::Wider;
use crate::frame::{ContactFrame, Part, extent};
use crate::problem::{ContactProblem, UnwornRecess};

/// Gaps, over the approach, up to which pairs lie in a window.
const AMPLE: f64 = 2.0;
/// Approach, over the lowest gap next to a window, from which on a larger one is taken, or none where that gap is beyond the frame.
const NEAR: f64 = 0.8;
/// Elements on each side of those pairs.
const MARGIN: usize = 1;
/// A distance (m) to try on pairs that are open.
const SLIP: f64 = 1e-3;

/// A place for the histories of a run, told from the frame that its simulation begins with.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub(super) struct Placed {
    /// How often the elements became twice as large.
    doubled: usize,
    /// The frame of these elements as a part of the one that it grew to.
    grown: Option<Made>,
    /// The part of that in which the run works.
    window: Option<Made>,
}

/// A part that two frames share, and what goes on in the frame that it was made for.
#[derive(Debug, Clone, Serialize, Deserialize)]
struct Made {
    part: Part,
    /// Made where it is needed.
    #[serde(skip)]
    simulation: OnceLock<Arc<Simulation>>,
}

impl Made {
    fn by(part: Part) -> Self {
        Self { part, simulation: OnceLock::new() }
    }

    fn simulation(&self, make: impl Fn(&Part) -> Option<Simulation>) -> Option<&Simulation> {
        if self.simulation.get().is_none() {
            let made = Arc::new(make(&self.part)?);
            self.simulation.get_or_init(|| made);
        }
        self.simulation.get().map(|made| &**made)
    }
}

impl Placed {
    /// What goes on in the frame with these elements before it grew.
    fn first<'a>(&self, simulation: &'a Simulation) -> &'a Simulation {
        simulation.frames().nth(self.doubled).unwrap_or(simulation)
    }

    /// What goes on in the frame; `None` where a surface does not reach so far.
    pub fn in_frame<'a>(&'a self, simulation: &'a Simulation) -> Option<&'a Simulation> {
        let first = self.first(simulation);
        match &self.grown {
            Some(grown) => grown.simulation(|part| first.around(part)),
            None => Some(first),
        }
    }

    /// What goes on in the window, or in the frame where none exists; `None` where it cannot be made.
    pub fn simulation<'a>(&'a self, simulation: &'a Simulation) -> Option<&'a Simulation> {
        let frame = self.in_frame(simulation)?;
        match &self.window {
            Some(window) => window.simulation(|part| frame.within(part)),
            None => Some(frame),
        }
    }

    /// Whether it is a window.
    pub fn is_window(&self) -> bool {
        self.window.is_some()
    }

    /// The same frame without a window.
    pub fn whole(&self) -> Self {
        Self { window: None, ..self.clone() }
    }

    /// The same frame with a window that has room for an approach (m) to grow; without one where that would be nearly the
    /// whole frame, or what is next to it may count.
    pub fn windowed(&self, simulation: &Simulation, approach: f64) -> Self {
        let part = self.in_frame(simulation).and_then(|frame| window(frame, approach));
        let placed = Self { window: part.map(Made::by), ..self.clone() };
        if placed.simulation(simulation).is_some() { placed } else { self.whole() }
    }

    /// Whether the next step at an approach (m) had better be taken in a larger window.
    pub fn is_narrow(&self, simulation: &Simulation, approach: f64) -> bool {
        let near = |within: &Simulation| approach > NEAR * within.beside;
        self.is_window() && self.simulation(simulation).is_none_or(near)
    }

    /// The same frame with a larger window, for histories that come to an approach (m), or without one.
    pub fn roomier(&self, simulation: &Simulation, approach: f64) -> Self {
        let within = self.simulation(simulation);
        let reached = within.map_or(f64::INFINITY, |within| approach.max(within.beside));
        self.windowed(simulation, reached)
    }

    /// The frame with elements twice as large to go on in from some progress on, where there is one.
    pub fn doubled(&self, simulation: &Simulation, progress: f64) -> Option<Self> {
        let Wider { from, .. } = self.first(simulation).wider.as_deref()?;
        (progress >= *from).then(|| Self { doubled: self.doubled + 1, ..Self::default() })
    }

    /// A frame with so many elements more, or with those twice as large that were to come later; `None` where the surfaces end
    /// before. Histories that reached some progress (the motion's own unit) and approach (m) get a window in the frame that grew.
    ///
    /// # Errors
    /// If it had more than it may have.
    pub fn larger(
        &self,
        simulation: &Simulation,
        more: More,
        [progress, approach]: [f64; 2],
    ) -> Result<Option<Self>, Error> {
        if let Some(doubled) = self.doubled(simulation, f64::INFINITY) {
            return Ok(Some(doubled));
        }
        let first = self.first(simulation);
        let own = Part::inside(first.problem.frame.elements(), [[0; 2]; 2]);
        let grown = self.grown.as_ref().map_or(own, |grown| grown.part);
        let part = grown.lying_in(&Part::inside(grown.frame(), more));
        let [columns, rows] = part.frame();
        if columns.saturating_mul(rows) > first.most {
            let measure = first.problem.motion.progress;
            return Err(Error::Outgrown { measure, progress, elements: part.frame() });
        }
        let larger = Self { grown: Some(Made::by(part)), window: None, ..*self };
        let exists = larger.in_frame(simulation).is_some();
        Ok(exists.then(|| larger.windowed(simulation, approach)))
    }

    /// How to go to another place; `None` where that is the same.
    pub fn to<'a>(&self, other: &'a Self, simulation: &'a Simulation) -> Option<Moving<'a>> {
        let to = other.simulation(simulation)?;
        if self.doubled != other.doubled {
            return Some(Moving { shared: None, simulation: to });
        }
        let [own, there] = [self.corner(), other.corner()];
        let own_elements = self.simulation(simulation)?.problem.frame.elements();
        let elements = [own_elements, to.problem.frame.elements()];
        let first = [0, 1].map(|axis| own[axis] - there[axis]);
        let same = first == [0; 2] && elements[0] == elements[1];
        (!same).then(|| Moving { shared: Some(Part::shared(elements, first)), simulation: to })
    }

    /// Its first element, counted from that of the frame before it grew.
    fn corner(&self) -> [isize; 2] {
        let [window, grown] = [&self.window, &self.grown].map(|made| {
            let part = made.as_ref().map(|made| made.part.extent());
            part.map_or([0; 2], |extent| extent.map(|range| range.start as isize))
        });
        [0, 1].map(|axis| window[axis] - grown[axis])
    }
}

impl Simulation {
    /// The same in a window.
    fn within(&self, part: &Part) -> Option<Self> {
        let within = self.on(self.problem.frame.within(part)?)?;
        let gap = self.problem.frame.gap().iter().enumerate();
        let beside = gap.filter(|(pair, _)| part.place(*pair).is_none()).map(|(_, gap)| *gap);
        Some(Self { beside: beside.fold(self.surroundings().least(), f64::min), ..within })
    }

    /// The same in a larger frame that its own is a part of.
    fn around(&self, part: &Part) -> Option<Self> {
        let profiles = self.problem.bodies.each_ref().map(|body| &*body.profile);
        self.on(self.problem.frame.around(part, profiles)?)
    }

    /// The same on another part of its endless grid; `None` where there is no compliance.
    fn on(&self, frame: ContactFrame) -> Option<Self> {
        let Self { problem, solver, friction_solver, schedule, .. } = self;
        Some(Self {
            problem: ContactProblem {
                bodies: problem.bodies.clone(),
                compliance: problem.compliance.on(&frame)?,
                frame,
                friction: problem.friction.clone(),
                motion: problem.motion.clone(),
                unworn: UnwornRecess::default(),
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

/// The part of a frame around the contact that has room for an approach (m) to grow.
fn window(simulation: &Simulation, approach: f64) -> Option<Part> {
    let frame = &simulation.problem.frame;
    if !stays_apart(&simulation.problem) || approach > NEAR * simulation.surroundings().least() {
        return None;
    }
    let near = extent(frame.elements(), |pair| frame.gap()[pair] < AMPLE * approach)?;
    Part::around(frame.elements(), &near, [MARGIN; 2])
}

/// Whether nothing happens to pairs that are far from the contact: surfaces stay opposite each other, no heat flows along
/// them, they do not end or repeat themselves, and pairs that are open do not wear.
fn stays_apart(problem: &ContactProblem) -> bool {
    let frame = &problem.frame;
    let motion = &problem.motion;
    let stay = motion.lever_arm().is_some() && motion.stays();
    let plain = frame.is_uniform() && !frame.is_line() && !frame.measure().closed;
    let open = || {
        let rubbing = problem.rubbing(0.0, SLIP, motion.heading([0.0; 2]));
        problem.wear(std::iter::once(rubbing), [true; 2], |_, _| [0.0; 2])
    };
    stay && plain && !problem.goes_by_temperature() && open().depth(0) == 0.0
}

#[cfg(test)]
mod tests {
    use super::Placed;
    use crate::body::profile::{Flat, Sphere};
    use crate::body::{Body, Material};
    use crate::motion::{Control, Sliding, Stepping};
    use crate::simulation::memory::{History, Increment};
    use crate::simulation::moving::Move;
    use crate::simulation::{Effort, Simulation};
    use crate::wear::Archard;

    /// A worn ball on a flat, pressed together.
    fn pressed() -> (Simulation, History) {
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
        let mut history = History::new(problem);
        let worn = &mut history.state.surfaces[0].depth;
        let cap = problem.frame.gap().iter().map(|gap| (2e-7 - gap).max(0.0));
        worn.iter_mut().zip(cap).for_each(|(worn, cap)| *worn = cap);
        let press = Increment { advance: 0.0, progress: 0.0, control };
        history.press(&simulation, press, &mut Effort::default()).unwrap();
        (simulation, history)
    }

    /// Holds what a history says it knows of displacements and gaps against the sum over its pressures, and its load and worn
    /// volume against those of another.
    fn assert_true(history: &History, on: &Simulation, same: (&History, &Simulation)) {
        let problem = &on.problem;
        let mut displacement = vec![0.0; problem.frame.len()];
        problem.compliance.apply_normal(&history.state.pressure, &mut displacement);
        for (pair, expected) in displacement.iter().enumerate() {
            let known = history.known.is_none_or(|part| part.place(pair).is_some());
            assert!(!known || (history.displacement[pair] - expected).abs() < 1e-12);
        }
        let worn = history.state.total_worn();
        for (pair, gap) in history.state.gap_of(problem).iter().enumerate() {
            let apart = problem.frame.gap()[pair] + worn[pair] - history.state.approach;
            assert!((gap - apart - displacement[pair]).abs() < 1e-12, "{pair}");
        }
        let sums = |history: &History, on: &Simulation| {
            let frame = &on.problem.frame;
            [&history.state.pressure, &history.state.total_worn()].map(|one| frame.integrate(one))
        };
        let [found, expected] = [sums(history, on), sums(same.0, same.1)];
        for (found, expected) in found.iter().zip(expected) {
            assert!((found / expected - 1.0).abs() < 1e-12, "{found:e} {expected:e}");
        }
    }

    /// A history is the same contact wherever it is moved: in the frame, in windows of two sizes, in a larger frame and in a
    /// window of that.
    #[test]
    fn a_history_stays_true_wherever_it_is_moved() {
        let (simulation, history) = pressed();
        let approach = history.state.approach;
        let frame = Placed::default();
        let narrow = frame.windowed(&simulation, approach);
        let wide = narrow.windowed(&simulation, 2.5 * approach);
        let grown = frame
            .larger(&simulation, [[3, 10], [0, 7]], [0.0, f64::NEG_INFINITY])
            .unwrap()
            .unwrap();
        let within = grown.windowed(&simulation, approach);
        let places = [&frame, &narrow, &wide, &grown, &within];
        let windows = [false, true, true, false, true];
        assert_eq!(places.map(Placed::is_window), windows);
        let elements =
            |place: &Placed| place.simulation(&simulation).unwrap().problem.frame.elements();
        assert!((0..2).all(|axis| elements(&narrow)[axis] < elements(&wide)[axis]));
        assert_eq!(elements(&grown), [109, 87]);
        let mut completed = history.clone();
        completed.complete(&simulation.problem, &mut Effort::default());
        let moved = |history: &History, from: &Placed, to: &Placed| {
            from.to(to, &simulation).map_or_else(|| history.clone(), |to| history.moved(&to))
        };
        for history in [history, completed] {
            for first in places {
                let here = moved(&history, &frame, first);
                for second in places {
                    let there = moved(&here, first, second);
                    let on = second.simulation(&simulation).unwrap();
                    assert_true(&there, on, (&history, &simulation));
                    let back = moved(&there, second, &frame);
                    assert_eq!(back.state.pressure, history.state.pressure);
                    assert_eq!(back.state.surfaces, history.state.surfaces);
                }
            }
        }
    }

    /// On elements twice as large too; what pressures displace is known nowhere then.
    #[test]
    fn a_history_stays_true_on_larger_elements() {
        let (simulation, history) = pressed();
        let (wider, _) = pressed();
        let Simulation { problem, schedule, .. } = &wider;
        let sliding = (problem.motion.clone(), schedule.clone());
        let wider = Simulation::builder(problem.bodies.clone(), sliding)
            .frame([4.8e-3, 4.0e-3], [96, 80])
            .build()
            .unwrap();
        let simulation = simulation.widened(0.5, wider).unwrap();
        let frame = Placed::default();
        assert!(frame.doubled(&simulation, 0.4).is_none());
        let doubled = frame.doubled(&simulation, 0.5).unwrap();
        let there = history.moved(&frame.to(&doubled, &simulation).unwrap());
        let on = doubled.simulation(&simulation).unwrap();
        assert!(there.known.is_some());
        assert_true(&there, on, (&history, &simulation));
    }
}
