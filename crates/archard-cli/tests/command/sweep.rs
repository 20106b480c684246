//! Studies: designs, tables, and frames and grids of their rows.

mod going_on;
mod only_k_s;

use std::collections::HashMap;
use std::fs;
use std::path::Path;
use std::time::SystemTime;

use tempfile::TempDir;

use super::{archard, case, printed, said};

/// A pin on a disc in ten steps on a coarse frame.
const SMALL: [&str; 6] = [
    "--set",
    "frame.elements=[12, 12]",
    "--set",
    "motion.sliding.step=50 mm",
    "--set",
    "output.every=250 mm",
];
const K: &str = "body.pin.wear.archard.coefficient";

/// The arguments of a study of the small case.
fn study<'a>(case: &'a str, more: &[&'a str]) -> Vec<&'a str> {
    [&["sweep", case, "-o", "study", "-q"], &SMALL[..], more].concat()
}

/// The rows of a table by column.
fn rows(dir: &TempDir, name: &str) -> Vec<HashMap<String, String>> {
    let mut reader = csv::Reader::from_path(dir.path().join(name)).unwrap();
    let header = reader.headers().unwrap().clone();
    let row = |record: csv::StringRecord| {
        header.iter().zip(&record).map(|(name, cell)| (name.to_owned(), cell.to_owned())).collect()
    };
    reader.records().map(|record| row(record.unwrap())).collect()
}

fn number(row: &HashMap<String, String>, column: &str) -> f64 {
    row[column].parse().unwrap_or_else(|_| panic!("{column}: {:?}", row[column]))
}

fn written(dir: &Path) -> Vec<(usize, SystemTime)> {
    let folders = fs::read_dir(dir.join("study/rows")).unwrap().map(|entry| entry.unwrap().path());
    let time = |folder: &Path| fs::metadata(folder.join("summary.json")).ok()?.modified().ok();
    let number = |folder: &Path| folder.file_name()?.to_str()?.parse().ok();
    let mut all: Vec<_> =
        folders.filter_map(|folder| Some((number(&folder)?, time(&folder)?))).collect();
    all.sort_unstable();
    all
}

/// Lists are values like others, and each row says what varied and what came out, the end the median and the interval.
#[test]
fn lists_are_values() {
    let dir = TempDir::new().unwrap();
    let pin = case("pin_on_disc");
    let sizes = r#"frame.size=["1.2 mm", "1.2 mm"];["1.4 mm", "1.2 mm"]"#;
    let over = ["--over", sizes, "--over", "motion.sliding.load=5 N,20 N"];
    let arguments = [&["sweep", pin.to_str().unwrap(), "-o", "study"], &SMALL[..], &over].concat();
    let ran = archard(&dir, &arguments).success();
    let rows = rows(&dir, "study/sweep.csv");
    assert_eq!(rows.len(), 4);
    assert_eq!(rows[2]["frame.size"], r#"["0.0014 m", "0.0012 m"]"#);
    for (index, row) in rows.iter().enumerate() {
        assert_eq!(row["status"], "done");
        let load = if index % 2 == 0 { "5 N" } else { "20 N" };
        let depth = archard_case::verdict::four(1e6 * number(row, "wear_depth_m"));
        let said = said(&ran);
        let line = said.lines().find(|line| line.contains(&format!("row {}, size", index + 1)));
        let line = line.unwrap_or_else(|| panic!("{said}"));
        let came = format!("load {load}: wear depth (pin) {depth} um, peak pressure");
        assert!(line.contains(&came), "{line}");
    }
    // The median of four is the mean of the middle ones.
    let mut depths: Vec<f64> = rows.iter().map(|row| 1e6 * number(row, "wear_depth_m")).collect();
    depths.sort_by(f64::total_cmp);
    let [least, median, most] =
        [depths[0], 0.5 * (depths[1] + depths[2]), depths[3]].map(archard_case::verdict::four);
    let end = format!("wear depth (pin)  median {median} um, 4 rows from {least} to {most} um");
    assert!(printed(&ran).contains(&end), "{}", printed(&ran));
    archard(&dir, &["plot", "study"]).success();
    let effects = fs::read_to_string(dir.path().join("study/plots/main_effects.svg")).unwrap();
    assert!(effects.contains("Frame size"), "{effects}");
}

/// Two keys that are numbers make a map.
#[test]
#[ignore = "long: in .ci/long"]
fn two_keys_make_a_map() {
    let dir = TempDir::new().unwrap();
    let pin = case("pin_on_disc");
    let over = [
        "--over",
        "motion.sliding.load=5 N:20 N:3",
        "--over",
        "body.pin.profile.sphere.radius=25 mm,35 mm,50 mm",
    ];
    archard(&dir, &study(pin.to_str().unwrap(), &over)).success();
    archard(&dir, &["plot", "study"]).success();
    let map = fs::read_to_string(dir.path().join("study/plots/map.svg")).unwrap();
    // The depth of each row stands in its cell.
    for row in rows(&dir, "study/sweep.csv") {
        let depth = 1e6 * number(&row, "wear_depth_m");
        let written = |text: &str| {
            let number = text.strip_suffix(" ?").unwrap_or(text).parse();
            number.is_ok_and(|near: f64| (near / depth - 1.0).abs() < 6e-3)
        };
        assert!(map.split(['<', '>']).any(written), "{depth}");
    }
    assert!(map.contains(">Load (N)<") && map.contains(">Radius of pin (mm)<"), "{map}");
    // Black on the deepest, white on those below half of it.
    assert!(map.contains("font-size=\"13\" text-anchor=\"middle\" fill=\"#000000\""), "{map}");
    let depths: Vec<f64> =
        rows(&dir, "study/sweep.csv").iter().map(|row| number(row, "wear_depth_m")).collect();
    let deepest = depths.iter().copied().fold(0.0, f64::max);
    let shallow = depths.iter().any(|depth| *depth < 0.5 * deepest);
    assert_eq!(map.contains("fill=\"#ffffff\">"), shallow, "{map}");
    // Three values that are far apart take as much room as three that are not, each with its name.
    for name in [">5<", ">12.5<", ">20<", ">25<", ">35<", ">50<"] {
        assert!(map.contains(name), "{name}: {map}");
    }
    // What is doubtful is marked, and why.
    let table = dir.path().join("study/sweep.csv");
    let text = fs::read_to_string(&table).unwrap();
    for (given, count) in [("done,good", 0), ("done,doubtful", 1)] {
        let good = text.replace("done,doubtful", "done,good");
        fs::write(&table, good.replacen("done,good", given, 1)).unwrap();
        archard(&dir, &["plot", "study"]).success();
        let map = fs::read_to_string(dir.path().join("study/plots/map.svg")).unwrap();
        assert_eq!(map.matches(" ?<").count(), count, "{map}");
        let summary = fs::read(dir.path().join("study/rows/0001/summary.json")).unwrap();
        let summary: serde_json::Value = serde_json::from_slice(&summary).unwrap();
        let lines = summary["verdict"]["lines"].as_array().unwrap().iter();
        let why = lines
            .filter(|line| line["word"] != "good")
            .map(|line| line["subject"].as_str().unwrap());
        let mut why: Vec<&str> = why.collect();
        why.sort_unstable();
        let why = why.join(", ");
        let said = map.contains(&format!("? doubtful, 1 of 9 rows: {why}"));
        assert_eq!(said, count == 1, "{why}: {map}");
    }
}

#[test]
fn sobol_indices_have_their_own_design() {
    let dir = TempDir::new().unwrap();
    let pin = case("pin_on_disc");
    let samples = [
        "--sample",
        "motion.sliding.load=uniform(8 N, 12 N)",
        "--sample",
        "body.pin.profile.sphere.radius=uniform(45 mm, 55 mm)",
        "--samples",
        "4",
        "--design",
        "saltelli",
    ];
    archard(&dir, &study(pin.to_str().unwrap(), &samples)).success();
    assert_eq!(rows(&dir, "study/sweep.csv").len(), 4 * (2 + 2));
    archard(&dir, &["plot", "study"]).success();
    assert!(dir.path().join("study/plots/sobol_indices.png").is_file());
}

/// Whatever is wrong is said before anything runs or is written.
#[test]
fn wrong_studies_are_refused() {
    let dir = TempDir::new().unwrap();
    let pin = case("pin_on_disc");
    let load = "motion.sliding.load";
    for (options, said_of_it) in [
        (vec!["--over", "motion.sliding.laod=5 N,6 N"], "did you mean `load`"),
        (vec!["--over", "motion.sliding.load=5,6"], "needs a unit"),
        (vec!["--over", "motion.sliding.load=5 N,6 mm"], "row 2 of the study cannot be run"),
        (vec!["--over", "motion.sliding.load=5 N:6 N:1"], "two values at least"),
        (vec!["--over", "motion.sliding.load=5 N,-6 N"], "greater than zero"),
        (vec!["--over", "motion.sliding.load=5 N:20 N:1000000000"], "100000 at most can be run"),
        (
            vec![
                "--over",
                "motion.sliding.load=1 N:2 N:1000",
                "--over",
                "output.every=1 mm:2 mm:1000",
            ],
            "a study of 1000000 rows",
        ),
        (
            vec![
                "--sample",
                "motion.sliding.load=normal(5 N, 1 N)",
                "--samples",
                "18446744073709551615",
            ],
            "more rows than can be counted",
        ),
        (vec!["--over", load], "write --over KEY="),
        (
            vec!["--over", "motion.sliding.load=5 N", "--over", "motion.sliding.load=6 N"],
            "is given twice",
        ),
        (vec!["--over", "motion.sliding.load=5 N", "--design", "sobol"], "give --sample"),
        (vec!["--over", "motion.sliding.load=5 N", "--task", "4/3"], "like 0/8 to 7/8"),
        (vec!["--sample", "motion.sliding.load=normal(5 N, 1 N)"], "--samples"),
        (
            vec!["--sample", "motion.sliding.load=cauchy(5 N, 1 N)", "--samples", "2"],
            "write a distribution like",
        ),
        (
            vec!["--sample", "motion.sliding.load=normal(5 N, 100 N)", "--samples", "9"],
            "greater than zero",
        ),
        (vec![], "a study goes over something"),
    ] {
        let refused = archard(&dir, &study(pin.to_str().unwrap(), &options)).code(2);
        assert!(said(&refused).contains(said_of_it), "{said_of_it} is not in\n{}", said(&refused));
        assert!(!dir.path().join("study").exists(), "{options:?}");
    }
    let body = case("patch_test");
    let over = [
        "sweep",
        body.to_str().unwrap(),
        "--over",
        "body.block.material.poisson=0.2,0.3",
        "-o",
        "study",
    ];
    let refused = archard(&dir, &over).code(2);
    assert!(said(&refused).contains("two bodies in contact"), "{}", said(&refused));
}

/// Frames of rows grow with their contact, also where one run gives several.
#[test]
fn frames_of_rows_grow_with_their_contact() {
    let dir = TempDir::new().unwrap();
    let pin = case("pin_on_disc");
    let pin = pin.to_str().unwrap();
    let ks = format!("{K}=2e-14 1/Pa,1.33e-13 1/Pa,1e-12 1/Pa");
    let sweep = study(pin, &["--over", &ks]);
    archard(&dir, &sweep).success();
    let rows = rows(&dir, "study/sweep.csv");
    for row in &rows {
        assert_eq!((&*row["status"], &*row["verdict"] == "wrong"), ("done", false), "{row:?}");
    }
    let volume = number(&rows[2], "worn_volume_pin_m3");
    assert!((volume / (1e-12 * 10.2 * 0.5) - 1.0).abs() < 1e-6, "{volume}");
    let before = written(dir.path());
    archard(&dir, &sweep).success();
    assert_eq!(written(dir.path()), before);
}

/// With an accuracy every row has elements of its own and the errors that they make; what is done is not run again, and rows
/// that differ in k alone are runs of their own.
#[test]
fn rows_to_an_accuracy_find_their_grids() {
    let dir = TempDir::new().unwrap();
    let pin = case("pin_on_disc").display().to_string();
    let arguments = [
        "sweep",
        &pin,
        "-o",
        "study",
        "--set",
        "frame=",
        "--set",
        "motion.sliding.step=",
        "--accuracy",
        "5%",
        "--over",
        "motion.sliding.load=5 N, 50 N",
        "--over",
        "body.pin.wear.archard.coefficient=1.33e-13 1/Pa, 2.66e-13 1/Pa",
    ];
    let told = said(&archard(&dir, &arguments).success());
    assert!(!told.contains("Only k s counts"), "{told}");
    let rows = rows(&dir, "study/sweep.csv");
    assert_eq!(rows.len(), 4);
    for row in &rows {
        assert_eq!(row["status"], "done", "{row:?}");
        let error = number(row, "relative_error");
        assert!(error > 0.0 && error < 0.05, "{error}");
    }
    let size = |row: usize| {
        let case = fs::read_to_string(dir.path().join(format!("study/rows/{row:04}/case.toml")));
        let case = case.unwrap();
        case.lines().find(|line| line.starts_with("frame.size")).unwrap().to_owned()
    };
    assert_ne!(size(1), size(3));
    let before = written(dir.path());
    archard(&dir, &arguments).success();
    assert_eq!(before, written(dir.path()));
    // Another accuracy is another study.
    let other: Vec<&str> =
        arguments.iter().map(|&one| if one == "5%" { "4%" } else { one }).collect();
    archard(&dir, &other).code(2);
}
