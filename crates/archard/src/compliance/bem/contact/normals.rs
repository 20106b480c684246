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
//! which on arcs and spheres is their height above the chord; where a file has nodes on its edges, as much as the surface through these
//! does. With the elements themselves an approach would open
//! and close the gaps of a conforming contact in steps, and gaps would depend on which corners face each other.

use glam::{DMat3, DVec3};

use super::super::element::evaluate;
use super::super::patch::Patch;
use super::super::surface::Surface;
use super::STEEP;
use super::rim::turned;
use crate::body::Finite;
use crate::numerics::WRITTEN;

/// The outward normals of a zone at the corners of its elements.
pub(super) struct Normals {
    corners: Vec<Vec<DVec3>>,
    /// How far the nodes on the edges of each triangle lie off their middles (m), where they do anywhere.
    edges: Option<Vec<[DVec3; 3]>>,
}

impl Normals {
    pub fn new(finite: &Finite, surface: &Surface) -> Self {
        let around = around(finite, surface);
        let near = |face: usize, vertex: usize| {
            let patch = &surface.patches[face];
            let own = patch.normal(patch.middle_reference());
            let near = around[vertex].iter().filter(move |one| one.dot(own) > STEEP * one.length());
            (near.clone().count() == around[vertex].len(), near.sum::<DVec3>().normalize_or(own))
        };
        let zone = &finite.meshed.zone.faces;
        let of = |&face: &usize| -> (Vec<bool>, Vec<DVec3>) {
            let vertices = surface.corners[face].as_slice().iter();
            vertices.map(|&vertex| near(face, vertex)).unzip()
        };
        let (all_around, mut corners): (Vec<_>, Vec<_>) = zone.iter().map(of).unzip();
        let edges = edges(finite);
        // Elements that bear the contact meet it up to the rim.
        if finite.elasticity.bears() && edges.is_none() {
            let vertices = |face: &usize| surface.corners[*face].as_slice().to_vec();
            let elements: Vec<Vec<usize>> = zone.iter().map(vertices).collect();
            turned(&elements, &finite.meshed.mesh.vertices, &mut corners, &all_around);
        }
        Self { corners, edges }
    }

    /// The outward normal at a place on an element, by its index in the zone.
    pub fn at(&self, index: usize, patch: &Patch, at: [f64; 2]) -> DVec3 {
        if let Some(edges) = &self.edges {
            return above(patch, edges[index], at)[1];
        }
        let shares = patch.element.map.iter().map(|polynomial| evaluate(polynomial, at));
        shares.zip(&self.corners[index]).map(|(share, n)| share * *n).sum::<DVec3>().normalize()
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
        if let Some(edges) = &self.edges {
            let [place, normal] = above(patch, edges[index], at);
            return (place - patch.at(at)).dot(normal);
        }
        let place = patch.at(at);
        let shares = patch.element.map.iter().map(|polynomial| evaluate(polynomial, at));
        let corners = patch.corners.iter().zip(&self.corners[index]);
        let above = corners.map(|(corner, normal)| (*corner - place).dot(*normal));
        0.5 * shares.zip(above).map(|(share, above)| share * above).sum::<f64>()
    }
}

/// The place (m) straight above one of a triangle, and the outward normal there, on the surface through nodes that lie off the middles of
/// its edges. A surface that is known by other coordinates than the triangle's is followed along its tangents.
fn above(patch: &Patch, [a, b, c]: [DVec3; 3], at: [f64; 2]) -> [DVec3; 2] {
    /// Each time what is left falls with its square.
    const STEPS: usize = 3;
    let below = patch.at(at);
    let mut own = at;
    let mut found = [below, DVec3::Z];
    for _ in 0..STEPS {
        let [s, t] = own;
        let rest = 1.0 - s - t;
        let [along_s, along_t] = patch.tangents(own);
        let along_s = along_s + 4.0 * ((rest - s) * a + t * b - t * c);
        let along_t = along_t + 4.0 * ((rest - t) * c + s * b - s * a);
        let place = patch.at(own) + 4.0 * (rest * s * a + s * t * b + t * rest * c);
        let normal = along_s.cross(along_t).normalize();
        found = [place, normal];
        let off = below - place;
        let axes = DMat3::from_cols(along_s, along_t, normal);
        let step = axes.inverse() * off;
        if !step.is_finite() {
            break;
        }
        own = [s + step.x, t + step.y];
    }
    found
}

