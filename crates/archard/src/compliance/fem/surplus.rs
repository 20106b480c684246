//! What cubic functions would add to displacements that are quadratic in each tetrahedron.
//!
//! Each function of an edge or a side by itself takes what the tractions and the stresses leave over on it. All [together](super::together)
//! they add somewhat more; by how much is found for even loads. What all further degrees add follows from it, as the error falls with
//! the degree at the edges of what is clamped, where stresses are singular.

use std::collections::HashMap;

use faer::Mat;
use glam::{DMat3, DVec3};
use rayon::prelude::*;

use super::Solid;
use super::held::Held;
use super::stiffness::{force, lame};
use super::together::{Together, together};
use super::triangle::Point;
use crate::body::mesh::Volume;
use crate::body::mesh::tetrahedron::{EDGES, cubic_slopes, points, slopes, turn};
use crate::compliance::bem::image::NearField;

/// Tetrahedra that are gone through at once.
const BATCH: usize = 256;
/// The cubic function of an edge a quarter of the way from its first end, where it is largest about.
const AT_A_QUARTER: f64 = 3.0 / 32.0;

/// How displacements rise with the distance from an edge between a clamped and a free face at right angles: by this power, of a
/// material of that ratio of Poisson in plane strain (M. L. Williams, J. Appl. Mech. 19 (1952), 526).
fn power_at_an_edge(poisson: f64) -> f64 {
    let left = |power: f64| {
        let sine = (0.5 * std::f64::consts::PI * power).sin();
        sine * sine * (3.0 - 4.0 * poisson) + power * power - 4.0 * (1.0 - poisson).powi(2)
    };
    let (mut low, mut high) = (0.0, 1.0);
    // Each step halves what is open: to rounding.
    for _ in 0..f64::MANTISSA_DIGITS {
        let middle = 0.5 * (low + high);
        *(if left(middle) > 0.0 { &mut high } else { &mut low }) = middle;
    }
    high
}

/// What all degrees from the third on add to energies, relative to the third alone. Where displacements rise by a power at an edge,
/// errors of displacements fall with the degree to twice that power, and those of energies to four times it (I. Babuska and M. Suri,
/// RAIRO Model. Math. Anal. Numer. 21 (1987), 199).
fn further(poisson: f64) -> f64 {
    1.0 / (1.0 - (2.0_f64 / 3.0).powf(4.0 * power_at_an_edge(poisson)))
}

/// The cubic functions of a volume for those who solve for them: of each tetrahedron the function and its sign there, what is held of
/// each, and directions along which each does no work on itself, whose squares add up to what it gives way by (1/(N m)).
pub(super) struct Cubic<'a> {
    pub functions: &'a [[(usize, f64); 10]],
    pub held: &'a [Held],
    pub directions: &'a [Vec<DVec3>],
}

/// The cubic functions of a volume: of its edges, which have the numbers of the nodes on them, and behind them of its sides.
pub(super) struct Surplus {
    loads: usize,
    /// Of each tetrahedron, of its edges in their order and its sides.
    functions: Vec<[usize; 10]>,
    /// Of each triangle of the surface, of its edges and of itself.
    faces: Vec<[usize; 4]>,
    /// Whether the first end of each edge of each triangle has the lower number.
    rises: Vec<[bool; 3]>,
    /// Ends of each edge, the lower number first.
    ends: HashMap<usize, [usize; 2]>,
    /// What is left over on each function (N m), one vector a load.
    residual: Vec<DVec3>,
    /// How each function by itself resists (N m).
    resists: Vec<DMat3>,
}

