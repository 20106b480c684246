//! Runs that are told how accurate they have to be.

use std::fs;

use tempfile::TempDir;

use super::{archard, case, printed, said};

const PIN: &str = r#"
[body.pin]
material = { young = "210 GPa", poisson = 0.3 }
profile.sphere = { radius = "50 mm" }
wear.archard = { coefficient = "1.33e-13 1/Pa" }

[body.disc]
material = { young = "210 GPa", poisson = 0.3 }
profile.flat = {}

[motion.sliding]
load = "10.2 N"
distance = "100 mm"
"#;

/// Without a frame and without steps: both are chosen, the errors stand in the history, the verdict and the folder's case,
/// which runs to the same results.
#[test]
fn one_number_takes_the_place_of_frame_and_steps() {
    let dir = TempDir::new().unwrap();
    fs::write(dir.path().join("pin.toml"), PIN).unwrap();
    let run = archard(&dir, &["run", "pin.toml", "--accuracy", "5%", "-o", "one"]).success();
    let told = said(&run);
    assert!(told.contains("  0 %  estimating the discretisation error: "), "{told}");
    // The runs on fewer elements are part of what is done.
    let shares = told.lines().filter_map(|line| line.split_once(" %  "));
    let shares: Vec<f64> = shares.filter_map(|(share, _)| share.trim().parse().ok()).collect();
    assert!(shares.windows(2).all(|two| two[0] <= two[1]), "{told}");
    let first = told.lines().find(|line| line.contains("peak pressure")).unwrap();
    assert!(!first.starts_with("  0 %") && shares.last() == Some(&100.0), "{told}");
    assert!(printed(&run).contains("  +- "), "{}", printed(&run));
    let read =
        |folder: &str, file: &str| fs::read_to_string(dir.path().join(folder).join(file)).unwrap();
    let history = read("one", "history.csv");
    for column in ["relative_error", "error_of_wear_depth_m"] {
        let titles = history.lines().next().unwrap();
        assert!(titles.split(',').any(|title| title == column), "{titles}");
    }
    let case = read("one", "case.toml");
    assert!(case.contains("accuracy = 0.05") && case.contains("frame.size"), "{case}");
    archard(&dir, &["run", "one", "-o", "two", "-q"]).success();
    archard(&dir, &["run", "pin.toml", "--accuracy", ".05", "-o", "three", "-q"]).success();
    for other in ["two", "three"] {
        assert_eq!(history, read(other, "history.csv"));
        assert_eq!(case, read(other, "case.toml"));
    }
    // A folder is refused before elements are sought for the run, and the same case may run there again.
    let elsewhere = ["run", "pin.toml", "--accuracy", "4%", "-o", "one"];
    let refused = said(&archard(&dir, &elsewhere).code(2));
    assert!(refused.contains("another case") && !refused.contains("estimating"), "{refused}");
    let refused = said(&archard(&dir, &["run", "--resume", "one"]).code(2));
    assert!(refused.contains("no run to go on") && !refused.contains("estimating"), "{refused}");
    archard(&dir, &["run", "pin.toml", "--accuracy", "5%", "-o", "one", "-q"]).success();
}

/// Without the number there has to be a frame.
#[test]
fn a_frame_that_is_missing_is_asked_for() {
    let dir = TempDir::new().unwrap();
    fs::write(dir.path().join("pin.toml"), PIN).unwrap();
    let run = archard(&dir, &["run", "pin.toml"]).code(2);
    assert!(said(&run).contains("frame"), "{}", said(&run));
    let run = archard(&dir, &["run", "pin.toml", "--accuracy", "much"]).code(2);
    assert!(said(&run).contains("accuracy"), "{}", said(&run));
}

/// A budget ends the search on the first grid that is judged, not the run, which says how far off it is.
#[test]
fn a_budget_ends_the_search() {
    let dir = TempDir::new().unwrap();
    let punch = case("running_in_flat_punch").display().to_string();
    let run = |budget| {
        let budget = format!("--budget={budget}");
        archard(&dir, &["run", &punch, "-o", "one", "--force", &budget])
    };
    for nothing in ["0 s", "-1 s", "1 mm", "soon"] {
        let refused = said(&run(nothing).code(2));
        assert!(refused.contains(&format!("--budget {nothing}: ")), "{refused}");
    }
    let told = said(&run("1e-9 s"));
    let stays = "0.05 was asked for; the run goes on with that";
    assert!(told.contains(stays) && told.contains("the run takes 28 x 28 elements"), "{told}");
    let history = fs::read_to_string(dir.path().join("one/history.csv")).unwrap();
    assert!(history.contains("error_of_wear_depth_m"), "{history}");
    let run = [
        "run",
        "hertz",
        "--set",
        "accuracy=",
        "--set",
        "frame={ size = [\"0.4 mm\", \"0.4 mm\"], elements = [20, 20] }",
        "--budget=1 s",
    ];
    let refused = said(&archard(&dir, &run).code(2));
    assert!(refused.contains("no `accuracy` is asked for"), "{refused}");
}
