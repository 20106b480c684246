//! Two blocks whose meshes do not match, against the same blocks with nodes that face each other.

use approx::assert_relative_eq;

use crate::common::{Rows, case};

/// A rounded block pressed into a block, like on like, a quarter of both.
const BLOCKS: &str = r#"
[body.punch]
material = { young = "210 GPa", poisson = 0.3 }
supports = { bottom = "clamped" }
symmetry = ["x", "y"]
profile.power = { coefficient = "0.005 1/m", exponent = 2 }
[body.punch.mesh.box]
size = ["1 m", "1 m", "1 m"]
contact = { size = ["0.2 m", "0.2 m"], elements = [10, 10] }
[body.block]
material = { young = "210 GPa", poisson = 0.3 }
supports = { bottom = "clamped" }
symmetry = ["x", "y"]
[body.block.mesh.box]
size = ["1 m", "1 m", "1 m"]
contact = { size = ["0.24 m", "0.24 m"], elements = [12, 12] }
[motion.indentation]
approach = "0.07 mm"
[friction.coulomb]
coefficient = 0.3
"#;

fn pressed(options: &[&str]) -> Rows {
    let mut rows = Rows::default();
    case(BLOCKS, options).run(&mut [&mut rows]).expect("it converges");
    rows
}

/// Elements of the second body 1.83, 1.38 and 0.92 times as wide as those of the first. Like materials under
/// friction slip nowhere: tangential displacements of both are the same.
#[test]
#[ignore = "long: in .ci/long"]
fn pressures_do_not_swing() {
    let matching = pressed(&[]);
    for elements in ["[6, 6]", "[8, 8]", "[12, 12]"] {
        let rows = pressed(&[
            "body.block.mesh.box.contact.size=[\"0.22 m\", \"0.22 m\"]",
            &format!("body.block.mesh.box.contact.elements={elements}"),
        ]);
        for (column, within) in
            [("load_N", 1e-3), ("peak_pressure_Pa", 0.02), ("centre_pressure_Pa", 0.02)]
        {
            assert_relative_eq!(rows.last(column), matching.last(column), max_relative = within);
        }
        // Against a rigid punch it is of the order of 10 mJ.
        assert!(rows.last("dissipated_J") < 1e-6, "{}", rows.last("dissipated_J"));
    }
}

/// A half-space opposite turns along with a block of its material: nothing slips either, and the load is
/// that without friction.
#[test]
fn a_half_space_moves_along_the_surface_as_a_block_does() {
    let half_space = ["body.block.elasticity=half_space"];
    let rows = pressed(&half_space);
    let without = pressed(&[half_space[0], "friction="]);
    assert_relative_eq!(rows.last("load_N"), without.last("load_N"), max_relative = 1e-4);
    assert!(rows.last("dissipated_J") < 1e-6, "{}", rows.last("dissipated_J"));
}
