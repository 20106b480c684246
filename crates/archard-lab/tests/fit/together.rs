//! Coefficients that are fitted together.

use archard_case::CaseFile;
use archard_case::measured::Table;
use archard_lab::{Error, Files, Fit, Request, fit};

use super::made::{Made, Until, published};

const COATED: [&str; 5] = [
    "accuracy=",
    "frame={ size = [\"0.3 mm\", \"0.3 mm\"], elements = [24, 24] }",
    "body.disc.layers.0.thickness=1 um",
    "motion.sliding.tolerance=0.03",
    "output.every=500 m",
];

const LAYER: &str = "body.disc.layers.0.wear.archard.coefficient";

const BELOW: &str = "body.disc.wear.archard.coefficient";

fn both(file: &CaseFile, text: &str, keys: [&str; 2]) -> Result<Fit, Error> {
    let dir = tempfile::tempdir().unwrap();
    let table = Table::read("tests.csv", text.as_bytes()).unwrap();
    let request = Request {
        parameters: &keys.map(str::to_owned),
        uncertain: &[],
        assumed: &[],
        files: Files { folder: dir.path(), columns: &[] },
        dir: dir.path(),
        store: None,
        following: &mut Until(None, vec![]),
    };
    fit(file, &table, request)
}

/// Tests that wear through a coating tell its coefficient and that of what is below it, from a case that has others; in whatever
/// order they are asked for. Tests that end within it do not, and say so.
#[test]
fn a_coating_and_what_is_below_it_are_fitted_together() {
    let file = published("coated_disc", &COATED);
    let truth = [1e-15, 5e-15];
    let bodies = [("disc.layers.0", truth[0]), ("disc", truth[1])];
    let columns = [("depth_um", "wear_depth_disc_m", 1e6)];
    let mut held = 0;
    for seed in 1..=3 {
        let made = Made { file: file.clone(), bodies: &bodies, columns: &columns, tests: 6, seed };
        let text = made.table("distance_m");
        let other =
            file.clone().set(format!("{LAYER}=2e-15 1/Pa")).set(format!("{BELOW}=4e-15 1/Pa"));
        let found = both(&other, &text, [LAYER, BELOW]).unwrap();
        assert!(found.by_k_s && found.runs < 60, "{}", found.runs);
        for (own, k) in found.coefficients.iter().zip(truth) {
            let [low, high] = own.estimate.interval.unwrap();
            held += usize::from(low < k && k < high);
            assert!((own.estimate.median / k).ln().abs() < 0.5, "{:e}", own.estimate.median);
            assert!(own.estimate.next.unwrap()[1] > high);
        }
        assert!(found.correlation().unwrap().0.abs() < 0.99);
        assert!(found.to_string().contains("correlate by"), "{found}");
        if seed == 1 {
            let turned = both(&other, &text, [BELOW, LAYER]).unwrap();
            let elsewhere = both(&file, &text, [LAYER, BELOW]).unwrap();
            for (place, own) in found.coefficients.iter().enumerate() {
                let of = |fit: &Fit, place: usize| fit.coefficients[place].estimate.median;
                let k = own.estimate.median;
                assert!((of(&turned, 1 - place) / k - 1.0).abs() < 1e-6);
                // Runs of other lengths have steps of their own: a part of the error that is stated.
                let [low, high] = own.estimate.interval.unwrap();
                let off = (of(&elsewhere, place) / k).ln().abs();
                assert!(off < 0.1 * (high / low).ln(), "{place}: {off}");
            }
            // A way that ends in the coating.
            let short = published("coated_disc", &COATED).set("motion.sliding.distance=100 m");
            let never = Made { file: short.clone(), ..made }.table("distance_m");
            let error = both(&short, &never, [LAYER, BELOW]).unwrap_err().to_string();
            assert!(error.contains(&format!("do not determine `{BELOW}`")), "{error}");
        }
    }
    assert!(held >= 4, "{held} of 6");
}

/// Keys that are wrong or twice, and more than can be fitted.
#[test]
fn keys_that_cannot_be_fitted_together_are_told() {
    let file = published("coated_disc", &COATED);
    let text = "test,distance_m,depth_um\nA,1000,2\nA,2000,4\n";
    let twice = both(&file, text, [BELOW, BELOW]).unwrap_err().to_string();
    assert!(twice.contains("is given twice"), "{twice}");
    let unknown = both(&file, text, [BELOW, "body.disc.layer.wear"]).unwrap_err().to_string();
    assert!(
        unknown.contains(&format!("like --parameter {BELOW} or --parameter {LAYER}")),
        "{unknown}"
    );
}
