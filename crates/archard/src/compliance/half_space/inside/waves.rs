//! Stresses and displacements below surfaces that repeat themselves: tractions are waves between the elements, and each wave has its own
//! field, that of a half-space or of [layers](super::layers).
//!
//! The mean of the pressures is borne without strain along the surface; it squeezes, and the mean of friction shears, what lies between a
//! place and the depth that displacements are measured from.

use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use rayon::prelude::*;
use realfft::num_complex::Complex64;
use rustfft::FftPlanner;

use super::Below;
use super::layers::half_space;
use super::plane::{odd, parity};
use super::rest::{Rest, components, displacements};
use super::sums::Sums;
use crate::numerics::convolution::{Convolution, Spectrum};
use crate::stress::Components;

/// Depths whose waves are kept: a place and those above and below it. A choice of memory.
const KEPT: usize = 3;
/// Components of the stress and the displacement.
const ALL: usize = 9;

/// Tractions as waves.
pub(super) struct Waves {
    convolution: Convolution,
    /// How far below the contact (m) displacements are measured from.
    depth: f64,
    /// Column by column.
    all: OnceLock<Vec<Wave>>,
    kept: Mutex<Vec<Arc<Depth>>>,
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

/// The waves that reach a depth.
struct Depth {
    /// The piece that is asked about, and the depth (m).
    at: (Option<usize>, f64),
    /// Wave numbers (1/m) of the columns and of the rows.
    k: [Vec<f64>; 2],
    /// Amplitudes of the stress (Pa) and of the displacement times twice the shear modulus (N/m), column by column.
    amplitudes: Vec<[Complex64; ALL]>,
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

/// What a wave of these numbers (1/m) makes `z` (m) deep of unit tractions along each axis: what is odd along one axis only is times i.
fn of_wave(below: &Below, [x, y]: [f64; 2], z: f64) -> Rest {
    let (k, poisson) = (x.hypot(y), below.material(z).poisson);
    if k == 0.0 {
        return ([0, 1, 2].map(|axis| even(axis, poisson)), Default::default());
    }
    let [c, s] = [x / k, y / k];
    let (stress, moved) = match below.piece(z) {
        None => half_space(z, poisson).wave(k),
        Some((layers, piece)) => layers.wave(piece, z, k),
    };
    let along = [c * c, s * s, c * s, c, s];
    let functions = [1.0, c * c, c * s, c, s, c * s * s, s * c * c];
    (components(functions, &stress), displacements(along, &moved))
}

impl Waves {
    /// Of a number of elements that is even or one along each axis; displacements are measured from so far (m) below the contact.
    pub fn on(elements: [usize; 2], depth: f64) -> Self {
        let convolution = Convolution::wrapping(elements);
        Self { convolution, depth, all: OnceLock::new(), kept: Mutex::default() }
    }

    /// How far below the contact (m) displacements are measured from.
    pub fn depth(&self) -> f64 {
        self.depth
    }

    pub fn convolution(&self) -> &Convolution {
        &self.convolution
    }

    /// The spectra of components under tractions along axes, at a depth (m).
    pub fn kernels(&self, below: &Below, wanted: &[[usize; 2]], depth: f64) -> Vec<Spectrum> {
        let (size, [columns, rows]) = (below.size(), below.elements.map(|count| count / 2 + 1));
        let wave = |index: usize| {
            let waves = [index % columns, index / columns];
            let k = [0, 1].map(|axis| TAU * waves[axis] as f64 / size[axis]);
            of_wave(below, k, depth).0
        };
        let all: Vec<[Components; 3]> = (0..columns * rows).into_par_iter().map(wave).collect();
        let kernel = |&[axis, component]: &[usize; 2]| {
            self.convolution.transfer(parity(component, axis, false), |waves| {
                all[waves[0] + columns * waves[1]][axis][component]
            })
        };
        wanted.iter().map(kernel).collect()
    }

    /// Stress (Pa), and displacement times twice the shear modulus (N/m), at places along x and y (m) of that depth (m), in axes with z
    /// into the body.
    pub fn at(&self, below: &Below, places: &[[f64; 2]], z: f64) -> Vec<Sums> {
        let first = below.place(0);
        let waves = self.waves_at(below, z);
        let mut groups: [BTreeMap<u64, Vec<usize>>; 2] = Default::default();
        for (index, place) in places.iter().enumerate() {
            for axis in 0..2 {
                groups[axis].entry(place[axis].to_bits()).or_default().push(index);
            }
        }
        // Waves are summed up along one axis once for all places in line along the other one.
        let axis = usize::from(groups[1].len() <= groups[0].len());
        let lines: Vec<&Vec<usize>> = groups[axis].values().collect();
        let line = |indices: &&Vec<usize>| -> Vec<(usize, Sums)> {
            let from = places[indices[0]][axis] - first[axis];
            let summed = waves.along(axis, from);
            let at = |&index: &usize| {
                let from = places[index][1 - axis] - first[1 - axis];
                (index, waves.across(1 - axis, &summed, from))
            };
            indices.par_iter().map(at).collect()
        };
        let mean = self.mean(below, z);
        let mut found = vec![Sums::default(); places.len()];
        for (index, (stress, moved)) in lines.par_iter().flat_map(line).collect::<Vec<_>>() {
            found[index] = (stress, std::array::from_fn(|axis| moved[axis] + mean[axis]));
        }
        found
    }

