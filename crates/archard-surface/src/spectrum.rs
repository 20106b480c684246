//! The power spectrum of a map: which wavelengths its height, slope and curvature are made of.
//!
//! C(f) = dx dy/(nx ny <w^2>) |sum w (z - mean) exp(-2 pi i f r)|^2 (m^4) over spatial frequencies f (1/m), the inverse of
//! wavelengths, with the window w. Its integral over all frequencies, negative ones too, is the mean square of w (z - mean) over that of w: Sq^2
//! without a window. In the wave vector q = 2 pi f it is the C of T. D. B. Jacobs, T. Junge and L. Pastewka (*Surf. Topogr.: Metrol.
//! Prop.* 5 (2017) 013001), whose integral has a factor 1/(2 pi)^2. Multiplied by (2 pi f)^2 it gives the mean square slope.

use std::f64::consts::{PI, TAU};

use rustfft::FftPlanner;
use rustfft::num_complex::Complex;

use crate::filter::transposed;
use crate::map::{HeightMap, NoMap};

/// What heights are multiplied by along each axis, so that the jump from the last to the first does not count as roughness.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Window {
    /// Nothing: of maps that repeat themselves.
    None,
    /// Half of 1 - cos, zero at both ends, of J. von Hann.
    Hann,
}

/// The power spectrum of a map.
#[derive(Debug, Clone, PartialEq)]
pub struct Spectrum {
    elements: [usize; 2],
    size: [f64; 2],
    /// C (m^4), frequencies along x first, in the order of the transform.
    density: Vec<f64>,
}

/// The waves of about one frequency.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mode {
    /// Their mean frequency (1/m).
    pub frequency: f64,
    /// Density: m^4 of all directions, m^3 along an axis.
    pub density: f64,
    /// How many waves it is the mean of.
    pub waves: usize,
}

/// How much of a map points of some distance do not resolve: waves shorter than two of them along x or y.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LostDetail {
    /// Their share of the mean square height.
    pub height: f64,
    /// Their share of the mean square slope.
    pub slope: f64,
    /// Their share of the mean square of the mean curvature.
    pub curvature: f64,
}

impl Spectrum {
    /// Of a map, whose holes are filled first.
    ///
    /// # Errors
    /// If no height is left.
    pub fn of(map: &HeightMap, window: Window) -> Result<Self, NoMap> {
        let map = map.filled()?;
        let [nx, ny] = map.elements();
        let mean = map.heights().iter().sum::<f64>() / map.heights().len() as f64;
        let weights = [nx, ny].map(|count| window.weights(count));
        let weighed = |(at, height): (usize, &f64)| {
            Complex::new(weights[0][at % nx] * weights[1][at / nx] * (height - mean), 0.0)
        };
        let mut field: Vec<Complex<f64>> = map.heights().iter().enumerate().map(weighed).collect();
        let mut planner = FftPlanner::new();
        planner.plan_fft_forward(nx).process(&mut field);
        let mut turned = transposed(&field, nx);
        drop(field);
        planner.plan_fft_forward(ny).process(&mut turned);
        let squares: Vec<f64> = turned.iter().map(Complex::norm_sqr).collect();
        let scale: f64 = (0..2)
            .map(|axis| map.pixel()[axis] / weights[axis].iter().map(|one| one * one).sum::<f64>())
            .product();
        let density = transposed(&squares, ny).into_iter().map(|one| one * scale).collect();
        Ok(Self { elements: map.elements(), size: map.size(), density })
    }

    /// C by the size of the frequency, the mean over all directions in rings as wide as the lowest frequency of the longer side; up to the
    /// highest that both axes have.
    pub fn radial(&self) -> Vec<Mode> {
        let step = 1.0 / self.size[0].max(self.size[1]);
        let highest = (0..2).map(|axis| 0.5 * self.elements[axis] as f64 / self.size[axis]);
        let rings = (highest.fold(f64::INFINITY, f64::min) / step) as usize;
        let mut sums = vec![Mode { frequency: 0.0, density: 0.0, waves: 0 }; rings + 1];
        for ([x, y], density) in self.waves() {
            let frequency = x.hypot(y);
            if let Some(sum) = sums.get_mut((frequency / step).round() as usize) {
                sum.frequency += frequency;
                sum.density += density;
                sum.waves += 1;
            }
        }
        let mean = |Mode { frequency, density, waves }: Mode| {
            let count = waves as f64;
            Mode { frequency: frequency / count, density: density / count, waves }
        };
        sums.into_iter().skip(1).filter(|sum| sum.waves > 0).map(mean).collect()
    }

