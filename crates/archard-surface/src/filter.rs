//! The linear Gaussian filter of ISO 16610-61, for short waves and for long ones.
//!
//! The Gaussian weighs a neighbour at the distance r by exp(-pi r^2/(alpha L)^2), alpha^2 = ln 2/pi, so that a wave of the cutoff L keeps half of
//! its amplitude, a wave of another length l the share 2^-(L/l)^2. At the rim and at points that were not measured the weights that are left are
//! made to sum to one: constants stay what they are, a slope is bent within about half a cutoff of the rim.

use std::f64::consts::{LN_2, PI};

use rustfft::FftPlanner;
use rustfft::num_complex::Complex;

use crate::map::HeightMap;

/// Relative rounding of lengths that are whole numbers of pixels.
pub(crate) const ROUNDING: f64 = 1e-9;

/// Why a map cannot be filtered.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum NoFilter {
    /// No wave of the map is so short.
    #[error(
        "a cutoff of {cutoff:e} m is shorter than two pixels, {least:e} m: the map has no such waves"
    )]
    Short {
        /// The cutoff (m).
        cutoff: f64,
        /// The least (m).
        least: f64,
    },
    /// The map is not so long.
    #[error("a cutoff of {cutoff:e} m is longer than the shorter side of the map, {most:e} m")]
    Long {
        /// The cutoff (m).
        cutoff: f64,
        /// The most (m).
        most: f64,
    },
}

impl HeightMap {
    /// The map without its short waves, half of them kept at the cutoff (m): the S-filter of ISO 25178-3. Points that were not measured
    /// count for nothing and stay so.
    ///
    /// # Errors
    /// If the cutoff is shorter than two pixels or longer than the map.
    pub fn smoothed(&self, cutoff: f64) -> Result<Self, NoFilter> {
        let least = 2.0 * self.pixel()[0].max(self.pixel()[1]);
        let most = self.size()[0].min(self.size()[1]);
        if cutoff < least * (1.0 - ROUNDING) {
            return Err(NoFilter::Short { cutoff, least });
        }
        if cutoff > most * (1.0 + ROUNDING) {
            return Err(NoFilter::Long { cutoff, most });
        }
        // With alpha^2 = ln 2/pi the exponent is that of a normal distribution.
        let deviation = cutoff * (0.5 * LN_2).sqrt() / PI;
        let deviation = self.pixel().map(|pixel| deviation / pixel);
        let means = gaussian(self.elements(), self.heights(), deviation);
        Ok(self.of_heights(means.into_iter().map(|(mean, _)| mean).collect()))
    }

    /// The map without its long waves, half of them taken off at the cutoff (m): the L-filter of ISO 25178-3.
    ///
    /// # Errors
    /// As of [`smoothed`](Self::smoothed).
    pub fn roughness(&self, cutoff: f64) -> Result<Self, NoFilter> {
        let waviness = self.smoothed(cutoff)?;
        let heights = self.heights().iter().zip(waviness.heights());
        Ok(self.of_heights(heights.map(|(height, long)| height - long).collect()))
    }
}

/// Values on a grid weighed by a Gaussian of that standard deviation (points along x and y): the mean of the numbers around each, and the
/// share of all weights that these have. What is no number stays none.
pub(crate) fn gaussian(
    [nx, ny]: [usize; 2],
    values: &[f64],
    deviation: [f64; 2],
) -> Vec<(f64, f64)> {
    let known = || values.iter().copied().filter(|value| !value.is_nan());
    let [low, high] =
        [known().fold(f64::INFINITY, f64::min), known().fold(f64::NEG_INFINITY, f64::max)];
    let range = if high > low { high - low } else { 1.0 };
    // Values as real parts, whether they are numbers as imaginary ones: the weights are real and keep them apart.
    let packed = |value: &f64| match value.is_nan() {
        true => Complex::ZERO,
        false => Complex::new((value - low) / range, 1.0),
    };
    let mut field: Vec<Complex<f64>> = values.iter().map(packed).collect();
    weigh(&mut field, nx, deviation[0]);
    let mut turned = transposed(&field, nx);
    weigh(&mut turned, ny, deviation[1]);
    let sums = transposed(&turned, ny);
    let mean = |(value, sums): (&f64, &Complex<f64>)| match value.is_nan() {
        true => (f64::NAN, sums.im),
        false => (low + range * sums.re / sums.im, sums.im),
    };
    values.iter().zip(&sums).map(mean).collect()
}

