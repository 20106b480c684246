//! Volumes over regions, and what they are uncertain by.
//!
//! A volume is a sum of changes over points, less the plane and the place found by all other points: a sum over noise in which
//! each point has a weight. Its variance follows from the covariance of the noise and holds all that is common to noise, level and
//! place.

use statrs::distribution::{ContinuousCDF, StudentsT};

use super::noise::Noise;
use super::placement::{LEVEL, PARAMETERS};
use super::solve::{Square, times};

/// A value found from changes with its standard uncertainties, in the unit of the value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Uncertain {
    /// The value: a volume (m^3) or a depth (m).
    pub value: f64,
    /// By the noise of the points that it is a sum of.
    pub noise: f64,
    /// By the level: offset and tilts between the scans.
    pub level: f64,
    /// By shift and turn.
    pub place: f64,
    /// By where regions end, and by points without a height in them.
    pub edge: f64,
    /// By all. Noise, level and place have common parts: their squares need not add up to its own.
    pub standard: f64,
    /// Half of the 95 % interval, by Student's t.
    pub expanded: f64,
}

/// What sums of changes are uncertain by.
pub(super) struct Uncertainty<'a> {
    pub(super) noise: &'a Noise,
    /// Of points that tell level and place: their weight and how their change falls with these.
    pub(super) told_by: &'a [Option<(f64, [f64; PARAMETERS])>],
    /// How the change of every point falls with level and place.
    pub(super) falls: &'a [Option<[f64; PARAMETERS]>],
    pub(super) inverse: &'a Square,
}

impl Uncertainty<'_> {
    /// A value that is a sum of changes with weights; `edge` is its uncertainty by the edge.
    pub(super) fn of(&self, value: f64, weights: &[f64], edge: f64) -> Uncertain {
        let mut falls = [0.0; PARAMETERS];
        for (weight, own) in weights.iter().zip(self.falls).filter(|(weight, _)| **weight != 0.0) {
            let own = own.unwrap_or_default();
            falls.iter_mut().zip(own).for_each(|(sum, one)| *sum += weight * one);
        }
        let by = times(self.inverse, &falls);
        let part = |own: bool, which: std::ops::Range<usize>| -> f64 {
            let fitted = |told: &Option<(f64, [f64; PARAMETERS])>| {
                told.map_or(0.0, |(weight, falls)| {
                    weight * which.clone().map(|one| falls[one] * by[one]).sum::<f64>()
                })
            };
            let all = self.told_by.iter().zip(weights);
            let all = all.map(|(told, weight)| if own { *weight } else { 0.0 } - fitted(told));
            self.noise.variance_of(&all.collect::<Vec<f64>>())
        };
        let standard = (part(true, 0..PARAMETERS) + edge * edge).sqrt();
        Uncertain {
            value,
            noise: part(true, 0..0).sqrt(),
            level: part(false, LEVEL..PARAMETERS).sqrt(),
            place: part(false, 0..LEVEL).sqrt(),
            edge,
            standard,
            expanded: standard * self.coverage(),
        }
    }

    /// The quantile of Student's t for 95 %.
    fn coverage(&self) -> f64 {
        // Its parameters are positive.
        StudentsT::new(0.0, 1.0, self.noise.freedom).map_or(f64::NAN, |t| t.inverse_cdf(0.975))
    }
}
