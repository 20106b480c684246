//! Tables, keys and readings that are refused, with what to do.

use archard_case::measured::Table;
use archard_lab::{Files, Request, fit};

use super::made::{Until, assuming, fitted, published};

/// Wear of a body without readings is taken from the case where that is said, whatever its law and what is measured.
#[test]
fn a_coefficient_that_no_test_tells_is_named() {
    let pin = "depth_pin_um";
    let power = "body.disc.wear.archard=";
    let law = "body.disc.wear.power={coefficient = \"1e-16 m^2/N\", pressure_exponent = 1.5, reference_pressure = \"1 MPa\"}";
    for (case, options, column, key) in [
        ("pin_on_disc_both", &[][..], pin, "body.disc.wear.archard.coefficient"),
        ("pin_on_disc_both", &[][..], "volume_disc_mm3", "body.pin.wear.archard.coefficient"),
        ("pin_on_disc_track", &[][..], "diameter_ball_um", "body.disc.wear.archard.coefficient"),
        ("twin_disc", &[][..], "section_disc1_mm2", "body.disc2.wear.archard.coefficient"),
        ("pin_on_disc_both", &[power, law][..], pin, "body.disc.wear.power.coefficient"),
    ] {
        let far = if case == "twin_disc" { "revolutions" } else { "distance_m" };
        let file = published(case, options);
        let text = format!("test,{far},{column}\nA,0.2,1\nA,0.4,1.5\n");
        let error = fitted(&file, &text, None).unwrap_err().to_string();
        for said in [format!("no reading that tells `{key}`"), format!("add --assume {key} to")] {
            assert!(error.contains(&said), "{case}: {error}");
        }
    }
    // A coating and what is below it are two of them, whichever is fitted.
    let coated = published("coated_disc", &[]);
    let [below, layer] = ["body.disc.wear", "body.disc.layers.0.wear"]
        .map(|table| format!("{table}.archard.coefficient"));
    for (parameter, named) in [(&below, &layer), (&layer, &below)] {
        let text = "test,distance_m,depth_disc_um\nA,10,0.1\nA,20,0.2\n";
        let error = fitted(&coated, text, Some(parameter)).unwrap_err().to_string();
        assert!(error.contains(&format!("no reading that tells `{named}`")), "{error}");
        assert!(!error.contains(&format!("tells `{parameter}`")), "{error}");
    }
    let coarse = ["frame.elements=[24, 24]", "motion.sliding.step=50 mm"];
    let file = published("pin_on_disc_both", &coarse);
    let text = "test,distance_m,volume_pin_mm3\nA,0.2,1.4e-4\nA,0.4,2.7e-4\n";
    let disc = "body.disc.wear.archard.coefficient";
    // Said on the command line, a value is told.
    for told in [disc.to_owned(), format!("{disc}=1e-13 1/Pa")] {
        let found = assuming(&file, text, &[&told]).unwrap();
        let k = found.coefficients[0].estimate.median;
        assert!((k / 6.7e-14 - 1.0).abs() < 0.05, "{k:e}");
    }
}

#[test]
fn what_cannot_be_fitted_is_told_with_its_line() {
    let file = published("pin_on_disc", &[]);
    let both = published("pin_on_disc_both", &[]);
    let head = "test,distance_m,depth_um\n";
    let on = |rows: &str| fitted(&file, &format!("{head}{rows}"), None).unwrap_err().to_string();
    for (rows, said) in [
        ("A,0.2,1\nA,0.1,2\n", "tests.csv, line 3: `distance` goes back within test `A`"),
        ("A,0.1,-1\n", "tests.csv, line 2: `depth` is negative"),
        ("A,-0.1,1\n", "line 2: `distance` is negative"),
        ("A,0.1,0\n", "line 2: `depth` is zero after some wear"),
        (
            "A,0.1,1\nA,0.6,2\n",
            "line 3: `distance` is 0.6 (SI) and the run of the case ends at 0.5",
        ),
        (",0.1,1\n", "line 2: the column `test` needs a name"),
        ("A,0,1\n", "no reading tells any wear"),
    ] {
        let error = on(rows);
        assert!(error.contains(said), "{error}");
    }
    let whole = |text: &str, said: &str| {
        let error = fitted(&file, text, None).unwrap_err().to_string();
        assert!(error.contains(said), "{error}");
    };
    whole("distance_m,depth_um\n0.1,1\n0.2,2\n", "a column `test` is needed");
    whole("test,depth_um\nA,1\n", "a column `distance [m]` is needed");
    whole("test,distance_m,tiefe_um\nA,0.1,1\n", "nothing that wears was measured");
    whole("test,distance_m,depth_N\nA,0.1,1\n", "expected a length");
    whole("test,distance_m,depth\nA,0.1,1\n", "has no unit: title it like `depth [mm]`");
    whole("test,distance_m,mass_mg\nA,0.1,1\n", "body.pin.density");
    whole("test,distance_m,section_mm2\nA,0.1,1\n", "do not tell the `section`");
    whole("test,distance_m,depth_disc_um\nA,0.1,1\n", "`disc`, which does not wear");
    let error = fitted(&both, &format!("{head}A,0.1,1\n"), None).unwrap_err().to_string();
    assert!(error.contains("name it `depth_pin` or `depth_disc`"), "{error}");
    let key = "body.pin.profile.sphere.radii";
    let error = fitted(&file, &format!("{head}A,0.1,1\n"), Some(key)).unwrap_err().to_string();
    assert!(error.contains("is no number in the case"), "{error}");
}