impl Surplus {
    pub fn new(volume: &Volume, loads: usize) -> Self {
        let mut sides: HashMap<[usize; 3], usize> = HashMap::new();
        let mut ends = HashMap::new();
        let edges = volume.nodes.len();
        let sorted = |mut corners: [usize; 3]| {
            corners.sort_unstable();
            corners
        };
        let mut functions = vec![];
        for element in &volume.elements {
            let mut own = [0; 10];
            for (edge, [one, other]) in EDGES.into_iter().enumerate() {
                own[edge] = element[4 + edge];
                let [one, other] = [element[one], element[other]];
                ends.insert(own[edge], [one.min(other), one.max(other)]);
            }
            for across in 0..4 {
                let mut corners = (0..4).filter(|corner| *corner != across);
                let corners = [(); 3].map(|()| element[corners.next().unwrap_or(0)]);
                let next = edges + sides.len();
                own[6 + across] = *sides.entry(sorted(corners)).or_insert(next);
            }
            functions.push(own);
        }
        let of_face = |face: &[usize; 6]| {
            let own = sides.get(&sorted([face[0], face[1], face[2]])).copied().unwrap_or(0);
            [face[3], face[4], face[5], own]
        };
        let rises = |face: &[usize; 6]| [0, 1, 2].map(|edge| face[edge] < face[(edge + 1) % 3]);
        let count = edges + sides.len();
        Self {
            loads,
            functions,
            faces: volume.faces.iter().map(of_face).collect(),
            rises: volume.faces.iter().map(rises).collect(),
            ends,
            residual: vec![DVec3::ZERO; count * loads],
            resists: vec![DMat3::ZERO; count],
        }
    }

    /// Adds forces (N), one a load, at a point of a triangle of the surface.
    pub fn load(&mut self, face: usize, point: &Point, forces: &[DVec3]) {
        let [a, b, c, middle] = self.faces[face];
        for (edge, function) in [a, b, c].into_iter().enumerate() {
            let sign = if self.rises[face][edge] { 1.0 } else { -1.0 };
            self.add(function, sign * point.edges[edge], forces);
        }
        self.add(middle, point.middle, forces);
    }

    /// Adds what forces (N) do on the cubic functions of a triangle of the surface.
    pub fn bear(&mut self, face: usize, forces: [DVec3; 4]) {
        for ((function, sign), force) in self.of_face(face).into_iter().zip(forces) {
            self.add(function, sign, &[force]);
        }
    }

    /// The functions of a triangle of the surface, with their signs there.
    fn of_face(&self, face: usize) -> [(usize, f64); 4] {
        std::array::from_fn(|own| {
            let turned = own < 3 && !self.rises[face][own];
            (self.faces[face][own], if turned { -1.0 } else { 1.0 })
        })
    }

    /// What they and all further degrees add to displacements (m) under the one load that acts.
    pub fn added(mut self, solid: &Solid, displacements: Vec<f64>) -> Added {
        self.take_stresses(solid, &[displacements]);
        let held = self.held(solid);
        let directions: Vec<Vec<DVec3>> = self
            .resists
            .iter()
            .zip(&held)
            .map(|(resists, held)| directions(*resists, held))
            .collect();
        let functions: Vec<[(usize, f64); 10]> =
            self.functions.iter().zip(&solid.volume.elements).map(signed).collect();
        let cubic = Cubic { functions: &functions, held: &held, directions: &directions };
        let residual = std::slice::from_ref(&self.residual);
        let mut values = together(solid, &cubic, residual).remove(0).values;
        let share = further(solid.material.poisson);
        values.iter_mut().for_each(|value| *value *= share);
        Added { nodes: solid.volume.nodes.len(), values, surplus: self }
    }

    fn add(&mut self, function: usize, share: f64, forces: &[DVec3]) {
        let own = &mut self.residual[function * self.loads..][..self.loads];
        own.iter_mut().zip(forces).for_each(|(own, force)| *own += share * *force);
    }

    /// The energy (m/N) of what they and all further degrees add to displacements (m) between two loads.
    pub fn energy(
        mut self,
        solid: &Solid,
        displacements: &[Vec<f64>],
        near: &NearField<'_>,
    ) -> Mat<f64> {
        self.take_stresses(solid, displacements);
        let held = self.held(solid);
        let directions: Vec<Vec<DVec3>> = self
            .resists
            .iter()
            .zip(&held)
            .map(|(resists, held)| directions(*resists, held))
            .collect();
        let rows: Vec<Vec<DVec3>> = (0..self.resists.len())
            .into_par_iter()
            .map(|function| {
                let way = (&held[function], &directions[function][..]);
                self.root(function, way, solid, (displacements, near))
            })
            .collect();
        let functions: Vec<[(usize, f64); 10]> =
            self.functions.iter().zip(&solid.volume.elements).map(signed).collect();
        let cubic = Cubic { functions: &functions, held: &held, directions: &directions };
        let even: Vec<Vec<DVec3>> = near
            .even()
            .map(|load| self.residual.iter().skip(load).step_by(self.loads).copied().collect())
            .collect();
        let share = |one: &Together| if one.each > 0.0 { one.energy / one.each } else { 1.0 };
        let together = together(solid, &cubic, &even).iter().map(share).fold(1.0, f64::max);
        let there: Vec<&Vec<DVec3>> = rows.iter().filter(|row| !row.is_empty()).collect();
        let rows: Mat<f64> =
            Mat::from_fn(3 * there.len(), self.loads, |row, load| there[row / 3][load][row % 3]);
        let energy = rows.transpose() * &rows;
        energy * faer::Scale(together * further(solid.material.poisson))
    }

