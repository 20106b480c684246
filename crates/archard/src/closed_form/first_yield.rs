//! At what peak pressure bodies begin to yield that Hertz's pressure presses, without friction.
//!
//! K. L. Johnson, *Contact Mechanics* (1985), sections 3.4, 4.1 and 6.2. Under a circle of radius one the stresses on the axis are
//!
//! ```text
//! zz = -1/(1 + z^2)        rr = -(1 + nu) (1 - z atan(1/z)) + 1/(2 (1 + z^2)),
//! ```
//!
//! times the peak pressure, and under a line those of [McEwen](super::sliding_line). The largest equivalent stress of von Mises lies
//! on the axis, below the surface or, under a line of a Poisson's ratio up to 0.19, on it; under a circle of a ratio below -0.33 it
//! lies around the contact, where rr = -tt = (1 - 2 nu)/3.

use super::sliding_line;
use crate::numerics::SAME;
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
        let rim = (1.0 - 2.0 * poisson) / 3f64.sqrt();
        Self::of(rim, 0.0, |z| {
            let zz = -1.0 / (1.0 + z * z);
            let rr = -(1.0 + poisson) * (1.0 - z * (1.0 / z).atan()) - 0.5 * zz;
            von_mises(&[rr, rr, zz, 0.0, 0.0, 0.0])
        })
    }

    /// Under a line of contact.
    pub fn under_line(poisson: f64) -> Self {
        // Where the maximum below the surface is the larger, a minimum lies above it, at less than 0.16.
        Self::of(1.0 - 2.0 * poisson, 0.16, |z| {
            von_mises(&sliding_line::stress([0.0, z], 0.0, poisson))
        })
    }

    /// The larger of an equivalent stress (over the peak pressure) on the surface and that of the depth, which has one maximum between
    /// a least depth and one.
    fn of(surface: f64, least: f64, stress: impl Fn(f64) -> f64) -> Self {
        let golden = 0.5 * (5f64.sqrt() - 1.0);
        let [mut low, mut high] = [least, 1.0];
        // Nearer to a maximum values differ by rounding alone.
        while high - low > SAME {
            let [left, right] = [high - golden * (high - low), low + golden * (high - low)];
            if stress(left) < stress(right) { low = left } else { high = right }
        }
        let depth = 0.5 * (low + high);
        let inside = stress(depth);
        if surface > inside {
            return Self { pressure: 1.0 / surface, depth: 0.0 };
        }
        Self { pressure: 1.0 / inside, depth }
    }
}

#[cfg(test)]
mod tests {
    use super::FirstYield;

    /// From Hankel integrals and McEwen's stresses of the whole plane, by another program.
    #[test]
    fn pressures_and_depths_are_those_of_the_whole_field() {
        let circle = [
            // Around the contact: (1 - 2 nu)/3^.5.
            (-0.5, 0.5 * 3f64.sqrt(), 0.0),
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
