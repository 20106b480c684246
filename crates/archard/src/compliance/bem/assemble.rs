//! The equations of a body, one a node and direction, straight into the matrix of what is sought.
//!
//! For every node x, with H and G the integrals of T and U times the shape functions,
//!
//! ```text
//! sum of H u = sum of G t / G_s
//! ```
//!
//! Displacements u that are known and tractions t that are given go to the right-hand side, tractions of
//! contact to columns of their own. The block of a node with itself follows from the displacement of a
//! rigid body, under which no traction acts. Nodes that mirror planes make act through images: the image of
//! an element is the element seen from the image of the node.

use std::collections::BTreeMap;

use faer::{Mat, MatMut};
use glam::DVec3;
use pulp::Arch;
use rayon::prelude::*;

use super::blocks::{BLOCK, blocks};
use super::conditions::{Conditions, Given};
use super::integrate::{Beam, Integrals, Spot, Tile};
use super::kelvin::{ALL, DISPLACEMENT, Kelvin};
use super::patch::distance;
use super::rules::{Places, Rules};
use super::surface::Surface;

/// The equations: matrix * sought = contact * tractions there + fixed.
///
/// Along each direction of a node's basis its displacement (m) is sought or, where that is known, its
/// traction in units of shear modulus / length; tractions of contact are in that unit.
pub(super) struct System {
    pub matrix: Mat<f64>,
    pub contact: Mat<f64>,
    pub fixed: Mat<f64>,
    /// How often Kelvin's solution was evaluated.
    pub evaluations: usize,
}

/// What the equations are made from.
pub(super) struct Assembly<'a> {
    pub surface: &'a Surface,
    pub conditions: &'a Conditions,
    pub rules: Rules,
    pub kelvin: Kelvin,
    /// What a traction (Pa) is multiplied by to be in its unit.
    pub unit: f64,
    arch: Arch,
    images: Vec<DVec3>,
    /// Elements whose tractions are not all zero.
    loaded: Vec<bool>,
}

/// Places that one point against many does better than many points against these.
const MANY: usize = 25;
/// How far a block has to be from an element, relative to half its extent, to be treated as one.
const APART: f64 = 3.0;

impl<'a> Assembly<'a> {
    pub fn new(
        surface: &'a Surface,
        conditions: &'a Conditions,
        (kelvin, unit): (Kelvin, f64),
        tolerance: f64,
    ) -> Self {
        let is_loaded = |traction: usize| {
            let given = conditions.tractions[traction].given;
            given.iter().any(|given| *given != Given::Traction(0.0))
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
        }
    }

    /// Makes the equations; blocks of nodes in parallel.
    pub fn system(&self) -> System {
        let unknowns = self.surface.unknowns();
        let mut matrix = Mat::zeros(unknowns, unknowns);
        let mut contact = Mat::zeros(unknowns, 3 * self.conditions.contact.len());
        let mut fixed = Mat::zeros(unknowns, 1);
        let strips = matrix.as_mut().par_row_chunks_mut(3 * BLOCK);
        let contacts = contact.as_mut().par_row_chunks_mut(3 * BLOCK);
        let known = fixed.as_mut().par_row_chunks_mut(3 * BLOCK);
        let places = &self.surface.nodes;
        let blocks = blocks(places);
        let fill = |(((matrix, contact), fixed), nodes)| {
            Strip::new(self, nodes).fill(Rows { matrix, contact, fixed })
        };
        let evaluations = strips.zip(contacts).zip(known).zip(blocks).map(fill).sum();
        System { matrix, contact, fixed, evaluations }
    }
}

/// The rows of one block of nodes: all along x, then y, then z.
struct Rows<'m> {
    matrix: MatMut<'m, f64>,
    contact: MatMut<'m, f64>,
    fixed: MatMut<'m, f64>,
}

/// A block of nodes on its way through the elements.
struct Strip<'a> {
    assembly: &'a Assembly<'a>,
    nodes: Vec<usize>,
    centre: DVec3,
    radius: f64,
    /// Integrals of one element: for each shape function and each component, a value a node.
    tractions: Vec<f64>,
    displacements: Vec<f64>,
    /// What a rigid displacement makes of the integrals so far: for each component, a value a node.
    rigid: Vec<f64>,
    places: Places,
    spots: Vec<Spot>,
    sums: Vec<f64>,
    evaluations: usize,
}

impl<'a> Strip<'a> {
    fn new(assembly: &'a Assembly<'a>, nodes: Vec<usize>) -> Self {
        let place = |node: usize| assembly.surface.nodes[node];
        let centre = nodes.iter().map(|&node| place(node)).sum::<DVec3>() / nodes.len() as f64;
        let radius = nodes.iter().map(|&node| place(node).distance(centre)).fold(0.0, f64::max);
        Self {
            assembly,
            nodes,
            centre,
            radius,
            tractions: vec![0.0; 4 * 9 * BLOCK],
            displacements: vec![0.0; 4 * 9 * BLOCK],
            rigid: vec![0.0; 9 * BLOCK],
            places: Places::default(),
            spots: vec![],
            sums: vec![0.0; 4 * ALL * BLOCK],
            evaluations: 0,
        }
    }

