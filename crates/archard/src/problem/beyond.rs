//! Where surfaces that were measured overlap beyond the frame.

use std::f64::consts::PI;

use super::{ContactProblem, ContactState};
use crate::body::{Body, contact_modulus};
use crate::frame::Rectangle;

/// Places along an axis on which shapes given by formulas are looked at, beside the middle of the frame and relative to
/// its size.
const ACROSS: [f64; 5] = [-0.5, -0.25, 0.0, 0.25, 0.5];

/// The measured places of two surfaces outside a frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Beyond {
    /// What the frame covers.
    frame: Rectangle,
    /// Gap (m) of the undeformed bodies, as the frame counts it, and where (m), the smallest gaps first.
    places: Vec<(f64, [f64; 2])>,
}

/// Bodies that overlap at a place outside the frame: they would touch there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Overlap {
    /// How deep (m).
    pub depth: f64,
    /// Where along x and y (m).
    pub place: [f64; 2],
}

impl Beyond {
    /// Those of a problem; what is known is that of an earlier state, maybe in another frame.
    pub fn of(problem: &ContactProblem, known: Option<Self>) -> Self {
        let frame = problem.frame.rectangle();
        let same = known.filter(|known| known.frame == frame);
        same.unwrap_or_else(|| Self { frame, places: Self::places(problem) })
    }

    /// None where formulas give both shapes, the surfaces end with the frame, or a body swings.
    fn places(problem: &ContactProblem) -> Vec<(f64, [f64; 2])> {
        let frame = &problem.frame;
        let fixed = problem.motion.swing().is_none();
        if !(frame.is_uniform() && fixed) || frame.measure().closed || frame.is_empty() {
            return vec![];
        }
        let rectangle = frame.rectangle();
        let profiles = problem.bodies.each_ref().map(|body| &*body.profile);
        let axes = [0, 1].map(|axis| {
            let mut places = profiles.map(|profile| profile.places()[axis]).concat();
            if frame.is_line() && axis == 1 {
                places = vec![rectangle.centre[1]];
            }
            (!places.is_empty(), places)
        });
        if axes.iter().all(|(measured, _)| !measured) {
            return vec![];
        }
        let [x, y] = [0, 1].map(|axis| match &axes[axis] {
            (true, places) => places.clone(),
            _ => ACROSS.map(|at| rectangle.centre[axis] + at * rectangle.size[axis]).to_vec(),
        });
        let recess =
            |[x, y]: [f64; 2]| -> f64 { profiles.iter().map(|profile| profile.recess(x, y)).sum() };
        let touch = recess(frame.place(0)) - frame.gap()[0];
        let all = y.iter().flat_map(|&y| x.iter().map(move |&x| [x, y]));
        let outside = all.filter(|&place| !rectangle.holds(place));
        let mut places: Vec<_> = outside.map(|place| (recess(place) - touch, place)).collect();
        places.retain(|(gap, _)| gap.is_finite());
        places.sort_by(|one, other| one.0.total_cmp(&other.0));
        places
    }

    /// The deepest overlap in a state.
    ///
    /// From the edge of the frame on, where it is known, the displacement falls as that of the load on a half-space at one
    /// place, or on one line.
    pub fn overlap(&self, problem: &ContactProblem, state: &ContactState) -> Option<Overlap> {
        let close = self.places.partition_point(|(gap, _)| *gap < state.approach);
        if close == 0 || state.load <= 0.0 {
            return None;
        }
        let frame = &problem.frame;
        let rectangle = frame.rectangle();
        let modulus = contact_modulus(problem.bodies.each_ref().map(Body::uppermost));
        let normal = state.gap_of(problem);
        let (elements, spacing) = (frame.elements(), frame.spacing());
        let nearest = |place: [f64; 2]| {
            let index = [0, 1].map(|axis| {
                let along = (place[axis] - rectangle.corner()[axis]) / spacing[axis];
                along.clamp(0.0, elements[axis] as f64 - 1.0) as usize
            });
            index[0] + elements[0] * index[1]
        };
        let total: f64 = state.pressure.iter().sum();
        let centre = [0, 1].map(|axis| {
            let moment =
                |(pair, pressure): (usize, &f64)| pressure * frame.place(pair)[axis] / total;
            state.pressure.iter().enumerate().map(moment).sum::<f64>()
        });
        let distance = |place: [f64; 2]| match frame.is_line() {
            true => (place[0] - centre[0]).abs(),
            false => (place[0] - centre[0]).hypot(place[1] - centre[1]),
        };
        let falls = |near: f64, far: f64| match frame.is_line() {
            true => 2.0 * state.load / rectangle.size[1] / (PI * modulus) * (far / near).ln(),
            false => state.load / (PI * modulus) * (1.0 / near - 1.0 / far),
        };
        let depth = |&(gap, place): &(f64, [f64; 2])| {
            let edge = nearest(place);
            let worn = state.worn[0][edge] + state.worn[1][edge];
            let displacement = normal[edge] + state.approach - frame.gap()[edge] - worn;
            let [near, far] = [distance(frame.place(edge)), distance(place)];
            let left = displacement - falls(near, far.max(near));
            Overlap { depth: state.approach - gap - left, place }
        };
        let overlaps = self.places[..close].iter().map(depth).filter(|overlap| overlap.depth > 0.0);
        overlaps.max_by(|one, other| one.depth.total_cmp(&other.depth))
    }
}
