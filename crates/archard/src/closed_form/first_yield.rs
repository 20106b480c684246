//! At what peak pressure bodies begin to yield that Hertz's pressure presses, without friction.
//!
//! K. L. Johnson, *Contact Mechanics* (1985), sections 3.4, 4.1 and 6.2. Under a circle of radius one the stresses on the axis are
//!
//! ```text
//! zz = -1/(1 + z^2)        rr = -(1 + nu) (1 - z atan(1/z)) + 1/(2 (1 + z^2)),
//! ```
//!
//! under a line of half-width one, in plane strain,
//!
//! ```text
//! xx = 2 z - (1 + 2 z^2)/m    zz = -1/m    m = (1 + z^2)^(1/2)    yy = nu (xx + zz),
//! ```
//!
//! times the peak pressure, and the largest equivalent stress of von Mises lies on the axis: below the surface, under a line of a
//! Poisson's ratio up to 0.19 on it.

use crate::stress::von_mises;

/// Where bodies yield first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FirstYield {
    /// The peak pressure at which they do, over the yield stress in tension.
    pub pressure: f64,
    /// How deep that is, over the radius or half-width of the contact.
    pub depth: f64,
}

impl FirstYield {
    /// Under a circular contact.
    pub fn under_circle(poisson: f64) -> Self {
        Self::below(|z| {
            let zz = -1.0 / (1.0 + z * z);
            let rr = -(1.0 + poisson) * (1.0 - z * (1.0 / z).atan()) - 0.5 * zz;
            von_mises(&[rr, rr, zz, 0.0, 0.0, 0.0])
        })
    }

    /// Under a line of contact.
    pub fn under_line(poisson: f64) -> Self {
        Self::below(|z| {
            let m = (1.0 + z * z).sqrt();
            let (xx, zz) = (2.0 * z - (1.0 + 2.0 * z * z) / m, -1.0 / m);
            von_mises(&[xx, poisson * (xx + zz), zz, 0.0, 0.0, 0.0])
        })
    }

    /// The largest of an equivalent stress (over the peak pressure) of the depth.
    fn below(stress: impl Fn(f64) -> f64) -> Self {
        // Below the surface there is one maximum, at less than a radius: it is enclosed by parts of a golden section.
        let golden = 0.5 * (5f64.sqrt() - 1.0);
        let [mut low, mut high] = [0.2, 1.0];
        while high - low > 1e-9 {
            let [left, right] = [high - golden * (high - low), low + golden * (high - low)];
            if stress(left) < stress(right) { low = left } else { high = right }
        }
        let inside = 0.5 * (low + high);
        let surface = f64::MIN_POSITIVE;
        let depth = if stress(surface) > stress(inside) { 0.0 } else { inside };
        Self { pressure: 1.0 / stress(depth.max(surface)), depth }
    }
}

#[cfg(test)]
mod tests {
    use super::FirstYield;

    /// From Hankel integrals and McEwen's stresses of the whole plane, by another program.
    #[test]
    fn pressures_and_depths_are_those_of_the_whole_field() {
        let circle = [
            (0.0, 1.29931, 0.38194),
            (0.1, 1.39448, 0.41488),
            (0.25, 1.55435, 0.46431),
            (0.3, 1.61280, 0.48086),
            (0.5, 1.87724, 0.54787),
        ];
        let line = [
            (0.0, 1.0, 0.0),
            (0.1, 1.25, 0.0),
            (0.2, 1.64389, 0.58746),
            (0.3, 1.79367, 0.70429),
            (0.5, 1.92269, 0.78615),
        ];
        let close = |FirstYield { pressure, depth }, known: [f64; 2]| {
            assert!((pressure - known[0]).abs() < 1e-5, "{pressure} {known:?}");
            assert!((depth - known[1]).abs() < 2e-5, "{depth} {known:?}");
        };
        circle.into_iter().for_each(|(nu, p, z)| close(FirstYield::under_circle(nu), [p, z]));
        line.into_iter().for_each(|(nu, p, z)| close(FirstYield::under_line(nu), [p, z]));
    }
}
