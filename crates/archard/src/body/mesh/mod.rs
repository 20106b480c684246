//! The surface of a finite body, divided into elements.
//!
//! A mesh is made by one of the generators (a box, a cylinder, a sphere) or read from a file. The
//! generators divide the zone that may touch into equal elements and let the others grow with the
//! distance from it. A new shape is one file here and one line in [`MESHES`].
//!
//! Where a plane of symmetry halves the body, only the part at positive x or y is meshed and the cut
//! is left open: `mirrored` says so, for x = 0 and y = 0.

mod axis;
mod block;
mod bounds;
mod builder;
mod check;
mod contact;
mod crossing;
mod curvatures;
mod cylinder;
mod divided;
mod file;
mod free;
mod listed;
mod measure;
#[doc(hidden)]
pub mod reduced;
mod refine;
mod rings;
mod shells;
mod smooth;
mod sphere;
mod tensor;
pub mod tetrahedron;
mod thickness;
mod volume;

#[doc(hidden)]
pub use check::MeshProblem;
pub use file::MeshFileError;
#[doc(hidden)]
pub use file::{Fault, Place};
#[doc(hidden)]
pub use free::SupportedSurfaces;
#[doc(hidden)]
pub use listed::MeshSurface;
#[doc(hidden)]
pub use reduced::ReducedMatrix;
#[doc(hidden)]
pub use volume::InvertedElement;
pub use volume::Volume;

pub use curvatures::axes;

use std::fmt::Debug;
use std::sync::Arc;

use crate::parameters::{Choice, Invalid};

/// A closed surface of triangles and quadrilaterals (open only on planes of symmetry).
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Mesh {
    /// Places of the corners (m).
    pub vertices: Vec<[f64; 3]>,
    /// The elements.
    pub faces: Vec<Face>,
    /// Names of the parts of the surface.
    pub surfaces: Vec<String>,
}

/// An element of the surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Face {
    /// Its corners.
    pub corners: Corners,
    /// The part of the surface it belongs to, an index into [`Mesh::surfaces`].
    pub surface: usize,
}

/// Indices of the corners of an element, counter-clockwise seen from outside.
#[doc(hidden)]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Corners {
    /// A triangle.
    Triangle([usize; 3]),
    /// A quadrilateral.
    Quad([usize; 4]),
}

impl Corners {
    /// The indices, one after the other.
    pub fn as_slice(&self) -> &[usize] {
        match self {
            Corners::Triangle(corners) => corners,
            Corners::Quad(corners) => corners,
        }
    }
}

/// The part of the surface that may touch.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Zone {
    /// Its elements, indices into [`Mesh::faces`].
    pub faces: Vec<usize>,
    /// The numbers of elements along x and y where the elements form a grid, x fastest. Each is then a
    /// [`Corners::Quad`] whose corners begin at low x and low y, then high x and low y.
    pub grid: Option<[usize; 2]>,
}

/// A surface with the part of it that may touch.
#[non_exhaustive]
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ContactMesh {
    /// The surface of the body.
    pub mesh: Mesh,
    /// The part that may touch; without elements where the body says nothing of contact.
    pub zone: Zone,
    /// Whether the coordinates are the body's true place (files). Otherwise the body lies below z = 0,
    /// the centre of the zone at the origin, the outward normal there along z.
    pub placed: bool,
    /// What is inside, its surface triangle by triangle that of the mesh; where a file says.
    pub volume: Option<Arc<Volume>>,
    /// How its nodes give way; where a file says.
    pub reduced: Option<Arc<ReducedMatrix>>,
}

/// A body whose surface can be divided into elements.
pub trait Shape: Debug + Send + Sync {
    /// The elements of the body, or of its part at positive x or y where the planes x = 0 or y = 0 are
    /// planes of symmetry. Where what is held leaves a free span, they follow the thickness.
    ///
    /// # Errors
    /// If the elements asked for cannot be made.
    fn mesh(&self, mirrored: [bool; 2], held: &SupportedSurfaces)
    -> Result<ContactMesh, MeshError>;

    /// A number of elements that the mesh has at least, known without making it.
    fn at_least(&self, mirrored: [bool; 2], held: &SupportedSurfaces) -> usize;

    /// The longest element along a free span over the thickness that bends there; `None` where nothing bends.
    fn slenderness(
        &self,
        meshed: &ContactMesh,
        mirrored: [bool; 2],
        held: &SupportedSurfaces,
    ) -> Option<f64>;

    /// A mesh that is coarse everywhere, for an image field of a load on a rectangle of that centre and size (m), or on one
    /// that is not known yet, below z = 0; `None` where the rectangle lies on no flat face, or an edge is so close that elements at it are more than any mesh has.
    fn coarse(
        &self,
        _rectangle: Option<[[f64; 2]; 2]>,
        _mirrored: [bool; 2],
        _held: &SupportedSurfaces,
    ) -> Option<ContactMesh> {
        None
    }

