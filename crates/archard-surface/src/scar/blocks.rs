//! Readings of a profile in rising order, averaged over blocks.

use crate::map::HeightMap;
use crate::outliers::median;

/// Blocks at most: the cost of a covariance that is dense. A scar is thirty of them wide at least where it fills a quarter of the profile.
const MOST: usize = 140;

/// Places so many steps apart have a hole between them: halfway to where a reading is missing.
const UNEVEN: f64 = 1.5;

/// A profile in blocks.
#[derive(Debug, Clone)]
pub(super) struct Blocks {
    /// Places and heights (m).
    pub places: Vec<f64>,
    pub heights: Vec<f64>,
    /// Spikes that were left out.
    pub spikes: usize,
    /// What a block is not known better than by the rounding of its readings (m), and what a reading is not.
    pub rounding: f64,
    pub step: f64,
    /// Readings in all.
    pub readings: usize,
}

impl Blocks {
    /// Of places and heights (m), not a number where nothing was measured.
    pub fn of(readings: &[[f64; 2]]) -> Self {
        let mut all: Vec<[f64; 2]> =
            readings.iter().copied().filter(|own| own.iter().all(|own| own.is_finite())).collect();
        all.sort_by(|one, other| one[0].total_cmp(&other[0]));
        let count = all.len();
        // A map of one row, and of a second that was not measured. Where no block has two readings their weights find spikes: the bottom of
        // a scar of few readings would count as one.
        let heights = all.iter().map(|own| own[1]).chain(vec![f64::NAN; count]).collect();
        if count > MOST
            && let Ok(line) = HeightMap::new([count, 2], [1.0; 2], heights)
        {
            let kept = line.clear().0;
            all = all
                .into_iter()
                .zip(kept.heights())
                .filter(|own| own.1.is_finite())
                .map(|own| own.0)
                .collect();
        }
        let spikes = count - all.len();
        let side = all.len().div_ceil(MOST).max(1);
        let spare = all.len() % side;
        let blocks = all[spare / 2..all.len() - (spare - spare / 2)].chunks(side);
        let mean = |axis: usize| {
            let one =
                |block: &[[f64; 2]]| block.iter().map(|own| own[axis]).sum::<f64>() / side as f64;
            blocks.clone().map(one).collect()
        };
        let (places, heights) = (mean(0), mean(1));
        let step = step(&all) / 12f64.sqrt();
        let rounding = step / (side as f64).sqrt();
        Self { places, heights, spikes, rounding, step, readings: count }
    }

    /// Number of blocks.
    pub fn len(&self) -> usize {
        self.places.len()
    }

    /// From the first place to the last (m).
    pub fn span(&self) -> f64 {
        self.places[self.len() - 1] - self.places[0]
    }

    /// The middle step between places (m).
    pub fn step(&self) -> f64 {
        let mut steps: Vec<f64> = self.places.windows(2).map(|pair| pair[1] - pair[0]).collect();
        median(&mut steps).unwrap_or(0.0)
    }

    /// The length (m) that each place stands for, and from where to where (m) nothing was measured between them.
    pub fn cover(&self) -> (Vec<f64>, Vec<[f64; 2]>) {
        let step = self.step();
        let mut lengths = vec![0.0; self.len()];
        let mut holes = vec![];
        for (at, pair) in self.places.windows(2).enumerate() {
            let far = pair[1] - pair[0];
            let own = if far <= UNEVEN * step { far } else { step };
            lengths[at] += 0.5 * own;
            lengths[at + 1] += 0.5 * own;
            if own < far {
                holes.push([pair[0] + 0.5 * own, pair[1] - 0.5 * own]);
            }
        }
        // The first and the last reach half a step beyond them.
        let last = lengths.len() - 1;
        [0, last].into_iter().for_each(|at| lengths[at] += 0.5 * step);
        (lengths, holes)
    }
}

/// The least step between heights (m) where many are the same; zero otherwise.
fn step(readings: &[[f64; 2]]) -> f64 {
    let mut heights: Vec<f64> = readings.iter().map(|own| own[1]).collect();
    heights.sort_by(f64::total_cmp);
    let range = heights.last().zip(heights.first()).map_or(0.0, |(last, first)| last - first);
    // Closer ones are the same, to double precision.
    heights.dedup_by(|next, first| *next - *first <= 1e-12 * range);
    let least = heights.windows(2).map(|pair| pair[1] - pair[0]).fold(f64::INFINITY, f64::min);
    if 2 * heights.len() < readings.len() && least.is_finite() { least } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::Blocks;

    /// Spikes are left out, and blocks are means of what is left.
    #[test]
    fn blocks_leave_out_spikes() {
        let mut random = fastrand::Rng::with_seed(1);
        let mut reading = |i: usize| {
            let spike = if i % 100 == 7 { 1e-3 } else { 0.0 };
            [i as f64, 1e-7 * (0..12).map(|_| random.f64() - 0.5).sum::<f64>() + spike]
        };
        let blocks = Blocks::of(&(0..1400).map(&mut reading).collect::<Vec<_>>());
        // W. Chauvenet's bound takes half a point by chance.
        assert!((14..17).contains(&blocks.spikes), "{blocks:?}");
        assert_eq!([blocks.len(), blocks.readings], [138, 1400]);
        assert!(blocks.heights.iter().all(|own| own.abs() < 5e-7));
        assert!((blocks.step() - 10.0).abs() < 0.1 && (blocks.span() - 1380.0).abs() < 10.0);
    }
}