    /// The spectrum of profiles along x (0) or y (1), the mean of all: m^3, whose integral over all frequencies, negative ones too, is that of C.
    /// Positive frequencies alone are listed.
    pub fn along(&self, axis: usize) -> Vec<Mode> {
        let count = self.elements[axis] / 2;
        let mut sums = vec![(0.0, 0); count + 1];
        for (at, density) in self.density.iter().enumerate() {
            let index = [at % self.elements[0], at / self.elements[0]][axis];
            let (sum, waves) = &mut sums[index.min(self.elements[axis] - index)];
            *sum += density / self.size[1 - axis];
            *waves += 1;
        }
        let mode = |(order, (sum, waves)): (usize, (f64, usize))| Mode {
            frequency: order as f64 / self.size[axis],
            // Both signs of a frequency go in, but of the highest of an even number of points.
            density: sum * self.elements[1 - axis] as f64 / waves as f64,
            waves,
        };
        sums.into_iter().enumerate().skip(1).map(mode).collect()
    }

    /// The mean square (m^2) of the heights.
    pub fn mean_square(&self) -> f64 {
        self.moment(0)
    }

    /// The root of the mean square slope.
    pub fn rms_gradient(&self) -> f64 {
        self.moment(2).sqrt()
    }

    /// The root of the mean square (1/m) of the mean curvature, half of d2z/dx2 + d2z/dy2.
    pub fn rms_curvature(&self) -> f64 {
        0.5 * self.moment(4).sqrt()
    }

    /// What points that far (m) apart do not resolve. Nothing is known of waves that the map does not have itself.
    pub fn unresolved(&self, spacing: f64) -> LostDetail {
        // Twice the spacing is the shortest wave that is told from a longer one.
        let highest = 0.5 / spacing * (1.0 + f64::EPSILON.sqrt());
        let share = |power: i32| {
            let beyond = |[x, y]: [f64; 2]| x.abs().max(y.abs()) > highest;
            let all = self.moment(power);
            if all > 0.0 { self.sum(power, beyond) / all } else { 0.0 }
        };
        LostDetail { height: share(0), slope: share(2), curvature: share(4) }
    }

    /// The integral of (2 pi f)^power C.
    fn moment(&self, power: i32) -> f64 {
        self.sum(power, |_| true)
    }

    fn sum(&self, power: i32, which: impl Fn([f64; 2]) -> bool) -> f64 {
        let waves = self.waves().filter(|(place, _)| which(*place));
        let parts = waves.map(|([x, y], density)| (TAU * x.hypot(y)).powi(power) * density);
        parts.sum::<f64>() / (self.size[0] * self.size[1])
    }

    /// Frequencies (1/m) along x and y with their density (m^4).
    fn waves(&self) -> impl Iterator<Item = ([f64; 2], f64)> {
        let [nx, ny] = self.elements;
        let signed = |index: usize, count: usize| {
            if 2 * index <= count { index as f64 } else { index as f64 - count as f64 }
        };
        self.density.iter().enumerate().map(move |(at, density)| {
            let place = [signed(at % nx, nx) / self.size[0], signed(at / nx, ny) / self.size[1]];
            (place, *density)
        })
    }
}

