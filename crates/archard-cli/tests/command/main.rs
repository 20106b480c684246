//! The command as a user meets it: exit codes, what it says, what it leaves behind.

mod accuracy;
mod browser;
mod compare;
mod finite;
mod fit;
#[path = "../../../archard-case/tests/framed/mod.rs"]
mod framed;
mod hostile;
mod known;
mod life;
mod log;
mod memory;
mod own_data;
mod report;
mod running;
mod scans;
mod start;
mod surface;
mod sweep;
#[cfg(unix)]
mod tasks;
mod validate;
mod verdict;
mod watch;

use std::fs;
use std::path::Path;

use archard_case::output::{Image, Manifest};
use assert_cmd::Command;
use assert_cmd::assert::Assert;
use tempfile::TempDir;

use framed::folder as case;

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

/// A text with one space wherever there are several.
fn squeezed(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn a_wrong_case_exits_with_two_and_points_at_the_line() {
    let dir = TempDir::new().unwrap();
    let wrong = fs::read_to_string(case("pin_on_disc").join("case.toml")).unwrap();
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

/// The README shows lines that its first command prints.
#[test]
fn results_come_with_their_errors() {
    let dir = TempDir::new().unwrap();
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let case = root.join("cases/pin_on_disc/case.toml");
    let printed = printed(&archard(&dir, &["run", case.to_str().unwrap()]).success());
    let readme = fs::read_to_string(root.join("README.md")).unwrap();
    let shown = block(&readme, "text");
    assert!(shown.lines().all(|line| line.contains(" +- ")), "{shown}");
    assert_shown(shown, &printed);
}

/// The first page of the book shows a case and lines that its run prints.
#[test]
#[ignore = "long: in .ci/long"]
fn the_first_page_shows_what_its_case_gives() {
    let dir = TempDir::new().unwrap();
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book/src/index.md");
    let page = fs::read_to_string(page).unwrap();
    fs::create_dir(dir.path().join("pin")).unwrap();
    fs::write(dir.path().join("pin/case.toml"), block(&page, "toml")).unwrap();
    let printed = printed(&archard(&dir, &["run", "pin/case.toml"]).success());
    assert_shown(block(&page, "text"), &printed);
    archard(&dir, &["plot", "results/pin"]).success();
}

/// The first block of code of a kind on a page.
fn block<'a>(page: &'a str, kind: &str) -> &'a str {
    page.split("```").find_map(|block| block.strip_prefix(&format!("{kind}\n"))).unwrap()
}

fn assert_shown(shown: &str, printed: &str) {
    for line in shown.lines() {
        assert!(printed.contains(line), "{line} is not in\n{printed}");
    }
}

