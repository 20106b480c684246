//! What a user meets first: laws, materials, and the questions of a new case.

use std::fs;

use archard::wear::WEAR_LAWS;
use archard_case::materials::MATERIALS;
use assert_cmd::Command;
use tempfile::TempDir;

use super::{archard, printed, said, squeezed};

/// One law in full, by its name or its key; what shares a name is shown together.
#[test]
fn a_law_is_shown_with_its_bounds_an_example_and_its_source() {
    let dir = TempDir::new().unwrap();
    let shown = printed(&archard(&dir, &["laws", "energy"]).success());
    for part in [
        "wear.energy\n",
        "alpha max(W - W0, 0)",
        "alpha; zero or greater\n",
        "wear.energy = { coefficient = \"1e-5 mm^3/J\"",
        "Source: S. Fouvry",
    ] {
        assert!(shown.contains(part), "{part}: {shown}");
    }
    for law in WEAR_LAWS {
        archard(&dir, &["laws", &format!("wear.{}", law.name)]).success();
    }
    let both = printed(&archard(&dir, &["laws", "table"]).success());
    assert!(both.contains("wear.table = ") && both.contains("friction.table = "), "{both}");
    let unknown = archard(&dir, &["laws", "enrgy"]).code(2);
    assert!(said(&unknown).contains("did you mean `energy`?"), "{}", said(&unknown));
}

#[test]
fn materials_are_listed_and_shown() {
    let dir = TempDir::new().unwrap();
    let listed = printed(&archard(&dir, &["materials"]).success());
    for one in MATERIALS {
        assert!(listed.lines().any(|line| line.trim_start().starts_with(one.name)), "{listed}");
        let shown = printed(&archard(&dir, &["materials", one.name]).success());
        assert!(shown.contains(one.source) && shown.contains(one.state), "{shown}");
    }
    let shown = printed(&archard(&dir, &["materials", "aisi 52100"]).success());
    let squeezed = squeezed(&shown);
    for part in ["100Cr6: bearing steel", "Young's modulus 210 GPa", "hardness 7.316 GPa"] {
        assert!(squeezed.contains(part), "{part}: {shown}");
    }
    assert!(shown.contains("material = \"100Cr6\"\n"), "{shown}");
    let unknown = archard(&dir, &["materials", "alumnia"]).code(2);
    assert!(said(&unknown).contains("did you mean `alumina`?"), "{}", said(&unknown));
}

/// Answers come from standard input where it is asked to ask; a folder that is there is kept, before anything is asked.
#[test]
fn new_asks_and_writes_the_answers() {
    let dir = TempDir::new().unwrap();
    let asks = |arguments: &[&str], answers: &str| {
        let mut command = Command::cargo_bin("archard").unwrap();
        command.current_dir(dir.path()).args(arguments).write_stdin(answers).assert()
    };
    let ask = ["new", "ball_on_flat", "--ask", "-o", "mine"];
    let ended = asks(&ask, "100Cr6\n").code(2);
    assert!(said(&ended).contains("nothing is written"), "{}", said(&ended));
    assert!(!dir.path().join("mine").exists());
    let asked = asks(&ask, "100Cr6\n\n\n5 kN/\n30 N\n").success();
    let talk = printed(&asked);
    assert!(talk.contains("load [10.2 N]: ") && talk.contains("  error: "), "{talk}");
    let written = fs::read_to_string(dir.path().join("mine/case.toml")).unwrap();
    assert!(written.contains("material = \"100Cr6\"\n"), "{written}");
    assert!(written.contains("load = \"30 N\""), "{written}");
    archard(&dir, &["check", "mine"]).success();
    let kept = asks(&ask, "").code(2);
    assert!(said(&kept).contains("it is kept"), "{}", said(&kept));
    let by_number = asks(&["new", "--ask", "-o", "other"], "1\n\n\n\n\n").success();
    assert!(printed(&by_number).contains("Which rig?"));
    assert!(dir.path().join("other/case.toml").is_file());
    let no_rig = asks(&["new", "patch_test", "--ask"], "").code(2);
    assert!(said(&no_rig).contains("is no rig"), "{}", said(&no_rig));
}