impl Window {
    /// At the middles of so many pixels.
    fn weights(self, count: usize) -> Vec<f64> {
        let weight = |index: usize| match self {
            Self::None => 1.0,
            Self::Hann => (PI * (index as f64 + 0.5) / count as f64).sin().powi(2),
        };
        (0..count).map(weight).collect()
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use approx::assert_relative_eq;
    use fastrand::Rng;

    use super::{Mode, Spectrum, Window};
    use crate::map::HeightMap;
    use crate::texture::Texture;

    const SIZE: [f64; 2] = [100e-6, 80e-6];

    /// Heights over places (m) from a corner, on 100 x 40 points.
    fn map(mut height: impl FnMut(f64, f64) -> f64) -> HeightMap {
        let pixel = [1e-6, 2e-6];
        let heights =
            (0..4000).map(|at| height(pixel[0] * (at % 100) as f64, pixel[1] * (at / 100) as f64));
        HeightMap::new([100, 40], pixel, heights.collect()).unwrap()
    }

    /// The integral over all frequencies is Sq^2 (Parseval), of an axis and of rings too.
    #[test]
    fn the_integral_is_the_mean_square() {
        let mut random = Rng::with_seed(3);
        let noise = map(|_, _| 1e-6 * random.f64());
        let spectrum = Spectrum::of(&noise, Window::None).unwrap();
        let square = Texture::of(&noise).rms.powi(2);
        assert_relative_eq!(spectrum.mean_square(), square, max_relative = 1e-12);
        // White noise spreads evenly to the Nyquist frequencies: C is Sq^2 dx dy. Sums of a thousand waves and more scatter by 3 %.
        for window in [Window::None, Window::Hann] {
            let radial = Spectrum::of(&noise, window).unwrap().radial();
            let many = radial.iter().fold((0.0, 0.0), |(sum, count), one| {
                (sum + one.density * one.waves as f64, count + one.waves as f64)
            });
            assert_relative_eq!(many.0 / many.1, square * 2e-12, max_relative = 0.15);
        }
        for (axis, size) in SIZE.into_iter().enumerate() {
            let along = spectrum.along(axis);
            let pixel = noise.pixel()[axis];
            let last = along.len() - 1;
            let both = along[..last].iter().map(|one| 2.0 * one.density).sum::<f64>();
            let rest = square - (both + along[last].density) / size;
            // What is left is the frequency zero along the axis, one of as many.
            assert!(rest > 0.0 && rest < square * 3.0 * pixel / size, "{rest} of {square}");
        }
    }

    /// A sine of amplitude a that fits the map has a^2/2 in one mode, with its slope and curvature; a window leaves their sum as it is.
    #[test]
    fn a_sine_is_one_mode() {
        let (a, k) = (2e-6, [5.0 / SIZE[0], 3.0 / SIZE[1]]);
        let wave = |x: f64, y: f64| a * (TAU * (k[0] * x + k[1] * y)).cos();
        let q = TAU * k[0].hypot(k[1]);
        let square = 0.5 * a * a;
        for (window, error) in [(Window::None, 1e-12), (Window::Hann, 0.1)] {
            let spectrum = Spectrum::of(&map(wave), window).unwrap();
            assert_relative_eq!(spectrum.mean_square(), square, max_relative = 1e-10);
            assert_relative_eq!(spectrum.rms_gradient(), q * square.sqrt(), max_relative = error);
            assert_relative_eq!(
                spectrum.rms_curvature(),
                0.5 * q * q * square.sqrt(),
                max_relative = error
            );
            for axis in 0..2 {
                let peak = |modes: &[Mode]| {
                    modes.iter().fold(modes[0], |most, one| {
                        if one.density > most.density { *one } else { most }
                    })
                };
                let found = peak(&spectrum.along(axis));
                assert_relative_eq!(found.frequency, k[axis], max_relative = 1e-12);
                let share = if window == Window::None { 1.0 } else { 2.0 / 3.0 };
                assert_relative_eq!(
                    found.density,
                    share * 0.5 * square * SIZE[axis],
                    max_relative = 1e-9
                );
            }
        }
    }

    /// Of two waves, points resolve those of more than two of their distances.
    #[test]
    fn points_do_not_resolve_short_waves() {
        let (long, short) = (TAU / 50e-6, TAU / 10e-6);
        let two = map(|x, y| (long * x).sin() + 0.1 * (short * x).sin() + 0.0 * y);
        let spectrum = Spectrum::of(&two, Window::None).unwrap();
        let left = spectrum.unresolved(8e-6);
        let share = |power: i32| {
            let (one, other) = (long.powi(power), 0.01 * short.powi(power));
            other / (one + other)
        };
        assert_relative_eq!(left.height, share(0), max_relative = 1e-9);
        assert_relative_eq!(left.slope, share(2), max_relative = 1e-9);
        assert_relative_eq!(left.curvature, share(4), max_relative = 1e-9);
        assert!(spectrum.unresolved(5e-6).slope < 1e-12);
        assert!(spectrum.unresolved(26e-6).height > 0.999);
        let across = map(|x, y| (TAU * y / 10e-6).sin() + 0.0 * x);
        assert!(Spectrum::of(&across, Window::None).unwrap().unresolved(8e-6).slope > 0.999);
    }
}
