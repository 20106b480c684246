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
    /// convex; `None` where they are not known.
    pub fn curvatures(&self) -> Option<[f64; 2]> {
        curvatures(&*self.profile, self.finite.as_ref().map(|finite| finite.curvatures))
    }
}

/// Curvatures 1/R along x and y (1/m) of a profile on a plane (`None`), or on a mesh of these curvatures.
pub(crate) fn curvatures(
    profile: &dyn Profile,
    mesh: Option<Option<[f64; 2]>>,
) -> Option<[f64; 2]> {
    let ([x, y], [mesh_x, mesh_y]) = (profile.curvatures()?, mesh.unwrap_or(Some([0.0; 2]))?);
    Some([x + mesh_x, y + mesh_y])
}

#[cfg(test)]
mod tests {
    use super::{curvatures, profile::PROFILES};
    use crate::parameters::{Value, Values};

    #[test]
    fn a_profile_bends_the_mesh_it_lies_on() {
        let sphere = PROFILES.iter().find(|choice| choice.name == "sphere").unwrap();
        let mut values = Values::default();
        values.insert("radius", Value::Number(0.5));
        let sphere = (sphere.build)(&values).unwrap();
        assert_eq!(curvatures(&*sphere, None), Some([2.0, 2.0]));
        assert_eq!(curvatures(&*sphere, Some(Some([3.0, 0.0]))), Some([5.0, 2.0]));
        assert_eq!(curvatures(&*sphere, Some(None)), None);
    }
}