    /// Takes what the stresses of each load do, and how each function resists.
    fn take_stresses(&mut self, solid: &Solid, displacements: &[Vec<f64>]) {
        let elements: Vec<usize> = (0..self.functions.len()).collect();
        for batch in elements.chunks(BATCH) {
            let found: Vec<_> = batch
                .par_iter()
                .map(|element| of_element(solid, *element, displacements))
                .collect();
            for (&element, (resists, stresses)) in batch.iter().zip(&found) {
                let nodes = &solid.volume.elements[element];
                let functions = signed((&self.functions[element], nodes));
                for (own, (function, sign)) in functions.into_iter().enumerate() {
                    self.resists[function] += resists[own];
                    let of_loads: Vec<DVec3> =
                        stresses.iter().map(|stresses| stresses[own]).collect();
                    self.add(function, -sign, &of_loads);
                }
            }
        }
    }

    /// What is held of each function.
    fn held(&self, solid: &Solid) -> Vec<Held> {
        let mut held = solid.nodes.clone();
        held.resize(self.resists.len(), Held::FREE);
        for (face, own) in self.faces.iter().zip(&solid.faces) {
            held[face[3]] = *own;
        }
        held
    }

    /// What a function adds, one a load, so that products of two are energies: along what is free as the residual asks, along what is
    /// held by what the half-space is displaced there and quadratic functions are not.
    fn root(
        &self,
        function: usize,
        (held, directions): (&Held, &[DVec3]),
        solid: &Solid,
        (displacements, near): (&[Vec<f64>], &NearField<'_>),
    ) -> Vec<DVec3> {
        let resists = self.resists[function];
        if resists == DMat3::ZERO {
            return vec![];
        }
        let residual = &self.residual[function * self.loads..][..self.loads];
        let moved = self.ends.get(&function).filter(|_| held.count > 0).map(|ends| {
            let at = |node: usize| DVec3::from(solid.volume.nodes[node]);
            let [one, other] = ends.map(at);
            let weights = [0.375, -0.125, 0.75];
            let nodes = [ends[0], ends[1], function];
            let place = weights[0] * one + weights[1] * other + weights[2] * at(function);
            let known = near.at(place, DVec3::Z).displacement;
            let found = |load: usize| {
                let value = |node: usize| DVec3::from_slice(&displacements[load][3 * node..][..3]);
                nodes.iter().zip(weights).map(|(node, share)| share * value(*node)).sum::<DVec3>()
            };
            let missed =
                |(load, known): (usize, &DVec3)| held.held(-*known - found(load)) / AT_A_QUARTER;
            known.iter().enumerate().map(missed).collect::<Vec<_>>()
        });
        let added = |load: usize| {
            let along = |axis: usize| {
                if axis < held.count {
                    let unit = held.basis[axis];
                    let missed = moved.as_ref().map_or(0.0, |moved| moved[load].dot(unit));
                    missed * unit.dot(resists * unit).sqrt()
                } else {
                    residual[load].dot(directions[axis - held.count])
                }
            };
            DVec3::from_array([0, 1, 2].map(along))
        };
        (0..self.loads).map(added).collect()
    }
}

/// What is added to displacements (m) by quadratic and cubic functions.
pub(super) struct Added {
    nodes: usize,
    values: Vec<DVec3>,
    surplus: Surplus,
}

impl Added {
    /// To the function of a node.
    pub fn node(&self, node: usize) -> DVec3 {
        self.values[node]
    }

