//! The equations of a body, one a node and direction, straight into the matrix of what is sought.
//!
//! For every node x, with H and G the integrals of T and U times the shape functions,
//!
//! ```text
//! sum of H u = sum of G t / G_s
//! ```
//!
//! Displacements u that are known and tractions t that are given go to the right-hand side, tractions of
//! contact to columns of their own, and other loads to columns next to that of what is known. The block of a node with itself follows from the displacement of a
//! rigid body, under which no traction acts. Nodes that mirror planes make act through images: the image of
//! an element is the element seen from the image of the node.

use faer::{ColMut, Mat, MatMut};
use glam::DVec3;
use pulp::Arch;
use rayon::prelude::*;

use super::blocks::{BLOCK, blocks};
use super::conditions::{AxisCondition, Conditions};
use super::curvature::{Share, curvatures};
use super::element::CURVATURES;
use super::integrate::NODES;
use super::kelvin::{Evaluations, Kelvin};
use super::loads::Loads;
use super::making::{Listener, Parts};
use super::rules::Rules;
use super::strip::{Stock, Strip};
use super::surface::Surface;
use crate::numerics::large::{Large, NoMemory};

/// The equations: matrix * sought = contact * tractions there + fixed.
///
/// Along each direction of a node's basis its displacement (m) is sought or, where that is known, its
/// traction in units of shear modulus / length; tractions of contact are in that unit.
pub(super) struct System {
    pub matrix: Large<f64>,
    pub contact: Large<f64>,
    /// What is known, and behind it a column for each of other loads.
    pub fixed: Mat<f64>,
    /// How often Kelvin's solution was evaluated.
    pub evaluations: Evaluations,
}

/// What the equations are made from.
pub(super) struct Assembly<'a> {
    pub surface: &'a Surface,
    pub conditions: &'a Conditions,
    pub rules: Rules,
    pub kelvin: Kelvin,
    /// What a traction (Pa) is multiplied by to be in its unit.
    pub unit: f64,
    pub arch: Arch,
    /// See [`Surface::images`].
    pub images: Vec<DVec3>,
    /// Elements whose tractions are not all zero.
    pub loaded: Vec<bool>,
    /// What bends the displacements of an element between its nodes.
    pub curvatures: Vec<Vec<Share>>,
    /// Other loads, each by itself.
    pub loads: Option<&'a Loads>,
}

impl<'a> Assembly<'a> {
    pub fn new(
        surface: &'a Surface,
        conditions: &'a Conditions,
        (kelvin, unit): (Kelvin, f64),
        tolerance: f64,
    ) -> Self {
        let is_loaded = |traction: usize| {
            let given = conditions.tractions[traction].given;
            given.iter().any(|given| *given != AxisCondition::Traction(0.0))
        };
        let loaded = (0..surface.patches.len())
            .map(|face| surface.tractions_of(face).any(is_loaded))
            .collect();
        Self {
            surface,
            conditions,
            rules: Rules::new(tolerance),
            kelvin,
            unit,
            arch: Arch::new(),
            images: surface.images(),
            loaded,
            curvatures: curvatures(surface),
            loads: None,
        }
    }

    /// The same with other loads, each by itself.
    pub fn under(mut self, loads: &'a Loads) -> Self {
        for (face, loaded) in self.loaded.iter_mut().enumerate() {
            *loaded |= self.surface.tractions_of(face).any(|traction| loads.loads(traction));
        }
        Self { loads: Some(loads), ..self }
    }

    /// Makes the equations; blocks of nodes in parallel.
    ///
    /// # Errors
    /// If there is no memory for them.
    pub fn system(&self, told: Listener<'_>) -> Result<System, NoMemory> {
        let unknowns = self.surface.unknowns();
        let mut matrix = Large::zeros(unknowns, unknowns)?;
        let mut contact = Large::zeros(unknowns, 3 * self.conditions.contact.len())?;
        let loads = self.loads.map_or(0, Loads::count);
        let mut fixed = Mat::zeros(unknowns, 1 + loads);
        let strips = matrix.as_mut().par_row_chunks_mut(3 * BLOCK);
        let contacts = contact.as_mut().par_row_chunks_mut(3 * BLOCK);
        let known = fixed.as_mut().par_row_chunks_mut(3 * BLOCK);
        let places = &self.surface.nodes;
        let blocks = blocks(places);
        let parts = Parts::new(told, unknowns, blocks.len());
        let fill = |(((matrix, contact), fixed), nodes)| {
            let evaluations = Rows { assembly: self, matrix, contact, fixed }.fill(nodes);
            parts.one();
            evaluations
        };
        let evaluations = strips.zip(contacts).zip(known).zip(blocks).map(fill).sum();
        Ok(System { matrix, contact, fixed, evaluations })
    }
}

/// The rows of one block of nodes, all along x, then y, then z, and how they come to their values.
struct Rows<'m> {
    assembly: &'m Assembly<'m>,
    matrix: MatMut<'m, f64>,
    contact: MatMut<'m, f64>,
    fixed: MatMut<'m, f64>,
}

