//! Strip theory: an elliptic patch that rolls as Carter's cylinders do, strip by strip.
//!
//! D. J. Haines and E. Ollerton, *Proc. Inst. Mech. Eng.* 177 (1963) 95; Johnson, *Contact
//! Mechanics*, section 8.4. The strips follow the rolling direction and do not feel each other; each
//! has the length of the ellipse and the pressure of Hertz where it lies, so that the same length
//! slips at the trailing edge of all of them.
//!
//! Creepages are relative to the one at which the middle strip, and with it the patch, slips all
//! over: mu a / R of [`super::carter::saturation_creepage`] with the half width a and combined radius
//! R along the rolling direction. The pressure p0 of the ellipse itself would give 2 mu p0 / E*; the
//! longer the patch across, the closer both are.

use std::f64::consts::FRAC_2_PI;

/// Share of the contact area that sticks at a relative creepage x:
/// (2/pi) [acos x - x sqrt(1 - x^2)], none from x = 1 on.
pub fn stick_share(relative_creepage: f64) -> f64 {
    let x = relative_creepage.abs().min(1.0);
    FRAC_2_PI * (x.acos() - x * (1.0 - x * x).sqrt())
}

/// Tangential force relative to its limit mu N, at a relative creepage x, its sign that of the
/// creepage: 1 - (3/2) [s - s^3/3 - x acos x] with s = sqrt(1 - x^2), the sum of Carter's forces
/// weighted with the loads of the strips.
pub fn relative_force(relative_creepage: f64) -> f64 {
    let x = relative_creepage.abs().min(1.0);
    let s = (1.0 - x * x).sqrt();
    relative_creepage.signum() * (1.0 - 1.5 * (s - s.powi(3) / 3.0 - x * x.acos()))
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::{relative_force, stick_share};
    use crate::closed_form::{carter, kalker::Coefficients};

    /// Force and share of stick summed over strips at y = b sin t, of relative length cos t: their
    /// loads go with its square, their creepages relative to their own saturation with its inverse.
    fn summed(creepage: f64) -> (f64, f64) {
        let count = 100_000;
        let step = std::f64::consts::PI / f64::from(count);
        let (mut force, mut load, mut stick, mut area) = (0.0, 0.0, 0.0, 0.0);
        for i in 0..count {
            let length = ((f64::from(i) + 0.5) * step).sin();
            let own = creepage / length;
            force += length.powi(3) * carter::relative_force(own);
            load += length.powi(3);
            stick += length.powi(2) * (1.0 - own.abs()).max(0.0);
            area += length.powi(2);
        }
        (force / load, stick / area)
    }

    #[test]
    fn carters_strips_sum_to_both() {
        for creepage in [0.05, 0.3, -0.62, 0.95, 1.0, 2.0] {
            let (force, stick) = summed(creepage);
            assert_relative_eq!(relative_force(creepage), force, epsilon = 1e-8);
            assert_relative_eq!(stick_share(creepage), stick, epsilon = 1e-8);
        }
    }

    #[test]
    fn from_all_sticking_to_all_slipping() {
        assert_relative_eq!(stick_share(0.0), 1.0);
        assert_relative_eq!(relative_force(0.0), 0.0);
        assert_eq!((stick_share(1.0), relative_force(1.0)), (0.0, 1.0));
        assert_eq!((stick_share(-3.0), relative_force(-3.0)), (0.0, -1.0));
    }

    /// At small creepage the force is G a b C11 xi with Kalker's limit for narrow ellipses: the slope
    /// times 2 pi / (3 * 2 (1 - nu)), from N = (2 pi / 3) a b p0 and a saturation of
    /// 2 mu p0 (1 - nu) / G. At a/b = 1/10 the limit is 2 % off.
    #[test]
    fn small_creepage_meets_linear_theory() {
        let slope = relative_force(1e-6) / 1e-6;
        for poisson in [0.0, 0.25, 0.5] {
            let narrow = Coefficients::at(0.1, poisson).unwrap().longitudinal;
            let found = slope * std::f64::consts::PI / (3.0 * (1.0 - poisson));
            assert_relative_eq!(found, narrow, max_relative = 0.02);
        }
    }

    /// Reference values of the twin discs (b/a = 3.8) at 0.5 %: 26.2 % stick by strip theory, 27 % in an
    /// independent half-space solution. That lies between the strips saturated by mu a / R, 0.802 %, and
    /// by 2 mu p0 / E*, 0.840 %.
    #[test]
    fn twin_discs() {
        let by_radius = carter::saturation_creepage(0.6, 0.2165120e-3, 16.199846e-3);
        let by_pressure = 2.0 * 0.6 * 800.3693e6 / (0.5 * 208e9 / 0.91);
        let [low, high] = [by_radius, by_pressure].map(|limit| stick_share(0.005 / limit));
        assert_relative_eq!(low, 0.262, epsilon = 1e-3);
        assert!(low < 0.27 && 0.27 < high && high < 0.3, "{low} to {high}");
    }
}
