//! A body: what it is made of, what shape it has, whether it wears.

mod finite;
mod material;
pub mod mesh;
pub mod profile;

pub use finite::{Elasticity, Finite, Interpolation, Support};
pub use material::{Material, contact_modulus};
pub use profile::Profile;

use crate::wear::WearLaw;

/// One of the two bodies in contact.
///
/// A body is an elastic half-space whose surface is the plane of contact less the recess of its
/// profile, unless it is rigid or of finite shape.
#[derive(Debug)]
pub struct Body {
    /// The user's name for it; result columns carry it.
    pub name: String,
    /// The shape of its surface near the contact.
    pub profile: Box<dyn Profile>,
    /// What it is made of; `None` for a rigid body.
    pub material: Option<Material>,
    /// Its surface where it is of finite shape; `None` for a half-space.
    pub finite: Option<Finite>,
    /// How it wears; `None` if it does not.
    pub wear: Option<Box<dyn WearLaw>>,
}

impl Body {
    /// Curvatures 1/R along x and y (1/m) of the surface in the middle of the contact, positive where it is
    /// convex: of the profile on a plane, or on the mesh. `None` where they are not known.
    pub fn curvatures(&self) -> Option<[f64; 2]> {
        let mesh = self.finite.as_ref().map_or(Some([0.0; 2]), |finite| finite.curvatures);
        let ([x, y], [mesh_x, mesh_y]) = (self.profile.curvatures()?, mesh?);
        Some([x + mesh_x, y + mesh_y])
    }
}

#[cfg(test)]
mod tests {
    use super::mesh::Meshed;
    use super::{Body, Elasticity, Finite, Interpolation, profile::PROFILES};
    use crate::parameters::{Value, Values};

    /// A sphere of 0.5 m, on a mesh of these curvatures where there is one.
    fn sphere(mesh: Option<Option<[f64; 2]>>) -> Body {
        let sphere = PROFILES.iter().find(|choice| choice.name == "sphere").unwrap();
        let mut values = Values::default();
        values.insert("radius", Value::Number(0.5));
        let finite = mesh.map(|curvatures| Finite {
            meshed: Meshed::default(),
            curvatures,
            supports: vec![],
            mirrored: [false; 2],
            interpolation: Interpolation::default(),
            tolerance: 1e-3,
            elasticity: Elasticity::default(),
        });
        let profile = (sphere.build)(&values).unwrap();
        Body { name: String::new(), profile, material: None, finite, wear: None }
    }

    #[test]
    fn a_profile_bends_the_mesh_it_lies_on() {
        assert_eq!(sphere(None).curvatures(), Some([2.0, 2.0]));
        assert_eq!(sphere(Some(Some([3.0, 0.0]))).curvatures(), Some([5.0, 2.0]));
        assert_eq!(sphere(Some(None)).curvatures(), None);
    }
}
