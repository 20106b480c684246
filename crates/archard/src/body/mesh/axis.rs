//! Divisions along one direction: equal in the middle, growing geometrically on both sides.

use std::ops::Range;

/// How widths grow.
#[derive(Debug, Clone, Copy)]
pub(super) struct Growth {
    /// Largest ratio of neighbours, greater than 1.
    pub ratio: f64,
    /// Largest width (m).
    pub widest: f64,
}

impl Growth {
    /// Widths (m) that fill a length (m) next to an element of that width (m).
    pub fn beside(self, width: f64, length: f64) -> Vec<f64> {
        self.fill(length, |ratio| self.geometric(width, ratio, 1))
    }

    /// Widths (m) that fill a length (m), the first of them `first` (m) or narrower.
    pub fn from(self, first: f64, length: f64) -> Vec<f64> {
        self.fill(length, |ratio| self.geometric(first, ratio, 0))
    }

    /// The widths of a geometric series from that term on, none wider than allowed.
    fn geometric(self, start: f64, ratio: f64, skip: usize) -> impl Iterator<Item = f64> {
        let next = move |width: &f64| Some((width * ratio).min(self.widest));
        std::iter::successors(Some(start.min(self.widest)), next).skip(skip)
    }

    /// As few widths of a series as fill the length, with the ratio that makes them fill it exactly.
    fn fill<S: Iterator<Item = f64>>(self, length: f64, series: impl Fn(f64) -> S) -> Vec<f64> {
        // A sliver left over is not worth an element.
        let enough = length * (1.0 - 1e-9);
        let (mut count, mut reached) = (0, 0.0);
        for width in series(self.ratio) {
            if reached >= enough {
                break;
            }
            reached += width;
            count += 1;
        }
        let (mut low, mut high) = (1.0, self.ratio);
        for _ in 0..60 {
            let ratio = 0.5 * (low + high);
            let filled: f64 = series(ratio).take(count).sum();
            if filled < length { low = ratio } else { high = ratio }
        }
        let mut widths: Vec<f64> = series(low).take(count).collect();
        // Where the widest width rules or even equal ones are too wide, the ratio alone cannot do it.
        let stretch = length / widths.iter().sum::<f64>();
        widths.iter_mut().for_each(|width| *width *= stretch);
        widths
    }
}

/// Rising places from zero to a length (m), parted by these widths (m).
pub(super) fn places(widths: &[f64], length: f64) -> Vec<f64> {
    let mut places = vec![0.0];
    let mut place = 0.0;
    for width in widths {
        place += width;
        places.push(place);
    }
    if let Some(last) = places.last_mut() {
        *last = length;
    }
    places
}

/// A divided axis, symmetric about zero unless only its positive half is kept.
#[derive(Debug, Clone)]
pub(super) struct Axis {
    /// Rising places (m).
    pub places: Vec<f64>,
    /// The equal elements in the middle; element i lies between the places i and i + 1.
    pub zone: Range<usize>,
}

/// A field of a load on the middle part of an axis, seen from next to it: it varies over distances from the load.
#[derive(Debug, Clone, Copy)]
pub(super) struct Fading {
    /// Half the length of the middle part (m).
    pub middle: f64,
    /// How far away it is seen from (m).
    pub distance: f64,
    /// Width of an element over the distance from the load.
    pub share: f64,
    /// Largest width of an element (m).
    pub widest: f64,
}

impl Fading {
    /// Elements that follow the field along an axis of that length (m), symmetric about its middle; of its positive half if it is
    /// mirrored.
    pub fn count(self, length: f64, mirrored: bool) -> f64 {
        let end = self.stretched(0.5 * length);
        (if mirrored { end } else { 2.0 * end } - 1e-9).ceil().max(1.0)
    }

    /// Elements up to a place (m): the integral of one over their width.
    fn stretched(self, place: f64) -> f64 {
        let Self { middle, distance, share, widest } = self;
        let width = share * distance;
        if width >= widest {
            return place / widest;
        }
        let capped = distance * ((widest / width).powi(2) - 1.0).sqrt();
        let beyond = (place - middle).max(0.0);
        let graded = (beyond.min(capped) / distance).asinh() / share;
        place.min(middle) / width + graded + (beyond - capped).max(0.0) / widest
    }

    /// The place (m) up to which there are so many elements.
    fn place(self, elements: f64) -> f64 {
        let Self { middle, distance, share, widest } = self;
        let width = share * distance;
        if width >= widest {
            return elements * widest;
        }
        let inner = middle / width;
        if elements <= inner {
            return elements * width;
        }
        let capped = distance * ((widest / width).powi(2) - 1.0).sqrt();
        let graded = distance * (share * (elements - inner)).sinh();
        if graded <= capped {
            return middle + graded;
        }
        let rest = elements - inner - (capped / distance).asinh() / share;
        middle + capped + rest * widest
    }
}

