//! Stresses inside bodies that are half-spaces with image fields.

use archard::body::Body;
use archard::elastic::{DeformedBody, Point, PressedHalfSpace, Response, Section, von_mises};
use archard::frame::VectorField;
use archard::simulation::{Simulation, offsets};
use archard::stress::MEASURES;
use archard_case::output::{Inside, Sheet, Surface};

use super::meshed_contact::{PUNCHED, input};
use crate::common::{case, states};

/// A mesh around the zone in place of the frame.
const MESHED: [&str; 4] = [
    "body.block.elasticity=boundary_elements",
    r#"body.block.mesh.box.contact={ face = "top", size = ["0.2 m", "0.2 m"], elements = [10, 10] }"#,
    r#"body.block.symmetry=["x", "y"]"#,
    "frame=",
];
const ROUGH: &str = "friction.coulomb.coefficient=0.3";

/// The last tractions on the pairs.
fn last(simulation: &Simulation) -> VectorField {
    let state = states(simulation).unwrap().pop().unwrap().0;
    simulation.problem.tractions(&state)
}

/// A body of a simulation with its image field.
fn pressed(simulation: &Simulation, which: usize) -> PressedHalfSpace {
    let problem = &simulation.problem;
    let placed = (which, offsets(&problem.bodies, &problem.motion));
    let bodies = problem.bodies.each_ref();
    PressedHalfSpace::with_ends(bodies, placed, &problem.frame, &last(simulation)).unwrap().unwrap()
}

fn largest(one: &Response, other: &Response) -> f64 {
    let both = one.stress.as_flattened().iter().zip(other.stress.as_flattened());
    both.map(|(one, other)| (one - other).abs()).fold(0.0, f64::max)
}

/// Below the zone, deep in the body and next to its clamped bottom, under pressure and friction, as body 1 and as body 2. Far from the
/// zone a half-space has other stresses.
#[test]
#[ignore = "long: in .ci/long"]
fn stresses_of_a_cube_are_those_of_a_mesh_around_its_zone() {
    let places = [
        [0.0, 0.0, -0.04],
        [0.05, 0.02, -0.1],
        [0.0, 0.0, -0.3],
        [0.3, 0.2, -0.5],
        [-0.1, 0.3, -0.7],
        [0.1, 0.1, -0.9],
    ];
    let points = places.map(|place| Point { name: String::new(), place });
    let first = PUNCHED.find("[body.block]").unwrap();
    let motion = PUNCHED.find("[frame]").unwrap();
    let turned = [&PUNCHED[first..motion], &PUNCHED[..first], &PUNCHED[motion..]].concat();
    for (text, which) in [(PUNCHED, 1), (turned.as_str(), 0)] {
        let meshed = case(text, &[&MESHED[..], &[ROUGH]].concat());
        let bodies = meshed.problem.bodies.each_ref();
        let known = DeformedBody::in_contact(bodies, which, &last(&meshed), &points);
        let known = known.unwrap().unwrap().points;
        let imaged = case(text, &[ROUGH]);
        let found = pressed(&imaged, which);
        let alone = imaged.problem.bodies.clone().map(|body| Body { finite: None, ..body });
        let frame = &imaged.problem.frame;
        let alone =
            PressedHalfSpace::in_contact(alone.each_ref(), which, frame, &last(&imaged)).unwrap();
        for ((known, place), depth) in known.iter().zip(places).zip(0..) {
            let scale = von_mises(&known.stress);
            let off = largest(&found.at(place).unwrap(), known) / scale;
            assert!(off < 0.01, "{which} {place:?}: {off}");
            let off = largest(&alone.at(place).unwrap(), known) / scale;
            assert!(depth < 3 || off > 0.2, "{which} {place:?}: {off}");
        }
        let [error, most] = found.missed(&places).unwrap();
        assert!(error > 0.0 && error < 0.005 * most, "{error} {most}");
    }
}

/// The mean stress (Pa) across a cut at a depth (m), along x and z, and by how much stresses there are off at most.
fn across(pressed: &PressedHalfSpace, depth: f64) -> ([f64; 2], f64) {
    const COUNT: usize = 12;
    let (mut mean, mut places) = ([0.0; 2], vec![]);
    for cell in 0..COUNT * COUNT {
        let [x, y] = [cell % COUNT, cell / COUNT].map(|i| (i as f64 + 0.5) / COUNT as f64 - 0.5);
        let place = [x, y, -depth];
        let stress = pressed.at(place).unwrap().stress;
        mean[0] += stress[2][0] / (COUNT * COUNT) as f64;
        mean[1] += stress[2][2] / (COUNT * COUNT) as f64;
        places.push(place);
    }
    (mean, pressed.missed(&places).unwrap()[0])
}

