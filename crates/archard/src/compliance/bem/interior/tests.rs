//! Fields known in closed form, from their exact values on the surface.

use glam::{DMat3, DVec3};

use super::super::solid::Boundary;
use super::super::surface::Surface;
use super::super::tests::{GRADIENT, MATERIAL, cube, stress};
use super::hooke::Linear;
use super::{Interior, Response};
use crate::body::Interpolation;
use crate::body::mesh::Mesh;

/// The boundary of a body under a field.
fn under(surface: &Surface, field: impl Fn(DVec3) -> Response) -> Boundary {
    let nodes = surface.traction_nodes().iter();
    Boundary {
        displacement: surface.nodes.iter().map(|&place| field(place).displacement).collect(),
        traction: nodes.map(|node| field(node.place).stress * node.normal).collect(),
    }
}

fn linear(place: DVec3) -> Response {
    Response { displacement: GRADIENT * place, stress: stress(GRADIENT) }
}

/// Bending about y by moments at both ends: sigma_xx = z.
fn bending(place: DVec3) -> Response {
    let DVec3 { x, y, z } = place;
    let nu = MATERIAL.poisson;
    let displacement = DVec3::new(2.0 * x * z, -2.0 * nu * y * z, nu * (y * y - z * z) - x * x);
    Response {
        displacement: displacement / (2.0 * MATERIAL.young),
        stress: DMat3::from_diagonal(DVec3::new(z, 0.0, 0.0)),
    }
}

fn skewed(p: DVec3) -> DVec3 {
    DVec3::new(p.x + 0.3 * p.y + 0.2 * p.z, p.y - 0.2 * p.z, 1.5 * p.z)
}

/// Points from the middle of a unit cube to its surface, an edge and a corner.
fn points() -> impl Iterator<Item = DVec3> {
    let ends = [(0.61, 0.43, 1.0), (1.0, 0.43, 1.0), (1.0, 1.0, 1.0), (0.5, 0.0, 0.25)];
    ends.into_iter().flat_map(|end| {
        [0.1, 0.6, 0.9, 0.99, 0.9999, 1.0].map(|share| DVec3::splat(0.5).lerp(end.into(), share))
    })
}

fn distance(a: DMat3, b: DMat3) -> f64 {
    (a - b).to_cols_array().into_iter().map(f64::abs).fold(0.0, f64::max)
}

#[test]
fn linear_fields_come_out_at_any_depth() {
    for interpolation in [Interpolation::Continuous, Interpolation::Discontinuous] {
        for (triangles, divisions) in [(false, 1), (false, 3), (true, 2)] {
            let surface =
                Surface::new(&cube(divisions, triangles, skewed), interpolation, [false; 2]);
            let boundary = under(&surface, linear);
            let interior = Interior::new(&surface, &MATERIAL, &boundary, 1e-6);
            for point in points().map(skewed) {
                let found = interior.at(point).expect("it is inside");
                assert!(found.displacement.distance(GRADIENT * point) < 1e-12, "{point}");
                assert!(distance(found.stress, stress(GRADIENT)) < 1e-11, "{point}");
            }
            for found in interior.surface_stress() {
                assert!(distance(found, stress(GRADIENT)) < 1e-11);
            }
        }
    }
}

/// Without the field that is taken off, the kernels alone.
#[test]
fn the_identity_holds_to_the_tolerance() {
    let surface = Surface::new(&cube(2, false, skewed), Interpolation::Continuous, [false; 2]);
    let boundary = under(&surface, linear);
    let nothing = Linear { place: DVec3::ZERO, displacement: DVec3::ZERO, gradient: DMat3::ZERO };
    for tolerance in [1e-4, 1e-7] {
        let interior = Interior::new(&surface, &MATERIAL, &boundary, tolerance);
        for point in [[0.5; 3], [0.2, 0.7, 0.4], [0.9, 0.3, 0.05]].map(|p| skewed(p.into())) {
            let found = interior.integrate(point, &nothing);
            assert!(found.displacement.distance(GRADIENT * point) < 10.0 * tolerance, "{point}");
            assert!(distance(found.stress, stress(GRADIENT)) < 100.0 * tolerance, "{point}");
        }
    }
}

