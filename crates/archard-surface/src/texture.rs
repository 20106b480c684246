//! Parameters of areal surface texture (ISO 25178-2).
//!
//! Heights count from their mean, of the points that were measured. Gradients are taken after ISO 25178-2 from six neighbours
//! along an axis, which is exact for polynomials of the sixth degree; next to the rim and points that are missing, where there are none, the
//! point counts for nothing. The area of the surface is that of the triangles between neighbours.

use crate::map::HeightMap;

/// Weights of the seven points about one for its slope, over 60 spacings.
const SLOPE: [f64; 7] = [-1.0, 9.0, -45.0, 0.0, 45.0, -9.0, 1.0];

/// Weights of the same for its second derivative, over 180 squares of the spacing.
const BEND: [f64; 7] = [2.0, -27.0, 270.0, -490.0, 270.0, -27.0, 2.0];

/// The parameters of a map.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Texture {
    /// Mean height (m) that the others are measured from.
    pub mean: f64,
    /// Sa (m): mean of the sizes of heights.
    pub mean_deviation: f64,
    /// Sq (m): root of the mean square.
    pub rms: f64,
    /// Ssk: mean cube over Sq cubed.
    pub skewness: f64,
    /// Sku: mean fourth power over that of Sq; 3 of a Gaussian.
    pub kurtosis: f64,
    /// Sp (m): highest peak.
    pub peak: f64,
    /// Sv (m): deepest pit, positive.
    pub pit: f64,
    /// Sdq: root of the mean square of the gradient; not a number on fewer than seven points along an axis.
    pub rms_gradient: f64,
    /// Root of the mean square (1/m) of the mean curvature, half of d2z/dx2 + d2z/dy2, of the same points.
    pub rms_curvature: f64,
    /// Sdr: how much more area the surface has than its projection.
    pub developed: f64,
}

impl Texture {
    /// Of a map.
    pub fn of(map: &HeightMap) -> Self {
        let measured = || map.heights().iter().filter(|height| !height.is_nan());
        let count = measured().count() as f64;
        let mean = measured().sum::<f64>() / count;
        let moment =
            |power: i32| measured().map(|height| (height - mean).powi(power)).sum::<f64>() / count;
        let rms = moment(2).sqrt();
        let highest = measured().copied().fold(f64::NEG_INFINITY, f64::max);
        let lowest = measured().copied().fold(f64::INFINITY, f64::min);
        Self {
            mean,
            mean_deviation: measured().map(|height| (height - mean).abs()).sum::<f64>() / count,
            rms,
            skewness: moment(3) / rms.powi(3),
            kurtosis: moment(4) / rms.powi(4),
            peak: highest - mean,
            pit: mean - lowest,
            rms_gradient: rms_of(map, |along| {
                let slope = |axis: usize| along(axis, &SLOPE) / (60.0 * map.pixel()[axis]);
                slope(0).powi(2) + slope(1).powi(2)
            }),
            rms_curvature: rms_of(map, |along| {
                let bend = |axis: usize| along(axis, &BEND) / (180.0 * map.pixel()[axis].powi(2));
                (0.5 * (bend(0) + bend(1))).powi(2)
            }),
            developed: developed(map),
        }
    }

    /// Sz (m): from the deepest pit to the highest peak.
    pub fn height(&self) -> f64 {
        self.peak + self.pit
    }
}

/// The root of the mean of a square, over all points that have it; it is told what the seven points along an axis sum to by their weights.
fn rms_of(map: &HeightMap, square: impl Fn(&dyn Fn(usize, &[f64; 7]) -> f64) -> f64) -> f64 {
    let [nx, ny] = map.elements();
    let (mut sum, mut count) = (0.0_f64, 0.0);
    for y in 3..ny.saturating_sub(3) {
        for x in 3..nx.saturating_sub(3) {
            let along = |axis: usize, weights: &[f64; 7]| {
                let part = |(at, weight): (usize, &f64)| {
                    let place = if axis == 0 { [x + at - 3, y] } else { [x, y + at - 3] };
                    weight * map.at(place[0], place[1])
                };
                weights.iter().enumerate().map(part).sum::<f64>()
            };
            let square = square(&along);
            if !square.is_nan() {
                sum += square;
                count += 1.0;
            }
        }
    }
    (sum / count).sqrt()
}

