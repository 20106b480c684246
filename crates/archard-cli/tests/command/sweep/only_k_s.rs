//! Rows that differ in the wear coefficient alone: one run answers all.

use std::collections::HashMap;
use std::fs;

use tempfile::TempDir;

use super::{K, SMALL, number, rows, study, written};
use crate::{archard, case, printed, said};

/// Rows that differ in k alone: the smallest is its own run to 1e-9, the others to the error of their own, longer steps.
#[test]
fn only_k_s_counts() {
    let dir = TempDir::new().unwrap();
    let pin = case("pin_on_disc");
    let sample = format!("{K}=lognormal(1e-13 1/Pa, 0.4)");
    let sampled = ["--sample", &sample, "--samples", "8", "--set", "motion.sliding.step=5 mm"];
    let shared = [&["sweep", pin.to_str().unwrap(), "-o", "study"], &SMALL[..], &sampled].concat();
    let ran = archard(&dir, &shared).success();
    assert!(said(&ran).contains("7 of 8 rows"), "{}", said(&ran));
    assert!(printed(&ran).contains("8 done, 0 wrong, 0 failed, 0 open"), "{}", printed(&ran));
    let separate = [
        &["sweep", pin.to_str().unwrap(), "-o", "separate", "--separate", "-q"],
        &SMALL[..],
        &sampled,
    ]
    .concat();
    archard(&dir, &separate).success();
    let [one, all] = ["study/sweep.csv", "separate/sweep.csv"].map(|name| rows(&dir, name));
    let k = |row: &HashMap<String, String>| number(row, &format!("{K}_per_Pa"));
    let least = (0..8).min_by(|&i, &j| k(&one[i]).total_cmp(&k(&one[j]))).unwrap();
    for (index, (one, other)) in one.iter().zip(&all).enumerate() {
        assert_eq!(k(one), k(other));
        // What is told of a row is judged as its own run is, warnings included.
        assert_eq!([&one["verdict"], &one["reason"]], [&other["verdict"], &other["reason"]]);
        let lines = |study: &str| {
            let path = format!("{study}/rows/{:04}/summary.json", index + 1);
            let summary = fs::read_to_string(dir.path().join(path)).unwrap();
            let summary: serde_json::Value = serde_json::from_str(&summary).unwrap();
            let lines = summary["verdict"]["lines"].as_array().unwrap().iter();
            let lines = lines.filter(|line| line["word"] != "good");
            lines.map(|line| (line["subject"].clone(), line["word"].clone())).collect::<Vec<_>>()
        };
        assert_eq!(lines("study"), lines("separate"), "row {index}");
        for column in [
            "distance_m",
            "load_N",
            "approach_m",
            "wear_depth_pin_m",
            "worn_volume_pin_m3",
            "centre_pressure_Pa",
        ] {
            let (one, other) = (number(one, column), number(other, column));
            let within = if index == least || column.starts_with("worn") { 1e-9 } else { 1e-3 };
            assert!(
                (one / other - 1.0).abs() < within,
                "row {index}, {column}: {one:e} and {other:e}"
            );
        }
        // k F s.
        let volume = k(one) * 10.2 * 0.5;
        assert!((number(one, "worn_volume_pin_m3") / volume - 1.0).abs() < 1e-6);
    }
    // A row has its own history, which ends where it does.
    let folder = format!("study/rows/{:04}/history.csv", least + 1);
    assert!((number(rows(&dir, &folder).last().unwrap(), "distance_m") - 0.5).abs() < 1e-12);
    // What is done stays done.
    let before = written(dir.path());
    archard(&dir, &shared).success();
    assert_eq!(written(dir.path()), before);
    archard(&dir, &["plot", "study"]).success();
    for picture in ["bands.svg", "bands.png", "main_effects.svg"] {
        assert!(dir.path().join("study/plots").join(picture).is_file(), "{picture}");
    }
}

/// Under Archard's law a part lasts as 1 / k, and a row whose limit lies beyond the motion has no end of its life.
#[test]
fn lives_go_as_one_over_k() {
    let dir = TempDir::new().unwrap();
    let pin = case("pin_on_disc");
    let k = format!("{K}=1e-13 1/Pa, 2e-13 1/Pa, 1e-15 1/Pa");
    let limit = ["--set", "until={ worn_volume_pin = \"4e-4 mm^3\" }", "--over", &k];
    let arguments = [&["sweep", pin.to_str().unwrap(), "-o", "study"], &SMALL[..], &limit].concat();
    let ran = archard(&dir, &arguments).success();
    let rows = rows(&dir, "study/sweep.csv");
    let life = |row: usize| number(&rows[row], "life_distance_m");
    // k F s, with 10.2 N.
    for (row, k) in [(0, 1e-13), (1, 2e-13)] {
        let expected = 4e-13 / (k * 10.2);
        assert!((life(row) / expected - 1.0).abs() < 1e-6, "{} {expected}", life(row));
        assert!(number(&rows[row], "distance_m") >= expected);
    }
    assert_eq!(life(2), f64::INFINITY);
    assert!(printed(&ran).contains("to beyond the motion"), "{}", printed(&ran));
}

/// Twice as many derived rows take twice the disk.
#[test]
fn derived_rows_take_disk_in_proportion() {
    let dir = TempDir::new().unwrap();
    let pin = case("pin_on_disc");
    let sample = format!("{K}=lognormal(1e-13 1/Pa, 0.2)");
    let size = |samples: &str| {
        let more = ["--sample", &sample, "--samples", samples];
        archard(&dir, &study(pin.to_str().unwrap(), &more)).success();
        let histories = (1..=samples.parse().unwrap()).map(|row: u64| {
            let path = dir.path().join(format!("study/rows/{row:04}/history.csv"));
            fs::metadata(path).unwrap().len()
        });
        let mut histories: Vec<u64> = histories.collect();
        // All but the run itself.
        histories.sort_unstable();
        let derived: u64 = histories[..histories.len() - 1].iter().sum();
        fs::remove_dir_all(dir.path().join("study")).unwrap();
        derived as f64
    };
    let [few, many] = ["20", "80"].map(size);
    assert!(many < 1.3 * 4.0 * few, "{few} and {many} bytes");
}

#[test]
fn a_law_that_is_not_linear_in_k_runs_row_by_row() {
    let dir = TempDir::new().unwrap();
    let pin = case("pin_on_disc");
    let law =
        "body.pin.wear={ threshold = { coefficient = \"1e-13 1/Pa\", threshold = \"1 MPa\" } }";
    let over = ["--over", "body.pin.wear.threshold.coefficient=1e-13 1/Pa,2e-13 1/Pa"];
    let arguments =
        [&["sweep", pin.to_str().unwrap(), "-o", "study", "--set", law], &SMALL[..], &over]
            .concat();
    let ran = archard(&dir, &arguments).success();
    assert!(!said(&ran).contains("Only k s counts"), "{}", said(&ran));
}
