//! Areas and enclosed volumes.

use super::{ContactMesh, Corners, Mesh};
use crate::numerics::SAME;

impl Mesh {
    /// Area of the elements (m^2); mirror images do not count.
    pub fn area(&self) -> f64 {
        (0..self.faces.len()).map(|face| length(self.area_vector(face))).sum()
    }

    /// Volume enclosed (m^3), mirror images at x = 0 and y = 0 included; negative where the elements are
    /// seen clockwise from outside.
    ///
    /// One third of the flux of the place through the surface (the divergence theorem). The cut planes
    /// of symmetry, where nothing is meshed, give nothing since the origin lies on them.
    pub fn volume(&self, mirrored: [bool; 2]) -> f64 {
        self.volume_under(0..self.faces.len(), mirrored)
    }

    /// The same of some elements, which are closed by themselves.
    pub(super) fn volume_under(
        &self,
        faces: impl Iterator<Item = usize>,
        mirrored: [bool; 2],
    ) -> f64 {
        // Close to the body, so that little cancels.
        let near = self.vertices.first().copied().unwrap_or_default();
        let origin = [
            if mirrored[0] { 0.0 } else { near[0] },
            if mirrored[1] { 0.0 } else { near[1] },
            near[2],
        ];
        let place = |corner: usize| difference(self.vertices[corner], origin);
        let tetrahedron = |a, b, c| dot(place(a), cross(place(b), place(c))) / 6.0;
        let under = |face: usize| match self.faces[face].corners {
            Corners::Triangle([a, b, c]) => tetrahedron(a, b, c),
            // The bilinear surface lies halfway between the two ways to fold the element.
            Corners::Quad([a, b, c, d]) => {
                0.5 * (tetrahedron(a, b, c) + tetrahedron(a, c, d))
                    + 0.5 * (tetrahedron(a, b, d) + tetrahedron(b, c, d))
            }
        };
        let images = mirrored.iter().map(|&mirrored| if mirrored { 2.0 } else { 1.0 });
        images.product::<f64>() * faces.map(under).sum::<f64>()
    }

    /// The centre of an element (m), the mean of its corners.
    pub fn centre(&self, face: usize) -> [f64; 3] {
        let corners = self.faces[face].corners;
        let corners = corners.as_slice();
        [0, 1, 2].map(|axis| {
            corners.iter().map(|&corner| self.vertices[corner][axis]).sum::<f64>()
                / corners.len() as f64
        })
    }

    /// The outward normal of an element times its area (m^2); of a warped one, of its outline.
    pub fn area_vector(&self, face: usize) -> [f64; 3] {
        let place = |corner: usize| self.vertices[corner];
        let (one, other) = match self.faces[face].corners {
            Corners::Triangle([a, b, c]) => {
                (difference(place(b), place(a)), difference(place(c), place(a)))
            }
            Corners::Quad([a, b, c, d]) => {
                (difference(place(c), place(a)), difference(place(d), place(b)))
            }
        };
        cross(one, other).map(|component| 0.5 * component)
    }
}

impl ContactMesh {
    /// Whether the elements of the zone lie in one plane, or in parallel ones.
    pub fn has_plane_zone(&self) -> bool {
        let mut normals = self.zone.faces.iter().map(|&face| {
            let vector = self.mesh.area_vector(face);
            vector.map(|component| component / length(vector))
        });
        let Some(first) = normals.next() else { return false };
        normals.all(|normal| length(difference(normal, first)) < SAME)
    }
}

pub(super) fn difference(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(super) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(super) fn length(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}