/// A quarter under a field that is symmetric about x = 0 and y = 0, seen from all four quarters.
#[test]
fn mirror_images_are_part_of_the_body() {
    let whole = cube(3, false, |place| place);
    let faces = whole.faces.iter().filter(|face| ![0, 2].contains(&face.surface));
    let quarter = Mesh { faces: faces.copied().collect(), ..whole.clone() };
    let gradient = DMat3::from_diagonal(DVec3::new(0.3, -0.2, 0.1));
    let field =
        |place: DVec3| Response { displacement: gradient * place, stress: stress(gradient) };
    for interpolation in [Interpolation::Continuous, Interpolation::Discontinuous] {
        let surface = Surface::new(&quarter, interpolation, [true; 2]);
        let boundary = under(&surface, field);
        let interior = Interior::new(&surface, &MATERIAL, &boundary, 1e-6);
        for point in [[0.0, 0.0, 0.5], [-0.9, 0.4, 0.2], [-0.3, -0.999, 0.9], [0.7, -0.1, 1.0]] {
            let found = interior.at(point.into()).expect("it is inside");
            assert!(found.displacement.distance(gradient * DVec3::from(point)) < 1e-12);
            assert!(distance(found.stress, stress(gradient)) < 1e-11);
        }
        assert!(interior.at(DVec3::new(-1.2, 0.5, 0.5)).is_none());
    }
}

#[test]
fn a_point_lies_inside_on_or_outside() {
    let surface = Surface::new(&cube(2, true, skewed), Interpolation::Continuous, [false; 2]);
    let depth = |point: [f64; 3]| surface.depth(skewed(point.into()));
    assert_eq!(depth([0.5, 0.5, 1.2]), None);
    assert_eq!(depth([-0.3, 0.5, 0.5]), None);
    assert!(depth([0.3, 0.2, 1.0]).is_some_and(|depth| depth < 1e-12));
    let below = depth([0.5, 0.5, 0.9]).expect("it is inside");
    assert!((below - 0.15).abs() < 1e-12, "{below}");
}

/// Largest errors of displacement and stress, relative to the largest of each, with exact values on that many
/// elements an edge.
fn errors(divisions: usize, interpolation: Interpolation) -> [f64; 2] {
    let surface = Surface::new(&cube(divisions, false, |place| place), interpolation, [false; 2]);
    let boundary = under(&surface, bending);
    let interior = Interior::new(&surface, &MATERIAL, &boundary, 1e-6);
    points().fold([0.0; 2], |errors, point| {
        let (found, exact) = (interior.at(point).expect("it is inside"), bending(point));
        let displacement = found.displacement.distance(exact.displacement) * MATERIAL.young;
        [errors[0].max(displacement), errors[1].max(distance(found.stress, exact.stress))]
    })
}

/// Displacements of continuous elements are of second order, and the errors of stresses, the largest of them 1, stay
/// small near edges and corners; discontinuous elements with their second derivatives meet both to the tolerance.
#[test]
fn bending_is_met_at_any_depth() {
    for interpolation in [Interpolation::Continuous, Interpolation::Discontinuous] {
        let (coarse, fine) = (errors(4, interpolation), errors(8, interpolation));
        let order = (coarse[0] / fine[0]).log2();
        let which = format!("{interpolation:?} {coarse:?} {fine:?}");
        let largest = |errors: [f64; 2]| errors[0].max(errors[1]);
        match interpolation {
            Interpolation::Continuous => {
                assert!(order > 1.9, "{which}");
                assert!(coarse[1] < 0.02 && fine[1] < 0.5 * coarse[1], "{which}");
            }
            Interpolation::Discontinuous => {
                assert!(largest(coarse) < 1e-6 && largest(fine) < 1e-6, "{which}");
            }
        }
    }
}
