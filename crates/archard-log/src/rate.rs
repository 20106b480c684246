//! The steady part of a step, its wear rate, and jumps of the transducer.

use statrs::distribution::{ContinuousCDF, Normal};

use crate::noise::{BINS, Found, means, regress};
use crate::steps::median;

/// Readings that a rate needs: twice as many as line and noise have parameters, in each half.
pub const FEWEST: usize = 20;

/// A rate (m/m) from one distance to another (m), and its 95 % interval.
#[derive(Debug, Clone, Copy)]
pub struct Rate {
    /// Depth over distance (m/m).
    pub rate: f64,
    /// Its 95 % interval (m/m).
    pub interval: [f64; 2],
    /// Where the part begins and ends (m).
    pub part: [f64; 2],
    /// Standard error (m/m).
    pub error: f64,
    /// Decay length of the noise (m).
    pub wander: f64,
}

/// Jumps: the first row after each, and its height (m). One step between two readings that no noise of the others makes once in a
/// hundred logs, and that stays: the medians of the readings of a bin before and after differ by more than half of it.
pub fn jumps(depth: &[f64]) -> Vec<(usize, f64)> {
    let steps: Vec<f64> = depth.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let middle = median(&steps);
    let off: Vec<f64> = steps.iter().map(|step| (step - middle).abs()).collect();
    let normal = Normal::new(0.0, 1.0).expect("the standard normal distribution");
    // The median deviation of a normal distribution is its third quartile.
    let sigma = median(&off) / normal.inverse_cdf(0.75);
    let resolution = resolution(depth);
    let bound = normal.inverse_cdf(1.0 - 0.005 / steps.len().max(1) as f64) * sigma.max(resolution);
    let width = depth.len().div_ceil(BINS).max(5);
    let stays = |row: usize| {
        let before = median(&depth[row.saturating_sub(width)..row]);
        median(&depth[row..(row + width).min(depth.len())]) - before
    };
    let large = (1..depth.len()).filter(|row| off[row - 1] > bound);
    large
        .map(|row| (row, stays(row)))
        .filter(|(row, stays)| {
            let step = steps[row - 1];
            stays.abs() > bound && stays * step > 0.5 * step * step
        })
        .collect()
}

/// The smallest difference of two neighbours that is not zero.
fn resolution(depth: &[f64]) -> f64 {
    let steps = depth.windows(2).map(|pair| (pair[1] - pair[0]).abs());
    let least = steps.filter(|step| *step > 0.0).fold(f64::INFINITY, f64::min);
    if least.is_finite() { least } else { 0.0 }
}

/// The rate of all that is given, with a step at each jump.
pub fn rate(distance: &[f64], depth: &[f64], jumps: &[usize]) -> Option<Rate> {
    let n = depth.len();
    if n < FEWEST {
        return None;
    }
    let bins = n.min(BINS);
    let (first, last) = (distance[0], distance[n - 1]);
    let span = last - first;
    if span.is_nan() || span <= 0.0 {
        return None;
    }
    let step =
        |jump: usize| -> Vec<f64> { (0..n).map(|row| f64::from(u8::from(row >= jump))).collect() };
    let mut columns = vec![vec![1.0; bins]];
    columns.extend(jumps.iter().map(|jump| means(&step(*jump), bins)));
    let along: Vec<f64> = distance.iter().map(|at| (at - first) / span).collect();
    columns.push(means(&along, bins));
    let found = regress(&columns, &means(depth, bins))?;
    // Two ends, each rounded: a variance of a twelfth of the square of the resolution each.
    let rounded = resolution(depth) / 6f64.sqrt();
    let found = Found { error: found.error.hypot(rounded), ..found };
    Some(Rate {
        rate: found.value / span,
        interval: found.interval().map(|end| end / span),
        part: [first, last],
        error: found.error / span,
        wander: found.length * span / bins as f64,
    })
}

/// Of the tenths up to the middle, the start after which the rate has the smallest standard error: readings of the running in widen
/// it, readings that are left out do as well (the marginal standard error rule of White, Simulation 69 (1997) 323, for a slope).
pub fn steady(distance: &[f64], depth: &[f64], jumps: &[usize]) -> Option<Rate> {
    let end = distance.last()?;
    let starts = (0..=5).map(|tenth| distance[0] + 0.1 * f64::from(tenth) * (end - distance[0]));
    let rates = starts.filter_map(|start| from(start, distance, depth, jumps));
    rates.min_by(|one, other| one.error.total_cmp(&other.error))
}

/// The rate from a distance on.
pub fn from(start: f64, distance: &[f64], depth: &[f64], jumps: &[usize]) -> Option<Rate> {
    let row = distance.partition_point(|at| *at < start);
    let later: Vec<usize> =
        jumps.iter().filter(|jump| **jump > row).map(|jump| jump - row).collect();
    rate(&distance[row..], &depth[row..], &later)
}

/// A mean and its 95 % interval.
pub fn mean(values: &[f64]) -> Option<(f64, [f64; 2])> {
    if values.len() < FEWEST {
        return None;
    }
    let bins = values.len().min(BINS);
    let found = regress(&[vec![1.0; bins]], &means(values, bins))?;
    Some((found.value, found.interval()))
}
