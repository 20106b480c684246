use super::MeshProblem;
use crate::body::mesh::builder::Builder;
use crate::body::mesh::tensor::{SIDES, block};
use crate::body::mesh::{Corners, Face, Mesh};

/// A cube of 1 m at positive x, y and z, two elements an edge.
fn cube(mirrored: [bool; 2]) -> Mesh {
    let mut builder = Builder::new(1.0);
    let axis = &[0.0, 0.5, 1.0][..];
    block(&mut builder, [axis; 3], mirrored, SIDES, |place| place);
    builder.finish()
}

fn messages(mesh: &Mesh, mirrored: [bool; 2]) -> Vec<String> {
    mesh.check(mirrored).iter().map(ToString::to_string).collect()
}

#[track_caller]
fn only(mesh: &Mesh, mirrored: [bool; 2], expected: &str) {
    let messages = messages(mesh, mirrored);
    assert!(messages.len() == 1 && messages[0].contains(expected), "{messages:?}");
}

#[test]
fn good_surfaces_have_no_problems() {
    for mirrored in [[false, false], [true, false], [false, true], [true, true]] {
        assert_eq!(messages(&cube(mirrored), mirrored), [""; 0]);
    }
}

#[test]
fn open_and_branching_surfaces_are_found() {
    only(&cube([true, false]), [false, false], "open: 8 edges");
    let mut mesh = cube([false, false]);
    let first = mesh.faces.remove(0);
    only(&mesh, [false, false], "open: 4 edges");
    mesh.faces.push(first);
    let Corners::Quad([a, b, c, d]) = first.corners else { unreachable!() };
    mesh.faces.push(Face { corners: Corners::Quad([d, c, b, a]), ..first });
    let messages = messages(&mesh, [false, false]);
    assert!(messages[0].contains("1 elements are there twice"), "{messages:?}");
    assert!(messages[1].contains("4 edges belong to more than two"), "{messages:?}");
}

#[test]
fn orientation_is_checked() {
    let mut mesh = cube([false, false]);
    let turn = |face: &mut Face| {
        if let Corners::Quad(corners) = &mut face.corners {
            corners.reverse();
        }
    };
    turn(&mut mesh.faces[3]);
    only(&mesh, [false, false], "neighbours at 4 edges");
    turn(&mut mesh.faces[3]);
    mesh.faces.iter_mut().for_each(turn);
    only(&mesh, [false, false], "encloses -1.000e0 m^3");
    let mut mesh = cube([true, true]);
    mesh.faces.iter_mut().for_each(turn);
    only(&mesh, [true, true], "encloses -4.000e0 m^3");
}

#[test]
fn planes_of_symmetry_are_kept_clear() {
    let mut mesh = cube([true, false]);
    mesh.vertices.iter_mut().for_each(|vertex| vertex[0] -= 0.25);
    let found = messages(&mesh, [true, false]);
    assert!(found[0].contains("lie at negative x, the first at x = -2.5000e-1 m"), "{found:?}");
    only(&cube([false, false]), [true, false], "4 elements lie on the plane of symmetry x = 0");
}

#[test]
fn poor_elements_are_warned_of() {
    let mut mesh = cube([false, false]);
    mesh.vertices.iter_mut().for_each(|vertex| vertex[2] *= 40.0);
    only(&mesh, [false, false], "16 elements are more than 20 times");
    assert!(mesh.check([false, false])[0].is_warning());
    let mut mesh = cube([false, false]);
    mesh.vertices.push([3.0; 3]);
    only(&mesh, [false, false], "1 vertices belong to no element");
    let middle = mesh.vertices.iter().position(|place| *place == [0.5, 0.5, 1.0]).unwrap();
    mesh.vertices.pop();
    mesh.vertices[middle] = [0.5, 0.5, 1.4];
    let messages = messages(&mesh, [false, false]);
    assert!(messages.iter().any(|message| message.contains("far from flat")), "{messages:?}");
    mesh.vertices[middle] = [0.1, 0.1, 1.0];
    only(&mesh, [false, false], "1 quadrilaterals have a corner that points inwards");
}

#[test]
fn what_cannot_be_used_is_said_alone() {
    assert_eq!(Mesh::default().check([false; 2]), [MeshProblem::Empty]);
    let mut mesh = cube([false, false]);
    mesh.faces[0].corners = Corners::Triangle([0, 1, 99]);
    only(&mesh, [false; 2], "element 0 names the vertex 99");
    let mut mesh = cube([false, false]);
    mesh.vertices[0][0] = f64::NAN;
    only(&mesh, [false; 2], "1 vertices lie nowhere");
    let mut mesh = cube([false, false]);
    let corner = mesh.vertices[0];
    mesh.vertices.iter_mut().for_each(|vertex| vertex[2] = corner[2]);
    assert!(mesh.check([false; 2]).iter().any(|p| matches!(p, MeshProblem::Flat { .. })));
}
