//! Tests as random effects of several coefficients: y = J (theta + b) + e, with b of each test and e of each reading.
//!
//! The variances of b, one a coefficient, and of e, one a quantity, are those of restricted maximum likelihood, by the
//! iteration that multiplies each by the root of what is seen over what is expected (H. Zhou, L. Hu, J. Zhou and K. Lange,
//! J. Comput. Graph. Stat. 28 (2019) 350). Readings enter through J' J alone, so that a test may tell some coefficients only.

use super::matrix::{Matrix, add_square, dot, plus, power, product, times, zeros};

/// Iterations of the variances, and the relative change at which they have settled.
const ITERATIONS: usize = 300;
const SETTLED: f64 = 1e-4;
/// Share of the largest eigenvalue below which readings say nothing in a direction.
pub const NOTHING: f64 = 1e-10;

/// The readings of a test, linear in the coefficients.
#[derive(Debug, Clone, PartialEq)]
pub struct Rows {
    /// Derivatives by the logarithms of the coefficients, a row a reading.
    pub slopes: Vec<Vec<f64>>,
    /// What is left of the logarithms of the readings.
    pub left: Vec<f64>,
    /// What both were divided by: the stated uncertainty of the reading, or 1.
    pub unit: Vec<f64>,
    /// The variance of each reading is that of its group.
    pub group: Vec<usize>,
}

/// Variances between tests, a coefficient each, and of the groups of readings.
#[derive(Debug, Clone, PartialEq)]
pub struct Variances {
    pub between: Vec<f64>,
    pub readings: Vec<f64>,
}

impl Variances {
    /// A share of the way to others.
    pub fn towards(&self, others: &Self, share: f64) -> Self {
        let between = |one: &[f64], other: &[f64]| {
            one.iter().zip(other).map(|(a, b)| a + share * (b - a)).collect()
        };
        Self {
            between: between(&self.between, &others.between),
            readings: between(&self.readings, &others.readings),
        }
    }
}

/// What a test says under variances.
pub struct TestLikelihood {
    /// J' V^-1 J and J' V^-1 y.
    pub information: Matrix,
    pub score: Vec<f64>,
    /// T (1 + H T)^-1, with H = J' J over the variances of readings.
    shrink: Matrix,
    /// H itself and J' y over the variances.
    plain: (Matrix, Vec<f64>),
}

impl TestLikelihood {
    pub fn of(rows: &Rows, variances: &Variances) -> Self {
        let size = variances.between.len();
        let (mut plain, mut sums) = (zeros(size), vec![0.0; size]);
        for ((slopes, left), group) in rows.slopes.iter().zip(&rows.left).zip(&rows.group) {
            let weight = 1.0 / variances.readings[*group];
            add_square(&mut plain, slopes, weight);
            sums.iter_mut().zip(slopes).for_each(|(sum, slope)| *sum += weight * slope * left);
        }
        let root: Vec<f64> = variances.between.iter().map(|v| v.sqrt()).collect();
        let scaled = |matrix: &Matrix| -> Matrix {
            let row = |(row, a): (&Vec<f64>, &f64)| {
                row.iter().zip(&root).map(|(x, b)| a * x * b).collect()
            };
            matrix.iter().zip(&root).map(row).collect()
        };
        let mut inner = scaled(&plain);
        (0..size).for_each(|i| inner[i][i] += 1.0);
        let shrink = scaled(&power(&inner, -1.0, 0.0));
        let across = product(&plain, &shrink);
        let information = plus(&plain, &product(&across, &plain), -1.0);
        let score = sums.iter().zip(times(&across, &sums)).map(|(all, part)| all - part).collect();
        Self { information, score, shrink, plain: (plain, sums) }
    }

    /// The effects of the test where the coefficients are off by a change: b.
    pub fn effects(&self, change: &[f64]) -> Vec<f64> {
        let moved = times(&self.plain.0, change);
        let left: Vec<f64> = self.plain.1.iter().zip(moved).map(|(all, part)| all - part).collect();
        times(&self.shrink, &left)
    }
}

