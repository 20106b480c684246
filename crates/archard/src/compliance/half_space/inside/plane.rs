//! The stresses at all elements in a plane below the surface, by convolution.

use std::f64::consts::PI;
use std::sync::Arc;

use rayon::prelude::*;

use super::{Below, corner, rest, strip};
use crate::compliance::half_space::differences::differences;
use crate::numerics::convolution::{Parity, Spectrum};

/// Components of the stresses, from pressures alone and with friction.
const ALL: usize = 18;

/// Kernels of a half-space that are the same: of zz by friction and of xz or yz by the pressure, of yz by friction along x and of xz by that
/// along y.
const TWINS: [[usize; 2]; 3] = [[2, 16], [8, 17], [5, 10]];

impl Below {
    /// The stresses (Pa) below the centres of the elements, so deep (m, zero or greater), as those of [`Below::stress`]: a field a
    /// component, in the order xx, yy, zz, xy, xz, yz, one value an element.
    pub fn plane(&self, depth: f64) -> [Vec<f64>; 6] {
        let [nx, ny] = self.elements;
        let (convolution, kernels) = match &self.waves {
            None => (&*self.convolution, self.kernels(depth)),
            Some(waves) => {
                let first = if self.rubs() { 0 } else { 12 };
                let wanted: Vec<_> = (first..ALL).map(|own| [own / 6, own % 6]).collect();
                let kernels = waves.kernels(self, &wanted, depth);
                (waves.convolution(), kernels.into_iter().map(Arc::new).collect())
            }
        };
        let mut fields = [0; 6].map(|_| vec![0.0; nx * ny]);
        if self.rubs() {
            let [one, two] = [0, 3].map(|first| {
                [0, 1, 2].map(|row| [0, 1, 2].map(|axis| (&*kernels[6 * axis + first + row], 1.0)))
            });
            let tractions = self.tractions.each_ref().map(|traction| &traction[..]);
            let [xx, yy, zz, xy, xz, yz] = &mut fields;
            convolution.apply_matrix(one, tractions, [xx, yy, zz]);
            convolution.apply_matrix(two, tractions, [xy, xz, yz]);
        } else {
            for (kernel, field) in kernels.iter().zip(&mut fields) {
                convolution.apply_matrix([[(&**kernel, 1.0)]], [&self.tractions[2]], [field]);
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
    fn kernels(&self, depth: f64) -> Vec<Arc<Spectrum>> {
        let [nx, ny] = self.elements;
        let half = self.spacing.map(|h| 0.5 * h);
        let (line, poisson) = (self.depth.is_some(), self.material(depth).poisson);
        let scale = if line { PI } else { 2.0 * PI };
        let piece = self.piece(depth);
        let seen =
            piece.filter(|_| line).map_or(vec![], |(layers, piece)| layers.seen(piece, depth));
        let corners = rows([nx, ny], |at| {
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
        });
        let far = piece.filter(|_| !line).map(|(layers, piece)| layers.far(piece, depth));
        let added = far.map(|far| {
            let from = |at: [usize; 2]| [0, 1].map(|axis| self.spacing[axis] * at[axis] as f64);
            rows([nx, ny], |at| far.element(from(at), half).0)
        });
        let first = if self.rubs() { 0 } else { 12 };
        let values = |index: usize| {
            let values: Vec<f64> = of(&corners, index, nx).map(|value| value / scale).collect();
            // A function of corners is odd where its differences are even.
            let sign = |parity: Parity| if parity == Parity::Even { -1.0 } else { 1.0 };
            let signs = parity(index % 6, index / 6, line).map(sign);
            let mut values = if line {
                let mut before = signs[0] * values[0];
                values.into_iter().map(|here| here - std::mem::replace(&mut before, here)).collect()
            } else {
                differences(values, self.elements, signs)
            };
            if let Some(added) = &added {
                values.iter_mut().zip(of(added, index, nx)).for_each(|(own, added)| *own += added);
            }
            values
        };
        let known = |index: usize| parity(index % 6, index / 6, line);
        let twin = |index: usize| {
            let twin = TWINS.iter().find(|[_, own]| *own == index && first == 0);
            twin.filter(|_| piece.is_none()).map(|[of, _]| *of)
        };
        let mut left: Vec<usize> = (first..ALL).filter(|index| twin(*index).is_none()).collect();
        let mut kernels: [Option<Arc<Spectrum>>; ALL] = Default::default();
        while let Some(one) = left.pop() {
            let opposite =
                |other: &usize| (0..2).all(|axis| known(one)[axis] != known(*other)[axis]);
            match left.iter().position(opposite).map(|place| left.remove(place)) {
                Some(other) => {
                    let both = [one, other];
                    let own = both.map(values);
                    let own = own.each_ref().map(|values| &values[..]);
                    let spectra = self.convolution.spectrum_pair(own, nx, both.map(known));
                    for (index, spectrum) in both.into_iter().zip(spectra) {
                        kernels[index] = Some(Arc::new(spectrum));
                    }
                }
                None => {
                    let spectrum = self.convolution.spectrum(&values(one), nx, known(one));
                    kernels[one] = Some(Arc::new(spectrum));
                }
            }
        }
        (first..ALL).filter_map(|index| kernels[twin(index).unwrap_or(index)].clone()).collect()
    }
}

/// The components under tractions along each axis by indices along x and y: row by row, in each component after component.
fn rows(
    [nx, ny]: [usize; 2],
    components: impl Fn([usize; 2]) -> [[f64; 6]; 3] + Sync,
) -> Vec<Vec<f64>> {
    let row = |j: usize| {
        let mut row = vec![0.0; ALL * nx];
        for i in 0..nx {
            let found = components([i, j]);
            found.iter().flatten().enumerate().for_each(|(own, value)| row[own * nx + i] = *value);
        }
        row
    };
    (0..ny).into_par_iter().map(row).collect()
}

/// One component of all rows.
fn of(rows: &[Vec<f64>], component: usize, nx: usize) -> impl Iterator<Item = f64> {
    rows.iter().flat_map(move |row| row[component * nx..][..nx].iter().copied())
}

/// Whether a component under tractions along an axis keeps its sign where x and where y are reversed: it changes by each index that
/// is reversed.
pub(super) fn parity(component: usize, axis: usize, line: bool) -> [Parity; 2] {
    let odd = odd(component, axis);
    let across = if odd[1] && !line { Parity::Odd } else { Parity::Even };
    [if odd[0] { Parity::Odd } else { Parity::Even }, across]
}

/// The same of components of the stress and then of the displacement: whether they change it.
pub(super) fn odd(component: usize, axis: usize) -> [bool; 2] {
    const INDICES: [&[usize]; 9] =
        [&[0, 0], &[1, 1], &[2, 2], &[0, 1], &[0, 2], &[1, 2], &[0], &[1], &[2]];
    let indices = INDICES[component];
    [0, 1].map(|reversed| {
        indices.iter().chain([&axis]).filter(|index| **index == reversed).count() % 2 == 1
    })
}
