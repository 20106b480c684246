//! Fourier transforms of maps.

use std::sync::Arc;

use rustfft::num_complex::Complex;
use rustfft::{Fft, FftPlanner};

use crate::filter::transposed;

/// The transforms of maps of one size.
pub(super) struct Fourier {
    size: [usize; 2],
    /// Forward along x and y, and back.
    plans: [[Arc<dyn Fft<f64>>; 2]; 2],
}

impl Fourier {
    /// For maps of at least so many points along x and y: sizes with small factors are quick.
    pub(super) fn at_least(size: [usize; 2]) -> Self {
        let size = size.map(|least| (least..).find(|&size| is_smooth(size)).unwrap_or(least));
        let mut planner = FftPlanner::new();
        let plans = [
            size.map(|size| planner.plan_fft_forward(size)),
            size.map(|size| planner.plan_fft_inverse(size)),
        ];
        Self { size, plans }
    }

    /// Points along x and y.
    pub(super) fn size(&self) -> [usize; 2] {
        self.size
    }

    /// The transform of the values of a smaller map, zero beyond it.
    pub(super) fn of<T: Copy + Into<Complex<f64>>>(
        &self,
        elements: [usize; 2],
        values: &[T],
    ) -> Vec<Complex<f64>> {
        let mut padded = vec![Complex::default(); self.size[0] * self.size[1]];
        for (row, line) in values.chunks_exact(elements[0]).enumerate() {
            for (place, value) in padded[row * self.size[0]..].iter_mut().zip(line) {
                *place = (*value).into();
            }
        }
        self.apply(0, padded)
    }

    /// The map of a transform.
    pub(super) fn back(&self, transform: Vec<Complex<f64>>) -> Vec<Complex<f64>> {
        let mut values = self.apply(1, transform);
        let scale = 1.0 / values.len() as f64;
        values.iter_mut().for_each(|value| *value *= scale);
        values
    }

    /// Lags along x and y (points) of a place in a correlation: those beyond the middle are negative.
    pub(super) fn lag(&self, at: usize) -> [isize; 2] {
        let signed = |index: usize, size: usize| {
            if index > size / 2 { index as isize - size as isize } else { index as isize }
        };
        [signed(at % self.size[0], self.size[0]), signed(at / self.size[0], self.size[1])]
    }

    fn apply(&self, way: usize, mut values: Vec<Complex<f64>>) -> Vec<Complex<f64>> {
        let [along_x, along_y] = &self.plans[way];
        along_x.process(&mut values);
        let mut turned = transposed(&values, self.size[0]);
        along_y.process(&mut turned);
        transposed(&turned, self.size[1])
    }
}

/// Whether a number has no other prime factors than 2, 3 and 5.
fn is_smooth(mut number: usize) -> bool {
    for factor in [2, 3, 5] {
        while number > 1 && number.is_multiple_of(factor) {
            number /= factor;
        }
    }
    number == 1
}

#[cfg(test)]
mod tests {
    use super::Fourier;
    use rustfft::num_complex::Complex;

    /// One point moved by (2, 1) correlates with the one at the origin at that lag.
    #[test]
    fn a_correlation_has_its_peak_at_the_shift() {
        let fourier = Fourier::at_least([14, 7]);
        assert_eq!(fourier.size(), [15, 8]);
        let point = |x: usize, y: usize| {
            let mut map = vec![0.0; 7 * 4];
            map[x + 7 * y] = 3.0;
            fourier.of([7, 4], &map)
        };
        let product = |(one, other): (&Complex<f64>, &Complex<f64>)| one.conj() * other;
        let found = fourier.back(point(1, 2).iter().zip(&point(3, 3)).map(product).collect());
        for (at, value) in found.iter().enumerate() {
            let wanted = if fourier.lag(at) == [2, 1] { 9.0 } else { 0.0 };
            assert!((value - wanted).norm() < 1e-12, "{at} {value}");
        }
    }
}