/// `check` says what a run with that accuracy would take, and points at what a frame was chosen for.
#[test]
fn check_takes_an_accuracy() {
    let dir = TempDir::new().unwrap();
    let of = |options: &[&str]| {
        let checked = archard(&dir, &[&["check", "hertz"], options].concat()).success();
        printed(&checked)
    };
    assert_eq!(of(&["--accuracy", "2%"]), of(&["--set", "accuracy=0.02"]));
    assert_ne!(of(&["--accuracy", "2%"]), of(&[]));
    let flat = ["check", "hertz", "--accuracy", "1%", "--set", "body.ball.profile={ flat = {} }"];
    let refused = archard(&dir, &flat).code(2);
    assert!(said(&refused).contains("--> --accuracy:1:10"), "{}", said(&refused));
    // The grid is the one that a run begins with, and the next is said with what it takes.
    for (case, accuracy) in [("hertz", "2%"), ("pin_on_disc", "1%"), ("carter", "1%")] {
        let of = |json: &[&str]| {
            let options = [&["check", case, "--accuracy", accuracy], json].concat();
            printed(&archard(&dir, &options).success())
        };
        let checked: serde_json::Value = serde_json::from_str(&of(&["--json"])).unwrap();
        let [begins, next] = ["begins", "elements"].map(|key| {
            let axis = |axis: usize| checked["refined"][key][axis].as_u64().unwrap();
            [axis(0), axis(1)]
        });
        let pairs = |[x, y]: [u64; 2]| x * y;
        assert_eq!(Some(pairs(begins)), checked["pairs"].as_u64());
        assert_eq!(next[0], 2 * begins[0]);
        let (said, [x, y]) = (of(&[]), begins);
        assert!(said.contains(&format!("begins with {x} x {y} elements")), "{said}");
    }
    let given = [
        "check",
        "hertz",
        "--set",
        "frame.size=['0.4 mm', '0.4 mm']",
        "--set",
        "frame.elements=[48, 48]",
    ];
    assert!(!printed(&archard(&dir, &given).success()).contains("begins with"));
    let refused = archard(&dir, &["fit", "hertz", "--data", "none", "--accuracy", "1"]).code(2);
    assert!(said(&refused).contains("--> --accuracy:1:10"), "{}", said(&refused));
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
fn an_unknown_flag_exits_with_two() {
    let dir = TempDir::new().unwrap();
    archard(&dir, &["run", "case.toml", "--fast"]).code(2);
}

/// A reader that has seen enough, `archard check ... | head -1`, and a full disc.
#[cfg(target_os = "linux")]
/// What Carter, Vermeulen and Johnson and the incremental model expect of the twin discs, and their first
/// contact, which independently passes on 0.895 of 180 N, to 1 %.
/// Two cycles of a sphere under 10.2 N between plus and minus half of what friction bears, on a coarse frame.
/// Frames of so few elements that nothing touches at first in some of the steps: an honest end, whichever.
#[test]
fn a_summary_that_is_none_is_refused() {
    let dir = TempDir::new().unwrap();
    let case = case("hertz");
    let arguments = ["run", case.to_str().unwrap(), "-o", "out", "-q"];
    archard(&dir, &[&arguments[..], &["--set", "frame.elements=[10, 10]"]].concat()).success();
    // Without sums, which would be refused first.
    fs::remove_file(dir.path().join("out/manifest.txt")).unwrap();
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

/// Files that stand next to those for ParaView stay, those it wrote are replaced, and no name from a file leads out of
/// its folder.
#[test]
fn paraview_writes_within_its_folder_and_replaces_its_own_files() {
    let dir = TempDir::new().unwrap();
    let case = case("hertz");
    let arguments = ["run", case.to_str().unwrap(), "-o", "out", "-q"];
    archard(&dir, &[&arguments[..], &["--set", "frame.elements=[10, 10]"]].concat()).success();
    let written = dir.path().join("out/paraview");
    archard(&dir, &["paraview", "out"]).success();
    let mine = written.join("view.pvsm");
    fs::write(&mine, "mine").unwrap();
    archard(&dir, &["paraview", "out"]).success();
    assert_eq!(fs::read_to_string(&mine).unwrap(), "mine");
    // One of them that the list does not name is somebody's.
    fs::remove_file(written.join("manifest.txt")).unwrap();
    let refused = archard(&dir, &["paraview", "out"]).code(2);
    assert!(said(&refused).contains("is in the way"), "{}", said(&refused));
    fs::remove_dir_all(&written).unwrap();
    fs::create_dir(dir.path().join("victim")).unwrap();
    let last = dir.path().join("out/fields/0000.vti");
    let mut image = Image::read(&last).unwrap();
    for field in &mut image.fields {
        field.name = field.name.replace("height_ball_m", "height_../../victim/x_m");
    }
    assert!(image.fields.iter().any(|field| field.name.contains("victim")));
    Manifest::read(&dir.path().join("out"))
        .unwrap()
        .claim("fields/0000.vti")
        .and_then(|place| image.write(&place))
        .unwrap();
    let refused = archard(&dir, &["paraview", "out"]).code(2);
    assert!(said(&refused).contains("no case can have a body"), "{}", said(&refused));
    assert_eq!(fs::read_dir(dir.path().join("victim")).unwrap().count(), 0);
}

/// Whatever is asked for as a file and is not one is refused by what it is.
#[cfg(unix)]
#[test]
fn what_is_no_file_is_refused_by_its_kind() {
    let dir = TempDir::new().unwrap();
    let pipe = dir.path().join("pipe");
    assert!(std::process::Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    let case = case("pin_on_disc");
    let case = case.to_str().unwrap();
    for (name, kind) in [(pipe.to_str().unwrap(), "a named pipe"), ("/dev/zero", "a device")] {
        let table = format!("body.pin.profile={{table={{file=\"{name}\"}}}}");
        let mesh = format!("body.pin.mesh={{file={{path=\"{name}\"}}}}");
        for arguments in [
            &["check", name][..],
            &["check", case, "--set", &table],
            &["check", case, "--set", &mesh],
            &["fit", case, "--data", name],
        ] {
            let refused = archard(&dir, arguments).code(2);
            let said = said(&refused);
            assert!(said.contains(kind) && said.contains(name), "{arguments:?}: {said}");
        }
    }
    let settings = ["frame.elements=[24, 24]", "motion.sliding.step=50 mm"];
    let set = settings.iter().flat_map(|one| ["--set", one]);
    archard(&dir, &["run", case, "-o", "out", "-q"].into_iter().chain(set).collect::<Vec<_>>())
        .success();
    let fields = fs::read_dir(dir.path().join("out/fields")).unwrap();
    let last = fields.map(|entry| entry.unwrap().file_name().into_string().unwrap()).max();
    let last = format!("fields/{}", last.unwrap());
    for name in ["history.csv", "profiles.csv", "summary.json", "fields.pvd", &last] {
        let path = dir.path().join("out").join(name);
        let kept = fs::read(&path).unwrap();
        fs::remove_file(&path).unwrap();
        assert!(std::process::Command::new("mkfifo").arg(&path).status().unwrap().success());
        let said = said(&archard(&dir, &["plot", "out"]).code(2));
        assert!(said.contains(name) && said.matches("a named pipe").count() == 1, "{said}");
        fs::remove_file(&path).unwrap();
        fs::write(&path, kept).unwrap();
    }
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
