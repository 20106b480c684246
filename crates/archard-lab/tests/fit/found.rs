//! Coefficients that are found again in studies made up by runs.

use std::error::Error as StdError;
use std::fmt::Write;

use archard::simulation::{Observer, Report, worn_extent};
use archard_case::CaseFile;
use archard_case::measured::Table;
use archard_case::verdict::Word;
use archard_lab::{Error, Exponent, Files, Request, fit};

use super::made::{Made, Until, assert_found, assuming, fitted, published};

const FAR_OFF: &str = "body.pin.wear.archard.coefficient=\"3e-15 1/Pa\"";

/// A case with an accuracy is fitted on the elements that it takes: its coefficient is that of fine elements and short steps.
#[test]
fn an_accuracy_is_settled_once() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/pin_on_disc");
    let asked = CaseFile::read(path.as_ref()).unwrap();
    let fine = ["frame.elements=[120, 120]", "motion.sliding.step=2.5 mm"];
    let fine = published("pin_on_disc", &fine);
    let text = "test,distance_mm,depth_pin_um\nA,250,1.4\nA,500,2.0\nB,500,2.3\nC,500,1.9\n";
    let [asked, fine] = [asked, fine].map(|file| fitted(&file, text, None).unwrap());
    assert_eq!([asked.runs, fine.runs], [4; 2]);
    let [asked, fine] = [asked, fine].map(|fit| fit.coefficients[0].estimate.median);
    assert!((asked / fine - 1.0).abs() < 0.01, "{asked:e} {fine:e}");
}

/// What a fit cannot use is refused before the elements are settled, and who interrupts that is told so.
#[test]
fn an_accuracy_is_settled_for_what_can_be_fitted() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/pin_on_disc");
    let asked = CaseFile::read(path.as_ref()).unwrap();
    let tried = |uncertain: &[(String, f64)], text: &str| {
        let dir = tempfile::tempdir().unwrap();
        let table = Table::read("tests.csv", text.as_bytes()).unwrap();
        let files = Files { folder: dir.path(), columns: &[] };
        let following = &mut Until(Some(0), vec![]);
        let dir = dir.path();
        let request = Request {
            parameters: &[],
            uncertain,
            assumed: &[],
            files,
            dir,
            store: None,
            following,
        };
        fit(&asked, &table, request).unwrap_err()
    };
    let text = "test,distance_mm,depth_pin_um\nA,500,2.0\nB,500,2.3\n";
    let stopped = tried(&[], text);
    assert!(matches!(stopped, Error::Stopped { runs: 0, .. }), "{stopped}");
    let unknown = tried(&[], "test,distance_mm,depth_ball_um\nA,500,2.0\n");
    assert!(matches!(unknown, Error::Mismatch(_)), "{unknown}");
    let uncertain = tried(&[("motion.sliding.speed".to_owned(), 0.1)], text);
    assert!(uncertain.to_string().contains("`motion.sliding.speed` is no number"), "{uncertain}");
}

/// From a guess forty times too small, by depths, volumes and the diameter of the scar.
#[test]
fn a_pin_is_fitted() {
    let columns =
        [("depth_um", "wear_depth_pin_m", 1e6), ("volume_mm3", "worn_volume_pin_m3", 1e9)];
    let file = published("pin_on_disc", &[]);
    let made = Made {
        file: file.clone(),
        bodies: &[("pin", 1.33e-13)],
        columns: &columns,
        tests: 5,
        seed: 1,
    };
    let text = made.table("distance_m");
    let found = fitted(&file.clone().set(FAR_OFF), &text, None).unwrap();
    assert!(found.by_k_s);
    assert_found(&found.coefficients[0], 1.33e-13);
    // Where it began makes no difference.
    let again = fitted(&file, &text, None).unwrap();
    let [one, other] = [&found, &again].map(|fit| fit.coefficients[0].estimate.median);
    assert!((one / other - 1.0).abs() < 1e-3, "{one:e} {other:e}");
}

/// The diameter of a scar at the end of a run, as `fit` reads it: the geometric mean of both extents.
struct Scar(usize, f64);

impl Observer for Scar {
    fn observe(&mut self, report: &Report<'_>) -> Result<(), Box<dyn StdError + Send + Sync>> {
        let [along, across] = worn_extent(report, self.0).unwrap_or_default();
        self.1 = (along * across).sqrt();
        Ok(())
    }
}

