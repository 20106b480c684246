//! Triangles with three nodes, on the reference triangle 0 <= s, t and s + t <= 1.

use super::{Element, Polynomial};

const CORNERS: &[[f64; 2]] = &[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];

/// Linear in s and t, one at a corner and zero at the others.
const MAP: &[Polynomial] = &[[1.0, -1.0, -1.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]];

const THIRD: f64 = 1.0 / 3.0;

/// Nodes at the corners.
pub(super) const CONTINUOUS: Element = Element {
    name: "continuous triangle",
    corners: CORNERS,
    map: MAP,
    nodes: CORNERS,
    shape: MAP,
    curvature: None,
    continuous: true,
};

/// Nodes at the points of Gauss of the second degree, where the shape functions are orthogonal.
pub(super) const DISCONTINUOUS: Element = Element {
    name: "discontinuous triangle",
    corners: CORNERS,
    map: MAP,
    nodes: &[[0.5 * THIRD, 0.5 * THIRD], [2.0 * THIRD, 0.5 * THIRD], [0.5 * THIRD, 2.0 * THIRD]],
    shape: &[[5.0 * THIRD, -2.0, -2.0, 0.0], [-THIRD, 2.0, 0.0, 0.0], [-THIRD, 0.0, 2.0, 0.0]],
    curvature: None,
    continuous: false,
};
