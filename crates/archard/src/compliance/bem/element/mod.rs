//! Boundary elements: how displacements and tractions vary over a face of the mesh.
//!
//! An element is its reference face, its nodes there and its shape functions, polynomials in 1, s, t and
//! s t. A new one is one file here and one line in [`ELEMENTS`].

mod quad;
mod triangle;

use crate::body::Interpolation;

/// A kind of element on quadrilaterals or triangles.
#[derive(Debug, PartialEq)]
pub struct Element {
    /// What it is called.
    pub name: &'static str,
    /// Reference coordinates (s, t) of the corners of the face.
    pub corners: &'static [[f64; 2]],
    /// Coordinates of a place on the face as polynomials: for each corner, what it counts for.
    pub map: &'static [Polynomial],
    /// Reference coordinates of the nodes.
    pub nodes: &'static [[f64; 2]],
    /// Shape function of each node.
    pub shape: &'static [Polynomial],
    /// The square of s and t at all of the nodes, where they have one, and squares of both are added to the shape
    /// functions for what bends between the nodes: see [`CURVATURES`].
    pub curvature: Option<f64>,
    /// Whether the nodes are the corners, and neighbours share their displacements.
    pub continuous: bool,
}

/// Functions that vanish at the nodes, (s^2 - c) / 2 and (t^2 - c) / 2: what they are multiplied by are second
/// derivatives along s and t, found from the nodes around.
pub const CURVATURES: usize = 2;

/// Coefficients of 1, s, t and s t.
pub type Polynomial = [f64; 4];

/// The elements there are: continuous ones first, quadrilaterals before triangles.
pub const ELEMENTS: &[Element] =
    &[quad::CONTINUOUS, triangle::CONTINUOUS, quad::DISCONTINUOUS, triangle::DISCONTINUOUS];

/// The element on a face of that many corners.
pub fn element(interpolation: Interpolation, corners: usize) -> &'static Element {
    match (interpolation, corners) {
        (Interpolation::Continuous, 3) => &ELEMENTS[1],
        (Interpolation::Continuous, _) => &ELEMENTS[0],
        (Interpolation::Discontinuous, 3) => &ELEMENTS[3],
        (Interpolation::Discontinuous, _) => &ELEMENTS[2],
    }
}

/// The value of a polynomial.
pub fn evaluate(polynomial: &Polynomial, [s, t]: [f64; 2]) -> f64 {
    let [one, along_s, along_t, both] = polynomial;
    one + along_s * s + along_t * t + both * s * t
}
