//! Points that do not belong to the surface around them: spikes of optical instruments.
//!
//! A point is an outlier where it lies outside the range of the points around it, by more than chance. Walls and edges lie within the
//! range of their neighbours and stay. The points around are rings of one, two and three points, so that spikes of up to 3 x 3 points see past
//! themselves. A neighbour counts where its opposite was measured too, so that slopes make no difference; at rims and holes the line through
//! two points further inside counts in its place.
//!
//! Chance is W. Chauvenet's (*A Manual of Spherical and Practical Astronomy* (1863)): of as many Gaussian values half a point would lie
//! beyond it. Its scale is the median size of second differences over the same distance (F. R. Hampel, *J. Amer. Statist. Assoc.* 69 (1974) 383),
//! on the map and around the point, and the rounding of the heights at least.

use std::f64::consts::SQRT_2;

use statrs::function::erf::erfc_inv;

use crate::map::{HeightMap, NoMap};

/// Rings around a point. From any of 3 x 3 points the third ring lies beyond all others.
const RINGS: usize = 3;
/// How far second differences around a point are taken from, in points: a spike of 3 x 3 points is in less than a quarter of them.
const AROUND: usize = 2 * RINGS + 1;
/// Second differences or heights whose median or steps are taken, about. A choice of cost.
const SAMPLE: usize = 1_000_000;
/// A normal distribution has the standard deviation of this times the median size.
pub(crate) const BY_MEDIAN: f64 = 1.482_602_218_505_602;

/// The outliers of a map.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outliers {
    /// How many points.
    pub count: usize,
    /// How far (m) outside of the range of its neighbours a point may lie.
    pub threshold: f64,
}

impl HeightMap {
    /// The map with its outliers as points that were not measured.
    ///
    /// # Errors
    /// If none but outliers were measured.
    pub fn without_outliers(&self) -> Result<(Self, Outliers), NoMap> {
        let (map, threshold) = self.clear();
        let count = map.missing() - self.missing();
        let map = Self::new(self.elements(), self.pixel(), map.heights().to_vec())?;
        Ok((map, Outliers { count, threshold }))
    }

    /// The same, whatever is left, and the threshold (m).
    pub(crate) fn clear(&self) -> (Self, f64) {
        let rounding = rounding(self);
        let count = (self.heights().len() - self.missing()).max(1) as f64;
        let normal = SQRT_2 * erfc_inv(0.5 / count);
        let mut map = self.clone();
        let mut threshold = None;
        // What the largest hid is found next; each time the map loses a point at least.
        loop {
            let scales: Vec<f64> = (1..=RINGS).map(|ring| map.scale(ring).max(rounding)).collect();
            threshold = threshold.or(scales.first().map(|scale| normal * scale));
            let outlier = |at: &usize| {
                scales.iter().zip(1..).any(|(scale, ring)| {
                    let excess = map.excess(*at, ring);
                    excess > normal * scale && excess > normal * map.scale_around(*at, ring)
                })
            };
            let found: Vec<usize> = (0..map.heights().len()).filter(outlier).collect();
            if found.is_empty() {
                return (map, threshold.unwrap_or(0.0));
            }
            let mut heights = map.heights().to_vec();
            found.iter().for_each(|&at| heights[at] = f64::NAN);
            map = self.of_heights(heights);
        }
    }

    /// The height at a point so many steps away; not a number beyond the map.
    fn away(&self, at: usize, [dx, dy]: [isize; 2], times: isize) -> f64 {
        let [nx, ny] = self.elements();
        let x = (at % nx).checked_add_signed(times * dx).filter(|x| *x < nx);
        let y = (at / nx).checked_add_signed(times * dy).filter(|y| *y < ny);
        x.zip(y).map_or(f64::NAN, |(x, y)| self.at(x, y))
    }

