//! Rows of a study: each the run by itself, shared by tasks, gone on with after an end, and their folders.

use std::fs;
use std::process::{Command, Stdio};
use std::time::Duration;

use archard_case::output::Claim;
use tempfile::TempDir;

use super::{SMALL, number, rows, study, written};
use crate::{archard, case, said};

#[test]
fn every_row_is_the_run_by_itself() {
    let dir = TempDir::new().unwrap();
    let pin = case("pin_on_disc");
    let over = [
        "--over",
        "motion.sliding.load=5 N:20 N:2",
        "--over",
        "body.pin.profile.sphere.radius=25 mm,50 mm",
    ];
    archard(&dir, &study(pin.to_str().unwrap(), &over)).success();
    let design = fs::read_to_string(dir.path().join("study/design.csv")).unwrap();
    let head = "row,motion.sliding.load_N,body.pin.profile.sphere.radius_m\n";
    assert_eq!(design, format!("{head}1,5.0,0.025\n2,5.0,0.05\n3,20.0,0.025\n4,20.0,0.05\n"));
    let rows = rows(&dir, "study/sweep.csv");
    assert_eq!(rows.len(), 4);
    for (index, row) in rows.iter().enumerate() {
        let load = format!("motion.sliding.load={} N", row["motion.sliding.load_N"]);
        let radius =
            format!("body.pin.profile.sphere.radius={} m", row["body.pin.profile.sphere.radius_m"]);
        let alone = [
            "run",
            pin.to_str().unwrap(),
            "-q",
            "-o",
            "alone",
            "--force",
            "--set",
            &load,
            "--set",
            &radius,
        ];
        archard(&dir, &[&alone[..], &SMALL].concat()).success();
        let history =
            |folder: &str| fs::read_to_string(dir.path().join(folder).join("history.csv")).unwrap();
        assert_eq!(history("alone"), history(&format!("study/rows/{:04}", index + 1)));
        let last = self::rows(&dir, "alone/history.csv").pop().unwrap();
        for (column, value) in &last {
            let told = row[column].parse::<f64>().ok();
            assert_eq!(told, value.parse().ok(), "{column}");
        }
        assert_eq!(row["status"], "done");
    }
    // Nothing is run again, with other jobs too.
    let before = written(dir.path());
    archard(&dir, &study(pin.to_str().unwrap(), &[&over[..], &["-j", "1"]].concat())).success();
    assert_eq!(written(dir.path()), before);
    // A row that is lost is run again, alone.
    fs::remove_dir_all(dir.path().join("study/rows/0003")).unwrap();
    archard(&dir, &study(pin.to_str().unwrap(), &over)).success();
    let after = written(dir.path());
    assert_eq!(after.len(), 4);
    assert!([0, 1, 3].iter().all(|&row| after[row] == before[row]) && after[2].1 > before[2].1);
    archard(&dir, &["plot", "study"]).success();
    assert!(dir.path().join("study/plots/main_effects.svg").is_file());
}

#[test]
fn tasks_share_the_rows() {
    let dir = TempDir::new().unwrap();
    let pin = case("pin_on_disc");
    let over = ["--over", "motion.sliding.load=5 N:20 N:7"];
    let tasks: Vec<_> = (0..3)
        .map(|task| {
            Command::new(assert_cmd::cargo::cargo_bin("archard"))
                .current_dir(dir.path())
                .args(study(pin.to_str().unwrap(), &over))
                .args(["--task", &format!("{task}/3"), "-j", "1"])
                .stderr(Stdio::null())
                .spawn()
                .unwrap()
        })
        .collect();
    for mut task in tasks {
        assert!(task.wait().unwrap().success());
    }
    let rows = rows(&dir, "study/sweep.csv");
    assert_eq!(rows.len(), 7);
    assert!(rows.iter().all(|row| row["status"] == "done"), "{rows:?}");
    // What one task runs by itself are its own rows.
    let alone = TempDir::new().unwrap();
    let task = [&over[..], &["--task", "3/3"]].concat();
    archard(&alone, &study(pin.to_str().unwrap(), &task)).success();
    let run: Vec<usize> = written(alone.path()).into_iter().map(|(row, _)| row).collect();
    assert_eq!(run, [1, 4, 7]);
}

/// A row that another process runs is left to it.
#[test]
fn a_row_is_run_by_whoever_holds_its_folder() {
    let dir = TempDir::new().unwrap();
    let pin = case("pin_on_disc");
    let over = ["--over", "motion.sliding.load=5 N,6 N"];
    let held = Claim::take(&dir.path().join("study/rows/0001")).unwrap();
    let left = archard(&dir, &study(pin.to_str().unwrap(), &over)).code(2);
    assert!(said(&left).contains("rows that another process runs: 1"), "{}", said(&left));
    let status = || -> Vec<String> {
        rows(&dir, "study/sweep.csv").iter().map(|row| row["status"].clone()).collect()
    };
    assert_eq!(status(), ["open", "done"]);
    drop(held);
    archard(&dir, &study(pin.to_str().unwrap(), &over)).success();
    assert_eq!(status(), ["done", "done"]);
}

