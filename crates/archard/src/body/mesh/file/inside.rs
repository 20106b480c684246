//! The inside of a body from a file, laid below a flat face of it.

use std::sync::Arc;

use glam::{DVec2, DVec3};

use super::near::Near;
use super::solid;
use crate::body::mesh::{ContactMesh, Corners, Mesh, MeshError, SupportedSurfaces, Volume, Zone};
use crate::numerics::WRITTEN;

/// The inside of a body with its surface, triangle by triangle, in the places of the file.
#[derive(Debug)]
pub(super) struct Inside {
    volume: Volume,
    pub mesh: Mesh,
}

impl Inside {
    /// In metres, its surface divided at edges where elements turn by more than an angle (rad); where the file names nothing of it, by
    /// that angle or another.
    pub fn new(
        (mut volume, mut mesh): (Volume, Mesh),
        scale: f64,
        angle: Option<f64>,
        other: f64,
    ) -> Self {
        volume.nodes.as_flattened_mut().iter_mut().for_each(|value| *value *= scale);
        mesh.vertices.as_flattened_mut().iter_mut().for_each(|value| *value *= scale);
        solid::divide(&mut mesh, angle, other);
        Self { volume, mesh }
    }

    /// What the file calls the nodes, as far as it has them.
    pub fn numbers(&self) -> &[u64] {
        &self.volume.numbers
    }

    /// Where the nodes are (m).
    pub fn places(&self) -> &[[f64; 3]] {
        &self.volume.nodes
    }

    /// The nodes of a zone, those on edges too, some of them several times.
    pub fn nodes_of(&self, zone: &Zone) -> impl Iterator<Item = usize> {
        zone.faces.iter().flat_map(|face| self.volume.faces[*face])
    }

    /// Why it is no body: where a tetrahedron is turned inside out.
    pub fn fault(&self) -> Option<String> {
        let inverted = self.volume.inverted()?;
        let corners = &self.volume.elements[inverted.element][..4];
        let middle =
            corners.iter().map(|node| DVec3::from(self.volume.nodes[*node])).sum::<DVec3>();
        let [x, y, z] = (0.25 * middle).to_array();
        Some(format!(
            "the tetrahedron {} around ({x:.4e}, {y:.4e}, {z:.4e}) m is flat or turned inside out: mesh the body anew, in Gmsh with `Mesh.HighOrderOptimize = 1`",
            inverted.element + 1
        ))
    }

    /// The body below z = 0, on which a flat face of it lies that looks along z and holds a place along x and y (m): that of this name,
    /// or the outermost one that nothing holds. It is turned over at z = 0 where the face looks down. `None` where there is no such
    /// face, or one on both sides; while no place is known, the upper one.
    pub fn below(
        &self,
        place: Option<[f64; 2]>,
        held: &SupportedSurfaces,
        named: Option<&str>,
    ) -> Option<ContactMesh> {
        let extent = self.mesh.extent();
        let level = |sign: f64| {
            let levels = (0..self.mesh.faces.len()).filter_map(|face| {
                let surface = &self.mesh.surfaces[self.mesh.faces[face].surface];
                let meant = match named {
                    Some(named) => surface == named,
                    None => !held.at(surface),
                };
                let normal = DVec3::from(self.mesh.area_vector(face)).normalize_or_zero();
                let flat = sign * normal.z > 1.0 - WRITTEN;
                let here = place.is_none_or(|place| self.holds(face, place));
                (meant && flat && here).then(|| sign * self.mesh.centre(face)[2])
            });
            levels.reduce(f64::max)
        };
        let (up, over) = match (level(1.0), level(-1.0)) {
            (Some(top), None) => (-top, false),
            (None, Some(bottom)) => (bottom, true),
            (Some(top), _) if place.is_none() => (-top, false),
            _ => return None,
        };
        let mut volume = self.volume.clone().placed(up, over);
        let mut mesh = self.mesh.clone();
        for vertex in &mut mesh.vertices {
            vertex[2] = if over { -(vertex[2] + up) } else { vertex[2] + up };
        }
        // Files carry seven digits.
        let flat = |place: &mut [f64; 3]| {
            if place[2].abs() <= WRITTEN * extent {
                place[2] = 0.0;
            }
        };
        volume.nodes.iter_mut().for_each(flat);
        mesh.vertices.iter_mut().for_each(flat);
        for face in mesh.faces.iter_mut().filter(|_| over) {
            if let Corners::Triangle([a, b, c]) = face.corners {
                face.corners = Corners::Triangle([a, c, b]);
            }
        }
        Some(ContactMesh {
            mesh,
            placed: false,
            volume: Some(Arc::new(volume)),
            ..ContactMesh::default()
        })
    }

    /// The body where it is, with a zone that may touch.
    pub fn placed(&self, zone: Zone) -> ContactMesh {
        let volume = Some(Arc::new(self.volume.clone()));
        ContactMesh { mesh: self.mesh.clone(), zone, placed: true, volume, reduced: None }
    }

    /// The triangles of the surface of that name.
    ///
    /// # Errors
    /// If there is no such surface.
    pub fn zone(&self, surface: &str) -> Result<Zone, MeshError> {
        self.mesh.zone(surface)
    }

    /// The triangles near a place.
    ///
    /// # Errors
    /// If there are none.
    pub fn near(&self, near: &Near, feature_angle: f64) -> Result<Zone, MeshError> {
        near.zone(self.mesh.clone(), feature_angle, [false; 2]).map(|(_, zone)| zone)
    }

    /// Whether a triangle, seen along z, holds a place (m).
    fn holds(&self, face: usize, place: [f64; 2]) -> bool {
        let corners = self.mesh.faces[face].corners.as_slice();
        let at = |corner: usize| DVec3::from(self.mesh.vertices[corners[corner]]).truncate();
        let place = DVec2::from(place);
        let sides = [0, 1, 2].map(|corner| {
            let (one, other) = (at(corner), at((corner + 1) % 3));
            (other - one).perp_dot(place - one)
        });
        let near = WRITTEN * self.mesh.extent().powi(2);
        sides.iter().all(|side| *side >= -near) || sides.iter().all(|side| *side <= near)
    }
}
