//! A curved zone as smooth as it is meant, on plane elements.
//!
//! Each corner has the normal of the sphere through it and its neighbours (N. Max, Weights for computing vertex
//! normals from facet normals, *Journal of Graphics Tools* 4 (1999) 1-6), nodes what lies between. The surface rises
//! above an element by half of what the tangent planes of the corners p_c do, each weighed by its share w_c
//! (T. Boubekeur and M. Alexa, Phong tessellation, *ACM Transactions on Graphics* 27 (2008) 141),
//!
//! ```text
//! rise = 1/2 sum over c of w_c (p_c - place) . n_c
//! ```
//!
//! which on arcs and spheres is their height above the chord. With the elements themselves an approach would open
//! and close the gaps of a conforming contact in steps, and gaps would depend on which corners face each other.

use glam::DVec3;

use super::super::element::evaluate;
use super::super::patch::Patch;
use super::super::surface::Surface;
use crate::body::Finite;

/// Elements that turn by more (cosine of 30 degrees) meet in an edge of the body.
const EDGE: f64 = 0.866;

/// The outward normals of a zone at the corners of its elements.
pub(super) struct Normals {
    corners: Vec<Vec<DVec3>>,
}

impl Normals {
    pub fn new(finite: &Finite, surface: &Surface) -> Self {
        let around = around(finite, surface);
        let of = |&face: &usize| {
            let patch = &surface.patches[face];
            let own = patch.normal(patch.middle_reference());
            let near = |weighed: &&DVec3| weighed.dot(own) > EDGE * weighed.length();
            let smooth = |&vertex: &usize| {
                around[vertex].iter().filter(near).sum::<DVec3>().normalize_or(own)
            };
            surface.corners[face].as_slice().iter().map(smooth).collect()
        };
        Self { corners: finite.meshed.zone.faces.iter().map(of).collect() }
    }

    /// Normals at the nodes of tractions; zero away from the zone.
    pub fn at_nodes(&self, finite: &Finite, surface: &Surface) -> Vec<DVec3> {
        let mut normals = vec![DVec3::ZERO; surface.tractions.len()];
        for (&face, corners) in finite.meshed.zone.faces.iter().zip(&self.corners) {
            let element = surface.patches[face].element;
            for (node, at) in surface.tractions_of(face).zip(element.nodes) {
                let shares = element.map.iter().map(|polynomial| evaluate(polynomial, *at));
                normals[node] += shares.zip(corners).map(|(share, n)| share * *n).sum::<DVec3>();
            }
        }
        normals.iter_mut().for_each(|normal| *normal = normal.normalize_or_zero());
        normals
    }

    /// How far the surface rises (m) above a place on an element, by its index in the zone.
    pub fn rise(&self, index: usize, patch: &Patch, at: [f64; 2]) -> f64 {
        let place = patch.at(at);
        let shares = patch.element.map.iter().map(|polynomial| evaluate(polynomial, at));
        let corners = patch.corners.iter().zip(&self.corners[index]);
        let above = corners.map(|(corner, normal)| (*corner - place).dot(*normal));
        0.5 * shares.zip(above).map(|(share, above)| share * above).sum::<f64>()
    }
}

/// Normals of the elements around each vertex with their weights, mirror images among them.
fn around(finite: &Finite, surface: &Surface) -> Vec<Vec<DVec3>> {
    let mesh = &finite.meshed.mesh;
    let mut around = vec![vec![]; mesh.vertices.len()];
    for (patch, corners) in surface.patches.iter().zip(&surface.corners) {
        let vertices = corners.as_slice();
        let count = vertices.len();
        for (corner, &vertex) in vertices.iter().enumerate() {
            let place = patch.corners[corner];
            let next = patch.corners[(corner + 1) % count] - place;
            let last = patch.corners[(corner + count - 1) % count] - place;
            let weight = next.length_squared() * last.length_squared();
            let mut images = vec![next.cross(last) / weight];
            for axis in 0..2 {
                if surface.mirrored[axis] && place[axis] == 0.0 {
                    let mut image = images.clone();
                    image.iter_mut().for_each(|normal| normal[axis] = -normal[axis]);
                    images.extend(image);
                }
            }
            around[vertex].extend(images);
        }
    }
    around
}
