//! Several coefficients of one model from the same tests; a single test need not give them all.
//!
//! Least squares of all readings find the medians first. Then each test has coefficients of its own, which scatter about them: the
//! model is linearised where each test is (M. J. Lindstrom and D. M. Bates, Biometrics 46 (1990) 673), and [`mixed`] and [`robust`]
//! say what follows.

pub mod matrix;
mod mixed;
mod robust;
#[cfg(test)]
mod tests;
mod worth;

use super::within::{FLAT, ITERATIONS, STRIDE, Test};
use matrix::{Matrix, dot, eigen, plus, times, zeros};
use mixed::{JointFit, Rows, Variances, variances};

/// Factor by which steps are held back where they lead nowhere, and less where they do.
const HOLD: f64 = 10.0;
/// Rounds of variances, and change of the logarithms in one at which they have settled: relative to their standard uncertainties,
/// to which a tenth adds half a per cent.
const ROUNDS: usize = 30;
const OF_UNCERTAINTY: f64 = 0.1;
/// Squares over variances that tell nothing: those of a hundredth of a standard deviation.
const NEGLIGIBLE: f64 = 1e-4;
/// Rounds that change the variances freely.
const FREE: f64 = 4.0;
/// Change of the logarithms at which they are near enough to begin with.
pub const NEAR: f64 = 1e-3;
/// Part of a vector from which on a coefficient belongs to a combination.
const PART: f64 = 0.3;

/// What a model says of a reading.
#[derive(Debug, Clone, PartialEq)]
pub struct Tangent {
    /// Natural logarithm of the value.
    pub log: f64,
    /// Its derivatives by the logarithms of the coefficients.
    pub slopes: Vec<f64>,
}

/// What a model says of the readings of a test (by its place) at logarithms of the coefficients.
pub type Model<'a, E> = &'a mut dyn FnMut(usize, &[f64]) -> Result<Vec<Tangent>, E>;

/// Why tests do not tell the coefficients.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum NotTold<E> {
    /// The model failed.
    #[error(transparent)]
    Model(#[from] E),
    /// The readings say nothing of these coefficients, or of what they have in common.
    #[error("the readings do not determine the coefficients {0:?}")]
    Flat(Vec<usize>),
    /// One test alone says something of a coefficient: how that scatters is not known.
    #[error("test {test} alone determines the coefficient {coefficient}")]
    Alone {
        /// The places of both.
        test: usize,
        coefficient: usize,
    },
    /// There are no best coefficients.
    #[error("no coefficients fit the readings best")]
    Unsettled,
}

/// Several coefficients from tests.
#[derive(Debug, Clone, PartialEq)]
pub struct Joint {
    /// Natural logarithms of the medians.
    pub logs: Vec<f64>,
    /// Of each test, those of its own.
    pub of_tests: Vec<Vec<f64>>,
    /// How the errors of the logarithms of the medians correlate.
    pub correlation: Matrix,
    /// Variances of the logarithms, and their degrees of freedom.
    errors: Vec<(f64, f64)>,
    rows: Vec<Rows>,
    variances: Variances,
    stated: bool,
}

/// All tests, and how many quantities were measured in them.
#[derive(Debug, Clone, Copy)]
pub struct Tests<'a> {
    pub tests: &'a [Test],
    pub quantities: usize,
}

