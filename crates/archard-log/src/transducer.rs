//! What a transducer does of its own: readings that are off alone (spikes), and steps that stay (jumps).

use statrs::distribution::{ContinuousCDF, Normal};

use crate::noise::BINS;
use crate::steps::median;

/// Share of readings whose scatter is that of all: up to a tenth may be off (a choice).
const SOUND: f64 = 0.9;

/// What no noise of the others makes once in a hundred logs of as many readings: that many times their scatter, not below the
/// resolution. Where readings are held or repeat themselves, most are off by nothing, and the scatter is that of the rest.
fn bound(off: &[f64], resolution: f64) -> f64 {
    let normal = Normal::new(0.0, 1.0).expect("the standard normal distribution");
    let mut sizes: Vec<f64> = off.iter().map(|own| own.abs()).collect();
    sizes.sort_by(f64::total_cmp);
    let of = |share: f64| {
        let at = (share * sizes.len() as f64) as usize;
        sizes.get(at).copied().unwrap_or_default() / normal.inverse_cdf(0.5 + 0.5 * share)
    };
    let sigma = of(0.5).max(of(SOUND)).max(resolution);
    normal.inverse_cdf(1.0 - 0.005 / off.len().max(1) as f64) * sigma
}

/// Readings of a bin of the regression, five at least: what is shorter than half of that and comes back is a spike, what stays a jump.
fn width(readings: usize) -> usize {
    readings.div_ceil(BINS).max(5)
}

/// Rows of readings that no noise of the others makes, and from which the depth comes back: off from the median of the readings around
/// by that and by their quartiles, which hold the median where fewer than a quarter of them are off and the depth itself rises.
pub fn spikes(depth: &[f64]) -> Vec<usize> {
    let n = depth.len();
    if n < 3 {
        return vec![];
    }
    let around = running_quartiles(depth, width(n));
    let off: Vec<f64> = depth.iter().zip(&around).map(|(own, around)| own - around[1]).collect();
    let bound = bound(&off, resolution(depth));
    // An end has readings at one side alone: it is off from where the next two point, whose noise adds up to the root of six.
    let end = |row: usize, near: usize, next: usize| {
        let off = depth[row] - 2.0 * depth[near] + depth[next];
        off.abs() > 6f64.sqrt() * bound && (depth[near] - depth[next]).abs() <= 2f64.sqrt() * bound
    };
    let is = |row: &usize| match *row {
        0 => end(0, 1, 2),
        row if row == n - 1 => end(row, n - 2, n - 3),
        row => off[row].abs() > bound + around[row][2] - around[row][0],
    };
    (0..n).filter(is).collect()
}

/// Jumps: the first row after each, and its height (m). One step between two readings that no noise of the others makes, and that
/// stays: the medians of the readings of a bin before and after differ by more than half of it.
pub fn jumps(depth: &[f64]) -> Vec<(usize, f64)> {
    let steps: Vec<f64> = depth.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let middle = median(&steps);
    let off: Vec<f64> = steps.iter().map(|step| step - middle).collect();
    let bound = bound(&off, resolution(depth));
    let width = width(depth.len());
    let stays = |row: usize| {
        let before = median(&depth[row.saturating_sub(width)..row]);
        median(&depth[row..(row + width).min(depth.len())]) - before
    };
    let large = (1..depth.len()).filter(|row| off[row - 1].abs() > bound);
    large
        .map(|row| (row, stays(row)))
        .filter(|(row, stays)| {
            let step = steps[row - 1];
            stays.abs() > bound && stays * step > 0.5 * step * step
        })
        .collect()
}

/// The smallest difference of two neighbours that is not zero.
pub fn resolution(depth: &[f64]) -> f64 {
    let steps = depth.windows(2).map(|pair| (pair[1] - pair[0]).abs());
    let least = steps.filter(|step| *step > 0.0).fold(f64::INFINITY, f64::min);
    if least.is_finite() { least } else { 0.0 }
}

/// The quartiles of as many readings on both sides of each: `half`, fewer at the ends, so that a course which only rises has itself as
/// its median. Counts by rank are kept in a binary indexed tree (Fenwick, Softw. Pract. Exp. 24 (1994) 327).
fn running_quartiles(values: &[f64], half: usize) -> Vec<[f64; 3]> {
    let n = values.len();
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|one, other| values[*one].total_cmp(&values[*other]));
    let mut rank = vec![0; n];
    order.iter().enumerate().for_each(|(at, row)| rank[*row] = at);
    let mut tree = vec![0i32; n + 1];
    let put = |tree: &mut Vec<i32>, row: usize, count: i32| {
        let mut at = rank[row] + 1;
        while at <= n {
            tree[at] += count;
            at += at & at.wrapping_neg();
        }
    };
    let largest = 1usize << n.ilog2();
    let nth = |tree: &Vec<i32>, nth: usize| {
        let (mut at, mut left, mut step) = (0, nth as i32, largest);
        while step > 0 {
            if at + step <= n && tree[at + step] <= left {
                at += step;
                left -= tree[at];
            }
            step /= 2;
        }
        values[order[at]]
    };
    let (mut from, mut to) = (0, 0);
    (0..n)
        .map(|row| {
            let reach = half.min(row).min(n - 1 - row);
            while to < row + reach + 1 {
                put(&mut tree, to, 1);
                to += 1;
            }
            while from < row - reach {
                put(&mut tree, from, -1);
                from += 1;
            }
            [reach / 2, reach, 2 * reach - reach / 2].map(|place| nth(&tree, place))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::{running_quartiles, spikes};
    use crate::steps::median;

    #[test]
    fn running_medians_are_those_of_each_window() {
        let mut random = fastrand::Rng::with_seed(3);
        for n in [1, 2, 7, 100] {
            let values: Vec<f64> = (0..n).map(|_| f64::from(random.u8(0..9))).collect();
            let expected = (0..n).map(|row| {
                let reach = 4.min(row).min(n - 1 - row);
                median(&values[row - reach..=row + reach])
            });
            let found = running_quartiles(&values, 4).into_iter().map(|around| around[1]);
            assert!(found.eq(expected));
        }
    }

    #[test]
    fn what_comes_back_is_a_spike_and_running_in_is_not() {
        let mut random = fastrand::Rng::with_seed(5);
        let mut depth: Vec<f64> = (0..900)
            .map(|row| 40.0 * (1.0 - (-f64::from(row) / 30.0).exp()) + 0.2 * random.f64())
            .collect();
        assert_eq!(spikes(&depth), Vec::<usize>::new());
        for row in [20, 300, 301, 302, 899] {
            depth[row] += 25.0;
        }
        assert_eq!(spikes(&depth), [20, 300, 301, 302, 899]);
    }
}
