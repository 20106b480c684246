//! The command as a user meets it: exit codes, what it says, what it leaves behind.

mod accuracy;
mod browser;
mod compare;
mod finite;
mod fit;
mod memory;
mod report;
mod sweep;
mod tasks;
mod verdict;

use std::fs;
use std::path::{Path, PathBuf};

use archard::friction::FRICTION;
use archard::wear::WEAR_LAWS;
use assert_cmd::Command;
use assert_cmd::assert::Assert;
use tempfile::TempDir;

/// A published case.
fn case(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases").join(name)
}

/// What the command does with these arguments in a folder.
fn archard(dir: &TempDir, arguments: &[&str]) -> Assert {
    Command::cargo_bin("archard").unwrap().current_dir(dir.path()).args(arguments).assert()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

fn said(assert: &Assert) -> String {
    text(&assert.get_output().stderr)
}

fn printed(assert: &Assert) -> String {
    text(&assert.get_output().stdout)
}

#[test]
fn a_wrong_case_exits_with_two_and_points_at_the_line() {
    let dir = TempDir::new().unwrap();
    let wrong = fs::read_to_string(case("pin_on_disc/case.toml")).unwrap();
    fs::write(dir.path().join("pin.toml"), wrong.replace("\"50 mm\" }", "50 }")).unwrap();
    for command in ["run", "check"] {
        let refused = archard(&dir, &[command, "pin.toml"]).code(2);
        let said = said(&refused);
        assert!(said.contains("pin.toml:5:29"), "{said}");
        assert!(said.contains("`body.pin.profile.sphere.radius`"), "{said}");
        assert!(said.contains("write \"50 mm\" or \"50 m\""), "{said}");
    }
    assert!(!dir.path().join("results").exists());
}

/// Whatever law is in the lists, with all it takes.
#[test]
fn laws_are_listed() {
    let dir = TempDir::new().unwrap();
    let listed = printed(&archard(&dir, &["laws"]).success());
    let wear = WEAR_LAWS.iter().map(|law| (law.name, law.meaning, law.parameters));
    let friction = FRICTION.iter().map(|law| (law.name, law.meaning, law.parameters));
    for (name, meaning, parameters) in wear.chain(friction) {
        assert!(listed.contains(&format!("{name}: {meaning}\n")), "{listed}");
        for parameter in parameters {
            assert!(listed.contains(parameter.meaning), "{listed}");
        }
    }
    assert!(listed.contains("    threshold    J/m^2  work of friction"), "{listed}");
}

#[test]
fn a_case_that_is_not_there_exits_with_two() {
    let dir = TempDir::new().unwrap();
    let refused = archard(&dir, &["run", "nowhere.toml"]).code(2);
    assert!(said(&refused).contains("cannot read the case `nowhere.toml`"));
}

#[test]
fn an_option_on_an_unknown_key_points_at_the_option() {
    let dir = TempDir::new().unwrap();
    let case = case("pin_on_disc");
    let option = "motion.sliding.stpe=10 mm";
    let refused = archard(&dir, &["check", case.to_str().unwrap(), "--set", option]).code(2);
    let said = said(&refused);
    assert!(said.contains("--set:1:16"), "{said}");
    assert!(said.contains("did you mean `step`?"), "{said}");
}

#[test]
fn check_prints_the_case_in_si_and_the_forecast() {
    let dir = TempDir::new().unwrap();
    let checked = archard(&dir, &["check", case("pin_on_disc").to_str().unwrap()]).success();
    let printed = printed(&checked);
    for line in [
        "body.pin.profile.sphere.radius = \"0.05 m\"",
        "motion.sliding.step = \"0.005 m\"",
        "Hertz contact     radius 0.149 mm",
        "peak pressure     219 MPa",
        "wear depth        2.08 um at the end",
        "contact solves    101",
    ] {
        assert!(printed.contains(line), "{line} is not in\n{printed}");
    }
    assert!(said(&checked).contains("only 7.46 elements lie across the contact"));
}

#[test]
fn a_run_leaves_a_case_that_runs_again() {
    let dir = TempDir::new().unwrap();
    let small = ["--set", "frame.elements=[12, 12]", "--set", "motion.sliding.step=50 mm"];
    let case = case("pin_on_disc");
    let mut arguments = vec!["run", case.to_str().unwrap()];
    arguments.extend(small);
    let ran = archard(&dir, &arguments).success();
    let results = "results/pin_on_disc--frame.elements=12x12--motion.sliding.step=50mm";
    assert!(printed(&ran).contains(results), "{}", printed(&ran));
    let again = archard(&dir, &["run", results, "-o", "again", "--quiet"]).success();
    let results = dir.path().join(results);
    for name in ["case.toml", "history.csv", "summary.json", "fields.pvd"] {
        assert!(results.join(name).is_file(), "{name}");
    }
    assert_eq!((printed(&again), said(&again)), (String::new(), String::new()));
    for name in ["case.toml", "history.csv"] {
        let read = |folder: &Path| fs::read_to_string(folder.join(name)).unwrap();
        assert_eq!(read(&results), read(&dir.path().join("again")), "{name}");
    }
}

#[test]
fn results_in_a_folder_of_an_earlier_run_leave_other_files_alone() {
    let dir = TempDir::new().unwrap();
    let case = case("hertz");
    let arguments =
        ["run", case.to_str().unwrap(), "-o", "out", "--set", "frame.elements=[10, 10]"];
    archard(&dir, &arguments).success();
    fs::write(dir.path().join("out/notes.txt"), "mine").unwrap();
    archard(&dir, &arguments).success();
    assert_eq!(fs::read_to_string(dir.path().join("out/notes.txt")).unwrap(), "mine");
}

#[test]
fn an_output_folder_that_cannot_be_written_exits_with_two() {
    let dir = TempDir::new().unwrap();
    fs::write(dir.path().join("taken"), "a file, not a folder").unwrap();
    let case = case("hertz");
    let refused = archard(&dir, &["run", case.to_str().unwrap(), "-o", "taken/out"]).code(2);
    let said = said(&refused);
    assert!(said.contains("cannot write `taken/out"), "{said}");
}

#[test]
fn results_never_replace_the_case_itself() {
    let dir = TempDir::new().unwrap();
    archard(&dir, &["new", "hertz"]).success();
    let before = fs::read_to_string(dir.path().join("hertz/case.toml")).unwrap();
    let refused = archard(&dir, &["run", "hertz", "-o", "hertz"]).code(2);
    assert!(said(&refused).contains("would overwrite the case"));
    assert_eq!(fs::read_to_string(dir.path().join("hertz/case.toml")).unwrap(), before);
}

#[test]
fn new_lists_and_writes_the_cases() {
    let dir = TempDir::new().unwrap();
    let listed = printed(&archard(&dir, &["new"]).success());
    for name in ["hertz", "pin_on_disc", "pin_on_disc_both"] {
        assert!(
            listed.lines().any(|line| line.split_whitespace().next() == Some(name)),
            "{listed}"
        );
        let written = printed(&archard(&dir, &["new", name]).success());
        let next = format!("archard run {name}");
        assert!(written.contains(&next), "{written}");
        archard(&dir, &["run", &format!("{name}/case.toml"), "-q"]).success();
        assert!(dir.path().join("results").join(name).join("history.csv").is_file());
        let refused = archard(&dir, &["new", name]).code(2);
        assert!(said(&refused).contains("cannot write"), "{}", said(&refused));
    }
    let unknown = archard(&dir, &["new", "gear"]).code(2);
    assert!(said(&unknown).contains("there is no rig and no built-in case `gear`"));
}

#[test]
fn rigs_are_known_by_name() {
    let dir = TempDir::new().unwrap();
    let listed = printed(&archard(&dir, &["new", "--list"]).success());
    let rigs = listed.lines().skip(2).take_while(|line| !line.is_empty());
    let rigs: Vec<&str> = rigs.filter_map(|line| line.split_whitespace().next()).collect();
    assert!(rigs.contains(&"fretting") && rigs.contains(&"twin_disc"), "{listed}");
    for rig in rigs {
        let spelt = rig.replace('_', " ");
        archard(&dir, &["new", &spelt, "-o", rig]).success();
        let checked = archard(&dir, &["check", rig, "--json"]).success();
        let checked: serde_json::Value = serde_json::from_str(&printed(&checked)).unwrap();
        assert_eq!(checked["valid"], true);
        // A rig's case explains itself.
        let text = fs::read_to_string(dir.path().join(rig).join("case.toml")).unwrap();
        assert!(text.contains("# "), "{text}");
    }
}

#[test]
fn check_tells_programs_what_it_tells_people() {
    let dir = TempDir::new().unwrap();
    let case = case("hertz");
    let checked = archard(&dir, &["check", case.to_str().unwrap(), "--json"]).success();
    let checked: serde_json::Value = serde_json::from_str(&printed(&checked)).unwrap();
    // Hertz: (6 F E*^2 / (pi^3 R^2))^(1/3).
    let modulus = 210e9 / (2.0 * (1.0 - 0.09));
    let pressure =
        (6.0 * 10.2 * modulus * modulus / (std::f64::consts::PI.powi(3) * 0.05 * 0.05)).cbrt();
    let found = checked["closed_form"]["hertz"]["peak_pressure_Pa"].as_f64().unwrap();
    assert!((found / pressure - 1.0).abs() < 1e-12, "{found} {pressure}");
    assert_eq!(checked["pairs"], 3600);

    fs::write(dir.path().join("wrong.toml"), "title = \"a\"\n[body.ball]\n  colour = 1\n").unwrap();
    let refused = archard(&dir, &["check", "wrong.toml", "--json"]).code(2);
    let refused: serde_json::Value = serde_json::from_str(&printed(&refused)).unwrap();
    assert_eq!(refused["valid"], false);
    let problems = refused["problems"].as_array().unwrap();
    let colour = problems.iter().find(|problem| problem["key"] == "body.ball.colour").unwrap();
    assert_eq!((&colour["line"], &colour["column"]), (&3.into(), &3.into()), "{colour}");
}

#[test]
fn the_doctor_finds_this_machine_well() {
    let dir = TempDir::new().unwrap();
    let said = printed(&archard(&dir, &["doctor"]).success());
    for part in ["threads", "vectors", "memory", "cache", "Hertz", "Carter", "passed in"] {
        assert!(said.contains(part), "{part} is not in\n{said}");
    }
}

#[test]
fn completions_and_manuals_name_every_command() {
    let dir = TempDir::new().unwrap();
    let bash = printed(&archard(&dir, &["completions", "bash"]).success());
    archard(&dir, &["man", "man"]).success();
    let page = fs::read_to_string(dir.path().join("man/archard.1")).unwrap();
    for command in ["run", "check", "new", "laws", "plot", "sweep", "doctor"] {
        assert!(bash.contains(command), "{bash}");
        assert!(page.contains(&format!("archard\\-{command}")), "{page}");
        assert!(dir.path().join(format!("man/archard-{command}.1")).is_file());
    }
}

#[test]
fn a_solve_that_does_not_converge_exits_with_one_and_says_by_how_much() {
    let dir = TempDir::new().unwrap();
    let case = case("pin_on_disc");
    let option = "solver.conjugate_gradient.max_iterations=1";
    let arguments = ["run", case.to_str().unwrap(), "-o", "out", "--set", option];
    let failed = archard(&dir, &arguments).code(1);
    let said = said(&failed);
    for part in ["at distance 0.0 m did not converge", "residual", "1 iterations", "1.0e-8"] {
        assert!(said.contains(part), "{part} is not in\n{said}");
    }
    assert!(said.contains("what was computed so far is in out"), "{said}");
    let summary = fs::read_to_string(dir.path().join("out/summary.json")).unwrap();
    assert!(summary.contains("\"complete\": false"), "{summary}");
    assert!(summary.contains("did not converge"), "{summary}");
}

#[test]
fn a_scar_that_outgrows_the_frame_exits_with_two_and_keeps_what_was_computed() {
    let dir = TempDir::new().unwrap();
    let case = case("pin_on_disc");
    let size = "frame.size=[\"0.4 mm\", \"0.4 mm\"]";
    let arguments = ["run", case.to_str().unwrap(), "-o", "out", "--set", size];
    let failed = archard(&dir, &arguments).code(2);
    let said = said(&failed);
    assert!(said.contains("will reach the edge of the frame along x and y"), "{said}");
    assert!(said.contains("every element of the frame is in contact"), "{said}");
    assert!(said.contains("enlarge `frame.size`"), "{said}");
    let history = fs::read_to_string(dir.path().join("out/history.csv")).unwrap();
    assert!(history.lines().count() > 2, "{history}");
    assert!(!history.contains("\n0.5,"), "{history}");
}

#[test]
fn explicit_steps_beyond_their_bound_run_with_a_warning() {
    let dir = TempDir::new().unwrap();
    let case = case("pin_on_disc");
    let explicit = ["--set", "motion.sliding.scheme=explicit", "--set", "output.every=1 m"];
    let arguments = [&["run", case.to_str().unwrap(), "-o", "out"][..], &explicit].concat();
    let said = said(&archard(&dir, &arguments).success());
    assert!(said.contains("the explicit scheme is unstable with this step"), "{said}");
    assert!(said.contains("3.03 mm"), "{said}");
}

#[test]
fn an_unknown_flag_exits_with_two() {
    let dir = TempDir::new().unwrap();
    archard(&dir, &["run", "case.toml", "--fast"]).code(2);
}

/// A reader that has seen enough, `archard check ... | head -1`, and a full disc.
#[cfg(target_os = "linux")]
#[test]
fn standard_output_may_be_closed_or_full() {
    let shell = |line: &str| {
        let program = assert_cmd::cargo::cargo_bin("archard");
        let case = case("hertz");
        let line =
            line.replace("CHECK", &format!("'{}' check '{}'", program.display(), case.display()));
        Command::new("bash").args(["-o", "pipefail", "-c", &line]).assert()
    };
    shell("CHECK | head -n 1").code(0);
    let full = shell("CHECK > /dev/full").code(2);
    assert!(said(&full).contains("cannot write to standard output"), "{}", said(&full));
}

#[test]
fn threads_are_few_and_many_are_refused() {
    let dir = TempDir::new().unwrap();
    let hertz = case("hertz");
    let hertz = hertz.to_str().unwrap();
    let few = ["run", hertz, "-o", "few", "--quiet", "--set", "frame.elements=[41, 41]"];
    for (threads, known) in [(&[][..], 1), (&["--threads", "2"], 2)] {
        archard(&dir, &[&few, threads, &["--force"]].concat()).success();
        let summary = std::fs::read_to_string(dir.path().join("few/summary.json")).unwrap();
        assert!(summary.contains(&format!("\"threads\": {known}")), "{summary}");
    }
    archard(&dir, &["run", hertz, "-o", "out", "--threads", "1", "--quiet"]).success();
    let summary = fs::read_to_string(dir.path().join("out/summary.json")).unwrap();
    assert!(summary.contains("\"threads\": 1"), "{summary}");
    let refused = archard(&dir, &["run", hertz, "-o", "out", "--threads", "100000"]).code(2);
    assert!(said(&refused).contains("processors"), "{}", said(&refused));
}

#[test]
fn friction_that_does_not_converge_exits_with_one() {
    let dir = TempDir::new().unwrap();
    let case = case("twin_disc");
    let option = "friction_solver.newton.max_iterations=1";
    let arguments = ["run", case.to_str().unwrap(), "-o", "out", "--set", option];
    let said = said(&archard(&dir, &arguments).code(1));
    for part in ["friction at revolution 0.0 did not converge", "1 iterations", "`friction_solver`"]
    {
        assert!(said.contains(part), "{part} is not in\n{said}");
    }
    let summary = fs::read_to_string(dir.path().join("out/summary.json")).unwrap();
    assert!(summary.contains("\"complete\": false"), "{summary}");
}

/// What Carter, Vermeulen and Johnson and the incremental model expect of the twin discs, and their first
/// contact, which independently passes on 0.895 of 180 N, to 1 %.
#[test]
fn rolling_says_what_to_expect_and_what_came_out() {
    let dir = TempDir::new().unwrap();
    let case = case("twin_disc");
    let checked = printed(&archard(&dir, &["check", case.to_str().unwrap()]).success());
    for line in [
        "saturation        creepage 0.00802 (all slips, mu a/R)",
        "stick share       0.261 (strip theory)",
        "creep force       155 N along (Vermeulen-Johnson)",
        "wear depth        26.0 um at the end (incremental model)",
        "contact solves    about 58",
    ] {
        assert!(checked.contains(line), "{line} is not in\n{checked}");
    }
    let contact = ["motion.rolling.revolutions=0", "motion.rolling.tolerance=", "output="];
    let mut arguments = vec!["run", case.to_str().unwrap(), "-o", "out"];
    arguments.extend(contact.iter().flat_map(|option| ["--set", option]));
    let ran = archard(&dir, &arguments).success();
    assert!(said(&ran).contains("100 %  revolution 0"), "{}", said(&ran));
    let printed = printed(&ran);
    for line in ["creepage          0.005000 along\n", "worn section      0 mm^2 off `disc2`"] {
        assert!(printed.contains(line), "{line} is not in\n{printed}");
    }
    let force = printed.split("creep force").nth(1).unwrap().split_whitespace().next().unwrap();
    assert!((force.parse::<f64>().unwrap() / (0.895 * 180.0) - 1.0).abs() < 0.01, "{printed}");
    assert!(printed.contains("N along, on `disc1`"), "{printed}");
}

/// Two cycles of a sphere under 10.2 N between plus and minus half of what friction bears, on a coarse frame.
#[test]
fn fretting_leaves_its_loop_and_says_what_it_dissipated() {
    let dir = TempDir::new().unwrap();
    let case = case("cattaneo_mindlin");
    let options =
        ["frame.elements=[16, 16]", "motion.fretting.increments=8", "motion.fretting.cycles=2"];
    let mut arguments = vec!["run", case.to_str().unwrap(), "-o", "out"];
    arguments.extend(options.iter().flat_map(|option| ["--set", option]));
    let ran = archard(&dir, &arguments).success();
    assert!(said(&ran).contains("100 %  cycle 2,"), "{}", said(&ran));
    let printed = printed(&ran);
    for text in ["stick area        0.0", "nJ of it in the last cycle"] {
        assert!(printed.contains(text), "{text} is not in\n{printed}");
    }
    // The beginning of each cycle and its increments.
    let loops = fs::read_to_string(dir.path().join("out/fretting_loop.csv")).unwrap();
    assert_eq!(loops.lines().count(), 1 + 2 * (1 + 8), "{loops}");
    archard(&dir, &["plot", "out"]).success();
    assert!(dir.path().join("out/plots/fretting_loop.svg").is_file());
}

/// Frames of so few elements that nothing touches at first in some of the steps: an honest end, whichever.
#[test]
fn twin_discs_on_hardly_any_elements_do_not_panic() {
    for elements in ["[3, 3]", "[2, 5]"] {
        let dir = TempDir::new().unwrap();
        let case = case("twin_disc");
        let option = format!("frame.elements={elements}");
        let arguments = ["run", case.to_str().unwrap(), "-o", "out", "-q", "--set", &option];
        let ran = archard(&dir, &arguments);
        let code = ran.get_output().status.code();
        assert!(code.is_some_and(|code| code < 3), "{elements}: {code:?}: {}", said(&ran));
        assert!(!said(&ran).contains("panicked"), "{elements}: {}", said(&ran));
    }
}

#[test]
fn a_summary_that_is_none_is_refused() {
    let dir = TempDir::new().unwrap();
    let case = case("hertz");
    let arguments = ["run", case.to_str().unwrap(), "-o", "out", "-q"];
    archard(&dir, &[&arguments[..], &["--set", "frame.elements=[10, 10]"]].concat()).success();
    for text in ["[1]", "null", "3", "\"closed_form\"", "{"] {
        fs::write(dir.path().join("out/summary.json"), text).unwrap();
        let refused = archard(&dir, &["plot", "out"]).code(2);
        assert!(said(&refused).contains("out/summary.json"), "{text}: {}", said(&refused));
    }
    // Half a row of a run that was killed is left out.
    let history = dir.path().join("out/history.csv");
    let rows = fs::read_to_string(&history).unwrap() + "0.5,12";
    fs::write(&history, rows).unwrap();
    fs::remove_file(dir.path().join("out/summary.json")).unwrap();
    archard(&dir, &["plot", "out"]).success();
}

#[test]
fn worn_surfaces_are_written_for_paraview() {
    let dir = TempDir::new().unwrap();
    let case = case("pin_on_disc");
    archard(&dir, &["run", case.to_str().unwrap(), "-o", "out", "-q"]).success();
    let said = printed(&archard(&dir, &["paraview", "out"]).success());
    assert!(said.contains("11 outputs of pin and disc"), "{said}");
    let script = fs::read_to_string(dir.path().join("out/paraview/open.py")).unwrap();
    assert!(script.contains("[\"pin\", \"disc\"]") && script.contains("wear_um"), "{script}");
    for body in ["pin", "disc"] {
        let list = fs::read_to_string(dir.path().join(format!("out/paraview/{body}.pvd"))).unwrap();
        assert_eq!(list.matches("<DataSet").count(), 11, "{list}");
        assert!(dir.path().join(format!("out/paraview/{body}_0010.vtu")).is_file());
    }
    let refused = archard(&dir, &["paraview", "."]).code(2);
    assert!(crate::said(&refused).contains("fields.pvd"), "{}", crate::said(&refused));
}
