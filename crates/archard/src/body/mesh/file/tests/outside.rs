//! Surfaces that are turned over, cavities, and parts that are no one body.

use approx::assert_relative_eq;
use glam::DVec3;

use super::super::parse;
use super::solids::{Triangle, cube, cuboid, mesh, near, problems, quad, stl, turn, zoned};

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

/// Two parts that were never united, as CAD writes them: overlapping, one on the other with the larger face on either,
/// and a bar through a cube, no corner and no middle of either in the other.
#[test]
fn parts_that_touch_or_cross_are_refused() {
    let parts = [
        ([0.8, 0.3, 0.3], [1.7, 0.7, 0.7]),
        ([0.3, 0.3, 0.8], [0.7, 0.7, 1.7]),
        ([1.0, -0.2, -0.2], [2.0, 1.2, 1.2]),
        ([1.0, 0.3, 0.3], [2.0, 0.7, 0.7]),
        ([-0.5, 0.4, 1.0], [1.5, 0.6, 1.1]),
        ([-5.0, 0.4, 0.4], [7.0, 0.6, 0.6]),
        ([0.0, 0.3, 0.3], [0.5, 0.7, 0.7]),
    ];
    for (low, high) in parts {
        let other = cuboid(low.into(), high.into());
        for triangles in [[cube(), other.clone()].concat(), [other.clone(), cube()].concat()] {
            let said = problems(&mesh(&triangles, [false; 2]), [false; 2]);
            assert!(
                said.iter().any(|one| one.contains("touch or cross at x = ")),
                "{low:?}: {said:?}"
            );
        }
    }
    // So near that it could be meant, and still apart.
    let beside = cuboid(DVec3::new(1.0 + 1e-6, 0.0, 0.0), DVec3::new(2.0, 1.0, 1.0));
    let said = problems(&mesh(&[cube(), beside].concat(), [false; 2]), [false; 2]);
    assert!(said.len() == 1 && said[0].contains("that of 2 bodies"), "{said:?}");
}

/// Files in single precision miss the plane of symmetry by a little: a zone is divided there all the same.
#[test]
fn vertices_near_a_plane_of_symmetry_lie_on_it() {
    let mirrored = [true; 2];
    let mut triangles = cuboid(DVec3::new(0.0, 0.0, -1.0), DVec3::new(1.0, 1.0, 0.0));
    triangles.retain(|corners| (0..2).all(|axis| corners.iter().any(|place| place[axis] > 0.0)));
    for place in triangles.iter_mut().flatten() {
        let [x, y] = [place.x, place.y].map(|at| if at == 0.0 { 3e-8 } else { at });
        (place.x, place.y) = (x, y);
    }
    let known = zoned(&triangles, near([0.0; 3], 0.2, Some(20.0)), mirrored).unwrap();
    assert_eq!(problems(&known.mesh, mirrored), [""; 0]);
}

#[test]
fn open_surfaces_stay_as_they_are_and_gmsh_is_told() {
    let mut triangles = cube();
    triangles.remove(0);
    turn(&mut triangles[5]);
    let mesh = mesh(&triangles, [false; 2]);
    let plain = parse(stl(&triangles).as_bytes()).unwrap().mesh;
    assert_eq!(mesh.faces.len(), plain.faces.len());
    assert!(mesh.faces.iter().zip(&plain.faces).all(|(one, other)| one.corners == other.corners));
    let said = problems(&mesh, [false; 2]);
    assert!(
        said[0].contains("open: 3 edges") && said[0].contains("removeDuplicateNodes"),
        "{said:?}"
    );
    assert!(said[0].contains("the first from the vertex x = "), "{said:?}");
    assert!(said[1].contains("setOutwardOrientation"), "{said:?}");
}

/// Programs compute a corner once for each triangle, and not always to the same bits.
#[test]
fn corners_that_differ_by_rounding_leave_no_gap() {
    let mut triangles = cube();
    for (index, corner) in triangles.iter_mut().flatten().enumerate() {
        *corner += 1e-15 * index as f64;
    }
    let plain = parse(stl(&triangles).as_bytes()).unwrap().mesh;
    assert_eq!((plain.vertices.len(), problems(&plain, [false; 2])), (8, vec![]));
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
    assert!(said.iter().any(|one| one.contains("setOutwardOrientation")), "{said:?}");
}
