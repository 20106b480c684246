//! Spectra of kernels that are even or odd along each axis.

use std::sync::Arc;

use rayon::prelude::*;
use realfft::{RealFftPlanner, RealToComplex, num_complex::Complex64};

use super::Convolution;
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

impl Convolution {
    /// The spectrum of a kernel known at offsets zero and greater, in rows of that width.
    ///
    /// Where the period is shorter than twice the field, the nearest image counts.
    pub fn spectrum(&self, kernel: &[f64], width: usize, parity: [Parity; 2]) -> Spectrum {
        let [spectrum] = self.spectra([kernel], width, [parity]);
        spectrum
    }

    /// The spectra of two such kernels at the cost of one: along each axis one of them is even and the other one odd.
    pub fn spectrum_pair(
        &self,
        kernels: [&[f64]; 2],
        width: usize,
        parities: [[Parity; 2]; 2],
    ) -> [Spectrum; 2] {
        self.spectra(kernels, width, parities)
    }

    fn spectra<const N: usize>(
        &self,
        kernels: [&[f64]; N],
        width: usize,
        parities: [[Parity; 2]; N],
    ) -> [Spectrum; N] {
        let (columns, height) = (self.columns(), self.period[1] / 2 + 1);
        let rows = kernels[0].len() / width;
        // In each row kernel after kernel.
        let mut along_x = vec![0.0; N * columns * rows];
        let along = &self.row_forward;
        along_x.par_chunks_mut(N * columns).enumerate().for_each(|(row, out)| {
            let halves = kernels.map(|kernel| kernel[row * width..][..width].iter().copied());
            half_transform(along, halves, parities.map(|[along, _]| (along, 1.0)), out);
        });
        let along = RealFftPlanner::new().plan_fft_forward(self.period[1]);
        let points = (self.period[0] * self.period[1]) as f64;
        let scaled = parities.map(|parity| {
            let sign = if parity == [Parity::Odd; 2] { -1.0 } else { 1.0 };
            (parity[1], sign / points)
        });
        let mut factors = vec![0.0; N * height * columns];
        factors.par_chunks_mut(N * height).enumerate().for_each(|(kx, out)| {
            let column = |kernel: usize| along_x[kernel * columns + kx..].iter();
            let halves = std::array::from_fn(|kernel| column(kernel).step_by(N * columns).copied());
            half_transform(&along, halves, scaled, out);
        });
        std::array::from_fn(|kernel| {
            let own =
                factors.chunks(N * height).flat_map(|both| &both[kernel * height..][..height]);
            Spectrum { factors: own.copied().collect(), parity: parities[kernel] }
        })
    }

    /// The spectrum that multiplies waves by a number, or, where it is odd along one axis only, by i times that number:
    /// a function of how many of them fit into the period along x and y. What is odd along an axis vanishes where the
    /// field or its shortest wave repeats itself from point to point.
    pub fn transfer(
        &self,
        parity: [Parity; 2],
        factor: impl Fn([usize; 2]) -> f64 + Sync,
    ) -> Spectrum {
        let height = self.period[1] / 2 + 1;
        let scale = 1.0 / (self.period[0] * self.period[1]) as f64;
        let value = |index: usize| {
            let waves = [index / height, index % height];
            let vanishes = |axis: usize| {
                parity[axis] == Parity::Odd && (2 * waves[axis]).is_multiple_of(self.period[axis])
            };
            if vanishes(0) || vanishes(1) { 0.0 } else { scale * factor(waves) }
        };
        let factors = (0..self.columns() * height).into_par_iter().map(value).collect();
        Spectrum { factors, parity }
    }
}

/// The parts that do not vanish of the transforms of periodic sequences, each with its parity and times a scale, one after the other.
/// They are given at offsets zero and greater, and the nearest image counts. One alone, or an even one and an odd one: the real and
/// the imaginary part of the transform of their sum.
fn half_transform<const N: usize>(
    plan: &Arc<dyn RealToComplex<f64>>,
    halves: [impl Iterator<Item = f64>; N],
    scaled: [(Parity, f64); N],
    out: &mut [f64],
) {
    let period = plan.len();
    let length = out.len() / N;
    let lengths = [period, length, plan.get_scratch_len()];
    Buffers::lend(lengths, |values, spectrum, scratch| {
        values.fill(0.0);
        for (half, (parity, _)) in halves.into_iter().zip(scaled) {
            for (offset, value) in half.enumerate().take(period / 2 + 1) {
                if offset > 0 && 2 * offset < period {
                    values[offset] += value;
                    values[period - offset] += parity.sign() * value;
                } else if parity == Parity::Even {
                    values[offset] += value;
                }
            }
        }
        plan.process_with_scratch(values, spectrum, scratch)
            .expect("buffers of the planned length");
        for (out, (parity, scale)) in out.chunks_mut(length).zip(scaled) {
            out.iter_mut()
                .zip(&*spectrum)
                .for_each(|(out, value)| *out = scale * parity.part(*value));
        }
    });
}
