//! A regression on readings that are not independent: noise is a part that decays over a length (autoregression of first order) and a
//! part of each reading alone. Length and share are those of the largest restricted likelihood (Patterson and Thompson, Biometrika 58
//! (1971) 545); the columns are whitened by a Kalman filter. Student's t has as many degrees of freedom as the stretch holds integrated
//! autocorrelation times, twice the decay length (Sokal, 1997).

use statrs::distribution::{ContinuousCDF, StudentsT};

/// A coefficient, its standard error, the degrees of freedom and the decay length of the noise (in spacings).
#[derive(Debug, Clone, Copy)]
pub struct NoiseFit {
    /// The estimate.
    pub value: f64,
    /// Its standard error.
    pub error: f64,
    /// Degrees of freedom of Student's t.
    pub freedom: f64,
    /// Decay length of the noise, in spacings of the readings.
    pub length: f64,
}

impl NoiseFit {
    /// The 95 % interval.
    pub fn interval(&self) -> [f64; 2] {
        let t = StudentsT::new(0.0, 1.0, self.freedom).expect("a degree of freedom at least");
        let half = t.inverse_cdf(0.975) * self.error;
        [self.value - half, self.value + half]
    }
}

/// Means of as equally many readings as there are bins.
pub fn means(values: &[f64], bins: usize) -> Vec<f64> {
    let edge = |bin: usize| bin * values.len() / bins;
    let mean = |own: &[f64]| own.iter().sum::<f64>() / own.len() as f64;
    (0..bins).map(|bin| mean(&values[edge(bin)..edge(bin + 1)])).collect()
}

/// Bins of readings: fewer readings than these stay as they are. Made up noise has the same coverage with 60 and with 120.
pub const BINS: usize = 60;

/// The last coefficient of `y` on the columns, at equally spaced readings.
pub fn regress(columns: &[Vec<f64>], y: &[f64]) -> Option<NoiseFit> {
    let (n, p) = (y.len(), columns.len());
    if n < p + 3 {
        return None;
    }
    let most = 4.0 * n as f64;
    // Sixteen lengths from white noise, .2 spacings, to a random walk over the stretch.
    let lengths = (0..16).map(|step| 0.2 * (most / 0.2).powf(f64::from(step) / 15.0));
    let tried = lengths.flat_map(|length| [0.0, 0.05, 0.2, 0.5, 0.8].map(|share| (length, share)));
    let best = tried
        .filter_map(|(length, share)| at(columns, y, length, share))
        .max_by(|one, other| one.0.total_cmp(&other.0))?;
    Some(best.1)
}

fn at(columns: &[Vec<f64>], y: &[f64], length: f64, share: f64) -> Option<(f64, NoiseFit)> {
    let (n, p) = (y.len(), columns.len());
    let rho = (-1.0 / length).exp();
    let (mut states, mut variance, mut log_det) = (vec![0.0; p + 1], 1.0 - share, 0.0);
    let mut products = vec![vec![0.0; p + 1]; p + 1];
    for row in 0..n {
        if row > 0 {
            variance = rho * rho * variance + (1.0 - share) * (1.0 - rho * rho);
            states.iter_mut().for_each(|state| *state *= rho);
        }
        let total = variance + share;
        let gain = variance / total;
        let value = |column: usize| if column < p { columns[column][row] } else { y[row] };
        let ahead: Vec<f64> = (0..=p).map(|column| value(column) - states[column]).collect();
        for (state, new) in states.iter_mut().zip(&ahead) {
            *state += gain * new;
        }
        for (one, line) in products.iter_mut().enumerate() {
            for (other, product) in line.iter_mut().enumerate() {
                *product += ahead[one] * ahead[other] / total;
            }
        }
        variance *= 1.0 - gain;
        log_det += total.ln();
    }
    // Cholesky of the products with `y` last: its corner is the root of the sum of squares.
    let mut root = vec![vec![0.0; p + 1]; p + 1];
    for row in 0..=p {
        for column in 0..=row {
            let sum: f64 = (0..column).map(|k| root[row][k] * root[column][k]).sum();
            let rest = products[row][column] - sum;
            root[row][column] = match row == column {
                true if row == p => rest.max(f64::MIN_POSITIVE).sqrt(),
                true if rest > 0.0 => rest.sqrt(),
                true => return None,
                false => rest / root[column][column],
            };
        }
    }
    let freedom = (n - p) as f64;
    let squares = root[p][p] * root[p][p];
    let own = root[p - 1][p - 1];
    let columns_log: f64 = (0..p).map(|k| root[k][k].ln()).sum();
    let likelihood = -0.5 * log_det - columns_log - 0.5 * freedom * squares.ln();
    let found = NoiseFit {
        value: root[p][p - 1] / own,
        error: (squares / freedom).sqrt() / own,
        // Scale, length and share of the noise: three degrees at least.
        freedom: (n as f64 / (2.0 * length)).clamp(3f64.min(freedom), freedom),
        length,
    };
    Some((likelihood, found))
}
