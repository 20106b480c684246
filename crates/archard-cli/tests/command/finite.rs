//! Finite bodies: what is kept of them, what `check` says of them, and bodies without contact.

use std::fs;
use std::path::PathBuf;

use tempfile::TempDir;

use super::{archard, case, printed, said, squeezed};

/// A small block under a punch, its compliances in a folder of their own.
fn run_block(dir: &TempDir, output: &str) -> String {
    let case = case("punch_indentation_block");
    let arguments = [
        "run",
        case.to_str().unwrap(),
        "-o",
        output,
        "--cache",
        "kept",
        "--set",
        "body.block.mesh.box.contact.elements=[4, 4]",
        "--set",
        "motion.indentation.increments=4",
        "--quiet",
    ];
    archard(dir, &arguments).success();
    fs::read_to_string(dir.path().join(output).join("history.csv")).unwrap()
}

#[test]
fn compliances_are_kept_and_give_the_same_bits() {
    let dir = TempDir::new().unwrap();
    let kept = || -> Vec<PathBuf> {
        let entries = fs::read_dir(dir.path().join("kept")).unwrap();
        entries.map(|entry| entry.unwrap().path()).collect()
    };
    let first = run_block(&dir, "first");
    let [file] = &kept()[..] else { panic!("{:?}", kept()) };
    let sound = fs::read(file).unwrap();
    assert_eq!(run_block(&dir, "second"), first);
    assert_eq!(kept().len(), 1);
    // Damage is found, and what was damaged computed and kept again.
    let mut damaged = sound.clone();
    let middle = damaged.len() / 2;
    damaged[middle] ^= 1;
    fs::write(file, &damaged).unwrap();
    assert_eq!(run_block(&dir, "third"), first);
    assert_eq!(fs::read(file).unwrap(), sound);
    // As is a file cut short.
    fs::write(file, &sound[..middle]).unwrap();
    assert_eq!(run_block(&dir, "fourth"), first);
    assert_eq!(fs::read(file).unwrap(), sound);
    // And one that others may write to, with a warning in the summary.
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        fs::set_permissions(file, fs::Permissions::from_mode(0o666)).unwrap();
        assert_eq!(run_block(&dir, "fifth"), first);
        assert_eq!(fs::metadata(file).unwrap().permissions().mode() & 0o777, 0o600);
        let summary = fs::read_to_string(dir.path().join("fifth/summary.json")).unwrap();
        assert!(summary.contains("may be written by other users"), "{summary}");
    }
}

#[test]
fn another_material_has_a_compliance_of_its_own_and_friction_has_not() {
    let dir = TempDir::new().unwrap();
    let case = case("punch_indentation_block");
    let run = |option: &str| {
        let small = "body.block.mesh.box.contact.elements=[4, 4]";
        let steps = "motion.indentation.increments=2";
        let arguments =
            ["run", case.to_str().unwrap(), "-o", "out", "--cache", "kept", "-q", "--force"];
        let options = ["--set", small, "--set", steps, "--set", option];
        archard(&dir, &[&arguments[..], &options].concat()).success();
        fs::read_dir(dir.path().join("kept")).unwrap().count()
    };
    assert_eq!(run("friction.coulomb.coefficient=0.3"), 1);
    assert_eq!(run("friction.coulomb.coefficient=0.1"), 1);
    assert_eq!(run("body.block.material.young=200 GPa"), 2);
    // A half-space needs none.
    assert_eq!(run("body.block.elasticity=half_space"), 2);
}

