//! The steady part of a step and its wear rate.

use crate::noise::{BINS, NoiseFit, means, regress};
use crate::transducer::resolution;

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

/// Width of the 95 % interval of a normal distribution, in its standard deviations.
const NORMAL: f64 = 3.92;

impl Rate {
    /// The standard deviation (m/m) of a normal distribution that has the same interval.
    pub fn deviation(&self) -> f64 {
        (self.interval[1] - self.interval[0]) / NORMAL
    }
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
    let found = NoiseFit { error: found.error.hypot(rounded), ..found };
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
