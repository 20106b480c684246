//! A zone that is picked by a place and divided.

use approx::assert_relative_eq;
use glam::DVec3;

use super::solids::{ball, cube, cuboid, meshed, near, problems, turned, values, zoned};
use crate::body::mesh::{ContactMesh, Corners};
use crate::parameters::{Value, Values};

fn longest(meshed: &ContactMesh) -> f64 {
    let length = |&face: &usize| {
        let corners = meshed.mesh.faces[face].corners;
        let place = |corner: usize| DVec3::from(meshed.mesh.vertices[corner]);
        corners.edges().map(|[a, b]| place(a).distance(place(b))).fold(0.0, f64::max)
    };
    meshed.zone.faces.iter().map(length).fold(0.0, f64::max)
}

/// The middle of a plane top, divided into elements of a twentieth of a box of 0.2 m: the rest stays coarse.
#[test]
fn a_zone_near_a_place_is_divided() {
    for mirrored in [[false; 2], [true, true]] {
        let mut triangles = cuboid(DVec3::new(-1.0, -1.0, -1.0), DVec3::new(1.0, 1.0, 0.0));
        if mirrored[0] {
            triangles = cuboid(DVec3::new(0.0, 0.0, -1.0), DVec3::new(1.0, 1.0, 0.0));
            triangles
                .retain(|corners| (0..2).all(|axis| corners.iter().any(|place| place[axis] > 0.0)));
        }
        let meshed = zoned(&triangles, near([0.0; 3], 0.2, Some(20.0)), mirrored).unwrap();
        assert_eq!(problems(&meshed.mesh, mirrored), [""; 0]);
        assert_relative_eq!(meshed.mesh.volume(mirrored), 4.0, max_relative = 1e-12);
        assert!(longest(&meshed) <= 0.01, "{}", longest(&meshed));
        let area: f64 = meshed
            .zone
            .faces
            .iter()
            .map(|&face| DVec3::from(meshed.mesh.area_vector(face)).length())
            .sum();
        let images = if mirrored[0] { 4.0 } else { 1.0 };
        assert_relative_eq!(images * area, 0.04, max_relative = 0.1);
        let count = meshed.mesh.faces.len();
        assert!(count < 2 * meshed.zone.faces.len() + 200, "{count}");
        assert!(meshed.has_plane_zone());
    }
}

/// On a ball of facets of 15 degrees new vertices lie on the ball, which facets miss by 0.9 % of the radius.
#[test]
fn a_divided_zone_is_as_round_as_it_is_meant() {
    let meshed = zoned(&ball(12), near([0.0, 0.0, 1.0], 0.2, Some(16.0)), [false; 2]).unwrap();
    assert_eq!(problems(&meshed.mesh, [false; 2]), [""; 0]);
    assert!(longest(&meshed) <= 0.2 / 16.0);
    for place in &meshed.mesh.vertices {
        assert_relative_eq!(DVec3::from(*place).length(), 1.0, max_relative = 4e-4);
    }
    let [x, y] = meshed.curvatures([false; 2]).expect("it is round");
    assert_relative_eq!(x, 1.0, max_relative = 0.03);
    assert_relative_eq!(y, 1.0, max_relative = 0.03);
    // The side of a cylinder is round across and straight along its axis; its rim stays on the circle.
    let cylinder = turned(&[[0.0, 0.0], [1.0, 0.0], [1.0, 2.0], [0.0, 2.0]], 36);
    let meshed = zoned(&cylinder, near([1.0, 0.0, 1.9], 0.3, Some(12.0)), [false; 2]).unwrap();
    assert_eq!(problems(&meshed.mesh, [false; 2]), [""; 0]);
    let side = meshed.mesh.vertices.iter().filter(|place| place[0].hypot(place[1]) > 0.9);
    for place in side {
        assert_relative_eq!(place[0].hypot(place[1]), 1.0, max_relative = 1e-5);
    }
    let normal = |&face: &usize| DVec3::from(meshed.mesh.area_vector(face)).normalize();
    assert!(meshed.zone.faces.iter().all(|face| normal(face).z.abs() < 0.1));
    let [x, y] = meshed.curvatures([false; 2]).expect("it is round");
    let (straight, round) = if x.abs() < y.abs() { (x, y) } else { (y, x) };
    assert_relative_eq!(round, 1.0, max_relative = 0.01);
    assert_eq!(straight, 0.0);
}

/// A plane that goes over into a rounding stays plane to its end.
#[test]
fn planes_beside_roundings_stay_plane() {
    let round = |step: usize| {
        let angle = std::f64::consts::FRAC_PI_2 * step as f64 / 9.0;
        [0.9 + 0.1 * angle.cos(), 0.9 + 0.1 * angle.sin()]
    };
    let mut profile = vec![[0.0, 0.0], [1.0, 0.0]];
    profile.extend((0..=9).map(round));
    profile.push([0.0, 1.0]);
    let pin = turned(&profile, 36);
    let meshed = zoned(&pin, near([0.0, 0.0, 1.0], 1.6, Some(8.0)), [false; 2]).unwrap();
    assert_eq!(problems(&meshed.mesh, [false; 2]), [""; 0]);
    let within = meshed.mesh.vertices.iter().filter(|[x, y, z]| x.hypot(*y) < 0.89 && *z > 0.5);
    let highest = within.map(|place| (place[2] - 1.0).abs()).fold(0.0, f64::max);
    assert!(highest < 1e-12, "{highest}");
    assert!(meshed.zone.faces.len() > 100);
}

