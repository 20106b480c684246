//! Cases that ask for stresses in half-spaces.

use crate::{case, reads_back};

const BALL: &str = r#"
[body.ball]
material = { young = "210 GPa", poisson = 0.3 }
profile.sphere = { radius = "50 mm" }
[body.flat]
material = { young = "210 GPa", poisson = 0.3 }
profile.flat = {}
[frame]
size = ["0.4 mm", "0.4 mm"]
elements = [20, 20]
[motion.indentation]
load = "10.2 N"
[output]
points.ball.below = ["0 mm", "0 mm", "-72 um"]
sections.flat.middle = { through = ["0 mm", "0 mm", "0 mm"], normal = [0, 1, 0], spacing = "10 um", size = ["0.1 mm", "0.1 mm"] }
[output.stress]
ball = {}
"#;

#[test]
fn what_is_asked_of_stresses_reads_back() {
    let ways = [
        ("\"auto\"", vec![]),
        ("[\"20 um\", \"5 um\", \"5 um\"]", vec![5e-6, 20e-6]),
        ("{ first = \"1 um\", last = \"100 um\", count = 3 }", vec![1e-6, 10e-6, 100e-6]),
    ];
    for (depths, known) in ways {
        let more = format!(
            "flat = {{ depths = {depths}, field = true, initial = {{ xx = \"-120 MPa\", zx = \"5 MPa\" }}, yield_strength = \"600 MPa\" }}\n"
        );
        let case = case(&(BALL.to_owned() + &more));
        reads_back(&case);
        let wanted = case.stresses[1].clone().unwrap();
        assert_eq!(wanted.depths.len(), known.len());
        for (found, known) in wanted.depths.iter().zip(known) {
            assert!((found / known - 1.0).abs() < 1e-12, "{found} {known}");
        }
        assert!(wanted.field && wanted.strength == Some(600e6));
        assert_eq!(wanted.initial, [-120e6, 0.0, 0.0, 0.0, 5e6, 0.0]);
        assert!(!case.stresses[0].as_ref().unwrap().field);
    }
}

#[test]
fn strengths_of_layers_read_back_and_hardness_stands_for_them() {
    let layers = r#"layers = [{ young = "300 GPa", poisson = 0.2, thickness = "3 um", hardness = "14 GPa" }, { young = "250 GPa", poisson = 0.3, thickness = "1 um" }]"#;
    let coated = BALL.replace("profile.flat = {}", &format!("{layers}\nprofile.flat = {{}}"));
    let more = "flat = { layer_strengths = [\"5 GPa\", \"900 MPa\"] }\n";
    let case = case(&(coated + more));
    reads_back(&case);
    let wanted = case.stresses[1].as_ref().unwrap();
    assert_eq!(wanted.layer_strengths, [5e9, 900e6]);
    assert_eq!(wanted.hardness, [Some(14e9), None, None]);
}

#[test]
fn points_and_sections_of_waves_need_no_multiple_of_elements() {
    let waves = BALL
        .replace(
            "profile.sphere = { radius = \"50 mm\" }",
            "profile.wave = { amplitude = \"0.5 um\", length_x = \"0.2 mm\" }",
        )
        .replace("elements = [20, 20]", "elements = [20, 20]\nperiodic = true")
        .replace("load = \"10.2 N\"", "load = \"10 MPa\"")
        .replace("[output.stress]\nball = {}\n", "");
    let case = case(&waves);
    reads_back(&case);
    assert!(case.frame.periodic && !case.sections[1].is_empty());
}
