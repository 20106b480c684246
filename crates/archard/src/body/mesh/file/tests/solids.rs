//! Solids of triangles, as CAD programs write them, and the meshes that are made of them.

use std::fmt::Write;

use glam::DVec3;

use crate::body::mesh::{ContactMesh, MESHES, Mesh, SupportedSurfaces};
use crate::parameters::{Invalid, Value, Values};

pub(super) type Triangle = [DVec3; 3];

/// A text of one solid.
pub(super) fn stl(triangles: &[Triangle]) -> String {
    let mut text = "solid made by hand\n".to_owned();
    for triangle in triangles {
        text += "facet normal 0 0 0\nouter loop\n";
        for DVec3 { x, y, z } in triangle {
            writeln!(text, "vertex {x:e} {y:e} {z:e}").unwrap();
        }
        text += "endloop\nendfacet\n";
    }
    text + "endsolid\n"
}

/// Two triangles of a quadrilateral seen counter-clockwise.
pub(super) fn quad([a, b, c, d]: [DVec3; 4]) -> [Triangle; 2] {
    [[a, b, c], [a, c, d]]
}

/// A box between two corners.
pub(super) fn cuboid(low: DVec3, high: DVec3) -> Vec<Triangle> {
    let at = |x: usize, y: usize, z: usize| {
        let pick = |axis: usize, which: usize| [low[axis], high[axis]][which];
        DVec3::new(pick(0, x), pick(1, y), pick(2, z))
    };
    [
        [at(0, 0, 0), at(0, 1, 0), at(1, 1, 0), at(1, 0, 0)],
        [at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)],
        [at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1)],
        [at(1, 1, 0), at(0, 1, 0), at(0, 1, 1), at(1, 1, 1)],
        [at(0, 1, 0), at(0, 0, 0), at(0, 0, 1), at(0, 1, 1)],
        [at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1)],
    ]
    .into_iter()
    .flat_map(quad)
    .collect()
}

pub(super) fn cube() -> Vec<Triangle> {
    cuboid(DVec3::ZERO, DVec3::ONE)
}

/// A body of revolution about z from its profile, radius and height from the bottom up, in that many strips.
pub(super) fn turned(profile: &[[f64; 2]], strips: usize) -> Vec<Triangle> {
    let at = |[radius, height]: [f64; 2], strip: usize| {
        let angle = std::f64::consts::TAU * (strip % strips) as f64 / strips as f64;
        DVec3::new(radius * angle.cos(), radius * angle.sin(), height)
    };
    let mut triangles = vec![];
    for ends in profile.windows(2) {
        for strip in 0..strips {
            let [a, b] = [at(ends[0], strip), at(ends[0], strip + 1)];
            let [c, d] = [at(ends[1], strip + 1), at(ends[1], strip)];
            // At the poles two of the corners are one.
            triangles.extend(
                quad([a, b, c, d]).into_iter().filter(|[a, b, c]| a != b && b != c && c != a),
            );
        }
    }
    triangles
}

/// A ball of 1 m in strips of 180/n degrees.
pub(super) fn ball(strips: usize) -> Vec<Triangle> {
    let angle = |step: usize| std::f64::consts::PI * step as f64 / strips as f64;
    let profile: Vec<[f64; 2]> = (0..=strips)
        .map(|step| match step {
            0 => [0.0, -1.0],
            step if step == strips => [0.0, 1.0],
            step => [angle(step).sin(), -angle(step).cos()],
        })
        .collect();
    turned(&profile, 2 * strips)
}

pub(super) fn turn(triangle: &mut Triangle) {
    triangle.swap(0, 1);
}

/// Values of `mesh.file` for these triangles.
pub(super) fn values(triangles: &[Triangle]) -> Values {
    let mut values = Values::default();
    let bytes = stl(triangles).into_bytes();
    values.insert("path", Value::File { bytes: bytes.into(), name: "a.stl".to_owned() });
    values
}

pub(super) fn meshed(values: &Values, mirrored: [bool; 2]) -> Result<ContactMesh, Invalid> {
    let choice = MESHES.iter().find(|choice| choice.name == "file").unwrap();
    Ok((choice.build)(values)?.mesh(mirrored, &SupportedSurfaces::default())?)
}

pub(super) fn mesh(triangles: &[Triangle], mirrored: [bool; 2]) -> Mesh {
    meshed(&values(triangles), mirrored).unwrap().mesh
}

pub(super) fn near(middle: [f64; 3], size: f64, elements: Option<f64>) -> Value {
    let mut near = Values::default();
    near.insert("near", Value::Triple(middle));
    near.insert("size", Value::Number(size));
    if let Some(elements) = elements {
        near.insert("elements", Value::Number(elements));
    }
    Value::Section(near)
}

/// A mesh with the zone in a box.
pub(super) fn zoned(
    triangles: &[Triangle],
    zone: Value,
    mirrored: [bool; 2],
) -> Result<ContactMesh, Invalid> {
    let mut values = values(triangles);
    values.insert("contact", zone);
    meshed(&values, mirrored)
}

pub(super) fn problems(mesh: &Mesh, mirrored: [bool; 2]) -> Vec<String> {
    mesh.check(mirrored).iter().map(ToString::to_string).collect()
}