/// Load and friction go through every cut of a cube on which a punch slides, as boundary elements or in tetrahedra; what is missing is less
/// than stresses are off.
#[test]
#[ignore = "long: in .ci/long"]
fn stresses_on_a_cut_balance_load_and_friction() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("part.inp");
    std::fs::write(&path, input([1.0; 3], [8; 3])).unwrap();
    let file = format!("mesh.file = {{ path = {path:?}, unit = \"m\" }}");
    let sliding = "motion={ sliding={ approach=\"0.07 mm\", distance=\"1 mm\", step=\"1 mm\" } }";
    for text in [PUNCHED, &PUNCHED.replace("mesh.box.size = [\"1 m\", \"1 m\", \"1 m\"]", &file)] {
        let simulation = case(text, &[sliding, ROUGH, "frame.elements=[48, 48]"]);
        let tractions = last(&simulation);
        let [x, _, z] = simulation.problem.frame.force(&tractions);
        // On the block, body 2: friction the other way, along its outward normal as on body 1.
        let known = [-x, z];
        assert!(x.abs() > 0.29 * z.abs() && z < 0.0, "{x} {z}");
        let block = pressed(&simulation, 1);
        for depth in [0.25, 0.75] {
            let (found, error) = across(&block, depth);
            for (found, known) in found.iter().zip(known) {
                let off = (found - known).abs();
                assert!(off < error && off < 0.01 * z.abs(), "{depth}: {found} {known} {error}");
            }
        }
    }
}

/// The files are those of other bodies of finite shape: body 2 lies above the plane of contact.
#[test]
fn places_sections_and_the_surface_are_put_out() {
    let simulation = case(PUNCHED, &["frame.elements=[32, 32]"]);
    let point = Point { name: "below".to_owned(), place: [0.0, 0.0, -0.1] };
    let section = Section {
        name: "low".to_owned(),
        through: [0.0, 0.0, -0.5],
        normal: [0.0, 0.0, 1.0],
        spacing: 0.25,
        size: None,
    };
    let mut inside = Inside::at([vec![], vec![point]]).on([vec![], vec![section]]);
    simulation.run(&mut [&mut inside]).unwrap();
    let dir = tempfile::tempdir().unwrap();
    inside.write(dir.path(), &simulation.problem).unwrap();
    let table = std::fs::read_to_string(dir.path().join("points.csv")).unwrap();
    assert!(table.lines().nth(1).unwrap().starts_with("block,below,0,0,-0.1,0.1,"), "{table}");
    let sheet = Sheet::read(&dir.path().join("sections/block_low.vtu")).unwrap();
    assert_eq!((sheet.points.len(), sheet.cells.len()), (25, 16));
    assert!(sheet.points.iter().all(|place| (place[2] - 0.5).abs() < 1e-9));
    let surface = Surface::read(&dir.path().join("surface_2.vtu")).unwrap();
    let stress = surface.field("stress_zz_Pa").unwrap();
    assert!(stress.iter().all(|own| own.is_finite()));
    let [low, high] = [f64::min, f64::max]
        .map(|pick| surface.places.iter().map(|place| place[2]).fold(0.5, pick));
    assert!(low.abs() < 1e-9 && high > 0.9, "{low} {high}");
}

/// What is free of tractions has none, at the top beside the zone and at a side; and planes of the largest stresses have what places
/// have.
#[test]
#[ignore = "long: in .ci/long"]
fn free_faces_and_planes_have_the_stresses_of_places() {
    let simulation = case(PUNCHED, &[]);
    let block = pressed(&simulation, 1);
    let top = block.at([0.3, 0.1, 0.0]).unwrap().stress;
    let side = block.at([0.5, 0.1, -0.3]).unwrap();
    assert!(top[2].iter().all(|own| own.abs() < 1e-6 * block.peak()), "{top:?}");
    let free = side.stress[0].map(f64::abs).into_iter().fold(0.0, f64::max);
    let half_space = 0.1 * von_mises(&side.stress);
    assert!(free < half_space, "{side:?}");
    let maxima = block.maxima(&[0.02, 0.1, 0.2], (&[0.0; 6], &[None]), &mut |_, _| {}).unwrap();
    for layer in &maxima.layers {
        let (value, [x, y]) = layer.largest[0];
        let found = von_mises(&block.at([x, y, -layer.depth]).unwrap().stress);
        assert!((value - found).abs() < 1e-4 * block.peak(), "{value} {found}");
    }
    for (own, (name, _)) in maxima.inside.iter().zip(MEASURES) {
        assert!(own.error > 0.0 && own.error < 0.03 * own.value, "{name}: {own:?}");
    }
    // The whole surface has the load where it is clamped.
    let load = simulation.problem.frame.force(&last(&simulation))[2];
    let surface = block.on_surface().unwrap();
    let bottom = surface.surface.names().iter().position(|name| name == "bottom").unwrap();
    let held = surface.forces()[bottom][2];
    assert!((held / load + 1.0).abs() < 0.1, "{held} {load}");
    assert!(surface.displacement.len() == surface.traction.len() && surface.worn.is_empty());
    assert!(block.at([0.6, 0.0, -0.3]).is_none() && block.at([0.0, 0.0, -1.1]).is_none());
    assert!(block.check(&[0.9]).is_ok() && block.check(&[1.1]).is_err());
}
