//! Tests as random effects: the mean of their logarithms of k, how they scatter, and what the next test will show.
//!
//! A test is known as x_i with the variance v_i of its reading; tests scatter about the mean mu with the variance tau^2. tau^2
//! is that of Paule and Mandel (J. Res. NBS 87 (1982) 377), the weights are 1 / (tau^2 + v_i), and the variance of the mean is
//! scaled by what the tests show (Hartung & Knapp, Stat. Med. 20 (2001) 3875), with Student's t on n - 1 degrees of freedom.
//! Where all v_i are equal this is the mean with its t interval, exactly.

use statrs::distribution::{ContinuousCDF, Normal, StudentsT};

/// What tests say together.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Effects {
    /// Mean of the tests.
    pub mean: f64,
    /// Its standard deviation.
    pub deviation: f64,
    /// Standard deviation between tests, the reading taken off: tau.
    pub between: f64,
    /// Standard deviation of what another test will show, read as these were, about the mean found here.
    pub next: f64,
    /// Degrees of freedom.
    pub degrees: f64,
}

impl Effects {
    /// Of two tests or more, each with the variance of its reading; `None` of fewer.
    pub fn of(values: &[f64], variances: &[f64]) -> Option<Self> {
        let count = values.len();
        if count < 2 {
            return None;
        }
        let excess = |tau2: f64| scatter(values, variances, tau2).1 - (count - 1) as f64;
        let (mut low, mut high) = (0.0, spread(values));
        let tau2 = match excess(0.0) > 0.0 {
            false => 0.0,
            true => {
                while high - low > f64::EPSILON * high {
                    let middle = 0.5 * (low + high);
                    if excess(middle) > 0.0 { low = middle } else { high = middle }
                }
                high
            }
        };
        let ([mean, weight], sum) = scatter(values, variances, tau2);
        let shown = sum / (count - 1) as f64;
        let (own, reading) = (shown / weight, variances.iter().sum::<f64>() / count as f64);
        Some(Self {
            mean,
            deviation: own.sqrt(),
            between: tau2.sqrt(),
            next: (shown * (tau2 + reading) + own).sqrt(),
            degrees: (count - 1) as f64,
        })
    }
}

/// Mean and sum of weights at a variance between tests, and the weighted sum of squares about the mean.
fn scatter(values: &[f64], variances: &[f64], tau2: f64) -> ([f64; 2], f64) {
    // Tests that agree exactly, read without error, weigh equally.
    let weights: Vec<f64> =
        variances.iter().map(|v| 1.0 / (tau2 + v).max(f64::MIN_POSITIVE.sqrt())).collect();
    let weight: f64 = weights.iter().sum();
    let mean = values.iter().zip(&weights).map(|(x, w)| w * x).sum::<f64>() / weight;
    let sum = values.iter().zip(&weights).map(|(x, w)| w * (x - mean).powi(2)).sum();
    ([mean, weight], sum)
}

/// A variance no smaller than tau^2: the sum of squares about the middle.
fn spread(values: &[f64]) -> f64 {
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    values.iter().map(|x| (x - mean).powi(2)).sum::<f64>()
}

/// Half the width of the 95 % interval, in standard deviations.
pub fn factor(degrees: f64) -> f64 {
    student(degrees).inverse_cdf(0.975)
}

/// The same of a value whose standard deviation is known.
pub fn known_factor() -> f64 {
    Normal::standard().inverse_cdf(0.975)
}

/// How probable a ratio at least so far from zero is by chance.
pub fn chance(ratio: f64, degrees: f64) -> f64 {
    2.0 * student(degrees).cdf(-ratio.abs())
}

pub(super) fn student(degrees: f64) -> StudentsT {
    // Degrees of freedom are counted by whoever asks, and are positive.
    StudentsT::new(0.0, 1.0, degrees.max(1e-3)).unwrap_or_else(|_| unreachable!())
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::{Effects, chance, factor};

    /// Equal readings: the mean, the standard error and the interval of the next one of any textbook.
    #[test]
    fn tests_read_alike_are_a_sample() {
        let values: [f64; 4] = [1.0, 2.0, 4.0, 5.0];
        // Sum of squares about 3 is 10.
        let s2 = 10.0 / 3.0;
        for v in [0.0, 0.5, 20.0] {
            let effects = Effects::of(&values, &[v; 4]).unwrap();
            assert_relative_eq!(effects.mean, 3.0, max_relative = 1e-12);
            assert_relative_eq!(effects.deviation, (s2 / 4.0_f64).sqrt(), max_relative = 1e-9);
            assert_relative_eq!(effects.next, (s2 * 1.25_f64).sqrt(), max_relative = 1e-9);
            assert_relative_eq!(effects.between, (s2 - v).max(0.0).sqrt(), max_relative = 1e-9);
        }
    }

    #[test]
    fn a_test_read_badly_weighs_little() {
        let effects = Effects::of(&[0.0, 0.1, 5.0], &[0.01, 0.01, 100.0]).unwrap();
        assert!(effects.mean < 0.06, "{effects:?}");
        assert_eq!(Effects::of(&[1.0], &[1.0]), None);
        let same = Effects::of(&[1.0, 1.0], &[0.0, 0.0]).unwrap();
        assert_eq!((same.mean, same.between, same.deviation), (1.0, 0.0, 0.0));
    }

    /// Tables of Student's t.
    #[test]
    fn quantiles_are_those_of_the_tables() {
        for (degrees, known) in [(1.0, 12.706), (2.0, 4.303), (9.0, 2.262), (1e6, 1.960)] {
            assert_relative_eq!(factor(degrees), known, max_relative = 3e-4);
        }
        assert_relative_eq!(chance(4.303, 2.0), 0.05, max_relative = 1e-3);
    }
}
