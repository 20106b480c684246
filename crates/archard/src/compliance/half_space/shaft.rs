//! A shaft: a solid cylinder in plane strain, as a half-space and what its round surface adds.
//!
//! Under a pressure cos(n theta) the surface of a cylinder of radius R moves inwards by w_n cos(n theta). Michell's stress functions
//! r^n cos(n theta) and r^(n + 2) cos(n theta), without shear on the surface, give with kappa = 3 - 4 nu
//!
//! ```text
//! w_n = R/(4 G) [(kappa + 1) n - (kappa - 1)]/(n^2 - 1)
//! ```
//!
//! for n > 1, and for the even pressure n = 0. A pressure with n = 1 is a force, against which something has to hold the shaft. Here it is
//! a body force that is the same in all of the shaft, under which w_1 = (1 - 2 nu) R/(4 G) over its axis; another hold on the axis changes
//! w_1 alone, and a motion w_1 cos(theta) closes gaps as an approach does: pressures do not depend on the hold. A line load has all n, with
//! known sums, with L = -ln(2 sin|theta/2|) and S = (pi - theta)/2
//!
//! ```text
//! sum sin(n theta)/(n^2 - 1)      = sin(theta) (L + 1/4)
//! sum sin(n theta)/(n^3 - n)      = 3/4 sin(theta) - S (1 - cos(theta))          n = 2, 3, ...
//! ```

use std::f64::consts::PI;

use crate::body::Material;

/// A shaft.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Shaft {
    /// Radius (m).
    pub radius: f64,
    /// What it is made of.
    pub material: Material,
}

impl Shaft {
    /// Displacement (m/Pa) at the edge of a strip of unit pressure that reaches as far along the arc (m), with the sign of that.
    pub fn strip(&self, x: f64) -> f64 {
        let Material { poisson, .. } = self.material;
        let kappa = 3.0 - 4.0 * poisson;
        let angle = x / self.radius;
        let (sine, cosine) = angle.sin_cos();
        let logarithm = -(2.0 * (0.5 * angle).sin().abs()).ln();
        let sweep = 0.5 * (PI - angle.abs()) * angle.signum();
        let even_and_force = 0.5 * (kappa - 1.0) * (angle + sine);
        let one = sine * (logarithm + 0.25);
        let other = 0.75 * sine - sweep * (1.0 - cosine);
        let sum = even_and_force + (kappa + 1.0) * one - (kappa - 1.0) * other;
        self.radius / (4.0 * PI * self.material.shear_modulus()) * sum
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use approx::{assert_abs_diff_eq, assert_relative_eq};

    use super::Shaft;
    use crate::body::Material;
    use crate::body::profile::Round;
    use crate::compliance::half_space::stack::Stack;

    /// The displacement (m) inwards of a shaft at theta = 0 under a pressure of 1 Pa times cos(n theta), over so many strips.
    fn of_harmonic(shaft: &Shaft, order: f64, strips: u32) -> f64 {
        let width = TAU / f64::from(strips);
        let strip = |index: u32| {
            let angle = width * (f64::from(index) - 0.5 * f64::from(strips));
            let [far, near] =
                [0.5, -0.5].map(|side| shaft.strip((angle + side * width) * shaft.radius));
            (order * angle).cos() * (far - near)
        };
        (0..strips).map(strip).sum()
    }

    /// Under an even pressure a shaft shrinks as Lame says, under a force it is pressed as a liquid is, and what decays inwards in it is
    /// what decays outwards around a hole at the order -n, of the other sign.
    #[test]
    fn strips_add_up_to_harmonics() {
        for poisson in [0.0, 0.3, 0.47] {
            let material = Material { young: 210e9, poisson };
            let shaft = Shaft { radius: 14e-3, material };
            let unit = shaft.radius / shaft.material.shear_modulus();
            let even = 0.5 * (1.0 - 2.0 * poisson);
            // Strips have no middle value of the pressure: of second order.
            let found = |order: f64| {
                let [coarse, fine] =
                    [2000, 4000].map(|strips| of_harmonic(&shaft, order, strips) / unit);
                (4.0 * fine - coarse) / 3.0
            };
            assert_abs_diff_eq!(found(0.0), even, epsilon = 1e-9);
            assert_abs_diff_eq!(found(1.0), 0.5 * even, epsilon = 1e-7);
            let hole = Stack {
                layers: &[],
                base: Some(&material),
                hollow: Some((Round::Cylinder, shaft.radius)),
            };
            let kappa = 3.0 - 4.0 * poisson;
            for order in [2.0, 3.0, 7.0] {
                let known = |n: f64| ((kappa + 1.0) * n - (kappa - 1.0)) / (4.0 * (n * n - 1.0));
                assert_abs_diff_eq!(found(order), known(order), epsilon = 1e-6);
                let k = order / shaft.radius;
                let around = hole.compliance(k)[2] / k / unit;
                assert_relative_eq!(around, -known(-order), max_relative = 1e-8);
            }
        }
    }
}
