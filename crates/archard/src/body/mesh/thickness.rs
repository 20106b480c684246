//! How long elements are against the thickness of the body below them, for meshes of any shape.
//!
//! A ray from the middle of an element along its inward normal meets the other side at the local thickness. It
//! counts where neither side is held, the sides face away from each other, and the body reaches further from what
//! holds it than it is thick there.

use glam::DVec3;
use rayon::prelude::*;

use super::free::{self, SupportedSurfaces};
use super::{ContactMesh, Mesh};
use crate::numerics::{SAME, WRITTEN};

/// Share of the surface that may have longer elements: at sharp edges any element is longer than the body is thick,
/// and thin places next to holes do not bend.
const FEW: f64 = 0.1;
/// Cosine between outward normals below which sides face away from each other.
const OPPOSITE: f64 = -0.5;

/// An element and its mirror images.
struct Side {
    middle: DVec3,
    normal: DVec3,
    /// Its corners, of all triangles it is folded into.
    triangles: Vec<[DVec3; 3]>,
    area: f64,
    length: f64,
    held: bool,
}

/// The longest element against the thickness that bends below it, all but a few; `None` where nothing bends.
pub(super) fn longest(
    meshed: &ContactMesh,
    mirrored: [bool; 2],
    held: &SupportedSurfaces,
) -> Option<f64> {
    let mesh = &meshed.mesh;
    let own: Vec<Side> = (0..mesh.faces.len()).map(|face| side(mesh, face, held)).collect();
    let held_at: Vec<DVec3> = own.iter().filter(|one| one.held).map(|one| one.middle).collect();
    let reach = own
        .par_iter()
        .map(|one| held_at.iter().map(|at| at.distance(one.middle)).fold(f64::INFINITY, f64::min))
        .filter(|distance| distance.is_finite())
        .reduce(|| 0.0, f64::max);
    let beside = |one: &Side| -> Option<(f64, f64)> {
        let thickness = thickness(one, &own, mirrored).filter(|_| !one.held)?;
        free::bends(thickness, reach).then_some((one.length / thickness, one.area))
    };
    let mut found: Vec<(f64, f64)> = own.par_iter().filter_map(beside).collect();
    found.sort_by(|one, other| other.0.total_cmp(&one.0));
    let all: f64 = own.iter().map(|one| one.area).sum();
    let mut area = 0.0;
    let beyond = found.iter().find(|(_, own)| {
        area += own;
        area > FEW * all
    });
    beyond.map(|(longest, _)| *longest)
}

fn side(mesh: &Mesh, face: usize, held: &SupportedSurfaces) -> Side {
    let corners = mesh.faces[face].corners.as_slice().iter();
    let corners: Vec<DVec3> = corners.map(|&corner| mesh.vertices[corner].into()).collect();
    let next = corners.iter().cycle().skip(1);
    let mut edges: Vec<f64> = corners.iter().zip(next).map(|(a, b)| a.distance(*b)).collect();
    edges.sort_by(f64::total_cmp);
    // A square folded into triangles has diagonals, which are no lengths of elements.
    let length = edges[if corners.len() == 3 { 1 } else { 3 }];
    let vector = DVec3::from(mesh.area_vector(face));
    let triangles = (2..corners.len()).map(|at| [corners[0], corners[at - 1], corners[at]]);
    Side {
        middle: corners.iter().sum::<DVec3>() / corners.len() as f64,
        normal: vector.normalize_or_zero(),
        triangles: triangles.collect(),
        area: vector.length(),
        length,
        held: held.at(&mesh.surfaces[mesh.faces[face].surface]),
    }
}

/// The distance (m) to the other side, if that is not held and faces away.
fn thickness(one: &Side, all: &[Side], mirrored: [bool; 2]) -> Option<f64> {
    let signs = |mirrored: bool| if mirrored { &[1.0, -1.0][..] } else { &[1.0] };
    let [along_x, along_y] = mirrored.map(signs);
    let mut nearest: Option<(f64, bool)> = None;
    for (x, y) in along_x.iter().flat_map(|x| along_y.iter().map(move |y| (*x, *y))) {
        let image = DVec3::new(x, y, 1.0);
        // The ray is mirrored in place of the body.
        let (from, along) = (image * one.middle, -image * one.normal);
        for other in all {
            let hits = other.triangles.iter().filter_map(|corners| hit(from, along, corners));
            for distance in hits.filter(|distance| *distance > WRITTEN * one.length) {
                if nearest.is_none_or(|(known, _)| distance < known) {
                    let away = along.dot(other.normal) > -OPPOSITE;
                    nearest = Some((distance, away && !other.held));
                }
            }
        }
    }
    nearest.filter(|(_, counts)| *counts).map(|(distance, _)| distance)
}

/// Where a ray meets a triangle (T. Moeller and B. Trumbore, *Journal of Graphics Tools* 2, 1997).
fn hit(from: DVec3, along: DVec3, [a, b, c]: &[DVec3; 3]) -> Option<f64> {
    let (one, other) = (*b - *a, *c - *a);
    let across = along.cross(other);
    let determinant = one.dot(across);
    if determinant == 0.0 {
        return None;
    }
    let offset = from - *a;
    let u = offset.dot(across) / determinant;
    let turned = offset.cross(one);
    let v = along.dot(turned) / determinant;
    let inside = u >= -SAME && v >= -SAME && u + v <= 1.0 + SAME;
    inside.then(|| other.dot(turned) / determinant)
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::super::free::SupportedSurfaces;
    use super::super::{ContactMesh, MESHES};
    use super::longest;
    use crate::parameters::{Value, Values};

    /// A box of so many divisions.
    fn cuboid(size: [f64; 3], divisions: [f64; 3], mirrored: [bool; 2]) -> ContactMesh {
        let mut values = Values::default();
        values.insert("size", Value::Triple(size));
        values.insert("divisions", Value::Triple(divisions));
        let choice = MESHES.iter().find(|choice| choice.name == "box").unwrap();
        (choice.build)(&values).unwrap().mesh(mirrored, &SupportedSurfaces::default()).unwrap()
    }

    fn held(surfaces: &[&str]) -> SupportedSurfaces {
        surfaces.iter().map(|name| ((*name).to_owned(), [true; 3])).collect()
    }

    #[test]
    fn elements_are_measured_by_the_free_thickness_below_them() {
        let of = |size, divisions, mirrored, surfaces: &[&str]| {
            longest(&cuboid(size, divisions, mirrored), mirrored, &held(surfaces))
        };
        let whole = [false; 2];
        let beam = |mirrored| of([10.0, 1.0, 0.8], [8.0, 4.0, 4.0], mirrored, &["left"]).unwrap();
        assert_relative_eq!(beam(whole), 1.25 / 0.8, max_relative = 1e-9);
        assert_relative_eq!(beam([false, true]), 1.25 / 0.8, max_relative = 1e-9);
        // A layer does not bend, nor does a cube, nor what nothing holds.
        assert_eq!(of([10.0, 10.0, 0.8], [8.0, 8.0, 4.0], whole, &["bottom"]), None);
        assert_eq!(of([1.0, 1.0, 1.0], [1.0, 1.0, 1.0], whole, &["bottom"]), None);
        assert_eq!(of([10.0, 1.0, 1.0], [8.0, 4.0, 4.0], whole, &[]), None);
    }
}
