//! The stiffness of a body in tetrahedra.

use faer::sparse::{SparseColMat, SymbolicSparseColMat};
use glam::{DMat3, DVec3};
use rayon::prelude::*;

use super::held::Held;
use crate::body::Material;
use crate::body::mesh::Volume;
use crate::body::mesh::tetrahedron::{points, slopes, turn};

/// Tetrahedra whose stiffness is found at once.
const BATCH: usize = 1024;

/// Forces (N) on nodes by displacements (m) of nodes: blocks of three by three, symmetric.
#[derive(Debug, Clone)]
pub(super) struct Stiffness {
    /// Below and on the diagonal: for each node that is displaced, the nodes behind it in rising order, with their blocks.
    columns: Vec<Vec<(usize, DMat3)>>,
}

/// Lame's constants (Pa).
pub(super) fn lame(material: &Material) -> [f64; 2] {
    let shear = material.shear_modulus();
    [2.0 * shear * material.poisson / (1.0 - 2.0 * material.poisson), shear]
}

/// The force (N m) that a function of slope `one` (1/m) meets from a displacement along a function of slope `other`.
pub(super) fn force([lame, shear]: [f64; 2], one: DVec3, other: DVec3) -> DMat3 {
    let outer = |a: DVec3, b: DVec3| DMat3::from_cols(b.x * a, b.y * a, b.z * a);
    lame * outer(one, other) + shear * (outer(other, one) + one.dot(other) * DMat3::IDENTITY)
}

impl Stiffness {
    pub fn new(volume: &Volume, material: &Material) -> Self {
        let count = volume.nodes.len();
        let mut near: Vec<Vec<usize>> = vec![vec![]; count];
        for element in &volume.elements {
            for &node in element {
                near[node].extend(element.iter().filter(|&&other| other >= node));
            }
        }
        let column = |mut others: Vec<usize>| {
            others.sort_unstable();
            others.dedup();
            others.into_iter().map(|other| (other, DMat3::ZERO)).collect()
        };
        let mut columns: Vec<Vec<(usize, DMat3)>> = near.into_iter().map(column).collect();
        let constants = lame(material);
        for batch in volume.elements.chunks(BATCH) {
            let found: Vec<_> =
                batch.par_iter().map(|element| of_element(volume, element, constants)).collect();
            for (element, blocks) in batch.iter().zip(found) {
                for (a, &displaced) in element.iter().enumerate() {
                    for (b, &pulled) in element.iter().enumerate() {
                        if pulled < displaced {
                            continue;
                        }
                        let column = &mut columns[displaced];
                        if let Ok(place) = column.binary_search_by_key(&pulled, |one| one.0) {
                            column[place].1 += blocks[10 * b + a];
                        }
                    }
                }
            }
        }
        Self { columns }
    }

    /// Forces (N) by displacements (m), three a node.
    pub fn times(&self, displacements: &[f64]) -> Vec<f64> {
        let at = |node: usize| DVec3::from_slice(&displacements[3 * node..3 * node + 3]);
        let mut forces = vec![DVec3::ZERO; self.columns.len()];
        for (displaced, column) in self.columns.iter().enumerate() {
            let own = at(displaced);
            for &(pulled, block) in column {
                forces[pulled] += block * own;
                if pulled != displaced {
                    forces[displaced] += block.transpose() * at(pulled);
                }
            }
        }
        forces.into_iter().flat_map(|force| force.to_array()).collect()
    }

    /// Its part between directions that are free, below the diagonal; and the number of each free direction of each node.
    pub fn between_free(
        &self,
        held: &[Held],
    ) -> (Option<SparseColMat<usize, f64>>, Vec<[usize; 3]>) {
        let mut count = 0;
        let number = |held: &Held| {
            let mut own = [usize::MAX; 3];
            for own in &mut own[held.count..] {
                *own = count;
                count += 1;
            }
            own
        };
        let numbers: Vec<[usize; 3]> = held.iter().map(number).collect();
        let (mut starts, mut rows, mut values) = (vec![0], vec![], vec![]);
        for (displaced, column) in self.columns.iter().enumerate() {
            for direction in held[displaced].count..3 {
                let unit = held[displaced].basis[direction];
                for &(pulled, block) in column {
                    let force = block * unit;
                    let first = if pulled == displaced { direction } else { held[pulled].count };
                    let along = numbers[pulled].into_iter().zip(held[pulled].basis).skip(first);
                    for (number, direction) in along {
                        rows.push(number);
                        values.push(force.dot(direction));
                    }
                }
                starts.push(rows.len());
            }
        }
        let matrix = (count > 0).then(|| {
            let symbolic = SymbolicSparseColMat::new_checked(count, count, starts, None, rows);
            SparseColMat::new(symbolic, values)
        });
        (matrix, numbers)
    }
}

/// Blocks of a tetrahedron, row by node that is pulled.
fn of_element(volume: &Volume, element: &[usize; 10], constants: [f64; 2]) -> Vec<DMat3> {
    let places = element.map(|node| DVec3::from(volume.nodes[node]));
    let mut blocks = vec![DMat3::ZERO; 100];
    for (at, weight) in points() {
        let turn = turn(&places, at);
        let weight = weight * turn.determinant() / 6.0;
        let inverse = turn.inverse().transpose();
        let slopes = slopes(at).map(|slope| inverse * slope);
        for (pulled, one) in slopes.iter().enumerate() {
            for (displaced, other) in slopes.iter().enumerate() {
                blocks[10 * pulled + displaced] += weight * force(constants, *one, *other);
            }
        }
    }
    blocks
}
