//! `archard fit`: from a table to a coefficient, its files, and a prediction.

use std::fs;

use tempfile::TempDir;

use super::{archard, case, printed, said};

/// Volumes of three tests, k F s with k = 1e-4, 1.3e-4 and 1.6e-4 mm3/(N m), each read three times, with small errors.
fn tests(exponent: f64) -> String {
    let mut text = "Versuch;Weg [mm];Volumen [mm^3]\n".to_owned();
    let off = [[1.02, 0.98, 1.01], [0.99, 1.03, 0.98], [0.98, 1.0, 1.02]];
    for ((test, k), off) in [("A", 1.0e-4), ("B", 1.3e-4), ("C", 1.6e-4)].into_iter().zip(off) {
        for (distance, off) in [0.1_f64, 0.2, 0.4].into_iter().zip(off) {
            let volume = k * 10.2 * 0.2 * (distance / 0.2).powf(exponent) * off;
            text += &format!("{test};{};{volume:.6e}\n", 1e3 * distance).replace('.', ",");
        }
    }
    text
}

const NAMES: [&str; 6] = [
    "--column",
    "test=Versuch",
    "--column",
    "distance=Weg [mm]",
    "--column",
    "volume=Volumen [mm^3]",
];

#[test]
fn a_table_becomes_a_coefficient_and_a_prediction() {
    let (dir, case) = (TempDir::new().unwrap(), case("pin_on_disc"));
    let case = case.to_str().unwrap();
    fs::write(dir.path().join("tests.csv"), tests(1.0)).unwrap();
    let arguments = [&["fit", case, "--data", "tests.csv", "-o", "fit"][..], &NAMES].concat();
    let text = printed(&archard(&dir, &arguments).success());
    // The geometric mean of the three is 1.276e-4; so is that of a k p s at each.
    assert!(
        text.contains("  k               1.27") || text.contains("  k               1.28"),
        "{text}"
    );
    assert!(
        text.contains("another test, read as these, lies there with 95 % probability"),
        "{text}"
    );
    for name in ["fit.json", "fit.csv", "fit.svg", "fit.png", "run/history.csv"] {
        assert!(dir.path().join("fit").join(name).is_file(), "{name}");
    }
    let pictured = said(&archard(&dir, &["plot", "fit"]).code(2));
    assert!(pictured.contains("its picture is `fit/fit.png`"), "{pictured}");
    let predict = ["sweep", case, "--from", "fit/fit.json", "--samples", "6", "-o", "study"];
    let larger = ["--set", "frame.size=[\"2 mm\", \"2 mm\"]", "--set", "frame.elements=[50, 50]"];
    archard(&dir, &[&predict[..], &larger].concat()).success();
    let design = fs::read_to_string(dir.path().join("study/design.csv")).unwrap();
    let value = |line: &str| line.split(',').nth(1).and_then(|cell| cell.parse::<f64>().ok());
    let values: Vec<f64> = design.lines().skip(1).filter_map(value).collect();
    let below = values.iter().filter(|value| **value < 1.277e-13).count();
    assert_eq!((values.len(), below), (6, 3), "{design}");
}

#[test]
fn tests_that_are_not_of_the_law_give_no_coefficient() {
    let (dir, case) = (TempDir::new().unwrap(), case("pin_on_disc"));
    let case = case.to_str().unwrap();
    fs::write(dir.path().join("tests.csv"), tests(0.5)).unwrap();
    let arguments = ["fit", case, "--data", "tests.csv", "-o", "fit"];
    let failed = said(&archard(&dir, &[&arguments[..], &NAMES].concat()).code(1));
    assert!(failed.contains("the tests do not wear as the law says"), "{failed}");
    let predict = ["sweep", case, "--from", "fit/fit.json", "--samples", "4", "-o", "study"];
    let refused = said(&archard(&dir, &predict).code(2));
    assert!(refused.contains("to predict with"), "{refused}");
    // A header that is not there is told with those that are.
    let wrong = [&arguments[..], &["--column", "depth=Tiefe"]].concat();
    let wrong = said(&archard(&dir, &wrong).code(2));
    assert!(wrong.contains("there are `Versuch`, `Weg [mm]`, `Volumen [mm^3]`"), "{wrong}");
    // What cannot be fitted leaves no folder.
    let wrong = ["fit", case, "--data", "tests.csv", "-o", "none"];
    archard(&dir, &wrong).code(2);
    assert!(!dir.path().join("none").exists());
}

