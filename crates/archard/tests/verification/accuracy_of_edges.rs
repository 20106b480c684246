//! The error stated where elements see an edge badly: of what touches, of what sticks, of a punch, of a scar that swings.

use std::f64::consts::PI;

use archard::simulation::history::Row;

use super::accuracy::{answer, rows, with_error};

const CARTER: &str = include_str!("../../../../cases/carter/case.toml");
const PUNCH: &str = include_str!("../../../../cases/running_in_flat_punch/case.toml");
const FORMULA: &str = include_str!("../../../../cases/custom_expression/case.toml");
const FRETTING: &str = include_str!("../../../../cases/mccoll_fretting/case.toml");

const ASKED: [&str; 3] = ["accuracy=0.1", "accuracy=0.03", "accuracy=0.01"];

/// Asserts that a value lies within the error stated and what the truth leaves.
fn assert_within(row: &Row, column: &str, (truth, leaves): (f64, f64), what: &str) {
    let (found, error) = with_error(row, column);
    let off = (found - truth).abs();
    println!("{what} {column}: off {:.2e} of {:.2e}", off / truth.abs(), error / truth.abs());
    assert!(off <= error + leaves, "{what} {column}: {off:e} of {error:e}");
}

/// The row of an output.
fn row_at(rows: &[Row], progress: f64) -> &Row {
    let row = rows.iter().find(|row| (row[0].1 / progress - 1.0).abs() < 1e-9);
    row.expect("an output")
}

/// Rolling cylinders near saturation: a strip that sticks, narrower than the elements of the coarser grids, takes from the force
/// what no grid shows. Carter: the strip is 1 - x of the contact and takes (1 - x)^2 of the force, x the share of the creepage
/// from which on all slips.
#[test]
fn a_strip_too_narrow_for_the_elements_counts() {
    let (length, half, limit) = (0.04, 0.2e-3, 2154.24);
    for share in [0.8, 0.917, 0.97, 1.0, 1.5] {
        let creepage = format!("motion.rolling.creepage={}", 0.003 * share);
        let left = f64::max(1.0 - share, 0.0);
        for accuracy in ASKED {
            let row = answer(CARTER, &[&creepage, accuracy]);
            let what = format!("{share} {accuracy}");
            let contact = 2.0 * half * length;
            for (column, truth) in [
                ("force_x_N", limit * (1.0 - left * left)),
                ("stick_area_m2", contact * left),
                ("contact_area_m2", contact),
                ("peak_pressure_Pa", 571.43e6),
            ] {
                assert_within(&row, column, (truth, 1e-4 * truth), &what);
            }
            assert!(with_error(&row, "creepage").1 < 1e-9, "what is given has no error");
        }
    }
}

/// The block wears deepest under the edge of a flat punch, where its pressure had no bound: the error is of the first order.
/// Against an independent axisymmetric solution on 400 rings that become finer towards the edge, extrapolated in its steps.
#[test]
fn the_depth_under_an_edge_lies_within_the_error_stated() {
    for accuracy in ["accuracy=0.2", "accuracy=0.1"] {
        let row = answer(PUNCH, &["motion.sliding.distance=10 mm", accuracy]);
        assert_within(&row, "wear_depth_m", (7.428e-8, 0.002e-8), accuracy);
        // Galin's.
        assert_within(&row, "centre_pressure_Pa", (20.78444e6, 1e3), accuracy);
    }
}

/// Cylinders of plastic that wear by less than in proportion to the pressure: most at the end of the strip that slips, which is
/// narrower than an element of the coarser grids. Carter's tractions: with x from the middle of the strip that sticks, of half
/// width a', the slip over the speed is mu sqrt(x^2 - a'^2) / R; integrated over the pressure to the power 0.6.
#[test]
fn what_wears_at_the_rim_of_slip_lies_within_the_error_stated() {
    const CYLINDERS: &str = r#"
        [body.one]
        material = { young = "3 GPa", poisson = 0.2 }
        profile.cylinder = { radius = "31.45 mm", axis = "y" }
        [body.one.wear.power]
        coefficient = "1.919e-8 mm^3/(N m)"
        pressure_exponent = 0.6
        reference_pressure = "61.96 MPa"
        [body.two]
        material = { young = "3 GPa", poisson = 0.2 }
        profile.cylinder = { radius = "30.31 mm", axis = "y" }
        [frame]
        plane_strain = true
        [friction.coulomb]
        coefficient = 0.439
        [motion.rolling]
        load = "59.88 N/mm"
        creepage = 0.01
        revolutions = 5387
    "#;
    for (creepage, truth) in [(0.000877, 7.79608e-13), (0.003, 6.90016e-12), (0.01, 5.33689e-11)] {
        let creepage = format!("motion.rolling.creepage={creepage}");
        for accuracy in ASKED {
            let row = answer(CYLINDERS, &[&creepage, accuracy]);
            let what = format!("{creepage} {accuracy}");
            assert_within(&row, "wear_depth_m", (truth, 1e-4 * truth), &what);
        }
    }
}

/// A ball that hardly wears: the deepest of elements lies beside the middle.
#[test]
fn the_depth_of_few_elements_lies_within_the_error_stated() {
    let case = r#"
        [body.ball]
        material = { young = "210 GPa", poisson = 0.3 }
        profile.sphere = { radius = "30 mm" }
        wear.archard = { coefficient = "1e-16 1/Pa" }
        [body.flat]
        material = { young = "210 GPa", poisson = 0.3 }
        profile.flat = {}
        [motion.sliding]
        load = "10 N"
        distance = "1 mm"
    "#;
    // Hertz: p0^3 = 6 F E*^2 / (pi^3 R^2).
    let modulus = 210e9 / (1.0 - 0.3 * 0.3) / 2.0;
    let pressure = (60.0 * modulus * modulus / (PI.powi(3) * 0.03 * 0.03)).cbrt();
    for accuracy in ASKED {
        let row = answer(case, &[accuracy]);
        let depth = 1e-16 * pressure * 1e-3;
        assert_within(&row, "wear_depth_m", (depth, 1e-5 * depth), accuracy);
        assert_within(&row, "peak_pressure_Pa", (pressure, 1e-5 * pressure), accuracy);
    }
}

