//! A body: what it is made of, what shape it has, whether it wears.

mod finite;
mod layer;
mod material;
pub mod mesh;
pub mod profile;
mod thermal;

pub use finite::{Elasticity, Finite, Interpolation, Support};
pub use layer::Layer;
pub use material::{Material, contact_modulus};
pub use profile::Profile;
pub use thermal::Thermal;

use std::sync::Arc;

use crate::parameters::{Parameter, Quantity};
use crate::wear::WearLaw;

/// One of the two bodies in contact.
///
/// A body is an elastic half-space whose surface is the plane of contact less the recess of its
/// profile, unless it is rigid or of finite shape.
#[derive(Debug, Clone)]
pub struct Body {
    /// The user's name for it; result columns carry it.
    pub name: String,
    /// The shape of its surface near the contact.
    pub profile: Arc<dyn Profile>,
    /// What it is made of, below its layers; `None` for a rigid body.
    pub material: Option<Material>,
    /// Layers from its surface down.
    pub layers: Vec<Layer>,
    /// Its surface where it is of finite shape; `None` for a half-space.
    pub finite: Option<Finite>,
    /// How it wears; `None` if it does not.
    pub wear: Option<Arc<dyn WearLaw>>,
    /// In plane strain: how far below the contact (m) its approach and shift are measured from, a length that a line of
    /// contact by itself leaves open. `None` for the [default](Body::depths).
    pub depth: Option<f64>,
    /// Its density (kg/m^3), to weigh what is worn off; `None` where it is not known.
    pub density: Option<f64>,
    /// Indentation hardness (Pa) of its material at the surface: elastic pressures above it are doubted. `None` where it is not
    /// known.
    pub indentation_hardness: Option<f64>,
    /// How it conducts heat; `None` where that is not known.
    pub thermal: Option<Thermal>,
    /// The largest pressure (Pa) it bears: it yields under that one, elastic and perfectly plastic. `None` where it stays elastic.
    pub hardness: Option<f64>,
}

impl Body {
    /// A rigid body of that name and profile that does not wear.
    ///
    /// Result columns carry the name: letters, digits, `_` and `-`.
    pub fn new(name: impl Into<String>, profile: impl Profile + 'static) -> Self {
        let profile = Arc::new(profile);
        Self {
            name: name.into(),
            profile,
            material: None,
            layers: vec![],
            finite: None,
            wear: None,
            depth: None,
            density: None,
            indentation_hardness: None,
            thermal: None,
            hardness: None,
        }
    }

    /// What a hardness is; its quantity is read from cases.
    pub const HARDNESS: Parameter = Parameter::optional(
        "hardness",
        Quantity::Pressure,
        "largest pressure the body bears, under which it yields and keeps the imprint",
    );

    /// What a density is; its quantity is read from cases.
    pub const DENSITY: Parameter = Parameter::optional(
        "density",
        Quantity::Measured { name: "a density", unit: "kg/m^3" },
        "density, to weigh what is worn off",
    );

    /// What to write for a name that cannot be one.
    pub const NAMES: &str = "use letters, digits, _ and - (and not `total`)";

