//! How the pairs count in sums: forces, products of fields.

use crate::numerics::vector::{Values, sum_with};

/// What the pairs of a frame stand for.
///
/// A force is the mean area times the sum of the weighted tractions. A compliance is symmetric in the product
/// of fields that has these weights: what pressures do to one another depends on the areas they act on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measure<'a> {
    /// Mean area (m^2) of a pair and its mirror images.
    pub area: f64,
    /// The area of each pair relative to the mean.
    pub weight: Values<'a>,
    /// How much of the approach closes the gap of each pair.
    pub closing: Values<'a>,
    /// Size (m) of a pair alone: the side of a square of its mean area.
    pub side: f64,
    /// Whether the surfaces end where the pairs do, or repeat themselves, so that all of them may touch.
    pub closed: bool,
}

impl Measure<'_> {
    /// That of a plane of equal elements of that area (m^2).
    pub fn even(area: f64) -> Self {
        let one = Values::All(1.0);
        Self { area, weight: one, closing: one, side: area.sqrt(), closed: false }
    }

    /// Force (N) along the approach that pressures (Pa) bear.
    pub fn load(&self, pressure: &[f64]) -> f64 {
        let [sum] =
            sum_with([self.weight, self.closing], [pressure], |[weight, closing], [pressure]| {
                [weight * closing * pressure]
            });
        sum * self.area
    }
}
