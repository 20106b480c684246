//! What lies beyond the frame, and may touch.
//!
//! The frame is a part of an endless grid. Pressures open the gaps beyond it, so that only places touch there whose gap is less
//! than the approach: their gaps are known from the profiles, and what the pressures open them by at least from the
//! compliance. Where that does not keep them open, or the contact comes to the rim of the frame, the frame has to grow.

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
    /// Gap (m) of the undeformed bodies, as the frame counts it, and the element, counted from the first one of the frame;
    /// the smallest gaps first.
    places: Vec<(f64, [isize; 2])>,
    /// Along which axes the frame can grow: where the surfaces do not change, a long contact is cut off as the frame says.
    grows: [bool; 2],
}

impl Surroundings {
    /// Those of a problem. There are none beyond frames that are not uniform, or that end or repeat themselves with the
    /// surfaces.
    pub fn of(problem: &ContactProblem) -> Self {
        let frame = &problem.frame;
        let line = frame.is_line();
        if !frame.is_uniform() || frame.measure().closed {
            return Self { places: vec![], grows: [false; 2] };
        }
        let grows = [0, 1].map(|axis| !(line && axis == 1) && !problem.is_even(axis));
        let profiles = problem.bodies.each_ref().map(|body| &*body.profile);
        let touch = frame.touch(profiles);
        let (elements, spacing) = (frame.elements().map(|n| n as isize), frame.spacing());
        let corner = frame.rectangle().corner();
        let near = |axis: usize| {
            let more = if grows[axis] { elements[axis] } else { 0 };
            -more..elements[axis] + more
        };
        let inside =
            |place: [isize; 2]| (0..2).all(|axis| (0..elements[axis]).contains(&place[axis]));
        let ring = near(1).flat_map(|y| near(0).map(move |x| [x, y]));
        let far = readings(problem, grows);
        let far = far.filter(|place| (0..2).any(|axis| !near(axis).contains(&place[axis])));
        let gap = |place: [isize; 2]| {
            let [x, y] =
                [0, 1].map(|axis| corner[axis] + (place[axis] as f64 + 0.5) * spacing[axis]);
            profiles.iter().map(|profile| profile.recess(x, y)).sum::<f64>() - touch
        };
        let beyond = ring.filter(|&place| !inside(place)).chain(far);
        let gaps = beyond.map(|place| (gap(place), place)).filter(|(gap, _)| gap.is_finite());
        let mut places: Vec<_> = gaps.collect();
        places.sort_by(|one, other| one.0.total_cmp(&other.0));
        Self { places, grows }
    }

    /// Whether a frame can grow.
    pub fn grow(&self) -> bool {
        self.grows.contains(&true)
    }

    /// How much more a frame needs that holds a contact; `None` where it holds what touches, and open elements around it.
    pub fn missed(&self, problem: &ContactProblem, state: &ContactState) -> Option<More> {
        let elements = problem.frame.elements();
        let [columns, rows] = extent(elements, |pair| state.pressure[pair] > 0.0)?;
        let mut low = [columns.start, rows.start].map(|first| first as isize - OPEN);
        let mut high = [columns.end, rows.end].map(|end| end as isize + OPEN);
        let close = self.places.partition_point(|(gap, _)| *gap < state.approach);
        let numbers = if close > 0 { &CELLS[..] } else { &[] };
        let cells = Cells::of(elements, &state.pressure, numbers);
        for &(gap, place) in &self.places[..close] {
            if !cells.leave_open(gap - state.approach, &*problem.compliance, place) {
                for axis in 0..2 {
                    low[axis] = low[axis].min(place[axis] - OPEN);
                    high[axis] = high[axis].max(place[axis] + 1 + OPEN);
                }
            }
        }
        let more = [0, 1].map(|axis| {
            let sides = [(-low[axis]).max(0), (high[axis] - elements[axis] as isize).max(0)];
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

impl Simulation {
    /// What lies beyond its frame.
    pub(super) fn surroundings(&self) -> &Surroundings {
        self.surroundings.get_or_init(|| Surroundings::of(&self.problem))
    }
}
