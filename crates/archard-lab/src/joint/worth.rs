//! What several coefficients are worth: intervals, how their errors correlate, exponents, and each as an estimate by itself.

use std::convert::Infallible;

use super::super::effects::factor;
use super::super::estimate::{Common, Estimate, MANY, UNTOLD};
use super::super::shape::Exponent;
use super::super::within::{FittedTest, Test};
use super::matrix::{Matrix, dot, eigen};
use super::mixed::{JointFit, Rows, Variances};
use super::robust::Covariance;
use super::{Joint, NotTold, Place, combined, told};

impl Joint {
    pub(super) fn of<E>(
        Place { logs, of_tests, rows }: Place,
        (variances, stated): (Variances, bool),
    ) -> Result<Self, NotTold<E>> {
        let (matrix, degrees) = covariance(&rows, &variances, stated)?;
        let by_readings = Variances { between: vec![0.0; logs.len()], ..variances.clone() };
        let by_readings = JointFit::of(&rows, &by_readings).inverse;
        match eigen(&by_readings).last() {
            Some((variance, vector)) if variance.sqrt() > UNTOLD => {
                return Err(NotTold::Flat(combined(vector)));
            }
            _ => {}
        }
        let size = logs.len();
        let root: Vec<f64> =
            (0..size).map(|i| matrix[i][i].max(f64::MIN_POSITIVE).sqrt()).collect();
        let entry = |i: usize, j: usize| (matrix[i][j] / (root[i] * root[j])).clamp(-1.0, 1.0);
        let correlation = (0..size).map(|i| (0..size).map(|j| entry(i, j)).collect()).collect();
        let errors = (0..size).map(|i| (matrix[i][i], degrees[i])).collect();
        Ok(Self { logs, of_tests, correlation, errors, rows, variances, stated })
    }

    /// By how much the logarithms change where the model says that much more of the logarithms of the readings of each test.
    pub fn response(&self, more: &[Vec<f64>]) -> Vec<f64> {
        let part = |(own, more): (&Rows, &Vec<f64>)| {
            let left = more.iter().zip(&own.unit).map(|(more, unit)| -more / unit).collect();
            Rows { left, ..own.clone() }
        };
        let rows: Vec<Rows> = self.rows.iter().zip(more).map(part).collect();
        JointFit::of(&rows, &self.variances).change
    }

    /// The exponent of something, by its logarithm at each reading of each test, that all coefficients go by besides the law.
    fn exponent(&self, law: f64, logs: &[Vec<f64>]) -> Option<Exponent> {
        let all = || logs.iter().flatten();
        let middle = all().sum::<f64>() / all().count() as f64;
        let widened = |(own, logs): (&Rows, &Vec<f64>)| {
            let wider = |(row, log): (&Vec<f64>, &f64)| -> Vec<f64> {
                row.iter().copied().chain([row.iter().sum::<f64>() * (log - middle)]).collect()
            };
            Rows { slopes: own.slopes.iter().zip(logs).map(wider).collect(), ..own.clone() }
        };
        let rows: Vec<Rows> = self.rows.iter().zip(logs).map(widened).collect();
        let mut variances = self.variances.clone();
        variances.between.push(0.0);
        let flat = Variances {
            between: vec![0.0; variances.between.len()],
            readings: vec![1.0; variances.readings.len()],
        };
        told::<Infallible>(&rows, &flat).ok()?;
        let fitted = JointFit::of(&rows, &variances);
        let (matrix, degrees) = covariance::<Infallible>(&rows, &variances, self.stated).ok()?;
        let last = self.logs.len();
        (degrees[last] >= 1.0).then(|| {
            Exponent::of(law, fitted.change[last], matrix[last][last].sqrt(), degrees[last])
        })
    }

    /// Each coefficient by itself: what is uncertain in all tests equally is common to each.
    pub fn estimates(&self, tests: &[Test], commons: &[Vec<Common>]) -> Vec<Estimate> {
        let far = |test: &Test| test.readings.iter().map(|own| own.progress.ln()).collect();
        let distance = self.exponent(1.0, &tests.iter().map(far).collect::<Vec<_>>());
        let load = |test: &Test| test.load.map(|load| vec![load.ln(); test.readings.len()]);
        let loads: Option<Vec<_>> = tests.iter().map(load).collect();
        let loads = loads.and_then(|loads| self.exponent(0.0, &loads));
        let nothing = vec![];
        let common = |place: usize| commons.get(place).unwrap_or(&nothing);
        (0..self.logs.len())
            .map(|i| self.estimate(i, tests, (distance, loads), common(i)))
            .collect()
    }

