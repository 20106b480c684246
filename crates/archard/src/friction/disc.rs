//! The disc of admissible tractions: the projection on it and what its derivative is made of.

/// A point beyond a disc around zero, which is projected on it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Beyond {
    /// Unit vector from the centre to the point.
    pub normal: [f64; 2],
    /// Distance of the point from the centre.
    pub length: f64,
    /// Radius over that distance. A small change of the point moves its projection by this share of the part across the
    /// normal.
    pub share: f64,
}

impl Beyond {
    /// A point and the radius of the disc; `None` where the point belongs to the disc.
    #[inline]
    pub fn of([x, y]: [f64; 2], radius: f64) -> Option<Self> {
        let length = x.hypot(y);
        if length <= radius {
            return None;
        }
        Some(Self { normal: [x / length, y / length], length, share: radius / length })
    }
}

/// The point of a disc around zero that is next to a point. With the limit for radius it is the projection of the augmented
/// Lagrangian on the admissible tractions (the paper's eq. 11, with the sign of its eq. 10).
#[inline]
pub fn onto_disc(point: [f64; 2], radius: f64) -> [f64; 2] {
    Beyond::of(point, radius).map_or(point, |beyond| point.map(|value| value * beyond.share))
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::{Beyond, onto_disc};

    /// The derivative of the projection is the share of the part across the normal: central differences, whose error is
    /// of second order in the change of 1e-5.
    #[test]
    fn the_derivative_is_the_share_across_the_normal() {
        let (point, change, h) = ([3.0, -1.0], [0.4, 0.7], 1e-5);
        let beyond = Beyond::of(point, 2.0).expect("a point beyond the disc");
        let moved = |length: f64| onto_disc([0, 1].map(|i| point[i] + length * change[i]), 2.0);
        let (forth, back, across) = (moved(h), moved(-h), [-beyond.normal[1], beyond.normal[0]]);
        let part = beyond.share * (across[0] * change[0] + across[1] * change[1]);
        for axis in 0..2 {
            let difference = (forth[axis] - back[axis]) / (2.0 * h);
            assert_relative_eq!(difference, part * across[axis], max_relative = 1e-8);
        }
    }

    #[test]
    fn points_of_the_disc_stay() {
        assert_eq!(Beyond::of([3.0, 4.0], 5.0), None);
        assert_eq!(onto_disc([3.0, 4.0], 5.0), [3.0, 4.0]);
        assert_eq!(onto_disc([0.0; 2], 0.0), [0.0; 2]);
        assert_eq!(onto_disc([6.0, 8.0], 5.0), [3.0, 4.0]);
    }
}
