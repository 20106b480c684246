//! What coefficients the next test will have.

use statrs::distribution::{ContinuousCDF, Normal};

use super::effects::student;

/// The coefficient below which that share of the next tests lies, by its median, the scale of its logarithm and the degrees of
/// freedom of Student's t.
pub fn next_test([median, scale, degrees]: [f64; 3], share: f64) -> f64 {
    let share = share.clamp(f64::EPSILON, 1.0 - f64::EPSILON);
    median * (scale * student(degrees).inverse_cdf(share)).exp()
}

/// The second of two shares, each drawn evenly between zero and one, so that both go together: normal deviates of them have
/// that correlation, and it is spread as evenly as before. A Gaussian copula.
pub fn together([one, other]: [f64; 2], correlation: f64) -> f64 {
    let normal = Normal::standard();
    let own = (1.0 - correlation * correlation).max(0.0).sqrt();
    let [a, b] =
        [one, other].map(|share| normal.inverse_cdf(share.clamp(f64::EPSILON, 1.0 - f64::EPSILON)));
    normal.cdf(correlation * a + own * b)
}

#[cfg(test)]
mod tests {
    use super::{next_test, together};

    /// The 97.5 % quantile of Student's t of two degrees of freedom is 4.303, of any table.
    #[test]
    fn the_next_test_is_students() {
        let next = next_test([2.0, 0.1, 2.0], 0.975);
        assert!((next - 2.0 * 0.43027_f64.exp()).abs() < 1e-4, "{next}");
        assert!(next_test([2.0, 0.1, 2.0], 0.0).is_finite() && together([1.0, 0.0], 0.5) < 1.0);
    }

    /// Shares that go wholly together are the same, and those that do not stay as they are.
    #[test]
    fn shares_go_together() {
        for share in [0.01, 0.3, 0.99] {
            assert!((together([share, 0.4], 1.0) - share).abs() < 1e-12);
            assert!((together([share, 0.4], 0.0) - 0.4).abs() < 1e-12);
            assert!((together([share, 0.4], -1.0) - (1.0 - share)).abs() < 1e-12);
        }
    }
}
