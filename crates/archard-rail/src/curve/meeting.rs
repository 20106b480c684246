//! Where a piece of a curve has a given coordinate.

use super::{Cubic, Curve};

/// Difference (m) of places that counts for nothing: some seventy times the rounding of a place of 0.1 m, and far below any profile's error.
const SAME: f64 = 1e-15;
/// Steps that are enough: each halves the interval at least, of 1 m to 1e-18 m, and Newton's double the digits.
const MOST: usize = 60;

impl Curve {
    /// Where (m along the polygon) the coordinate of points along a direction (y and z) has a value (m), between two places of one
    /// piece at which it lies on both sides of it.
    pub(crate) fn meets(&self, [from, to]: [f64; 2], direction: [f64; 2], value: f64) -> f64 {
        let (cubic, middle) = self.piece(0.5 * (from + to));
        let start = 0.5 * (from + to) - middle;
        let off = Coordinate::new(cubic, direction, value);
        start + off.zero([from - start, to - start])
    }
}

/// A coordinate over a cubic, less a value.
struct Coordinate([f64; 4]);

impl Coordinate {
    fn new(cubic: &Cubic, [y, z]: [f64; 2], value: f64) -> Self {
        let mut along = cubic.map(|[own, other]| y * own + z * other);
        along[0] -= value;
        Self(along)
    }

    /// Value and slope.
    fn at(&self, d: f64) -> [f64; 2] {
        let [a, b, c, e] = self.0;
        [a + d * (b + d * (c + d * e)), b + d * (2.0 * c + d * 3.0 * e)]
    }

    /// Newton's method within the interval, which is halved where a step leaves it.
    fn zero(&self, [from, to]: [f64; 2]) -> f64 {
        let rises = self.at(to)[0] > self.at(from)[0];
        let (mut low, mut high) = (from, to);
        let mut place = 0.5 * (low + high);
        for _ in 0..MOST {
            let [value, slope] = self.at(place);
            if value == 0.0 {
                return place;
            }
            if (value > 0.0) == rises {
                high = place;
            } else {
                low = place;
            }
            let newton = place - value / slope;
            let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
            if (next - place).abs() <= SAME {
                return next;
            }
            place = next;
        }
        place
    }
}
