//! The error stated where elements see an edge badly: of what touches, of what sticks, of a punch, of a scar that swings.

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
