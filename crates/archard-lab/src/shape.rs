//! Whether tests wear as the model says they do: over the distance, and over the load.

use std::f64::consts::LN_10;

use super::effects::{Effects, chance, factor};
use super::within::{FittedTest, Test};

/// A law is rejected where chance would show what was seen less often than this: where the 95 % interval of an exponent leaves it out.
pub const REJECTED: f64 = 0.05;
/// An exponent closer to the law than this does not reject it: over a decade it changes k by 12 %.
pub const NEGLIGIBLE: f64 = 0.05;

/// An exponent with its interval and how probable it is if the law holds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Exponent {
    /// The exponent found.
    pub value: f64,
    /// The exponent of the law.
    pub law: f64,
    /// Its 95 % interval.
    pub interval: [f64; 2],
    /// The probability of something at least as far off, if the law holds.
    pub p: f64,
}

impl Exponent {
    /// Whether the law is rejected: what was seen is no chance, and not negligible.
    pub fn rejects(&self) -> bool {
        self.p < REJECTED && (self.value - self.law).abs() > NEGLIGIBLE
    }

    /// Whether the readings leave it open: the interval holds an exponent of one less, wear that does not depend on it at all.
    pub fn is_open(&self) -> bool {
        let [low, high] = self.interval;
        !self.rejects() && (low..=high).contains(&(self.law - 1.0))
    }

    /// The exponent, its interval, how probable it is, and what follows from both.
    pub fn in_words(&self) -> String {
        let off = (self.value - self.law).abs();
        let is_chance = self.p >= REJECTED;
        // What is no chance and negligible has the digits that tell it from the law.
        let decimals = match is_chance || self.rejects() {
            true => 2,
            false => (1.0 - off.log10().floor()).max(2.0) as usize,
        };
        let number = |value: f64| format!("{value:.decimals$}");
        let (p, word) = match (is_chance, self.rejects()) {
            (true, _) if self.is_open() => (
                format!("p = {:.2}", self.p),
                format!("open, as the interval holds {:.0}, no dependence at all", self.law - 1.0),
            ),
            (true, _) => (format!("p = {:.2}", self.p), "accepted".to_owned()),
            (false, true) => (format!("p < {REJECTED}"), "rejected".to_owned()),
            (false, false) => (
                format!("p < {REJECTED}"),
                format!(
                    "accepted, though it is no chance: off by {}, and less than {NEGLIGIBLE} is negligible",
                    number(off)
                ),
            ),
        };
        let [low, high] = self.interval.map(number);
        format!("{} ({low} .. {high}), {p}: {word}", number(self.value))
    }

    pub(super) fn of(law: f64, difference: f64, deviation: f64, degrees: f64) -> Self {
        let half = factor(degrees) * deviation;
        let value = law + difference;
        let p = match deviation > 0.0 {
            true => chance(difference / deviation, degrees),
            false => f64::from(u8::from(difference == 0.0)),
        };
        Self { value, law, interval: [value - half, value + half], p }
    }
}

/// The exponent q of the distance if wear went by k s^q, where the law says 1; `None` where the readings cannot tell.
///
/// Each test has an exponent of its own, and they are tests as any: it is their scatter that counts, as readings of a test
/// are not independent. Fewer than three tests are judged by their residuals, and tests of one reading each by how their k
/// goes with the distance.
pub fn over_distance(
    (tests, fitted): (&[Test], &[FittedTest]),
    weights: &[Vec<f64>],
    correlation: f64,
) -> Option<Exponent> {
    let slopes: Vec<Slope> = (tests.iter().zip(fitted).zip(weights))
        .filter_map(|((test, fitted), weights)| Slope::of(test, fitted, weights))
        .collect();
    if slopes.len() >= 3 {
        let information: f64 = slopes.iter().map(|slope| slope.information).sum();
        let mean =
            slopes.iter().map(|slope| slope.information * slope.value).sum::<f64>() / information;
        let square = slopes.iter().map(|slope| slope.information * (slope.value - mean).powi(2));
        let degrees = (slopes.len() - 1) as f64;
        let deviation = (square.sum::<f64>() / degrees / information).sqrt();
        return Some(Exponent::of(1.0, mean, deviation, degrees));
    }
    if slopes.is_empty() {
        let point = |(test, fitted): (&Test, &FittedTest)| [mean_log(test), fitted.log_k];
        let points: Vec<[f64; 2]> = tests.iter().zip(fitted).map(point).collect();
        let [slope, deviation] = line(&points)?;
        return Some(Exponent::of(1.0, slope, deviation, points.len() as f64 - 2.0));
    }
    let degrees: f64 = slopes.iter().map(|slope| slope.readings - 2.0).sum();
    let independent = (1.0 - correlation) / (1.0 + correlation);
    let left: f64 = slopes.iter().map(|slope| slope.left).sum();
    if degrees < 1.0 {
        return None;
    }
    let information: f64 = slopes.iter().map(|slope| slope.information).sum();
    let mean =
        slopes.iter().map(|slope| slope.information * slope.value).sum::<f64>() / information;
    let deviation = (left / degrees / information / independent).sqrt();
    Some(Exponent::of(1.0, mean, deviation, (degrees * independent).max(1.0)))
}

/// What the residuals of a test say of its exponent.
struct Slope {
    /// The exponent less 1.
    value: f64,
    /// The inverse of its variance, in units of that of the weights.
    information: f64,
    /// Weighted squares of the residuals that are left.
    left: f64,
    readings: f64,
}

