//! The value of a field at the centre of the pairs, scattered or on a grid.

use super::Grid;
use crate::numerics::dense::Cholesky;
use crate::numerics::{SAME, WRITTEN};

/// Pairs, mirror images included, that a parabola is fitted to at least, twice as many as it has coefficients; more where others
/// are as near.
const FITTED: usize = 12;
/// Reach of the weights of the fit relative to the farthest pair.
const REACH: f64 = 1.4;

/// Weights of the pairs that say what a field is at x = y = 0.
#[derive(Debug, Clone, Default)]
pub(super) struct Centre {
    nearest: Vec<(usize, f64)>,
    /// Least-squares fit, exact for quadratics; none where the pairs do not determine one.
    smooth: Vec<(usize, f64)>,
}

impl Centre {
    pub fn of(places: &[[f64; 3]], mirrored: [bool; 2]) -> Self {
        let mut images = images(places, mirrored);
        images.sort_by(|a, b| a.distance.total_cmp(&b.distance));
        let as_near = |count: usize| {
            let last = images.get(count.min(images.len()).wrapping_sub(1));
            let reach = last.map_or(0.0, |image| image.distance * (1.0 + WRITTEN));
            images.iter().take_while(|image| image.distance <= reach).count()
        };
        let nearest = &images[..as_near(1)];
        let share = 1.0 / nearest.len().max(1) as f64;
        // A pair at the centre needs no fit.
        let fitted = &images[..as_near(FITTED)];
        let own = nearest.first().zip(fitted.last());
        let own = own.is_some_and(|(near, far)| near.distance <= WRITTEN * far.distance);
        Self {
            nearest: gathered(nearest.iter().map(|image| (image.pair, share))),
            smooth: match fit(fitted) {
                Some(weights) if !own => gathered(weights.into_iter()),
                _ => vec![],
            },
        }
    }

    /// The value of a field; the mean of the nearest pairs where the field vanishes at one of those around, as
    /// pressures do outside a contact.
    pub fn value(&self, field: &[f64]) -> f64 {
        let weigh = |weights: &[(usize, f64)]| -> f64 {
            weights.iter().map(|(pair, weight)| weight * field[*pair]).sum()
        };
        let whole = self.smooth.iter().all(|(pair, _)| field[*pair] != 0.0);
        weigh(if whole && !self.smooth.is_empty() { &self.smooth } else { &self.nearest })
    }
}

/// A pair or one of its mirror images.
struct Image {
    pair: usize,
    place: [f64; 2],
    distance: f64,
}

fn images(places: &[[f64; 3]], mirrored: [bool; 2]) -> Vec<Image> {
    let sides = mirrored.map(|mirrored| if mirrored { &[1.0, -1.0][..] } else { &[1.0] });
    let mut images = Vec::with_capacity(places.len() * sides[0].len() * sides[1].len());
    for (pair, place) in places.iter().enumerate() {
        for side_x in sides[0] {
            for side_y in sides[1] {
                let place = [side_x * place[0], side_y * place[1]];
                images.push(Image { pair, place, distance: place[0].hypot(place[1]) });
            }
        }
    }
    images
}

