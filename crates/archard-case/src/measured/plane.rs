//! The plane through readings of a surface: offset and tilt by least squares, debris left out.

/// A reading of a surface: its place along x and y, and its height out of the material (m).
pub type Height = [f64; 3];

/// A plane through readings, and how well they tell it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plane {
    /// Height (m) at the origin of the readings.
    pub offset: f64,
    /// Slope along x and y; zero along an axis that all readings have the same place on.
    pub tilt: [f64; 2],
    /// Readings it was fitted to.
    pub used: usize,
    /// Their scatter about it (m).
    pub scatter: f64,
    /// The middle of those readings (m), and the inverse of the sums of their squares about it (1/m^2).
    middle: [f64; 2],
    spread: [[f64; 2]; 2],
}

/// Deviations, in standard deviations by the median, beyond which a reading is debris (B. Iglewicz and D. C. Hoaglin, *How to
/// Detect and Handle Outliers*, ASQC 1993).
pub(super) const DEBRIS: f64 = 3.5;
/// The median of deviations over the standard deviation of normal ones: their third quartile.
const MEDIAN: f64 = 0.6745;
/// Standard deviations beyond which chance explains nothing: it comes to as much once in 370 times.
pub(super) const BEYOND_CHANCE: f64 = 3.0;
/// Rounds in which what is left out settles, at most: each leaves out some.
pub(super) const ROUNDS: usize = 12;
/// Fewest readings that tell a plane.
pub const FEWEST: usize = 6;

impl Plane {
    /// The horizontal plane at height zero: readings that are level already.
    pub const LEVEL: Self = Self {
        offset: 0.0,
        tilt: [0.0; 2],
        used: 0,
        scatter: 0.0,
        middle: [0.0; 2],
        spread: [[0.0; 2]; 2],
    };

    /// A plane that no readings tell.
    pub(super) fn given(offset: f64, tilt: [f64; 2]) -> Self {
        Self { offset, tilt, ..Self::LEVEL }
    }

    /// The plane through readings; `None` of fewer than [`FEWEST`].
    pub fn through(readings: &[Height]) -> Option<Self> {
        let mut rest = readings.to_vec();
        let mut found = None;
        for _ in 0..ROUNDS {
            let plane = Self::of_least_squares(&rest)?;
            let mut sizes: Vec<f64> = rest.iter().map(|own| plane.above(own).abs()).collect();
            sizes.sort_by(f64::total_cmp);
            let deviation = sizes[sizes.len() / 2] / MEDIAN;
            found = Some(plane);
            let before = rest.len();
            let debris = DEBRIS * deviation.max(f64::MIN_POSITIVE);
            rest.retain(|own| plane.above(own).abs() <= debris);
            if rest.len() == before || rest.len() < FEWEST {
                break;
            }
        }
        found
    }

    /// By how much a reading lies above the plane (m).
    pub fn above(&self, [x, y, z]: &Height) -> f64 {
        z - self.offset - self.tilt[0] * x - self.tilt[1] * y
    }

    /// Variance of its height at a place, over that of an independent reading.
    pub(super) fn variance_at(&self, place: [f64; 2]) -> f64 {
        let [x, y] = [0, 1].map(|axis| place[axis] - self.middle[axis]);
        let [[a, b], [_, c]] = self.spread;
        1.0 / self.used.max(1) as f64 + a * x * x + 2.0 * b * x * y + c * y * y
    }

    fn of_least_squares(readings: &[Height]) -> Option<Self> {
        if readings.len() < FEWEST {
            return None;
        }
        let count = readings.len() as f64;
        let [x, y, z] = [0, 1, 2].map(|i| readings.iter().map(|own| own[i]).sum::<f64>() / count);
        let from = |own: &Height| [own[0] - x, own[1] - y, own[2] - z];
        let sum = |i: usize, j: usize| -> f64 {
            readings.iter().map(|own| from(own)[i] * from(own)[j]).sum()
        };
        let (xx, yy, xy) = (sum(0, 0), sum(1, 1), sum(0, 1));
        let (largest, whole) = (xx.max(yy), xx * yy - xy * xy);
        // Of sums of so many terms.
        let rounding = count * f64::EPSILON;
        let spread = if xx <= rounding * largest {
            [[0.0, 0.0], [0.0, inverse(yy)]]
        } else if yy <= rounding * largest || whole <= rounding * xx * yy {
            [[inverse(xx), 0.0], [0.0, 0.0]]
        } else {
            [[yy / whole, -xy / whole], [-xy / whole, xx / whole]]
        };
        let tilt = spread.map(|[a, b]| a * sum(0, 2) + b * sum(1, 2));
        let mut plane = Self {
            offset: z - tilt[0] * x - tilt[1] * y,
            tilt,
            used: readings.len(),
            scatter: 0.0,
            middle: [x, y],
            spread,
        };
        let square: f64 = readings.iter().map(|own| plane.above(own).powi(2)).sum();
        plane.scatter = (square / count).sqrt();
        Some(plane)
    }
}

fn inverse(square: f64) -> f64 {
    if square > 0.0 { 1.0 / square } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::Plane;

    /// A tilted plane with a speck of debris, along a line and over an area.
    #[test]
    fn a_tilted_plane_is_found_beside_debris() {
        for across in [0.0, 2e-3] {
            let readings: Vec<[f64; 3]> = (0..400)
                .map(|i| {
                    let (x, y) = (5e-6 * f64::from(i), across * f64::from(i % 20) / 20.0);
                    let debris = if (30..34).contains(&i) { 5e-6 } else { 0.0 };
                    [x, y, 1e-5 + 3e-3 * x - 1e-3 * y + debris]
                })
                .collect();
            let plane = Plane::through(&readings).unwrap();
            let tilt = [3e-3, if across > 0.0 { -1e-3 } else { 0.0 }];
            assert!((plane.offset - 1e-5).abs() < 1e-12, "{plane:?}");
            for (found, made) in plane.tilt.into_iter().zip(tilt) {
                assert!((found - made).abs() < 1e-9, "{plane:?}");
            }
            assert_eq!(plane.used, 396);
            assert_eq!(Plane::through(&readings[..3]), None);
        }
    }

    /// The variance of a line at a place, of any textbook: 1/n + (x - mean)^2 / sum of squares.
    #[test]
    fn a_line_is_known_best_in_its_middle() {
        let readings: Vec<[f64; 3]> = (0..11).map(|i| [f64::from(i), 0.0, 0.0]).collect();
        let plane = Plane::through(&readings).unwrap();
        assert!((plane.variance_at([5.0, 0.0]) - 1.0 / 11.0).abs() < 1e-12);
        assert!((plane.variance_at([10.0, 3.0]) - 1.0 / 11.0 - 25.0 / 110.0).abs() < 1e-12);
    }
}
