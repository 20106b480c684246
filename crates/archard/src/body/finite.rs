//! A body of finite shape, meshed on its surface.

use super::mesh::ContactMesh;

/// A meshed surface, how it is held, and how fields vary over its elements.
#[derive(Debug, Clone, PartialEq)]
pub struct Finite {
    /// The surface and the part of it that may touch.
    pub meshed: ContactMesh,
    /// Curvatures 1/R along x and y (1/m) in the middle of that part, as of [`Shape::curvatures`].
    ///
    /// [`Shape::curvatures`]: super::mesh::Shape::curvatures
    pub curvatures: Option<[f64; 2]>,
    /// What is known on surfaces, by their index; the others bear no traction.
    pub supports: Vec<(usize, Support)>,
    /// Whether x = 0 and y = 0 are planes of symmetry.
    pub mirrored: [bool; 2],
    /// How tractions and displacements vary over the elements.
    pub interpolation: Interpolation,
    /// Relative error allowed in the integrals over elements.
    pub tolerance: f64,
    /// How the body deforms.
    pub elasticity: Elasticity,
}

/// What says how a meshed body deforms.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Elasticity {
    /// Its own shape and supports.
    #[default]
    BoundaryElements,
    /// Its own shape and supports, as a half-space with an image field: the zone lies on a flat face, and the mesh says nothing of it,
    /// and the frame divides it. The mesh is coarse; halved once, it says how far the image field is off.
    Image,
    /// Its own shape and supports, by the tetrahedra inside it: its nodes on the zone are the pairs, and its elements bear what acts there.
    FiniteElements,
    /// A matrix that its file gives: its nodes on the zone are the pairs, as of finite elements.
    Reduced,
    /// A half-space in its place: the mesh gives the pairs and their gap only.
    HalfSpace,
}

impl Elasticity {
    /// Whether the mesh of the body itself deforms, with the zone as it is.
    pub fn is_own(self) -> bool {
        matches!(self, Self::BoundaryElements | Self::FiniteElements | Self::Reduced)
    }

    /// Whether the nodes of its elements bear the contact, in the mean over what lies around them.
    pub fn bears(self) -> bool {
        matches!(self, Self::FiniteElements | Self::Reduced)
    }
}

/// What is known on a surface away from the contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Support {
    /// No displacement.
    Clamped,
    /// No displacement along the normal, no traction across it.
    Roller,
    /// Displacements (m) along x, y and z; `None` leaves a direction without traction.
    Displacement([Option<f64>; 3]),
    /// A traction (Pa) along x, y and z.
    Traction([f64; 3]),
    /// A pressure (Pa) against the surface.
    Pressure(f64),
}

impl Support {
    /// The axes along which displacements are known; of a roller the normal alone, whatever its axis.
    pub fn holds(&self) -> [bool; 3] {
        match self {
            Support::Clamped | Support::Roller => [true; 3],
            Support::Displacement(given) => given.map(|one| one.is_some()),
            Support::Traction(_) | Support::Pressure(_) => [false; 3],
        }
    }

    /// Whether it displaces or loads the body, and does not only hold it.
    pub fn loads(&self) -> bool {
        match self {
            Support::Clamped | Support::Roller => false,
            Support::Displacement(given) => {
                given.iter().any(|one| one.is_some_and(|one| one != 0.0))
            }
            Support::Traction(traction) => *traction != [0.0; 3],
            Support::Pressure(pressure) => *pressure != 0.0,
        }
    }
}

/// How tractions and displacements vary over elements.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Interpolation {
    /// Nodes at the corners, displacements the same on all faces that meet there.
    Continuous,
    /// Nodes inside every face, at points of Gauss: more accurate, and without edges or corners.
    #[default]
    Discontinuous,
}