/// Poisson's ratio hardly changes any depth: no reading gives it.
#[test]
fn a_parameter_that_the_data_cannot_tell_is_refused() {
    let file = published("pin_on_disc", &["motion.sliding.step=\"25 mm\""]);
    let text = "test,distance_m,volume_mm3\nA,0.1,1e-4\nA,0.2,2e-4\n";
    let error = fitted(&file, text, Some("body.pin.material.poisson")).unwrap_err().to_string();
    assert!(error.contains("cannot tell"), "{error}");
}

/// Tables as people hand them in by mistake: each is refused in words, or said to be doubtful.
#[test]
fn hostile_tables_are_told() {
    let file = published("pin_on_disc", &["motion.sliding.step=\"25 mm\""]);
    let refused = |text: &str| fitted(&file, text, None).unwrap_err().to_string();
    for (text, said) in [
        // Letters, no number, infinity.
        (
            "test,distance_m,volume_mm3\nA,0.4,NaN\n",
            "`NaN` in the column `volume_mm3` is not a finite",
        ),
        (
            "test,distance_m,volume_mm3\nA,inf,1e-4\n",
            "`inf` in the column `distance_m` is not a finite",
        ),
        // Units in a second line.
        ("test,distance,volume\n,m,mm3\nA,0.4,1e-4\n", "has no unit: title it like"),
        // No wear at all, no reading at all.
        ("test,distance_m,volume_mm3\nA,0.2,0\nA,0.4,0\n", "is zero after some wear"),
        ("test,distance_m,volume_mm3\nA,0.2,\nA,0.4,\n", "no reading tells any wear"),
        ("test,distance_m,volume_mm3,u_volume_mm3\nA,0.4,1e-4,-1e-5\n", "greater than zero"),
        ("test,load_N,distance_m,volume_mm3\nA,-5,0.4,1e-4\n", "load has to be greater than zero"),
        // A scar no wider than that of the unworn contact.
        ("test,distance_m,width_mm\nA,0.2,0.05\nA,0.4,0.06\n", "test `A`"),
    ] {
        let error = refused(text);
        assert!(error.contains(said), "{text}: {error}");
    }
    let whole = |text: &str| fitted(&file, text, None).unwrap();
    // Tests that have nothing to do with each other: the interval says so.
    let wide = whole("test,distance_m,volume_mm3\nA,0.4,2e-5\nB,0.4,6e-4\n");
    let [low, high] = wide.coefficients[0].estimate.interval.unwrap();
    assert!(high / low > 1e6, "{wide}");
    // Pasted twice.
    let twice = whole(
        "test,distance_m,volume_mm3\nA,0.2,2.6e-4\nA,0.4,5.6e-4\nB,0.2,2.6e-4\nB,0.4,5.6e-4\nB,0.4,5.6e-4\n",
    );
    assert!(twice.to_string().contains("lines 5 and 6 are the same"), "{twice}");
    let pasted = whole(
        "test,distance_m,volume_mm3\nA,0.2,2.6e-4\nA,0.4,5.6e-4\nB,0.2,2.6e-4\nB,0.4,5.6e-4\n",
    );
    assert!(
        pasted.to_string().contains("the tests `A` and `B` have the same readings"),
        "{pasted}"
    );
    // One reading gives k, and nothing of its error.
    let one = whole("\u{feff}Test;Distance [mm];Volume / mm^3\nA;400;0,00056\n");
    assert_eq!(one.coefficients[0].estimate.interval, None);
    assert!(one.to_string().contains("without an interval"), "{one}");
}

#[test]
fn uncertainties_are_checked_before_anything_runs() {
    let file = published("pin_on_disc", &[]);
    let table = Table::read("tests.csv", b"test,distance_m,volume_mm3\nA,0.4,5e-4\n").unwrap();
    let dir = tempfile::tempdir().unwrap();
    for (key, relative, said) in [
        ("motion.sliding.load", 5.0, "between 0 % and 50 %"),
        ("motion.sliding.load", f64::NAN, "between 0 % and 50 %"),
        ("body.pin.color", 0.1, "is no number in the case"),
        ("motion.sliding.distance", 0.1, "is that of `distance`"),
    ] {
        let uncertain = [(key.to_owned(), relative)];
        let mut following = Until(Some(1), vec![]);
        let request = Request {
            parameters: &[],
            uncertain: &uncertain,
            assumed: &[],
            files: Files { folder: dir.path(), columns: &[] },
            dir: dir.path(),
            store: None,
            following: &mut following,
        };
        let error = fit(&file, &table, request).unwrap_err().to_string();
        assert!(error.contains(said), "{error}");
    }
}