impl Tests<'_> {
    /// Whether all readings have uncertainties.
    fn stated(&self) -> bool {
        self.tests.iter().flat_map(|test| &test.readings).all(|own| own.uncertainty.is_some())
    }

    /// The rows of the tests at coefficients of their own, what is left being from the medians on. Readings of stated uncertainty
    /// are divided by it.
    fn rows<E>(
        &self,
        logs: &[f64],
        of_tests: &[Vec<f64>],
        model: Model<'_, E>,
    ) -> Result<Vec<Rows>, E> {
        let stated = self.stated();
        let one = |(place, (test, own)): (usize, (&Test, &Vec<f64>))| {
            let tangents = model(place, own)?;
            let effects: Vec<f64> = own.iter().zip(logs).map(|(own, all)| own - all).collect();
            let mut rows = Rows { slopes: vec![], left: vec![], unit: vec![], group: vec![] };
            for (reading, tangent) in test.readings.iter().zip(tangents) {
                let unit = reading.uncertainty.filter(|_| stated).unwrap_or(1.0);
                let left = reading.value.ln() - tangent.log + dot(&tangent.slopes, &effects);
                rows.left.push(left / unit);
                rows.unit.push(unit);
                rows.slopes.push(tangent.slopes.iter().map(|slope| slope / unit).collect());
                rows.group.push(if stated { 0 } else { reading.quantity });
            }
            Ok(rows)
        };
        self.tests.iter().zip(of_tests).enumerate().map(one).collect()
    }

    /// The coefficients that fit all readings best as if no test had its own, by Levenberg and Marquardt.
    pub fn pooled<E>(
        &self,
        guess: &[f64],
        settled: f64,
        model: Model<'_, E>,
    ) -> Result<Vec<f64>, NotTold<E>> {
        let flat = self.none(guess.len());
        let mut logs = guess.to_vec();
        let mut hold = 1e-3;
        let at = |logs: &[f64], model: Model<'_, E>| {
            self.rows(logs, &vec![logs.to_vec(); self.tests.len()], model)
        };
        let squares =
            |rows: &[Rows]| rows.iter().flat_map(|own| &own.left).map(|r| r * r).sum::<f64>();
        let mut rows = at(&logs, model)?;
        let count = rows.iter().map(|own| own.left.len()).sum::<usize>() as f64;
        for _ in 0..ITERATIONS {
            let mut information = zeros(logs.len());
            let mut score = vec![0.0; logs.len()];
            for own in rows.iter().map(|own| mixed::TestLikelihood::of(own, &flat)) {
                information = plus(&information, &own.information, 1.0);
                score.iter_mut().zip(&own.score).for_each(|(sum, part)| *sum += part);
            }
            let most = eigen(&information).last().map_or(0.0, |own| own.0);
            (0..logs.len()).for_each(|i| information[i][i] += hold * most.max(f64::MIN_POSITIVE));
            let step = times(&matrix::power(&information, -1.0, mixed::NOTHING), &score);
            let largest = step.iter().fold(0.0_f64, |most, own| most.max(own.abs()));
            let share = (STRIDE / largest).min(1.0);
            let next: Vec<f64> = logs.iter().zip(&step).map(|(x, step)| x + share * step).collect();
            if largest <= settled {
                return Ok(logs);
            }
            let tried = at(&next, model)?;
            let better = squares(&rows) - squares(&tried);
            if better >= 0.0 {
                let enough = NEGLIGIBLE / count * squares(&tried);
                (logs, rows) = (next, tried);
                if better < enough {
                    return Ok(logs);
                }
                hold /= HOLD;
            } else {
                hold *= HOLD;
            }
        }
        Err(NotTold::Unsettled)
    }

    /// No scatter between tests, and readings that weigh the same.
    fn none(&self, size: usize) -> Variances {
        Variances { between: vec![0.0; size], readings: vec![1.0; self.quantities.max(1)] }
    }

    /// The coefficients, from logarithms on, until they change by less than given.
    ///
    /// # Errors
    /// If the model fails, or the tests do not tell all coefficients.
    pub fn joint<E>(
        &self,
        guess: &[f64],
        settled: f64,
        model: Model<'_, E>,
    ) -> Result<Joint, NotTold<E>> {
        let size = guess.len();
        let stated = self.stated();
        let logs = self.pooled(guess, NEAR, model)?;
        let of_tests = vec![logs.clone(); self.tests.len()];
        let rows = self.rows(&logs, &of_tests, model)?;
        told(&rows, &self.none(size))?;
        // From what is left of all readings on, as scatter of both kinds.
        let count = rows.iter().map(|own| own.left.len()).sum::<usize>() as f64;
        let left = rows.iter().flat_map(|own| &own.left).map(|r| r * r).sum::<f64>() / count;
        let left = left.max(f64::EPSILON);
        let mut spread = self.none(size);
        if !stated {
            spread.readings.fill(left);
        }
        if self.tests.len() > 1 {
            spread.between.fill(if stated { 0.01 } else { left });
        }
        let mut at = Place { logs, of_tests, rows };
        for round in 1..=ROUNDS {
            // To and fro over the place where a coating ends: by less and less (H. Robbins and S. Monro, Ann. Math. Stat. 22 (1951) 400).
            let share = (FREE / round as f64).min(1.0);
            spread = spread.towards(&variances(&at.rows, &spread, stated), share);
            let before = at.logs.clone();
            at = self.best(at, &spread, settled, model)?;
            let known = JointFit::of(&at.rows, &spread).inverse;
            let off = |(i, log): (usize, &f64)| {
                (log - before[i]).abs() <= settled.max(OF_UNCERTAINTY * known[i][i].sqrt())
            };
            if at.logs.iter().enumerate().all(off) {
                return Joint::of(at, (spread, stated));
            }
        }
        Err(NotTold::Unsettled)
    }

    /// The coefficients and those of the tests that fit best under variances, by Gauss and Newton: each step as long as it makes
    /// things better, so that a place where a coating ends, and slopes jump, is an end too.
    fn best<E>(
        &self,
        from: Place,
        spread: &Variances,
        settled: f64,
        model: Model<'_, E>,
    ) -> Result<Place, NotTold<E>> {
        let mut at = from;
        for _ in 0..ITERATIONS {
            let fitted = JointFit::of(&at.rows, spread);
            let (mut steps, mut largest) = (vec![], 0.0_f64);
            for (own, told) in at.of_tests.iter().zip(&fitted.told) {
                let effects = told.effects(&fitted.change);
                let to =
                    at.logs.iter().zip(&fitted.change).zip(effects).map(|((x, y), z)| x + y + z);
                let step: Vec<f64> = own.iter().zip(to).map(|(x, to)| to - x).collect();
                largest = step.iter().fold(largest, |most, own| most.max(own.abs()));
                steps.push(step);
            }
            largest = fitted.change.iter().fold(largest, |most, own| most.max(own.abs()));
            let here = at.cost(spread);
            let mut share = (STRIDE / largest.max(f64::MIN_POSITIVE)).min(1.0);
            at = loop {
                if share * largest <= settled {
                    return Ok(at);
                }
                let moved = |x: &[f64], by: &[f64]| -> Vec<f64> {
                    x.iter().zip(by).map(|(x, by)| x + share * by).collect()
                };
                let logs = moved(&at.logs, &fitted.change);
                let of_tests: Vec<Vec<f64>> =
                    at.of_tests.iter().zip(&steps).map(|(own, step)| moved(own, step)).collect();
                let rows = self.rows(&logs, &of_tests, model)?;
                let next = Place { logs, of_tests, rows };
                let better = here - next.cost(spread);
                if (0.0..NEGLIGIBLE).contains(&better) {
                    return Ok(next);
                }
                if better > 0.0 {
                    break next;
                }
                share *= 0.5;
            };
        }
        Err(NotTold::Unsettled)
    }
}