/// A steel pin on a steel disc, by accuracy alone: its recess c r^n.
const TIP: &str = r#"
[body.pin]
material = { young = "210 GPa", poisson = 0.3 }
profile.axisymmetric_power = { coefficient = 0.01, exponent = 1 }
wear.archard = { coefficient = "1e-16 1/Pa" }
[body.disc]
material = { young = "210 GPa", poisson = 0.3 }
profile.flat = {}
"#;

/// At a tip pressures converge by the order n - 1, and at that of a cone they have no bound.
#[test]
fn pressures_at_a_tip_are_stated_as_they_converge() {
    let case = format!("{TIP}[motion.indentation]\nload = \"10 N\"\n");
    // I. N. Sneddon, Int. J. Eng. Sci. 3 (1965) 47: F = 2 E* kappa c n a^(n + 1) / (n + 1), approach kappa c a^n, pressure at
    // the tip E* kappa c n a^(n - 1) / (pi (n - 1)), kappa = sqrt(pi) Gamma(n/2 + 1) / Gamma((n + 1)/2).
    for (accuracy, exponent, approach, pressure) in [
        ("accuracy=0.1", "1", 1.16677e-6, f64::INFINITY),
        ("accuracy=0.01", "1", 1.16677e-6, f64::INFINITY),
        ("accuracy=0.1", "1.5", 6.56209e-7, 6.5695e8),
        ("accuracy=0.03", "1.5", 6.56209e-7, 6.5695e8),
        ("accuracy=0.01", "1.5", 6.56209e-7, 6.5695e8),
    ] {
        let exponent = format!("body.pin.profile.axisymmetric_power.exponent={exponent}");
        let coefficient = match pressure.is_finite() {
            true => "body.pin.profile.axisymmetric_power.coefficient=0.01 mm^-0.5",
            false => "body.pin.profile.axisymmetric_power.coefficient=0.01",
        };
        let row = answer(&case, &[&exponent, coefficient, accuracy]);
        let what = format!("{exponent} {accuracy}");
        assert_within(&row, "approach_m", (approach, 1e-5 * approach), &what);
        for column in ["centre_pressure_Pa", "peak_pressure_Pa"] {
            if pressure.is_finite() {
                assert_within(&row, column, (pressure, 1e-4 * pressure), &what);
            } else {
                let (found, error) = with_error(&row, column);
                assert!(error > 0.99 * found, "{what} {column}: {error:e} of {found:e}");
            }
        }
    }
}

/// The depth that a tip wears while the elements do not see that it becomes blunt, against an independent axisymmetric solution
/// on 300 to 1200 rings, extrapolated in them and in its steps.
#[test]
fn the_depth_of_a_tip_lies_within_the_error_stated() {
    let case = format!("{TIP}[motion.sliding]\nload = \"10 N\"\ndistance = \"300 mm\"\n");
    let recess = [
        "body.pin.profile.axisymmetric_power.exponent=1.5",
        "body.pin.profile.axisymmetric_power.coefficient=0.01 mm^-0.5",
    ];
    let rows = rows(&case, &[&recess[..], &["accuracy=0.1"]].concat());
    for (distance, depth, pressure) in [(0.03, 1.9142e-9, 6.286e8), (0.3, 1.792e-8, 5.682e8)] {
        let row = row_at(&rows, distance);
        assert_within(row, "wear_depth_m", (depth, 1e-3 * depth), "depth");
        assert_within(row, "centre_pressure_Pa", (pressure, 1e-3 * pressure), "pressure");
    }
}

/// Pressures under a coefficient that runs in, against an independent axisymmetric solution.
#[test]
fn pressures_under_a_law_that_remembers_lie_within_the_errors_stated() {
    for accuracy in ASKED {
        let rows = rows(FORMULA, &[accuracy]);
        for (distance, truth) in [(0.02, 46.838e6), (0.1, 28.465e6), (0.2, 22.356e6)] {
            let row = row_at(&rows, distance);
            assert_within(row, "centre_pressure_Pa", (truth, 5e-4 * truth), accuracy);
        }
    }
}

/// Pressures on a scar that swings ripple by percents, and say so.
#[test]
fn pressures_on_a_scar_that_swings_lie_within_the_errors_stated() {
    let variants: [&[&str]; 3] = [
        &[],
        &["body.cylinder.wear.archard.coefficient=7.65975e-9 1/MPa"],
        &["body.flat.material.young=251.871 GPa", "body.cylinder.material.young=336.072 GPa"],
    ];
    for options in variants {
        let at = |accuracy: &'static str| rows(FRETTING, &[options, &[accuracy]].concat());
        let truth = at("accuracy=0.003");
        for accuracy in ASKED {
            let found = at(accuracy);
            for cycles in [1000.0, 5000.0, 10_000.0, 18_000.0] {
                let [row, best] = [&found, &truth].map(|rows| row_at(rows, cycles));
                let what = format!("{accuracy} at {cycles}");
                for column in ["peak_pressure_Pa", "centre_pressure_Pa", "wear_depth_flat_m"] {
                    assert_within(row, column, with_error(best, column), &what);
                }
            }
        }
    }
}
