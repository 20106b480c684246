//! Whether the later map lies where it belongs: what the difference keeps of the texture.
//!
//! At the right place the textures of both scans cancel, and their difference has the variance of noise alone. At a wrong one it has the sum of
//! both variances, less what a fit found by chance. Made scans at their own place keep 7 % at most, and 16 to 63 % at others, where a lay
//! is the same in both (`cargo test -p archard-surface --lib -- difference::tests`).

use crate::fit::Normal;
use crate::map::HeightMap;
use crate::outliers::{BY_MEDIAN, median};

/// The most that scans of one place keep: between the 7 % of right places and the 16 % of wrong ones.
pub(super) const MOST: f64 = 0.1;

/// What is left of the texture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Kept {
    /// Variance of the difference over that of both textures, each without noise.
    pub(super) share: f64,
    /// Whether noise hides the texture, so that nothing gives the place, and the place matters little.
    pub(super) hidden: bool,
}

/// Of the later heights (m) and the differences (m) at points of a map with their weights, all not numbers where nothing is as it was. `floor` is
/// what heights are not known better than (m).
pub(super) fn kept(map: &HeightMap, change: &[f64], weights: &[f64], floor: f64) -> Kept {
    let rest = |values: &dyn Fn(usize) -> f64| -> f64 {
        let nx = map.elements()[0];
        let half = map.size().map(|size| 0.5 * size);
        let known = || (0..change.len()).filter(|&at| weights[at] > 0.0 && !change[at].is_nan());
        let terms =
            |at: usize| [1.0, map.place(0, at % nx) / half[0], map.place(1, at / nx) / half[1]];
        let mut normal = Normal::new(3);
        known().for_each(|at| normal.add(&terms(at), values(at)));
        let plane = normal.solved();
        let off = |at: usize| {
            let own: f64 = terms(at).iter().zip(&plane).map(|(term, factor)| term * factor).sum();
            (values(at) - own).powi(2)
        };
        let (sum, count) = known().fold((0.0, 0.0), |(sum, n), at| (sum + off(at), n + 1.0));
        sum / f64::max(count, 1.0)
    };
    let later = |at: usize| map.heights()[at];
    let earlier = |at: usize| map.heights()[at] - change[at];
    let noise = mixed(map.elements(), change);
    let texture = rest(&later) + rest(&earlier) - noise;
    let (sum, all) = change
        .iter()
        .zip(weights)
        .filter(|(own, _)| !own.is_nan())
        .fold((0.0, f64::MIN_POSITIVE), |(sum, all), (own, weight)| {
            (sum + weight * own * own, all + weight)
        });
    let share = (sum / all - noise).max(0.0) / texture.max(f64::MIN_POSITIVE);
    Kept { share, hidden: texture < noise.max(floor * floor) }
}

/// The variance (m^2) of noise, by mixed second differences of neighbours, which have four times as much and little of what is smooth.
fn mixed([nx, ny]: [usize; 2], values: &[f64]) -> f64 {
    let corners = (0..ny - 1).flat_map(|y| (0..nx - 1).map(move |x| x + nx * y));
    let mixed = |at: usize| values[at] + values[at + nx + 1] - values[at + 1] - values[at + nx];
    let mut sizes: Vec<f64> =
        corners.map(mixed).filter(|one| !one.is_nan()).map(f64::abs).collect();
    (0.5 * BY_MEDIAN * median(&mut sizes).unwrap_or(0.0)).powi(2)
}