fn developed(map: &HeightMap) -> f64 {
    let [nx, ny] = map.elements();
    let [dx, dy] = map.pixel();
    let (mut more, mut count) = (0.0, 0.0);
    for y in 0..ny - 1 {
        for x in 0..nx - 1 {
            let [a, b, c, d] =
                [[x, y], [x + 1, y], [x, y + 1], [x + 1, y + 1]].map(|[x, y]| map.at(x, y));
            // Both ways of cutting the pixel into two triangles, half each.
            let triangle = |along_x: f64, along_y: f64| {
                (1.0 + (along_x / dx).powi(2) + (along_y / dy).powi(2)).sqrt()
            };
            let areas = [
                triangle(b - a, c - a),
                triangle(d - c, d - b),
                triangle(b - a, d - b),
                triangle(d - c, c - a),
            ];
            let ratio = 0.25 * areas.iter().sum::<f64>();
            if !ratio.is_nan() {
                more += ratio - 1.0;
                count += 1.0;
            }
        }
    }
    more / count
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{PI, SQRT_2, TAU};

    use approx::assert_relative_eq;

    use super::Texture;
    use crate::map::HeightMap;

    /// A wave of height a and wavelength l has Sa = 2 a/pi, Sq = a/sqrt 2, Ssk = 0, Sku = 3/2 and Sdq = sqrt 2 pi a/l.
    #[test]
    fn a_wave_has_its_parameters() {
        let (a, l, n) = (1e-6, 50e-6, 200);
        let wave = |x: usize| a * (TAU * (x as f64 + 0.5) * 1e-6 / l).sin();
        let heights = (0..n * 8).map(|at| wave(at % n)).collect();
        let texture = Texture::of(&HeightMap::new([n, 8], [1e-6; 2], heights).unwrap());
        assert_relative_eq!(texture.mean_deviation, 2.0 * a / PI, max_relative = 1e-3);
        assert_relative_eq!(texture.rms, a / SQRT_2, max_relative = 1e-12);
        assert!(texture.skewness.abs() < 1e-12 && texture.mean.abs() < 1e-18);
        assert_relative_eq!(texture.kurtosis, 1.5, max_relative = 1e-12);
        // The rows of whole waves lose three points at each end.
        assert_relative_eq!(texture.rms_gradient, SQRT_2 * PI * a / l, max_relative = 0.02);
        assert_relative_eq!(
            texture.developed,
            0.5 * texture.rms_gradient.powi(2),
            max_relative = 0.03
        );
    }

    /// A paraboloid has the mean of its principal curvatures, and the sixth power of x a second derivative that is exact.
    #[test]
    fn a_paraboloid_has_its_curvature() {
        let place = |at: usize| [2e-3 * (at % 20) as f64, 1e-3 * (at / 20) as f64];
        let of = |height: &dyn Fn([f64; 2]) -> f64| {
            let heights = (0..200).map(|at| height(place(at))).collect();
            Texture::of(&HeightMap::new([20, 10], [2e-3, 1e-3], heights).unwrap()).rms_curvature
        };
        let bowed = of(&|[x, y]| 3.0 * x * x - 4.0 * y * y + x * y);
        assert_relative_eq!(bowed, 1.0, max_relative = 1e-9);
        let sixth = of(&|[x, _]| x.powi(6));
        let squares = (3..17).map(|x| (15.0 * (2e-3 * f64::from(x)).powi(4)).powi(2));
        assert_relative_eq!(sixth, (squares.sum::<f64>() / 14.0).sqrt(), max_relative = 1e-9);
    }

    #[test]
    fn a_plane_has_its_gradient_and_area() {
        let plane = |at: usize| 0.3 * (at % 20) as f64 * 2e-6 + 0.4 * (at / 20) as f64 * 1e-6;
        let map = HeightMap::new([20, 10], [2e-6, 1e-6], (0..200).map(plane).collect()).unwrap();
        let texture = Texture::of(&map);
        assert_relative_eq!(texture.rms_gradient, 0.5, max_relative = 1e-12);
        assert_relative_eq!(texture.developed, 1.25f64.sqrt() - 1.0, max_relative = 1e-12);
    }
}