/// How far nodes on the edges of the zone lie off the middles (m); `None` where there are none, or none lies off.
fn edges(finite: &Finite) -> Option<Vec<[DVec3; 3]>> {
    let volume = finite.meshed.volume.as_ref()?;
    let at = |node: usize| DVec3::from(volume.nodes[node]);
    let off = |nodes: &[usize; 6]| {
        [0, 1, 2]
            .map(|edge| at(nodes[3 + edge]) - 0.5 * (at(nodes[edge]) + at(nodes[(edge + 1) % 3])))
    };
    let edges: Vec<_> =
        finite.meshed.zone.faces.iter().map(|face| off(&volume.faces[*face])).collect();
    let least = WRITTEN * finite.meshed.mesh.extent();
    edges.iter().flatten().any(|off| off.length() > least).then_some(edges)
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

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::{Normals, Surface};
    use crate::body::mesh::{ContactMesh, Corners, Face, Mesh, Zone};
    use crate::body::{Elasticity, Finite, Interpolation};

    const RADIUS: f64 = 2.0;

    /// A patch of four by four elements on a sphere about the origin, their corners an angle of about that apart.
    fn patch(angle: f64) -> Finite {
        let vertices = (0..25).map(|vertex| {
            let [x, y] = [vertex % 5, vertex / 5].map(|i| angle * (f64::from(i) - 1.7));
            (RADIUS * DVec3::new(x, y, 1.0).normalize()).to_array()
        });
        let face = |face: usize| {
            let first = 5 * (face / 4) + face % 4;
            let corners = Corners::Quad([first, first + 1, first + 6, first + 5]);
            Face { corners, surface: 0 }
        };
        let mesh = Mesh {
            vertices: vertices.collect(),
            faces: (0..16).map(face).collect(),
            surfaces: vec!["cap".to_owned()],
        };
        // The four in the middle, all of whose corners have elements all around.
        let zone = Zone { faces: vec![5, 6, 9, 10], grid: None };
        Finite {
            meshed: ContactMesh { mesh, zone, placed: true, ..ContactMesh::default() },
            curvatures: Some([1.0 / RADIUS; 2]),
            supports: vec![],
            mirrored: [false; 2],
            interpolation: Interpolation::Discontinuous,
            tolerance: 1e-6,
            elasticity: Elasticity::BoundaryElements,
        }
    }

    /// The largest errors of normals at the corners and at nodes, and of the rise relative to the radius.
    fn errors(angle: f64) -> [f64; 3] {
        let finite = patch(angle);
        let surface = Surface::new(&finite.meshed.mesh, finite.interpolation, finite.mirrored);
        let normals = Normals::new(&finite, &surface);
        let mut errors = [0.0f64; 3];
        for (index, &face) in finite.meshed.zone.faces.iter().enumerate() {
            let patch = &surface.patches[face];
            for (corner, normal) in patch.corners.iter().zip(&normals.corners[index]) {
                errors[0] = errors[0].max(normal.distance(corner.normalize()));
            }
            for at in [[0.0, 0.0], [0.5, -0.5], [0.9, 0.3]] {
                let place = patch.at(at);
                let above = RADIUS - place.length();
                assert!(above > 0.0);
                let rise = normals.rise(index, patch, at);
                errors[2] = errors[2].max((rise - above).abs() / RADIUS);
            }
        }
        for (node, normal) in normals.at_nodes(&finite, &surface).into_iter().enumerate() {
            if normal != DVec3::ZERO {
                let place = surface.tractions[node].place;
                errors[1] = errors[1].max(normal.distance(place.normalize()));
            }
        }
        errors
    }

    /// Normals are exact on a sphere at corners (Max), and between them, where normals and places are the same
    /// mean of those of the corners; the rise follows with the fourth power of the size of the elements.
    #[test]
    fn a_sphere_is_as_smooth_as_it_is_meant() {
        let (coarse, fine) = (errors(0.2), errors(0.1));
        assert!(coarse[0] < 1e-12 && fine[0] < 1e-12, "{coarse:?} {fine:?}");
        assert!(coarse[1] < 1e-12 && fine[1] < 1e-12, "{coarse:?} {fine:?}");
        assert!(coarse[2] < 2e-4 && fine[2] < 0.08 * coarse[2], "{coarse:?} {fine:?}");
    }
}
