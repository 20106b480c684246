//! What a user has written is never replaced: results go where nothing stands, or where this program wrote before.

use std::fs;
use std::path::Path;

use tempfile::TempDir;

use super::{archard, case, said};

const SMALL: [&str; 7] = [
    "-q",
    "--set",
    "frame.elements=[12, 12]",
    "--set",
    "motion.sliding.step=50 mm",
    "--set",
    "output.every=250 mm",
];

/// Two tests of a pin, k F s with k near 1e-4 mm3/(N m).
fn tests(path: &Path) {
    let text =
        "test,distance_m,volume_mm3\nA,0.2,2.00e-4\nA,0.4,4.1e-4\nB,0.2,2.1e-4\nB,0.4,4.0e-4\n";
    fs::write(path, text).unwrap();
}

/// The contents of all files of a folder, by name.
fn contents(dir: &Path) -> Vec<(String, Vec<u8>)> {
    let mut all: Vec<_> = fs::read_dir(dir)
        .unwrap()
        .flatten()
        .filter(|entry| entry.path().is_file())
        .map(|entry| {
            let name = entry.file_name().into_string().unwrap();
            (name, fs::read(entry.path()).unwrap())
        })
        .collect();
    all.sort();
    all
}

/// Each name that a command gives, with a file of the user's in its place: the command says which is in the way before it
/// computes anything, and every file stays.
#[test]
fn files_of_the_user_are_in_the_way_of_every_command() {
    let dir = TempDir::new().unwrap();
    let pin = case("pin_on_disc");
    let pin = pin.to_str().unwrap();
    tests(&dir.path().join("tests.csv"));
    let fit = [&["fit", pin, "--data", "tests.csv", "-o", "mine"][..], &SMALL].concat();
    let over = ["--over", "motion.sliding.load=5 N,7 N"];
    let sweep = [&["sweep", pin, "-o", "mine"][..], &SMALL, &over].concat();
    for (arguments, names) in [
        (&fit, &["fit.csv", "fit.json", "fit.svg", "fit.png"][..]),
        (&sweep, &["study.json", "sweep.csv"]),
    ] {
        for name in names {
            let mine = dir.path().join("mine");
            fs::create_dir(&mine).unwrap();
            fs::write(mine.join(name), "mine").unwrap();
            let refused = said(&archard(&dir, arguments).code(2));
            assert!(refused.contains(&format!("mine/{name}` is in the way")), "{refused}");
            assert_eq!(fs::read_to_string(mine.join(name)).unwrap(), "mine");
            assert!(!mine.join("rows/0001").exists() && !mine.join("run").exists(), "{name}");
            fs::remove_dir_all(mine).unwrap();
        }
    }
}

/// Pictures that the user put in the places of drawn ones stay, and none is drawn then; drawn ones are drawn again.
#[test]
#[ignore = "long: in .ci/long"]
fn pictures_of_the_user_stay() {
    let dir = TempDir::new().unwrap();
    let pin = case("pin_on_disc");
    archard(&dir, &[&["run", pin.to_str().unwrap(), "-o", "run"][..], &SMALL].concat()).success();
    archard(&dir, &["plot", "run"]).success();
    archard(&dir, &["plot", "run"]).success();
    let plots = dir.path().join("run/plots");
    let drawn = contents(&plots);
    for (name, content) in &drawn {
        fs::write(plots.join(name), "mine").unwrap();
        let before = contents(&plots);
        let refused = said(&archard(&dir, &["plot", "run"]).code(2));
        assert!(refused.contains(&format!("{name}` is in the way")), "{refused}");
        assert!(contents(&plots) == before, "{name}");
        fs::write(plots.join(name), content).unwrap();
    }
    // A picture at a path of the user's choosing, too.
    let heights: Vec<String> = (0..16).map(|y| format!("0 {} 1 0 1 0 1 0", y % 3)).collect();
    fs::write(dir.path().join("scan.txt"), heights.join("\n")).unwrap();
    let draw = ["surface", "scan.txt", "--set", "unit=um", "--set", "pixel=5 um", "-o"];
    for ending in ["svg", "png"] {
        let name = format!("scan.{ending}");
        let arguments = [&draw[..], &[&name]].concat();
        archard(&dir, &arguments).success();
        archard(&dir, &arguments).success();
        fs::write(dir.path().join(&name), "mine").unwrap();
        archard(&dir, &arguments).code(2);
        assert_eq!(fs::read_to_string(dir.path().join(&name)).unwrap(), "mine");
    }
}

/// What a command reads is no place for its results, though an earlier command wrote it there: the data of a fit, its case, the
/// case of a study, a scan.
#[cfg(unix)]
#[test]
fn inputs_are_no_places_for_results() {
    let dir = TempDir::new().unwrap();
    let at = |name: &str| dir.path().join(name);
    let pin = case("pin_on_disc");
    let pin = pin.to_str().unwrap();
    tests(&at("tests.csv"));
    archard(&dir, &[&["fit", pin, "--data", "tests.csv", "-o", "fit"][..], &SMALL].concat());
    let listed = fs::read_to_string(at("fit/manifest.txt")).unwrap();
    assert!(listed.contains("wrote fit.csv"), "{listed}");
    // The same file under another name.
    tests(&at("fit/fit.csv"));
    fs::hard_link(at("fit/fit.csv"), at("linked.csv")).unwrap();
    let before = contents(&at("fit"));
    for data in ["fit/fit.csv", "linked.csv"] {
        let arguments = ["fit", pin, "--data", data, "-o", "fit"];
        let refused = said(&archard(&dir, &[&arguments[..], &SMALL].concat()).code(2));
        assert!(refused.contains("fit.csv` is read here"), "{refused}");
    }
    let nested = ["fit", "fit/run", "--data", "tests.csv", "-o", "fit", "-q"];
    let refused = said(&archard(&dir, &nested).code(2));
    assert!(refused.contains("fit/run/case.toml` is read here"), "{refused}");
    assert!(contents(&at("fit")) == before);
    let over = ["--over", "motion.sliding.load=5 N,7 N", "-o", "study"];
    archard(&dir, &[&["sweep", pin][..], &SMALL, &over].concat()).success();
    let again = [&["sweep", "study/rows/0001", "-q"][..], &over].concat();
    let refused = said(&archard(&dir, &again).code(2));
    assert!(refused.contains("rows/0001/case.toml` is read here"), "{refused}");
}
