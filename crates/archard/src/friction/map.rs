//! The linear map between an ellipse of admissible tractions and a disc.
//!
//! With a symmetric matrix A, the tractions of a pair are t = A t^ and its mapped slip is s^ = A s. The work is the same
//! in both, t . s = t^ . s^, and the slip of maximum dissipation at an admissible ellipse, the image of a disc, is along
//! the mapped traction: Coulomb's law for t^ and s^. Whatever ellipse has a symmetric A: a rotation of t^ changes nothing.

use crate::numerics::SAME;
use crate::numerics::vector::sweep;

/// How far below its limit a traction is where pairs stick, relative to it.
const STICKS: f64 = 1e-6;

/// A symmetric positive definite matrix A on vectors in the tangent plane of a pair, along its t1 and t2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Map {
    xx: f64,
    xy: f64,
    yy: f64,
}

impl Map {
    /// No change: the admissible set is a disc already.
    pub const IDENTITY: Self = Self { xx: 1.0, xy: 0.0, yy: 1.0 };

    /// The map that stretches a disc of radius one to an ellipse of these semi-axes, greater than zero, the first of
    /// which lies at an angle (rad) from t1 towards t2.
    pub fn ellipse([first, second]: [f64; 2], angle: f64) -> Self {
        let (mean, half) = (0.5 * (first + second), 0.5 * (first - second));
        let (sin, cos) = (2.0 * angle).sin_cos();
        Self { xx: mean + half * cos, xy: half * sin, yy: mean - half * cos }
    }

    /// Whether it changes nothing.
    pub fn is_identity(self) -> bool {
        self == Self::IDENTITY
    }

    /// Whether its axes are t1 and t2.
    pub fn is_aligned(self) -> bool {
        self.xy.abs() <= SAME * 0.5 * (self.xx + self.yy)
    }

    /// A v: the traction of the pair that belongs to a mapped one, the mapped slip that belongs to one of the pair.
    pub fn apply(self, [x, y]: [f64; 2]) -> [f64; 2] {
        [self.xx * x + self.xy * y, self.xy * x + self.yy * y]
    }

    /// The map the other way.
    #[must_use]
    pub fn inverse(self) -> Self {
        let determinant = self.xx * self.yy - self.xy * self.xy;
        Self { xx: self.yy / determinant, xy: -self.xy / determinant, yy: self.xx / determinant }
    }

    /// Replaces vectors, given by their components along t1 and t2 of all pairs, by their images.
    pub fn apply_to(self, fields: [&mut [f64]; 2]) {
        let [] = sweep(fields, [], |vector, []| (self.apply(vector), []));
    }

    /// The images of such vectors.
    pub fn images(self, fields: [&[f64]; 2]) -> [Vec<f64>; 2] {
        let [mut one, mut two] = fields.map(<[f64]>::to_vec);
        self.apply_to([&mut one, &mut two]);
        [one, two]
    }

    /// Length of the mapped traction that belongs to one of the pair (Pa): where the pair slips, the limit of friction.
    pub fn length(self, traction: [f64; 2]) -> f64 {
        let [x, y] = self.inverse().apply(traction);
        x.hypot(y)
    }

    /// Whether a pair with a limit of friction (Pa) bears a traction (Pa) without slipping: it is less than the limit.
    pub fn sticks(self, traction: [f64; 2], limit: f64) -> bool {
        limit > 0.0 && self.length(traction) < (1.0 - STICKS) * limit
    }

    /// Friction against slip in a direction, relative to the limit; so also the largest admissible force along that
    /// direction. One where the direction is zero.
    pub fn resistance(self, direction: [f64; 2]) -> f64 {
        let [x, y] = self.apply(direction);
        let length = direction[0].hypot(direction[1]);
        if length > 0.0 { x.hypot(y) / length } else { 1.0 }
    }

    /// Traction against slip in a direction (that of body 2 over body 1, which friction on body 1 follows), relative to the
    /// limit; zero where the direction is.
    pub fn against(self, direction: [f64; 2]) -> [f64; 2] {
        let [x, y] = self.apply(direction);
        let length = x.hypot(y);
        if length > 0.0 { self.apply([x / length, y / length]) } else { [0.0; 2] }
    }

    /// The largest resistance in any direction.
    pub fn largest(self) -> f64 {
        0.5 * (self.xx + self.yy) + (0.5 * (self.xx - self.yy)).hypot(self.xy)
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_6;

    use approx::assert_relative_eq;

    use super::Map;

    /// A point of the ellipse at 30 degrees, in its own axes (a cos u, b sin u), has a mapped length of one.
    #[test]
    fn an_ellipse_becomes_a_disc() {
        let map = Map::ellipse([0.6, 0.3], FRAC_PI_6);
        for u in [0.0, 0.4, 1.3, 2.9, -1.0_f64] {
            let (first, second) = (0.6 * u.cos(), 0.3 * u.sin());
            let (sin, cos) = FRAC_PI_6.sin_cos();
            let traction = [first * cos - second * sin, first * sin + second * cos];
            assert_relative_eq!(map.length(traction), 1.0, max_relative = 1e-14);
        }
        assert_relative_eq!(map.largest(), 0.6, max_relative = 1e-14);
        assert_relative_eq!(
            map.resistance([3.0 * 0.75_f64.sqrt(), 1.5]),
            0.6,
            max_relative = 1e-14
        );
        assert_relative_eq!(map.resistance([-0.5, 0.75_f64.sqrt()]), 0.3, max_relative = 1e-14);
    }

    #[test]
    fn the_work_is_the_same_in_both() {
        let map = Map::ellipse([2.0, 0.1], 0.7);
        let (traction, slip) = ([3.0, -1.0], [0.2, 5.0]);
        let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
        let mapped = dot(map.inverse().apply(traction), map.apply(slip));
        assert_relative_eq!(mapped, dot(traction, slip), max_relative = 1e-13);
        let most = map.against(slip);
        assert_relative_eq!(map.length(most), 1.0, max_relative = 1e-13);
        let length = slip[0].hypot(slip[1]);
        assert_relative_eq!(dot(most, slip), map.resistance(slip) * length, max_relative = 1e-13);
    }

    #[test]
    fn equal_axes_at_any_angle_change_nothing() {
        assert!(Map::ellipse([1.0, 1.0], 0.3).is_identity());
        assert!(Map::ellipse([0.6, 0.3], std::f64::consts::FRAC_PI_2).is_aligned());
        assert!(!Map::ellipse([0.6, 0.3], 1e-6).is_aligned());
    }
}