#[test]
fn stresses_inside_of_a_body_in_contact_are_put_out() {
    let dir = TempDir::new().unwrap();
    let case = case("punch_indentation_block");
    let points =
        r#"output.points.block={ top = ["0 m", "0 m", "0 m"], below = ["0 m", "0 m", "-50 mm"] }"#;
    let small = "body.block.mesh.box.contact.elements=[8, 8]";
    let steps = "motion.indentation.increments=1";
    let alone = ["--set", "friction=", "--set", "body.block.wear="];
    let arguments =
        [&["run", case.to_str().unwrap(), "-o", "out", "-q", "--force"], &alone[..]].concat();
    let options = ["--set", small, "--set", steps, "--set", points];
    archard(&dir, &[&arguments[..], &options].concat()).success();
    let out = dir.path().join("out");
    let table = fs::read_to_string(out.join("points.csv")).unwrap();
    assert!(table.starts_with("body,point,x_m,y_m,z_m,depth_m,displacement_x_m"), "{table}");
    let below = table.lines().find(|line| line.starts_with("block,below,")).expect("a row");
    let stress: f64 = below.split(',').nth(11).unwrap().parse().unwrap();
    // Hertz: the peak pressure is 123 MPa, the radius 83.7 mm.
    assert!((stress / (-123e6 / (1.0 + (50.0f64 / 83.7).powi(2))) - 1.0).abs() < 0.03, "{below}");
    let surface = archard_case::output::Surface::read(&out.join("surface_2.vtu")).unwrap();
    let stress = surface.field("stress_zz_Pa").expect("a field");
    assert!(stress.iter().fold(0.0, |least: f64, stress| least.min(*stress)) < -110e6);
    // A run without points leaves none of an earlier one.
    let options = ["--set", small, "--set", steps];
    archard(&dir, &[&arguments[..], &options].concat()).success();
    assert!(!out.join("points.csv").exists() && !out.join("surface_2.vtu").exists());
}

/// A section and a point: what every traction makes of the body is kept next to its compliance, so that a second run solves
/// nothing and writes the same bits.
#[test]
fn sections_are_put_out_and_shown_in_paraview() {
    let dir = TempDir::new().unwrap();
    let case = case("punch_indentation_block");
    let run = |output: &str| {
        let section = r#"output.sections.block.middle={ through = ["0 m", "0 m", "0 m"], normal = [0, 1, 0], spacing = "50 mm", size = ["0.4 m", "0.8 m"] }"#;
        let options = [
            "body.block.mesh.box.contact.elements=[4, 4]",
            "motion.indentation.increments=4",
            r#"output.points.block.below=["0 m", "0 m", "-50 mm"]"#,
            section,
        ];
        let case = case.to_str().unwrap();
        let mut arguments = vec!["run", case, "-o", output, "-q", "--force", "--cache", "kept"];
        options.iter().for_each(|option| arguments.extend(["--set", option]));
        archard(&dir, &arguments).success();
        let read = |name: &str| fs::read(dir.path().join(output).join(name)).unwrap();
        let files = ["points.csv", "surface_2.vtu", "sections/block_middle.vtu"].map(read);
        let kept = fs::read_dir(dir.path().join("kept")).unwrap();
        let mut kept: Vec<_> = kept.map(|entry| entry.unwrap().path()).collect();
        kept.sort();
        (files, kept)
    };
    let (first, kept) = run("first");
    assert_eq!(kept.len(), 2, "{kept:?}");
    // Were the equations solved again, they would be written again.
    let written = |path: &PathBuf| fs::metadata(path).unwrap().modified().unwrap();
    let times: Vec<_> = kept.iter().map(written).collect();
    assert_eq!(run("second"), (first, kept.clone()));
    assert_eq!(kept.iter().map(written).collect::<Vec<_>>(), times);
    // A grid of 9 by 9 places below the surface, the middle of them at the point.
    let sheet =
        archard_case::output::Sheet::read(&dir.path().join("first/sections/block_middle.vtu"));
    let sheet = sheet.unwrap();
    assert_eq!((sheet.points.len(), sheet.cells.len()), (9 * 9, 8 * 8));
    let at = |place: &[f64; 3]| {
        place[0].abs() < 1e-9 && place[1] == 0.0 && (place[2] - 0.05).abs() < 1e-9
    };
    // The block lies above the plane of contact, turned over; the table keeps to its own coordinates.
    let place = sheet.points.iter().position(at).expect("a place 50 mm within");
    let stress = sheet.fields.iter().find(|field| field.name == "stress_zz_Pa").unwrap();
    let table = fs::read_to_string(dir.path().join("first/points.csv")).unwrap();
    let known: f64 = table.lines().nth(1).unwrap().split(',').nth(11).unwrap().parse().unwrap();
    assert!((stress.values[place] / known - 1.0).abs() < 1e-9, "{known}");
    let sinks = sheet.fields.iter().find(|field| field.name == "displacement_z_m").unwrap();
    let known: f64 = table.lines().nth(1).unwrap().split(',').nth(8).unwrap().parse().unwrap();
    assert!((sinks.values[place] / -known - 1.0).abs() < 1e-9, "{known}");
    let said = printed(&archard(&dir, &["paraview", "first"]).success());
    assert!(said.contains("stress_block.vtu, section_block_middle.vtu"), "{said}");
    for name in ["stress_block.vtu", "section_block_middle.vtu", "block.pvd", "open.py"] {
        assert!(dir.path().join("first/paraview").join(name).is_file(), "{name}");
    }
    let refused = |options: &[&str]| {
        let arguments = [&["check", case.to_str().unwrap()], options].concat();
        crate::said(&archard(&dir, &arguments).code(2))
    };
    let plane = |rest: &str| {
        format!(
            "output.sections.block.a={{ through = [\"0 m\", \"0 m\", \"9 m\"], normal = {rest} }}"
        )
    };
    for (rest, message) in [
        ("[0, 0, 1], spacing = \"50 mm\"", "no square of the grid lies in it"),
        ("[0, 0, 0], spacing = \"1 mm\"", "no direction"),
        ("[0, 1, 0], spacing = \"0.1 mm\"", "take a larger `spacing`"),
        ("[0, 1], spacing = \"1 mm\"", "expected three values"),
    ] {
        let said = refused(&["--set", &plane(rest)]);
        assert!(said.contains(message), "{rest}: {said}");
    }
    let said = refused(&[
        "--set",
        r#"output.sections.punch.a={ through = ["0 m", "0 m", "0 m"], normal = [0, 1, 0], spacing = "1 mm" }"#,
    ]);
    assert!(said.contains("has no stress to put out"), "{said}");
}

