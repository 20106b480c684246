//! Where pairs that close within an increment begin to bear friction.
//!
//! A pair slides over the other surface before it touches, and no traction answers to that. While a gap closes by
//! some length the surfaces slide by another; near the edge of the contact both grow with the root of the distance
//! from it (K. L. Johnson, *Contact Mechanics*, sections 3.4 and 7.3), so that their ratio is even there. Open pairs
//! show the ratio, the pairs that have closed take it from the nearest, and what they slid until they touched
//! is the gap they had times the ratio. Under loads that rise together the ratio is constant, and pairs that
//! close stick from where they touch (R. D. Mindlin and H. Deresiewicz, *J. Appl. Mech.* 20 (1953) 327).

use serde::{Deserialize, Serialize};

use super::spread::spread;
use crate::frame::ContactFrame;
use crate::numerics::vector::map;
use crate::problem::ContactState;

/// Closing of an open pair, relative to the largest gap that has closed, below which its ratio gives nothing.
const CLOSES: f64 = 0.1;
/// The largest factor by which courses are taken to converge.
const FACTOR: f64 = 0.9;

/// Gaps and pressures before an increment.
#[derive(Debug, Clone)]
pub(super) struct Before {
    gap: Vec<f64>,
    open: Vec<bool>,
}

/// Distance slid (m) over gap closed (m), along t1 and t2, one value a pair.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct Course([Vec<f64>; 2]);

impl Before {
    pub fn of(state: &ContactState) -> Self {
        let open = state.pressure.iter().map(|&pressure| pressure <= 0.0).collect();
        Self { gap: state.gap.values.clone(), open }
    }

    /// Pairs that have closed since, over some gap.
    fn closed<'a>(&'a self, state: &'a ContactState) -> impl Iterator<Item = usize> + 'a {
        let has_closed =
            |&pair: &usize| self.open[pair] && self.gap[pair] > 0.0 && state.pressure[pair] > 0.0;
        (0..self.gap.len()).filter(has_closed)
    }

    /// The ratios of an increment; `None` where no pair has closed, or none that is open shows it.
    pub fn course(&self, state: &ContactState, frame: &ContactFrame) -> Option<Course> {
        let slip = &state.tangential.as_ref()?.slip;
        let widest = self.closed(state).map(|pair| self.gap[pair]).fold(0.0, f64::max);
        if widest == 0.0 {
            return None;
        }
        let closing = |pair: usize| self.gap[pair] - state.gap.values[pair];
        let tells = |pair: usize| {
            self.open[pair] && state.pressure[pair] <= 0.0 && closing(pair) > CLOSES * widest
        };
        let known: Vec<bool> = (0..self.gap.len()).map(tells).collect();
        if !known.contains(&true) {
            return None;
        }
        let ratio = |axis: usize| {
            let at = |pair: usize| if known[pair] { slip[axis][pair] / closing(pair) } else { 0.0 };
            spread((0..known.len()).map(at).collect(), &known, frame)
        };
        Some(Course([0, 1].map(ratio)))
    }

    /// What open pairs slide until they touch (m).
    pub fn until_touch(&self, course: Option<&Course>) -> Option<[Vec<f64>; 2]> {
        let Course(ratio) = course?;
        let slid = |ratio: &Vec<f64>| -> Vec<f64> {
            let at = |pair: usize| {
                if self.open[pair] { ratio[pair] * self.gap[pair].max(0.0) } else { 0.0 }
            };
            (0..ratio.len()).map(at).collect()
        };
        Some(ratio.each_ref().map(slid))
    }

    /// How far two such are apart where pairs have closed, relative to the largest of the second.
    pub fn apart(&self, state: &ContactState, courses: [Option<&Course>; 2]) -> f64 {
        let at = |course: Option<&Course>, (axis, pair): (usize, usize)| {
            course.map_or(0.0, |Course(ratio)| ratio[axis][pair] * self.gap[pair])
        };
        let (mut off, mut most) = (0.0_f64, 0.0_f64);
        for place in self.closed_axes(state) {
            let [one, other] = courses.map(|course| at(course, place));
            (off, most) = (off.max((one - other).abs()), most.max(other.abs()));
        }
        if off == 0.0 { 0.0 } else { off / most }
    }

    /// The course that a series of them goes to: with `from`, an increment shows `to[0]`, and with that `to[1]`.
    ///
    /// The tractions of an increment answer to any course, and only what they leave at the edge of the contact gives
    /// it from the right one: the series converges slowly, by nearly the same factor each time, and is extrapolated
    /// (A. C. Aitken, *Proc. R. Soc. Edinburgh* 46 (1926) 289).
    pub fn limit(&self, state: &ContactState, from: Option<&Course>, to: [&Course; 2]) -> Course {
        let [one, two] = to;
        let start = |axis: usize, pair: usize| from.map_or(0.0, |course| course.0[axis][pair]);
        let (mut product, mut square) = (0.0, 0.0);
        for (axis, pair) in self.closed_axes(state) {
            let weight = self.gap[pair] * self.gap[pair];
            let first = one.0[axis][pair] - start(axis, pair);
            let second = two.0[axis][pair] - one.0[axis][pair];
            (product, square) =
                (product + weight * first * second, square + weight * first * first);
        }
        let factor = if square > 0.0 { (product / square).clamp(0.0, FACTOR) } else { 0.0 };
        let further = factor / (1.0 - factor);
        Course([0, 1].map(|axis| {
            map([&one.0[axis], &two.0[axis]], |[one, two]| two + further * (two - one))
        }))
    }

    fn closed_axes<'a>(
        &'a self,
        state: &'a ContactState,
    ) -> impl Iterator<Item = (usize, usize)> + 'a {
        self.closed(state).flat_map(|pair| [(0, pair), (1, pair)])
    }
}
