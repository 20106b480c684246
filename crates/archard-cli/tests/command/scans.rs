//! `archard compare --before A --after B`.

use std::f64::consts::PI;
use std::fs;

use serde_json::Value;
use tempfile::TempDir;

use super::{archard, text};

const POINTS: usize = 64;
/// Half widths (um) and depth (um) of the scar.
const SCAR: [f64; 3] = [30.0, 36.0, 1.0];

/// A matrix of heights (um) 2 um apart: waves of unlike lengths, noise of 10 nm, and a scar.
fn scan(seed: u64, ground: f64, scar: bool) -> String {
    let mut random = fastrand::Rng::with_seed(seed);
    let row = |y: usize| {
        let height = |x: usize| {
            let [x, y] = [x, y].map(|index| 2.0 * (index as f64 - 31.5));
            let waves: f64 = (1..12)
                .map(f64::from)
                .map(|k| (ground * k * x * 0.05 + (7.0 * k).sin() * 0.3 * y + k * k).sin())
                .sum();
            let far = (x / SCAR[0]).powi(2) + (y / SCAR[1]).powi(2);
            let noise = (0..12).map(|_| random.f64()).sum::<f64>() - 6.0;
            let worn = if scar { SCAR[2] * (1.0 - far).max(0.0) } else { 0.0 };
            format!("{:.5}", 0.1 * waves + 0.01 * noise - worn)
        };
        (0..POINTS).map(height).collect::<Vec<_>>().join(" ")
    };
    (0..POINTS).map(row).collect::<Vec<_>>().join("\n")
}

#[test]
#[ignore = "long: in .ci/long"]
fn what_is_worn_between_two_scans_is_said_and_written() {
    let dir = TempDir::new().unwrap();
    let put = |name: &str, text: String| fs::write(dir.path().join(name), text).unwrap();
    put("a.csv", scan(1, 1.0, false));
    put("b.csv", scan(2, 1.0, true));
    put("c.csv", scan(3, 1.37, true));
    let scans = ["compare", "--before", "a.csv", "--set", "pixel=2 um", "--set", "unit=um"];
    let with = |more: &[&'static str]| archard(&dir, &[&scans[..], more].concat());
    let made = ["--after", "b.csv", "-o", "out", "--test", "T", "--at", "distance_m=250"];
    let words = text(&with(&made).success().get_output().stdout);
    assert!(words.contains("worn volume") && words.contains("mm3, 95 %: "), "{words}");
    let read = |name: &str| fs::read_to_string(dir.path().join("out").join(name)).unwrap();
    let found: Value = serde_json::from_str(&read("difference.json")).unwrap();
    let worn = &found["worn_volume_m3"];
    let volume = 0.5e-18 * PI * SCAR[0] * SCAR[1] * SCAR[2];
    let by = worn["standard_uncertainty"].as_f64().unwrap();
    assert!((worn["value"].as_f64().unwrap() - volume).abs() < 3.0 * by, "{worn} {volume}");
    assert!(by < 0.02 * volume, "{worn}");
    // One verdict: in words, in the file and on the page.
    let judged = found["verdict"]["word"].as_str().unwrap();
    assert!(words.contains(&format!("verdict           {judged} (")), "{words}");
    assert!(read("report.html").contains(&format!("Verdict: <strong>{judged}</strong>")));
    let lines = found["verdict"]["lines"].as_array().unwrap();
    let stated = lines.iter().find(|line| line["subject"] == "stated").unwrap();
    let value = |key: &str| found[key]["value"].as_f64().unwrap();
    let half = |key: &str| found[key]["interval_95"][1].as_f64().unwrap() - value(key);
    let largest = (half("worn_volume_m3") / value("worn_volume_m3"))
        .max(half("net_volume_m3") / value("worn_volume_m3"))
        .max(half("depth_m") / value("depth_m"));
    assert!(stated["value"].as_f64().unwrap() >= largest * (1.0 - 1e-9), "{stated} {largest}");
    let remarks = found["remarks"].as_array().unwrap().len();
    assert_eq!(lines.iter().filter(|line| line["subject"] == "warning").count(), remarks);
    let tests = read("tests.csv");
    assert!(tests.starts_with("test,distance_m,volume_mm3,u_volume_mm3\nT,250,"), "{tests}");
    assert!(
        read("report.html").contains("Worn volume") && read("section.csv").lines().count() > 20
    );
    assert!(dir.path().join("out/plots/difference.png").is_file());
    let error = text(&with(&["--after", "c.csv"]).code(2).get_output().stderr);
    assert!(error.contains("c.csv: the "), "{error}");
    let wrong = |more: &[&'static str]| text(&with(more).code(2).get_output().stderr);
    for key in ["level=plane", "form=sphere", "rough=50 um"] {
        let error = wrong(&["--after", "b.csv", "--set", key]);
        assert!(error.contains("takes off a part of what is worn"), "{error}");
    }
    let error = wrong(&["--after", "b.csv", "--at", "500"]);
    assert!(error.contains("--at 500: write a column and a number"), "{error}");
    // A file of the user's is in the way, and stays; what was written here before is replaced.
    fs::create_dir(dir.path().join("mine")).unwrap();
    put("mine/tests.csv", "mine".to_owned());
    let error = wrong(&["--after", "b.csv", "-o", "mine"]);
    assert!(error.contains("tests.csv` is in the way"), "{error}");
    assert_eq!(fs::read_dir(dir.path().join("mine")).unwrap().count(), 1);
    fs::create_dir(dir.path().join("pages")).unwrap();
    put("pages/report.html", "mine".to_owned());
    let error = wrong(&["--after", "b.csv", "-o", "pages"]);
    assert!(error.contains("report.html` is there, and is no page"), "{error}");
    assert_eq!(fs::read_to_string(dir.path().join("pages/report.html")).unwrap(), "mine");
    with(&made).success();
    // Each scan in a unit of its own: nanometres before, micrometres after.
    let nanometres = |row: &str| {
        let heights = row.split(' ').map(|cell| 1e3 * cell.parse::<f64>().unwrap());
        heights.map(|height| height.to_string()).collect::<Vec<_>>().join(" ")
    };
    let rows: Vec<String> = scan(1, 1.0, false).lines().map(nanometres).collect();
    put("nm.csv", rows.join("\n"));
    let units = ["--set", "pixel=2 um", "--set-before", "unit=nm", "--set-after", "unit=um"];
    let scans = ["compare", "--before", "nm.csv", "--after", "b.csv", "-o", "units"];
    archard(&dir, &[&scans[..], &units].concat()).success();
    let other = fs::read_to_string(dir.path().join("units/difference.json")).unwrap();
    let other: Value = serde_json::from_str(&other).unwrap();
    let [one, other] = [worn, &other["worn_volume_m3"]].map(|all| all["value"].as_f64().unwrap());
    assert!((one / other - 1.0).abs() < 1e-6, "{one} {other}");
    let error = wrong(&["--after", "b.csv", "--set-before", "form=sphere"]);
    assert!(error.contains("takes off a part of what is worn"), "{error}");
    archard(&dir, &["compare", "--before", "a.csv"]).failure();
    archard(&dir, &["compare"]).failure();
}
