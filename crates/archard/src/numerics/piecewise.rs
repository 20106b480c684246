//! Functions given by points, straight between them and held beyond the first and the last.

use crate::numerics::SAME;

/// Points at rising places.
#[derive(Debug, Clone, PartialEq)]
pub struct Piecewise {
    places: Vec<f64>,
    values: Vec<f64>,
}

/// Why points make no such function.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum NoFunction {
    /// There are not as many values as places, or none.
    #[error("needs as many values as places, and one at least")]
    Unpaired,
    /// A place or value that is no finite number.
    #[error("places and values must be finite numbers")]
    NotFinite,
    /// Places that do not rise.
    #[error("must rise from row to row, and {next:e} follows on {place:e}")]
    NotRising {
        /// A place.
        place: f64,
        /// The one given after it.
        next: f64,
    },
    /// A place or value below zero.
    #[error("must not be negative, and {value:e} is")]
    Negative {
        /// The place or value.
        value: f64,
    },
}

impl Piecewise {
    /// The function through values at rising places, none of them negative.
    ///
    /// # Errors
    /// If the lists differ in length or are empty, a number is not finite or negative, or places do not rise.
    pub fn new(places: &[f64], values: &[f64]) -> Result<Self, NoFunction> {
        if places.len() != values.len() || places.is_empty() {
            return Err(NoFunction::Unpaired);
        }
        let mut all = places.iter().chain(values);
        if !all.clone().all(|value| value.is_finite()) {
            return Err(NoFunction::NotFinite);
        }
        if let Some(&value) = all.find(|value| **value < 0.0) {
            return Err(NoFunction::Negative { value });
        }
        if let Some(pair) = places.windows(2).find(|pair| pair[1] <= pair[0]) {
            return Err(NoFunction::NotRising { place: pair[0], next: pair[1] });
        }
        Ok(Self { places: places.to_vec(), values: values.to_vec() })
    }

    /// The value at a place.
    pub fn at(&self, place: f64) -> f64 {
        match self.interval(place) {
            Ok(left) => self.values[left] + self.slope_of(left) * (place - self.places[left]),
            Err(end) => self.values[end],
        }
    }

    /// The derivative at a place, from the right; zero beyond the points.
    pub fn slope(&self, place: f64) -> f64 {
        self.interval(place).map_or(0.0, |left| self.slope_of(left))
    }

    /// The derivative at a place, from the left; zero beyond the points.
    pub fn slope_before(&self, place: f64) -> f64 {
        match self.places.partition_point(|&known| known < place) {
            next if next == 0 || next == self.places.len() => 0.0,
            next => self.slope_of(next - 1),
        }
    }

    /// The integral from a place over a length.
    pub fn integral(&self, from: f64, length: f64) -> f64 {
        // Measured from the place on: a small length far out keeps its digits.
        let within = self.places.iter().map(|place| place - from);
        let within = within.filter(|place| *place > 0.0 && *place < length);
        let ends: Vec<f64> = within.chain([length]).collect();
        let mut sum = 0.0;
        let mut before = (0.0, self.at(from));
        for end in ends {
            let value = self.at(from + end);
            sum += 0.5 * (before.1 + value) * (end - before.0);
            before = (end, value);
        }
        sum
    }

    /// A place at which the value times the place falls; `None` where that product rises, or stays, everywhere.
    pub fn falling_product(&self) -> Option<f64> {
        let falls = |&left: &usize| {
            let end = self.places[left + 1];
            self.values[left + 1] + self.slope_of(left) * end < -SAME * self.values[left]
        };
        (0..self.places.len() - 1).find(falls).map(|left| self.places[left + 1])
    }

    /// The point before a place that lies between points, or the end beyond which it lies.
    fn interval(&self, place: f64) -> Result<usize, usize> {
        let last = self.places.len() - 1;
        match self.places.partition_point(|&known| known <= place) {
            0 => Err(0),
            next if next > last => Err(last),
            next => Ok(next - 1),
        }
    }

    /// The slope between a point and the next.
    fn slope_of(&self, left: usize) -> f64 {
        let rise = self.values[left + 1] - self.values[left];
        rise / (self.places[left + 1] - self.places[left])
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::{NoFunction, Piecewise};

    fn tent() -> Piecewise {
        Piecewise::new(&[1.0, 2.0, 4.0], &[0.0, 2.0, 1.0]).unwrap()
    }

    #[test]
    fn values_are_straight_between_points_and_held_beyond() {
        let places = [0.0, 1.0, 1.5, 2.0, 3.0, 4.0, 9.0];
        assert_eq!(places.map(|place| tent().at(place)), [0.0, 0.0, 1.0, 2.0, 1.5, 1.0, 1.0]);
        assert_eq!(places.map(|place| tent().slope(place)), [0.0, 2.0, 2.0, -0.5, -0.5, 0.0, 0.0]);
        let before = places.map(|place| tent().slope_before(place));
        assert_eq!(before, [0.0, 0.0, 2.0, 2.0, -0.5, -0.5, 0.0]);
    }

    /// Areas of triangles and trapezoids: 1 up to 2, 3 up to 4, then 1 a unit.
    #[test]
    fn integrals_are_exact_and_add_up() {
        assert_relative_eq!(tent().integral(0.0, 2.0), 1.0);
        assert_relative_eq!(tent().integral(0.5, 4.5), 1.0 + 3.0 + 1.0);
        assert_relative_eq!(tent().integral(6.0, 3.0), 3.0);
        let parts = tent().integral(0.3, 1.1) + tent().integral(1.4, 2.2);
        assert_relative_eq!(parts, tent().integral(0.3, 3.3), max_relative = 1e-14);
        assert_relative_eq!(1e9 * tent().integral(1e6, 1e-9), 1.0, max_relative = 1e-14);
    }

    /// x (2 - (x - 2) / 2) = 3 x - x^2 / 2 falls beyond 3.
    #[test]
    fn products_may_fall() {
        assert_eq!(tent().falling_product(), Some(4.0));
        // x (2 - (x - 2) / 4) rises up to 5.
        let gentle = Piecewise::new(&[1.0, 2.0, 4.0], &[0.0, 2.0, 1.5]).unwrap();
        assert_eq!(gentle.falling_product(), None);
    }

    #[test]
    fn points_that_make_no_function_are_refused() {
        let new = |places: &[f64], values: &[f64]| Piecewise::new(places, values).unwrap_err();
        assert_eq!(new(&[0.0], &[]), NoFunction::Unpaired);
        assert_eq!(new(&[], &[]), NoFunction::Unpaired);
        assert_eq!(new(&[0.0, f64::NAN], &[1.0, 1.0]), NoFunction::NotFinite);
        assert_eq!(new(&[0.0, 0.0], &[1.0, 1.0]), NoFunction::NotRising { place: 0.0, next: 0.0 });
        assert_eq!(new(&[0.0, 1.0], &[1.0, -1.0]), NoFunction::Negative { value: -1.0 });
    }
}
