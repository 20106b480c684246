//! Convolution of fields on a grid with symmetric kernels, by real Fourier transforms.
//!
//! The transforms are arranged so that little is computed that is not needed: rows outside the field
//! are never transformed, columns are transformed there and back while they are in the cache, and
//! only the rows asked for are transformed back. Kernels are even or odd along each axis, so that
//! their spectra are real up to a factor i, and half of each is stored.

use super::vector::LANES;

mod buffers;
mod difference;
mod spectrum;
#[cfg(test)]
mod tests;

use std::fmt;
use std::sync::{Arc, Mutex, PoisonError};

use rayon::prelude::*;
use realfft::{ComplexToReal, RealFftPlanner, RealToComplex, num_complex::Complex64};
use rustfft::{Fft, FftPlanner};

pub use difference::Difference;
pub use spectrum::{Parity, Spectrum};

use buffers::{Buffers, grow};

/// Plans and work space for convolutions on one grid.
pub struct Convolution {
    /// Elements of the field along x and y.
    size: [usize; 2],
    /// Points of the periodic grid along x and y.
    period: [usize; 2],
    row_forward: Arc<dyn RealToComplex<f64>>,
    row_inverse: Arc<dyn ComplexToReal<f64>>,
    column_forward: Arc<dyn Fft<f64>>,
    column_inverse: Arc<dyn Fft<f64>>,
    /// Work space of an application, kept between applications, maybe those of several convolutions: spectra along x of
    /// every row, by blocks of columns, in each block component after component.
    spare: Arc<Mutex<Vec<Complex64>>>,
}

impl fmt::Debug for Convolution {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Convolution {{ size: {:?}, period: {:?} }}", self.size, self.period)
    }
}

impl Convolution {
    /// Convolutions of fields of that size, padded so that nothing wraps around.
    pub fn padded(size: [usize; 2]) -> Self {
        Self::with_period(size, size.map(|n| even_smooth(2 * n)))
    }

    /// Periodic convolutions of fields of that size; the period is a little longer than the field
    /// where its size has large prime factors.
    pub fn periodic(size: [usize; 2]) -> Self {
        Self::with_period(size, size.map(even_smooth))
    }

    /// Convolutions of fields that repeat themselves after that many elements, which is even or one along each axis.
    pub fn wrapping(size: [usize; 2]) -> Self {
        Self::with_period(size, size)
    }

    fn with_period(size: [usize; 2], period: [usize; 2]) -> Self {
        let (mut real, mut complex) = (RealFftPlanner::new(), FftPlanner::new());
        Self {
            size,
            period,
            row_forward: real.plan_fft_forward(period[0]),
            row_inverse: real.plan_fft_inverse(period[0]),
            column_forward: complex.plan_fft_forward(period[1]),
            column_inverse: complex.plan_fft_inverse(period[1]),
            spare: Arc::default(),
        }
    }

    /// The same with the work space of another one: for convolutions that are applied in turn.
    pub fn sharing_space(self, other: &Self) -> Self {
        Self { spare: Arc::clone(&other.spare), ..self }
    }

    /// Points of the periodic grid along x and y.
    pub fn period(&self) -> [usize; 2] {
        self.period
    }

    /// Number of columns of a spectrum.
    fn columns(&self) -> usize {
        self.period[0] / 2 + 1
    }

    /// Convolves one field with one kernel, into `result`.
    pub fn apply(&self, spectrum: &Spectrum, field: &[f64], result: &mut [f64]) {
        self.apply_columns([field], [result], |column, spectra| {
            self.multiply(spectrum, column, spectra);
        });
    }

    /// Convolves `N` fields with a matrix of kernels: result i is the sum over j of kernel (i, j),
    /// with its sign, applied to field j.
    pub fn apply_matrix<const N: usize>(
        &self,
        kernels: [[(&Spectrum, f64); N]; N],
        fields: [&[f64]; N],
        results: [&mut [f64]; N],
    ) {
        self.apply_columns(fields, results, |column, spectra| {
            self.multiply_matrix(&kernels, column, spectra);
        });
    }

