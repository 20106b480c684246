//! Punches of revolution: Sneddon, *Int. J. Eng. Sci.* 3 (1965) 47.

use approx::assert_relative_eq;
use archard::closed_form::sneddon::Punch;

use crate::common::{Rows, case};

const PUNCH: &str = r#"
[body.punch]
rigid = true
profile.axisymmetric_power = { coefficient = 0.02, exponent = 1 }
[body.flat]
material = { young = "91 GPa", poisson = 0.3 }
profile.flat = {}
[frame]
size = ["0.24 mm", "0.24 mm"]
elements = [121, 121]
[motion.indentation]
approach = "3 um"
"#;

/// E* of the flat (Pa).
const MODULUS: f64 = 100e9;

/// The last row of the punch with options.
fn pressed(options: &[&str]) -> Rows {
    let mut rows = Rows::default();
    case(PUNCH, options).run(&mut [&mut rows]).expect("it converges");
    rows
}

/// Load and area of contact of a cone, a paraboloid and a blunter punch; an element is 0.02 of the radius. The loads
/// were 2.0e-5, 2.9e-5 and 4.7e-5 off, the areas 0.45 %: the border of the contact follows elements.
#[test]
fn cones_and_blunter_punches_are_those_of_sneddon() {
    for (written, coefficient, exponent) in
        [("0.02", 0.02, 1.0), ("100 1/m", 100.0, 2.0), ("2e10 m^-3", 2e10, 4.0)]
    {
        let punch = format!(
            "body.punch.profile.axisymmetric_power={{coefficient=\"{written}\",exponent={exponent}}}"
        );
        let expected = Punch::of_radius(coefficient, exponent, MODULUS, 0.1e-3);
        let approach = format!("motion.indentation.approach={:e} m", expected.approach);
        let rows = pressed(&[&punch, &approach]);
        let area = std::f64::consts::PI * expected.radius.powi(2);
        assert_relative_eq!(rows.last("load_N"), expected.load, max_relative = 1e-4);
        assert_relative_eq!(rows.last("contact_area_m2"), area, max_relative = 1e-2);
    }
}
