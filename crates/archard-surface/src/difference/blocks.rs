//! Maps on fewer points: means over blocks, and smoothing by a Gaussian.

use crate::filter::gaussian;
use crate::map::HeightMap;

/// The map of the means over blocks of an odd number of points along both axes; what is left over is cut off evenly at both ends, so
/// that the middle stays. `None` if fewer than two blocks fit.
pub(super) fn means(map: &HeightMap, side: usize) -> Option<HeightMap> {
    if side <= 1 {
        return Some(map.clone());
    }
    let count = map.elements().map(|all| {
        let count = all / side;
        if (all - count * side).is_multiple_of(2) { count } else { count.saturating_sub(1) }
    });
    let first = [0, 1].map(|axis| (map.elements()[axis] - count[axis] * side) / 2);
    let mean = |at: usize| {
        let corner = [first[0] + side * (at % count[0]), first[1] + side * (at / count[0])];
        let cells =
            (0..side * side).map(|cell| map.at(corner[0] + cell % side, corner[1] + cell / side));
        cells.sum::<f64>() / (side * side) as f64
    };
    let heights = (0..count[0] * count[1]).map(mean).collect();
    HeightMap::new(count, map.pixel().map(|size| size * side as f64), heights).ok()
}

/// Values on a grid smoothed by a Gaussian of that standard deviation (points along x and y), where they are numbers.
pub(super) fn smoothed(elements: [usize; 2], values: &[f64], deviation: [f64; 2]) -> Vec<f64> {
    gaussian(elements, values, deviation).into_iter().map(|(mean, _)| mean).collect()
}

#[cfg(test)]
mod tests {
    use super::{means, smoothed};
    use crate::map::HeightMap;

    /// Means of a plane are the plane in the middles of blocks.
    #[test]
    fn blocks_keep_places_and_planes() {
        for (elements, side) in [([9, 11], 3), ([10, 8], 3), ([31, 22], 5)] {
            let count = elements[0] * elements[1];
            let blank = HeightMap::new(elements, [2.0, 3.0], vec![0.0; count]).unwrap();
            let plane = |map: &HeightMap, at: usize| {
                let [x, y] = [at % map.elements()[0], at / map.elements()[0]];
                map.place(0, x) - 2.0 * map.place(1, y)
            };
            let heights = (0..count).map(|at| plane(&blank, at)).collect();
            let fewer = means(&blank.of_heights(heights), side).unwrap();
            for (at, height) in fewer.heights().iter().enumerate() {
                assert!((height - plane(&fewer, at)).abs() < 1e-12, "{elements:?} {side}");
            }
        }
    }

    /// The variance of white noise falls by 1/(4 pi deviation^2), and its mean stays.
    #[test]
    fn smoothing_has_the_weights_of_a_gaussian() {
        let n = 41;
        let mut point = vec![0.0; n * n];
        point[n * n / 2] = 1.0;
        let spread = smoothed([n, n], &point, [2.0, 3.0]);
        let sum: f64 = spread.iter().sum();
        let squares: f64 = spread.iter().map(|one| one * one).sum();
        assert!((sum - 1.0).abs() < 1e-3, "{sum}");
        assert!((squares * 4.0 * std::f64::consts::PI * 6.0 - 1.0).abs() < 1e-2, "{squares}");
        point[3] = f64::NAN;
        let level: Vec<f64> = point.iter().map(|one| one * 0.0 + 5.0).collect();
        let same = smoothed([n, n], &level, [2.0, 3.0]);
        assert!(same.iter().zip(&level).all(|(one, other)| one.is_nan() == other.is_nan()));
        assert!(same.iter().all(|one| one.is_nan() || (one - 5.0).abs() < 1e-12));
    }
}