    /// Fills the rows; how often Kelvin's solution was evaluated for it.
    fn fill(mut self, mut rows: Rows<'_>) -> usize {
        for face in 0..self.assembly.surface.patches.len() {
            self.tractions.fill(0.0);
            self.displacements.fill(0.0);
            for image in &self.assembly.images {
                self.integrate(face, *image);
            }
            self.write(face, &mut rows);
        }
        self.write_own(&mut rows);
        self.evaluations
    }

    fn point(&self, at: usize, image: DVec3) -> DVec3 {
        image * self.assembly.surface.nodes[self.nodes[at]]
    }

    /// Adds the integrals over an element, seen from an image of the nodes.
    fn integrate(&mut self, face: usize, image: DVec3) {
        let patch = &self.assembly.surface.patches[face];
        let away = (image * self.centre).distance(patch.centre) - self.radius - patch.radius;
        if away >= APART * patch.half[0].max(patch.half[1]) {
            let orders = self.assembly.rules.orders(patch, away);
            let all: Vec<usize> = (0..self.nodes.len()).collect();
            self.tile(face, image, orders, &all);
            return;
        }
        let mut groups: BTreeMap<[usize; 2], Vec<usize>> = BTreeMap::new();
        for at in 0..self.nodes.len() {
            let point = self.point(at, image);
            let local = &self.assembly.surface.local[face];
            let count = patch.element.nodes.len();
            let own = local[..count].iter().position(|local| local.node == self.nodes[at]);
            if let Some(own) = own.filter(|_| point == self.point(at, DVec3::ONE)) {
                self.beam(face, image, at, Some(own));
                continue;
            }
            let away = distance(point, &patch.corners);
            let orders = self.assembly.rules.orders(patch, away);
            if !Rules::far(patch, away) || orders[0] * orders[1] >= MANY {
                self.beam(face, image, at, None);
            } else {
                groups.entry(orders).or_default().push(at);
            }
        }
        for (orders, group) in groups {
            self.tile(face, image, orders, &group);
        }
    }

    /// Many nodes against the places of a rule.
    fn tile(&mut self, face: usize, image: DVec3, orders: [usize; 2], group: &[usize]) {
        let patch = &self.assembly.surface.patches[face];
        self.places.clear();
        self.assembly.rules.whole(patch, orders, &mut self.places);
        Spot::on(patch, &self.places, &mut self.spots);
        let width = group.len().next_multiple_of(8);
        self.evaluations += width * self.spots.len();
        let mut points = [[0.0; BLOCK]; 3];
        for index in 0..width {
            let point = self.point(group[index.min(group.len() - 1)], image);
            for axis in 0..3 {
                points[axis][index] = point[axis];
            }
        }
        let nodes = patch.element.nodes.len();
        let displacement = self.assembly.loaded[face];
        self.assembly.arch.dispatch(Tile {
            kelvin: self.assembly.kelvin,
            points: points.each_ref().map(|points| &points[..width]),
            spots: &self.spots,
            nodes,
            displacement,
            sums: &mut self.sums[..nodes * ALL * width],
        });
        for node in 0..nodes {
            for i in 0..3 {
                for j in 0..3 {
                    let component = 3 * i + j;
                    let row = |row: usize| {
                        let start = (node * ALL + row) * width;
                        start..start + group.len()
                    };
                    let start = (9 * node + component) * BLOCK;
                    let mirror = image[i] * image[j];
                    for (&at, sum) in group.iter().zip(&self.sums[row(component)]) {
                        self.tractions[start + at] += image[i] * sum;
                        self.rigid[component * BLOCK + at] += mirror * sum;
                    }
                    if displacement {
                        for (&at, sum) in group.iter().zip(&self.sums[row(DISPLACEMENT[i][j])]) {
                            self.displacements[start + at] += image[i] * sum;
                        }
                    }
                }
            }
        }
    }

