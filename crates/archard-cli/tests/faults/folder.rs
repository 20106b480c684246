//! Folders that are in use, hold something else, are removed or have no room.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use super::{
    MANY_STEPS, Run, assert_no_parts, assert_whole, command, lines, said, summary, wait_until,
};

const SMALL: [&str; 2] = ["frame.elements=[12, 12]", "motion.sliding.step=5 mm"];

/// All files of a folder and its folder of fields, with their content.
fn content(out: &Path) -> Vec<(String, Vec<u8>)> {
    let mut files = vec![];
    for folder in [out.to_owned(), out.join("fields")] {
        for entry in fs::read_dir(folder).unwrap().flatten().filter(|entry| entry.path().is_file())
        {
            let name = entry.path().display().to_string();
            files.push((name, fs::read(entry.path()).unwrap()));
        }
    }
    files.retain(|(name, _)| !name.ends_with(".lock"));
    files.sort();
    files
}

#[test]
fn one_of_two_runs_into_a_folder_is_refused() {
    let dir = tempfile::tempdir().unwrap();
    let first = Run::start(&mut command(dir.path(), "pin_on_disc", &MANY_STEPS));
    wait_until("rows", || lines(dir.path()) > 3);
    let second = command(dir.path(), "pin_on_disc", &MANY_STEPS).output().unwrap();
    assert_eq!(second.status.code(), Some(2));
    let holder = format!("another run (process {}) writes into `out`", first.id());
    assert!(said(&second).contains(&holder), "{}", said(&second));
    // Who only reads may.
    let plot = |dir: &Path| {
        Command::new(assert_cmd::cargo::cargo_bin("archard"))
            .args(["plot", "out"])
            .current_dir(dir)
            .output()
            .unwrap()
    };
    let plotted = plot(dir.path());
    assert!(plotted.status.success(), "{}", said(&plotted));
    first.signal("KILL");
    first.end();
    assert_whole(dir.path());
    // The lock ends with the process that held it. Rows of the first would not tell that the third has begun.
    fs::remove_file(dir.path().join("out/history.csv")).unwrap();
    let third = Run::start(&mut command(dir.path(), "pin_on_disc", &MANY_STEPS));
    wait_until("rows of the third run", || lines(dir.path()) > 3);
    third.signal("TERM");
    assert_eq!(third.end().status.code(), Some(3));
}

#[test]
fn results_of_another_case_are_kept() {
    let dir = tempfile::tempdir().unwrap();
    let run = |settings: &[&str], more: &[&str]| -> Output {
        command(dir.path(), "pin_on_disc", settings).args(more).output().unwrap()
    };
    assert!(run(&SMALL, &[]).status.success());
    let before = content(&dir.path().join("out"));
    let other = ["frame.elements=[14, 14]", "motion.sliding.step=5 mm"];
    let refused = run(&other, &[]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(said(&refused).contains("--force"), "{}", said(&refused));
    assert_eq!(content(&dir.path().join("out")), before);
    assert!(run(&SMALL, &[]).status.success());
    assert!(run(&other, &["--force"]).status.success());
    assert_ne!(content(&dir.path().join("out")), before);
}

/// A run that does not go on leaves every byte: of an edited case, from a checkpoint of another run, or from none.
#[test]
fn a_resume_that_is_refused_changes_nothing() {
    let dir = tempfile::tempdir().unwrap();
    let start = |step: &str| {
        let settings = [MANY_STEPS[0], step, "output.every=\"20 um\""];
        Run::start(&mut command(dir.path(), "pin_on_disc", &settings))
    };
    let out = dir.path().join("out");
    let [case, checkpoint] = ["case.toml", "checkpoint"].map(|name| out.join(name));
    let stop = |run: Run| {
        wait_until("rows", || lines(dir.path()) > 8);
        run.signal("TERM");
        assert_eq!(run.end().status.code(), Some(3));
    };
    stop(start("motion.sliding.step=0.001 mm"));
    let other = fs::read(&checkpoint).unwrap();
    fs::remove_dir_all(&out).unwrap();
    stop(start("motion.sliding.step=0.002 mm"));
    let (text, kept) = (fs::read_to_string(&case).unwrap(), fs::read(&checkpoint).unwrap());
    let edited = text.replacen("coefficient = \"", "coefficient = \"2", 1);
    assert_ne!(edited, text);
    let pipe = || {
        fs::remove_file(&checkpoint).unwrap();
        assert!(Command::new("mkfifo").arg(&checkpoint).status().unwrap().success());
    };
    let forged = [&kept[..kept.len() / 2], &kept[kept.len() / 2 + 1..]].concat();
    let trials: [(&str, &dyn Fn()); 4] = [
        ("another case", &|| fs::write(&case, &edited).unwrap()),
        ("another case", &|| fs::write(&checkpoint, &other).unwrap()),
        ("damaged", &|| fs::write(&checkpoint, &forged).unwrap()),
        ("a named pipe", &pipe),
    ];
    for (why, spoil) in trials {
        fs::write(&case, &text).unwrap();
        fs::write(&checkpoint, &kept).unwrap();
        spoil();
        let before = content(&out);
        let mut resume = super::program();
        resume.current_dir(dir.path()).args(["run", "-q", "--resume", "out"]);
        let refused = resume.output().unwrap();
        assert_eq!(refused.status.code(), Some(2), "{}", said(&refused));
        assert!(said(&refused).contains(why), "{}", said(&refused));
        assert_eq!(content(&out), before, "{why}");
    }
}

/// Files of the user's with names that a run gives are named before anything is computed, and stay.
#[test]
fn files_of_the_user_are_in_the_way() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("out");
    fs::create_dir_all(out.join("fields")).unwrap();
    for name in ["profiles.csv", "fields/2024.vti"] {
        fs::write(out.join(name), "mine").unwrap();
        for more in [&[][..], &["--force"]] {
            let ran = command(dir.path(), "pin_on_disc", &SMALL).args(more).output().unwrap();
            assert_eq!(ran.status.code(), Some(2));
            let message = format!("`out/{name}` is in the way");
            assert!(said(&ran).contains(&message), "{}", said(&ran));
        }
        assert_eq!(content(&out).len(), 1, "nothing is added");
        fs::remove_file(out.join(name)).unwrap();
    }
    let ran = command(dir.path(), "pin_on_disc", &SMALL).output().unwrap();
    assert!(ran.status.success(), "{}", said(&ran));
}

