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
