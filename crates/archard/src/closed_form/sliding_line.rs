//! Stresses below a line of contact under Hertz's pressure, with friction in proportion to it: plane strain.
//!
//! E. McEwen, *Phil. Mag.* 40 (1949) 454; J. O. Smith & C. K. Liu, *J. Appl. Mech.* 20 (1953) 157; K. L. Johnson, *Contact
//! Mechanics* (1985), sections 4.1 and 7.1. With the half-width and the peak pressure one, z into the body, and
//!
//! ```text
//! m^2, n^2 = 1/2 {[(1 - x^2 + z^2)^2 + 4 x^2 z^2]^(1/2) +- (1 - x^2 + z^2)},   m > 0, n of the sign of x,
//! ```
//!
//! pressure makes the stresses
//!
//! ```text
//! xx = 2 z - m [1 + (z^2 + n^2)/(m^2 + n^2)]   zz = -m [1 - (z^2 + n^2)/(m^2 + n^2)]   xz = -n (m^2 - z^2)/(m^2 + n^2)
//! ```
//!
//! and friction along x, over its coefficient, xx = n [2 - (z^2 - m^2)/(m^2 + n^2)] - 2 x, zz = xz and xz = xx of the pressure.

use crate::stress::Components;

/// The stress over the peak pressure at x and z, over the half-width of the contact. Friction acts on the body along x.
pub fn stress([x, z]: [f64; 2], friction: f64, poisson: f64) -> Components {
    let b = 1.0 - x * x + z * z;
    let r = b.hypot(2.0 * x * z);
    let [m2, n2] = [0.5 * (r + b), 0.5 * (r - b)].map(|square| square.max(0.0));
    let (m, n) = (m2.sqrt(), n2.sqrt().copysign(x));
    // Zero at the edge, where m and n are.
    let over = if r > 0.0 { r.recip() } else { 0.0 };
    let share = (z * z + n2) * over;
    let (xx, zz) = (2.0 * z - m * (1.0 + share), -m * (1.0 - share));
    let xz = -n * (m2 - z * z) * over;
    let sheared = n * (2.0 - (z * z - m2) * over) - 2.0 * x;
    let (xx, zz, xz) = (xx + friction * sheared, zz + friction * xz, xz + friction * xx);
    [xx, poisson * (xx + zz), zz, 0.0, xz, 0.0]
}

#[cfg(test)]
mod tests {
    use super::stress;

    /// The surface bears the tractions and no others, and what is below is in equilibrium.
    #[test]
    fn stresses_are_in_equilibrium_with_the_tractions() {
        let (mu, nu) = (0.4, 0.3);
        for x in [-3.0f64, -1.2, -0.7, 0.0, 0.3, 0.999, 2.0] {
            let [_, _, zz, _, xz, _] = stress([x, 0.0], mu, nu);
            let pressure = (1.0 - x * x).max(0.0).sqrt();
            assert!((zz + pressure).abs() < 1e-14 && (xz + mu * pressure).abs() < 1e-14, "{x}");
        }
        assert_eq!(stress([-1.0, 0.0], mu, nu)[0], 2.0 * mu);
        let d = 1e-4;
        for [x, z] in [[0.3, 0.5], [-1.4, 0.2], [0.9, 1.3]] {
            let along = |dx: f64, dz: f64| {
                let [high, low] =
                    [1.0, -1.0].map(|side| stress([x + side * dx, z + side * dz], mu, nu));
                std::array::from_fn::<f64, 6, _>(|i| (high[i] - low[i]) / (2.0 * d))
            };
            let (across, down) = (along(d, 0.0), along(0.0, d));
            let left = [across[0] + down[4], across[4] + down[2]];
            assert!(left.iter().all(|left| left.abs() < 1e-6), "{left:?}");
        }
    }
}
