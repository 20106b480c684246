//! Coefficients of tests that were made up by runs of their own, with readings that are off, are found again.

#[path = "../../archard-case/tests/framed/mod.rs"]
mod framed;

use std::error::Error as StdError;
use std::fmt::Write;
use std::path::Path;

use archard::simulation::history::{self, number};
use archard::simulation::{Observer, Report, worn_extent};
use archard_case::CaseFile;
use archard_case::measured::Table;
use archard_case::output::Claim;
use archard_case::verdict::Word;
use archard_lab::{Coefficient, Error, Exponent, Files, Fit, Following, Request, fit};

/// Numbers of a normal distribution, by Box and Muller.
struct Normal(fastrand::Rng);

impl Normal {
    fn draw(&mut self) -> f64 {
        let radius = (-2.0 * (1.0 - self.0.f64()).ln()).sqrt();
        radius * (std::f64::consts::TAU * self.0.f64()).cos()
    }
}

#[derive(Default)]
struct Rows(Vec<Vec<(String, f64)>>);

impl Observer for Rows {
    fn observe(&mut self, report: &Report<'_>) -> Result<(), Box<dyn StdError + Send + Sync>> {
        self.0.push(history::row(report));
        Ok(())
    }
}

fn published(name: &str, options: &[&str]) -> CaseFile {
    let path = framed::folder(name);
    let file = CaseFile::read(&path).unwrap();
    options.iter().fold(file, |file, option| file.set(*option))
}

/// How tests are made: what scatters between them, and by how much readings are off.
struct Made<'a> {
    file: CaseFile,
    /// The bodies with the median of their coefficients (1/Pa).
    bodies: &'a [(&'a str, f64)],
    /// Columns of the table, of the history, and the factor between them.
    columns: &'a [(&'a str, &'a str, f64)],
    tests: usize,
    seed: u64,
}

const SCATTER: f64 = 0.2;
const READING: f64 = 0.04;

impl Made<'_> {
    /// Tests, each a run with coefficients of its own, read four times.
    fn table(&self, progress: &str) -> String {
        let mut random = Normal(fastrand::Rng::with_seed(self.seed));
        let names: Vec<&str> = self.columns.iter().map(|column| column.0).collect();
        let mut text = format!("test,{progress},{}\n", names.join(","));
        for test in 0..self.tests {
            let with = |file: CaseFile, (body, median): &(&str, f64)| {
                let k = median * (SCATTER * random.draw()).exp();
                file.set(format!("body.{body}.wear.archard.coefficient=\"{k:e} 1/Pa\""))
            };
            let file = self.bodies.iter().fold(self.file.clone(), with);
            let mut rows = Rows::default();
            file.resolve().unwrap().case.build().unwrap().run(&mut [&mut rows]).unwrap();
            let count = rows.0.len() - 1;
            for reading in 1..=4 {
                let row = &rows.0[reading * count / 4];
                let mut cells = format!("{test},{}", row[0].1);
                for (_, column, factor) in self.columns {
                    let off = (READING * random.draw()).exp();
                    let _ = write!(cells, ",{}", number(row, column).unwrap() * factor * off);
                }
                let _ = writeln!(text, "{cells}");
            }
        }
        text
    }
}

/// Ends a fit at the first step of a run.
struct Until(Option<usize>, Vec<Option<f64>>);

impl Following for Until {
    fn begins(&mut self, run: usize, _: &str) {
        if self.0 == Some(run) {
            self.0 = Some(0);
        }
    }

    fn ended(&mut self, _: usize, _: &str, seconds: Option<f64>) {
        self.1.push(seconds);
    }

    fn observer(&mut self) -> &mut dyn Observer {
        self
    }
}

impl Observer for Until {
    fn observe(&mut self, _: &Report<'_>) -> Result<(), Box<dyn StdError + Send + Sync>> {
        if self.0 == Some(0) { Err("interrupted".into()) } else { Ok(()) }
    }
}

fn fitted(file: &CaseFile, text: &str, parameter: Option<&str>) -> Result<Fit, Error> {
    let dir = tempfile::tempdir().unwrap();
    fitted_in(dir.path(), file, (text, parameter), &mut Until(None, vec![]))
}

/// A fit that takes the wear at some keys from the case.
fn assuming(file: &CaseFile, text: &str, keys: &[&str]) -> Result<Fit, Error> {
    let dir = tempfile::tempdir().unwrap();
    let assumed: Vec<String> = keys.iter().map(|key| (*key).to_owned()).collect();
    let table = Table::read("tests.csv", text.as_bytes()).unwrap();
    let request = Request {
        parameters: &[],
        uncertain: &[],
        assumed: &assumed,
        files: Files { folder: dir.path(), columns: &[] },
        dir: dir.path(),
        store: None,
        following: &mut Until(None, vec![]),
    };
    fit(file, &table, request)
}

