//! Surface meshes of finite bodies.

/// A closed surface of triangles and quadrilaterals; open only on planes of symmetry.
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    /// Places of the vertices (m).
    pub vertices: Vec<[f64; 3]>,
    /// The faces.
    pub faces: Vec<Face>,
    /// Names of the surfaces.
    pub surfaces: Vec<String>,
}

/// One face of a mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Face {
    /// Its corners, counter-clockwise seen from outside.
    pub corners: Corners,
    /// The surface it belongs to.
    pub surface: usize,
}

/// The corners of a face, by vertex.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Corners {
    /// A triangle.
    Triangle([usize; 3]),
    /// A quadrilateral.
    Quad([usize; 4]),
}

impl Corners {
    /// The vertices in order.
    pub fn as_slice(&self) -> &[usize] {
        match self {
            Corners::Triangle(vertices) => vertices,
            Corners::Quad(vertices) => vertices,
        }
    }
}
