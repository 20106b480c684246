//! What lies beyond the frame, and may touch.
//!
//! The frame is a part of an endless grid. Pressures open the gaps beyond it, so that only places touch there whose gap is less
//! than the approach: their gaps are known from the profiles, and what the pressures open them by at least from the
//! compliance. Where that does not keep them open, or the contact comes to the rim of the frame, the frame has to grow.

use std::ops::Range;

use rayon::prelude::*;

use super::Simulation;
use crate::body::Body;
use crate::frame::extent;
use crate::problem::{ContactProblem, ContactState};
use crate::solve::Cells;

/// Places along an axis on which shapes given by formulas are looked at far from the frame, relative to its size.
const ACROSS: [f64; 5] = [-0.5, -0.25, 0.0, 0.25, 0.5];

/// Cells along an axis by which the pressures are summed: the last ones tell displacements beyond the frame to their digits.
const CELLS: [usize; 4] = [1, 4, 16, 64];

/// Open elements around the contact: its edge is told by two of them.
const OPEN: isize = 2;

/// How many elements more a frame needs at the lower and the upper side along x, and along y.
pub(super) type More = [[usize; 2]; 2];

/// The places beyond a frame: as far as it is wide on each side, and farther away where readings are.
#[derive(Debug)]
pub(super) struct Surroundings {
    /// Along which axes the frame can grow: where the surfaces do not change, a long contact is cut off as the frame says.
    grows: [bool; 2],
    /// How deep (m) the profiles lie below their planes where they touch first.
    touch: f64,
    /// Elements in which readings lie far from the frame, counted from its first one.
    far: Vec<[isize; 2]>,
    /// The least gap (m) beyond.
    least: f64,
}

impl Surroundings {
    /// Those of a problem. There are none beyond frames that are not uniform, or that end or repeat themselves with the
    /// surfaces.
    pub fn of(problem: &ContactProblem) -> Self {
        let frame = &problem.frame;
        let least = f64::INFINITY;
        let none = Self { grows: [false; 2], touch: 0.0, far: vec![], least };
        if !frame.is_uniform() || frame.measure().closed {
            return none;
        }
        let grows = [0, 1].map(|axis| !(problem.is_even(axis) || frame.is_line() && axis == 1));
        let touch = frame.touch(problem.bodies.each_ref().map(|body| &*body.profile));
        let one = Self { grows, touch, ..none };
        let is_near =
            |place: &[isize; 2]| (0..2).all(|axis| one.near(problem, axis).contains(&place[axis]));
        let far = readings(problem, grows).filter(|place| !is_near(place)).collect();
        let one = Self { far, ..one };
        let gaps = one.places(problem).map(|place| one.gap(problem, place));
        let least = gaps.filter(|gap| gap.is_finite()).reduce(|| least, f64::min);
        Self { least, ..one }
    }

    /// Whether a frame can grow.
    pub fn grow(&self) -> bool {
        self.grows.contains(&true)
    }

    /// Elements along an axis, those of the frame among them, that are looked at.
    fn near(&self, problem: &ContactProblem, axis: usize) -> Range<isize> {
        let count = problem.frame.elements()[axis] as isize;
        let more = if self.grows[axis] { count } else { 0 };
        -more..count + more
    }

    /// The elements beyond the frame that are looked at.
    fn places(&self, problem: &ContactProblem) -> impl ParallelIterator<Item = [isize; 2]> {
        let elements = problem.frame.elements().map(|count| count as isize);
        let [columns, rows] = [0, 1].map(|axis| self.near(problem, axis));
        let inside =
            move |place: &[isize; 2]| (0..2).all(|axis| (0..elements[axis]).contains(&place[axis]));
        let near =
            rows.into_par_iter().flat_map_iter(move |y| columns.clone().map(move |x| [x, y]));
        near.filter(move |place| !inside(place)).chain(self.far.par_iter().copied())
    }

    /// The gap (m) of the undeformed bodies at an element, as the frame counts it.
    fn gap(&self, problem: &ContactProblem, place: [isize; 2]) -> f64 {
        let (corner, spacing) = (problem.frame.rectangle().corner(), problem.frame.spacing());
        let [x, y] = [0, 1].map(|axis| corner[axis] + (place[axis] as f64 + 0.5) * spacing[axis]);
        problem.bodies.iter().map(|body| body.profile.recess(x, y)).sum::<f64>() - self.touch
    }