/// A study that is killed goes on, to the same bits.
#[test]
fn a_killed_study_goes_on() {
    let pin = case("pin_on_disc");
    let over = [
        "--over",
        "motion.sliding.load=5 N:20 N:6",
        "--set",
        "motion.sliding.step=2 mm",
        "--set",
        "frame.elements=[40, 40]",
    ];
    let [killed, whole] = [TempDir::new().unwrap(), TempDir::new().unwrap()];
    archard(&whole, &study(pin.to_str().unwrap(), &over)).success();
    for jobs in ["1", "2", "1"] {
        let mut child = Command::new(assert_cmd::cargo::cargo_bin("archard"))
            .current_dir(killed.path())
            .args(study(pin.to_str().unwrap(), &over))
            .args(["-j", jobs])
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        std::thread::sleep(Duration::from_millis(400));
        let _ = child.kill();
        child.wait().unwrap();
    }
    archard(&killed, &study(pin.to_str().unwrap(), &over)).success();
    let table = |dir: &TempDir| fs::read_to_string(dir.path().join("study/sweep.csv")).unwrap();
    assert_eq!(table(&killed), table(&whole));
    let histories = |dir: &TempDir| -> Vec<String> {
        (1..=6)
            .map(|row| {
                fs::read_to_string(dir.path().join(format!("study/rows/{row:04}/history.csv")))
                    .unwrap()
            })
            .collect()
    };
    assert_eq!(histories(&killed), histories(&whole));
}

/// A row that does not converge is told with its error; the others are done.
#[test]
fn failed_rows_are_recorded() {
    let dir = TempDir::new().unwrap();
    let pin = case("pin_on_disc");
    let over = ["--over", "solver.conjugate_gradient.max_iterations=1,1000"];
    let failed = archard(&dir, &study(pin.to_str().unwrap(), &over)).code(1);
    assert!(said(&failed).contains("rows that failed or are wrong: 1"), "{}", said(&failed));
    let rows = rows(&dir, "study/sweep.csv");
    assert_eq!([&*rows[0]["status"], &*rows[1]["status"]], ["failed", "done"]);
    assert!(rows[0]["error"].contains("did not converge"), "{rows:?}");
    assert_eq!(rows[0]["wear_depth_m"], "");
    assert!(number(&rows[1], "wear_depth_m") > 0.0);
}

#[test]
fn a_folder_of_another_study_is_left_alone() {
    let dir = TempDir::new().unwrap();
    let pin = case("pin_on_disc");
    let of = |over: &'static str| {
        study(pin.to_str().unwrap(), &["--over", over])
            .iter()
            .map(|s| (*s).to_owned())
            .collect::<Vec<_>>()
    };
    let run = |arguments: Vec<String>| {
        archard(&dir, &arguments.iter().map(String::as_str).collect::<Vec<_>>())
    };
    run(of("motion.sliding.load=5 N,6 N")).success();
    let before = written(dir.path());
    let refused = run(of("motion.sliding.load=5 N,7 N")).code(2);
    assert!(said(&refused).contains("is of another study, from line 3 on"), "{}", said(&refused));
    let mut other = of("motion.sliding.load=5 N,6 N");
    other.extend(["--set".to_owned(), "motion.sliding.distance=400 mm".to_owned()]);
    let refused = run(other).code(2);
    assert!(said(&refused).contains("0001` holds another case"), "{}", said(&refused));
    assert_eq!(written(dir.path()), before);
}

/// Rows that are killed between the end of their run and that of their folder: the study is called again, and their folders are
/// as if nobody had killed them.
#[test]
fn rows_that_are_killed_as_they_end_are_tidied() {
    let dir = TempDir::new().unwrap();
    let pin = case("pin_on_disc");
    let over = ["--over", "motion.sliding.load=5 N,20 N"];
    let arguments = study(pin.to_str().unwrap(), &over);
    archard(&dir, &arguments).success();
    let row = dir.path().join("study/rows/0001");
    let names = || {
        let mut all: Vec<_> =
            fs::read_dir(&row).unwrap().map(|entry| entry.unwrap().file_name()).collect();
        all.sort();
        all
    };
    let manifest = row.join("manifest.txt");
    let (before, list, times) =
        (names(), fs::read_to_string(&manifest).unwrap(), written(dir.path()));
    // Before the checkpoint goes, and before the list is in order.
    for more in ["wrote checkpoint\n", "wrote checkpoint\nremoved checkpoint\n"] {
        fs::write(&manifest, format!("{list}{more}")).unwrap();
        if !more.contains("removed") {
            fs::write(row.join("checkpoint"), "a run").unwrap();
            fs::write(row.join("summary.json.999999.0.part"), "half").unwrap();
        }
        archard(&dir, &arguments).success();
        assert_eq!(names(), before, "{more}");
        assert_eq!(fs::read_to_string(&manifest).unwrap(), list, "{more}");
    }
    assert_eq!(written(dir.path()), times, "no row is run again");
}
