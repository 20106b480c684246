//! The error stated of what wears out of proportion to the pressure, and of what unlike bodies bear where they roll.

use std::f64::consts::PI;

use archard::closed_form::Hertz;
use archard::simulation::history::number;

use super::accuracy::{answer, assert_near, assert_within, over_half_a_turn};

const PIN: &str = include_str!("../../../../cases/pin_on_disc/case.toml");
const TRACK: &str = include_str!("../../../../cases/pin_on_disc_track/case.toml");
const CARTER: &str = include_str!("../../../../cases/carter/case.toml");

/// The contact of a ball of that radius (m) and a flat, both of steel, under a load (N): its half width (m), and the pressure (Pa) in
/// the middle.
fn hertz(radius: f64, load: f64) -> [f64; 2] {
    let modulus = 0.5 * 210e9 / (1.0 - 0.09);
    let hertz = Hertz::from_load([1.0 / radius; 2], modulus, load).expect("a contact");
    [hertz.semi_axes[0], hertz.peak_pressure]
}

/// Says how a body wears by a power of the pressure, hardly.
fn power(body: &str, exponent: f64) -> String {
    format!(
        "body.{body}.wear={{ power = {{ coefficient = \"1e-24 1/Pa\", pressure_exponent = {exponent}, \
         reference_pressure = \"1 GPa\" }} }}"
    )
}

/// What such a law wears (m) over a distance (m).
fn worn(pressure: f64, exponent: f64, distance: f64) -> f64 {
    1e-24 * 1e9 * (pressure / 1e9).powf(exponent) * distance
}

/// A ball that hardly wears keeps its pressures, which laws make depths and volumes of: pressures in the middle fall between
/// elements, and a law that bends sees how they fall to the rim.
#[test]
fn what_wears_out_of_proportion_lies_within_the_error_stated() {
    let [half, peak] = hertz(0.05, 10.2);
    let area = PI * half * half;
    let mut laws: Vec<(String, [f64; 2])> = vec![];
    for exponent in [0.3, 0.6, 1.5, 2.0] {
        let depth = worn(peak, exponent, 0.5);
        laws.push((power("pin", exponent), [depth, depth * area * 2.0 / (exponent + 2.0)]));
    }
    for share in [0.2_f64, 0.5, 0.8] {
        let law = format!(
            "body.pin.wear={{ threshold = {{ coefficient = \"1e-24 1/Pa\", threshold = \"{} Pa\" }} }}",
            share * peak
        );
        let depth = 1e-24 * peak * (1.0 - share) * 0.5;
        let volume = 1e-24 * 0.5 * peak * area * (2.0 / 3.0 - share + share.powi(3) / 3.0);
        laws.push((law, [depth, volume]));
    }
    for (law, [depth, volume]) in &laws {
        for accuracy in ["accuracy=0.2", "accuracy=0.1", "accuracy=0.03", "accuracy=0.01"] {
            let row = answer(PIN, &[law, accuracy]);
            let what = format!("{law} {accuracy}");
            assert_within(&row, "wear_depth_pin_m", (*depth, 1e-6 * depth), &what);
            assert_within(&row, "worn_volume_pin_m3", (*volume, 1e-6 * volume), &what);
        }
    }
}

/// The groove of a track takes up the errors along its rows, also where it wears in proportion.
#[test]
fn the_depth_of_a_groove_lies_within_the_error_stated() {
    let [half, peak] = hertz(0.003, 10.0);
    let passages = 1000.0 / (2.0 * PI * 0.01);
    for exponent in [0.3, 0.6, 1.0, 2.0] {
        // Over a passage, in the angle whose cosine is the place over the half width.
        let length = half * over_half_a_turn(|angle| angle.sin().powf(exponent + 1.0));
        let depth = worn(peak, exponent, passages * length);
        let laws = [power("ball", exponent), power("disc", exponent)];
        // Fourteen elements leave out most of those that the rim cuts.
        let size = 1e3 * 2.6 * half;
        let frame =
            format!("frame={{ size = [\"{size} mm\", \"{size} mm\"], elements = [14, 14] }}");
        for options in [
            &["accuracy=0.2"][..],
            &["accuracy=0.1"],
            &["accuracy=0.03"],
            &["accuracy=0.2", &frame],
        ] {
            let row = answer(TRACK, &[&[laws[0].as_str(), &laws[1]], options].concat());
            let what = format!("{exponent} {options:?}");
            assert_within(&row, "wear_depth_disc_m", (depth, 1e-4 * depth), &what);
        }
    }
}

/// Unlike cylinders stick and slip in more than one strip, and their edges fall within elements together. Against 4800 elements.
#[test]
fn forces_of_unlike_cylinders_lie_within_the_error_stated() {
    for (young, friction) in [("70 GPa", 0.3), ("20 GPa", 0.3), ("20 GPa", 0.6)] {
        let soft = format!("body.driven.material.young={young}");
        let rough = format!("friction.coulomb.coefficient={friction}");
        for creepage in [0.0003, 0.001, 0.003, 0.006] {
            let creepage = format!("motion.rolling.creepage={creepage}");
            let set = [soft.as_str(), &rough, &creepage];
            let fine =
                ["accuracy=", "frame.size=1.2 mm", "frame.elements=4800", "motion.rolling.step=1"];
            let truth = answer(CARTER, &[&set[..], &fine].concat());
            let force = number(&truth, "force_x_N").expect("a force");
            for accuracy in ["accuracy=0.1", "accuracy=0.03", "accuracy=0.01"] {
                let row = answer(CARTER, &[&set[..], &[accuracy]].concat());
                let what = format!("{young} {friction} {creepage} {accuracy}");
                assert_within(&row, "force_x_N", (force, 1e-4 * force.abs()), &what);
            }
        }
    }
}