/// A zone that reaches beyond an edge of the body ends there, on the side that is nearer.
#[test]
fn a_zone_ends_at_the_edge() {
    for (x, along) in [(0.95, 2), (1.0001, 0)] {
        let meshed = zoned(&cube(), near([x, 0.5, 0.97], 0.2, Some(8.0)), [false; 2]);
        let meshed = meshed.unwrap();
        let normals = meshed
            .zone
            .faces
            .iter()
            .map(|&face| DVec3::from(meshed.mesh.area_vector(face)).normalize());
        assert!(normals.clone().count() > 20);
        assert!(normals.clone().all(|normal| normal[along] > 0.999), "{x}");
        assert!(meshed.has_plane_zone());
    }
}

/// A place on an edge does not say which side is meant.
#[test]
fn a_place_on_an_edge_is_refused_unless_the_surface_is_named() {
    let refused = zoned(&cube(), near([1.0, 0.5, 1.0], 0.2, Some(8.0)), [false; 2]).unwrap_err();
    assert_eq!(refused.parameter, "contact.near");
    assert!(refused.message.contains("edge between `face_2`, `face_6`"), "{}", refused.message);
    let Value::Section(mut zone) = near([1.0, 0.5, 1.0], 0.2, Some(8.0)) else { unreachable!() };
    zone.insert("surface", Value::Word("face_2".to_owned()));
    let meshed = zoned(&cube(), Value::Section(zone), [false; 2]).unwrap();
    assert!(meshed.zone.faces.iter().all(|&face| meshed.mesh.area_vector(face)[2] > 0.0));
}

#[test]
fn files_beyond_any_machine_are_refused_at_once() {
    let refused = meshed(&values(&vec![cube()[0]; 100_001]), [false; 2]).unwrap_err();
    assert_eq!(refused.parameter, "path");
    assert!(
        refused.message.contains("100001 elements, 100000 are the most"),
        "{}",
        refused.message
    );
}

#[test]
fn places_with_nothing_near_say_where_the_body_is() {
    let refused = |zone: Value| zoned(&cube(), zone, [false; 2]).unwrap_err();
    let far = refused(near([1000.0, 500.0, 1000.0], 200.0, None));
    assert_eq!(far.parameter, "contact.near");
    assert!(far.message.contains("reaches from (0.0000e0, 0.0000e0, 0.0000e0)"), "{}", far.message);
    assert!(far.message.contains("`unit`"), "{}", far.message);
    // Elements are there, with their middles elsewhere.
    let coarse = refused(near([0.5, 0.5, 1.0], 0.1, None));
    assert!(
        coarse.message.contains("divide the elements there by `elements`"),
        "{}",
        coarse.message
    );
    let fine = refused(near([0.5, 0.5, 1.0], 0.8, Some(1e6)));
    assert_eq!(fine.parameter, "contact.elements");
    let mut named = Values::default();
    named.insert("near", Value::Triple([0.5, 0.5, 1.0]));
    named.insert("size", Value::Number(0.5));
    named.insert("surface", Value::Word("top".to_owned()));
    let unknown = refused(Value::Section(named));
    assert_eq!(unknown.parameter, "contact.surface");
    assert!(unknown.message.contains("it has `face_1`"), "{}", unknown.message);
}

/// Of two sides within the box the named one.
#[test]
fn a_zone_can_be_that_of_a_surface() {
    let plate = cuboid(DVec3::ZERO, DVec3::new(1.0, 1.0, 0.05));
    for (surface, up) in [("face_1", -1.0), ("face_2", 1.0)] {
        let Value::Section(mut zone) = near([0.5, 0.5, 0.02], 0.2, Some(4.0)) else {
            unreachable!()
        };
        zone.insert("surface", Value::Word(surface.to_owned()));
        let meshed = zoned(&plate, Value::Section(zone), [false; 2]).unwrap();
        assert!(meshed.zone.faces.iter().all(|&face| up * meshed.mesh.area_vector(face)[2] > 0.0));
    }
}

/// Quadrilaterals of Gmsh are divided into triangles where they have to be.
#[test]
fn quadrilaterals_are_divided_too() {
    let mut values = Values::default();
    let bytes = super::bytes(super::GMSH[2]);
    values.insert("path", Value::File { bytes: bytes.into(), name: "block.msh".to_owned() });
    values.insert("contact", near([0.0; 3], 10.0, Some(8.0)));
    let meshed = meshed(&values, [false; 2]).unwrap();
    assert_eq!(problems(&meshed.mesh, [false; 2]), [""; 0]);
    assert_relative_eq!(meshed.mesh.volume([false; 2]), 24e3, max_relative = 1e-6);
    assert!(longest(&meshed) <= 10.0 / 8.0);
    let triangle = |&face: &usize| matches!(meshed.mesh.faces[face].corners, Corners::Triangle(_));
    assert!(meshed.zone.faces.iter().all(triangle));
}
