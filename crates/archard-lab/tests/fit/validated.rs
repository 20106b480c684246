//! Measured sets: what their profiles tell, and what is predicted of each test by the others.

use std::path::Path;

use super::made::Until;
use archard_lab::validate::{Set, Validated, validate};

fn validated(name: &str) -> Validated {
    let dir = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../validation").join(name);
    let runs = tempfile::tempdir().unwrap();
    let found =
        validate(&Set::read(&dir).unwrap(), (runs.path(), None), &mut Until(None, vec![])).unwrap();
    println!("{found}");
    found
}

/// Three worn blocks: sections by a plane through what lies beside the scars, by hand; depth and width of each predicted by the others.
#[test]
fn worn_blocks_are_predicted_by_each_other() {
    let found = validated("cruzado");
    let all = found.outcome.as_ref().unwrap();
    assert_eq!(all.len(), 9);
    let of =
        |quantity: &'static str| all.iter().filter(move |own| own.quantity.starts_with(quantity));
    for (own, known) in of("profile").zip([0.0829e-6, 0.0690e-6, 0.0857e-6]) {
        assert!((own.measured / known - 1.0).abs() < 0.02, "{own:?}");
    }
    assert!(all.iter().all(|own| own.holds()), "{found}");
    // At the section of the test itself; the second scar is skew.
    for (quantity, most) in [("depth", [0.06; 3]), ("width", [0.04, 0.06, 0.04])] {
        for (own, most) in of(quantity).zip(most) {
            let error = own.at_own_section.unwrap() / own.measured - 1.0;
            assert!(error.abs() < most, "{own:?}");
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
