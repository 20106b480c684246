//! SIGINT, SIGTERM and SIGHUP, within steps and between them.

use std::fs;
use std::path::Path;
use std::process::{Output, Stdio};
use std::time::{Duration, Instant};

use super::{
    LONG_STEP, MANY_STEPS, Run, assert_no_parts, assert_whole, case, command, lines, program, said,
    summary, wait_until,
};

#[test]
fn every_signal_ends_a_run_with_its_results() {
    for name in ["INT", "TERM", "HUP"] {
        let dir = tempfile::tempdir().unwrap();
        let run = Run::start(&mut command(dir.path(), "pin_on_disc", &MANY_STEPS));
        wait_until("ten rows", || lines(dir.path()) > 10);
        run.signal(name);
        let ended = run.end();
        let said = said(&ended);
        assert_eq!(ended.status.code(), Some(3), "SIG{name}: {said}");
        assert!(
            said.contains("error: interrupted\n") && said.contains("archard run --resume out"),
            "{said}"
        );
        let summary = summary(dir.path());
        assert_eq!(
            (&summary["complete"], &summary["failure"]),
            (&false.into(), &"interrupted".into())
        );
        let rows = assert_whole(dir.path());
        assert_eq!(summary["steps"], rows - 1);
        assert_no_parts(dir.path());
        // How it began is still told where it goes on, and is interrupted again.
        let began = summary["command"].as_str().unwrap().to_owned();
        let mut resume = super::program();
        let again =
            Run::start(resume.current_dir(dir.path()).args(["run", "-q", "--resume", "out"]));
        wait_until("ten more rows", || lines(dir.path()) > rows + 10);
        again.signal(name);
        assert_eq!(again.end().status.code(), Some(3));
        let told = super::summary(dir.path())["command"].as_str().unwrap().to_owned();
        assert_eq!(told, format!("{began}; archard run -q --resume out"));
    }
}

/// The wait for the step to end is of two seconds.
#[test]
fn a_signal_ends_a_long_solve() {
    let dir = tempfile::tempdir().unwrap();
    let run = Run::start(&mut command(dir.path(), "pin_on_disc", &LONG_STEP));
    wait_until("results", || dir.path().join("out/profiles.csv").exists());
    std::thread::sleep(Duration::from_millis(300));
    run.signal("TERM");
    let asked = Instant::now();
    let ended = run.end();
    assert!(asked.elapsed() < Duration::from_secs(20), "{:?}", asked.elapsed());
    assert_eq!(ended.status.code(), Some(3), "{}", said(&ended));
    assert!(said(&ended).contains("the same command starts again"), "{}", said(&ended));
    assert_eq!(summary(dir.path())["failure"], "interrupted");
    assert_whole(dir.path());
}

#[test]
fn a_second_signal_ends_it_at_once() {
    let dir = tempfile::tempdir().unwrap();
    let run = Run::start(&mut command(dir.path(), "pin_on_disc", &LONG_STEP));
    wait_until("results", || dir.path().join("out/profiles.csv").exists());
    std::thread::sleep(Duration::from_millis(300));
    run.signal("INT");
    std::thread::sleep(Duration::from_millis(400));
    run.signal("INT");
    let ended = run.end();
    assert_eq!(ended.status.code(), Some(3), "{}", said(&ended));
    // The end after a wait would have written one.
    assert!(!dir.path().join("out/summary.json").exists());
}

/// The assembly of a body of 3,600 elements in contact: there is nothing to save, and nothing is left.
#[test]
fn a_signal_ends_an_assembly() {
    let dir = tempfile::tempdir().unwrap();
    let fine = [
        "body.block.mesh.box.contact.elements=[60, 60]",
        "body.block.elasticity=boundary_elements",
    ];
    let run = Run::start(&mut command(dir.path(), "punch_indentation_block", &fine));
    wait_until("the folder", || dir.path().join("out").exists());
    std::thread::sleep(Duration::from_millis(500));
    run.signal("TERM");
    let asked = Instant::now();
    let ended = run.end();
    assert!(asked.elapsed() < Duration::from_secs(20), "{:?}", asked.elapsed());
    assert_eq!(ended.status.code(), Some(3), "{}", said(&ended));
    assert!(said(&ended).contains("nothing was written or replaced"), "{}", said(&ended));
    assert!(!dir.path().join("out").exists());
}

