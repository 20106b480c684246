//! Normals of a curved zone, smooth across the edges of its plane elements.
//!
//! Each corner has the normal of the sphere through it and its neighbours (N. Max, Weights for computing vertex
//! normals from facet normals, *Journal of Graphics Tools* 4 (1999) 1-6), nodes what lies between. With those of
//! the elements themselves an approach would open or close the gaps of a conforming contact in steps.

use glam::DVec3;

use super::super::element::evaluate;
use super::super::surface::Surface;
use crate::body::Finite;

/// Elements that turn by more (cosine of 30 degrees) meet in an edge of the body.
const EDGE: f64 = 0.866;

/// Outward unit normals of the nodes of tractions; zero away from the zone.
pub(super) fn normals(finite: &Finite, surface: &Surface) -> Vec<DVec3> {
    let around = around(finite, surface);
    let mut normals = vec![DVec3::ZERO; surface.tractions.len()];
    for &face in &finite.meshed.zone.faces {
        let patch = &surface.patches[face];
        let own = patch.normal(patch.middle_reference());
        let corners = surface.corners[face].as_slice().iter();
        let corners: Vec<DVec3> = corners
            .map(|&vertex| {
                let smooth = around[vertex].iter();
                let smooth = smooth.filter(|weighed| weighed.dot(own) > EDGE * weighed.length());
                smooth.sum::<DVec3>().normalize_or(own)
            })
            .collect();
        for (node, at) in surface.tractions_of(face).zip(patch.element.nodes) {
            let shares = patch.element.map.iter().map(|polynomial| evaluate(polynomial, *at));
            normals[node] +=
                shares.zip(&corners).map(|(share, corner)| share * *corner).sum::<DVec3>();
        }
    }
    normals.iter_mut().for_each(|normal| *normal = normal.normalize_or_zero());
    normals
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
