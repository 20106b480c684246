//! Stresses inside of bodies in contact.

use std::f64::consts::PI;

use archard::elastic::{Deformed, Point};
use archard::simulation::Simulation;

use super::meshed_contact::BALL_ON_BLOCK;
use crate::common::{case, states};

/// A block that is nearly a half-space; the contact has a radius of 1 mm.
const LARGE: &str = r#"body.block.mesh.box.size=["40 mm", "40 mm", "40 mm"]"#;

/// The load (N) at the end, and what it makes of a body.
fn under(simulation: &Simulation, which: usize, points: &[Point]) -> (f64, Deformed) {
    let last = states(simulation).unwrap().pop().unwrap().0;
    let bodies = simulation.problem.bodies.each_ref();
    let deformed = Deformed::in_contact(bodies, which, &last.tractions(), points).unwrap();
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
fn errors(elastic: f64, load: f64, deformed: &Deformed, depths: &[f64]) -> [f64; 2] {
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
    let simulation = case(BALL_ON_BLOCK, &[LARGE]);
    let (load, mut deformed) = under(&simulation, 1, &on_the_axis(&depths));
    let surface = errors(1.0, load, &deformed, &depths);
    deformed.points.pop();
    let inside = errors(1.0, load, &deformed, &depths);
    assert!(inside[0] < 0.005 && inside[1] < 0.005, "{inside:?}");
    assert!(surface[0] < 0.03 && surface[1] < 0.03, "{surface:?}");
    let away = deformed.displacement.iter().map(|u| u[2]).fold(0.0, f64::min);
    assert!((away + 20e-6).abs() < 0.5e-6, "{away:e}");
}

/// Blocks alike share the approach, and so the stresses, though their meshes do not match: what acts on the
/// second is brought there from the nodes of the first.
#[test]
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
