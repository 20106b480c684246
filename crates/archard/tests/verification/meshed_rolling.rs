//! Rolling on a meshed body, against a half-space on the same pairs and against Kalker's linear theory.
//!
//! A steel ball of 20 mm radius, itself a half-space, touches a block 40 times as wide as the contact in a circle
//! of 0.2 mm radius. The pairs are the points of Gauss of the block's elements, so that their distances alternate
//! as 0.577 and 0.423.

use approx::assert_relative_eq;
use archard::closed_form::kalker::Coefficients;

use crate::common::{Rows, case};

/// Radius of the contact (m), its load by Hertz (N), shear modulus (Pa) and friction.
const RADIUS: f64 = 0.2e-3;
const LOAD: f64 = 61.538;
const SHEAR: f64 = 210e9 / 2.6;
const FRICTION: f64 = 0.3;

/// A ball on a block.
#[derive(Clone, Copy)]
struct Ball {
    /// Elements of the zone along an edge.
    elements: usize,
    elasticity: &'static str,
    friction: f64,
    drive: &'static str,
}

impl Ball {
    /// What the contact comes to, the elements halved by y = 0 where it creeps along x.
    fn roll(&self) -> Rows {
        let Self { elements, elasticity, friction, drive } = *self;
        let symmetry = if drive.starts_with("lateral") { "" } else { r#"symmetry = ["y"]"# };
        let text = format!(
            r#"
            [body.ball]
            material = {{ young = "210 GPa", poisson = 0.3 }}
            profile.sphere = {{ radius = "20 mm" }}
            [body.block]
            material = {{ young = "210 GPa", poisson = 0.3 }}
            supports = {{ bottom = "clamped" }}
            elasticity = "{elasticity}"
            boundary_elements.tolerance = 1e-4
            mesh.box.size = ["16 mm", "16 mm", "16 mm"]
            mesh.box.contact.size = ["0.5 mm", "0.5 mm"]
            mesh.box.contact.elements = [{elements}, {elements}]
            {symmetry}
            [friction.coulomb]
            coefficient = {friction}
            [motion.rolling]
            load = "{LOAD} N"
            revolutions = 0
            {drive}
            "#
        );
        let mut rows = Rows::default();
        case(&text, &[]).run(&mut [&mut rows]).expect("it converges");
        rows
    }
}

/// A block 40 times as wide as the contact differs by its size from a half-space, in what passes through the
/// contact by less than in the approach.
#[test]
fn a_large_block_rolls_as_a_half_space() {
    for (drive, column) in
        [("creepage = 0.001", "force_x_N"), ("lateral_creepage = 0.001", "force_y_N")]
    {
        let ball = Ball { elements: 8, elasticity: "half_space", friction: FRICTION, drive };
        let half_space = ball.roll();
        let block = Ball { elasticity: "boundary_elements", ..ball }.roll();
        for column in [column, "peak_pressure_Pa", "stick_area_m2"] {
            assert_relative_eq!(block.last(column), half_space.last(column), max_relative = 5e-3);
        }
    }
}

/// Nothing slips: Kalker's linear theory.
#[test]
fn a_block_that_sticks_follows_linear_theory() {
    let known = Coefficients::at(1.0, 0.3).expect("in the table");
    for (drive, column, coefficient) in [
        ("creepage = 0.001", "force_x_N", known.longitudinal),
        ("lateral_creepage = 0.001", "force_y_N", known.lateral),
    ] {
        let force = SHEAR * RADIUS * RADIUS * coefficient * 0.001;
        let errors = [6, 12].map(|elements| {
            let ball = Ball { elements, elasticity: "boundary_elements", friction: 100.0, drive };
            ball.roll().last(column) / force - 1.0
        });
        println!("{drive} {errors:?}");
        assert!(errors[1].abs() < 0.03, "{errors:?}");
    }
}