    /// What means of tractions displace a depth (m) by, times twice the shear modulus there (N/m).
    fn mean(&self, below: &Below, z: f64) -> [f64; 3] {
        let all = self.all(below);
        let materials = below.pieces().into_iter().enumerate().map(|(index, ends)| {
            let layers = below.layers.as_ref();
            (layers.map_or(below.material, |layers| layers.material(index)), ends)
        });
        let [sheared, squeezed] = materials.fold([0.0; 2], |sum, (material, [top, end])| {
            let thickness = match end.is_finite() {
                true => (end - top.max(z)).max(0.0),
                false => (self.depth - top).max(0.0) - (z - top).max(0.0),
            };
            let (own, poisson) = (thickness / material.shear_modulus(), material.poisson);
            [sum[0] + own, sum[1] + 0.5 * (1.0 - 2.0 * poisson) / (1.0 - poisson) * own]
        });
        let scale = 2.0 * below.material(z).shear_modulus();
        let mean = all[0].amplitudes.map(|own| scale * own.re);
        [sheared * mean[0], sheared * mean[1], squeezed * mean[2]]
    }

    fn all(&self, below: &Below) -> &[Wave] {
        self.all.get_or_init(|| waves(below))
    }

    /// The waves at a depth (m).
    fn waves_at(&self, below: &Below, z: f64) -> Arc<Depth> {
        let kept = || self.kept.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(known) = kept().iter().find(|own| own.at == (below.piece, z)) {
            return known.clone();
        }
        let made = Arc::new(Depth::of(self.all(below), below, z));
        let mut kept = kept();
        if kept.len() >= KEPT {
            kept.remove(0);
        }
        kept.push(made.clone());
        made
    }
}

impl Depth {
    fn of(all: &[Wave], below: &Below, z: f64) -> Self {
        let ny = below.elements[1];
        // What is left of the others is rounded off.
        let reaches = |k: f64| k.abs() * z <= -f64::EPSILON.ln();
        let columns: Vec<usize> =
            (0..all.len() / ny).filter(|column| reaches(all[column * ny].k[0])).collect();
        let rows: Vec<usize> = (0..ny).filter(|row| reaches(all[*row].k[1])).collect();
        let amplitudes = |index: usize| {
            let wave = &all[columns[index / rows.len()] * ny + rows[index % rows.len()]];
            if reaches(wave.k[0].hypot(wave.k[1])) { wave.at(below, z) } else { Default::default() }
        };
        let count = columns.len() * rows.len();
        Self {
            at: (below.piece, z),
            amplitudes: (0..count).into_par_iter().with_min_len(256).map(amplitudes).collect(),
            k: [
                columns.iter().map(|column| all[column * ny].k[0]).collect(),
                rows.iter().map(|row| all[*row].k[1]).collect(),
            ],
        }
    }

    /// The sums over the waves along an axis where it is so far (m) from the first element.
    fn along(&self, axis: usize, from: f64) -> Vec<[Complex64; ALL]> {
        let phases: Vec<Complex64> =
            self.k[axis].iter().map(|k| Complex64::cis(k * from)).collect();
        let rows = self.k[1].len();
        let mut sums = vec![[Complex64::ZERO; ALL]; self.k[1 - axis].len()];
        for (index, own) in self.amplitudes.iter().enumerate() {
            let at = [index / rows, index % rows];
            let phase = phases[at[axis]];
            for (sum, own) in sums[at[1 - axis]].iter_mut().zip(own) {
                *sum += own * phase;
            }
        }
        sums
    }

    /// The sum along the other axis, where it is so far (m) from the first element.
    fn across(&self, axis: usize, sums: &[[Complex64; ALL]], from: f64) -> Sums {
        let mut all = [0.0; ALL];
        for (k, own) in self.k[axis].iter().zip(sums) {
            let phase = Complex64::cis(k * from);
            all.iter_mut().zip(own).for_each(|(all, own)| *all += (own * phase).re);
        }
        let [xx, yy, zz, xy, xz, yz, x, y, z] = all;
        ([xx, yy, zz, xy, xz, yz], [x, y, z])
    }
}

impl Wave {
    /// The amplitudes of its stress and displacement at a depth (m): the real part of each, turned by the phase of a place, is what
    /// there is.
    fn at(&self, below: &Below, z: f64) -> [Complex64; ALL] {
        let Self { k, still, amplitudes } = self;
        let (stresses, moved) = of_wave(below, *k, z);
        let mut sum = [Complex64::ZERO; ALL];
        for (axis, amplitude) in amplitudes.iter().enumerate() {
            let own = stresses[axis].iter().chain(&moved[axis]);
            for (component, (sum, own)) in sum.iter_mut().zip(own).enumerate() {
                let odd = odd(component, axis);
                if (0..2).any(|axis| odd[axis] && still[axis]) {
                    continue;
                }
                let turn = if odd[0] == odd[1] { Complex64::ONE } else { Complex64::I };
                *sum += own * turn * amplitude;
            }
        }
        sum
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