/// All tests under variances: what each says, the inverse of the information of all, and the change of the coefficients that
/// fits best.
pub struct JointFit {
    pub told: Vec<TestLikelihood>,
    pub inverse: Matrix,
    pub change: Vec<f64>,
}

impl JointFit {
    pub fn of(tests: &[Rows], variances: &Variances) -> Self {
        let told: Vec<TestLikelihood> =
            tests.iter().map(|rows| TestLikelihood::of(rows, variances)).collect();
        let size = variances.between.len();
        let sum = |all: Matrix, own: &TestLikelihood| plus(&all, &own.information, 1.0);
        let information = told.iter().fold(zeros(size), sum);
        let inverse = power(&information, -1.0, NOTHING);
        let score: Vec<f64> =
            (0..size).map(|i| told.iter().map(|own| own.score[i]).sum()).collect();
        let change = times(&inverse, &score);
        Self { told, inverse, change }
    }

    /// By how much each variance is to be multiplied.
    fn factors(&self, tests: &[Rows], variances: &Variances, stated: bool) -> Variances {
        let ratio = |seen: f64, expected: f64| match expected > 0.0 {
            true => (seen / expected).sqrt(),
            false => 1.0,
        };
        let size = variances.between.len();
        let mut between = vec![[0.0; 2]; size];
        let mut readings = vec![[0.0; 2]; variances.readings.len()];
        for (rows, own) in tests.iter().zip(&self.told) {
            let moved = times(&own.information, &self.change);
            let common = product(&product(&own.information, &self.inverse), &own.information);
            for i in 0..size {
                between[i][0] += (own.score[i] - moved[i]).powi(2);
                between[i][1] += own.information[i][i] - common[i][i];
            }
            if stated {
                continue;
            }
            let effects = own.effects(&self.change);
            for ((slopes, left), group) in rows.slopes.iter().zip(&rows.left).zip(&rows.group) {
                let weight = 1.0 / variances.readings[*group];
                let fitted = dot(slopes, &self.change) + dot(slopes, &effects);
                let shrunk = times(&own.shrink, slopes);
                // The row of V^-1 J.
                let moved = times(&own.plain.0, &shrunk);
                let row: Vec<f64> =
                    slopes.iter().zip(moved).map(|(a, b)| weight * (a - b)).collect();
                let known = dot(&row, &times(&self.inverse, &row));
                readings[*group][0] += (weight * (left - fitted)).powi(2);
                readings[*group][1] += weight - weight * weight * dot(slopes, &shrunk) - known;
            }
        }
        let all = |own: Vec<[f64; 2]>| own.into_iter().map(|[a, b]| ratio(a, b)).collect();
        Variances { between: all(between), readings: all(readings) }
    }
}

/// The variances of tests, from others on; those of readings stay where they are stated, those between tests of one test.
pub fn variances(tests: &[Rows], from: &Variances, stated: bool) -> Variances {
    let mut found = from.clone();
    for _ in 0..ITERATIONS {
        let factors = JointFit::of(tests, &found).factors(tests, &found, stated);
        let mut largest = 0.0_f64;
        let mut by = |values: &mut [f64], factors: &[f64], most: f64| {
            for (value, factor) in values.iter_mut().zip(factors) {
                // What has vanished against the others has settled.
                if *value > 1e-9 * most {
                    largest = largest.max((factor - 1.0).abs());
                }
                *value = (*value * factor).max(f64::MIN_POSITIVE.sqrt());
            }
        };
        let most = found.readings.iter().chain(&found.between).fold(0.0_f64, |a, b| a.max(*b));
        if tests.len() > 1 {
            by(&mut found.between, &factors.between, most);
        }
        if !stated {
            by(&mut found.readings, &factors.readings, most);
        }
        if largest < SETTLED {
            break;
        }
    }
    found
}