    /// Convolves two fields with a symmetric matrix of real spectra, (0, 1) of them odd along both
    /// axes, and takes from each result its own value one element upstream.
    pub fn apply_differenced(
        &self,
        kernels: [&Spectrum; 3],
        difference: &Difference,
        fields: [&[f64]; 2],
        results: [&mut [f64]; 2],
    ) {
        self.apply_columns(fields, results, |column, spectra| {
            self.multiply_pair(kernels, column, spectra);
            difference.multiply(column, self.period[1], spectra);
        });
    }

    /// Convolves two fields with a symmetric matrix of real spectra, (0, 1) of them odd along both
    /// axes.
    pub fn apply_pair(
        &self,
        kernels: [&Spectrum; 3],
        fields: [&[f64]; 2],
        results: [&mut [f64]; 2],
    ) {
        self.apply_columns(fields, results, |column, spectra| {
            self.multiply_pair(kernels, column, spectra);
        });
    }

    /// Transforms fields, lets `multiply` change their columns, and transforms them back.
    fn apply_columns<const N: usize>(
        &self,
        fields: [&[f64]; N],
        results: [&mut [f64]; N],
        multiply: impl Fn(usize, &mut [Complex64]) + Sync,
    ) {
        let mut space = self.take_space(N);
        let blocks = &mut space[..self.blocks_length(N)];
        for (component, field) in fields.into_iter().enumerate() {
            self.transform_rows(field, [component, N], blocks);
        }
        self.transform_columns(N, blocks, multiply);
        for (component, result) in results.into_iter().enumerate() {
            self.collect_rows(blocks, [component, N], result);
        }
        self.give_back(space);
    }

    fn block_length(&self) -> usize {
        LANES * self.size[1]
    }

    fn blocks_length(&self, components: usize) -> usize {
        components * self.columns().div_ceil(LANES) * self.block_length()
    }

    fn take_space(&self, components: usize) -> Vec<Complex64> {
        let mut space =
            std::mem::take(&mut *self.spare.lock().unwrap_or_else(PoisonError::into_inner));
        grow(&mut space, self.blocks_length(components));
        space
    }

    fn give_back(&self, space: Vec<Complex64>) {
        *self.spare.lock().unwrap_or_else(PoisonError::into_inner) = space;
    }

    /// Transforms the rows of a field, one of several components; rows of zeros cost nothing.
    fn transform_rows(
        &self,
        field: &[f64],
        [component, components]: [usize; 2],
        blocks: &mut [Complex64],
    ) {
        let nx = self.size[0];
        let block_length = self.block_length();
        let plan = &self.row_forward;
        let columns = self.columns();
        let lengths = [self.period[0], LANES * columns, plan.get_scratch_len()];
        // Some rows of every block.
        let mut stripes: Vec<Vec<&mut [Complex64]>> = vec![];
        stripes.resize_with(self.size[1].div_ceil(LANES), Vec::new);
        for block in blocks.chunks_mut(components * block_length) {
            let own = &mut block[component * block_length..][..block_length];
            let parts = own.chunks_mut(LANES * LANES);
            stripes.iter_mut().zip(parts).for_each(|(stripe, part)| stripe.push(part));
        }
        stripes.par_iter_mut().zip(field.par_chunks(LANES * nx)).for_each(|(stripe, rows)| {
            Buffers::lend(lengths, |padded, spectra, scratch| {
                for (spectrum, row) in spectra.chunks_mut(columns).zip(rows.chunks(nx)) {
                    if row.iter().all(|&value| value == 0.0) {
                        spectrum.fill(Complex64::default());
                        continue;
                    }
                    padded[..nx].copy_from_slice(row);
                    padded[nx..].fill(0.0);
                    plan.process_with_scratch(padded, spectrum, scratch)
                        .expect("buffers of the planned length");
                }
                for (block, part) in stripe.iter_mut().enumerate() {
                    let rows = part.as_chunks_mut::<LANES>().0.iter_mut();
                    for (to, spectrum) in rows.zip(spectra.chunks(columns)) {
                        let from = &spectrum[block * LANES..];
                        match from.first_chunk::<LANES>() {
                            Some(from) => *to = *from,
                            None => to[..from.len()].copy_from_slice(from),
                        }
                    }
                }
            });
        });
    }

