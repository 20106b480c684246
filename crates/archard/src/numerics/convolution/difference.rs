//! The difference of a field from itself one element upstream, as a factor on its spectrum.

use std::f64::consts::TAU;

use realfft::num_complex::Complex64;

use super::Convolution;

/// The factor 1 - e^(-i theta) of a backward difference along an axis, frequency by frequency.
#[derive(Debug, Clone)]
pub struct Difference {
    axis: usize,
    factors: Vec<Complex64>,
}

impl Difference {
    /// The value of an element less that of its neighbour along an axis (0: x, 1: y), the one of lower
    /// index unless `reversed`.
    pub fn new(convolution: &Convolution, axis: usize, reversed: bool) -> Self {
        let period = convolution.period[axis];
        let sign = if reversed { 1.0 } else { -1.0 };
        let factor = |k: usize| {
            let angle = sign * TAU * k as f64 / period as f64;
            Complex64::new(1.0 - angle.cos(), -angle.sin())
        };
        let mut factors: Vec<Complex64> = (0..period).map(factor).collect();
        // The highest frequency of an even period is its own mirror image.
        factors[period / 2] = Complex64::new(2.0, 0.0);
        Self { axis, factors }
    }

    /// Multiplies a column of the spectra of several fields, each of that height.
    pub(super) fn multiply(&self, column: usize, height: usize, spectra: &mut [Complex64]) {
        if self.axis == 0 {
            let factor = self.factors[column];
            spectra.iter_mut().for_each(|value| *value *= factor);
        } else {
            for spectrum in spectra.chunks_mut(height) {
                spectrum.iter_mut().zip(&self.factors).for_each(|(value, factor)| *value *= factor);
            }
        }
    }
}