/// While the equations of another mesh are made, the results in the folder stay as they are.
#[test]
fn a_run_that_does_not_come_to_its_first_step_costs_no_results() {
    let dir = tempfile::tempdir().unwrap();
    let small = ["body.block.mesh.box.contact.elements=[4, 4]", "motion.indentation.increments=2"];
    let ran = command(dir.path(), "punch_indentation_block", &small).output().unwrap();
    assert!(ran.status.success(), "{}", said(&ran));
    let before = content(&dir.path().join("out"));
    let fine = [
        "body.block.mesh.box.contact.elements=[60, 60]",
        "body.block.elasticity=boundary_elements",
    ];
    let mut run = command(dir.path(), "punch_indentation_block", &fine);
    let run = Run::start(run.arg("--force"));
    let holder = run.id().to_string();
    let lock = dir.path().join("out/.archard.lock");
    wait_until("the lock", || fs::read_to_string(&lock).is_ok_and(|text| text.trim() == holder));
    std::thread::sleep(std::time::Duration::from_millis(500));
    run.signal("TERM");
    let ended = run.end();
    assert_eq!(ended.status.code(), Some(3), "{}", said(&ended));
    assert_eq!(content(&dir.path().join("out")), before);
}

#[test]
fn settings_have_a_folder_of_their_own() {
    let dir = tempfile::tempdir().unwrap();
    let run = |settings: &[&str]| {
        let mut command = Command::new(assert_cmd::cargo::cargo_bin("archard"));
        command.arg("run").arg(super::case("hertz")).arg("-q").current_dir(dir.path());
        command.args(settings.iter().flat_map(|setting| ["--set", setting]));
        let ran = command.output().unwrap();
        assert!(ran.status.success(), "{}", said(&ran));
    };
    run(&[]);
    run(&["frame.elements=[10, 10]"]);
    run(&["frame.elements=[12, 12]"]);
    let results = dir.path().join("results");
    for name in ["hertz", "hertz--frame.elements=10x10", "hertz--frame.elements=12x12"] {
        assert!(results.join(name).join("history.csv").is_file(), "{name}");
    }
}

#[test]
fn a_folder_that_is_removed_is_missed() {
    let dir = tempfile::tempdir().unwrap();
    let run = Run::start(&mut command(dir.path(), "pin_on_disc", &MANY_STEPS));
    wait_until("rows", || lines(dir.path()) > 3);
    fs::rename(dir.path().join("out"), dir.path().join("away")).unwrap();
    let ended = run.end();
    assert_eq!(ended.status.code(), Some(2));
    let said = said(&ended);
    assert!(said.contains("`out/history.csv` was removed or moved"), "{said}");
    assert!(!said.contains("what was computed so far"), "{said}");
    assert!(!dir.path().join("out").exists());
}

/// `ulimit -f` counts blocks of 512 bytes, in bash of 1024.
#[cfg(target_os = "linux")]
#[test]
fn a_limit_of_file_sizes_is_an_error_and_rows_stay_whole() {
    for blocks in [1, 3, 8, 20, 60] {
        let dir = tempfile::tempdir().unwrap();
        let settings = ["frame.elements=[16, 16]", "motion.sliding.step=1 mm", "output.every=5 mm"];
        let run = command(dir.path(), "pin_on_disc", &settings);
        let words = run.get_args().map(|word| format!("'{}'", word.display()));
        let line = words.collect::<Vec<_>>().join(" ");
        let line = format!("ulimit -f {blocks}; exec '{}' {line}", run.get_program().display());
        let ran = Command::new("bash").args(["-c", &line]).current_dir(dir.path()).output();
        let ran = ran.unwrap();
        assert_eq!(ran.status.code(), Some(2), "{blocks}: {} {}", ran.status, said(&ran));
        let message = format!("files may have {} bytes here", 1024 * blocks);
        assert!(said(&ran).contains("cannot write `out/"), "{}", said(&ran));
        assert!(said(&ran).contains(&message), "{}", said(&ran));
        assert_whole(dir.path());
        assert_no_parts(dir.path());
        if dir.path().join("out/summary.json").exists() {
            assert_eq!(summary(dir.path())["complete"], false);
        }
    }
}