    /// Transforms blocks of columns, lets `multiply` change them and transforms the rows of the field back. The spectra
    /// handed to `multiply` hold the components' columns one after the other.
    fn transform_columns(
        &self,
        components: usize,
        blocks: &mut [Complex64],
        multiply: impl Fn(usize, &mut [Complex64]) + Sync,
    ) {
        let ([_, ny], [_, my]) = (self.size, self.period);
        let (columns, block_length) = (self.columns(), self.block_length());
        let (forward, inverse) = (&self.column_forward, &self.column_inverse);
        let scratch_length =
            forward.get_inplace_scratch_len().max(inverse.get_inplace_scratch_len());
        let transform_block = |first: usize,
                               block: &mut [Complex64],
                               spectra: &mut [Complex64],
                               scratch: &mut [Complex64]| {
            let width = LANES.min(columns - first);
            let spectra = &mut spectra[..width * components * my];
            for (component, own) in block.chunks(block_length).enumerate() {
                for (row, values) in own.chunks(LANES * LANES).enumerate() {
                    for place in 0..width {
                        let column = &mut spectra[(place * components + component) * my..];
                        let column = &mut column[row * LANES..][..values.len() / LANES];
                        for (to, from) in column.iter_mut().zip(values.as_chunks::<LANES>().0) {
                            *to = from[place];
                        }
                    }
                }
            }
            spectra.chunks_mut(my).for_each(|column| column[ny..].fill(Complex64::default()));
            forward.process_with_scratch(spectra, scratch);
            for (column, spectra) in spectra.chunks_mut(components * my).enumerate() {
                multiply(first + column, spectra);
            }
            inverse.process_with_scratch(spectra, scratch);
            for (component, own) in block.chunks_mut(block_length).enumerate() {
                for (row, values) in own.chunks_mut(LANES * LANES).enumerate() {
                    for place in 0..width {
                        let column = &spectra[(place * components + component) * my..];
                        let column = &column[row * LANES..];
                        for (to, from) in values.as_chunks_mut::<LANES>().0.iter_mut().zip(column) {
                            to[place] = *from;
                        }
                    }
                }
            }
        };
        let lengths = [0, LANES * components * my, scratch_length];
        blocks.par_chunks_mut(components * block_length).enumerate().for_each(|(index, block)| {
            Buffers::lend(lengths, |_, spectra, scratch| {
                transform_block(index * LANES, block, spectra, scratch)
            });
        });
    }

    /// Transforms the rows of one of several components back.
    fn collect_rows(
        &self,
        blocks: &[Complex64],
        [component, components]: [usize; 2],
        result: &mut [f64],
    ) {
        let nx = self.size[0];
        let (columns, block_length) = (self.columns(), self.block_length());
        let plan = &self.row_inverse;
        let lengths = [self.period[0], LANES * columns, plan.get_scratch_len()];
        let own = |block: usize| &blocks[(block * components + component) * block_length..];
        result.par_chunks_mut(LANES * nx).enumerate().for_each(|(stripe, out)| {
            Buffers::lend(lengths, |values, spectra, scratch| {
                for block in 0..columns.div_ceil(LANES) {
                    let rows = own(block)[stripe * LANES * LANES..].as_chunks::<LANES>().0;
                    let rows = rows.iter().take(out.len() / nx);
                    for (from, spectrum) in rows.zip(spectra.chunks_mut(columns)) {
                        let to = &mut spectrum[block * LANES..];
                        match to.first_chunk_mut::<LANES>() {
                            Some(to) => *to = *from,
                            None => to.copy_from_slice(&from[..to.len()]),
                        }
                    }
                }
                for (spectrum, out) in spectra.chunks_mut(columns).zip(out.chunks_mut(nx)) {
                    // Real by symmetry, up to rounding that the plan would refuse.
                    spectrum[0].im = 0.0;
                    spectrum[columns - 1].im = 0.0;
                    plan.process_with_scratch(spectrum, values, scratch)
                        .expect("buffers of the planned length");
                    out.copy_from_slice(&values[..nx]);
                }
            });
        });
    }

