//! Why a mesh file cannot be read.

use std::fmt;

/// A mesh file that cannot be read.
#[non_exhaustive]
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{place}: {fault}")]
pub struct MeshFileError {
    /// Where in the file.
    pub place: Place,
    /// What is wrong there.
    pub fault: Fault,
}

/// A place in a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Place {
    /// A line of a text, counted from 1.
    Line(usize),
    /// A byte of a binary file, counted from 0.
    Byte(usize),
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Place::Line(line) => write!(f, "line {line}"),
            Place::Byte(byte) => write!(f, "byte {byte}"),
        }
    }
}

/// What is wrong with a mesh file.
#[non_exhaustive]
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum Fault {
    /// Neither of the formats.
    #[error(
        "is neither a Gmsh mesh nor STL nor an input of CalculiX or Abaqus: save the body as .msh (2.2 or 4.1) or .inp, or its surface as .stl"
    )]
    UnknownFormat,
    /// A version of Gmsh's format that is not read.
    #[error(
        "version {version} of Gmsh's format: save it as 2.2 or 4.1 (Mesh.MshFileVersion = 4.1)"
    )]
    Version {
        /// As written.
        version: String,
    },
    /// A binary file of a machine with other numbers.
    #[error(
        "the binary numbers are not those of a machine of 64 bits: save the mesh as text (Mesh.Binary = 0)"
    )]
    Binary,
    /// The file stops too early.
    #[error("the file ends where {expected} should follow: save it once more")]
    Ends {
        /// What should follow.
        expected: &'static str,
    },
    /// Something else than expected.
    #[error("expected {expected}, found `{found}`")]
    Unexpected {
        /// What should stand there.
        expected: &'static str,
        /// What does.
        found: String,
    },
    /// A part of the file that has to be there.
    #[error("the part {section} is missing: save the mesh once more")]
    NoSection {
        /// Its heading.
        section: &'static str,
    },
    /// An element of a vertex that is not there.
    #[error(
        "an element names the vertex {vertex}, which is not in the file: save the mesh once more"
    )]
    NoVertex {
        /// Its number.
        vertex: u64,
    },
    /// A vertex number that is there twice.
    #[error("the vertex {vertex} is there twice: save the mesh once more")]
    VertexTwice {
        /// Its number.
        vertex: u64,
    },
    /// Curved surface elements.
    #[error(
        "elements of higher order (kind {kind}): mesh with straight ones (Mesh.ElementOrder = 1)"
    )]
    HigherOrder {
        /// Gmsh's number of the kind.
        kind: u64,
    },
    /// No tetrahedra, or other volume elements with them.
    #[error(
        "the elements are not tetrahedra of 4 or 10 nodes alone (C3D4, C3D10): mesh the body with these, in Gmsh by `gmsh -3 -order 2 -format inp`"
    )]
    NoTetrahedra,
    /// A kind of element that is not known.
    #[error("elements of the unknown kind {kind}: save triangles and quadrilaterals only")]
    UnknownKind {
        /// Gmsh's number of the kind.
        kind: u64,
    },
    /// Only volumes or curves.
    #[error(
        "no triangles or quadrilaterals among the elements: mesh the surface (gmsh -2) and save it, with a physical group for it if there are any"
    )]
    NoSurface,
}
