//! Stresses below surfaces that repeat themselves: tractions are waves between the elements, and each wave has its own field.
//!
//! A wave of number k along l decays with depth as exp(-k z), z into the body. With d = k z and t across the wave, a pressure of 1 has
//!
//! ```text
//! ll = -(1 - d)   zz = -(1 + d)   tt = -2 nu   lz = i d
//! ```
//!
//! and a traction of 1 on the body along l, or along t,
//!
//! ```text
//! ll = i (2 - d)   zz = i d   tt = 2 nu i   lz = -(1 - d)        tz = -1   lt = i
//! ```
//!
//! times exp(-d) (K. L. Johnson, *Contact Mechanics*, 1985, section 13.2, for waves of pressure; the others by Airy's function z exp(-k z)).
//! The mean of the pressures is borne without strain along the surface.

use std::f64::consts::TAU;
use std::sync::OnceLock;

use rayon::prelude::*;
use realfft::num_complex::Complex64;
use rustfft::FftPlanner;

use super::Below;
use super::plane::parity;
use super::rest::components;
use crate::numerics::convolution::{Convolution, Parity, Spectrum};
use crate::stress::Components;

/// Waves that are summed up at once. A choice of effort.
const CHUNK: usize = 4096;

/// Tractions as waves.
pub(super) struct Waves {
    convolution: Convolution,
    all: OnceLock<Vec<Wave>>,
}

/// A wave of tractions.
struct Wave {
    /// Wave numbers (1/m) along x and y.
    k: [f64; 2],
    /// Along which axes it is the shortest there is, or none, so that what is odd vanishes.
    still: [bool; 2],
    /// Amplitudes (Pa) of tractions on the body along x and y, and into it.
    amplitudes: [Complex64; 3],
}

/// What a wave along a direction (cosine and sine) makes of a unit traction along x, y or into the body: the components, those times i
/// that are odd along one axis only. It goes `d` of its lengths over 2 pi into the body.
fn field(axis: usize, [c, s]: [f64; 2], d: f64, poisson: f64) -> Components {
    let n = poisson;
    let decay = (-d).exp();
    let own = match axis {
        0 => along([c, s], d, n),
        1 => {
            let [yy, xx, zz, xy, yz, xz] = along([s, c], d, n);
            [xx, yy, zz, xy, xz, yz]
        }
        _ => [
            -(c * c * (1.0 - d) + 2.0 * n * s * s),
            -(s * s * (1.0 - d) + 2.0 * n * c * c),
            -(1.0 + d),
            -c * s * (1.0 - d - 2.0 * n),
            c * d,
            s * d,
        ],
    };
    own.map(|value| value * decay)
}

/// The same of a traction along x, without the decay.
fn along([c, s]: [f64; 2], d: f64, n: f64) -> Components {
    [
        c * (c * c * (2.0 - d) + 2.0 * s * s * (1.0 + n)),
        c * (2.0 * n * c * c - s * s * d),
        c * d,
        s * (c * c * (1.0 - d - 2.0 * n) + s * s),
        -(c * c * (1.0 - d) + s * s),
        c * s * d,
    ]
}

/// What the mean of a traction makes.
fn even(axis: usize, poisson: f64) -> Components {
    let aside = -poisson / (1.0 - poisson);
    match axis {
        0 => [0.0, 0.0, 0.0, 0.0, -1.0, 0.0],
        1 => [0.0, 0.0, 0.0, 0.0, 0.0, -1.0],
        _ => [aside, aside, -1.0, 0.0, 0.0, 0.0],
    }
}

/// What a wave of these numbers (1/m) makes, `z` (m) deep.
fn of_wave(below: &Below, axis: usize, [x, y]: [f64; 2], z: f64) -> Components {
    let (k, poisson) = (x.hypot(y), below.material(z).poisson);
    if k == 0.0 {
        return even(axis, poisson);
    }
    let [c, s] = [x / k, y / k];
    match below.piece(z) {
        None => field(axis, [c, s], k * z, poisson),
        Some((layers, piece)) => {
            let functions = [1.0, c * c, c * s, c, s, c * s * s, s * c * c];
            components(functions, &layers.wave(piece, z, k))[axis]
        }
    }
}

/// Whether what a component is under a traction along an axis is odd along x and along y.
fn odd(component: usize, axis: usize) -> [bool; 2] {
    parity(component, axis, false).map(|parity| parity == Parity::Odd)
}

impl Waves {
    /// Of a number of elements that is even or one along each axis.
    pub fn on(elements: [usize; 2]) -> Self {
        Self { convolution: Convolution::wrapping(elements), all: OnceLock::new() }
    }

    pub fn convolution(&self) -> &Convolution {
        &self.convolution
    }

