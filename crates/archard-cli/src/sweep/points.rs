//! Points of the unit cube that samples are drawn at.

use crate::arguments::Layout;

/// Half the distance of the values that a Sobol sequence takes: its points lie within the cube, never on its faces.
const HALF: f64 = 1.0 / (1 << 25) as f64;
/// Most points of a Sobol sequence.
pub const MOST: usize = 1 << 16;

/// As many points in that many dimensions, each coordinate between zero and one.
///
/// Of [`Layout::Saltelli`] every point A of the first half of the dimensions is followed by its partner B of the other
/// half, and by A with each coordinate in turn taken from B: A. Saltelli et al., *Comput. Phys. Commun.* 181 (2010) 259.
pub fn points(layout: Layout, (count, dimensions): (usize, usize), seed: u32) -> Vec<Vec<f64>> {
    match layout {
        Layout::Latin => latin(count, dimensions, seed),
        Layout::Sobol => (0..count).map(|index| sobol(index, 0..dimensions, seed)).collect(),
        Layout::Saltelli => {
            (0..count).flat_map(|index| saltelli(index, dimensions, seed)).collect()
        }
    }
}

/// Makes the first two coordinates of points go together, as [`archard_lab::together`] does.
pub fn together(points: &mut [Vec<f64>], correlation: f64) {
    for point in points {
        if let [one, other, ..] = &mut point[..] {
            *other = archard_lab::together([*one, *other], correlation).clamp(HALF, 1.0 - HALF);
        }
    }
}

/// A point of Sobol's sequence, scrambled by A. B. Owen's method.
fn sobol(index: usize, dimensions: std::ops::Range<usize>, seed: u32) -> Vec<f64> {
    let one = |dimension: usize| {
        f64::from(sobol_burley::sample(index as u32, dimension as u32, seed)) + HALF
    };
    dimensions.map(one).collect()
}

/// Each of as many equal parts of every coordinate holds one point: M. D. McKay et al., *Technometrics* 21 (1979) 239.
fn latin(count: usize, dimensions: usize, seed: u32) -> Vec<Vec<f64>> {
    let mut random = fastrand::Rng::with_seed(u64::from(seed));
    let mut points = vec![vec![]; count];
    for _ in 0..dimensions {
        let mut parts: Vec<usize> = (0..count).collect();
        random.shuffle(&mut parts);
        for (point, part) in points.iter_mut().zip(parts) {
            // Never zero: there the quantile of most distributions is infinite.
            point.push((part as f64 + random.f64().max(f64::EPSILON)) / count as f64);
        }
    }
    points
}

fn saltelli(index: usize, dimensions: usize, seed: u32) -> Vec<Vec<f64>> {
    let a = sobol(index, 0..dimensions, seed);
    let b = sobol(index, dimensions..2 * dimensions, seed);
    let exchanged = |axis: usize| {
        let mut point = a.clone();
        point[axis] = b[axis];
        point
    };
    let mixed: Vec<Vec<f64>> = (0..dimensions).map(exchanged).collect();
    [a, b].into_iter().chain(mixed).collect()
}

#[cfg(test)]
mod tests {
    use statrs::distribution::{ContinuousCDF, Normal};

    use super::{points, together};
    use crate::arguments::Layout;

    #[test]
    fn every_part_of_every_axis_holds_one_point() {
        for layout in [Layout::Latin, Layout::Sobol] {
            let points = points(layout, (64, 3), 7);
            for axis in 0..3 {
                let mut parts: Vec<usize> =
                    points.iter().map(|point| (64.0 * point[axis]) as usize).collect();
                parts.sort_unstable();
                assert_eq!(parts, (0..64).collect::<Vec<_>>(), "{layout:?}");
            }
            assert!(points.iter().flatten().all(|&x| 0.0 < x && x < 1.0));
        }
    }

    #[test]
    fn seeds_tell_points_apart() {
        for layout in [Layout::Latin, Layout::Sobol, Layout::Saltelli] {
            assert_eq!(points(layout, (8, 2), 1), points(layout, (8, 2), 1));
            assert_ne!(points(layout, (8, 2), 1), points(layout, (8, 2), 2));
        }
    }

    #[test]
    fn partners_differ_in_one_coordinate_from_the_first() {
        let points = points(Layout::Saltelli, (4, 3), 1);
        assert_eq!(points.len(), 4 * (3 + 2));
        for block in points.chunks(5) {
            for axis in 0..3 {
                let mut expected = block[0].clone();
                expected[axis] = block[1][axis];
                assert_eq!(block[2 + axis], expected);
            }
        }
    }

    /// Normal deviates have the correlation asked for, and each is as evenly spread as before; the third is left alone.
    #[test]
    fn coordinates_go_together() {
        for (layout, correlation) in [
            (Layout::Latin, 0.9),
            (Layout::Sobol, -0.6),
            (Layout::Sobol, 1.0),
            (Layout::Latin, 0.0),
        ] {
            let before = points(layout, (2048, 3), 7);
            let mut after = before.clone();
            together(&mut after, correlation);
            let deviates = |i: usize| -> Vec<f64> {
                after.iter().map(|point| Normal::standard().inverse_cdf(point[i])).collect()
            };
            let [a, b] = [0, 1].map(deviates);
            let mean = |values: &[f64]| values.iter().sum::<f64>() / 2048.0;
            assert!(mean(&b).abs() < 0.02, "{}", mean(&b));
            let product: Vec<f64> = a.iter().zip(&b).map(|(a, b)| a * b).collect();
            // Chance in a Latin hypercube: 1 / sqrt(2048) = 2 %.
            assert!((mean(&product) - correlation).abs() < 0.06, "{}", mean(&product));
            let square: Vec<f64> = b.iter().map(|b| b * b).collect();
            assert!((mean(&square) - 1.0).abs() < 0.1, "{}", mean(&square));
            let third = |points: &[Vec<f64>]| points.iter().map(|p| p[2]).collect::<Vec<_>>();
            assert_eq!(third(&before), third(&after));
        }
    }
}