    /// One node against places around it, or on the element it lies on itself.
    fn beam(&mut self, face: usize, image: DVec3, at: usize, own: Option<usize>) {
        let patch = &self.assembly.surface.patches[face];
        let point = self.point(at, image);
        self.places.clear();
        match own {
            None => self.assembly.rules.near(patch, point, &mut self.places),
            Some(own) => {
                self.assembly.rules.polar(patch, patch.element.nodes[own], &mut self.places);
            }
        }
        self.places.pad();
        self.evaluations += self.places.s.len();
        let displacement = self.assembly.loaded[face];
        let kelvin = self.assembly.kelvin;
        let places = &self.places;
        let beam = Beam { kelvin, point, patch, places, displacement };
        let integrals: Integrals = self.assembly.arch.dispatch(beam);
        for (node, values) in integrals[..patch.element.nodes.len()].iter().enumerate() {
            for i in 0..3 {
                for j in 0..3 {
                    let component = 3 * i + j;
                    let slot = (9 * node + component) * BLOCK + at;
                    self.displacements[slot] += image[i] * values[DISPLACEMENT[i][j]];
                    // The own traction, strongly singular, follows from all others.
                    if own != Some(node) {
                        self.tractions[slot] += image[i] * values[component];
                        let mirror = image[i] * image[j];
                        self.rigid[component * BLOCK + at] += mirror * values[component];
                    }
                }
            }
        }
    }

    /// Takes the integrals of an element over into the columns they belong to.
    fn write(&self, face: usize, rows: &mut Rows<'_>) {
        let Assembly { surface, conditions, unit, .. } = self.assembly;
        let count = surface.patches[face].element.nodes.len();
        for (index, local) in surface.local[face][..count].iter().enumerate() {
            let start = 9 * index * BLOCK;
            self.write_node(local.node, &self.tractions[start..], 1.0, rows);
            if !self.assembly.loaded[face] {
                continue;
            }
            let condition = &conditions.tractions[local.traction];
            let values = &self.displacements[start..start + 9 * BLOCK];
            for (direction, (unit_vector, given)) in
                condition.basis.iter().zip(condition.given).enumerate()
            {
                match given {
                    Given::Traction(0.0) => {}
                    Given::Traction(traction) => {
                        let factor = unit * traction;
                        self.add(values, *unit_vector, factor, rows.fixed.as_mut().col_mut(0));
                    }
                    Given::Contact => {
                        if let Some(column) = conditions.contact_column[local.traction] {
                            let column = rows.contact.as_mut().col_mut(3 * column + direction);
                            self.add(values, *unit_vector, 1.0, column);
                        }
                    }
                    Given::Displacement(_) => {
                        let node = &conditions.nodes[local.node];
                        for own in 0..3 {
                            if let Some(known) = node.known[own]
                                && known.traction == local.traction
                                && node.basis[own].dot(*unit_vector).abs() > 0.5
                            {
                                let column = rows
                                    .matrix
                                    .as_mut()
                                    .col_mut(conditions.columns[local.node] + own);
                                self.add(values, node.basis[own], -1.0, column);
                            }
                        }
                    }
                }
            }
        }
    }

    /// Adds what the displacement of a node is multiplied by.
    fn write_node(&self, node: usize, values: &[f64], sign: f64, rows: &mut Rows<'_>) {
        let condition = &self.assembly.conditions.nodes[node];
        let first = self.assembly.conditions.columns[node];
        for (direction, unit_vector) in condition.basis.iter().enumerate() {
            match condition.known[direction] {
                None => {
                    let column = rows.matrix.as_mut().col_mut(first + direction);
                    self.add(values, *unit_vector, sign, column);
                }
                Some(known) if known.displacement != 0.0 => {
                    let factor = -sign * known.displacement;
                    self.add(values, *unit_vector, factor, rows.fixed.as_mut().col_mut(0));
                }
                Some(_) => {}
            }
        }
    }

    /// Adds the components of integrals along a direction to a column.
    fn add(&self, values: &[f64], direction: DVec3, factor: f64, column: faer::ColMut<'_, f64>) {
        let count = self.nodes.len();
        let Some(column) = column.try_as_col_major_mut() else { return };
        let column = column.as_slice_mut();
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

    /// The blocks of the nodes with themselves; where a node lies on a plane of symmetry, that it stays there.
    fn write_own(&self, rows: &mut Rows<'_>) {
        let count = self.nodes.len();
        let mut own = vec![0.0; 9 * BLOCK];
        for (at, &node) in self.nodes.iter().enumerate() {
            own.fill(0.0);
            for component in 0..9 {
                own[component * BLOCK + at] = self.rigid[component * BLOCK + at];
            }
            self.write_node(node, &own, -1.0, rows);
            let place = self.assembly.surface.nodes[node];
            for axis in 0..2 {
                if self.assembly.surface.mirrored[axis] && place[axis] == 0.0 {
                    let basis = &self.assembly.conditions.nodes[node].basis;
                    let direction = (0..3)
                        .max_by(|&a, &b| basis[a][axis].abs().total_cmp(&basis[b][axis].abs()));
                    let row = axis * count + at;
                    let first = self.assembly.conditions.columns[node];
                    rows.matrix[(row, first + direction.unwrap_or(axis))] = 1.0;
                }
            }
        }
    }
}
