//! The placement of the later map by least squares in which what changed hardly counts.
//!
//! Gauss and Newton's steps with the weights of Student's t of four degrees of freedom (K. L. Lange and others, *J. Amer. Statist. Assoc.* 84 (1989)
//! 881). The first fit leaves out what lies beyond four standard deviations, while these fall by half a step at most: places far
//! from the right one are smoothed over (A. Blake and A. Zisserman, *Visual Reconstruction*, MIT 1987).

use super::placement::{FORM, LEVEL, PARAMETERS, Placement};
use super::sample::Spline;
use super::solve::{inverse, times};
use crate::outliers::{BY_MEDIAN, median};

/// Degrees of freedom: those that Lange and others give for data with outliers.
const FREEDOM: f64 = 4.0;
/// Standard deviations beyond which points do not count in the first fit. A thousandth of normal ones lies within the tails.
const CUT: f64 = 4.0;
/// Least share of points that the first fit starts from: fewer are no surface.
const LEAST: f64 = 0.02;
/// Steps of the first fit, at most, and of those after it, which start near the end.
const STEPS: [usize; 2] = [40, 4];
/// A change of the shift by that share of a pixel does not count.
const STILL: f64 = 1e-4;
/// A step moves corners by no more than so many pixels: slopes are known to about that.
const STRIDE: f64 = 1.5;

/// What a placement is fitted to.
pub(super) struct Points<'a> {
    pub(super) before: &'a Spline,
    /// Places (m) and heights (m) of the later map.
    pub(super) after: Vec<([f64; 2], f64)>,
    /// The length (m) that turn and tilts are multiplied by.
    pub(super) reach: f64,
    /// The size of a pixel (m).
    pub(super) pixel: f64,
    /// Which numbers are sought.
    pub(super) sought: Sought,
    /// What heights are not known better than (m).
    pub(super) floor: f64,
}

/// Which numbers of a placement are sought besides its plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Sought {
    pub(super) place: bool,
    pub(super) form: bool,
}

impl Sought {
    /// Whether a number is sought.
    pub(super) fn has(self, number: usize) -> bool {
        (self.place || number >= LEVEL) && (self.form || number < FORM)
    }

    /// How many are.
    pub(super) fn count(self) -> f64 {
        (0..PARAMETERS).filter(|&number| self.has(number)).count() as f64
    }
}

/// A placement and the scatter (m) of differences about it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Fitted {
    pub(super) placement: Placement,
    pub(super) scatter: f64,
}

/// The weight of a difference: one of the mean normal one.
pub(super) fn weight(difference: f64, scatter: f64) -> f64 {
    (FREEDOM + 1.0) / (FREEDOM + (difference / scatter).powi(2))
}

impl Points<'_> {
    /// Differences at all points in common and how they fall with the numbers of a placement.
    pub(super) fn changes(&self, placement: &Placement) -> Vec<(f64, [f64; PARAMETERS])> {
        let change = |own: &([f64; 2], f64)| placement.change(self.before, *own, self.reach);
        self.after.iter().filter_map(change).collect()
    }

    /// The placement nearest to one whose differences scatter so (m), from afar or from nearby. `None` of too few points.
    pub(super) fn fitted(&self, start: Fitted, first: bool) -> Option<Fitted> {
        let Fitted { mut placement, mut scatter } = start;
        let mut left = STEPS[usize::from(!first)];
        loop {
            let changes = self.changes(&placement);
            let sizes = |most: f64| changes.iter().filter(|one| one.0.abs() < most).count();
            let least = (LEAST * changes.len() as f64).max(4.0 * self.sought.count());
            if (changes.len() as f64) < least {
                return None;
            }
            while first && (sizes(CUT * scatter) as f64) < least {
                scatter *= 2.0;
            }
            let most = if first { CUT * scatter } else { f64::INFINITY };
            let kept = || changes.iter().filter(|one| one.0.abs() < most);
            let middle = median(&mut kept().map(|one| one.0).collect::<Vec<f64>>())?;
            let spread =
                median(&mut kept().map(|one| (one.0 - middle).abs()).collect::<Vec<f64>>())?;
            let slowest = if first { 0.5 * scatter } else { 0.0 };
            let next = (BY_MEDIAN * spread).max(self.floor).max(slowest);
            let settled = next > 0.9 * scatter;
            scatter = next;
            let mut matrix = [[0.0; PARAMETERS]; PARAMETERS];
            let mut sums = [0.0; PARAMETERS];
            for (difference, falls) in kept() {
                let weight = weight(*difference, scatter);
                let own: [f64; PARAMETERS] =
                    std::array::from_fn(|one| if self.sought.has(one) { falls[one] } else { 0.0 });
                for (row, (sum, one)) in matrix.iter_mut().zip(sums.iter_mut().zip(&own)) {
                    *sum += weight * one * difference;
                    row.iter_mut().zip(&own).for_each(|(all, other)| *all += weight * one * other);
                }
            }
            let mut step = times(&inverse(&matrix), &sums);
            let most = STRIDE * self.pixel;
            step[..LEVEL].iter_mut().for_each(|one| *one = one.clamp(-most, most));
            let moved = step[..LEVEL].iter().any(|one| one.abs() > STILL * self.pixel);
            let lifted = step[LEVEL..].iter().any(|one| one.abs() > 1e-3 * scatter);
            placement = placement.changed(step, self.reach);
            left -= 1;
            if left == 0 || (settled && !(moved || lifted)) {
                return Some(Fitted { placement, scatter });
            }
        }
    }
}
