//! A map on coarser points, each with the mean of the heights around it.

use crate::filter::ROUNDING;
use crate::map::{HeightMap, NoMap};

/// Why a map cannot be put onto other points.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum NoMeans {
    /// Points as close as those were not measured.
    #[error(
        "points {spacing:e} m apart are closer than those of the map, {pixel:e} m: nothing is known between these"
    )]
    Fine {
        /// The distance (m) asked for.
        spacing: f64,
        /// That of the map (m).
        pixel: f64,
    },
    /// Too few points, or nothing is left.
    #[error(transparent)]
    Map(#[from] NoMap),
}

impl HeightMap {
    /// The map on points that distance (m) apart, as many as it has room for around its middle: the mean of the heights over the square around
    /// each, of what was measured there. That is the height a pressure works on that is constant over the square. A wave of length l along
    /// x or y keeps the share sin(a)/a, a = pi spacing/l.
    ///
    /// # Errors
    /// If the points are closer than those of the map, or fewer than two along an axis.
    pub fn averaged(&self, spacing: f64) -> Result<Self, NoMeans> {
        let pixel = self.pixel()[0].max(self.pixel()[1]);
        if spacing < pixel * (1.0 - ROUNDING) {
            return Err(NoMeans::Fine { spacing, pixel });
        }
        let count = self.size().map(|size| (size / spacing * (1.0 + ROUNDING)).floor() as usize);
        let [columns, rows] = [0, 1].map(|axis| self.shares(axis, spacing, count[axis]));
        let mut heights = Vec::with_capacity(count[0] * count[1]);
        for row in &rows {
            for column in &columns {
                let pixels = row.iter().flat_map(|(y, one)| {
                    column.iter().map(move |(x, other)| (self.at(*x, *y), one * other))
                });
                let measured = pixels.filter(|(height, _)| !height.is_nan());
                let (sum, weight) = measured.fold((0.0, 0.0), |(sum, all), (height, weight)| {
                    (sum + weight * height, all + weight)
                });
                heights.push(sum / weight);
            }
        }
        Ok(Self::new(count, [spacing; 2], heights)?)
    }

    /// The pixels along an axis that each of so many squares touches, with the length (m) they have in common.
    fn shares(&self, axis: usize, spacing: f64, count: usize) -> Vec<Vec<(usize, f64)>> {
        let pixel = self.pixel()[axis];
        let start = 0.5 * (self.size()[axis] - count as f64 * spacing);
        let last = self.elements()[axis] - 1;
        let square = |index: usize| {
            let [from, to] = [0, 1].map(|end| start + (index + end) as f64 * spacing);
            let [first, end] = [from, to].map(|edge| ((edge / pixel).max(0.0) as usize).min(last));
            let common = |at: usize| to.min((at + 1) as f64 * pixel) - from.max(at as f64 * pixel);
            (first..=end)
                .map(|at| (at, common(at)))
                .filter(|(_, length)| *length > ROUNDING * pixel)
                .collect()
        };
        (0..count).map(square).collect()
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{PI, TAU};

    use approx::assert_relative_eq;

    use super::NoMeans;
    use crate::map::{HeightMap, NoMap};
    use crate::texture::Texture;

    const PIXEL: [f64; 2] = [1e-6, 2e-6];

    fn map(height: impl Fn(usize, usize) -> f64) -> HeightMap {
        let heights = (0..400 * 200).map(|at| height(at % 400, at / 400)).collect();
        HeightMap::new([400, 200], PIXEL, heights).unwrap()
    }

    #[test]
    fn points_too_close_or_too_few_are_refused() {
        let map = map(|x, _| x as f64);
        assert!(matches!(map.averaged(1e-6), Err(NoMeans::Fine { .. })));
        assert!(matches!(map.averaged(300e-6), Err(NoMeans::Map(NoMap::Size([1, 1])))));
    }

    /// Means of a wave are those of its integral, up to the pixels' own; those of a plane lie on it, on points that divide no pixel.
    #[test]
    fn means_are_those_over_squares() {
        let wave = map(|x, _| (TAU * (x as f64 + 0.5) / 100.0).sin());
        let coarse = wave.averaged(20e-6).unwrap();
        assert_eq!((coarse.elements(), coarse.pixel()), ([20, 20], [20e-6; 2]));
        // 20 sums of sines in closed form, over 20.
        let share = (PI * 0.2).sin() / (PI * 0.01).sin() / 20.0;
        for x in 0..20 {
            let at = (TAU * (x as f64 + 0.5) * 0.2).sin();
            assert_relative_eq!(coarse.at(x, 3), share * at, epsilon = 1e-13);
        }
        let plane = map(|x, y| 2.0 * x as f64 * PIXEL[0] - y as f64 * PIXEL[1]);
        let middle = plane.place(0, 0) * -2.0 + plane.place(1, 0);
        let coarse = plane.averaged(7.3e-6).unwrap();
        assert_eq!(coarse.elements(), [54, 54]);
        for (x, y) in [(0, 0), (20, 41), (53, 7)] {
            // A square is a whole number of pixels but for the two at its ends, whose middles are not those of what it has of them.
            let exact = middle + 2.0 * coarse.place(0, x) - coarse.place(1, y);
            assert_relative_eq!(coarse.at(x, y), exact, epsilon = 0.3e-6);
        }
        // The mean of all is kept where the squares fill the map.
        let rough = map(|x, y| ((x * 31 + y * 17) % 101) as f64);
        let (fine, coarse) =
            (Texture::of(&rough).mean, Texture::of(&rough.averaged(3.2e-6).unwrap()).mean);
        assert_relative_eq!(fine, coarse, max_relative = 1e-12);
    }

    /// A square without a height is not measured; one with some has their mean.
    #[test]
    fn holes_count_for_nothing_in_means() {
        let map = map(|x, y| if x < 4 && y < 2 || x == 4 { f64::NAN } else { 5.0 });
        let coarse = map.averaged(4e-6).unwrap();
        assert_eq!(coarse.missing(), 1);
        assert!(coarse.at(0, 0).is_nan() && (coarse.at(1, 0) - 5.0).abs() < 1e-12);
    }
}