    /// How far (m) a point lies outside of the range of a ring; negative within it, infinitely so without a ring.
    fn excess(&self, at: usize, ring: usize) -> f64 {
        let own = self.heights()[at];
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        if own.is_nan() {
            return f64::NEG_INFINITY;
        }
        let far = ring as isize;
        for dy in -far..=far {
            let step = if dy.abs() == far { 1 } else { 2 * far };
            let mut dx = -far;
            while dx <= far {
                let way = [dx, dy];
                let next = self.away(at, way, 1);
                let value = match self.away(at, way, -1).is_nan() {
                    true => 2.0 * next - self.away(at, way, 2),
                    false => next,
                };
                (low, high) = (low.min(value), high.max(value));
                dx += step;
            }
        }
        if low > high { f64::NEG_INFINITY } else { (own - high).max(low - own) }
    }

    /// Second differences (m) at a point over so many points along x and y.
    fn second(&self, at: usize, ring: usize) -> impl Iterator<Item = f64> {
        let ways = [[ring as isize, 0], [0, ring as isize]];
        ways.into_iter()
            .map(move |way| {
                self.away(at, way, 1) + self.away(at, way, -1) - 2.0 * self.heights()[at]
            })
            .filter(|one| !one.is_nan())
    }

    /// The standard deviation (m) of second differences, of the map.
    fn scale(&self, ring: usize) -> f64 {
        let every = (2 * self.heights().len() / SAMPLE + 1) | 1;
        let all = (0..self.heights().len()).step_by(every);
        let mut sizes: Vec<f64> = all.flat_map(|at| self.second(at, ring)).map(f64::abs).collect();
        BY_MEDIAN * median(&mut sizes).unwrap_or(0.0)
    }

    /// The same, around a point.
    fn scale_around(&self, at: usize, ring: usize) -> f64 {
        let nx = self.elements()[0];
        let [x, y] = [at % nx, at / nx];
        let ends = |place: usize, axis: usize| {
            place.saturating_sub(AROUND)..(place + AROUND + 1).min(self.elements()[axis])
        };
        let all = ends(y, 1).flat_map(|y| ends(x, 0).map(move |x| x + nx * y));
        let mut sizes: Vec<f64> = all.flat_map(|at| self.second(at, ring)).map(f64::abs).collect();
        BY_MEDIAN * median(&mut sizes).unwrap_or(0.0)
    }
}

/// The standard deviation (m) that heights have by their rounding: to the least step between them where many are the same, and to nine
/// digits of their range, which files and sums keep.
pub(crate) fn rounding(map: &HeightMap) -> f64 {
    let every = map.heights().len() / SAMPLE + 1;
    let mut sorted: Vec<f64> =
        map.heights().iter().step_by(every).copied().filter(|height| !height.is_nan()).collect();
    let all = sorted.len();
    sorted.sort_unstable_by(f64::total_cmp);
    let range = sorted.last().zip(sorted.first()).map_or(0.0, |(last, first)| last - first);
    // Closer ones are the same, to double precision.
    let same = 1e-12 * range;
    sorted.dedup_by(|next, first| *next - *first <= same);
    let steps = sorted.windows(2).map(|pair| pair[1] - pair[0]);
    let least = steps.fold(f64::INFINITY, f64::min);
    let step = if 2 * sorted.len() < all && least.is_finite() { least / 12f64.sqrt() } else { 0.0 };
    step.max(1e-9 * range).max(f64::MIN_POSITIVE)
}

/// The median of numbers, the mean of the middle two if they are even; `None` of none.
pub(crate) fn median(values: &mut [f64]) -> Option<f64> {
    let half = values.len() / 2;
    if values.is_empty() {
        return None;
    }
    let even = values.len().is_multiple_of(2);
    let (below, middle, _) = values.select_nth_unstable_by(half, f64::total_cmp);
    let lower = below.iter().copied().filter(|_| even).fold(f64::NEG_INFINITY, f64::max);
    Some(if even { 0.5 * (lower + *middle) } else { *middle })
}

#[cfg(test)]
mod tests {
    use fastrand::Rng;

