//! The mesh of a body, how it is held, and what it deforms as.

use super::chosen::ChosenPart;
use super::definition::{BuildError, FrameCase};
use archard::body::mesh::{ContactMesh, MeshSurface, Shape, SupportedSurfaces};
use archard::body::{Elasticity, Finite, Interpolation, Support};
use archard::parameters::Invalid;

/// Why finite elements do not carry a body.
const NOT_FILLED: &str = "finite elements take a file with tetrahedra alone, whose elements on `contact` stay as they are: leave its `elements` out, and mesh the body finer there";

/// Why there is no compliance of a body.
const NO_MATRIX: &str = "is missing: the file of the stiffness or flexibility of the body, which `elasticity = \"compliance\"` takes";

/// The mesh of a body and how it is held.
#[non_exhaustive]
#[derive(Debug, Clone, PartialEq)]
pub struct FiniteCase {
    /// The mesh.
    pub mesh: ChosenPart<Box<dyn Shape>>,
    /// What is known on surfaces, by name.
    pub supports: Vec<(String, Support)>,
    /// Whether x = 0 and y = 0 are planes of symmetry.
    pub mirrored: [bool; 2],
    /// How tractions and displacements vary over the elements.
    pub interpolation: Interpolation,
    /// Relative error allowed in the integrals over elements.
    pub tolerance: f64,
    /// How the body deforms.
    pub elasticity: Elasticity,
    /// Why, where the case does not say so.
    pub(crate) why: Option<&'static str>,
}

/// Why a body has no image field.
pub(super) const NO_IMAGE: &str = "an image field takes a body that touches with a flat face, and a frame or zone that ends before the face does: of a `box`, smaller than its top; of a `file` with tetrahedra, on the one flat face along z that nothing holds, or on the face that `contact` names. Without a `[frame]`, `elasticity = \"finite_elements\"` lets the tetrahedra of a file bear the contact on any face that `contact` names";

impl FiniteCase {
    /// The mesh; with an image field a coarse one that knows of no contact.
    ///
    /// # Errors
    /// If it cannot be made; that of a checked case can.
    pub fn meshed(&self) -> Result<ContactMesh, BuildError> {
        if self.elasticity == Elasticity::Image {
            return self.coarse(self.zone().map(|(size, _)| [[0.0; 2], size]));
        }
        if self.elasticity.bears() {
            return self.filled();
        }
        Ok(self.mesh.build()?.mesh(self.mirrored, &self.held())?)
    }

    /// The mesh with the tetrahedra inside.
    fn filled(&self) -> Result<ContactMesh, BuildError> {
        if self.mirrored != [false; 2] {
            let message = "finite elements are those of the whole body: mesh all of it, and leave `symmetry` out";
            return Err(Invalid::new("path", message).into());
        }
        let missing = || Invalid::new("path", NOT_FILLED);
        let meshed = self.mesh.build()?.filled().ok_or_else(missing)??;
        if self.elasticity == Elasticity::Reduced && meshed.reduced.is_none() {
            return Err(Invalid::new("compliance", NO_MATRIX).into());
        }
        Ok(meshed)
    }

    /// The surfaces that supports hold; none where a half-space stands for the body.
    pub(super) fn held(&self) -> SupportedSurfaces {
        let bends = self.elasticity != Elasticity::HalfSpace;
        let supports = self.supports.iter().filter(|_| bends);
        supports.map(|(name, support)| (name.clone(), support.holds())).collect()
    }

    /// Whether the body touches with a surface of that name, where an image field says how it deforms.
    pub(super) fn touches_with(&self, surface: &str) -> bool {
        match self.mesh.values.word("contact") {
            Some(named) => named == surface,
            None => self.mesh.choice.name == "box" && surface == "top",
        }
    }

    /// The size (m) of the zone that may touch and its pairs along x and y, where the mesh says so: two for each element, as its nodes
    /// would be.
    pub(super) fn zone(&self) -> Option<([f64; 2], [usize; 2])> {
        let contact = self.mesh.values.section("contact")?;
        Some((contact.pair("size")?, contact.pair("elements")?.map(|count| 2 * count as usize)))
    }

    /// A coarse mesh of the whole body for an image field of loads on a rectangle of that centre and size (m) of its face, where it is known.
    fn coarse(&self, rectangle: Option<[[f64; 2]; 2]>) -> Result<ContactMesh, BuildError> {
        if self.mesh.values.get("path").is_some() && self.mirrored != [false; 2] {
            let message = "an image field is that of the whole body: mesh all of it, and leave `symmetry` out";
            return Err(Invalid::new("path", message).into());
        }
        let coarse = self.mesh.build()?.coarse(rectangle, [false; 2], &self.held());
        coarse.ok_or_else(|| Invalid::new("size", NO_IMAGE).into())
    }

    /// The surfaces of a file, in its own places; `None` of a generated mesh, which has none.
    pub(super) fn listed(&self) -> Option<Vec<MeshSurface>> {
        self.mesh.values.get("path")?;
        let ContactMesh { mesh, zone, .. } =
            self.mesh.build().ok()?.mesh(self.mirrored, &self.held()).ok()?;
        Some(mesh.listed(&zone))
    }

    /// The longest element of its mesh along a free span over the thickness there; `None` where nothing bends.
    ///
    /// # Errors
    /// As [`FiniteCase::meshed`].
    pub(super) fn slenderness(&self, meshed: &ContactMesh) -> Result<Option<f64>, BuildError> {
        Ok(self.mesh.build()?.slenderness(meshed, self.mirrored, &self.held()))
    }

    /// Builds the body's surface; supports of surfaces that are not there are left out.
    ///
    /// # Errors
    /// As [`FiniteCase::meshed`].
    pub fn build(&self, frame: &FrameCase) -> Result<Finite, BuildError> {
        let shape = self.mesh.build()?;
        // Image fields are those of whole bodies.
        let (meshed, mirrored) = match self.elasticity {
            Elasticity::Image => (self.coarse(Some([frame.centre, frame.size]))?, [false; 2]),
            own if own.bears() => (self.filled()?, self.mirrored),
            _ => (shape.mesh(self.mirrored, &self.held())?, self.mirrored),
        };
        let curvatures = match (self.elasticity, meshed.placed) {
            (Elasticity::Image, _) => Some([0.0; 2]),
            (_, true) => meshed.curvatures(self.mirrored),
            (_, false) => shape.curvatures(),
        };
        let surface = |name: &str| meshed.mesh.surfaces.iter().position(|known| known == name);
        let supports = self
            .supports
            .iter()
            .filter_map(|(name, support)| Some((surface(name)?, *support)))
            .collect();
        let Self { interpolation, tolerance, elasticity, .. } = *self;
        Ok(Finite { meshed, curvatures, supports, mirrored, interpolation, tolerance, elasticity })
    }
}