impl Rows<'_> {
    /// Fills the rows; how often Kelvin's solution was evaluated for it.
    fn fill(mut self, nodes: Vec<usize>) -> Evaluations {
        let mut strip = Strip::new(self.assembly, nodes);
        for face in 0..self.assembly.surface.patches.len() {
            strip.integrate(face);
            self.write(face, &strip.sums);
            self.write_curvatures(face, strip.bent, &strip.sums.tractions);
        }
        self.write_own(&strip.nodes, &strip.sums.rigid);
        strip.evaluations
    }

    /// Takes the integrals of an element over into the columns they belong to.
    fn write(&mut self, face: usize, sums: &Stock) {
        let Assembly { surface, conditions, unit, loads, .. } = self.assembly;
        let count = surface.patches[face].element.nodes.len();
        let rows = 9 * BLOCK;
        let all = sums.tractions.chunks_exact(rows).zip(sums.displacements.chunks_exact(rows));
        for ((tractions, displacements), local) in all.zip(&surface.local[face][..count]) {
            self.write_node(local.node, tractions, 1.0, DVec3::ONE);
            if !self.assembly.loaded[face] {
                continue;
            }
            let condition = &conditions.tractions[local.traction];
            for (direction, (unit_vector, given)) in
                condition.basis.iter().zip(condition.given).enumerate()
            {
                match given {
                    AxisCondition::Traction(traction) => {
                        let others = loads.iter().flat_map(|loads| {
                            loads.tractions[3 * local.traction + direction].iter()
                        });
                        for (column, traction) in
                            std::iter::once(&traction).chain(others).enumerate()
                        {
                            if *traction != 0.0 {
                                let column = self.fixed.as_mut().col_mut(column);
                                add(displacements, *unit_vector, unit * traction, column);
                            }
                        }
                    }
                    AxisCondition::Contact => {
                        if let Some(column) = conditions.contact_column[local.traction] {
                            let column = self.contact.as_mut().col_mut(3 * column + direction);
                            add(displacements, *unit_vector, 1.0, column);
                        }
                    }
                    AxisCondition::Displacement(_) => {
                        let node = &conditions.nodes[local.node];
                        for own in 0..3 {
                            if let Some(known) = node.known[own]
                                && known.traction == local.traction
                                && node.basis[own].dot(*unit_vector).abs() > 0.5
                            {
                                let column = conditions.columns[local.node] + own;
                                let column = self.matrix.as_mut().col_mut(column);
                                add(displacements, node.basis[own], -1.0, column);
                            }
                        }
                    }
                }
            }
        }
    }

    /// Takes the integrals with the curvatures of an element over to the nodes they are found from.
    fn write_curvatures(&mut self, face: usize, bent: [bool; CURVATURES], tractions: &[f64]) {
        if bent == [false; CURVATURES] {
            return;
        }
        let rows = 9 * BLOCK;
        let [along_s, along_t] = [NODES, NODES + 1].map(|row| &tractions[row * rows..][..rows]);
        let mut values = [0.0; 9 * BLOCK];
        for share in &self.assembly.curvatures[face] {
            let [of_s, of_t] = share.curvatures;
            for ((value, s), t) in values.iter_mut().zip(along_s).zip(along_t) {
                *value = of_s * s + of_t * t;
            }
            self.write_node(share.node, &values, 1.0, share.image);
        }
    }

    /// Adds what the displacement of an image of a node is multiplied by.
    fn write_node(&mut self, node: usize, values: &[f64], sign: f64, image: DVec3) {
        let condition = &self.assembly.conditions.nodes[node];
        let first = self.assembly.conditions.columns[node];
        for (direction, unit_vector) in condition.basis.iter().enumerate() {
            match condition.known[direction] {
                None => {
                    let column = self.matrix.as_mut().col_mut(first + direction);
                    add(values, image * *unit_vector, sign, column);
                }
                Some(known) => {
                    let others = self.assembly.loads.into_iter();
                    let others =
                        others.flat_map(|loads| loads.displacements[3 * node + direction].iter());
                    let all = std::iter::once(&known.displacement).chain(others);
                    for (column, displacement) in all.enumerate() {
                        if *displacement != 0.0 {
                            let column = self.fixed.as_mut().col_mut(column);
                            add(values, image * *unit_vector, -sign * displacement, column);
                        }
                    }
                }
            }
        }
    }

    /// The blocks of the nodes with themselves; where a node lies on a plane of symmetry, that it stays there.
    fn write_own(&mut self, nodes: &[usize], rigid: &[f64]) {
        let Assembly { surface, conditions, .. } = self.assembly;
        let mut own = vec![0.0; 9 * BLOCK];
        for (at, &node) in nodes.iter().enumerate() {
            own.fill(0.0);
            for component in 0..9 {
                own[component * BLOCK + at] = rigid[component * BLOCK + at];
            }
            self.write_node(node, &own, -1.0, DVec3::ONE);
            let place = surface.nodes[node];
            for axis in 0..2 {
                if surface.mirrored[axis] && place[axis] == 0.0 {
                    let basis = &conditions.nodes[node].basis;
                    let direction = (0..3)
                        .max_by(|&a, &b| basis[a][axis].abs().total_cmp(&basis[b][axis].abs()));
                    let row = axis * nodes.len() + at;
                    let column = conditions.columns[node] + direction.unwrap_or(axis);
                    self.matrix[(row, column)] = 1.0;
                }
            }
        }
    }
}

/// Adds the components of integrals along a direction to a column.
fn add(values: &[f64], direction: DVec3, factor: f64, column: ColMut<'_, f64>) {
    let Some(column) = column.try_as_col_major_mut() else { return };
    let column = column.as_slice_mut();
    let count = column.len() / 3;
    for (i, column) in column.chunks_exact_mut(count).enumerate() {
        for j in 0..3 {
            let share = factor * direction[j];
            if share != 0.0 {
                let values = &values[(3 * i + j) * BLOCK..];
                column.iter_mut().zip(values).for_each(|(sum, value)| *sum += share * value);
            }
        }
    }
}