    use super::{median, rounding};
    use crate::map::HeightMap;

    fn normal(random: &mut Rng) -> f64 {
        (-2.0 * (1.0 - random.f64()).ln()).sqrt() * (std::f64::consts::TAU * random.f64()).cos()
    }

    #[test]
    fn medians() {
        assert_eq!(median(&mut [3.0, 1.0, 2.0]), Some(2.0));
        assert_eq!(median(&mut [4.0, 1.0, 3.0, 2.0]), Some(2.5));
        assert_eq!(median(&mut []), None);
    }

    /// Gaussian noise on a steep plane loses no more than half a point a map, whatever the number of points.
    #[test]
    fn noise_has_half_an_outlier_a_map_at_most() {
        for points in [40, 120] {
            let mut found = 0;
            for seed in 0..20 {
                let mut random = Rng::with_seed(seed);
                let heights = (0..points * points).map(|at| {
                    1e-3 * (at % points + at / points) as f64 + 1e-7 * normal(&mut random)
                });
                let map = HeightMap::new([points; 2], [1e-6; 2], heights.collect()).unwrap();
                found += map.without_outliers().unwrap().1.count;
            }
            assert!(found <= 10, "{found} in 20 maps of {points}");
        }
    }

    /// Walls of a step, the bottom of a bowl and the corners of a slope are no spikes, noise or none.
    #[test]
    fn shapes_are_kept() {
        let shapes: [fn(f64, f64) -> f64; 4] = [
            |x, y| if (x - 20.0).abs().max((y - 24.0).abs()) < 9.0 { -5e-6 } else { 0.0 },
            |x, y| {
                -5e-6 * (1.0 - ((x - 22.0) / 12.0).powi(2) - ((y - 20.0) / 9.0).powi(2)).max(0.0)
            },
            |x, y| 1e-6 * (x + 2.0 * y),
            |x, y| -1e-8 * ((x - 20.0).powi(2) + (y - 20.0).powi(2)),
        ];
        for (kind, shape) in shapes.iter().enumerate() {
            for size in [0.0, 1e-8, 3e-7] {
                let mut random = Rng::with_seed(kind as u64);
                let height = |at: usize| {
                    shape((at % 44) as f64, (at / 44) as f64) + size * normal(&mut random)
                };
                let map =
                    HeightMap::new([44; 2], [1e-6; 2], (0..44 * 44).map(height).collect()).unwrap();
                let (_, outliers) = map.without_outliers().unwrap();
                assert!(outliers.count <= 1, "{kind} {size}: {outliers:?}");
            }
        }
    }

    /// Spikes of any size on rims, in corners and by holes are found, two next to each other too.
    #[test]
    fn spikes_on_rims_are_found() {
        let places = [[0, 0], [39, 39], [38, 39], [0, 17], [21, 0], [10, 11], [11, 11], [27, 25]];
        for size in [5e-6, -1e-4, 1.0] {
            let mut random = Rng::with_seed(3);
            let height = |at: usize| {
                let [x, y] = [at % 40, at / 40];
                let hole = (28..33).contains(&x) && (22..30).contains(&y);
                let spike = if places.contains(&[x, y]) { size } else { 0.0 };
                let texture = 2e-7 * (0.7 * x as f64 + 0.3 * y as f64).sin();
                if hole { f64::NAN } else { texture + spike + 1e-8 * normal(&mut random) }
            };
            let map = HeightMap::new([40; 2], [1e-6; 2], (0..1600).map(height).collect()).unwrap();
            let (kept, outliers) = map.without_outliers().unwrap();
            assert!(places.iter().all(|[x, y]| kept.at(*x, *y).is_nan()), "{size}");
            assert!(outliers.count <= places.len() + 2, "{size} {outliers:?}");
        }
    }

