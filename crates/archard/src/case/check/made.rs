//! The mesh of a body, made once for all that is asked of it.

use glam::DVec3;

use crate::body::Elasticity;
use crate::body::mesh::Meshed;
use crate::case::definition::FiniteCase;
use crate::compliance::bem::Size;
use crate::parameters::Invalid;

/// A mesh and what follows from it.
pub(super) struct Made {
    pub meshed: Meshed,
    pub size: Size,
    /// Curvatures in the middle of the zone along x and y (1/m), where they are known.
    pub curvatures: Option<[f64; 2]>,
}

impl Made {
    pub fn of(finite: &FiniteCase) -> Result<Self, Invalid> {
        let shape = finite.mesh.build()?;
        let meshed = shape.mesh(finite.mirrored, &finite.held())?;
        let size = Size::of(&meshed, finite.interpolation);
        let unknowns = match finite.elasticity {
            Elasticity::BoundaryElements => size.unknowns,
            Elasticity::HalfSpace => 0,
        };
        Ok(Self { meshed, size: Size { unknowns, ..size }, curvatures: shape.curvatures() })
    }

    /// The middle of the zone (m) and the outward normal there.
    pub fn middle(&self, mirrored: [bool; 2]) -> (DVec3, DVec3) {
        if !self.meshed.placed {
            return (DVec3::ZERO, DVec3::Z);
        }
        let (mesh, zone) = (&self.meshed.mesh, &self.meshed.zone.faces);
        let (mut place, mut normal, mut all) = (DVec3::ZERO, DVec3::ZERO, 0.0);
        for &face in zone {
            let vector = DVec3::from(mesh.area_vector(face));
            place += vector.length() * DVec3::from(mesh.centre(face));
            normal += vector;
            all += vector.length();
        }
        // Both lie on the planes of symmetry.
        let kept = DVec3::new(f64::from(!mirrored[0]), f64::from(!mirrored[1]), 1.0);
        (kept * place / all, (kept * normal).normalize_or(DVec3::Z))
    }
}