impl Slope {
    /// Least squares for the exponent besides k.
    fn of(test: &Test, fitted: &FittedTest, weights: &[f64]) -> Option<Self> {
        let size = weights.len();
        let sum =
            |part: &dyn Fn(usize) -> f64| -> f64 { (0..size).map(|j| weights[j] * part(j)).sum() };
        let along = |j: usize| fitted.slopes[j];
        let middle = sum(&|j| along(j).powi(2) * test.readings[j].progress.ln())
            / sum(&|j| along(j).powi(2));
        let across = |j: usize| along(j) * (test.readings[j].progress.ln() - middle);
        let information = sum(&|j| across(j).powi(2));
        // Readings at one place have nothing to say.
        if information <= 1e-9 * sum(&|j| along(j).powi(2)) {
            return None;
        }
        let value = sum(&|j| across(j) * fitted.residuals[j]) / information;
        let left = sum(&|j| fitted.residuals[j].powi(2)) - value * value * information;
        Some(Self { value, information, left: left.max(0.0), readings: size as f64 })
    }
}

/// The exponent of the load that k depends on, where a constant k says 0; `None` without three tests at two loads. Loads at which wear
/// that does not depend on them at all would change k by what is [negligible](NEGLIGIBLE) are one load, as that of a dead weight is
/// measured a little differently in each test.
pub fn over_loads(tests: &[Test], fitted: &[FittedTest]) -> Option<Exponent> {
    let point = |(test, fitted): (&Test, &FittedTest)| Some([test.load?.ln(), fitted.log_k]);
    let points: Vec<[f64; 2]> = tests.iter().zip(fitted).map(point).collect::<Option<_>>()?;
    let ends = points.iter().map(|point| point[0]);
    let [low, high] = [ends.clone().reduce(f64::min)?, ends.reduce(f64::max)?];
    if high - low < NEGLIGIBLE * LN_10 {
        return None;
    }
    let [slope, deviation] = line(&points)?;
    Some(Exponent::of(0.0, slope, deviation, points.len() as f64 - 2.0))
}

/// Slope of the straight line through points, and its standard deviation; `None` of fewer than three points or of one abscissa.
fn line(points: &[[f64; 2]]) -> Option<[f64; 2]> {
    let count = points.len() as f64;
    let mean = |axis: usize| points.iter().map(|point| point[axis]).sum::<f64>() / count;
    let [x, y] = [0, 1].map(mean);
    let square = points.iter().map(|point| (point[0] - x).powi(2)).sum::<f64>();
    if points.len() < 3 || square <= 1e-9 {
        return None;
    }
    let slope = points.iter().map(|[a, b]| (a - x) * (b - y)).sum::<f64>() / square;
    let left = points.iter().map(|[a, b]| (b - y - slope * (a - x)).powi(2)).sum::<f64>();
    Some([slope, (left / (count - 2.0) / square).sqrt()])
}

/// Mean of the logarithms of the distances of a test.
fn mean_log(test: &Test) -> f64 {
    let logs = test.readings.iter().map(|reading| reading.progress.ln());
    logs.sum::<f64>() / test.readings.len() as f64
}

/// The tests of each load, by rising load, and what they say together; `None` of a load with a single test.
pub fn by_load(
    tests: &[Test],
    fitted: &[FittedTest],
    variances: &[f64],
) -> Vec<(f64, usize, f64, Option<Effects>)> {
    let mut loads: Vec<f64> = tests.iter().filter_map(|test| test.load).collect();
    loads.sort_by(f64::total_cmp);
    loads.dedup_by(|one, other| (*one - *other).abs() <= 1e-6 * *one);
    let group = |load: f64| {
        let own = |index: &usize| {
            tests[*index].load.is_some_and(|other| (other - load).abs() <= 1e-6 * load)
        };
        let own: Vec<usize> = (0..tests.len()).filter(own).collect();
        let values: Vec<f64> = own.iter().map(|&i| fitted[i].log_k).collect();
        let variances: Vec<f64> = own.iter().map(|&i| variances[i]).collect();
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        (load, own.len(), mean, Effects::of(&values, &variances))
    };
    loads.into_iter().map(group).collect()
}

#[cfg(test)]
mod tests {
    use super::{Exponent, over_loads};
    use crate::within::{FittedTest, Test};

    /// A dead weight that was measured a little differently in each test is one load, and gives no exponent; two loads give one.
    #[test]
    fn nearly_equal_loads_are_one() {
        let fitted = [0.0, 0.1, -0.1, 0.05];
        let fitted = fitted.map(|log_k| FittedTest { log_k, slopes: vec![], residuals: vec![] });
        let tests = |loads: [f64; 4]| {
            loads.map(|load| Test { name: load.to_string(), load: Some(load), readings: vec![] })
        };
        assert_eq!(over_loads(&tests([10.005, 10.002, 9.998, 10.0]), &fitted), None);
        let two = over_loads(&tests([10.0, 10.0, 20.0, 20.0]), &fitted).unwrap();
        assert!(!two.rejects() && two.value.abs() < 0.2, "{two:?}");
    }

    #[test]
    fn what_is_accepted_has_its_reason() {
        let words = |value: f64, half: f64, p: f64| {
            Exponent { value, law: 1.0, interval: [value - half, value + half], p }.in_words()
        };
        assert_eq!(words(0.98, 0.06, 0.43), "0.98 (0.92 .. 1.04), p = 0.43: accepted");
        assert_eq!(
            words(0.9862, 0.0051, 1e-4),
            "0.986 (0.981 .. 0.991), p < 0.05: accepted, though it is no chance: off by 0.014, and less than 0.05 is negligible"
        );
        assert_eq!(
            words(0.7, 0.9, 0.4),
            "0.70 (-0.20 .. 1.60), p = 0.40: open, as the interval holds 0, no dependence at all"
        );
        assert_eq!(words(0.5, 0.1, 1e-5), "0.50 (0.40 .. 0.60), p < 0.05: rejected");
    }
}