    /// Points by themselves, most of whose neighbours are missing, are kept.
    #[test]
    fn lonely_points_are_kept() {
        let mut random = Rng::with_seed(13);
        let height = |at: usize| {
            let [x, y] = [at % 80, at / 80].map(|index| index as f64);
            let own = (0.6 * x).sin() + (0.4 * y + 0.1 * x).cos() + 0.02 * normal(&mut random);
            if random.f64() < 0.8 { f64::NAN } else { own }
        };
        let map = HeightMap::new([80; 2], [1.0; 2], (0..6400).map(height).collect()).unwrap();
        let (_, outliers) = map.without_outliers().unwrap();
        assert!(outliers.count <= 2, "{outliers:?}");
    }

    /// Heights in steps are known to a step over the root of 12, and others to the digits of their range.
    #[test]
    fn rounding_is_that_of_the_steps() {
        let mut random = Rng::with_seed(5);
        let heights: Vec<f64> = (0..2500).map(|_| 1e-6 * normal(&mut random)).collect();
        let map = HeightMap::new([50; 2], [1e-6; 2], heights).unwrap();
        assert!(rounding(&map) < 1e-14);
        let stepped =
            map.of_heights(map.heights().iter().map(|z| (z / 5e-8).round() * 5e-8).collect());
        assert!((rounding(&stepped) / 5e-8 * 12f64.sqrt() - 1.0).abs() < 1e-6);
    }

    /// Spikes of 3 x 3 points in noise are taken whole, and next to nothing else; a hole stays one.
    #[test]
    fn spikes_are_taken_whole() {
        let mut random = Rng::with_seed(7);
        let spiked =
            |x: usize, y: usize| (9..12).contains(&(x % 20)) && (9..12).contains(&(y % 20));
        let height = |at: usize| {
            let (x, y) = (at % 100, at / 100);
            let spike = if spiked(x, y) { 5e-6 } else { 0.0 };
            if x == 55 && y < 50 { f64::NAN } else { spike + 1e-7 * normal(&mut random) }
        };
        let map =
            HeightMap::new([100; 2], [1e-6; 2], (0..100 * 100).map(height).collect()).unwrap();
        let (kept, outliers) = map.without_outliers().unwrap();
        let taken = |at: usize| kept.heights()[at].is_nan() && !map.heights()[at].is_nan();
        let spikes = (0..100 * 100).filter(|&at| spiked(at % 100, at / 100)).count();
        let (right, wrong): (Vec<usize>, Vec<usize>) =
            (0..100 * 100).filter(|&at| taken(at)).partition(|&at| spiked(at % 100, at / 100));
        assert!(
            right.len() == spikes && wrong.len() <= 3,
            "{} of {spikes}, {}",
            right.len(),
            wrong.len()
        );
        assert_eq!(outliers.count, right.len() + wrong.len());
        // Second differences of noise have the root of six of its standard deviation.
        let expected = 6f64.sqrt() * 1e-7 * 4.06;
        assert!((outliers.threshold / expected - 1.0).abs() < 0.1, "{outliers:?}");
    }

    /// Single spikes on a steep slope, which move the medians around them, leave their neighbours where they are.
    #[test]
    fn neighbours_of_spikes_on_a_slope_are_kept() {
        let mut random = Rng::with_seed(11);
        let spiked = |x: usize, y: usize| x % 12 == 6 && y % 12 == 6;
        let height = |at: usize| {
            let (x, y) = (at % 96, at / 96);
            let spike = if spiked(x, y) { 9e-6 } else { 0.0 };
            spike + 2e-6 * x as f64 + 0.7e-6 * y as f64 + 1e-7 * normal(&mut random)
        };
        let map = HeightMap::new([96; 2], [1e-6; 2], (0..96 * 96).map(height).collect()).unwrap();
        let (kept, outliers) = map.without_outliers().unwrap();
        let taken = |at: usize| kept.heights()[at].is_nan();
        assert!((0..96 * 96).all(|at| taken(at) || !spiked(at % 96, at / 96)));
        assert!((64..=66).contains(&outliers.count), "{outliers:?}");
    }
}
