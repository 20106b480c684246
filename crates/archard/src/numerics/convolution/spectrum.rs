//! Spectra of kernels that are even or odd along each axis.

use std::sync::Arc;

use realfft::{RealToComplex, num_complex::Complex64};

use super::buffers::Buffers;

/// Whether a kernel keeps or changes its sign when an axis is reversed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Parity {
    /// It keeps it.
    Even,
    /// It changes it.
    Odd,
}

impl Parity {
    /// The factor of a reversal.
    pub(super) fn sign(self) -> f64 {
        if self == Parity::Even { 1.0 } else { -1.0 }
    }

    /// The part of the spectrum of a real sequence of this parity that does not vanish.
    pub(super) fn part(self, value: Complex64) -> f64 {
        if self == Parity::Even { value.re } else { value.im }
    }
}

/// The spectrum of a kernel, divided by the number of grid points.
#[derive(Debug, Clone)]
pub struct Spectrum {
    /// Real factors, a column of the grid after the other, half a column each.
    pub(super) factors: Vec<f64>,
    /// Along x and y.
    pub(super) parity: [Parity; 2],
}

impl Spectrum {
    /// The spectrum whose values are those of `change` (real, for kernels even along both axes).
    pub fn map(&self, change: impl Fn(f64) -> f64) -> Self {
        Self {
            factors: self.factors.iter().map(|&factor| change(factor)).collect(),
            parity: self.parity,
        }
    }

    /// Spectra made of others, value by value; each keeps the parity of the one in its place.
    pub fn combine<const N: usize>(
        spectra: &[Self; N],
        change: impl Fn([f64; N]) -> [f64; N],
    ) -> [Self; N] {
        let mut result = spectra.clone();
        for index in 0..spectra.first().map_or(0, |spectrum| spectrum.factors.len()) {
            let values = change(spectra.each_ref().map(|spectrum| spectrum.factors[index]));
            result.iter_mut().zip(values).for_each(|(to, value)| to.factors[index] = value);
        }
        result
    }

    /// Whether the factors are to be multiplied by i: a kernel odd along one axis only.
    pub(super) fn is_imaginary(&self) -> bool {
        self.parity[0] != self.parity[1]
    }
}

/// The part that does not vanish of the transform of a periodic sequence, times `scale`; the sequence
/// is given at offsets zero and greater, and the nearest image counts.
pub(super) fn half_transform(
    plan: &Arc<dyn RealToComplex<f64>>,
    half: impl Iterator<Item = f64>,
    parity: Parity,
    scale: f64,
    out: &mut [f64],
) {
    let period = plan.len();
    let lengths = [period, out.len(), plan.get_scratch_len()];
    Buffers::lend(lengths, |values, spectrum, scratch| {
        values.fill(0.0);
        for (offset, value) in half.enumerate().take(period / 2 + 1) {
            values[offset] = value;
            if offset > 0 && 2 * offset < period {
                values[period - offset] = parity.sign() * value;
            }
        }
        plan.process_with_scratch(values, spectrum, scratch)
            .expect("buffers of the planned length");
        out.iter_mut().zip(spectrum).for_each(|(out, value)| *out = scale * parity.part(*value));
    });
}
