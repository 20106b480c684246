//! The yardstick: a real Fourier transform of a square grid and back, nothing skipped.

use std::sync::{Arc, Mutex};
use std::time::Instant;

use rayon::prelude::*;
use realfft::{ComplexToReal, RealFftPlanner, RealToComplex, num_complex::Complex64};
use rustfft::{Fft, FftPlanner};

/// Columns transformed together, to read whole cache lines.
const BLOCK: usize = 8;

/// Plans and buffers of one grid.
pub struct RoundTrip {
    n: usize,
    forward: Arc<dyn RealToComplex<f64>>,
    inverse: Arc<dyn ComplexToReal<f64>>,
    column_forward: Arc<dyn Fft<f64>>,
    column_inverse: Arc<dyn Fft<f64>>,
    buffers: Mutex<Buffers>,
}

/// Values by rows; spectra by rows, then by blocks of columns.
struct Buffers {
    values: Vec<f64>,
    rows: Vec<Complex64>,
    spectrum: Vec<Complex64>,
    result: Vec<Complex64>,
}

impl RoundTrip {
    /// Round trips of n x n points.
    pub fn new(n: usize) -> Self {
        let (mut real, mut complex) = (RealFftPlanner::new(), FftPlanner::new());
        let columns = n / 2 + 1;
        let blocks = vec![Complex64::default(); columns.next_multiple_of(BLOCK) * n];
        Self {
            n,
            forward: real.plan_fft_forward(n),
            inverse: real.plan_fft_inverse(n),
            column_forward: complex.plan_fft_forward(n),
            column_inverse: complex.plan_fft_inverse(n),
            buffers: Mutex::new(Buffers {
                values: (0..n * n).map(|i| (i as f64).sin()).collect(),
                rows: vec![Complex64::default(); columns * n],
                spectrum: blocks.clone(),
                result: blocks,
            }),
        }
    }

    /// Seconds a round trip takes: the best of several.
    pub fn seconds(&self) -> f64 {
        rayon::scope(|_| self.best_of_several())
    }

    fn best_of_several(&self) -> f64 {
        let mut buffers = self.buffers.lock().expect("no thread has failed");
        let Buffers { values, rows, spectrum, result } = &mut *buffers;
        let width = self.n / 2 + 1;
        let mut best = f64::INFINITY;
        for _ in 0..5 {
            let start = Instant::now();
            self.rows_there(values, rows);
            let rows: &[Complex64] = rows;
            self.columns(&self.column_forward, spectrum, |block, row| {
                &rows[row * width + block * BLOCK..(row + 1) * width]
            });
            let spectrum: &[Complex64] = spectrum;
            self.columns(&self.column_inverse, result, |block, row| {
                &spectrum[(block * self.n + row) * BLOCK..][..BLOCK]
            });
            self.rows_back(result, values);
            best = best.min(start.elapsed().as_secs_f64());
            let scale = 1.0 / (self.n * self.n) as f64;
            values.iter_mut().for_each(|value| *value *= scale);
        }
        best
    }

    fn rows_there(&self, values: &mut [f64], rows: &mut [Complex64]) {
        values.par_chunks_mut(self.n).zip(rows.par_chunks_mut(self.n / 2 + 1)).for_each_init(
            || self.forward.make_scratch_vec(),
            |scratch, (row, out)| {
                self.forward.process_with_scratch(row, out, scratch).expect("lengths match")
            },
        );
    }

    /// Transforms all columns, block by block, into a layout of blocks of rows.
    fn columns<'a>(
        &self,
        plan: &Arc<dyn Fft<f64>>,
        result: &mut [Complex64],
        row_of: impl Fn(usize, usize) -> &'a [Complex64] + Sync,
    ) {
        let (n, width) = (self.n, self.n / 2 + 1);
        let zero = Complex64::default();
        result.par_chunks_mut(BLOCK * n).enumerate().for_each_init(
            || (vec![zero; BLOCK * n], vec![zero; plan.get_inplace_scratch_len()]),
            |(columns, scratch), (block, out)| {
                let count = BLOCK.min(width - block * BLOCK);
                for row in 0..n {
                    for (column, value) in row_of(block, row)[..count].iter().enumerate() {
                        columns[column * n + row] = *value;
                    }
                }
                plan.process_with_scratch(&mut columns[..count * n], scratch);
                for (row, values) in out.chunks_mut(BLOCK).enumerate() {
                    for (column, value) in values[..count].iter_mut().enumerate() {
                        *value = columns[column * n + row];
                    }
                }
            },
        );
    }

    fn rows_back(&self, blocks: &[Complex64], values: &mut [f64]) {
        let (n, width) = (self.n, self.n / 2 + 1);
        values.par_chunks_mut(n).enumerate().for_each_init(
            || (self.inverse.make_input_vec(), self.inverse.make_scratch_vec()),
            |(spectrum, scratch), (row, out)| {
                for (block, part) in spectrum.chunks_mut(BLOCK).enumerate() {
                    part.copy_from_slice(&blocks[(block * n + row) * BLOCK..][..part.len()]);
                }
                spectrum[0].im = 0.0;
                spectrum[width - 1].im = 0.0;
                self.inverse.process_with_scratch(spectrum, out, scratch).expect("lengths match");
            },
        );
    }
}