    /// Whether a body of a case can be called that: its name becomes part of the names of columns and files.
    pub fn is_name(name: &str) -> bool {
        let fits = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | '-');
        !name.is_empty() && name != "total" && name.chars().all(fits)
    }

    /// The same body, elastic, of that material.
    #[must_use]
    pub fn material(self, material: Material) -> Self {
        Self { material: Some(material), ..self }
    }

    /// The same body under these layers, from the surface down.
    #[must_use]
    pub fn layers(self, layers: impl Into<Vec<Layer>>) -> Self {
        Self { layers: layers.into(), ..self }
    }

    /// How thick its layers are together (m).
    pub fn coated(&self) -> f64 {
        self.layers.iter().map(|layer| layer.thickness).sum()
    }

    /// What it is made of at its surface; `None` for a rigid body.
    pub fn uppermost(&self) -> Option<&Material> {
        self.layers.first().map(|layer| &layer.material).or(self.material.as_ref())
    }

    /// The same body, worn by that law.
    #[must_use]
    pub fn wear(self, law: impl WearLaw + 'static) -> Self {
        Self { wear: Some(Arc::new(law)), ..self }
    }

    /// The same body, its approach and shift in plane strain measured from that depth (m).
    #[must_use]
    pub fn depth(self, depth: f64) -> Self {
        Self { depth: Some(depth), ..self }
    }

    /// The same body of that density (kg/m^3), so that what is worn off it is weighed.
    #[must_use]
    pub fn density(self, density: f64) -> Self {
        Self { density: Some(density), ..self }
    }

    /// Hardness (Pa): the largest pressure it bears, or else that of its law of wear, or else that of its material.
    pub fn known_hardness(&self) -> Option<f64> {
        let of_law = || self.wear.as_ref().and_then(|law| law.hardness());
        self.hardness.or_else(of_law).or(self.indentation_hardness)
    }

    /// The same body of a material of that indentation hardness (Pa).
    #[must_use]
    pub fn indentation_hardness(self, hardness: f64) -> Self {
        Self { indentation_hardness: Some(hardness), ..self }
    }

    /// The same body, conducting heat like that.
    #[must_use]
    pub fn thermal(self, thermal: Thermal) -> Self {
        Self { thermal: Some(thermal), ..self }
    }

    /// The same body, yielding under that pressure (Pa).
    #[must_use]
    pub fn hardness(self, hardness: f64) -> Self {
        Self { hardness: Some(hardness), ..self }
    }

    /// The pressure (Pa) under which the softer of two bodies yields; infinite where none does.
    pub fn softest(bodies: &[Self; 2]) -> f64 {
        let known = bodies.iter().filter_map(|body| body.hardness);
        known.fold(f64::INFINITY, f64::min)
    }

    /// The power of the distance by which the sharper of two bodies recedes from where it is sharpest.
    pub fn sharpest(bodies: &[Self; 2]) -> f64 {
        bodies.iter().map(|body| body.profile.sharpest()).fold(2.0, f64::min)
    }

    /// Where the surfaces of two bodies are known: the least and the largest place along x and y (m).
    pub fn known(bodies: &[Self; 2]) -> [[f64; 2]; 2] {
        let [one, two] = bodies.each_ref().map(|body| body.profile.extent());
        [0, 1].map(|axis| [one[axis][0].max(two[axis][0]), one[axis][1].min(two[axis][1])])
    }

    /// The depths (m) of bodies that touch along a line within that width (m): where none is given the radius of the
    /// rounder one along x, and at least the width.
    pub fn depths(bodies: [&Self; 2], width: f64) -> [f64; 2] {
        let curvature = |body: &Self| body.curvatures().map_or(0.0, |[x, _]| x.abs());
        let sharpest = curvature(bodies[0]).max(curvature(bodies[1]));
        let default = if sharpest > 0.0 { sharpest.recip().max(width) } else { 10.0 * width };
        bodies.map(|body| body.depth.unwrap_or(default))
    }

    /// The same body with that meshed surface, which its profile lies on, in place of a half-space.
    #[must_use]
    pub fn finite(self, finite: Finite) -> Self {
        Self { finite: Some(finite), ..self }
    }

    /// Whether it deforms as a half-space with an image field.
    pub fn has_image(&self) -> bool {
        self.finite.as_ref().is_some_and(|finite| finite.elasticity == Elasticity::Image)
    }

    /// Whether the nodes of its elements bear the contact.
    pub fn carries(&self) -> bool {
        self.finite.as_ref().is_some_and(|finite| finite.elasticity.bears())
    }

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
    use super::mesh::ContactMesh;
    use super::{Body, Elasticity, Finite, Interpolation, profile::Sphere};

    /// A sphere of 0.5 m, on a mesh of these curvatures where there is one.
    fn sphere(mesh: Option<Option<[f64; 2]>>) -> Body {
        let finite = mesh.map(|curvatures| Finite {
            meshed: ContactMesh::default(),
            curvatures,
            supports: vec![],
            mirrored: [false; 2],
            interpolation: Interpolation::default(),
            tolerance: 1e-3,
            elasticity: Elasticity::default(),
        });
        Body { finite, ..Body::new("sphere", Sphere::new(0.5).unwrap()) }
    }

    #[test]
    fn a_profile_bends_the_mesh_it_lies_on() {
        assert_eq!(sphere(None).curvatures(), Some([2.0, 2.0]));
        assert_eq!(sphere(Some(Some([3.0, 0.0]))).curvatures(), Some([5.0, 2.0]));
        assert_eq!(sphere(Some(None)).curvatures(), None);
    }
}