fn scar(file: &CaseFile, body: usize) -> f64 {
    let mut scar = Scar(body, 0.0);
    file.resolve().unwrap().case.build().unwrap().run(&mut [&mut scar]).unwrap();
    scar.1
}

/// One coefficient takes one run that is long enough and what gives its errors. The diameter depends on the fourth root of k or
/// less: 2 % of k is half a per cent of it.
#[test]
fn a_pin_is_fitted_by_the_diameter_of_its_scar() {
    let file = published("pin_on_disc", &["motion.sliding.step=\"10 mm\""]);
    let diameter = 1e6 * scar(&file, 0);
    let text =
        format!("test,distance_mm,diameter_um\nA,500,{}\nB,500,{diameter}\n", 1.02 * diameter);
    let found = fitted(&file.clone().set(FAR_OFF), &text, None).unwrap();
    let k = found.coefficients[0].estimate.tests[1].1;
    assert!((k / 1.33e-13 - 1.0).abs() < 0.02, "{k:e}");
    assert_eq!(found.unsettled, None);
    assert!(found.runs <= 6, "{}", found.runs);
}

/// A ball on a track whose own wear the case gives: its coefficient is found from its scar, which the track shapes.
#[test]
fn a_ball_on_a_track_that_wears_is_fitted_by_its_scar() {
    let coarse = [
        "frame.elements=[24, 24]",
        "motion.sliding.tolerance=0.01",
        "motion.sliding.distance=100 m",
    ];
    let file = published("pin_on_disc_track", &coarse);
    let key = "body.ball.wear.archard.coefficient";
    let of = |k: f64| file.clone().set(format!("{key}=\"{k:e} 1/Pa\""));
    let true_k = 3e-16;
    let diameter = 1e6 * scar(&of(true_k), 0);
    let text = format!("test,distance_m,diameter_ball_um\nA,100,{diameter}\nB,100,{diameter}\n");
    let found =
        assuming(&of(2.5 * true_k), &text, &["body.disc.wear.archard.coefficient"]).unwrap();
    let said = found.to_string();
    assert!(said.contains("as in the case: no reading determines it"), "{said}");
    let k = found.coefficients[0].estimate.median;
    assert!((k / true_k - 1.0).abs() < 0.03, "{k:e}");
    assert!(!found.by_k_s && found.runs <= 24, "{}", found.runs);
}

/// A fit has one verdict: the worst of what its exponents, its rounds and its runs say, wherever it is read.
#[test]
fn a_fit_has_one_verdict() {
    let file = published("pin_on_disc", &["motion.sliding.step=\"25 mm\""]);
    let text = "test,distance_m,volume_mm3\nA,0.2,2.6e-4\nA,0.4,5.6e-4\nB,0.2,3.3e-4\nB,0.4,6.4e-4\nC,0.2,3e-4\nC,0.4,6e-4\n";
    let mut found = fitted(&file, text, None).unwrap();
    found.doubts.clear();
    let exponent = |law: f64, value: f64, half: f64, p: f64| {
        Some(Exponent { value, law, interval: [value - half, value + half], p })
    };
    // Within the interval, within one that holds everything, and beyond it.
    let judged = |law: f64| {
        [
            (exponent(law, law + 0.02, 0.1, 0.6), Word::Good),
            (exponent(law, law - 0.57, 1.2, 0.2), Word::Doubtful),
            (exponent(law, law - 0.57, 0.1, 1e-4), Word::Wrong),
        ]
    };
    let none = [(None, Word::Doubtful)];
    for (distance, by_distance) in judged(1.0).into_iter().chain(none) {
        for (loads, by_load) in judged(0.0).into_iter().chain([(None, Word::Good)]) {
            for (doubts, by_doubts) in
                [(vec![], Word::Good), (vec!["few".to_owned()], Word::Doubtful)]
            {
                let estimate = &mut found.coefficients[0].estimate;
                (estimate.distance, estimate.loads) = (distance, loads);
                found.doubts = doubts;
                let word = by_distance.max(by_load).max(by_doubts);
                assert_eq!(found.verdict().word(), word, "{found}");
                assert_eq!(found.json()["verdict"]["word"], word.text());
                assert_eq!(found.rejected().is_some(), word == Word::Wrong);
                let said = found.to_string();
                assert!(said.contains(&format!("verdict           {} (", word.text())), "{said}");
                for line in said.lines().filter(|line| line.contains("accepted")) {
                    assert!(!line.contains("doubtful"), "{line}");
                }
            }
        }
    }
}