/// Coefficients of two bodies that go together are drawn together.
#[test]
fn coefficients_of_the_same_tests_are_drawn_together() {
    let (dir, case) = (TempDir::new().unwrap(), case("pin_on_disc_both"));
    let case = case.to_str().unwrap();
    let mut text = "test,distance_m,volume_pin_mm3,volume_disc_mm3\n".to_owned();
    for (test, (pin, disc)) in
        [(0.8, 0.78), (1.3, 1.33), (0.95, 1.0), (1.1, 1.06), (0.7, 0.71)].into_iter().enumerate()
    {
        for distance in [0.2, 0.4] {
            let volume = |k: f64| 1e9 * k * 10.2 * distance;
            let (pin, disc) = (volume(pin * 8.87e-14), volume(disc * 4.435e-14));
            text += &format!("{test},{distance},{pin:.6e},{disc:.6e}\n");
        }
    }
    fs::write(dir.path().join("tests.csv"), text).unwrap();
    let coarse = ["--set", "frame.elements=[24, 24]", "--set", "motion.sliding.step=50 mm"];
    let fit = ["fit", case, "--data", "tests.csv", "-o", "fit"];
    let said = printed(&archard(&dir, &[&fit[..], &coarse].concat()).success());
    assert!(said.contains("correlation 0.99 of 5 tests"), "{said}");
    let sweep = ["sweep", case, "--from", "fit/fit.json", "--samples", "40", "-o", "study"];
    archard(&dir, &[&sweep[..], &coarse].concat());
    let design = fs::read_to_string(dir.path().join("study/design.csv")).unwrap();
    let logs = |column: usize| -> Vec<f64> {
        let cells = design.lines().skip(1).map(|line| line.split(',').nth(column).unwrap());
        cells.map(|cell| cell.parse::<f64>().unwrap().ln()).collect()
    };
    let [one, other] = [1, 2].map(logs);
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    let product = |a: &[f64], b: &[f64]| {
        let (x, y) = (mean(a), mean(b));
        a.iter().zip(b).map(|(a, b)| (a - x) * (b - y)).sum::<f64>()
    };
    let correlation =
        product(&one, &other) / (product(&one, &one) * product(&other, &other)).sqrt();
    assert!((0.95..1.0).contains(&correlation), "{correlation}");
    let saltelli = ["sweep", case, "--from", "fit/fit.json", "--samples", "4", "-o", "indices"];
    let refused = archard(&dir, &[&saltelli[..], &["--design", "saltelli"]].concat()).code(2);
    let refused = super::said(&refused);
    assert!(refused.contains("go together"), "{refused}");
}

/// What the fit of one body says nothing of is not taken from the case without a word.
#[test]
fn a_prediction_says_what_no_test_has_told() {
    let (dir, case) = (TempDir::new().unwrap(), case("pin_on_disc_both"));
    let case = case.to_str().unwrap();
    let pin = "body.pin.wear.archard.coefficient";
    let fit = format!(
        r#"{{"coefficients": [{{"key": "{pin}", "unit": "1/Pa", "median": 1e-13,
            "next_test_log_deviation": 0.2, "next_test_degrees_of_freedom": 3.0}}]}}"#
    );
    fs::write(dir.path().join("fit.json"), fit).unwrap();
    let coarse = ["--set", "frame.elements=[16, 16]", "--set", "motion.sliding.step=50 mm"];
    let predict = ["sweep", case, "--from", "fit.json", "--samples", "3", "-o", "study"];
    // The built-in case of that name wears equally.
    let by_name = [&["sweep", "pin_on_disc_both"], &predict[2..]].concat();
    let predict = [&predict[..], &coarse].concat();
    let refused = said(&archard(&dir, &by_name).code(2));
    let disc = "body.disc.wear.archard.coefficient";
    assert!(refused.contains(&format!("has no `{disc}`, which is 6.650e-14 1/Pa")), "{refused}");
    assert!(refused.contains(&format!("--assume {disc}")), "{refused}");
    assert!(!dir.path().join("study").exists());
    archard(&dir, &[&predict[..], &["--assume", disc]].concat()).success();
    // Bands are those of each body, and of any column.
    archard(&dir, &["plot", "study"]).success();
    let bands = fs::read_to_string(dir.path().join("study/plots/bands.svg")).unwrap();
    assert!(bands.contains("Wear depth pin") && bands.contains("Wear depth disc"));
    archard(&dir, &["plot", "study", "--quantity", "worn_volume_pin_m3"]).success();
    let bands = fs::read_to_string(dir.path().join("study/plots/bands.svg")).unwrap();
    assert!(bands.contains("Worn volume pin") && !bands.contains("Wear depth"));
    let refused = said(&archard(&dir, &["plot", "study", "--quantity", "volume"]).code(2));
    assert!(refused.contains("has no column `volume`"), "{refused}");
}