    /// The mesh with what is inside, its surface triangle by triangle that of the tetrahedra; `None` where nobody knows what is inside, or
    /// the zone takes other elements than it has.
    ///
    /// # Errors
    /// As [`Shape::mesh`].
    fn filled(&self) -> Option<Result<ContactMesh, MeshError>> {
        None
    }

    /// Curvatures 1/R along x and y (1/m) in the middle of the zone, positive where it is convex; `None` where
    /// they are not known.
    fn curvatures(&self) -> Option<[f64; 2]> {
        None
    }
}

/// The meshes a case can name.
pub const MESHES: &[Choice<Box<dyn Shape>>] =
    &[block::CHOICE, cylinder::CHOICE, sphere::CHOICE, file::CHOICE];

/// Why a body cannot be divided as asked for.
#[non_exhaustive]
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum MeshError {
    /// A plane of symmetry would cut through elements of the zone.
    #[error(
        "{count} elements along {axis}: the plane of symmetry {axis} = 0 halves them, take an even number"
    )]
    OddElements {
        /// The axis across the plane.
        axis: char,
        /// The elements asked for.
        count: usize,
    },
    /// A plane of symmetry would cut through elements of an evenly divided body.
    #[error("{count} divisions: the plane of symmetry {axis} = 0 halves them, take an even number")]
    OddDivisions {
        /// The axis across the plane.
        axis: char,
        /// The divisions asked for.
        count: usize,
    },
    /// No element near the place where a file may touch.
    #[error(
        "no element has its middle in the box of {}, the nearest place of the surface is {:.4e} m away from its middle: {}",
        sides(.size), .distance, advice(*.distance, .size, *.divided, .extent)
    )]
    NothingNear {
        /// The sides of the box (m).
        size: [f64; 3],
        /// Distance (m) of the surface from its middle.
        distance: f64,
        /// Whether elements have been divided there.
        divided: bool,
        /// The lowest and the highest corner of the box around the surface (m).
        extent: [[f64; 3]; 2],
    },
    /// A place between two smooth faces.
    #[error(
        "lies on the edge between {}: move it onto one of them, or name the `surface` that is meant",
        listed(.faces)
    )]
    OnEdge {
        /// The surfaces on both sides.
        faces: Vec<String>,
    },
    /// More elements than anyone can compute with.
    #[error(
        "more than 100000 elements would be needed for edges of {width:.4e} m there: take fewer, or a smaller box"
    )]
    TooFine {
        /// The longest edge allowed (m).
        width: f64,
    },
    /// A matrix that is not that of the zone.
    #[error("{message}")]
    Matrix {
        /// What is wrong, with the name of its file.
        message: String,
    },
    /// A file has no surface of that name.
    #[error("the file has no surface `{name}`; it has {}", listed(.known))]
    NoSurface {
        /// The name asked for.
        name: String,
        /// The names there are.
        known: Vec<String>,
    },
}

impl MeshError {
    /// The parameter to change, one of a table inside the table as `table.parameter`.
    pub fn parameter(&self) -> &'static str {
        match self {
            MeshError::OddElements { .. } => "contact.elements",
            MeshError::OddDivisions { .. } => "divisions",
            MeshError::NothingNear { .. } | MeshError::OnEdge { .. } => "contact.near",
            MeshError::TooFine { .. } => "contact.elements",
            MeshError::Matrix { .. } => "compliance",
            MeshError::NoSurface { .. } => "contact",
        }
    }
}

impl From<MeshError> for Invalid {
    fn from(error: MeshError) -> Self {
        Self::new(error.parameter(), error.to_string())
    }
}

fn listed(names: &[String]) -> String {
    let names: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
    names.join(", ")
}

/// Elements of a file beyond which no machine holds their equations.
const MOST_OF_A_FILE: usize = 100_000;

fn sides([x, y, z]: &[f64; 3]) -> String {
    format!("{x:.4e} by {y:.4e} by {z:.4e} m")
}

/// What to do where a box holds nothing.
fn advice(distance: f64, size: &[f64; 3], divided: bool, [low, high]: &[[f64; 3]; 2]) -> String {
    let reach = size.iter().map(|side| 0.25 * side * side).sum::<f64>().sqrt();
    if distance <= reach && !divided {
        return "take a larger `size`, or divide the elements there by `elements`".to_owned();
    }
    let place = |[x, y, z]: &[f64; 3]| format!("({x:.4e}, {y:.4e}, {z:.4e}) m");
    format!(
        "the body reaches from {} to {}; move `near` there, or see whether the `unit` of the file is right",
        place(low),
        place(high)
    )
}