    /// Real factors of a column of a spectrum, from frequency zero to the highest.
    fn factors<'a>(&self, spectrum: &'a Spectrum, column: usize) -> &'a [f64] {
        let half = self.period[1] / 2 + 1;
        &spectrum.factors[column * half..][..half]
    }

    /// Multiplies a column by a kernel that is even along both axes, or odd along both.
    fn multiply(&self, spectrum: &Spectrum, column: usize, values: &mut [Complex64]) {
        let factors = self.factors(spectrum, column);
        let (low, high) = values.split_at_mut(factors.len());
        low.iter_mut().zip(factors).for_each(|(value, factor)| *value *= factor);
        let sign = spectrum.parity[1].sign();
        let mirrored = &factors[1..][..high.len()];
        high.iter_mut().rev().zip(mirrored).for_each(|(value, factor)| *value *= sign * factor);
    }

    /// Multiplies the columns of two fields by a symmetric matrix of kernels, the outer ones even along
    /// both axes and the middle one odd along both.
    fn multiply_pair(&self, kernels: [&Spectrum; 3], column: usize, values: &mut [Complex64]) {
        let my = self.period[1];
        let [xx, xy, yy] = kernels.map(|spectrum| self.factors(spectrum, column));
        let (first, second) = values.split_at_mut(my);
        let turn = |x: &mut Complex64, y: &mut Complex64, [xx, xy, yy]: [f64; 3]| {
            (*x, *y) = (*x * xx + *y * xy, *x * xy + *y * yy);
        };
        for ky in 0..xx.len() {
            turn(&mut first[ky], &mut second[ky], [xx[ky], xy[ky], yy[ky]]);
        }
        for ky in xx.len()..my {
            let mirror = my - ky;
            turn(&mut first[ky], &mut second[ky], [xx[mirror], -xy[mirror], yy[mirror]]);
        }
    }

    /// Multiplies the columns of several fields by a matrix of kernels.
    fn multiply_matrix<const N: usize>(
        &self,
        kernels: &[[(&Spectrum, f64); N]; N],
        column: usize,
        values: &mut [Complex64],
    ) {
        let my = self.period[1];
        let factors = kernels.map(|row| {
            row.map(|(spectrum, sign)| (self.factors(spectrum, column), spectrum, sign))
        });
        for ky in 0..my {
            let (mirrored, reversed) = if ky > my / 2 { (my - ky, true) } else { (ky, false) };
            let field: [Complex64; N] = std::array::from_fn(|j| values[j * my + ky]);
            for (i, row) in factors.iter().enumerate() {
                let mut sum = Complex64::default();
                for ((factors, spectrum, sign), value) in row.iter().zip(field) {
                    let side = if reversed { spectrum.parity[1].sign() } else { 1.0 };
                    let factor = sign * side * factors[mirrored];
                    sum += if spectrum.is_imaginary() {
                        Complex64::new(-factor * value.im, factor * value.re)
                    } else {
                        factor * value
                    };
                }
                values[i * my + ky] = sum;
            }
        }
    }
}

/// The smallest even number of prime factors 2, 3 and 5 that is not below `n`.
pub fn even_smooth(n: usize) -> usize {
    let smooth = |mut n: usize| {
        for prime in [2, 3, 5] {
            while n.is_multiple_of(prime) {
                n /= prime;
            }
        }
        n == 1
    };
    (n.max(2)..).find(|&n| n.is_multiple_of(2) && smooth(n)).unwrap_or(n)
}
