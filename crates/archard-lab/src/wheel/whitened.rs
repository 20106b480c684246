//! Zones of profiles as readings of tests.

use super::super::joint::matrix::{Matrix, dot, power, times};
use super::super::joint::{Joint, NotTold, Tangent, Tests};
use super::super::{Error, Reading, Test};
use super::{Measured, Round, Target};

/// Profiles as readings whose errors do not go together: those of the zones of a profile are turned, as it is laid as a whole.
pub(super) struct Whitened {
    pub tests: Vec<Test>,
    /// For each test, the tangents of its readings at the logarithms of the run.
    tangents: Vec<Vec<Tangent>>,
    at: Vec<f64>,
    /// For each profile what turns it.
    turns: Vec<Matrix>,
    /// The test of each profile.
    pub of_test: Vec<usize>,
}

impl Whitened {
    pub fn of(
        (measured, round): (&[Measured], &Round),
        slopes: &[Matrix],
        at: &[f64],
    ) -> Result<Self, Error> {
        let none = Self {
            tests: vec![],
            tangents: vec![],
            at: at.to_vec(),
            turns: vec![],
            of_test: vec![],
        };
        let mut whitened = none;
        for ((own, laid), slopes) in measured.iter().zip(&round.laid).zip(slopes) {
            let size = laid.shares.len();
            let mut of_logs = laid.covariance.clone();
            for (i, row) in of_logs.iter_mut().enumerate() {
                row.iter_mut()
                    .enumerate()
                    .for_each(|(j, cell)| *cell /= laid.shares[i] * laid.shares[j]);
            }
            let turn = power(&of_logs, -0.5, 0.0);
            let logs: Vec<f64> = laid.shares.iter().map(|share| share.ln()).collect();
            let values = times(&turn, &logs);
            let known = whitened.tests.iter().position(|test| test.name == own.test);
            let test = known.unwrap_or_else(|| {
                whitened.tests.push(Test { name: own.test.clone(), load: None, readings: vec![] });
                whitened.tangents.push(vec![]);
                whitened.tests.len() - 1
            });
            for zone in 0..size {
                whitened.tests[test].readings.push(Reading {
                    line: own.line,
                    quantity: zone,
                    progress: own.distance,
                    // Only its logarithm counts.
                    value: values[zone].clamp(-600.0, 600.0).exp(),
                    uncertainty: Some(1.0),
                });
                let along =
                    |place: usize| (0..size).map(|j| turn[zone][j] * slopes[j][place]).sum();
                whitened.tangents[test]
                    .push(Tangent { log: 0.0, slopes: (0..at.len()).map(along).collect() });
            }
            whitened.turns.push(turn);
            whitened.of_test.push(test);
        }
        Ok(whitened)
    }

    /// The coefficients that fit all of them.
    pub fn joint(&self, targets: &[Target]) -> Result<Joint, Error> {
        let all = Tests { tests: &self.tests, quantities: self.at.len() };
        let mut model = |test: usize, logs: &[f64]| {
            let off: Vec<f64> = logs.iter().zip(&self.at).map(|(log, at)| log - at).collect();
            let of =
                |own: &Tangent| Tangent { log: dot(&own.slopes, &off), slopes: own.slopes.clone() };
            Ok::<_, Error>(self.tangents[test].iter().map(of).collect())
        };
        all.joint(&self.at, 1e-6, &mut model).map_err(|why| match why {
            NotTold::Model(error) => error,
            NotTold::Flat(places) => Error::Mismatch(format!(
                "the profiles do not determine {}: they are nearly the same whatever it is",
                places.iter().map(|place| format!("`{}`", targets[*place].key)).collect::<Vec<_>>().join(" and ")
            )),
            NotTold::Alone { test, coefficient } => Error::Mismatch(format!(
                "test `{}` alone determines `{}`, so that nothing says how it scatters between wheels: fit that wheel alone",
                self.tests[test].name, targets[coefficient].key
            )),
            NotTold::Unsettled => Error::Mismatch("no coefficients fit the profiles best".to_owned()),
        })
    }

    /// What is uncertain in each coefficient by errors of the logarithms of the zones of each profile.
    pub fn response(&self, joint: &Joint, errors: &[Vec<f64>]) -> Vec<f64> {
        let mut sums = vec![0.0; self.at.len()];
        for zone in 0..self.turns.first().map_or(0, Vec::len) {
            let mut more: Vec<Vec<f64>> = vec![vec![]; self.tests.len()];
            for ((turn, test), errors) in self.turns.iter().zip(&self.of_test).zip(errors) {
                more[*test].extend(turn.iter().map(|row| row[zone] * errors[zone]));
            }
            for (sum, change) in sums.iter_mut().zip(joint.response(&more)) {
                *sum += change.abs();
            }
        }
        sums
    }
}