/// The middle part of an axis.
#[derive(Debug, Clone, Copy)]
pub(super) struct Middle {
    /// Its length (m).
    pub length: f64,
    /// Its equal elements.
    pub elements: usize,
}

impl Axis {
    /// An axis of that length (m) with elements that grow away from its middle part. If it is mirrored,
    /// the number of elements there is even.
    pub fn graded(middle: Middle, length: f64, growth: Growth, mirrored: bool) -> Self {
        let Middle { length: zone, elements } = middle;
        let odd = elements % 2;
        let inner = |k: usize| zone * (k as f64 + 0.5 * odd as f64) / elements as f64;
        let mut half: Vec<f64> = (0..=elements / 2).map(inner).collect();
        let inside = half.len();
        let rest = 0.5 * (length - zone);
        if rest > 1e-9 * length {
            let widths = growth.beside(zone / elements as f64, rest);
            half.extend(places(&widths, rest)[1..].iter().map(|place| 0.5 * zone + place));
        }
        if let Some(last) = half.last_mut() {
            *last = 0.5 * length;
        }
        if mirrored {
            return Self { places: half, zone: 0..elements / 2 };
        }
        let outside = half.len() - inside;
        let mut places: Vec<f64> = half[1 - odd..].iter().rev().map(|place| -place).collect();
        places.extend(&half);
        Self { places, zone: outside..outside + elements }
    }

    /// An axis of that length (m) in equal elements. If it is mirrored, their number is even.
    pub fn even(length: f64, elements: usize, mirrored: bool) -> Self {
        let growth = Growth { ratio: 2.0, widest: length };
        Self::graded(Middle { length, elements }, length, growth, mirrored)
    }

    /// An axis of that length (m), symmetric about its middle, in elements that follow a field.
    pub fn fading(length: f64, field: Fading, mirrored: bool) -> Self {
        let end = field.stretched(0.5 * length);
        let count = field.count(length, mirrored) as usize;
        let place = |step: usize| {
            let share = step as f64 / count as f64;
            let at = if mirrored { share } else { 2.0 * share - 1.0 };
            if at.abs() == 1.0 {
                0.5 * at * length
            } else {
                at.signum() * field.place(at.abs() * end)
            }
        };
        Self { places: (0..=count).map(place).collect(), zone: 0..0 }
    }

    /// The same from zero on.
    pub fn fading_from_zero(length: f64, field: Fading) -> Self {
        let Self { mut places, zone } = Self::fading(2.0 * length, field, true);
        places[0] = 0.0;
        Self { places, zone }
    }

    /// The largest width of an element (m).
    pub fn widest(&self) -> f64 {
        self.places.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max)
    }

    /// Width of the last element (m).
    pub fn last_width(&self) -> f64 {
        let places = &self.places;
        places[places.len() - 1] - places[places.len() - 2]
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::{Axis, Growth, Middle};

    #[test]
    fn widths_fill_the_length_within_the_ratio() {
        let growth = Growth { ratio: 2.0, widest: f64::INFINITY };
        let widths = growth.beside(0.01, 0.4);
        assert_eq!(widths.len(), 5);
        assert_relative_eq!(widths.iter().sum::<f64>(), 0.4, max_relative = 1e-12);
        assert!(widths[0] <= 0.02 && widths.windows(2).all(|pair| pair[1] < 2.0001 * pair[0]));
        let widths = growth.from(0.1, 1.0);
        assert_relative_eq!(widths[0], 0.1, max_relative = 1e-12);
        assert_eq!(growth.from(0.1, 0.04), [0.04]);
        let capped = Growth { ratio: 2.0, widest: 0.1 }.beside(0.01, 1.0);
        assert!(capped.iter().all(|&width| width <= 0.1 + 1e-12) && capped.len() == 12);
    }

    #[test]
    fn odd_even_and_halved_axes_agree() {
        let growth = Growth { ratio: 2.0, widest: f64::INFINITY };
        let axis = |elements, mirrored| {
            Axis::graded(Middle { length: 0.2, elements }, 1.0, growth, mirrored)
        };
        for elements in [1, 2, 5, 6] {
            let Axis { places, zone } = axis(elements, false);
            assert_eq!(zone.len(), elements);
            assert_relative_eq!(places[zone.start], -0.1, max_relative = 1e-12);
            assert_relative_eq!(places[zone.end], 0.1, max_relative = 1e-12);
            assert!(places.windows(2).all(|pair| pair[1] > pair[0]));
            assert_eq!((places[0], places[places.len() - 1]), (-0.5, 0.5));
        }
        let (whole, half) = (axis(6, false), axis(6, true));
        assert_eq!(whole.places[whole.places.len() - half.places.len()..], half.places);
        assert_eq!((half.zone, half.places[0]), (0..3, 0.0));
    }
}
