//! How long parts last by the coefficient of a fit.

use std::fs;
use std::path::Path;

use serde_json::{Value, json};
use tempfile::TempDir;

use super::{archard, printed, said};

/// A `fit.json` of one coefficient: median (1/Pa), its interval, deviation of the logarithm and degrees of freedom of the next test.
fn put_fit(dir: &TempDir, key: &str, next: Value) {
    let fit = json!({"coefficients": [{
        "key": key, "unit": "1/Pa", "median": 2e-13, "interval_95": [1e-13, 4e-13],
        "next_test_log_deviation": next[0], "next_test_degrees_of_freedom": next[1], "rejected": null,
    }]});
    fs::write(dir.path().join("fit.json"), fit.to_string()).unwrap();
}

fn life(dir: &TempDir, folder: &str) -> Value {
    let text = fs::read_to_string(dir.path().join(folder).join("summary.json")).unwrap();
    let summary: Value = serde_json::from_str(&text).unwrap();
    summary["life"].clone()
}

const LIMIT: [&str; 4] = ["--until", "wear_depth_pin=1.5um", "--from", "fit.json"];
const KEY: &str = "body.pin.wear.archard.coefficient";

/// Where k s alone counts a life is as 1 over k: the 90 % quantile of Student's t of four degrees of freedom is 1.5332, the 99 % one
/// 3.7469 (any table).
#[test]
#[ignore = "long: in .ci/long"]
fn lives_scatter_as_the_coefficient_does() {
    let dir = TempDir::new().unwrap();
    put_fit(&dir, KEY, json!([0.3, 4.0]));
    let ran = archard(&dir, &[&["run", "pin_on_disc", "-o", "r"][..], &LIMIT].concat()).success();
    let words = printed(&ran);
    assert!(words.contains("90 % of the parts") && words.contains("median life"), "{words}");
    let life = life(&dir, "r");
    let median = life["reached"]["distance_m"].as_f64().unwrap();
    let is = |of: &Value, share: f64| {
        let of = of.as_f64().unwrap();
        assert!((of / (share * median) - 1.0).abs() < 1e-4, "{of} of {median}: {share}");
    };
    let told = &life["distribution"];
    is(&told["B10"], (-0.3 * 1.533_206_f64).exp());
    is(&told["B1"], (-0.3 * 3.746_947_f64).exp());
    is(&told["interval_95"][0], 0.5);
    is(&told["interval_95"][1], 2.0);
    archard(&dir, &["plot", "r"]).success();
    assert!(dir.path().join("r/plots/life.png").is_file());
}

/// Another law takes runs of its own; one that is linear in its coefficient has lives as 1 over it all the same, within what is read
/// between two steps.
#[test]
fn other_laws_take_a_run_for_each_share() {
    let dir = TempDir::new().unwrap();
    let law = "body.pin.wear={ energy = { coefficient = \"1e-13 1/Pa\" } }";
    put_fit(&dir, "body.pin.wear.energy.coefficient", json!([0.3, 4.0]));
    let set = ["--set", law, "--set", "friction.coulomb.coefficient=0.5"];
    let command = [&["run", "pin_on_disc", "-o", "r"][..], &set, &LIMIT].concat();
    archard(&dir, &command).success();
    let life = life(&dir, "r");
    let told = |name: &str| life["distribution"][name].as_f64().unwrap();
    let ratio = told("B10") / told("median");
    assert!((ratio / (-0.3 * 1.533_206_f64).exp() - 1.0).abs() < 0.05, "{life:#}");
    assert!(told("B1") < told("B10"));
}

/// A limit that the median does not reach within the motion has no lives of other shares, which may be within it or not.
#[test]
fn lives_beyond_the_motion_are_unknown() {
    let dir = TempDir::new().unwrap();
    put_fit(&dir, KEY, json!([0.3, 4.0]));
    let far = ["--until", "wear_depth_pin=1mm", "--from", "fit.json"];
    let ran = archard(&dir, &[&["run", "pin_on_disc", "-o", "r"][..], &far].concat()).success();
    let words = printed(&ran);
    assert!(
        words.contains("unknown: with the median") && !words.contains("of the parts"),
        "{words}"
    );
    let told = &life(&dir, "r")["distribution"];
    assert!(told["B1"].is_null() && told["interval_95"].is_null(), "{told:#}");
}

