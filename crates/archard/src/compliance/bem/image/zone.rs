//! Polynomials on a rectangle of a body's face, and how many of them an image field takes.

use glam::DVec3;

use crate::frame::Rectangle;
use crate::numerics::quadrature::legendre_polynomials;

/// A rectangle on the face z = 0 with products of Legendre polynomials on it, orthonormal (1/m).
#[derive(Debug, Clone, PartialEq)]
pub struct Polynomials {
    pub(crate) rectangle: Rectangle,
    /// The degree of those along x and y together at most.
    pub(crate) degree: usize,
}

impl Polynomials {
    pub fn new(rectangle: Rectangle, degree: usize) -> Self {
        Self { rectangle, degree }
    }

    /// Degrees along x and y of each, rising.
    pub fn degrees(&self) -> Vec<[usize; 2]> {
        let of = |sum: usize| (0..=sum).map(move |x| [x, sum - x]);
        (0..=self.degree).flat_map(of).collect()
    }

    /// Those along one axis at a place (m), in 1/sqrt(m).
    pub fn along(&self, axis: usize, place: f64) -> Vec<f64> {
        let half = 0.5 * self.rectangle.size[axis];
        let values =
            legendre_polynomials(self.degree + 1, (place - self.rectangle.centre[axis]) / half);
        let scaled = |(n, value): (usize, f64)| value * ((n as f64 + 0.5) / half).sqrt();
        values.into_iter().enumerate().map(scaled).collect()
    }

    /// Their means between two places (m): the integral of P_n is (P_(n+1) - P_(n-1))/(2 n + 1).
    pub fn means(&self, axis: usize, [from, to]: [f64; 2]) -> Vec<f64> {
        let half = 0.5 * self.rectangle.size[axis];
        let at = |place: f64| {
            let values = (place - self.rectangle.centre[axis]) / half;
            legendre_polynomials(self.degree + 2, values)
        };
        let (low, high) = (at(from), at(to));
        let integral = |n: usize| {
            let before = if n == 0 { 0.0 } else { high[n - 1] - low[n - 1] };
            (high[n + 1] - low[n + 1] - before) / (2 * n + 1) as f64
        };
        (0..=self.degree)
            .map(|n| integral(n) * half / (to - from) * ((n as f64 + 0.5) / half).sqrt())
            .collect()
    }
}

/// By which factor polynomials on a rectangle at z = 0 come closer with each degree to a field with a singularity at a place: that of
/// the ellipse around the rectangle's side on which the place lies (S. N. Bernstein; L. N. Trefethen, *Approximation Theory and
/// Approximation Practice*, SIAM 2013, theorem 8.2), along the axis where it is less.
pub(super) fn ratio(rectangle: &Rectangle, place: DVec3) -> f64 {
    let at = [place.x, place.y];
    let along = |axis: usize| {
        let half = 0.5 * rectangle.size[axis];
        let own = (at[axis] - rectangle.centre[axis]) / half;
        let other = 1 - axis;
        let beside = (at[other] - rectangle.centre[other]).abs() - 0.5 * rectangle.size[other];
        let away = beside.max(0.0).hypot(place.z) / half;
        let sum = 0.5 * ((own - 1.0).hypot(away) + (own + 1.0).hypot(away));
        sum + (sum * sum - 1.0).max(0.0).sqrt()
    };
    along(0).min(along(1))
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;
    use glam::DVec3;

    use super::{Polynomials, ratio};
    use crate::frame::Rectangle;
    use crate::numerics::quadrature::gauss_legendre;

    #[test]
    fn polynomials_are_orthonormal_and_their_means_are_those_of_their_values() {
        let rectangle = Rectangle { centre: [0.3, -0.2], size: [0.4, 2.0] };
        let polynomials = Polynomials::new(rectangle, 4);
        for axis in 0..2 {
            let (low, half) = (rectangle.corner()[axis], 0.5 * rectangle.size[axis]);
            let points = gauss_legendre(8);
            for one in 0..5 {
                for other in 0..5 {
                    let product: f64 = points
                        .iter()
                        .map(|(x, weight)| {
                            let values = polynomials.along(axis, low + half * (1.0 + x));
                            half * weight * values[one] * values[other]
                        })
                        .sum();
                    assert_relative_eq!(
                        product,
                        f64::from(u8::from(one == other)),
                        epsilon = 1e-12
                    );
                }
                let [from, to] = [low + 0.1 * half, low + 0.3 * half];
                let mean: f64 = points
                    .iter()
                    .map(|(x, weight)| {
                        let place = 0.5 * (from + to + x * (to - from));
                        0.5 * weight * polynomials.along(axis, place)[one]
                    })
                    .sum();
                assert_relative_eq!(
                    polynomials.means(axis, [from, to])[one],
                    mean,
                    epsilon = 1e-12
                );
            }
        }
        assert_eq!(polynomials.degrees().len(), 15);
    }

    /// Beside the end of a side x + sqrt(x^2 - 1), away from its middle y + sqrt(y^2 + 1), which is less.
    #[test]
    fn ratios_are_those_of_ellipses() {
        let square = Rectangle::from([2.0, 2.0]);
        let long = Rectangle::from([2.0, 0.1]);
        assert_relative_eq!(ratio(&square, DVec3::new(3.0, 0.0, 0.0)), 2.0 + 5_f64.sqrt());
        assert_relative_eq!(ratio(&long, DVec3::new(3.0, 0.0, 0.0)), 3.0 + 8_f64.sqrt());
        assert_relative_eq!(ratio(&square, DVec3::new(0.0, 0.0, -2.0)), 2.0 + 5_f64.sqrt());
    }
}
