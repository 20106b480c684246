//! Stresses in half-spaces under a contact, as a case asks for them.

use std::fs;

use archard::elastic::{DeformedBody, Point, PressedHalfSpace, Response};
use archard::simulation::Simulation;
use archard_case::output::{Inside, Sheet};

use super::meshed_contact::BALL_ON_BLOCK;
use crate::common::{case, resolved, states};

/// A ball that slides along x on a flat, frictional.
const SLIDING: &str = r#"
[body.ball]
material = { young = "210 GPa", poisson = 0.3 }
profile.sphere = { radius = "50 mm" }
[body.flat]
material = { young = "210 GPa", poisson = 0.3 }
profile.flat = {}
[frame]
size = ["0.4 mm", "0.4 mm"]
elements = [64, 64]
[friction.coulomb]
coefficient = 0.25
[motion.sliding]
load = "10.2 N"
distance = "1 mm"
step = "1 mm"
"#;

/// Half-spaces and nearly half-spaces of meshes have the same axes, signs and components: under a rigid ball that slides.
#[test]
#[ignore = "long: in .ci/long"]
fn half_spaces_have_the_stresses_and_displacements_of_large_blocks() {
    let sliding = [
        r#"body.block.mesh.box.size=["40 mm", "40 mm", "40 mm"]"#,
        "body.block.elasticity=boundary_elements",
        "motion={ sliding={ approach=\"0.02 mm\", distance=\"1 mm\", step=\"1 mm\" } }",
        "friction.coulomb.coefficient=0.5",
        r#"body.block.symmetry=["y"]"#,
    ];
    let framed = [
        "body.block.mesh=",
        "body.block.supports=",
        "body.block.symmetry=",
        "body.block.profile.flat={}",
        "frame.size=[\"2.6 mm\", \"2.6 mm\"]",
        "frame.elements=[52, 52]",
        sliding[2],
        sliding[3],
    ];
    let places = [[0.0, 0.0, -0.5e-3], [0.6e-3, 0.3e-3, -0.4e-3], [-0.8e-3, 0.2e-3, -0.7e-3]];
    let points = places.map(|place| Point { name: String::new(), place });
    let last = |simulation: &Simulation| states(simulation).unwrap().pop().unwrap().0;
    let meshed = case(BALL_ON_BLOCK, &sliding);
    let state = last(&meshed);
    let tractions = meshed.problem.tractions(&state);
    assert!(tractions.t1.iter().any(|t| *t > 0.0), "friction on body 1 follows body 2");
    let bodies = meshed.problem.bodies.each_ref();
    let known = DeformedBody::in_contact(bodies, 1, &tractions, &points).unwrap().unwrap().points;
    let simple = case(BALL_ON_BLOCK, &framed);
    let state = last(&simple);
    let tractions = simple.problem.tractions(&state);
    let bodies = simple.problem.bodies.each_ref();
    let pressed =
        PressedHalfSpace::in_contact(bodies, 1, &simple.problem.frame, &tractions).unwrap();
    let found = pressed.points(&points).unwrap();
    let peak = state.pressure.iter().copied().fold(0.0, f64::max);
    for (found, known) in found.iter().zip(&known) {
        for (row, other) in found.stress.iter().flatten().zip(known.stress.iter().flatten()) {
            assert!((row - other).abs() < 0.025 * peak, "{found:?} {known:?}");
        }
    }
    // The block is held at a finite depth, and sways: how far apart points move stays.
    for which in 1..3 {
        let apart = |all: &[Response]| {
            [0, 1, 2].map(|axis| all[which].displacement[axis] - all[0].displacement[axis])
        };
        for (own, other) in apart(&found).into_iter().zip(apart(&known)) {
            assert!((own - other).abs() < 0.6e-6, "{found:?} {known:?}");
        }
    }
}

/// What a case writes: a table of points, a file a section, body 2 above the plane of contact, and the largest stresses.
#[test]
fn a_case_puts_out_points_sections_and_the_largest_stresses() {
    let simulation_of = |options: &[&str]| {
        let resolved = resolved(SLIDING, options);
        (resolved.case.inside(), resolved.case.build().unwrap())
    };
    let (mut inside, simulation): (Inside, Simulation) = simulation_of(&[
        "output.points.flat.below=[\"0 mm\", \"0 mm\", \"-72 um\"]",
        "output.points.ball.below=[\"0 mm\", \"0 mm\", \"-72 um\"]",
        r#"output.sections.flat.middle={ through = ["0 mm", "0 mm", "0 mm"], normal = [0, 1, 0], spacing = "20 um", size = ["0.2 mm", "0.2 mm"] }"#,
        "output.stress.flat={ field = true, yield_strength = \"400 MPa\" }",
    ]);
    simulation.run(&mut [&mut inside]).unwrap();
    let dir = tempfile::tempdir().unwrap();
    inside.write(dir.path(), &simulation.problem).unwrap();
    let sheet = Sheet::read(&dir.path().join("sections/flat_middle.vtu")).unwrap();
    assert!(sheet.points.iter().all(|place| place[2] >= 0.0) && !sheet.points.is_empty());
    let points = fs::read_to_string(dir.path().join("points.csv")).unwrap();
    let rows: Vec<Vec<&str>> = points.lines().map(|line| line.split(',').collect()).collect();
    let column = |row: usize, name: &str| -> f64 {
        let index = rows[0].iter().position(|known| *known == name).unwrap();
        rows[row][index].parse().unwrap()
    };
    // Bodies of one kind share pressures, and friction draws them apart.
    assert!((column(1, "stress_zz_Pa") - column(2, "stress_zz_Pa")).abs() < 1.0);
    assert!((column(1, "stress_zx_Pa") + column(2, "stress_zx_Pa")).abs() < 1.0);
    assert!(column(1, "stress_zx_Pa") > 1e6);
    assert!((column(1, "depth_m") - 72e-6).abs() < 1e-12);
    let table = fs::read_to_string(dir.path().join("stress_flat.csv")).unwrap();
    assert!(table.starts_with("depth_m,von_mises_Pa,") && table.lines().count() > 10, "{table}");
    let field = fs::read(dir.path().join("stress_flat.vtr")).unwrap();
    assert!(field.windows(15).any(|part| part == b"RectilinearGrid"));
}
