//! Rolling on a meshed body, against a half-space on the same pairs and against Kalker's linear theory.
//!
//! A steel ball of 20 mm radius, itself a half-space, touches a block 40 times as wide as the contact in a circle
//! of 0.2 mm radius. The pairs are the points of Gauss of the block's elements, so that their distances alternate
//! as 0.577 and 0.423.

use approx::assert_relative_eq;
use archard::closed_form::kalker::Coefficients;

use crate::common::{Rows, case};

/// Radius of the contact (m), its load by Hertz (N), shear modulus (Pa) and creepage.
const RADIUS: f64 = 0.2e-3;
const LOAD: f64 = 61.538;
const SHEAR: f64 = 210e9 / 2.6;
const CREEPAGE: f64 = 0.001;

/// A ball creeping along x over the block, half of it meshed; the force on the ball (N).
fn creep_force(elements: usize, elasticity: &str, friction: f64) -> f64 {
    let text = format!(
        r#"
        [body.ball]
        material = {{ young = "210 GPa", poisson = 0.3 }}
        profile.sphere = {{ radius = "20 mm" }}
        [body.block]
        material = {{ young = "210 GPa", poisson = 0.3 }}
        supports = {{ bottom = "clamped" }}
        symmetry = ["y"]
        elasticity = "{elasticity}"
        boundary_elements.tolerance = 1e-4
        mesh.box.size = ["16 mm", "16 mm", "16 mm"]
        mesh.box.contact.size = ["0.5 mm", "0.5 mm"]
        mesh.box.contact.elements = [{elements}, {elements}]
        [friction.coulomb]
        coefficient = {friction}
        [motion.rolling]
        load = "{LOAD} N"
        revolutions = 0
        creepage = {CREEPAGE}
        "#
    );
    let mut rows = Rows::default();
    case(&text, &[]).run(&mut [&mut rows]).expect("it converges");
    rows.last("force_x_N")
}

/// On 16 by 16 pairs the force is 0.9 % less than on a half-space.
#[test]
fn a_large_block_rolls_as_a_half_space() {
    let [block, half_space] = ["boundary_elements", "half_space"].map(|of| creep_force(8, of, 0.3));
    assert_relative_eq!(block, half_space, max_relative = 0.015);
}

/// Nothing slips: Kalker's linear theory. The force is 4.5, 8.0, 4.5 and 4.4 % high on 4, 6, 8 and 12 elements along an
/// edge: the upwind difference makes the contact stiffer, and its edge runs in stairs.
#[test]
fn a_block_that_sticks_follows_linear_theory() {
    let known = Coefficients::at(1.0, 0.3).expect("in the table");
    let force = SHEAR * RADIUS * RADIUS * known.longitudinal * CREEPAGE;
    assert_relative_eq!(creep_force(8, "boundary_elements", 100.0), force, max_relative = 0.05);
}

/// Pairs lie on the plane zone of the rail, whichever body is named first: the bodies are exchanged, and the force with them.
#[test]
fn a_disc_rolls_on_a_rail_in_either_order() {
    let disc = r#"
        [body.disc]
        material = { young = "210 GPa", poisson = 0.3 }
        supports = { bore = "clamped" }
        elasticity = "half_space"
        mesh.cylinder = { radius = "20 mm", bore = "12 mm", length = "4 mm", contact = { face = "side", size = ["1 mm", "4 mm"], elements = [6, 6] } }
        "#;
    let rail = r#"
        [body.rail]
        material = { young = "100 GPa", poisson = 0.3 }
        supports = { bottom = "clamped" }
        elasticity = "half_space"
        mesh.box = { size = ["16 mm", "4 mm", "8 mm"], contact = { size = ["1 mm", "4 mm"], elements = [8, 8] } }
        "#;
    let rolls = |bodies: [&str; 2], creepage: f64| {
        let text = format!(
            r#"
            {}
            {}
            [friction.coulomb]
            coefficient = 0.3
            [motion.rolling]
            load = "1 kN"
            creepage = {creepage}
            revolutions = 0
            "#,
            bodies[0], bodies[1]
        );
        let mut rows = Rows::default();
        case(&text, &[]).run(&mut [&mut rows]).expect("it converges");
        ["force_x_N", "peak_pressure_Pa", "approach_m"].map(|column| rows.last(column))
    };
    let [force, pressure, approach] = rolls([disc, rail], 0.002);
    let [other_force, other_pressure, other_approach] = rolls([rail, disc], -0.002);
    assert_relative_eq!(force, -other_force, max_relative = 1e-5);
    assert_relative_eq!(pressure, other_pressure, max_relative = 1e-5);
    assert_relative_eq!(approach, other_approach, max_relative = 1e-5);
    assert!(force.abs() > 100.0);
}
