//! Stresses inside of bodies in contact.

use std::f64::consts::PI;

use archard::elastic::{DeformedBody, Point, Section};
use archard::simulation::Simulation;
use archard_case::output::{Inside, Sheet, Store};

use super::meshed_contact::BALL_ON_BLOCK;
use crate::common::{case, states};

/// A block that is nearly a half-space; the contact has a radius of 1 mm.
const LARGE: &str = r#"body.block.mesh.box.size=["40 mm", "40 mm", "40 mm"]"#;
/// Stresses inside take a mesh around the zone.
const MESHED: &str = "body.block.elasticity=boundary_elements";

/// The load (N) at the end, and what it makes of a body.
fn under(simulation: &Simulation, which: usize, points: &[Point]) -> (f64, DeformedBody) {
    let last = states(simulation).unwrap().pop().unwrap().0;
    let bodies = simulation.problem.bodies.each_ref();
    let deformed = DeformedBody::in_contact(bodies, which, &last.tractions(), points).unwrap();
    (last.load, deformed.expect("a meshed body"))
}

/// Points on the axis at these depths (m) below z = 0.
fn on_the_axis(depths: &[f64]) -> Vec<Point> {
    let point = |depth: &f64| Point { name: String::new(), place: [0.0, 0.0, -depth] };
    depths.iter().map(point).collect()
}

/// Stress along z and across it, relative to the peak pressure, on the axis at a depth relative to the radius
/// (K. L. Johnson, *Contact Mechanics*, Cambridge 1985, eq. 3.45).
fn hertz(depth: f64) -> [f64; 2] {
    let along = -1.0 / (1.0 + depth * depth);
    let turned = 1.0 - depth * (1.0 / depth).atan();
    [along, -1.3 * turned - 0.5 * along]
}

/// The largest errors of the stress along z and across it on the axis, relative to the peak pressure, where that
/// many bodies are elastic.
fn errors(elastic: f64, load: f64, deformed: &DeformedBody, depths: &[f64]) -> [f64; 2] {
    let radius = (0.75 * load * 0.05 * elastic * (1.0 - 0.09) / 210e9).cbrt();
    let peak = 1.5 * load / (PI * radius * radius);
    let mut errors = [0.0f64; 2];
    for (response, depth) in deformed.points.iter().zip(depths) {
        let [along, across] = hertz(depth / radius);
        let found = [response.stress[2][2], response.stress[0][0]].map(|s| s / peak);
        errors[0] = errors[0].max((found[0] - along).abs());
        errors[1] = errors[1].max((found[1] - across).abs());
    }
    errors
}

/// Deep, at the depth of the largest shear, and on the surface, where the traction is known.
#[test]
fn a_ball_stresses_the_inside_of_a_block_as_hertz_says() {
    let depths = [0.48e-3, 1e-3, 2e-3, 1e-12];
    let simulation = case(BALL_ON_BLOCK, &[LARGE, MESHED]);
    let (load, mut deformed) = under(&simulation, 1, &on_the_axis(&depths));
    let surface = errors(1.0, load, &deformed, &depths);
    deformed.points.pop();
    let inside = errors(1.0, load, &deformed, &depths);
    assert!(inside[0] < 0.005 && inside[1] < 0.005, "{inside:?}");
    assert!(surface[0] < 0.03 && surface[1] < 0.03, "{surface:?}");
    let away = deformed.displacement.iter().map(|u| u[2]).fold(0.0, f64::min);
    assert!((away + 20e-6).abs() < 0.5e-6, "{away:e}");
}

