//! Points that do not belong to the surface around them: spikes of optical instruments.
//!
//! F. R. Hampel's identifier (*J. Amer. Statist. Assoc.* 69 (1974) 383) on the difference of a point to the median of its neighbours, over
//! the median of the sizes of all these differences. The threshold is W. Chauvenet's (*A Manual of Spherical and Practical Astronomy* (1863)):
//! of as many Gaussian differences half a point would lie beyond it. Neighbours are those within two points along each axis
//! whose opposite was measured too, so that a slope makes no difference; spikes of up to 3 x 3 points are fewer than half of them. Points beyond the
//! threshold are compared once more, with neighbours that are not beyond it.

use statrs::function::erf::erfc_inv;

use crate::map::{HeightMap, NoMap};

/// How far neighbours reach, in points: the median of 24 is not moved by the other eight of 3 x 3.
const REACH: usize = 2;

/// The outliers of a map.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outliers {
    /// How many points.
    pub count: usize,
    /// The largest difference (m) to the median of the neighbours that is none.
    pub threshold: f64,
}

/// Why outliers cannot be told.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum NoTest {
    /// Differences have no scatter.
    #[error(
        "more than half of the points are as high as the median of their neighbours: outliers cannot be told from such heights"
    )]
    NoScatter,
    /// Nothing is left.
    #[error(transparent)]
    Map(#[from] NoMap),
}

impl HeightMap {
    /// The map with its outliers as points that were not measured.
    ///
    /// # Errors
    /// If more than half of the heights do not differ from their neighbours, or none is left.
    pub fn without_outliers(&self) -> Result<(Self, Outliers), NoTest> {
        let differences: Vec<f64> =
            (0..self.heights().len()).map(|at| self.difference(at, self)).collect();
        let mut sizes: Vec<f64> =
            differences.iter().filter(|one| !one.is_nan()).map(|one| one.abs()).collect();
        let count = sizes.len() as f64;
        let middle = median(&mut sizes).filter(|middle| *middle > 0.0).ok_or(NoTest::NoScatter)?;
        // P(|g| > t) is erfc(t/sqrt 2): one half at the median, 1/(2 N) at the threshold.
        let threshold = middle * erfc_inv(0.5 / count) / erfc_inv(0.5);
        let suspect = |at: usize| differences[at].abs() > threshold;
        let height = |at: usize| if suspect(at) { f64::NAN } else { self.heights()[at] };
        let others = self.of_heights((0..differences.len()).map(height).collect());
        // A spike on a slope moves the median of its neighbours: without suspects among theirs they may turn out to be none.
        let cleared = |at: usize| self.difference(at, &others).abs() <= threshold;
        let kept = (0..differences.len())
            .map(|at| if suspect(at) && !cleared(at) { f64::NAN } else { self.heights()[at] });
        let map = Self::new(self.elements(), self.pixel(), kept.collect())?;
        let count = map.missing() - self.missing();
        Ok((map, Outliers { count, threshold }))
    }

    /// The difference (m) of a point to the median of its neighbours in another map; not a number without neighbours.
    fn difference(&self, at: usize, others: &Self) -> f64 {
        let place = [at % self.elements()[0], at / self.elements()[0]];
        let reach = [0, 1].map(|axis| {
            let beyond = self.elements()[axis] - 1 - place[axis];
            REACH.min(place[axis]).min(beyond)
        });
        let mut sorted = Vec::with_capacity((2 * REACH + 1).pow(2));
        for y in place[1] - reach[1]..=place[1] + reach[1] {
            for x in place[0] - reach[0]..=place[0] + reach[0] {
                let opposite = others.at(2 * place[0] - x, 2 * place[1] - y);
                if [x, y] != place && !opposite.is_nan() && !others.at(x, y).is_nan() {
                    sorted.push(others.at(x, y));
                }
            }
        }
        median(&mut sorted).map_or(f64::NAN, |middle| self.heights()[at] - middle)
    }
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

    use super::{NoTest, median};
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

    /// Of Gaussian noise on a steep plane about half a point a map is taken, whatever the number of points.
    #[test]
    fn noise_has_half_an_outlier_a_map() {
        for points in [40, 120] {
            let mut found = 0;
            for seed in 0..60 {
                let mut random = Rng::with_seed(seed);
                let heights = (0..points * points)
                    .map(|at| 1e-3 * (at % points) as f64 + 1e-7 * normal(&mut random));
                let map = HeightMap::new([points; 2], [1e-6; 2], heights.collect()).unwrap();
                found += map.without_outliers().unwrap().1.count;
            }
            // 30 are expected; Poisson's distribution leaves 14 to 49 with 99.8 %. Scatter about fewer neighbours at the rim is larger.
            assert!((14..=60).contains(&found), "{found} in 60 maps of {points}");
        }
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
        assert!(outliers.threshold > 4e-7 && outliers.threshold < 7e-7, "{outliers:?}");
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

    #[test]
    fn heights_without_scatter_are_refused() {
        let map = HeightMap::new([9, 9], [1e-6; 2], (0..81).map(f64::from).collect()).unwrap();
        assert_eq!(map.without_outliers(), Err(NoTest::NoScatter));
    }
}
