//! One solid that falls apart into faces, which supports and contact can name.

use glam::DVec3;

use super::super::parse;
use super::solids::{
    Triangle, ball, cube, mesh, meshed, near, problems, stl, turn, turned, values, zoned,
};
use crate::parameters::Value;

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

/// Names that a file already has are not given again.
#[test]
fn numbered_faces_keep_clear_of_names() {
    let mut cube = parse(stl(&cube()).as_bytes()).unwrap().mesh;
    cube.surfaces = vec!["a".to_owned(), "a_1".to_owned(), "a_4".to_owned()];
    cube.faces[0].surface = 1;
    cube.faces[1].surface = 1;
    cube.faces[2].surface = 2;
    cube.faces[3].surface = 2;
    cube.split(0.7, str::to_owned);
    let mut names = cube.surfaces.clone();
    names.sort();
    assert_eq!(names, ["a_1", "a_2", "a_3", "a_4", "a_5", "a_6"]);
    let surfaces: Vec<usize> = cube.faces.iter().map(|face| face.surface).collect();
    assert_eq!(cube.surfaces[surfaces[0]], "a_1");
    assert_eq!(cube.surfaces[surfaces[2]], "a_4");
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
    assert_eq!(problems(&parse(&bytes).unwrap().mesh, [false; 2]), [""; 0]);
    // Without its last triangle it is neither.
    bytes.truncate(bytes.len() - 50);
    let error = parse(&bytes).unwrap_err().to_string();
    assert!(error.contains("the file ends where"), "{error}");
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
