//! Polynomials that fit best, to be taken off: tilt, bow and what is left of the motion of a stage.
//!
//! All terms x^i y^j with i + j up to the degree, as products of Legendre polynomials over the map, so that the equations stay well
//! conditioned. Every point that was measured counts the same.

use crate::fit::Normal;
use crate::map::{HeightMap, NoMap};

/// The degree of the polynomial that is taken off a map.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Level {
    /// First degree: tilt.
    Plane = 1,
    /// Second degree: tilt, bow and twist.
    Quadratic,
    /// Third degree.
    Cubic,
    /// Fourth degree.
    Quartic,
    /// Fifth degree.
    Quintic,
}

/// The polynomial that fits a map best.
#[derive(Debug, Clone, PartialEq)]
pub struct Polynomial {
    degree: usize,
    /// Half the distance (m) from the first point to the last along x and y.
    half: [f64; 2],
    /// Factors (m) of the terms, in their order.
    factors: Vec<f64>,
}

impl Level {
    /// All, from the lowest degree, by the names that cases have for them.
    pub const ALL: [(&'static str, Self); 5] = [
        ("plane", Self::Plane),
        ("quadratic", Self::Quadratic),
        ("cubic", Self::Cubic),
        ("quartic", Self::Quartic),
        ("quintic", Self::Quintic),
    ];
}

impl Polynomial {
    /// The polynomial that fits the points that were measured best by least squares.
    pub fn of(map: &HeightMap, level: Level) -> Self {
        let degree = level as usize;
        let half = [0, 1].map(|axis| map.place(axis, map.elements()[axis] - 1));
        let mut polynomial = Self { degree, half, factors: vec![] };
        let mut normal = Normal::new(orders(degree).count());
        for (place, height) in map.measured() {
            normal.add(&polynomial.terms(place), height);
        }
        polynomial.factors = normal.solved();
        polynomial
    }

    /// The height (m) at a place (m) from the middle of the map.
    pub fn height(&self, place: [f64; 2]) -> f64 {
        self.terms(place).iter().zip(&self.factors).map(|(term, factor)| term * factor).sum()
    }

    /// The mean slope along x and y, from edge to edge of the map.
    pub fn tilt(&self) -> [f64; 2] {
        // Legendre polynomials are 1 at the upper edge, and -1 at the lower if they are odd; over the width all but the first vanish.
        let along = |axis: usize| {
            let odd = |order: &[usize; 2]| order[axis] % 2 == 1 && order[1 - axis] == 0;
            let terms = orders(self.degree).zip(&self.factors).filter(|(order, _)| odd(order));
            terms.map(|(_, factor)| factor).sum::<f64>() / self.half[axis]
        };
        [along(0), along(1)]
    }

    fn terms(&self, place: [f64; 2]) -> Vec<f64> {
        let [x, y] = [0, 1].map(|axis| legendre(self.degree, place[axis] / self.half[axis]));
        orders(self.degree).map(|[i, j]| x[i] * y[j]).collect()
    }
}

/// The orders along x and y of all terms up to a degree.
fn orders(degree: usize) -> impl Iterator<Item = [usize; 2]> {
    (0..=degree).flat_map(|all| (0..=all).map(move |j| [all - j, j]))
}

/// Legendre polynomials up to a degree, by their recurrence.
fn legendre(degree: usize, x: f64) -> Vec<f64> {
    let mut values = vec![1.0, x];
    for n in 1..degree {
        let factor = n as f64;
        let next = (2.0 * factor + 1.0) * x * values[n] - factor * values[n - 1];
        values.push(next / (factor + 1.0));
    }
    values
}

impl HeightMap {
    /// The map less the polynomial that fits best to the points that were measured, by least squares.
    ///
    /// # Errors
    /// If no height is left.
    pub fn levelled(&self, level: Level) -> Result<Self, NoMap> {
        self.without_polynomial(&Polynomial::of(self, level))
    }

    /// The map less a polynomial.
    ///
    /// # Errors
    /// If no height is left.
    pub fn without_polynomial(&self, polynomial: &Polynomial) -> Result<Self, NoMap> {
        let rest = self.less(|place| polynomial.height(place));
        Self::new(self.elements(), self.pixel(), rest.heights().to_vec())
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::{Level, Polynomial};
    use crate::map::HeightMap;

    const PIXEL: [f64; 2] = [2e-6, 3e-6];

    /// Heights over the number of the point along x and y, with a hole in a corner.
    fn map(height: impl Fn(f64, f64) -> f64) -> HeightMap {
        let hole = |x: f64, y: f64| if x > 20.0 && y < 7.0 { f64::NAN } else { height(x, y) };
        let heights = (0..30 * 20).map(|at| hole((at % 30) as f64, (at / 30) as f64)).collect();
        HeightMap::new([30, 20], PIXEL, heights).unwrap()
    }

    /// A polynomial is taken off by its own degree and all higher ones, and by no lower one.
    #[test]
    fn a_polynomial_is_taken_off_by_its_degree() {
        let powers = |x: f64, y: f64, degree: i32| {
            (0..=degree).map(|i| (0.1 * x).powi(i) * (0.2 * y).powi(degree - i)).sum::<f64>()
        };
        for degree in 1..=5 {
            let map = map(|x, y| 1e-6 * (3.0 + powers(x, y, degree)));
            let most = |map: &HeightMap| {
                map.heights()
                    .iter()
                    .filter(|one| !one.is_nan())
                    .fold(0.0, |most: f64, one| most.max(one.abs()))
            };
            let largest_height = most(&map);
            let largest = |level: Level| {
                let rest = map.levelled(level).unwrap();
                assert_eq!(rest.missing(), map.missing());
                most(&rest)
            };
            for (_, level) in Level::ALL {
                let rest = largest(level);
                assert_eq!(
                    rest < 1e-12 * largest_height,
                    level as i32 >= degree,
                    "{level:?} of {degree}: {rest}"
                );
            }
        }
    }

    #[test]
    fn the_tilt_is_that_from_edge_to_edge() {
        let plane = map(|x, y| 1e-9 * (5.0 + 2.0 * x - 3.0 * y));
        let [x, y] = Polynomial::of(&plane, Level::Plane).tilt();
        assert_relative_eq!(x, 1e-3, max_relative = 1e-10);
        assert_relative_eq!(y, -1e-3, max_relative = 1e-10);
        let cubic = map(|x, y| 1e-9 * (x * x * x + 7.0 * x * y * y - y));
        let rest = |y: f64| 1e-9 * (29f64.powi(2) + 7.0 * y * y) / PIXEL[0];
        let tilt = Polynomial::of(&cubic, Level::Cubic).tilt()[0];
        // The mean of y^2 between edges is a third of 19^2.
        assert_relative_eq!(tilt, rest(19.0 / 3f64.sqrt()), max_relative = 1e-10);
    }

    /// Points on one line leave the tilt across open: they are levelled all the same.
    #[test]
    fn points_on_a_line_are_levelled() {
        let line = map(|x, y| if y == 9.0 { 1e-9 * (4.0 + x) } else { f64::NAN });
        let rest = line.levelled(Level::Plane).unwrap();
        assert!(rest.heights().iter().all(|one| one.is_nan() || one.abs() < 1e-20));
        assert_eq!(rest.missing(), line.missing());
    }
}
