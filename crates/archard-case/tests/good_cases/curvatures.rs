//! A cylinder has its curvature whether it is a profile or a mesh, in all that asks for it.

use approx::assert_relative_eq;
use archard_case::RunnableCase;
use archard_case::output::{ResultFolder, Totals};
use serde_json::Value;

use crate::common::Rows;
use crate::{file, resolve};

/// Bodies of a rolling contact along a line of 4 mm.
const ROLLING: &str = r#"
[body.rail]
material = { young = "210 GPa", poisson = 0.3 }
RAIL
[body.disc]
material = { young = "210 GPa", poisson = 0.3 }
wear.archard = { coefficient = "1e-13 1/Pa" }
DISC
[friction.coulomb]
coefficient = 0.01
[motion.rolling]
load = "2.9 kN"
creepage = -0.002
revolutions = 100000
step = 10000
radius = "worn"
"#;
const RAIL: &str = r#"
mesh.box = { size = ["16 mm", "4 mm", "8 mm"], contact = { size = ["1 mm", "4 mm"], elements = [16, 3] } }
elasticity = "half_space""#;
const DISC: &str = r#"
mesh.cylinder = { radius = "20 mm", length = "4 mm", contact = { face = "side", size = ["1 mm", "4 mm"], elements = [16, 3] } }
elasticity = "half_space""#;

fn rolling(meshed: bool, options: &[&str]) -> RunnableCase {
    let frame = "[frame]\nsize = [\"1 mm\", \"4 mm\"]\nelements = [32, 6]\n[friction.";
    let text = if meshed {
        ROLLING.replace("RAIL", RAIL).replace("DISC", DISC)
    } else {
        let text = ROLLING.replace("RAIL", "profile.flat = {}").replace("[friction.", frame);
        text.replace("DISC", "profile.cylinder = { radius = \"20 mm\" }")
    };
    resolve(&options.iter().fold(file(&text), |file, option| file.set(*option)))
}

/// What `summary.json` says in closed form, and the rows of the run.
pub fn run(resolved: &RunnableCase) -> (Value, Rows) {
    let folder = tempfile::tempdir().unwrap();
    let mut results = ResultFolder::create(folder.path(), &resolved.case.to_string()).unwrap();
    let mut rows = Rows::default();
    resolved.case.build().unwrap().run(&mut [&mut results, &mut rows]).unwrap();
    results.finish(&Totals::default()).unwrap();
    let summary = std::fs::read_to_string(folder.path().join("summary.json")).unwrap();
    let summary: Value = serde_json::from_str(&summary).unwrap();
    (summary["closed_form"].clone(), rows)
}

#[test]
fn bodies_of_meshes_and_profiles_have_the_same_curvatures() {
    for meshed in [true, false] {
        let simulation = rolling(meshed, &[]).case.build().unwrap();
        let curvatures = simulation.problem.bodies.each_ref().map(|body| body.curvatures());
        assert_eq!(curvatures, [Some([0.0; 2]), Some([50.0, 0.0])]);
    }
}

#[test]
fn check_and_summary_tell_the_same_contact() {
    for meshed in [true, false] {
        let resolved = rolling(meshed, &["motion.rolling.revolutions=0", "motion.rolling.step="]);
        let half_width = resolved.forecast.estimate.contact.unwrap().semi_axes[0];
        let (said, _) = run(&resolved);
        assert_eq!(said["curvatures_per_m"], serde_json::json!([50.0, 0.0]), "{said}");
        let carter = said["carter"]["half_width_m"].as_f64().unwrap();
        assert_relative_eq!(carter, half_width, max_relative = 1e-9);
    }
}

/// The disc loses 1/R times what it wears of its creepage, here about a third at the end.
#[test]
fn worn_radii_count_on_meshes_as_on_profiles() {
    let lost = [true, false].map(|meshed| {
        let worn = ["worn", "nominal"].map(|radius| {
            let option = format!("motion.rolling.radius={radius}");
            run(&rolling(meshed, &[&option])).1.last("worn_section_disc_m2")
        });
        worn[0] / worn[1] - 1.0
    });
    assert!(lost[1].abs() > 0.05, "{lost:?}");
    assert_relative_eq!(lost[0], lost[1], max_relative = 0.05);
}
