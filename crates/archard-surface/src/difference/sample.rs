//! Heights and slopes of a map between its points.
//!
//! Cubic convolution of the fourth order (R. G. Keys, *IEEE Trans. Acoustics, Speech, Signal Processing* 29 (1981) 1153): cubics between
//! points, with slopes there from four neighbours. It is exact for polynomials of the third degree, so that waves keep their
//! phase, and takes 36 points only, so that a hole costs little. The one of the third order moves waves of eight points by up to
//! a hundredth of a point.

use crate::map::HeightMap;

/// Height (m) and slopes of a map at a place (m, from its middle); `None` beyond it or next to a hole.
pub(super) fn at(map: &HeightMap, place: [f64; 2]) -> Option<(f64, [f64; 2])> {
    let mut corner = [0; 2];
    let mut weights = [[0.0; 6]; 2];
    let mut slopes = [[0.0; 6]; 2];
    for axis in 0..2 {
        let count = map.elements()[axis];
        let along = place[axis] / map.pixel()[axis] + 0.5 * (count - 1) as f64;
        // A place on the last row of points that has neighbours is within, whatever the rounding.
        let low = along.floor().min(count as f64 - 4.0);
        if low < 2.0 || along - low > 1.0 + 1e-9 {
            return None;
        }
        corner[axis] = low as usize - 2;
        (weights[axis], slopes[axis]) = keys(along - low);
    }
    let [mut height, mut slope] = [0.0, 0.0].map(|zero| (zero, zero));
    for y in 0..6 {
        for x in 0..6 {
            let value = map.at(corner[0] + x, corner[1] + y);
            height.0 += weights[0][x] * weights[1][y] * value;
            slope.0 += slopes[0][x] * weights[1][y] * value;
            slope.1 += weights[0][x] * slopes[1][y] * value;
        }
    }
    let slope = [slope.0 / map.pixel()[0], slope.1 / map.pixel()[1]];
    height.0.is_finite().then_some((height.0, slope))
}

/// Weights of six points for the value and for the slope, a share `t` of the way from the third to the fourth.
fn keys(t: f64) -> ([f64; 6], [f64; 6]) {
    let (s, u) = (t * t, t * t * t);
    // Hermite's cubics of the value and the slope at either end, and their slopes.
    let values = [2.0 * u - 3.0 * s + 1.0, u - 2.0 * s + t, 3.0 * s - 2.0 * u, u - s];
    let slopes = [6.0 * (s - t), 3.0 * s - 4.0 * t + 1.0, 6.0 * (t - s), 3.0 * s - 2.0 * t];
    let weights = |[start, rise, end, fall]: [f64; 4]| {
        let (rise, fall) = (rise / 12.0, fall / 12.0);
        [rise, fall - 8.0 * rise, start - 8.0 * fall, end + 8.0 * rise, 8.0 * fall - rise, -fall]
    };
    (weights(values), weights(slopes))
}

#[cfg(test)]
mod tests {
    use super::at;
    use crate::map::HeightMap;

    #[test]
    fn cubics_are_exact() {
        let height = |x: f64, y: f64| {
            2.0 + 3.0 * x - y + 1e5 * (x * x - 2.0 * y * y + 0.5 * x * y) + 1e10 * x * x * (x + y)
        };
        let blank = HeightMap::new([11, 9], [2e-6, 3e-6], vec![0.0; 99]).unwrap();
        let heights = (0..99).map(|at| height(blank.place(0, at % 11), blank.place(1, at / 11)));
        let map = blank.of_heights(heights.collect());
        for place in [[0.0, 0.0], [1.3e-6, -2.2e-6], [-4.9e-6, 5.9e-6], [6e-6, -6e-6]] {
            let (value, [along_x, along_y]) = at(&map, place).unwrap();
            let [x, y] = place;
            assert!((value - height(x, y)).abs() < 1e-12);
            assert!(
                (along_x - 3.0 - 1e5 * (2.0 * x + 0.5 * y) - 1e10 * x * (3.0 * x + 2.0 * y)).abs()
                    < 1e-9
            );
            assert!((along_y + 1.0 - 1e5 * (0.5 * x - 4.0 * y) - 1e10 * x * x).abs() < 1e-9);
        }
        assert_eq!(at(&map, [6.1e-6, 0.0]), None);
        assert_eq!(at(&map, [0.0, -6.1e-6]), None);
    }
}
