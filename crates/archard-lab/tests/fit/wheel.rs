//! Wheels of known coefficients, worn by a run, measured with noise from another place, and fitted.

use std::fmt::Write;
use std::fs;
use std::ops::ControlFlow;
use std::path::Path;

use archard_case::measured::Table;
use archard_case::{CaseFile, Task};
use archard_lab::{Error, Files, Fit, Request, fit};

use super::made::{Normal, Until};

const CASE: &str = r#"
[body.wheel]
material = { young = "210 GPa", poisson = 0.28 }
profile.wheel = { standard = "S1002", radius = "460 mm" }
wear.archard.coefficient = "4e-15 1/Pa"
flange_wear.archard.coefficient = "4e-15 1/Pa"

[body.rail]
material = { young = "210 GPa", poisson = 0.28 }
profile.rail = { standard = "60E1", cant = "1:40" }

[friction.coulomb]
coefficient = 0.3

[frame]
elements = 16

[motion.wheel_rail]
wheel_load = "55 kN"
speed = "25 m/s"
route = "route.csv"
distance = "30000 km"
flange_from = "-26 mm"
"#;

const ROUTE: &str = "share,shift [mm],yaw [mrad],curvature [1/m]\n\
    0.5,0,0,0\n0.25,2,0.8,0.0001\n0.2,-2,-0.8,-0.0001\n0.05,6.5,3,0.002\n";

const TREAD: &str = "body.wheel.wear.archard.coefficient";
const FLANGE: &str = "body.wheel.flange_wear.archard.coefficient";
/// Standard deviation (mm) of a point, as those of MiniProf.
const NOISE: f64 = 5e-3;

/// The case in a folder with its route.
fn case(dir: &Path) -> CaseFile {
    fs::write(dir.join("route.csv"), ROUTE).unwrap();
    let path = dir.join("case.toml");
    fs::write(&path, CASE).unwrap();
    CaseFile::read(&path).unwrap()
}

/// Columns (mm) of the profile of a wheel that ran with these coefficients, with noise, turned and shifted as a whole.
fn worn(file: &CaseFile, [tread, flange]: [f64; 2], seed: u64) -> String {
    let file = file.clone().set(format!("{TREAD}={tread:e} 1/Pa"));
    let file = file.set(format!("{FLANGE}={flange:e} 1/Pa"));
    let Ok(Task::WheelRail(resolved)) = file.task() else { panic!("no wheel") };
    let prepared = resolved.case.prepare().unwrap();
    let travelled = prepared.travel(|_, _| ControlFlow::Continue(())).unwrap();
    let wheel = &travelled.worn[0].wheel;
    eprintln!("deepest {:.3} mm", 1e3 * wheel.depths().into_iter().fold(0.0, f64::max));
    let mut random = Normal(fastrand::Rng::with_seed(seed));
    let mut text = "y,z\n".to_owned();
    for [y, z] in wheel.profile().points {
        let [y, z] = [1e3 * y + NOISE * random.draw(), 1e3 * z + NOISE * random.draw()];
        let (sin, cos) = 2e-3_f64.sin_cos();
        let [y, z] = [y * cos - z * sin + 0.1, y * sin + z * cos - 0.4];
        writeln!(text, "{y:.4},{z:.4}").unwrap();
    }
    text
}

fn fitted(file: &CaseFile, dir: &Path, table: &str, assumed: &[String]) -> Result<Fit, Error> {
    let table = Table::read("wheels.csv", table.as_bytes()).unwrap();
    fit(
        file,
        &table,
        Request {
            parameters: &[],
            uncertain: &[],
            assumed,
            files: Files { folder: dir, columns: &[] },
            dir,
            store: None,
            following: &mut Until(None, vec![]),
        },
    )
}

/// A wheel that ran with one coefficient on its tread and another on its flange, neither of them that of the case, tells both to within the
/// intervals that are stated.
#[test]
fn a_worn_profile_tells_tread_and_flange() {
    let dir = tempfile::tempdir().unwrap();
    let file = case(dir.path());
    let truth = [8e-15, 2.5e-15];
    fs::write(dir.path().join("worn.csv"), worn(&file, truth, 3)).unwrap();
    let table = "test,distance [km],file\nwheel 1,30000,worn.csv\n";
    let found = fitted(&file, dir.path(), table, &[]).unwrap();
    eprintln!("{found}");
    for (coefficient, truth) in found.coefficients.iter().zip(truth) {
        let [low, high] = coefficient.estimate.interval.unwrap();
        assert!((low..=high).contains(&truth), "{} {low:e} {high:e}", coefficient.key);
        // What elements of the runs do to it the profile has, too: its points are left, and the quarter at which rounds end.
        let part = |source: &str| {
            let own = coefficient.estimate.budget.iter().find(|own| own.0 == source);
            own.unwrap_or_else(|| panic!("{source}")).1
        };
        let (readings, runs) = (part("readings"), part("elements and steps of the runs"));
        let off = (coefficient.estimate.median / truth).ln();
        assert!(off.abs() < 3.0 * readings + 0.25 * runs, "{off} {readings} {runs}");
        assert!(readings < 0.03 && runs < 0.15, "{readings} {runs}");
    }
    let [tread, flange] = &found.coefficients[..] else { panic!("{}", found.coefficients.len()) };
    assert_eq!((&*tread.key, &*flange.key), (TREAD, FLANGE));
}

/// What cannot be fitted says why, before anything runs.
#[test]
fn wheels_that_cannot_be_fitted_say_why() {
    let dir = tempfile::tempdir().unwrap();
    let file = case(dir.path());
    let head = "test,distance [km],file\n";
    fs::write(dir.path().join("odd.csv"), "y,z\n0,a\n").unwrap();
    let rail = file.clone().set("body.rail.wear.archard.coefficient=1e-15 1/Pa");
    let rail = rail.set("motion.wheel_rail.axles=1e6");
    let unworn = file.clone().set("body.wheel.flange_wear=").set("body.wheel.wear=");
    let unworn = unworn.set("motion.wheel_rail.distance=").set("motion.wheel_rail.flange_from=");
    let both = file.clone().set("motion.wheel_rail.side=both");
    for (file, table, expected) in [
        (&file, format!("{head}1,30000,none.csv\n"), "line 2: cannot read `none.csv`"),
        (&file, format!("{head}1,30000,odd.csv\n"), "line 2: `odd.csv`: line 2"),
        (&file, format!("{head}1,0,odd.csv\n"), "`distance` has to be greater than zero"),
        (&file, "test,distance [km]\n1,30000\n".to_owned(), "no column `file`"),
        (&file, "test,file\n1,odd.csv\n".to_owned(), "distance"),
        (&both, format!("{head}1,30000,odd.csv\n"), "no column `side`"),
        (&rail, format!("{head}1,30000,odd.csv\n"), "--assume body.rail.wear"),
        (&unworn, format!("{head}1,30000,odd.csv\n"), "no wear law"),
    ] {
        let said = fitted(file, dir.path(), &table, &[]).err();
        let said = said.unwrap_or_else(|| panic!("{table} passes")).to_string();
        assert!(said.contains(expected), "{table}: {said}");
    }
}