#[test]
fn check_compares_a_meshed_body_with_a_half_space() {
    let dir = TempDir::new().unwrap();
    let checked = archard(&dir, &["check", case("punch_indentation_block").to_str().unwrap()]);
    let checked = checked.success();
    let printed = printed(&checked);
    for line in [
        "Hertz contact     radius 83.7 mm",
        "% of the approach where `block` ends, 500 mm away",
        "half-space        in place of `block`: about 1.2 % more approach",
        "of `block`\n",
        "elasticity        half-space and image field for `block`: it touches with a flat face",
        "pairs             1600\n",
        "No warnings.",
    ] {
        assert!(printed.contains(line), "{line} is not in\n{printed}");
    }
}

#[test]
fn an_elastic_body_is_checked_and_run() {
    let dir = TempDir::new().unwrap();
    archard(&dir, &["new", "patch_test"]).success();
    let checked = printed(&archard(&dir, &["check", "patch_test"]).success());
    for line in ["output.points.on_x1 = [\"1 m\", \"0.4 m\", \"0.7 m\"]", "`cut`", "unknowns"] {
        assert!(checked.contains(line), "{line} is not in\n{checked}");
    }
    let ran = printed(&archard(&dir, &["run", "patch_test"]).success());
    assert!(ran.contains("at `inside`"), "{ran}");
    let results = dir.path().join("results/patch_test");
    let points = fs::read_to_string(results.join("points.csv")).unwrap();
    let header = "point,x_m,y_m,z_m,depth_m,displacement_x_m,displacement_y_m,displacement_z_m,\
        stress_xx_Pa,stress_yy_Pa,stress_zz_Pa,stress_xy_Pa,stress_yz_Pa,stress_zx_Pa,von_mises_Pa";
    assert_eq!(points.lines().next(), Some(header));
    assert_eq!(points.lines().count(), 4);
    let surface = archard_case::output::Surface::read(&results.join("surface.vtu")).unwrap();
    let stress = surface.field("stress_zz_Pa").expect("a field");
    assert!(stress.iter().all(|stress| (stress - 1.5e6).abs() < 50.0), "{stress:?}");
    archard(&dir, &["run", "results/patch_test", "-o", "again", "-q"]).success();
    assert_eq!(fs::read_to_string(dir.path().join("again/points.csv")).unwrap(), points);
    let shown = printed(&archard(&dir, &["paraview", "results/patch_test"]).success());
    assert!(shown.contains("stress_body.vtu written into"), "{shown}");
    let refused = archard(&dir, &["plot", "results/patch_test"]).code(2);
    assert!(said(&refused).contains("open its surface.vtu"), "{}", said(&refused));
}