/// Weighs each row of so many values by the Gaussian of that deviation (points), of sum one.
fn weigh(field: &mut [Complex<f64>], length: usize, deviation: f64) {
    // A deviation of nothing leaves each value by itself.
    let deviation = deviation.max(f64::MIN_POSITIVE);
    let weight = |offset: usize| (-0.5 * (offset as f64 / deviation).powi(2)).exp();
    // Beyond the reach weights are below rounding.
    let reach = (deviation * (-2.0 * f64::EPSILON.ln()).sqrt()).ceil() as usize;
    let all = 2.0 * (0..=reach).map(weight).sum::<f64>() - 1.0;
    let reach = reach.min(length - 1);
    let padded = (length + reach).next_power_of_two();
    let mut planner = FftPlanner::new();
    let (forward, backward) = (planner.plan_fft_forward(padded), planner.plan_fft_inverse(padded));
    let mut weights = vec![Complex::ZERO; padded];
    for offset in 0..=reach {
        let weight = Complex::new(weight(offset) / (all * padded as f64), 0.0);
        weights[offset] = weight;
        weights[(padded - offset) % padded] = weight;
    }
    forward.process(&mut weights);
    let mut row = vec![Complex::ZERO; padded];
    for values in field.chunks_exact_mut(length) {
        row.fill(Complex::ZERO);
        row[..length].copy_from_slice(values);
        forward.process(&mut row);
        row.iter_mut().zip(&weights).for_each(|(one, weight)| *one *= weight.re);
        backward.process(&mut row);
        values.copy_from_slice(&row[..length]);
    }
}

/// Rows of that length as columns.
pub(crate) fn transposed<T: Copy>(field: &[T], length: usize) -> Vec<T> {
    let rows = field.len() / length;
    (0..field.len()).map(|at| field[at / rows + length * (at % rows)]).collect()
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use approx::assert_relative_eq;

    use super::NoFilter;
    use crate::map::HeightMap;

    const PIXEL: [f64; 2] = [1e-6, 2e-6];

    fn map(height: impl Fn(usize, usize) -> f64) -> HeightMap {
        let heights = (0..400 * 200).map(|at| height(at % 400, at / 400)).collect();
        HeightMap::new([400, 200], PIXEL, heights).unwrap()
    }

    /// A wave of the cutoff keeps half, one of twice its length 2^(-1/4), along x, y and across; a constant stays, with holes.
    #[test]
    fn half_of_a_wave_is_kept_at_the_cutoff() {
        let cutoff = 40e-6;
        for (length, share) in [(1.0, 0.5), (2.0, 2f64.powf(-0.25)), (0.5, 0.0625)] {
            for [a, b] in [[1.0, 0.0], [0.0, 1.0], [0.6, 0.8]] {
                let k = TAU / (length * cutoff);
                let wave = |x: usize, y: usize| {
                    (k * (a * PIXEL[0] * x as f64 + b * PIXEL[1] * y as f64)).cos()
                };
                let whole = map(wave);
                let (smooth, rough) =
                    (whole.smoothed(cutoff).unwrap(), whole.roughness(cutoff).unwrap());
                // Beyond the reach of the rim.
                for (x, y) in (150..250).step_by(7).zip((80..120).step_by(3)) {
                    assert_relative_eq!(smooth.at(x, y), share * wave(x, y), epsilon = 1e-12);
                    assert_relative_eq!(
                        rough.at(x, y),
                        (1.0 - share) * wave(x, y),
                        epsilon = 1e-12
                    );
                }
            }
        }
    }

    /// Two constants with a hole between them that is wider than the reach: each stays, at the rim and around other holes too.
    #[test]
    fn constants_stay_around_holes() {
        let map = map(|x, y| match x {
            ..150 if (x / 30 + y / 20).is_multiple_of(2) => f64::NAN,
            ..150 => 3e-6,
            150..250 => f64::NAN,
            _ => 7e-6,
        });
        let smooth = map.smoothed(50e-6).unwrap();
        for (one, other) in smooth.heights().iter().zip(map.heights()) {
            assert!(one.is_nan() && other.is_nan() || (one - other).abs() < 1e-20, "{one} {other}");
        }
    }

    #[test]
    fn cutoffs_beyond_the_map_are_refused() {
        let map = map(|x, _| x as f64);
        assert_eq!(map.smoothed(3e-6), Err(NoFilter::Short { cutoff: 3e-6, least: 4e-6 }));
        assert!(matches!(map.roughness(401e-6), Err(NoFilter::Long { .. })));
    }
}