/// Weights of the value at the origin of the parabola that fits best; `None` where none is determined.
fn fit(images: &[Image]) -> Option<Vec<(usize, f64)>> {
    let reach = REACH * images.last()?.distance;
    if reach == 0.0 {
        return None;
    }
    let terms = |image: &Image| {
        let [x, y] = image.place.map(|place| place / reach);
        [1.0, x, y, x * x, x * y, y * y]
    };
    let weight = |image: &Image| (1.0 - (image.distance / reach).powi(2)).powi(2);
    let element = |row: usize, column: usize| -> f64 {
        images.iter().map(|one| weight(one) * terms(one)[row] * terms(one)[column]).sum()
    };
    let unit = [1.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    let factors = Cholesky::new(6, element)?.solve(&unit);
    let value = |image: &Image| {
        let terms = terms(image);
        weight(image) * factors.iter().zip(terms).map(|(factor, term)| factor * term).sum::<f64>()
    };
    let weights: Vec<(usize, f64)> = images.iter().map(|one| (one.pair, value(one))).collect();
    // Pairs on a line or on two, say, determine no parabola; rounding may still find one.
    let size: f64 = weights.iter().map(|(_, weight)| weight.abs()).sum();
    let exact = (0..unit.len()).all(|term| {
        let found: f64 =
            images.iter().zip(&weights).map(|(one, (_, weight))| weight * terms(one)[term]).sum();
        (found - unit[term]).abs() < SAME
    });
    (exact && size < 10.0).then_some(weights)
}

/// One weight a pair.
fn gathered(weights: impl Iterator<Item = (usize, f64)>) -> Vec<(usize, f64)> {
    let mut gathered: Vec<(usize, f64)> = Vec::new();
    for (pair, weight) in weights {
        match gathered.iter_mut().find(|(known, _)| *known == pair) {
            Some((_, sum)) => *sum += weight,
            None => gathered.push((pair, weight)),
        }
    }
    gathered
}

impl Grid {
    /// The value of a field at the centre of the grid.
    pub(super) fn at_centre(&self, field: &[f64]) -> f64 {
        match self.weigh(field, centre_smooth) {
            (value, true) => value,
            (_, false) => self.weigh(field, centre_nearest).0,
        }
    }

    /// Weighs the values around the centre, and whether none of them is zero, as they are next to the grid.
    fn weigh(&self, field: &[f64], weights: Weights) -> (f64, bool) {
        let [along_x, along_y] = [0, 1].map(|axis| weights(self.elements[axis], self.middle[axis]));
        let (mut sum, mut whole) = (0.0, true);
        for (iy, weight_y) in &along_y {
            for (ix, weight_x) in &along_x {
                let held = *ix < self.elements[0] && *iy < self.elements[1];
                let value = if held { field[ix + self.elements[0] * iy] } else { 0.0 };
                sum += weight_x * weight_y * value;
                whole &= value != 0.0;
            }
        }
        (sum, whole)
    }
}

/// Weights of places among `n`, by the middle, which lies so many half elements from the first side.
type Weights = fn(usize, isize) -> Vec<(usize, f64)>;

/// Weights of the one or two places at the middle.
fn centre_nearest(_: usize, middle: isize) -> Vec<(usize, f64)> {
    // Places before the first are none either.
    let place = |index: isize| usize::try_from(index).unwrap_or(usize::MAX);
    let half = middle.div_euclid(2);
    if middle % 2 == 0 {
        vec![(place(half - 1), 0.5), (place(half), 0.5)]
    } else {
        vec![(place(half), 1.0)]
    }
}

/// Weights that are exact for cubics, where there are places enough.
fn centre_smooth(n: usize, middle: isize) -> Vec<(usize, f64)> {
    let first = middle.div_euclid(2) - 2;
    match usize::try_from(first) {
        Ok(first) if middle % 2 == 0 && first + 4 <= n => {
            let weights = [-1.0, 9.0, 9.0, -1.0].into_iter().enumerate();
            weights.map(|(i, weight)| (first + i, weight / 16.0)).collect()
        }
        _ => centre_nearest(n, middle),
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::Centre;

    fn quadratic([x, y, _]: [f64; 3]) -> f64 {
        3.0 + x - 2.0 * y + 4.0 * x * y + x * x - 5.0 * y * y
    }

    /// Places that follow no rule.
    fn scattered(count: usize) -> Vec<[f64; 3]> {
        let wave = |i: usize, factor: f64| (factor * (i as f64 + 0.3)).sin();
        (0..count).map(|i| [wave(i, 1.7), wave(i, 2.9), 0.0]).collect()
    }

    #[test]
    fn a_quadratic_is_fitted_exactly() {
        let places = scattered(60);
        let field: Vec<f64> = places.iter().map(|&place| quadratic(place)).collect();
        assert_relative_eq!(Centre::of(&places, [false; 2]).value(&field), 3.0, epsilon = 1e-12);
    }

    #[test]
    fn mirror_images_take_part() {
        let places: Vec<_> =
            scattered(40).iter().map(|[x, y, _]| [x.abs(), y.abs(), 0.0]).collect();
        let even = |[x, y, _]: [f64; 3]| 3.0 + x * x - 5.0 * y * y;
        let field: Vec<f64> = places.iter().map(|&place| even(place)).collect();
        assert_relative_eq!(Centre::of(&places, [true; 2]).value(&field), 3.0, epsilon = 1e-12);
    }

    #[test]
    fn where_nothing_is_determined_the_nearest_count() {
        let line: Vec<_> = (0..20).map(|i| [f64::from(i) - 9.5, 0.0, 0.0]).collect();
        let field: Vec<f64> = line.iter().map(|[x, ..]| 2.0 + x).collect();
        assert_relative_eq!(Centre::of(&line, [false; 2]).value(&field), 2.0, epsilon = 1e-14);
        // The nearest lie on two lines, which say nothing of curvature across them.
        let slender: Vec<_> = (0..96)
            .map(|i| [f64::from(i % 16) - 7.5, 2.7 * f64::from(i / 16) + 1.35, 0.0])
            .collect();
        let field: Vec<f64> = slender.iter().map(|[x, y, _]| 300.0 - x * x - y * y).collect();
        let value = Centre::of(&slender, [false, true]).value(&field);
        assert_relative_eq!(value, 300.0 - 0.25 - 1.35 * 1.35, epsilon = 1e-9);
        let mut places = scattered(60);
        places[7] = [0.0; 3];
        let field: Vec<f64> = (0..60).map(|i| f64::from(i == 7)).collect();
        assert_relative_eq!(Centre::of(&places, [false; 2]).value(&field), 1.0, epsilon = 1e-14);
    }
}