    /// The spectrum of a component under tractions along an axis.
    pub fn kernel(&self, below: &Below, (axis, component): (usize, usize), depth: f64) -> Spectrum {
        let size = below.size();
        self.convolution.transfer(parity(component, axis, false), |waves| {
            let k = [0, 1].map(|axis| TAU * waves[axis] as f64 / size[axis]);
            of_wave(below, axis, k, depth)[component]
        })
    }

    /// The stress (Pa) at a place, in axes with z into the body.
    pub fn stress(&self, below: &Below, at: [f64; 2], z: f64) -> Components {
        let first = below.place(0);
        let from = [0, 1].map(|axis| at[axis] - first[axis]);
        let part = |waves: &[Wave]| {
            let mut sum = [0.0; 6];
            for wave in waves {
                wave.add(below, (from, z), &mut sum);
            }
            sum
        };
        let all = self.all.get_or_init(|| waves(below));
        // Summed up in the same order on any number of threads.
        let parts: Vec<Components> = all.par_chunks(CHUNK).map(part).collect();
        let mut sum = [0.0; 6];
        parts.iter().for_each(|part| sum.iter_mut().zip(part).for_each(|(sum, own)| *sum += own));
        sum
    }
}

impl Wave {
    /// Adds the stress (Pa) of the wave at a place along x and y, so deep (m).
    fn add(&self, below: &Below, (from, z): ([f64; 2], f64), sum: &mut Components) {
        let Self { k, still, amplitudes } = self;
        // What is left of it is rounded off.
        if k[0].hypot(k[1]) * z > -f64::EPSILON.ln() {
            return;
        }
        let phase = Complex64::cis(k[0] * from[0] + k[1] * from[1]);
        let none = Complex64::ZERO;
        for (axis, amplitude) in amplitudes.iter().enumerate().filter(|(_, own)| **own != none) {
            let turned = amplitude * phase;
            let own = of_wave(below, axis, *k, z);
            for (component, (sum, own)) in sum.iter_mut().zip(own).enumerate() {
                let odd = odd(component, axis);
                if (0..2).any(|axis| odd[axis] && still[axis]) {
                    continue;
                }
                *sum += own * if odd[0] == odd[1] { turned.re } else { -turned.im };
            }
        }
    }
}