/// Blocks of one kind share the approach, and so the stresses, though their meshes do not match: what acts on the
/// second is brought there from the nodes of the first.
#[test]
#[ignore = "long: in .ci/long"]
fn stresses_in_both_bodies_are_those_of_each_other() {
    let both = case(
        BALL_ON_BLOCK,
        &[
            LARGE,
            "body.ball.rigid=",
            "body.ball.material={ young = \"210 GPa\", poisson = 0.3 }",
            r#"body.ball.mesh.box={ size = ["40 mm", "40 mm", "40 mm"], contact = { face = "top", size = ["2.6 mm", "2.6 mm"], elements = [6, 6] } }"#,
            r#"body.block.mesh.box.contact={ face = "top", size = ["2.8 mm", "2.8 mm"], elements = [8, 8] }"#,
            "body.ball.supports={ bottom = \"clamped\" }",
            "body.ball.symmetry=[\"x\", \"y\"]",
        ],
    );
    let depths = [0.48e-3, 1e-3];
    for which in [0, 1] {
        let (load, deformed) = under(&both, which, &on_the_axis(&depths));
        let errors = errors(2.0, load, &deformed, &depths);
        assert!(errors[0] < 0.01 && errors[1] < 0.01, "body {}: {errors:?}", which + 1);
    }
}

/// On a section through the axis the equivalent stress of von Mises is largest below the surface: 0.620 of the peak
/// pressure at a depth of 0.481 radii for a Poisson's ratio of 0.3 (K. L. Johnson, *Contact Mechanics*, section 3.4). The
/// folder of what is kept gives the same without solving the equations again.
#[test]
#[ignore = "long: in .ci/long"]
fn a_section_shows_the_largest_equivalent_stress_where_hertz_has_it() {
    let simulation = case(BALL_ON_BLOCK, &[LARGE, MESHED]);
    let section = Section {
        name: "middle".to_owned(),
        through: [0.0; 3],
        normal: [0.0, 2.0, 0.0],
        spacing: 0.12e-3,
        size: Some([1.2e-3, 2.4e-3]),
    };
    let kept = tempfile::tempdir().unwrap();
    let mut sheets = vec![];
    for store in [None, Some(()), Some(())] {
        let store = store.map(|()| Store::new(kept.path()));
        let mut inside =
            Inside::at([vec![], vec![]]).on([vec![], vec![section.clone()]]).keeping(store);
        simulation.run(&mut [&mut inside]).unwrap();
        let dir = tempfile::tempdir().unwrap();
        inside.write(dir.path(), &simulation.problem).unwrap();
        let files: Vec<_> = std::fs::read_dir(dir.path()).unwrap().collect();
        assert_eq!(files.len(), 3, "the surface, the folder of sections and the list: {files:?}");
        sheets.push(Sheet::read(&dir.path().join("sections/block_middle.vtu")).unwrap());
    }
    let [solved, first, again] = &sheets[..] else { panic!("three runs") };
    assert_eq!(first, again);
    let mises = |sheet: &Sheet| {
        sheet.fields.iter().find(|f| f.name == "von_mises_Pa").unwrap().values.clone()
    };
    for (one, other) in mises(solved).iter().zip(mises(first)) {
        assert!((one - other).abs() < 1e-6 * one.abs(), "{one} {other}");
    }
    let load = states(&simulation).unwrap().pop().unwrap().0.load;
    let radius = (0.75 * load * 0.05 * (1.0 - 0.09) / 210e9).cbrt();
    let peak = 1.5 * load / (PI * radius * radius);
    let (place, largest) = solved
        .points
        .iter()
        .zip(mises(solved))
        .max_by(|one, other| one.1.total_cmp(&other.1))
        .expect("places");
    assert!((largest / peak - 0.620).abs() < 0.008, "{}", largest / peak);
    assert!((place[2] / radius - 0.481).abs() < 0.08, "{place:?} {radius}");
    assert!(place[0].abs() < 1e-9 && place[1] == 0.0, "{place:?}");
    // Both halves are there, body 2 lies above the plane of contact.
    let [low, high] = [f64::min, f64::max].map(|pick| {
        solved
            .points
            .iter()
            .fold(solved.points[0], |known, p| [0, 1, 2].map(|i| pick(known[i], p[i])))
    });
    assert!((low[0] + 6e-4).abs() < 1e-9 && (high[0] - 6e-4).abs() < 1e-9, "{low:?} {high:?}");
    assert!(low[2].abs() < 1e-9 && (high[2] - 1.2e-3).abs() < 1e-9, "{low:?} {high:?}");
}
