//! The stresses at all elements in a plane below the surface, by convolution.

use std::f64::consts::PI;

use rayon::prelude::*;

use super::{Below, corner, rest, strip};
use crate::compliance::half_space::differences::differences;
use crate::numerics::convolution::{Parity, Spectrum};

/// Components of the stresses, from pressures alone and with friction.
const ALL: usize = 18;

impl Below {
    /// The stresses (Pa) below the centres of the elements, so deep (m, zero or greater), as those of [`Below::stress`]: a field a
    /// component, in the order xx, yy, zz, xy, xz, yz, one value an element.
    pub fn plane(&self, depth: f64) -> [Vec<f64>; 6] {
        let [nx, ny] = self.elements;
        let (convolution, kernels) = match &self.waves {
            None => (&*self.convolution, self.kernels(depth)),
            Some(waves) => {
                let first = if self.rubs() { 0 } else { 12 };
                let kernel = |index: usize| waves.kernel(self, (index / 6, index % 6), depth);
                (waves.convolution(), (first..ALL).map(kernel).collect())
            }
        };
        let mut fields = [0; 6].map(|_| vec![0.0; nx * ny]);
        if self.rubs() {
            let [one, two] = [0, 3].map(|first| {
                [0, 1, 2].map(|row| [0, 1, 2].map(|axis| (&kernels[6 * axis + first + row], 1.0)))
            });
            let tractions = self.tractions.each_ref().map(|traction| &traction[..]);
            let [xx, yy, zz, xy, xz, yz] = &mut fields;
            convolution.apply_matrix(one, tractions, [xx, yy, zz]);
            convolution.apply_matrix(two, tractions, [xy, xz, yz]);
        } else {
            for (kernel, field) in kernels.iter().zip(&mut fields) {
                convolution.apply_matrix([[(kernel, 1.0)]], [&self.tractions[2]], [field]);
            }
        }
        fields[4..].iter_mut().flatten().for_each(|value| *value = -*value);
        if self.waves.is_some() {
            return fields;
        }
        let varying = self.varying(depth);
        let added: Vec<_> =
            (0..nx * ny).into_par_iter().map(|element| varying.at(self, element)).collect();
        for (component, field) in fields.iter_mut().enumerate() {
            field.iter_mut().zip(&added).for_each(|(value, added)| *value += added[component]);
        }
        fields
    }

    /// The spectra of the components under tractions along x, y and z, one axis after the other; without friction those of
    /// pressures alone.
    fn kernels(&self, depth: f64) -> Vec<Spectrum> {
        let [nx, ny] = self.elements;
        let half = self.spacing.map(|h| 0.5 * h);
        let (line, poisson) = (self.depth.is_some(), self.material(depth).poisson);
        let scale = if line { PI } else { 2.0 * PI };
        let piece = self.piece(depth);
        let seen =
            piece.filter(|_| line).map_or(vec![], |(layers, piece)| layers.seen(piece, depth));
        let corners: Vec<[[f64; 6]; 3]> = (0..nx * ny)
            .into_par_iter()
            .with_min_len(256)
            .map(|index| {
                let at = [index % nx, index / nx];
                let [x, y] = [0, 1].map(|axis| half[axis] * (2 * at[axis] + 1) as f64);
                if line {
                    let mut own = strip::stress(&strip::functions(x, depth), poisson);
                    let (added, _) = rest::at_edge(&seen, x);
                    let added = added.iter().flatten();
                    own.iter_mut().flatten().zip(added).for_each(|(own, added)| *own += added);
                    own
                } else {
                    corner::stress(&corner::functions([x, y], depth), poisson)
                }
            })
            .collect();
        let far = piece.filter(|_| !line).map(|(layers, piece)| layers.far(piece, depth));
        let added: Option<Vec<[[f64; 6]; 3]>> = far.map(|far| {
            let element = |index: usize| {
                let at = [index % nx, index / nx];
                far.element([0, 1].map(|axis| self.spacing[axis] * at[axis] as f64), half).0
            };
            (0..nx * ny).into_par_iter().with_min_len(256).map(element).collect()
        });
        let first = if self.rubs() { 0 } else { 12 };
        let kernel = |index: usize| {
            let (axis, component) = (index / 6, index % 6);
            let values: Vec<f64> =
                corners.iter().map(|corner| corner[axis][component] / scale).collect();
            let parity = parity(component, axis, line);
            // A function of corners is odd where its differences are even.
            let sign = |parity: Parity| if parity == Parity::Even { -1.0 } else { 1.0 };
            let mut values = if line {
                let mut before = sign(parity[0]) * values[0];
                values.into_iter().map(|here| here - std::mem::replace(&mut before, here)).collect()
            } else {
                differences(values, self.elements, parity.map(sign))
            };
            for (value, added) in values.iter_mut().zip(added.iter().flatten()) {
                *value += added[axis][component];
            }
            self.convolution.spectrum(&values, nx, parity)
        };
        (first..ALL).map(kernel).collect()
    }
}

/// Whether a component under tractions along an axis keeps its sign where x and where y are reversed: it changes by each index that
/// is reversed.
pub(super) fn parity(component: usize, axis: usize, line: bool) -> [Parity; 2] {
    const INDICES: [[usize; 2]; 6] = [[0, 0], [1, 1], [2, 2], [0, 1], [0, 2], [1, 2]];
    let indices = INDICES[component];
    [0, 1].map(|reversed| {
        let count = indices.iter().chain([&axis]).filter(|index| **index == reversed).count();
        if count % 2 == 0 || reversed == 1 && line { Parity::Even } else { Parity::Odd }
    })
}
