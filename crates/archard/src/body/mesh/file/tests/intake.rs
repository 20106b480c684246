//! What CAD programs write: surfaces that are turned over, of one solid, with faces to be found and a zone to be divided.

use std::fmt::Write;

use approx::assert_relative_eq;
use glam::DVec3;

use super::super::parse;
use crate::body::mesh::{Corners, MESHES, Mesh, Meshed, Supported};
use crate::parameters::{Invalid, Value, Values};

type Triangle = [DVec3; 3];

/// A text of one solid.
fn stl(triangles: &[Triangle]) -> String {
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
fn quad([a, b, c, d]: [DVec3; 4]) -> [Triangle; 2] {
    [[a, b, c], [a, c, d]]
}

/// A box between two corners.
fn cuboid(low: DVec3, high: DVec3) -> Vec<Triangle> {
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

fn cube() -> Vec<Triangle> {
    cuboid(DVec3::ZERO, DVec3::ONE)
}

/// A body of revolution about z from its profile, radius and height from the bottom up, in that many strips.
fn turned(profile: &[[f64; 2]], strips: usize) -> Vec<Triangle> {
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
fn ball(strips: usize) -> Vec<Triangle> {
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

fn turn(triangle: &mut Triangle) {
    triangle.swap(0, 1);
}

/// Values of `mesh.file` for these triangles.
fn values(triangles: &[Triangle]) -> Values {
    let mut values = Values::default();
    let bytes = stl(triangles).into_bytes();
    values.insert("path", Value::File { bytes, name: "a.stl".to_owned() });
    values
}

fn meshed(values: &Values, mirrored: [bool; 2]) -> Result<Meshed, Invalid> {
    let choice = MESHES.iter().find(|choice| choice.name == "file").unwrap();
    Ok((choice.build)(values)?.mesh(mirrored, &Supported::default())?)
}

fn mesh(triangles: &[Triangle], mirrored: [bool; 2]) -> Mesh {
    meshed(&values(triangles), mirrored).unwrap().mesh
}

fn near(middle: [f64; 3], size: f64, elements: Option<f64>) -> Value {
    let mut near = Values::default();
    near.insert("near", Value::Triple(middle));
    near.insert("size", Value::Number(size));
    if let Some(elements) = elements {
        near.insert("elements", Value::Number(elements));
    }
    Value::Section(near)
}

/// A mesh with the zone in a box.
fn zoned(triangles: &[Triangle], zone: Value, mirrored: [bool; 2]) -> Result<Meshed, Invalid> {
    let mut values = values(triangles);
    values.insert("contact", zone);
    meshed(&values, mirrored)
}

fn problems(mesh: &Mesh, mirrored: [bool; 2]) -> Vec<String> {
    mesh.check(mirrored).iter().map(ToString::to_string).collect()
}

#[test]
fn closed_surfaces_turn_their_outside_out() {
    for turned in [0b1111_1111_1111, 0b0101_0010_0110, 1] {
        let mut triangles = cube();
        for (bit, triangle) in triangles.iter_mut().enumerate() {
            if turned >> bit & 1 == 1 {
                turn(triangle);
            }
        }
        let mesh = mesh(&triangles, [false; 2]);
        assert_eq!(problems(&mesh, [false; 2]), [""; 0]);
        assert_relative_eq!(mesh.volume([false; 2]), 1.0, max_relative = 1e-12);
    }
}

#[test]
fn halves_turn_their_outside_out() {
    // Without the sides at x = 0 and y = 0.
    let mut quarter = cube();
    quarter.retain(|corners| (0..2).all(|axis| corners.iter().any(|place| place[axis] > 0.0)));
    for mirrored in [[true, true], [true, false]] {
        let mut triangles = quarter.clone();
        if !mirrored[1] {
            let side = cube();
            triangles.extend(side.iter().filter(|corners| corners.iter().all(|p| p.y == 0.0)));
        }
        triangles.iter_mut().step_by(2).for_each(turn);
        let mesh = mesh(&triangles, mirrored);
        assert_eq!(problems(&mesh, mirrored), [""; 0]);
        let images = mirrored.iter().filter(|one| **one).count() as i32;
        assert_relative_eq!(mesh.volume(mirrored), 2f64.powi(images), max_relative = 1e-12);
    }
}

#[test]
fn cavities_face_inwards() {
    for [outer, inner] in [[false, false], [true, false], [true, true]] {
        let [mut shell, mut cavity, mut core] = [
            cube(),
            cuboid(DVec3::splat(0.25), DVec3::splat(0.75)),
            cuboid(DVec3::splat(0.4), DVec3::splat(0.6)),
        ];
        if outer {
            shell.iter_mut().for_each(turn);
        }
        if inner {
            cavity.iter_mut().for_each(turn);
        }
        let hollow = mesh(&[shell.clone(), cavity.clone()].concat(), [false; 2]);
        assert_relative_eq!(hollow.volume([false; 2]), 1.0 - 0.125, max_relative = 1e-12);
        assert_eq!(problems(&hollow, [false; 2]), [""; 0]);
        // A body in the cavity is one of its own.
        core.iter_mut().for_each(turn);
        let two = mesh(&[shell, cavity, core].concat(), [false; 2]);
        assert_relative_eq!(two.volume([false; 2]), 1.0 - 0.125 + 0.008, max_relative = 1e-12);
        let said = problems(&two, [false; 2]);
        assert!(said.len() == 1 && said[0].contains("that of 2 bodies"), "{said:?}");
    }
}

#[test]
fn bodies_beside_each_other_are_refused() {
    let other = cuboid(DVec3::new(2.0, 0.0, 0.0), DVec3::new(3.0, 1.0, 1.0));
    let said = problems(&mesh(&[cube(), other].concat(), [false; 2]), [false; 2]);
    assert!(
        said.len() == 1 && said[0].contains("that of 2 bodies, the second at x = 2"),
        "{said:?}"
    );
    assert!(said[0].contains("BooleanUnion"));
}

#[test]
fn open_surfaces_stay_as_they_are_and_gmsh_is_told() {
    let mut triangles = cube();
    triangles.remove(0);
    turn(&mut triangles[5]);
    let mesh = mesh(&triangles, [false; 2]);
    let plain = parse(stl(&triangles).as_bytes()).unwrap();
    assert_eq!(mesh.faces.len(), plain.faces.len());
    assert!(mesh.faces.iter().zip(&plain.faces).all(|(one, other)| one.corners == other.corners));
    let said = problems(&mesh, [false; 2]);
    assert!(
        said[0].contains("open: 3 edges") && said[0].contains("removeDuplicateNodes"),
        "{said:?}"
    );
    assert!(said[1].contains("setOutwardOrientation"), "{said:?}");
}

/// A band with half a twist has no outside.
#[test]
fn what_has_no_outside_is_refused() {
    let place = |step: usize, side: f64| {
        let turn = std::f64::consts::TAU * step as f64 / 12.0;
        let width = 0.3 * side * if step == 12 { -1.0 } else { 1.0 };
        let turn = if step == 12 { 0.0 } else { turn };
        let radius = 1.0 + width * (0.5 * turn).cos();
        DVec3::new(radius * turn.cos(), radius * turn.sin(), width * (0.5 * turn).sin())
    };
    let band: Vec<Triangle> = (0..12)
        .flat_map(|step| {
            quad([place(step, -1.0), place(step + 1, -1.0), place(step + 1, 1.0), place(step, 1.0)])
        })
        .collect();
    let said = problems(&mesh(&band, [false; 2]), [false; 2]);
    assert!(said.iter().any(|one| one.contains("is open")), "{said:?}");
}

#[test]
fn one_solid_falls_apart_into_faces() {
    let names = |triangles: &[Triangle]| mesh(triangles, [false; 2]).surfaces;
    assert_eq!(names(&cube()), ["face_1", "face_2", "face_3", "face_4", "face_5", "face_6"]);
    let cylinder = [[0.0, 0.0], [1.0, 0.0], [1.0, 2.0], [0.0, 2.0]];
    assert_eq!(names(&turned(&cylinder, 12)), ["face_1", "face_2", "face_3"]);
    // Strips of 60 degrees are a prism.
    assert_eq!(names(&turned(&cylinder, 6)).len(), 2 + 6);
    assert_eq!(names(&ball(12)), ["made by hand"]);
    // Turned elements do not part a face.
    let mut mixed = cube();
    mixed.iter_mut().step_by(2).for_each(turn);
    assert_eq!(names(&mixed).len(), 6);
}

#[test]
fn the_angle_of_edges_can_be_set() {
    let mut values = values(&turned(&[[0.0, 0.0], [1.0, 0.0], [1.0, 2.0], [0.0, 2.0]], 12));
    for (angle, count) in [(25.0, 14), (35.0, 3), (100.0, 1)] {
        values.insert("feature_angle", Value::Number(f64::to_radians(angle)));
        let found = meshed(&values, [false; 2]).unwrap().mesh.surfaces;
        assert_eq!(found.len(), count, "{angle} {found:?}");
    }
}

#[test]
fn triangles_of_two_places_are_dropped_and_needles_are_not() {
    let mut triangles = cube();
    let [a, b, _] = triangles[0];
    triangles.extend([[a, b, b], [a, a, a]]);
    assert_eq!(problems(&mesh(&triangles, [false; 2]), [false; 2]), [""; 0]);
    // A needle halves an edge on one side only.
    let needle = [triangles[0][0], 0.5 * (triangles[0][0] + triangles[0][1]), triangles[0][1]];
    triangles.push(needle);
    let said = problems(&mesh(&triangles, [false; 2]), [false; 2]);
    assert!(said[0].contains("1 elements have no area"), "{said:?}");
}

#[test]
fn a_binary_file_may_begin_with_solid() {
    let triangles = cube();
    let mut bytes = b"solid is what some programs write here".to_vec();
    bytes.resize(80, b' ');
    bytes.extend((triangles.len() as u32).to_le_bytes());
    for triangle in &triangles {
        bytes.extend([0; 12]);
        for value in triangle.iter().flat_map(DVec3::to_array) {
            bytes.extend((value as f32).to_le_bytes());
        }
        bytes.extend([0; 2]);
    }
    assert_eq!(problems(&parse(&bytes).unwrap(), [false; 2]), [""; 0]);
    // Without its last triangle it is neither.
    bytes.truncate(bytes.len() - 50);
    let error = parse(&bytes).unwrap_err().to_string();
    assert!(
        error.contains("expected `facet` or `endsolid`") || error.contains("line 1"),
        "{error}"
    );
}

fn longest(meshed: &Meshed) -> f64 {
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
    values.insert("path", Value::File { bytes, name: "block.msh".to_owned() });
    values.insert("contact", near([0.0; 3], 10.0, Some(8.0)));
    let meshed = meshed(&values, [false; 2]).unwrap();
    assert_eq!(problems(&meshed.mesh, [false; 2]), [""; 0]);
    assert_relative_eq!(meshed.mesh.volume([false; 2]), 24e3, max_relative = 1e-6);
    assert!(longest(&meshed) <= 10.0 / 8.0);
    let triangle = |&face: &usize| matches!(meshed.mesh.faces[face].corners, Corners::Triangle(_));
    assert!(meshed.zone.faces.iter().all(triangle));
}

#[test]
fn surfaces_are_listed_with_place_and_size() {
    let meshed = zoned(&cube(), near([0.5, 0.5, 1.0], 0.4, Some(4.0)), [false; 2]).unwrap();
    let listed = meshed.mesh.listed(&meshed.zone);
    assert_eq!(listed.len(), 6);
    let top = &listed[1];
    assert_eq!((top.middle, top.size), ([0.5, 0.5, 1.0], [1.0, 1.0, 0.0]));
    assert_eq!(top.touching, meshed.zone.faces.len());
    let said = listed[0].to_string();
    assert!(said.contains("on `face_1`, 1000 x 1000 x 0 mm around (500, 500, 0) mm"), "{said}");
}
