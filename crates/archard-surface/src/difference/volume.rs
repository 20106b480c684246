//! Volumes over regions, and their uncertainty.
//!
//! A volume is a sum of changes over points, less the plane and the place found by all other points: a sum over noise in which
//! each point has a weight. Its variance follows from the covariance of the noise and holds all that is common to noise, level and
//! place.

use std::ops::Range;

use statrs::distribution::{ContinuousCDF, StudentsT};

use super::blocks::smoothed;
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
    /// By where regions end, and by points without a height in them.
    pub edge: f64,
    /// By all. Noise, level and place have common parts: their squares need not add up to its own.
    pub standard: f64,
    /// Half of the 95 % interval, by Student's t.
    pub expanded: f64,
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
    /// Of points, by the numbers of a range alone.
    pub(super) fn of(points: Vec<Option<(f64, Falls)>>, numbers: Range<usize>) -> Self {
        let mut matrix = [[0.0; PARAMETERS]; PARAMETERS];
        for (weight, falls) in points.iter().flatten() {
            for i in numbers.clone() {
                numbers.clone().for_each(|j| matrix[i][j] += weight * falls[i] * falls[j]);
            }
        }
        Self { points, inverse: inverse(&matrix) }
    }

    /// The weights of points in a sum of the numbers times `factors`.
    fn weights(&self, factors: &Falls) -> Vec<f64> {
        let by = times(&self.inverse, factors);
        let weight = |told: &Option<(f64, Falls)>| {
            told.map_or(0.0, |(weight, falls)| weight * product(&falls, &by))
        };
        self.points.iter().map(weight).collect()
    }
}

fn product(one: &Falls, other: &Falls) -> f64 {
    one.iter().zip(other).map(|(one, other)| one * other).sum()
}

/// The uncertainty of sums of changes.
///
/// The place is found from smoothed maps, and with it the level from maps as they are. An error of the place changes a sum by the slopes of
/// its points, and by those of the points that the level is fitted to.
pub(super) struct Uncertainty<'a> {
    pub(super) noise: &'a Noise,
    /// How the change of every point falls with level and place.
    pub(super) falls: &'a [Option<Falls>],
    /// What tells the level.
    pub(super) level: ToldBy,
    /// What tells the place, from smoothed maps, and their Gaussian (points along x and y); nothing where the place was not sought.
    pub(super) place: Option<(ToldBy, [usize; 2], [f64; 2])>,
}

impl Uncertainty<'_> {
    /// A value that is a sum of changes with weights; `edge` is its uncertainty by the edge.
    pub(super) fn of(&self, value: f64, weights: &[f64], edge: f64) -> Uncertain {
        let mut falls = [0.0; PARAMETERS];
        for (weight, own) in weights.iter().zip(self.falls).filter(|(weight, _)| **weight != 0.0) {
            let own = own.unwrap_or_default();
            falls.iter_mut().zip(own).for_each(|(sum, one)| *sum += weight * one);
        }
        let (level, place) = self.fitted(falls);
        let sum = |own: f64, level_too: f64, place_too: f64| -> f64 {
            let all = weights.iter().zip(&level).zip(&place);
            let all =
                all.map(|((one, two), three)| own * one - level_too * two - place_too * three);
            self.noise.variance_of(&all.collect::<Vec<f64>>())
        };
        let standard = (sum(1.0, 1.0, 1.0) + edge * edge).sqrt();
        Uncertain {
            value,
            noise: sum(1.0, 0.0, 0.0).sqrt(),
            level: sum(0.0, 1.0, 0.0).sqrt(),
            place: sum(0.0, 0.0, 1.0).sqrt(),
            edge,
            standard,
            expanded: standard * self.coverage(),
        }
    }

    /// The standard uncertainty of a sum of the numbers of the placement times `factors`.
    pub(super) fn of_numbers(&self, factors: Falls) -> f64 {
        let (level, place) = self.fitted(factors);
        let both: Vec<f64> = level.iter().zip(&place).map(|(one, other)| one + other).collect();
        self.noise.variance_of(&both).sqrt()
    }

    /// The weights of points in a sum of the numbers of the placement times `falls`: through the level, and through the place.
    fn fitted(&self, falls: Falls) -> (Vec<f64>, Vec<f64>) {
        let mut of_level = falls;
        of_level[..LEVEL].fill(0.0);
        let level = self.level.weights(&of_level);
        let Some((told_by, elements, deviation)) = &self.place else {
            return (level.clone(), vec![0.0; level.len()]);
        };
        // The level follows the place.
        let mut of_place = falls;
        of_place[LEVEL..].fill(0.0);
        let told = level.iter().zip(self.falls);
        for (weight, own) in told.filter_map(|(weight, own)| Some((weight, (*own)?))) {
            (0..LEVEL).for_each(|at| of_place[at] -= weight * own[at]);
        }
        let place = smoothed(*elements, &told_by.weights(&of_place), *deviation);
        (level, place)
    }

    /// The quantile of Student's t for 95 %.
    fn coverage(&self) -> f64 {
        // Its parameters are positive.
        StudentsT::new(0.0, 1.0, self.noise.freedom).map_or(f64::NAN, |t| t.inverse_cdf(0.975))
    }
}