/// Volumes follow k F s of each body, whatever the other does.
#[test]
fn both_bodies_are_fitted() {
    let columns = [
        ("volume_pin_mm3", "worn_volume_pin_m3", 1e9),
        ("volume_disc_mm3", "worn_volume_disc_m3", 1e9),
    ];
    let bodies = [("pin", 8.87e-14), ("disc", 4.435e-14)];
    let file = published("pin_on_disc_both", &[]);
    let made = Made { file: file.clone(), bodies: &bodies, columns: &columns, tests: 6, seed: 4 };
    let found = fitted(&file, &made.table("distance_m"), None).unwrap();
    assert_eq!(found.coefficients.len(), 2);
    for (own, (_, median)) in found.coefficients.iter().zip(bodies) {
        assert_found(own, median);
        let other = own.estimate.budget.iter().find(|part| part.0.contains("other body")).unwrap();
        assert!(other.1 < 1e-3, "{other:?}");
    }
}

/// Twin discs by their worn sections, over revolutions.
#[test]
fn twin_discs_are_fitted() {
    let columns = [
        ("section_disc1_mm2", "worn_section_disc1_m2", 1e6),
        ("section_disc2_mm2", "worn_section_disc2_m2", 1e6),
    ];
    let bodies = [("disc1", 1.333333e-12), ("disc2", 0.666667e-12)];
    let coarse = ["frame.elements=[21, 41]", "motion.rolling.tolerance=0.01"];
    let file = published("twin_disc", &coarse);
    let made = Made { file: file.clone(), bodies: &bodies, columns: &columns, tests: 4, seed: 5 };
    let found = fitted(&file, &made.table("revolutions"), None).unwrap();
    for (own, (_, median)) in found.coefficients.iter().zip(bodies) {
        assert_found(own, median);
    }
}

/// Fretting goes through jumps over cycles: each k is run by itself.
#[test]
fn fretting_is_fitted_by_runs_of_its_own() {
    let columns = [("volume_cylinder_mm3", "worn_volume_cylinder_m3", 1e9)];
    let bodies = [("cylinder", 1.9e-14)];
    let file = published("mccoll_fretting", &["frame.elements=80"]);
    let made = Made { file: file.clone(), bodies: &bodies, columns: &columns, tests: 4, seed: 3 };
    let key = "body.cylinder.wear.archard.coefficient";
    let from = file.set(format!("{key}=\"3e-8 1/MPa\""));
    let found = assuming(&from, &made.table("cycles"), &["body.flat.wear.archard.coefficient"]);
    let found = found.unwrap();
    assert_eq!(found.coefficients[0].key, key);
    assert!(!found.by_k_s);
    assert!(found.runs > 8, "{}", found.runs);
    assert_found(&found.coefficients[0], 1.9e-14);
}

/// Loads of their own are runs of their own: k that goes with the load is told from one that does not.
#[test]
fn a_coefficient_that_goes_with_the_load_is_rejected() {
    let text = |exponent: f64| {
        let mut text = "test,load [N],distance_m,volume_mm3\n".to_owned();
        for (test, (load, off)) in
            [(5.0, 1.0), (5.0, 1.1), (10.0, 1.05), (10.0, 0.95), (20.0, 1.0), (20.0, 1.1)]
                .into_iter()
                .enumerate()
        {
            for distance in [0.1, 0.2, 0.3] {
                let k = 1.33e-4 * off * (load / 10.0_f64).powf(exponent);
                let _ = writeln!(text, "{test},{load},{distance},{}", k * load * distance);
            }
        }
        text
    };
    let file = published("pin_on_disc", &[]);
    let constant = fitted(&file, &text(0.0), None).unwrap();
    assert_eq!(constant.rejected(), None);
    let growing = fitted(&file, &text(1.0), None).unwrap();
    let why = growing.rejected().unwrap();
    assert!(why.contains("from 5.000 N to 20.00 N it would have to grow"), "{why}");
    assert!(growing.to_string().contains("k               none"), "{growing}");
}
