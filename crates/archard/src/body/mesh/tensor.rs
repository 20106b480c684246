//! Patches of quadrilaterals on a rectangle of two parameters, and the six sides of a block.

use super::axis::Axis;
use super::builder::Builder;

/// Adds the elements between rows of places, `u` fastest; with `place(u, v)` a map whose image is
/// seen from outside as u to the right and v upwards.
pub(super) fn patch(
    builder: &mut Builder,
    surface: usize,
    [u, v]: [&[f64]; 2],
    place: impl Fn(f64, f64) -> [f64; 3],
) {
    let columns = u.len();
    let mut vertices = Vec::with_capacity(columns * v.len());
    for &v in v {
        vertices.extend(u.iter().map(|&u| builder.vertex(place(u, v))));
    }
    for row in 1..v.len() {
        for column in 1..columns {
            let low = (row - 1) * columns + column - 1;
            let high = low + columns;
            let corners = [vertices[low], vertices[low + 1], vertices[high + 1], vertices[high]];
            builder.quad(surface, corners);
        }
    }
}

/// Names of the sides of a block: towards +z, -z, -x, +x, -y, +y.
pub(super) const SIDES: [&str; 6] = ["top", "bottom", "left", "right", "front", "back"];

/// Adds the sides of a block with these divisions (rising places), each vertex moved by `place`; the
/// sides on planes of symmetry are left out. Sides of one name are one part of the surface.
pub(super) fn block(
    builder: &mut Builder,
    [x, y, z]: [&[f64]; 3],
    mirrored: [bool; 2],
    names: [&str; 6],
    place: impl Fn([f64; 3]) -> [f64; 3],
) {
    let end = |axis: &[f64]| (axis[0], axis[axis.len() - 1]);
    let ((left, right), (front, back), (bottom, top)) = (end(x), end(y), end(z));
    let [on_top, below, on_left, on_right, in_front, behind] = names;
    let mut side = |name: &str, axes: [&[f64]; 2], at: &dyn Fn(f64, f64) -> [f64; 3]| {
        let surface = builder.surface(name);
        patch(builder, surface, axes, |u, v| place(at(u, v)));
    };
    side(on_top, [x, y], &|u, v| [u, v, top]);
    side(below, [y, x], &|u, v| [v, u, bottom]);
    side(on_right, [y, z], &|u, v| [right, u, v]);
    side(behind, [z, x], &|u, v| [v, back, u]);
    if !mirrored[0] {
        side(on_left, [z, y], &|u, v| [left, v, u]);
    }
    if !mirrored[1] {
        side(in_front, [x, z], &|u, v| [u, front, v]);
    }
}

/// The elements of the middle of a patch, where `first` is the patch's first element.
pub(super) fn middle(first: usize, x: &Axis, y: &Axis) -> Vec<usize> {
    let columns = x.places.len() - 1;
    y.zone
        .clone()
        .flat_map(|row| x.zone.clone().map(move |column| first + row * columns + column))
        .collect()
}
