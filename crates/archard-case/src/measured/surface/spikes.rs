//! Readings that failed: dropouts, zeros in the place of lost readings, specks.

use rayon::prelude::*;

use super::Surface;
use crate::measured::plane::ROUNDS;

/// Cells on either side that a reading is held against, along a profile and along each axis of a map.
const REACH: [usize; 2] = [4, 2];
/// One in so many of them may be off by itself, at the upper end of their heights and at the lower one.
const OFF: usize = 8;
/// Scatter about the others beyond which a reading is off, and how scatter is told: by the deviation that so many readings
/// keep within, over the standard deviation of normal ones, their quantile of 0.95.
const FAR: f64 = 5.0;
const MOST: f64 = 0.9;
const WITHIN: f64 = 1.645;
/// A height that is there so many times may stand for lost readings.
const SEVERAL: usize = 3;
/// Readings of a profile beyond the middle of all by so many times its range are no heights, unless half of those around
/// them are there too; the share of readings beside that middle, either way.
const ABSURD: f64 = 20.0;
const BESIDE: f64 = 0.1;

/// A reading against those around it.
pub(super) struct Among {
    /// By how much it lies off their median (m).
    off: f64,
    /// By how much it lies beyond them (m), and over what range they lie themselves (m).
    beyond: f64,
    range: f64,
}

impl Surface {
    /// Leaves out readings that lie off those around them, above or below, by more than scatter and slope explain. A step or
    /// a scratch has neighbours of its own height and stays.
    pub(super) fn without_spikes(mut self) -> Self {
        self.leave_out_marks();
        if self.axis.is_some() {
            self.leave_out_absurd();
        }
        let mut scatter = None;
        for _ in 0..ROUNDS {
            let all: Vec<Option<Among>> =
                (0..self.heights.len()).into_par_iter().map(|cell| self.among(cell)).collect();
            let scatter = *scatter.get_or_insert_with(|| deviation(&all));
            let failed = |own: &Among| own.beyond > own.range.max(FAR * scatter);
            let mut left_out = 0;
            for (height, own) in self.heights.iter_mut().zip(&all) {
                if own.as_ref().is_some_and(failed) {
                    *height = f64::NAN;
                    left_out += 1;
                }
            }
            if left_out == 0 {
                break;
            }
        }
        self
    }

    /// Leaves out the number that an instrument writes for lost readings, as zero or -9999: the lowest or highest of all, there
    /// several times, and farther from all others than these are from each other.
    fn leave_out_marks(&mut self) {
        for sign in [1.0, -1.0] {
            let end = self.heights.iter().map(|z| sign * z).fold(f64::INFINITY, f64::min);
            let (mut least, mut most, mut count) = (f64::INFINITY, f64::NEG_INFINITY, 0);
            for z in self.heights.iter().map(|z| sign * z) {
                match z == end {
                    true => count += 1,
                    false => (least, most) = (least.min(z), most.max(z)),
                }
            }
            if count >= SEVERAL && most > least && least - end > most - least {
                let marks = self.heights.iter_mut().filter(|z| sign * **z == end);
                marks.for_each(|z| *z = f64::NAN);
            }
        }
    }

    /// Leaves out readings of a profile that are no heights: those around a reading are few there, and several of them may be
    /// none.
    fn leave_out_absurd(&mut self) {
        let mut known: Vec<f64> = self.heights.iter().copied().filter(|z| !z.is_nan()).collect();
        known.sort_unstable_by(f64::total_cmp);
        let beside = (BESIDE * known.len() as f64) as usize;
        let [low, high] = [known[beside], known[known.len() - 1 - beside]];
        let far = ABSURD * (high - low);
        let absurd: Vec<bool> =
            self.heights.iter().map(|z| *z < low - far || *z > high + far).collect();
        for (index, height) in self.heights.iter_mut().enumerate() {
            let around = index.saturating_sub(REACH[0])..(index + REACH[0] + 1).min(absurd.len());
            // The reading itself is one of them.
            let alike = absurd[around].iter().filter(|absurd| **absurd).count();
            if absurd[index] && alike <= REACH[0] {
                *height = f64::NAN;
            }
        }
    }

    /// A reading against those around it; `None` of a gap, or where next to none are around.
    fn among(&self, cell: usize) -> Option<Among> {
        let own = self.heights[cell];
        if own.is_nan() {
            return None;
        }
        let [columns, rows] = [0, 1].map(|axis| self.places[axis].len());
        let reach = REACH[usize::from(self.axis.is_none())];
        let [column, row] = [cell % columns, cell / columns];
        let mut others = [0.0; 24];
        let mut count = 0;
        for row in row.saturating_sub(reach)..=(row + reach).min(rows - 1) {
            for column in column.saturating_sub(reach)..=(column + reach).min(columns - 1) {
                let (place, height) =
                    (row * columns + column, self.heights[row * columns + column]);
                if place != cell && !height.is_nan() {
                    others[count] = height;
                    count += 1;
                }
            }
        }
        if count < 3 {
            return None;
        }
        let others = &mut others[..count];
        others.sort_unstable_by(f64::total_cmp);
        let median = 0.5 * (others[(count - 1) / 2] + others[count / 2]);
        let [low, high] = [others[count / OFF], others[count - 1 - count / OFF]];
        Some(Among {
            off: (own - median).abs(),
            beyond: (own - high).max(low - own),
            range: high - low,
        })
    }
}

/// Standard deviation of readings about the median of those around them (m).
fn deviation(all: &[Option<Among>]) -> f64 {
    let mut off: Vec<f64> = all.iter().flatten().map(|own| own.off).collect();
    if off.is_empty() {
        return 0.0;
    }
    let place = ((MOST * off.len() as f64) as usize).min(off.len() - 1);
    let (_, within, _) = off.select_nth_unstable_by(place, f64::total_cmp);
    *within / WITHIN
}
