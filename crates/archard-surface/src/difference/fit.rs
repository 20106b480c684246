//! The placement of the later map by least squares in which what changed does not count.
//!
//! Gauss and Newton's steps with the weights of Tukey's biweight, which are zero from 4.685 standard deviations on: of normal
//! differences it keeps 95 % of the information (P. J. Huber and E. M. Ronchetti, *Robust Statistics*, Wiley 2009). The
//! standard deviation is that of the median of sizes.

use super::placement::{LEVEL, PARAMETERS, Placement};
use super::solve::{inverse, times};
use crate::map::HeightMap;
use crate::outliers::median;

const BIWEIGHT: f64 = 4.685;
/// The median size of normal differences is 0.6745 standard deviations.
const MEDIAN: f64 = 0.674_489_750_196_081_7;
/// Steps, at most; each divides what is left by three at least where the start is within reach.
const STEPS: usize = 30;
/// A change of the shift by that share of a pixel is none.
const STILL: f64 = 1e-4;

/// What a placement is fitted to.
pub(super) struct Points<'a> {
    pub(super) before: &'a HeightMap,
    /// Places (m) and heights (m) of the later map.
    pub(super) after: Vec<([f64; 2], f64)>,
    /// The length (m) that turn and tilts are multiplied by.
    pub(super) reach: f64,
}

/// A placement and the scatter (m) of differences about it.
pub(super) struct Fitted {
    pub(super) placement: Placement,
    pub(super) scatter: f64,
}

/// The weight of a difference.
pub(super) fn weight(difference: f64, scatter: f64) -> f64 {
    let share = difference / (BIWEIGHT * scatter);
    if share.abs() < 1.0 { (1.0 - share * share).powi(2) } else { 0.0 }
}

impl Points<'_> {
    /// Differences at all points in common and how they fall with the numbers of a placement.
    pub(super) fn changes(&self, placement: &Placement) -> Vec<(f64, [f64; PARAMETERS])> {
        let change = |own: &([f64; 2], f64)| placement.change(self.before, *own, self.reach);
        self.after.iter().filter_map(change).collect()
    }

    /// The placement nearest to one; its shift and turn stay unless they are sought. `None` of too few points.
    pub(super) fn fitted(&self, start: Placement, sought: bool) -> Option<Fitted> {
        let pixel = self.before.pixel()[0].min(self.before.pixel()[1]);
        let mut placement = start;
        let mut left = STEPS;
        loop {
            let changes = self.changes(&placement);
            if changes.len() <= PARAMETERS {
                return None;
            }
            let mut sizes: Vec<f64> = changes.iter().map(|one| one.0.abs()).collect();
            let scatter = (median(&mut sizes)? / MEDIAN).max(f64::MIN_POSITIVE);
            let mut matrix = [[0.0; PARAMETERS]; PARAMETERS];
            let mut sums = [0.0; PARAMETERS];
            for (difference, falls) in &changes {
                let weight = weight(*difference, scatter);
                let first = if sought { 0 } else { LEVEL };
                for i in first..PARAMETERS {
                    sums[i] += weight * falls[i] * difference;
                    for j in first..PARAMETERS {
                        matrix[i][j] += weight * falls[i] * falls[j];
                    }
                }
            }
            let step = times(&inverse(&matrix), &sums);
            let moved = step[..LEVEL].iter().any(|one| one.abs() > STILL * pixel);
            let lifted = step[LEVEL..].iter().any(|one| one.abs() > STILL * scatter);
            if left == 0 || !(moved || lifted) {
                return Some(Fitted { placement, scatter });
            }
            placement = placement.changed(step, self.reach);
            left -= 1;
        }
    }
}
