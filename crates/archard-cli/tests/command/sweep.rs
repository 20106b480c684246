//! Studies: designs, rows that go on, tasks that share, and rows that are one run.

use std::collections::HashMap;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, SystemTime};

use archard_case::output::Claim;
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

/// Frames of rows grow with their contact, also where one run tells several.
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
