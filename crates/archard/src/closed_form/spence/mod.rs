//! Stick and slip under a punch that is pressed on: pressing alone makes unlike bodies slip.
//!
//! D. A. Spence, *Proc. R. Soc. A* 305 (1968) 55 and *J. Elasticity* 5 (1975) 297; Johnson, *Contact
//! Mechanics*, section 5.4. The more compliant surface, drawn inwards under a rigid indenter, slips in
//! an annulus and sticks within the radius c, whose share of the contact stays the same while the load
//! grows: every profile r^n leads to the same share, from flat punch to cone and sphere. Only friction
//! and the coupling of normal and tangential displacements count,
//!
//! ```text
//! beta = [(1 - 2 nu1)/G1 - (1 - 2 nu2)/G2] / (2 [(1 - nu1)/G1 + (1 - nu2)/G2]).
//! ```
//!
//! Two answers are here: one in closed form, with the pressures left as they are without friction, and
//! the exact one of [`Indentation`]. From stick ratios of 0.05 to 0.95 under a rigid indenter, that
//! takes 4 to 9 % more friction on a body of Poisson ratio 0.3 and 14 to 41 % more at 0.

mod indentation;
mod stretches;

use ellip::elliprf;

use crate::body::Material;

pub use indentation::Indentation;

/// The coupling beta of two bodies, Dundurs' constant (Johnson, eq. 5.3), positive when the first is the more
/// compliant one.
///
/// A body that is `None` is rigid: next to one the other has (1 - 2 nu)/(2 (1 - nu)). Two rigid bodies
/// have none.
pub fn coupling(materials: [Option<&Material>; 2]) -> f64 {
    let part = |factor: f64| {
        materials.map(|body| {
            body.map_or(0.0, |body| (1.0 - factor * body.poisson) / body.shear_modulus())
        })
    };
    let ([first, second], normal) = (part(2.0), part(1.0));
    let sum: f64 = normal.iter().sum();
    if sum > 0.0 { 0.5 * (first - second) / sum } else { 0.0 }
}

/// Friction coefficient that leaves a stick zone of that share c/a of the contact radius, the
/// frictionless pressures kept:
///
/// ```text
/// ln[(1 + x)/(1 - x)] / (2 x) = (mu / beta) K(sqrt(1 - x^2)),  x = c/a.
/// ```
///
/// Between bodies of that coupling; 0 at a ratio of 0, infinite at 1.
pub fn uncoupled_friction(stick_ratio: f64, coupling: f64) -> f64 {
    if stick_ratio <= 0.0 || coupling == 0.0 {
        return 0.0;
    }
    coupling.abs() * stick_ratio.atanh() / (stick_ratio * elliptic(stick_ratio))
}

/// Share c/a of the contact radius that sticks at a friction coefficient, the frictionless pressures
/// kept: the inverse of [`uncoupled_friction`].
///
/// All sticks without coupling. Little friction leaves very little: some 4 exp(-beta/mu).
pub fn uncoupled_stick_ratio(friction: f64, coupling: f64) -> f64 {
    // Bisection in s = ln[x / (1 - x)], which keeps the digits of both x and, within limits, 1 - x.
    let ratio = |s: f64| 1.0 / (1.0 + (-s).exp());
    let (mut low, mut high) = (-700.0, 36.0);
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            return ratio(middle);
        }
        if uncoupled_friction(ratio(middle), coupling) < friction {
            low = middle;
        } else {
            high = middle;
        }
    }
}

/// K(sqrt(1 - x^2)), the complete elliptic integral of the first kind.
fn elliptic(complement: f64) -> f64 {
    if complement < 1e-9 {
        return (4.0 / complement).ln();
    }
    elliprf(0.0, complement * complement, 1.0).unwrap_or(f64::INFINITY)
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::{coupling, uncoupled_friction, uncoupled_stick_ratio};
    use crate::body::Material;

    /// Tabulated K of the modular angles 60, 45 and 30 degrees (Abramowitz and Stegun, table 17.1).
    #[test]
    fn frictions_at_tabulated_integrals() {
        let rows: [(f64, f64); 3] =
            [(0.5, 2.156515647), (0.5_f64.sqrt(), 1.854074677), (0.75_f64.sqrt(), 1.685750355)];
        for (ratio, integral) in rows {
            let expected = 0.3 * ((1.0 + ratio) / (1.0 - ratio)).ln() / (2.0 * ratio * integral);
            assert_relative_eq!(uncoupled_friction(ratio, 0.3), expected, max_relative = 1e-9);
            assert_relative_eq!(uncoupled_friction(ratio, -0.3), expected, max_relative = 1e-9);
        }
    }

    #[test]
    fn the_stick_ratio_inverts_the_friction() {
        for ratio in [1e-30, 1e-8, 2e-9, 0.3, 0.9, 1.0 - 1e-9] {
            let friction = uncoupled_friction(ratio, 0.3);
            let found = uncoupled_stick_ratio(friction, 0.3);
            assert_relative_eq!(found, ratio, max_relative = 1e-11);
            assert_relative_eq!(1.0 - found, 1.0 - ratio, max_relative = 1e-5);
        }
    }

    /// Limits: K(sqrt(1 - x^2)) is ln(4/x) for small x and pi/2 for x = 1.
    #[test]
    fn little_and_much_friction() {
        for friction in [0.001, 0.02_f64] {
            let expected = 4.0 * (-0.3 / friction).exp();
            let found = uncoupled_stick_ratio(friction, 0.3);
            assert_relative_eq!(found, expected, max_relative = 1e-5);
        }
        let slipping = 2.0 * (-std::f64::consts::PI * 1.5 / 0.3_f64).exp();
        let found = 1.0 - uncoupled_stick_ratio(1.5, 0.3);
        assert_relative_eq!(found, slipping, max_relative = 1e-5);
        assert_eq!((uncoupled_friction(0.0, 0.3), uncoupled_friction(0.4, 0.0)), (0.0, 0.0));
        assert!(uncoupled_stick_ratio(0.0, 0.3) < 1e-100);
        assert_relative_eq!(uncoupled_stick_ratio(0.1, 0.0), 1.0, epsilon = 1e-15);
    }

    #[test]
    fn couplings_of_bodies() {
        let steel = Material { young: 210e9, poisson: 0.3 };
        let cork = Material { young: 30e6, poisson: 0.0 };
        let rubber = Material { young: 5e6, poisson: 0.5 };
        assert_relative_eq!(coupling([Some(&steel), None]), 2.0 / 7.0, max_relative = 1e-14);
        assert_relative_eq!(coupling([Some(&cork), None]), 0.5, max_relative = 1e-14);
        assert_eq!(coupling([Some(&rubber), None]), 0.0);
        assert_eq!(coupling([Some(&steel); 2]), 0.0);
        assert_eq!(coupling([None, None]), 0.0);
        let (one, other) =
            (coupling([Some(&cork), Some(&steel)]), coupling([Some(&steel), Some(&cork)]));
        assert_eq!(one, -other);
        assert_relative_eq!(one, 0.5, max_relative = 1e-3);
    }
}
