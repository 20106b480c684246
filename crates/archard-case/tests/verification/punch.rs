//! A rigid punch pressed into a block with friction, once: the first case of the paper's section 6.1.

use approx::assert_relative_eq;

use crate::common::{Rows, case};

/// The published case with other options.
fn indent(options: &[&str]) -> Rows {
    let case_file = include_str!("../../../../cases/punch_indentation/case.toml");
    let mut rows = Rows::default();
    case(case_file, options).run(&mut [&mut rows]).expect("it converges");
    rows
}

/// Independent values on half-spaces: load (N) and pressure in the centre (Pa) with friction and without,
/// and the stick ratio. They are for a contact zone on 40 x 40 nodes with bilinear tractions; with uniform
/// tractions on the elements the load is 0.03 % and the pressure 0.16 % higher.
#[test]
fn the_first_case_is_as_computed_independently() {
    for increments in [10, 20, 40] {
        let rows = indent(&[&format!("motion.indentation.increments={increments}")]);
        assert_relative_eq!(rows.last("load_N"), 1.82810e6, max_relative = 3e-3);
        assert_relative_eq!(rows.last("centre_pressure_Pa"), 1.33587e8, max_relative = 5e-3);
        let stick_ratio = (rows.last("stick_area_m2") / rows.last("contact_area_m2")).sqrt();
        // An element is 0.06 of the radius of contact; at each size of an increment, what just closed sticks.
        assert!((stick_ratio - 0.896).abs() < 0.06, "{stick_ratio}");
    }
    let rows = indent(&["friction=", "body.block.wear="]);
    assert_relative_eq!(rows.last("load_N"), 1.802037e6, max_relative = 1e-3);
    assert_relative_eq!(rows.last("centre_pressure_Pa"), 1.229156e8, max_relative = 1e-3);
}

/// What 10, 20 and 40 increments end with. Depths are of little meaning on any grid: pairs slide only around
/// the time they close.
#[test]
fn increments_hardly_matter() {
    let ends = [10, 20, 40].map(|increments| {
        let rows = indent(&[&format!("motion.indentation.increments={increments}")]);
        ["load_N", "centre_pressure_Pa", "dissipated_J"].map(|column| rows.last(column))
    });
    let [ten, twenty, forty] = ends;
    assert_relative_eq!(ten[0], forty[0], max_relative = 2e-4);
    assert_relative_eq!(twenty[0], forty[0], max_relative = 1e-4);
    assert_relative_eq!(ten[1], forty[1], max_relative = 3e-3);
    assert_relative_eq!(twenty[1], forty[1], max_relative = 1e-3);
}
