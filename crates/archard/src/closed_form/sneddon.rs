//! A punch of revolution c r^n pressed on a half-space: cone, sphere, and blunter shapes.
//!
//! I. N. Sneddon, *Int. J. Eng. Sci.* 3 (1965) 47; L. A. Galin, *Contact Problems* (1961; Springer 2008); Johnson,
//! *Contact Mechanics*, section 5.3. Under a contact of radius a
//!
//! ```text
//! approach = n c a^n I,  I = integral of sin^(n - 1) from 0 to pi/2,
//! load     = 2 E* a approach n/(n + 1).
//! ```
//!
//! For a cone that is pi/2 c a and pi/2 E* c a^2, for a sphere (n = 2, c = 1/(2 R)) Hertz.

use std::f64::consts::FRAC_PI_4;

use crate::numerics::quadrature::gauss_legendre;

/// A punch c r^n and the contact it makes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Punch {
    /// Radius of the contact (m).
    pub radius: f64,
    /// Approach of the bodies (m).
    pub approach: f64,
    /// Normal force (N).
    pub load: f64,
}

impl Punch {
    /// The contact of that radius (m) under a punch of factor c (m^(1 - n)) and exponent n, up to some hundred, at
    /// that contact modulus (Pa).
    pub fn of_radius(coefficient: f64, exponent: f64, modulus: f64, radius: f64) -> Self {
        let approach = exponent * coefficient * radius.powf(exponent) * sines(exponent);
        let load = 2.0 * modulus * radius * approach * exponent / (exponent + 1.0);
        Self { radius, approach, load }
    }

    /// The same at that approach (m).
    pub fn of_approach(coefficient: f64, exponent: f64, modulus: f64, approach: f64) -> Self {
        let radius = (approach / (exponent * coefficient * sines(exponent))).powf(1.0 / exponent);
        Self::of_radius(coefficient, exponent, modulus, radius)
    }
}

/// The integral of sin^(n - 1) from 0 to pi/2, from that of a higher power, which is smooth at zero.
fn sines(exponent: f64) -> f64 {
    const SMOOTH: f64 = 12.0;
    let (mut power, mut factor) = (exponent, 1.0);
    while power < SMOOTH {
        factor *= (power + 1.0) / power;
        power += 2.0;
    }
    let rule = gauss_legendre(64);
    let value = |x: f64| (FRAC_PI_4 * (1.0 + x)).sin().powf(power - 1.0);
    factor * FRAC_PI_4 * rule.iter().map(|(x, weight)| weight * value(*x)).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, PI};

    use approx::assert_relative_eq;

    use super::{Punch, sines};
    use crate::closed_form::Hertz;

    #[test]
    fn the_exponent_of_a_sphere_is_hertz() {
        let hertz = Hertz::from_load([20.0; 2], 115e9, 10.2).unwrap();
        let punch = Punch::of_approach(10.0, 2.0, 115e9, hertz.approach);
        assert_relative_eq!(punch.radius, hertz.semi_axes[0], max_relative = 1e-12);
        assert_relative_eq!(punch.load, hertz.load, max_relative = 1e-12);
    }

    /// Pi/2, 1 and pi/4 of n = 1, 2 and 3; the square of Gauss's constant's, 1.19814, of n = 3/2.
    #[test]
    fn integrals_of_sines_are_exact() {
        assert_relative_eq!(sines(1.0), FRAC_PI_2, max_relative = 1e-14);
        assert_relative_eq!(sines(2.0), 1.0, max_relative = 1e-14);
        assert_relative_eq!(sines(3.0), PI / 4.0, max_relative = 1e-14);
        assert_relative_eq!(sines(1.5), 1.198_140_234_735_592, max_relative = 1e-12);
    }
}