/// A study leaves the row that was under way with all it needs to go on, and the others open.
#[test]
fn a_signal_ends_a_study() {
    for name in ["INT", "TERM"] {
        let dir = tempfile::tempdir().unwrap();
        let mut study = program();
        study.current_dir(dir.path()).arg("sweep").arg(case("pin_on_disc"));
        study.args(["--over", "motion.sliding.load=5 N:20 N:3", "-o", "out", "-j", "1"]);
        study.args(MANY_STEPS.iter().flat_map(|setting| ["--set", setting]));
        study.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let run = Run::start(&mut study);
        let row = dir.path().join("out/rows/0001");
        let steps =
            || fs::read_to_string(row.join("history.csv")).unwrap_or_default().lines().count();
        wait_until("ten rows", || steps() > 10);
        run.signal(name);
        let ended = run.end();
        let said = said(&ended);
        assert_eq!(ended.status.code(), Some(3), "SIG{name}: {said}");
        assert!(said.contains("the same command goes on with the others"), "{said}");
        assert!(row.join("checkpoint").is_file());
        let table = fs::read_to_string(dir.path().join("out/sweep.csv")).unwrap();
        let status: Vec<_> = table.lines().skip(1).map(|row| row.split(',').nth(2)).collect();
        assert_eq!(status, [Some("interrupted"), Some("open"), Some("open")], "{table}");
    }
}

/// A study of a case, interrupted once something is there; what is said and how long the end took.
fn interrupted(options: &[&str], what: &str, there: impl Fn(&Path) -> bool) -> (Output, Duration) {
    let dir = tempfile::tempdir().unwrap();
    let mut study = program();
    study.current_dir(dir.path()).arg("sweep").arg(case("pin_on_disc"));
    study.args(["-o", "out", "-j", "1"]).args(options);
    study.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let run = Run::start(&mut study);
    wait_until(what, || there(dir.path()));
    run.signal("TERM");
    let asked = Instant::now();
    let ended = run.end();
    (ended, asked.elapsed())
}

/// Rows that one run gives are written one after the other, and what is not written is left.
#[test]
fn a_signal_ends_the_writing_of_derived_rows() {
    let k = "body.pin.wear.archard.coefficient=lognormal(1e-13 1/Pa, 0.2)";
    let mut options = vec!["--sample", k, "--samples", "600"];
    for setting in ["frame.elements=[10, 10]", "motion.sliding.step=50 mm"] {
        options.extend(["--set", setting]);
    }
    let rows = |dir: &Path| fs::read_dir(dir.join("out/rows")).map_or(0, Iterator::count);
    let (ended, took) = interrupted(&options, "derived rows", |dir| rows(dir) > 20);
    let said = said(&ended);
    assert_eq!(ended.status.code(), Some(3), "{said}");
    assert!(took < Duration::from_secs(20), "{took:?}");
    let done = said.split("rows done: ").nth(1).and_then(|rest| rest.lines().next());
    let done: usize = done.and_then(|count| count.parse().ok()).unwrap_or_else(|| panic!("{said}"));
    assert!((20..600).contains(&done), "{said}");
}

/// Where no step ends the study does, after a wait of two seconds.
#[test]
fn a_signal_ends_a_study_within_a_long_solve() {
    let mut options = vec!["--over", "motion.sliding.load=5 N:20 N:2"];
    options.extend(LONG_STEP.iter().flat_map(|setting| ["--set", setting]));
    let begun = |dir: &Path| dir.join("out/rows/0001/profiles.csv").exists();
    let (ended, took) = interrupted(&options, "results", begun);
    assert_eq!(ended.status.code(), Some(3), "{}", said(&ended));
    assert!(took < Duration::from_secs(20), "{took:?}");
    assert!(said(&ended).contains("the same command goes on"), "{}", said(&ended));
}