fn fitted_in(
    dir: &Path,
    file: &CaseFile,
    (text, parameter): (&str, Option<&str>),
    following: &mut dyn Following,
) -> Result<Fit, Error> {
    let table = Table::read("tests.csv", text.as_bytes()).unwrap();
    let files = Files { folder: dir, columns: &[] };
    let parameters: Vec<String> = parameter.into_iter().map(str::to_owned).collect();
    let parameters = &parameters;
    let request =
        Request { parameters, uncertain: &[], assumed: &[], files, dir, store: None, following };
    fit(file, &table, request)
}

/// The median lies in its interval, the interval is one of tests that scatter as these, and the law is not rejected.
fn assert_found(own: &Coefficient, median: f64) {
    let estimate = &own.estimate;
    let [low, high] = estimate.interval.unwrap();
    assert!(low < median && median < high, "{median:e}: {low:e} {high:e}");
    let [next_low, next_high] = estimate.next.unwrap();
    assert!(next_low < low && high < next_high);
    // By chance a deviation of few tests is a third to twice that of all.
    let between = estimate.between.unwrap();
    assert!((0.3 * SCATTER..2.2 * SCATTER).contains(&between), "{between}");
    for reading in estimate.readings.iter().flatten() {
        assert!(
            (0.5 * READING..2.0 * READING).contains(reading) || own.tests.len() < 4,
            "{reading}"
        );
    }
    assert_eq!(own.rejected(), None);
}

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

/// One coefficient takes one run that is long enough and what tells its errors. The diameter goes by the fourth root of k or
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

/// Poisson's ratio hardly changes any depth: no reading tells it.
#[test]
fn a_parameter_that_the_data_cannot_tell_is_refused() {
    let file = published("pin_on_disc", &["motion.sliding.step=\"25 mm\""]);
    let text = "test,distance_m,volume_mm3\nA,0.1,1e-4\nA,0.2,2e-4\n";
    let error = fitted(&file, text, Some("body.pin.material.poisson")).unwrap_err().to_string();
    assert!(error.contains("cannot tell"), "{error}");
}

/// What a fit that was ended has run is not run again, and what comes out is the same.
#[test]
fn a_fit_goes_on_where_it_was_ended() {
    let file = published("pin_on_disc", &["motion.sliding.step=\"25 mm\""]);
    let text =
        "test,distance_m,volume_mm3\nA,0.2,2.6e-4\nA,0.4,5.6e-4\nB,0.2,3.3e-4\nB,0.4,6.4e-4\n";
    let (dir, whole) = (tempfile::tempdir().unwrap(), fitted(&file, text, None).unwrap());
    assert!(whole.runs >= 3, "{}", whole.runs);
    let mut ended = Until(Some(3), vec![]);
    let error = fitted_in(dir.path(), &file, (text, None), &mut ended).unwrap_err();
    assert_eq!(
        error.to_string(),
        "interrupted after 2 runs, which are kept: the same call goes on behind them"
    );
    let mut again = Until(None, vec![]);
    let found = fitted_in(dir.path(), &file, (text, None), &mut again).unwrap();
    let before = again.1.iter().filter(|seconds| seconds.is_none()).count();
    assert_eq!((before, again.1.len()), (2, whole.runs));
    assert_eq!(found.json(), whole.json());
    assert!(!dir.path().join("kept").exists());
}

/// Two fits in one folder would write over each other: the folder is wrong, and nothing failed to converge.
#[test]
fn a_folder_in_use_is_refused() {
    let file = published("pin_on_disc", &["motion.sliding.step=\"25 mm\""]);
    let dir = tempfile::tempdir().unwrap();
    let _held = Claim::take(&dir.path().join("run")).unwrap();
    let text = "test,distance_m,volume_mm3\nA,0.4,5e-4\n";
    let error = fitted_in(dir.path(), &file, (text, None), &mut Until(None, vec![])).unwrap_err();
    assert!(matches!(error, Error::Folder(_)) && !error.is_of_convergence(), "{error}");
}

/// Runs that were kept are of the density they were made with, which no step depends on.
#[test]
fn runs_of_another_density_are_not_gone_on_with() {
    let file = published("pin_on_disc", &["motion.sliding.step=\"25 mm\""]);
    let of = |density: &str| file.clone().set(format!("body.pin.density=\"{density}\""));
    let text = "test,distance_m,mass_mg\nA,0.2,0.002\nA,0.4,0.0043\n";
    let dir = tempfile::tempdir().unwrap();
    let mut ended = Until(Some(3), vec![]);
    fitted_in(dir.path(), &of("7800 kg/m3"), (text, None), &mut ended).unwrap_err();
    let mut again = Until(None, vec![]);
    let found = fitted_in(dir.path(), &of("3900 kg/m3"), (text, None), &mut again).unwrap();
    assert!(again.1.iter().all(Option::is_some), "{:?}", again.1);
    assert_eq!(found.json(), fitted(&of("3900 kg/m3"), text, None).unwrap().json());
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
    // One reading tells k, and nothing of its error.
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
