//! What the command knows by name: laws, cases, rigs, its own commands.

use std::fs;

use archard::friction::FRICTION;
use archard::wear::WEAR_LAWS;
use assert_cmd::Command;
use tempfile::TempDir;

use super::{archard, printed, said};

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

/// A built-in case is run by its name where no file has it, with the files it reads.
#[test]
fn built_in_cases_are_known_by_name() {
    let dir = TempDir::new().unwrap();
    archard(&dir, &["run", "hertz", "-q"]).success();
    assert!(dir.path().join("results/hertz/history.csv").is_file());
    let kept = dir.path().join("kept");
    let run = |arguments: &[&str]| {
        let mut command = Command::cargo_bin("archard").unwrap();
        command.current_dir(dir.path()).env("ARCHARD_CACHE", &kept).args(arguments).assert()
    };
    let checked = printed(&run(&["check", "patch_test"]).success());
    assert!(checked.contains("unknowns"), "{checked}");
    assert!(kept.join("cases/patch_test/block.msh").is_file());
    // What the user has of that name comes first.
    fs::write(dir.path().join("hertz"), "title = 3").unwrap();
    assert!(said(&archard(&dir, &["check", "hertz"]).code(2)).contains("hertz:1"));
}

#[test]
fn what_was_mistyped_is_answered_with_the_nearest() {
    let dir = TempDir::new().unwrap();
    fs::create_dir_all(dir.path().join("mine")).unwrap();
    fs::write(dir.path().join("mine/monday.toml"), "").unwrap();
    for (arguments, near) in [
        (&["run", "pin_on_dics"][..], "did you mean `pin_on_disc`?"),
        (&["sweep", "hertzz", "--over", "a=1,2", "-o", "out"], "did you mean `hertz`?"),
        (&["check", "mine/mondya.toml"], "did you mean `mine/monday.toml`?"),
        (&["new", "twin_dics"], "did you mean `twin_disc`?"),
        (&["run", "xylophone"], "`archard new --list` shows the built-in cases"),
        (&["check", "hertz", "--set", "body.bal.density=1"], "did you mean `ball`?"),
        (&["rnu", "hertz"], "a similar subcommand exists: 'run'"),
        (&["chekc"], "a similar subcommand exists: 'check'"),
    ] {
        let refused = archard(&dir, arguments).code(2);
        assert!(said(&refused).contains(near), "{}", said(&refused));
    }
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
    for command in ["run", "check", "new", "laws", "materials", "watch", "plot", "sweep", "doctor"]
    {
        assert!(bash.contains(command), "{bash}");
        assert!(page.contains(&format!("archard\\-{command}")), "{page}");
        assert!(dir.path().join(format!("man/archard-{command}.1")).is_file());
    }
}