/// A friction that nothing depends on scatters no life: which one a share of parts reaches is not told by it.
#[test]
fn a_coefficient_that_a_life_does_not_fall_with_is_no_scatter_of_it() {
    let dir = TempDir::new().unwrap();
    put_fit(&dir, "friction.coulomb.coefficient", json!([0.3, 4.0]));
    let path = dir.path().join("fit.json");
    let mut fit: Value = serde_json::from_str(&fs::read_to_string(&path).unwrap()).unwrap();
    let own = &mut fit["coefficients"][0];
    own["unit"] = "".into();
    own["median"] = 0.3.into();
    own["interval_95"] = json!([0.2, 0.4]);
    fs::write(&path, fit.to_string()).unwrap();
    let assumed = ["run", "pin_on_disc", "-o", "r", "--assume", KEY];
    let ran = archard(&dir, &[&assumed[..], &LIMIT].concat()).success();
    let words = printed(&ran);
    assert!(words.contains("the life does not fall with"), "{words}");
    assert!(life(&dir, "r")["distribution"]["B10"].is_null(), "{words}");
}

/// One test gives no scatter; another body needs its key; a body that nobody fitted is asked for.
#[test]
fn what_is_not_told_is_said() {
    let dir = TempDir::new().unwrap();
    put_fit(&dir, KEY, Value::Null);
    let ran = archard(&dir, &[&["run", "pin_on_disc", "-o", "r"][..], &LIMIT].concat()).success();
    assert!(printed(&ran).contains("unknown: one test does not tell"), "{}", printed(&ran));
    let unknown = archard(&dir, &["run", "pin_on_disc", "-o", "u", "--until", "depth=1um"]).code(2);
    assert!(said(&unknown).contains("--until"), "{}", said(&unknown));
    put_fit(&dir, "body.stud.wear.archard.coefficient", json!([0.3, 4.0]));
    archard(&dir, &[&["run", "pin_on_disc", "-o", "s"][..], &LIMIT].concat()).code(2);
    let named = [&["run", "pin_on_disc", "-o", "s", "--as", KEY][..], &LIMIT].concat();
    archard(&dir, &named).success();
    put_fit(&dir, KEY, json!([0.3, 4.0]));
    let both =
        archard(&dir, &[&["run", "pin_on_disc_both", "-o", "b"][..], &LIMIT].concat()).code(2);
    assert!(said(&both).contains("body.disc"), "{}", said(&both));
}

/// A fit of a case with a limit has its life in a folder of its own, with a picture.
#[test]
#[ignore = "long: in .ci/long"]
fn a_fit_tells_how_long_its_case_lasts() {
    let dir = TempDir::new().unwrap();
    let table = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/fit/tests.csv");
    let table = table.display().to_string();
    let limit = "wear_depth_pin=1.5um";
    let fit = ["fit", "pin_on_disc", "--data", &table, "-o", "fit", "--until", limit];
    let words = printed(&archard(&dir, &fit).success());
    assert!(words.contains("B10"), "{words}");
    let told = life(&dir, "fit/life");
    let text = fs::read_to_string(dir.path().join("fit/fit.json")).unwrap();
    let fit: Value = serde_json::from_str(&text).unwrap();
    let own = &fit["coefficients"][0];
    let share = own["median"].as_f64().unwrap() / own["interval_95"][1].as_f64().unwrap();
    let [low, median] = [&told["distribution"]["interval_95"][0], &told["distribution"]["median"]]
        .map(|life| life.as_f64().unwrap());
    assert!((low / (share * median) - 1.0).abs() < 1e-9, "{told:#}");
    assert!(dir.path().join("fit/life/plots/life.svg").is_file());
}