    fn estimate(
        &self,
        place: usize,
        tests: &[Test],
        (distance, loads): (Option<Exponent>, Option<Exponent>),
        common: &[Common],
    ) -> Estimate {
        let (log, (variance, degrees)) = (self.logs[place], self.errors[place]);
        let many = tests.len() > 1;
        let shared: f64 = common.iter().map(|(_, u)| u * u).sum();
        let with_common = |variance: f64| {
            let all = variance + shared;
            // Welch and Satterthwaite: what is common is known from elsewhere.
            let degrees = if variance > 0.0 { degrees * (all / variance).powi(2) } else { MANY };
            (all.sqrt(), degrees.min(MANY))
        };
        let interval = |(deviation, degrees): (f64, f64)| {
            let half = factor(degrees) * deviation;
            [(log - half).exp(), (log + half).exp()]
        };
        // As many tests say something of it as degrees of freedom and one.
        let next = many.then(|| with_common(variance * (degrees + 2.0)));
        let known = self.stated || degrees >= 1.0;
        let reading = JointFit::of(
            &self.rows,
            &Variances {
                between: vec![0.0; self.logs.len()],
                readings: self.variances.readings.clone(),
            },
        );
        let reading = reading.inverse[place][place].min(variance);
        let mut budget = vec![("readings".to_owned(), reading.sqrt())];
        if many {
            budget.insert(0, ("scatter between tests".to_owned(), (variance - reading).sqrt()));
        }
        budget.extend(common.iter().cloned());
        let fitted = |(rows, own): (&Rows, &Vec<f64>)| self.within(place, rows, own);
        Estimate {
            median: log.exp(),
            interval: known.then(|| interval(with_common(variance))),
            next: next.map(interval),
            predictive: next.map(|(deviation, degrees)| [deviation, degrees]),
            tests: tests
                .iter()
                .zip(&self.of_tests)
                .map(|(test, own)| (test.name.clone(), own[place].exp(), None))
                .collect(),
            between: many.then(|| self.variances.between[place].sqrt()),
            readings: (!self.stated)
                .then(|| self.variances.readings.iter().map(|v| v.sqrt()).collect()),
            understated: None,
            correlation: 0.0,
            distance,
            loads,
            by_load: vec![],
            budget,
            fitted: self.rows.iter().zip(&self.of_tests).map(fitted).collect(),
        }
    }

    /// The fit of a test as that of one coefficient.
    fn within(&self, place: usize, rows: &Rows, own: &[f64]) -> FittedTest {
        let effects: Vec<f64> = own.iter().zip(&self.logs).map(|(own, all)| own - all).collect();
        let each = || rows.slopes.iter().zip(&rows.unit);
        let left =
            |((row, unit), left): ((&Vec<f64>, &f64), &f64)| unit * (left - dot(row, &effects));
        FittedTest {
            log_k: own[place],
            slopes: each().map(|(row, unit)| unit * row[place]).collect(),
            residuals: each().zip(&rows.left).map(left).collect(),
        }
    }
}

/// The covariance of the logarithms, and the degrees of freedom of each: by tests, or of one test by its readings.
fn covariance<E>(
    rows: &[Rows],
    variances: &Variances,
    stated: bool,
) -> Result<(Matrix, Vec<f64>), NotTold<E>> {
    let fitted = JointFit::of(rows, variances);
    let size = fitted.change.len();
    if let [one] = rows {
        let degrees = if stated { MANY } else { one.left.len() as f64 - size as f64 };
        return Ok((fitted.inverse, vec![degrees; size]));
    }
    let found = Covariance::of(&fitted);
    match found.alone {
        Some((test, coefficient)) => Err(NotTold::Alone { test, coefficient }),
        None => Ok((found.matrix, found.degrees)),
    }
}