/// The waves of tractions; those that are another one's mirror image count with it.
fn waves(below: &Below) -> Vec<Wave> {
    let [nx, ny] = below.elements;
    let mut planner = FftPlanner::new();
    let (rows, columns) = (planner.plan_fft_forward(nx), planner.plan_fft_forward(ny));
    let scale = 1.0 / (nx * ny) as f64;
    // Column by column.
    let transformed = below.tractions.each_ref().map(|traction| {
        let mut field: Vec<Complex64> =
            traction.iter().map(|value| Complex64::new(scale * value, 0.0)).collect();
        rows.process(&mut field);
        let mut turned: Vec<Complex64> =
            (0..nx * ny).map(|index| field[index / ny + nx * (index % ny)]).collect();
        columns.process(&mut turned);
        turned
    });
    let size = below.size();
    // A number of waves up to half of the elements; beyond, those that run the other way.
    let signed = |index: usize, count: usize| match 2 * index > count {
        true => index as f64 - count as f64,
        false => index as f64,
    };
    let wave = |index: usize| {
        let (i, j) = (index / ny, index % ny);
        let alone = (2 * i).is_multiple_of(nx);
        let count = if alone { 1.0 } else { 2.0 };
        Wave {
            k: [TAU * signed(i, nx) / size[0], TAU * signed(j, ny) / size[1]],
            still: [alone, (2 * j).is_multiple_of(ny)],
            amplitudes: transformed.each_ref().map(|transformed| count * transformed[index]),
        }
    };
    (0..(nx / 2 + 1) * ny).map(wave).collect()
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use approx::assert_relative_eq;

    use super::Below;
    use crate::Material;
    use crate::frame::{ContactFrame, Rectangle, VectorField};

    const SIZE: [f64; 2] = [1e-3, 0.5e-3];
    const ELEMENTS: [usize; 2] = [32, 16];

    /// Below tractions (Pa) on the body along x and y and a pressure, functions of the place (m).
    fn below(tractions: impl Fn([f64; 2]) -> [f64; 3]) -> Below {
        let corner = [0, 1].map(|axis| -0.5 * SIZE[axis]);
        let rectangle = Rectangle { centre: [0.0; 2], size: SIZE };
        let flat = &crate::body::profile::Flat;
        let frame = ContactFrame::uniform(rectangle, ELEMENTS, [flat, flat]).unwrap();
        let spacing = frame.spacing();
        let mut field = VectorField::zeros(frame.len());
        for pair in 0..frame.len() {
            let at = [pair % ELEMENTS[0], pair / ELEMENTS[0]];
            let place = [0, 1].map(|axis| corner[axis] + spacing[axis] * (at[axis] as f64 + 0.5));
            let [x, y, p] = tractions(place);
            (field.t1[pair], field.t2[pair], field.n[pair]) = (x, y, -p);
        }
        let steel = Material::new(210e9, 0.3).unwrap();
        Below::new(&steel, &frame, &field, 1e-2).unwrap()
    }

    /// The stresses are in balance, meet the tractions on the surface, and are those of Hooke's law with strains that fit together: the
    /// trace is harmonic, and the laplacian of each component is minus its second derivative over 1 + nu (Beltrami and Michell).
    #[test]
    fn waves_are_fields_of_an_elastic_body() {
        let [p, q] = [TAU * 2.0 / SIZE[0], TAU / SIZE[1]];
        let tractions = |[x, y]: [f64; 2]| {
            let [one, other] = [(p * x + q * y + 0.3).cos(), (p * x - q * y).sin()];
            [2e6 * one + 1e6, 1.5e6 * other - 0.5e6, 5e6 + 3e6 * other + 2e6 * one]
        };
        let below = below(tractions).repeated();
        let h = 5e-7;
        let stress = |[x, y, z]: [f64; 3]| below.stress([x, y, z]);
        for place in [[0.1e-3, 0.07e-3, -0.05e-3], [-0.2e-3, 0.11e-3, -0.09e-3]] {
            let moved = |axis: usize, by: f64| {
                let mut moved = place;
                moved[axis] += by;
                stress(moved)
            };
            let slope =
                |axis: usize, c: usize| (moved(axis, h)[c] - moved(axis, -h)[c]) / (2.0 * h);
            for [x, y, z] in [[0, 3, 4], [3, 1, 5], [4, 5, 2]] {
                let sum = slope(0, x) + slope(1, y) + slope(2, z);
                let size = slope(0, x).abs() + slope(1, y).abs() + slope(2, z).abs();
                assert!(sum.abs() < 1e-4 * size, "{sum} {size}");
            }
            let here = stress(place);
            let second = |axis: usize, of: &dyn Fn([f64; 6]) -> f64| {
                (of(moved(axis, h)) + of(moved(axis, -h)) - 2.0 * of(here)) / (h * h)
            };
            let trace = |s: [f64; 6]| s[0] + s[1] + s[2];
            let laplacian =
                |of: &dyn Fn([f64; 6]) -> f64| (0..3).map(|axis| second(axis, of)).sum::<f64>();
            let size = (0..3).map(|axis| second(axis, &trace).abs()).sum::<f64>();
            assert!(laplacian(&trace).abs() < 1e-3 * size, "{} {size}", laplacian(&trace));
            for c in 0..3 {
                let own = laplacian(&|s| s[c]) + second(c, &trace) / 1.3;
                assert!(own.abs() < 1e-3 * size, "{c}: {own} {size}");
            }
        }
        // On the surface, at the centre of an element.
        let element = 5 + ELEMENTS[0] * 3;
        let [x, y] = below.place(element);
        let [along, across, pressure] = tractions([x, y]);
        let [_, _, zz, _, xz, yz] = stress([x, y, 0.0]);
        assert_relative_eq!(zz, -pressure, max_relative = 1e-9);
        assert_relative_eq!(xz, along, max_relative = 1e-9);
        assert_relative_eq!(yz, across, max_relative = 1e-9);
        // A plane is what its points are.
        let plane = below.plane(0.04e-3);
        let known = stress([x, y, -0.04e-3]);
        for (plane, known) in plane.iter().zip(known) {
            assert_relative_eq!(plane[element], known, max_relative = 1e-9, epsilon = 1e-3);
        }
    }

    /// A contact in the middle of a frame much wider than it has the stresses of one that stands alone, but for the even part.
    #[test]
    fn a_small_spot_has_the_stresses_of_a_half_space() {
        let spot = |[x, y]: [f64; 2]| {
            let left = 1.0 - (x * x + y * y) / (0.09e-3f64).powi(2);
            let pressure = 1e9 * left.max(0.0);
            [0.2 * pressure, -0.1 * pressure, pressure]
        };
        let [repeated, alone] = [below(spot).repeated(), below(spot)];
        let peak = 1e9;
        for place in [[0.0, 0.0, -0.06e-3], [0.03e-3, -0.02e-3, -0.05e-3]] {
            let [one, other] = [&repeated, &alone].map(|below| below.stress(place));
            for (one, other) in one.iter().zip(other) {
                assert!((one - other).abs() < 0.05 * peak, "{one} {other}");
            }
        }
    }
}
