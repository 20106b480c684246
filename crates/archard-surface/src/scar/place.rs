//! Where the scar lies, roughly: robust least squares at all shifts.
//!
//! Differences are held against a tenth of the depth, so that one valley is left whatever noise and debris do (A. Blake and A. Zisserman,
//! *Visual Reconstruction*, MIT 1987).

use super::FREEDOM;
use super::model::{LINEAR, Model};
use crate::outliers::{BY_MEDIAN, median};

/// Share of the depth that differences are held against.
const SCALE: f64 = 0.1;
/// Growths that are tried first, a factor apart: the width and depth of one lead to those of the next.
const TRIED: std::ops::RangeInclusive<i32> = -4..=4;
const FACTOR: f64 = 4.0;
/// Shifts are tried this share of the width apart: a tenth of the depth of a parabola is a twentieth of its width from its side.
const APART: f64 = 1.0 / 40.0;
/// Least part of the scar that lies on the profile, at a shift.
const PART: f64 = 0.05;
/// Growths that are sought, from and to.
pub(super) const GROWN: [f64; 2] = [1e-3, 1e3];
/// Rounds of the growth, as depths are a power of it, and of its weights.
const ROUNDS: [usize; 2] = [3, 4];

/// The shift (m) and the growth at which readings are nearest to the model; `None` where they ask for no scar anywhere.
pub(super) fn roughly(model: &Model<'_>, noise: f64) -> Option<(f64, f64)> {
    let blocks = model.blocks;
    let ends = [blocks.places[0], blocks.places[blocks.len() - 1]];
    let mut best: Option<(f64, f64, f64)> = None;
    for first in TRIED.map(|power| FACTOR.powi(power)) {
        let width = model.shape.width(first);
        let scale = (SCALE * model.shape.deepest(first)).max(noise);
        let reach = 0.5 * (blocks.span() + width);
        let middle = 0.5 * (ends[0] + ends[1]);
        let step = (APART * width).max(blocks.step());
        let shifts = (0..).map(|i| middle - reach + step * f64::from(i));
        for shift in shifts.take_while(|shift| *shift < middle + reach) {
            let seen = ends.map(|end| end - shift);
            if model.shape.section_within(first, seen) < PART * model.shape.section(first) {
                continue;
            }
            let Some((grown, cost)) = at(model, (shift, first), scale, noise) else { continue };
            if grown > GROWN[0] && best.is_none_or(|(least, ..)| cost < least) {
                best = Some((cost, shift, grown));
            }
        }
    }
    best.map(|(_, shift, grown)| (shift, grown))
}

/// The growth at a shift from a first one on, and the cost of what is left: less the logarithm of its likelihood, of Student's t with the
/// scale that it has.
fn at(model: &Model<'_>, (shift, first): (f64, f64), scale: f64, noise: f64) -> Option<(f64, f64)> {
    let mut grown = first;
    let mut left = vec![];
    for _ in 0..ROUNDS[0] {
        let (columns, heights) = model.linear(shift, grown);
        let mut weights = vec![1.0; heights.len()];
        for _ in 0..ROUNDS[1] {
            let numbers = weighted(&columns, &heights, &weights)?;
            let residual = |at: usize| {
                heights[at] - (0..LINEAR).map(|i| numbers[i] * columns[i][at]).sum::<f64>()
            };
            left = (0..heights.len()).map(residual).collect();
            weights = left.iter().map(|own| weight(own / scale)).collect();
            grown = numbers[LINEAR - 1].clamp(GROWN[0], GROWN[1]);
        }
    }
    let mut sizes: Vec<f64> = left.iter().map(|own| own.abs()).collect();
    let spread = (BY_MEDIAN * median(&mut sizes)?).max(noise);
    let far = left.iter().map(|own| (1.0 + (own / spread).powi(2) / FREEDOM).ln()).sum::<f64>();
    Some((grown, left.len() as f64 * spread.ln() + 0.5 * (FREEDOM + 1.0) * far))
}

/// The weight of a deviation in Student's t.
fn weight(deviation: f64) -> f64 {
    (FREEDOM + 1.0) / (FREEDOM + deviation * deviation)
}

/// The numbers of columns nearest to heights, by weights, by G. Cramer's rule; `None` of columns that depend on each other.
fn weighted(columns: &[Vec<f64>], heights: &[f64], weights: &[f64]) -> Option<[f64; LINEAR]> {
    let sum = |one: &[f64], other: &[f64]| -> f64 {
        one.iter().zip(other).zip(weights).map(|((a, b), w)| a * b * w).sum()
    };
    let matrix: [[f64; LINEAR]; LINEAR] =
        std::array::from_fn(|i| std::array::from_fn(|j| sum(&columns[i], &columns[j])));
    let sums: [f64; LINEAR] = std::array::from_fn(|i| sum(&columns[i], heights));
    let whole = determinant(&matrix);
    let scale: f64 = (0..LINEAR).map(|i| matrix[i][i]).product();
    if whole.is_nan() || whole.abs() <= f64::EPSILON.sqrt() * scale {
        return None;
    }
    Some(std::array::from_fn(|j| {
        let mut other = matrix;
        (0..LINEAR).for_each(|i| other[i][j] = sums[i]);
        determinant(&other) / whole
    }))
}

fn determinant([[a, b, c], [d, e, f], [g, h, i]]: &[[f64; 3]; 3]) -> f64 {
    a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
}