    /// How much more a frame needs that holds a contact; `None` where it holds what touches, and open elements around it.
    pub fn missed(&self, problem: &ContactProblem, state: &ContactState) -> Option<More> {
        let elements = problem.frame.elements();
        let [columns, rows] = extent(elements, |pair| state.pressure[pair] > 0.0)?;
        let pressed = Reach {
            low: [columns.start, rows.start].map(|first| first as isize),
            high: [columns.end, rows.end].map(|end| end as isize),
        };
        let reach = if state.approach > self.least {
            let cells = Cells::of(elements, &state.pressure, &CELLS);
            let worn = Worn::of(problem, state);
            let touches = |place: &[isize; 2]| {
                let gap = self.gap(problem, *place);
                let apart = gap + worn.beyond(*place) - state.approach;
                gap.is_finite() && !cells.leave_open(apart, &*problem.compliance, *place)
            };
            let places = self.places(problem).filter(touches).map(Reach::of);
            places.reduce(|| pressed, Reach::and)
        } else {
            pressed
        };
        let more = [0, 1].map(|axis| {
            let (low, high) = (reach.low[axis] - OPEN, reach.high[axis] + OPEN);
            let sides = [(-low).max(0), (high - elements[axis] as isize).max(0)];
            if self.grows[axis] { sides.map(|side| side as usize) } else { [0; 2] }
        });
        (more != [[0; 2]; 2]).then_some(more)
    }

    /// As much more as a frame is wide, shared by both its sides: where all of it touches.
    pub fn twice(&self, problem: &ContactProblem) -> Option<More> {
        let more = |axis: usize| {
            if self.grows[axis] { [problem.frame.elements()[axis].div_ceil(2); 2] } else { [0; 2] }
        };
        self.grow().then(|| [more(0), more(1)])
    }
}

/// Elements from the first to the last along x and y, the last ones left out.
#[derive(Debug, Clone, Copy)]
struct Reach {
    low: [isize; 2],
    high: [isize; 2],
}

impl Reach {
    fn of(place: [isize; 2]) -> Self {
        Self { low: place, high: place.map(|one| one + 1) }
    }

    fn and(self, other: Self) -> Self {
        Self {
            low: [0, 1].map(|axis| self.low[axis].min(other.low[axis])),
            high: [0, 1].map(|axis| self.high[axis].max(other.high[axis])),
        }
    }
}

/// The elements in which readings of measured surfaces lie, counted from the first one of the frame. Shapes given by formulas
/// are looked at in a few places beside them.
fn readings(problem: &ContactProblem, grows: [bool; 2]) -> impl Iterator<Item = [isize; 2]> {
    let frame = &problem.frame;
    let (rectangle, spacing) = (frame.rectangle(), frame.spacing());
    let bodies: [&Body; 2] = problem.bodies.each_ref();
    let [x, y] = [0, 1].map(|axis| {
        let places = bodies.map(|body| body.profile.places()[axis]).concat();
        let measured = !places.is_empty() && grows[axis];
        let across = ACROSS.map(|at| rectangle.centre[axis] + at * rectangle.size[axis]);
        let places = if measured { places } else { across.to_vec() };
        let element =
            |place: &f64| ((place - rectangle.corner()[axis]) / spacing[axis]).floor() as isize;
        (measured, places.iter().map(element).collect::<Vec<_>>())
    });
    let (any, x, y) = (x.0 || y.0, x.1, y.1);
    let all = y.into_iter().flat_map(move |y| {
        let row: Vec<_> = x.iter().map(|&x| [x, y]).collect();
        row
    });
    all.filter(move |_| any)
}

/// Depths worn off beyond the frame: along lines of surfaces that pass.
struct Worn<'a> {
    elements: [usize; 2],
    /// The axis along which a body passes, and its depths (m), one value a pair.
    lines: Vec<(usize, &'a [f64])>,
}

impl<'a> Worn<'a> {
    fn of(problem: &ContactProblem, state: &'a ContactState) -> Self {
        let passing = problem.motion.passing();
        let of_body = |body: usize| {
            let passing = passing.filter(|passing| passing.bodies[body])?;
            Some((passing.direction.axis, &state.worn[body][..]))
        };
        let lines = (0..2).filter_map(of_body).collect();
        Self { elements: problem.frame.elements(), lines }
    }

    /// The depth (m) worn off both bodies at an element, counted from the first one of the frame.
    fn beyond(&self, place: [isize; 2]) -> f64 {
        let [nx, ny] = self.elements;
        let of_line = |&(axis, worn): &(usize, &[f64])| {
            let across = usize::try_from(place[1 - axis]).ok()?;
            let [x, y] = if axis == 0 { [nx / 2, across] } else { [across, ny / 2] };
            (x < nx && y < ny).then(|| worn[x + nx * y])
        };
        self.lines.iter().filter_map(of_line).sum()
    }
}

impl Simulation {
    /// What lies beyond its frame.
    pub(super) fn surroundings(&self) -> &Surroundings {
        self.surroundings.get_or_init(|| Surroundings::of(&self.problem))
    }
}