    /// To the cubic functions of a triangle of the surface.
    pub fn face(&self, face: usize) -> [DVec3; 4] {
        let functions = self.surplus.of_face(face);
        functions.map(|(function, sign)| sign * self.values[self.nodes + function])
    }
}

/// Directions of what is free, along which a function that resists so (N m) does no work on itself, as long as it gives way.
fn directions(resists: DMat3, held: &Held) -> Vec<DVec3> {
    let mut directions: Vec<DVec3> = vec![];
    if resists == DMat3::ZERO {
        return directions;
    }
    for unit in &held.basis[held.count..] {
        let rest =
            directions.iter().fold(*unit, |rest, one| rest - one.dot(resists * *unit) * *one);
        directions.push(rest / rest.dot(resists * rest).sqrt());
    }
    directions
}

/// The cubic functions of a tetrahedron with their signs there: those of edges rise from the end of the lower number.
fn signed((functions, nodes): (&[usize; 10], &[usize; 10])) -> [(usize, f64); 10] {
    std::array::from_fn(|own| {
        let turned = own < 6 && nodes[EDGES[own][0]] > nodes[EDGES[own][1]];
        (functions[own], if turned { -1.0 } else { 1.0 })
    })
}

/// How the cubic functions of a tetrahedron resist (N m), and what the stresses of each load do on them (N m).
fn of_element(
    solid: &Solid,
    element: usize,
    displacements: &[Vec<f64>],
) -> ([DMat3; 10], Vec<[DVec3; 10]>) {
    let nodes = &solid.volume.elements[element];
    let places = nodes.map(|node| DVec3::from(solid.volume.nodes[node]));
    let constants = lame(&solid.material);
    let mut resists = [DMat3::ZERO; 10];
    // Slopes of each function against the stress at each corner, which is linear between them.
    let mut against = [[DVec3::ZERO; 4]; 10];
    for (at, weight) in points() {
        let turn = turn(&places, at);
        let weight = weight * turn.determinant() / 6.0;
        let inverse = turn.inverse().transpose();
        for (function, slope) in cubic_slopes(at).into_iter().enumerate() {
            let slope = inverse * slope;
            resists[function] += weight * force(constants, slope, slope);
            for corner in 0..4 {
                against[function][corner] += weight * at[corner] * slope;
            }
        }
    }
    let corners: [[DVec3; 10]; 4] = [0, 1, 2, 3].map(|corner| {
        let mut at = [0.0; 4];
        at[corner] = 1.0;
        let inverse = turn(&places, at).inverse().transpose();
        slopes(at).map(|slope| inverse * slope)
    });
    let [lame, shear] = constants;
    let of_load = |displaced: &Vec<f64>| {
        let stresses = corners.map(|slopes| {
            let mut gradient = DMat3::ZERO;
            for (node, slope) in nodes.iter().zip(slopes) {
                let own = DVec3::from_slice(&displaced[3 * node..][..3]);
                gradient += DMat3::from_cols(slope.x * own, slope.y * own, slope.z * own);
            }
            let trace = gradient.x_axis.x + gradient.y_axis.y + gradient.z_axis.z;
            shear * (gradient + gradient.transpose()) + lame * trace * DMat3::IDENTITY
        });
        against.map(|slopes| {
            slopes.iter().zip(&stresses).map(|(slope, stress)| *stress * *slope).sum::<DVec3>()
        })
    };
    (resists, displacements.iter().map(of_load).collect())
}

#[cfg(test)]
mod tests {
    use super::{further, power_at_an_edge};

    /// Values of Williams's equation: .711 for a ratio of .3; the edge is smooth for zero, and cos (pi l / 2) = l for a half.
    #[test]
    fn powers_at_clamped_edges_are_known() {
        assert!((power_at_an_edge(0.3) - 0.711).abs() < 1e-3);
        assert!((power_at_an_edge(0.0) - 1.0).abs() < 1e-9);
        let half = power_at_an_edge(0.5);
        assert!(((0.5 * std::f64::consts::PI * half).cos() - half).abs() < 1e-9);
        assert!((further(0.3) - 1.46).abs() < 0.01);
    }
}
