//! Measured sets: what their profiles tell, and what is predicted of each test by the others.

use std::fs;
use std::path::{Path, PathBuf};

use super::made::Until;
use archard_lab::validate::{Set, Validation, validate};

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../validation").join(name)
}

fn validated(name: &str) -> Validation {
    let dir = folder(name);
    let runs = tempfile::tempdir().unwrap();
    let found =
        validate(&Set::read(&dir).unwrap(), (runs.path(), None), &mut Until(None, vec![])).unwrap();
    println!("{found}");
    found
}

/// Three worn blocks. By hand, from a line through what lies more than 1.5 mm from the middle: section, depth of the parabola through the
/// middle 1.4 mm, width at a twentieth of that depth between means of five readings. Each is predicted by the others.
#[test]
fn worn_blocks_are_predicted_by_each_other() {
    let found = validated("cruzado");
    let all = found.outcome.as_ref().unwrap();
    assert_eq!(all.len(), 9);
    assert!(all.iter().all(|own| own.holds()), "{found}");
    // How far the estimate may lie from the hand's; and at the section of the test itself the prediction: the second scar is skew.
    let by_hand = [
        ("profile", [0.0829e-6, 0.0690e-6, 0.0857e-6], 0.02, None),
        ("depth", [43.8e-6, 41.7e-6, 47.3e-6], 0.01, Some([0.06; 3])),
        ("width", [2.705e-3, 2.637e-3, 2.700e-3], 0.01, Some([0.04, 0.06, 0.04])),
    ];
    for (quantity, known, estimated, predicted) in by_hand {
        let tests = all.iter().filter(|own| own.quantity.starts_with(quantity));
        for (at, (own, known)) in tests.zip(known).enumerate() {
            assert!((own.measured / known - 1.0).abs() < estimated, "{own:?}");
            let Some(most) = predicted else { continue };
            let error = own.at_own_section.unwrap() / known - 1.0;
            assert!(error.abs() < most[at], "{own:?}: {error}");
        }
    }
}

/// The fretted flat, with the coefficient of its authors.
#[test]
fn a_fretted_flat_is_predicted() {
    let found = validated("mccoll");
    let all = found.outcome.as_ref().unwrap();
    let depth = all.iter().find(|own| own.quantity == "depth").unwrap();
    // The mean of the middle 0.1 mm is 2.64 um.
    assert!((depth.measured / 2.64e-6 - 1.0).abs() < 0.04, "{depth:?}");
    assert!(depth.error().abs() < 0.06 && all.iter().all(|own| own.holds()), "{found}");
}

/// Pins whose depth does not grow with the distance give no coefficient, with the reason.
#[test]
fn tests_that_do_not_wear_by_the_law_are_rejected() {
    let found = validated("te67");
    let why = found.outcome.unwrap_err();
    assert!(why.contains("the wear goes with the distance to the power"), "{why}");
}

/// What was measured before the end of the run is predicted there: a ring's scar is 2^(-2/3) as deep at half of the distance, and 2^(-1/3) as
/// wide. Beyond the end nothing is predicted, without a test nothing is said.
#[test]
fn a_test_is_predicted_where_it_ended() {
    let (dir, runs) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    for name in ["case.toml", "block_1.csv"] {
        fs::copy(folder("cruzado").join(name), dir.path().join(name)).unwrap();
    }
    let set = fs::read_to_string(folder("cruzado").join("set.toml")).unwrap();
    let given = "[coefficient]\nsource = \"of others\"\nuncertainty = 0.2\n";
    fs::write(dir.path().join("set.toml"), format!("{set}{given}")).unwrap();
    let of = |rows: &str| {
        fs::write(dir.path().join("tests.csv"), rows).unwrap();
        let set = Set::read(dir.path()).unwrap();
        validate(&set, (runs.path(), None), &mut Until(None, vec![]))
    };
    let rows = "test,distance [m],file\nA,3600,block_1.csv\nB,1800,block_1.csv\nA,1800,\n";
    let swapped = of(rows).unwrap_err().to_string();
    assert!(swapped.contains("goes back"), "{swapped}");
    let found = of("test,distance [m],file\nA,3600,block_1.csv\nB,1800,block_1.csv\n").unwrap();
    let all = found.outcome.unwrap();
    let value = |test: &str, quantity: &str| {
        all.iter().find(|own| own.test == test && own.quantity == quantity).unwrap().predicted
    };
    for (quantity, exponent) in [("profile_x", 1.0), ("depth", 2.0 / 3.0), ("width", 1.0 / 3.0)] {
        let ratio = value("B", quantity) / value("A", quantity);
        assert!((ratio / 0.5f64.powf(exponent) - 1.0).abs() < 0.02, "{quantity}: {ratio}");
    }
    // The section goes with the coefficient, whose interval is 1.96 times 20 %.
    let half = all[0].halves[1];
    assert!((half / 0.392 - 1.0).abs() < 0.02, "{half}");
    let beyond = of("test,distance [m],file\nA,9000,block_1.csv\n").unwrap_err().to_string();
    assert!(beyond.contains("the run of the case ends at 3600"), "{beyond}");
    let unnamed = of("distance [m],file\n3600,block_1.csv\n").unwrap_err().to_string();
    assert!(unnamed.contains("a column `test` is needed"), "{unnamed}");
}
