//! Volumes over regions, and their uncertainty.
//!
//! A volume is a sum of changes over points, less the plane and the place found by all other points: a sum over noise in which
//! each point has a weight. Its variance follows from the covariance of the noise and holds all that is common to noise, level and
//! place.

use std::ops::Range;

use statrs::distribution::{ContinuousCDF, Normal, StudentsT};

use super::noise::Noise;
use super::placement::{LEVEL, PARAMETERS};
use super::solve::{Square, inverse, times};

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
    /// By where regions end, and by walls between points.
    pub edge: f64,
    /// By points without a height.
    pub missing: f64,
    /// By all. Noise, level and place have common parts: their squares need not add up to its own.
    pub standard: f64,
    /// Half of the 95 % interval: of what is of noise by Student's t, of the rest by the normal distribution.
    pub expanded: f64,
}

/// What a value is uncertain by besides noise, level and place: standard uncertainties.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Besides {
    pub(super) edge: f64,
    pub(super) missing: f64,
}

/// How a change falls with the numbers of a placement.
pub(super) type Falls = [f64; PARAMETERS];

/// Points that numbers of a placement are fitted to: their weight and how their change falls, and the inverse of the matrix of least
/// squares.
pub(super) struct ToldBy {
    pub(super) points: Vec<Option<(f64, Falls)>>,
    pub(super) inverse: Square,
}

impl ToldBy {
    /// Of points.
    pub(super) fn of(points: Vec<Option<(f64, Falls)>>) -> Self {
        let mut matrix = [[0.0; PARAMETERS]; PARAMETERS];
        for (weight, falls) in points.iter().flatten() {
            for i in 0..PARAMETERS {
                (0..PARAMETERS).for_each(|j| matrix[i][j] += weight * falls[i] * falls[j]);
            }
        }
        Self { points, inverse: inverse(&matrix) }
    }

    /// The weights of points in a sum of the numbers, each with a factor, for those of a range alone.
    fn weights(&self, factors: &Falls, numbers: Range<usize>) -> Vec<f64> {
        let mut by = times(&self.inverse, factors);
        (0..PARAMETERS).filter(|at| !numbers.contains(at)).for_each(|at| by[at] = 0.0);
        let weight = |told: &Option<(f64, Falls)>| {
            told.map_or(0.0, |(weight, falls)| weight * product(&falls, &by))
        };
        self.points.iter().map(weight).collect()
    }
}

fn product(one: &Falls, other: &Falls) -> f64 {
    one.iter().zip(other).map(|(one, other)| one * other).sum()
}

/// The uncertainty of sums of changes: an error of place or level changes them by the slopes of their points.
pub(super) struct Uncertainty<'a> {
    pub(super) noise: &'a Noise,
    /// How the change of every point falls with level and place.
    pub(super) falls: &'a [Option<Falls>],
    /// What gives both.
    pub(super) told: ToldBy,
}

impl Uncertainty<'_> {
    /// A value that is a sum of changes with weights.
    pub(super) fn of(&self, value: f64, weights: &[f64], besides: Besides) -> Uncertain {
        let falls = self.falls_of(weights);
        let level = self.told.weights(&falls, LEVEL..PARAMETERS);
        let place = self.told.weights(&falls, 0..LEVEL);
        let sum = |own: f64, level_too: f64, place_too: f64| -> f64 {
            let all = weights.iter().zip(&level).zip(&place);
            let all =
                all.map(|((one, two), three)| own * one - level_too * two - place_too * three);
            self.noise.variance_of(&all.collect::<Vec<f64>>())
        };
        let Besides { edge, missing } = besides;
        let by_noise = sum(1.0, 1.0, 1.0);
        let rest = edge * edge + missing * missing;
        let [student, normal] = self.coverage();
        Uncertain {
            value,
            noise: sum(1.0, 0.0, 0.0).sqrt(),
            level: sum(0.0, 1.0, 0.0).sqrt(),
            place: sum(0.0, 0.0, 1.0).sqrt(),
            edge,
            missing,
            standard: (by_noise + rest).sqrt(),
            expanded: (student * student * by_noise + normal * normal * rest).sqrt(),
        }
    }

    /// The variance of a sum of changes with weights.
    pub(super) fn variance_of(&self, weights: &[f64]) -> f64 {
        let fitted = self.told.weights(&self.falls_of(weights), 0..PARAMETERS);
        let all = weights.iter().zip(&fitted).map(|(one, other)| one - other);
        self.noise.variance_of(&all.collect::<Vec<f64>>())
    }

    /// The standard uncertainty of a sum of the numbers of the placement times `factors`.
    pub(super) fn of_numbers(&self, factors: Falls) -> f64 {
        self.noise.variance_of(&self.told.weights(&factors, 0..PARAMETERS)).sqrt()
    }

    fn falls_of(&self, weights: &[f64]) -> Falls {
        let mut falls = [0.0; PARAMETERS];
        for (weight, own) in weights.iter().zip(self.falls).filter(|(weight, _)| **weight != 0.0) {
            let own = own.unwrap_or_default();
            falls.iter_mut().zip(own).for_each(|(sum, one)| *sum += weight * one);
        }
        falls
    }

    /// The quantiles for 95 % of Student's t and of the normal distribution.
    fn coverage(&self) -> [f64; 2] {
        // Its parameters are positive.
        let student = StudentsT::new(0.0, 1.0, self.noise.freedom);
        [student.map_or(f64::NAN, |t| t.inverse_cdf(0.975)), Normal::standard().inverse_cdf(0.975)]
    }
}
