//! Vermeulen and Johnson's law: force of a rolling elliptic contact that creeps without spin.
//!
//! P. J. Vermeulen and K. L. Johnson, *J. Appl. Mech.* 31 (1964) 338. Their stick zone is an ellipse
//! that touches the leading edge; the force follows from the one of linear theory alone, for which
//! Kalker's coefficients are taken in place of their own. On a circle it then lies 3 to 4 % below the
//! exact one while part of the contact slips.

/// Force relative to its limit, 1 - (1 - t/3)^3, at a force of linear theory relative to that limit
/// t; all slips from t = 3 on. Its sign is that of t.
pub fn relative_force(relative_linear_force: f64) -> f64 {
    let stick = 1.0 - relative_linear_force.abs().min(3.0) / 3.0;
    relative_linear_force.signum() * (1.0 - stick.powi(3))
}

/// Force (N) at a force of linear theory (N) along the rolling direction and across, of the same
/// direction; its limit is friction times load (N).
///
/// The linear one comes from [`super::kalker::Coefficients::resultant`] without spin.
pub fn force(linear: [f64; 2], limit: f64) -> [f64; 2] {
    let size = linear[0].hypot(linear[1]);
    if size == 0.0 || limit == 0.0 {
        return [0.0; 2];
    }
    linear.map(|part| limit * relative_force(size / limit) * part / size)
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::{force, relative_force};
    use crate::closed_form::kalker::Coefficients;

    /// The force over its limit of a circle, Poisson ratio 0.3, at creepages relative to mu F/(G a b).
    fn circle(creepage: [f64; 2]) -> [f64; 2] {
        let coefficients = Coefficients::at(1.0, 0.3).unwrap();
        force(coefficients.resultant(1.0, [1.0; 2], creepage, 0.0).force, 1.0)
    }

    /// Reference values of the exact theory, good for 1 %: the law stays 3 to 5 % below.
    #[test]
    fn a_little_below_the_exact_forces() {
        for (creepage, along, across) in [(0.2, 0.664, 0.598), (0.4, 0.955, 0.903)] {
            let found = [circle([creepage, 0.0])[0], circle([0.0, creepage])[1]];
            for (found, exact) in found.into_iter().zip([along, across]) {
                assert!((0.95..0.97).contains(&(-found / exact)), "{found} for {exact}");
            }
        }
    }

    /// At small creepage the law is linear: t - t^2/3 + t^3/27.
    #[test]
    fn linear_theory_is_the_limit() {
        let coefficients = Coefficients::at(1.0, 0.3).unwrap();
        let [along, across] = circle([3e-7, -4e-7]);
        assert_relative_eq!(along, -3e-7 * coefficients.longitudinal, max_relative = 1e-6);
        assert_relative_eq!(across, 4e-7 * coefficients.lateral, max_relative = 1e-6);
        assert_relative_eq!(relative_force(1.5), 1.5 - 0.75 + 0.125, max_relative = 1e-14);
        assert_relative_eq!(relative_force(-1.5), -0.875, max_relative = 1e-14);
    }

    /// Beyond t = 3 friction is all there is, in the direction of the linear force.
    #[test]
    fn all_slips_in_the_end() {
        assert_eq!(relative_force(3.0), 1.0);
        let [along, across] = force([30.0, -40.0], 5.0);
        assert_relative_eq!(along, 3.0, max_relative = 1e-14);
        assert_relative_eq!(across, -4.0, max_relative = 1e-14);
    }

    #[test]
    fn no_force_without_creepage_or_friction() {
        assert_eq!(force([0.0; 2], 1.0), [0.0; 2]);
        assert_eq!(force([1.0, 0.0], 0.0), [0.0; 2]);
    }
}
