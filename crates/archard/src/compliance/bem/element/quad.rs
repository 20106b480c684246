//! Quadrilaterals with four nodes, on the reference square of side 2.

use super::{Element, Polynomial};

const CORNERS: &[[f64; 2]] = &[[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];

/// Bilinear in s and t, one at a corner and zero at the others.
const MAP: &[Polynomial] = &[
    [0.25, -0.25, -0.25, 0.25],
    [0.25, 0.25, -0.25, -0.25],
    [0.25, 0.25, 0.25, 0.25],
    [0.25, -0.25, 0.25, -0.25],
];

/// 1 / sqrt(3): the points of the 2 by 2 rule of Gauss.
const GAUSS: f64 = 0.577_350_269_189_625_8;
/// sqrt(3) / 4.
const SLOPE: f64 = 0.25 / GAUSS;

/// Nodes at the corners.
pub(super) const CONTINUOUS: Element = Element {
    name: "continuous quadrilateral",
    corners: CORNERS,
    map: MAP,
    nodes: CORNERS,
    shape: MAP,
    curvature: None,
    continuous: true,
};

/// Nodes at the points of Gauss, where the shape functions are orthogonal on parallelograms.
pub(super) const DISCONTINUOUS: Element = Element {
    name: "discontinuous quadrilateral",
    corners: CORNERS,
    map: MAP,
    nodes: &[[-GAUSS, -GAUSS], [GAUSS, -GAUSS], [GAUSS, GAUSS], [-GAUSS, GAUSS]],
    shape: &[
        [0.25, -SLOPE, -SLOPE, 0.75],
        [0.25, SLOPE, -SLOPE, -0.75],
        [0.25, SLOPE, SLOPE, 0.75],
        [0.25, -SLOPE, SLOPE, -0.75],
    ],
    curvature: Some(GAUSS * GAUSS),
    continuous: false,
};