/// Where unlike cylinders begin to slip, their pressures have a cusp, which elements cut off. Against 4800 elements, which leave a
/// part in a thousand.
#[test]
fn the_cusp_of_unlike_cylinders_lies_within_the_error_stated() {
    let text = r#"
        [body.hard]
        material = { young = "110 GPa", poisson = 0.49 }
        profile.cylinder = { radius = "31.37 mm", axis = "y" }
        [body.soft]
        material = { young = "3 GPa", poisson = 0.3 }
        profile.cylinder = { radius = "20.56 mm", axis = "y" }
        [frame]
        plane_strain = true
        [friction.coulomb]
        coefficient = 0.346
        [motion.rolling]
        load = "150.1 N/mm"
        creepage = 0.00206
        revolutions = 0
    "#;
    let fine = ["frame.size=2.3 mm", "frame.elements=4800", "motion.rolling.step=1"];
    let peak = number(&answer(text, &fine), "peak_pressure_Pa").expect("a pressure");
    for accuracy in ["accuracy=0.1", "accuracy=0.03", "accuracy=0.01"] {
        let row = answer(text, &[accuracy]);
        assert_near(&row, "peak_pressure_Pa", (peak, 1e-3 * peak), accuracy);
    }
}

/// Discs wear deepest where few of their elements slip, most of all with a little spin. Against 200 x 200 elements, which leave a
/// part in two hundred.
#[test]
#[ignore = "long: in .ci/long"]
fn depths_where_few_elements_slip_lie_within_the_error_stated() {
    let text = r#"
        [body.one]
        material = { young = "70 GPa", poisson = 0.3 }
        profile.paraboloid = { radius_x = "10 mm", radius_y = "10 mm" }
        wear.archard = { coefficient = "1e-9 mm^3/(N m)" }
        [body.two]
        material = { young = "70 GPa", poisson = 0.3 }
        profile.flat = {}
        [friction.coulomb]
        coefficient = 0.3
        [motion.rolling]
        load = "100 N"
        revolutions = 1
    "#;
    let depth = |elements: usize, options: &[&str]| {
        let frame = format!(
            "frame={{ size = [\"0.75 mm\", \"0.75 mm\"], elements = [{elements}, {elements}] }}"
        );
        answer(text, &[options, &[&frame]].concat())
    };
    for (creepage, spin) in [(6.5e-4, 0.47), (1.3e-3, 0.94)] {
        let creepage = format!("motion.rolling.creepage={creepage}");
        let spin = format!("motion.rolling.spin={spin} 1/m");
        let fine = depth(200, &[&creepage, &spin, "motion.rolling.step=1"]);
        let truth = number(&fine, "wear_depth_m").expect("a depth");
        for elements in [32, 36, 40, 44, 48, 52, 56] {
            let row = depth(elements, &[&creepage, &spin, "accuracy=0.2"]);
            let what = format!("{creepage} {spin} {elements}");
            assert_near(&row, "wear_depth_m", (truth, 5e-3 * truth), &what);
        }
    }
}

/// Where a shear strength bounds friction right behind the edge, forces err by the first order of the elements, as areas do; and
/// what turns about the normal errs by what its parts do, whose sum is small. Against 240 x 240 elements, which leave three parts in a
/// thousand of forces and a part in fifty of moments.
#[test]
#[ignore = "long: in .ci/long"]
fn forces_under_a_shear_strength_and_moments_lie_within_the_error_stated() {
    let text = |young: &str, friction: &str, motion: &str| {
        format!(
            r#"
            [body.one]
            material = {{ young = "210 GPa", poisson = 0.3 }}
            profile.sphere = {{ radius = "20 mm" }}
            [body.two]
            material = {{ young = "{young}", poisson = 0.3 }}
            profile.flat = {{}}
            [friction]
            {friction}
            [motion.rolling]
            load = "100 N"
            {motion}
            revolutions = 0
            "#
        )
    };
    let bounded = "tresca = { coefficient = 0.3, shear_strength = \"30 MPa\" }";
    let coulomb = "coulomb = { coefficient = 0.3 }";
    for (young, size, friction, motion) in [
        ("210 GPa", 0.611, bounded, "creepage = 0.0003\nlateral_creepage = 0.0002"),
        ("210 GPa", 0.611, bounded, "creepage = 0.0001"),
        ("3 GPa", 2.02, coulomb, "spin = \"2 1/m\""),
    ] {
        let text = text(young, friction, motion);
        let row = |elements: usize, option: &str| {
            let frame = format!(
                "frame={{ size = [\"{size} mm\", \"{size} mm\"], elements = [{elements}, {elements}] }}"
            );
            answer(&text, &[&frame, option])
        };
        let fine = row(240, "motion.rolling.step=1");
        let of = |column: &str| number(&fine, column).expect("a force");
        let [x, y, moment] = ["force_x_N", "force_y_N", "moment_z_Nm"].map(of);
        let slack = 3e-3 * x.hypot(y);
        for elements in [24, 32, 40, 50] {
            let row = row(elements, "accuracy=0.2");
            let what = format!("{young} {motion} {elements}");
            assert_within(&row, "force_x_N", (x, slack), &what);
            assert_within(&row, "force_y_N", (y, slack), &what);
            assert_within(&row, "moment_z_Nm", (moment, 0.02 * moment.abs() + 1e-12), &what);
        }
    }
}
