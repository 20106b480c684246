//! SIGINT, SIGTERM and SIGHUP, within steps and between them.

use std::time::{Duration, Instant};

use super::{
    LONG_STEP, MANY_STEPS, assert_no_parts, assert_whole, command, lines, said, signal, summary,
    wait_until,
};

#[test]
fn every_signal_ends_a_run_with_its_results() {
    for name in ["INT", "TERM", "HUP"] {
        let dir = tempfile::tempdir().unwrap();
        let run = command(dir.path(), "pin_on_disc", &MANY_STEPS).spawn().unwrap();
        wait_until("ten rows", || lines(dir.path()) > 10);
        signal(&run, name);
        let ended = run.wait_with_output().unwrap();
        let said = said(&ended);
        assert_eq!(ended.status.code(), Some(3), "SIG{name}: {said}");
        assert!(said.contains("error: interrupted\n") && said.contains("to go on"), "{said}");
        let summary = summary(dir.path());
        assert_eq!(
            (&summary["complete"], &summary["failure"]),
            (&false.into(), &"interrupted".into())
        );
        assert_eq!(summary["steps"], assert_whole(dir.path()) - 1);
        assert_no_parts(dir.path());
    }
}

/// The wait for the step to end is of two seconds.
#[test]
fn a_signal_ends_a_long_solve() {
    let dir = tempfile::tempdir().unwrap();
    let run = command(dir.path(), "pin_on_disc", &LONG_STEP).spawn().unwrap();
    wait_until("results", || dir.path().join("out/profiles.csv").exists());
    std::thread::sleep(Duration::from_millis(300));
    signal(&run, "TERM");
    let asked = Instant::now();
    let ended = run.wait_with_output().unwrap();
    assert!(asked.elapsed() < Duration::from_secs(20), "{:?}", asked.elapsed());
    assert_eq!(ended.status.code(), Some(3), "{}", said(&ended));
    assert_eq!(summary(dir.path())["failure"], "interrupted");
    assert_whole(dir.path());
}

#[test]
fn a_second_signal_ends_it_at_once() {
    let dir = tempfile::tempdir().unwrap();
    let run = command(dir.path(), "pin_on_disc", &LONG_STEP).spawn().unwrap();
    wait_until("results", || dir.path().join("out/profiles.csv").exists());
    std::thread::sleep(Duration::from_millis(300));
    signal(&run, "INT");
    std::thread::sleep(Duration::from_millis(400));
    signal(&run, "INT");
    let asked = Instant::now();
    let ended = run.wait_with_output().unwrap();
    assert_eq!(ended.status.code(), Some(3), "{}", said(&ended));
    assert!(asked.elapsed() < Duration::from_millis(1500), "{:?}", asked.elapsed());
}

/// The assembly of a body of 3,600 elements in contact: there is nothing to save, and nothing is left.
#[test]
fn a_signal_ends_an_assembly() {
    let dir = tempfile::tempdir().unwrap();
    let fine = ["body.block.mesh.box.contact.elements=[60, 60]"];
    let run = command(dir.path(), "punch_indentation_block", &fine).spawn().unwrap();
    wait_until("the folder", || dir.path().join("out").exists());
    std::thread::sleep(Duration::from_millis(500));
    signal(&run, "TERM");
    let asked = Instant::now();
    let ended = run.wait_with_output().unwrap();
    assert!(asked.elapsed() < Duration::from_secs(20), "{:?}", asked.elapsed());
    assert_eq!(ended.status.code(), Some(3), "{}", said(&ended));
    assert!(said(&ended).contains("nothing was written or replaced"), "{}", said(&ended));
    assert!(!dir.path().join("out").exists());
}