/// Coefficients, those of each test, and the tests as they are linearised there.
struct Place {
    logs: Vec<f64>,
    of_tests: Vec<Vec<f64>>,
    rows: Vec<Rows>,
}

impl Place {
    /// Squares of what is left of readings and of the tests' own coefficients, over their variances.
    fn cost(&self, spread: &Variances) -> f64 {
        let mut sum = 0.0;
        for (rows, own) in self.rows.iter().zip(&self.of_tests) {
            let effects: Vec<f64> =
                own.iter().zip(&self.logs).map(|(own, all)| own - all).collect();
            for ((row, left), group) in rows.slopes.iter().zip(&rows.left).zip(&rows.group) {
                sum += (left - dot(row, &effects)).powi(2) / spread.readings[*group];
            }
            let between =
                effects.iter().zip(&spread.between).filter(|(_, variance)| **variance > 0.0);
            sum += between.map(|(effect, variance)| effect * effect / variance).sum::<f64>();
        }
        sum
    }
}

/// Refuses readings that say nothing in a direction.
fn told<E>(rows: &[Rows], flat: &Variances) -> Result<(), NotTold<E>> {
    let fitted = JointFit::of(rows, flat);
    let sum = |all: Matrix, own: &mixed::TestLikelihood| plus(&all, &own.information, 1.0);
    let information = fitted.told.iter().fold(zeros(flat.between.len()), sum);
    let squares: f64 = rows.iter().flat_map(|own| &own.slopes).map(|row| dot(row, row)).sum();
    match eigen(&information).first() {
        Some((least, vector)) if *least <= FLAT * squares => Err(NotTold::Flat(combined(vector))),
        _ => Ok(()),
    }
}

/// The coefficients that make up a direction.
fn combined(vector: &[f64]) -> Vec<usize> {
    (0..vector.len()).filter(|&i| vector[i].abs() > PART).collect()
}