/// Elements of two and a half thicknesses put the tip of this cantilever where it cannot be: that is no success, and
/// everything is written and marked all the same. With the mesh left out it is right.
#[test]
fn a_body_out_of_balance_is_a_failure_with_everything_written() {
    let dir = TempDir::new().unwrap();
    let beam = |divisions: &str| {
        format!(
            r#"
[body.b]
material = {{ young = "1 GPa", poisson = 0.3 }}
mesh.box = {{ size = ["10 m", "1 m", "1 m"]{divisions} }}
symmetry = ["y"]
supports = {{ left = "clamped", right = {{ traction = ["0 Pa", "0 Pa", "1 kPa"] }} }}
[output.points]
tip = ["5 m", "0 m", "-0.5 m"]
"#
        )
    };
    let summary = || -> serde_json::Value {
        let text = fs::read_to_string(dir.path().join("beam/summary.json")).unwrap();
        serde_json::from_str(&text).unwrap()
    };
    fs::write(dir.path().join("beam.toml"), beam(", divisions = [4, 4, 4]")).unwrap();
    let checked = archard(&dir, &["check", "beam.toml"]).success();
    assert!(
        said(&checked).contains("2.50 times as long as the body is thick"),
        "{}",
        said(&checked)
    );
    let failed = archard(&dir, &["run", "beam.toml", "-o", "beam"]).code(1);
    assert!(said(&failed).contains("of the load's moment is not balanced"), "{}", said(&failed));
    assert!(dir.path().join("beam/points.csv").exists());
    let wrong = summary();
    assert_eq!(wrong["complete"], true);
    assert_eq!(wrong["verdict"]["lines"][1]["subject"], "moments");
    assert_eq!(wrong["verdict"]["lines"][1]["word"], "wrong");
    fs::remove_dir_all(dir.path().join("beam")).unwrap();
    fs::write(dir.path().join("beam.toml"), beam("")).unwrap();
    let ran = printed(&archard(&dir, &["run", "beam.toml", "-o", "beam"]).success());
    assert!(squeezed(&ran).contains("verdict good ("), "{ran}");
    assert_eq!(summary()["verdict"]["word"], "good");
}

/// In a bush there are pressures that wear and do not bear the load: k F s is no closed form of the volume there.
#[test]
fn no_volume_is_said_to_follow_from_the_load_where_the_contact_is_curved() {
    let dir = TempDir::new().unwrap();
    let case = case("pin_in_bush");
    let short = ["--set", "motion.sliding.distance=20 m"];
    let mut arguments = vec!["run", case.to_str().unwrap(), "-o", "out", "--quiet"];
    arguments.extend(short);
    archard(&dir, &arguments).success();
    let text = fs::read_to_string(dir.path().join("out/summary.json")).unwrap();
    let summary: serde_json::Value = serde_json::from_str(&text).unwrap();
    let wear = &summary["wear"]["bush"];
    assert!(wear["worn_volume_m3"].as_f64().unwrap() > 0.0, "{wear}");
    assert!(
        wear["expected_volume_m3"].is_null() && wear["relative_difference"].is_null(),
        "{wear}"
    );
    archard(&dir, &["report", "out"]).success();
    let page = fs::read_to_string(dir.path().join("out/report.html")).unwrap();
    assert!(!page.contains("k F s"));
}
