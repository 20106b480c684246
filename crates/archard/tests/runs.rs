//! Cases run in ways the published ones are not, against closed forms and identities.

mod common;

use std::fmt::Write;
use std::path::Path;

use approx::assert_relative_eq;
use archard::case::{CaseFile, Solves};
use archard::closed_form::Hertz;

use common::Rows;

/// The rows of a published case with options.
fn run(case: &str, options: &[&str]) -> Rows {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases").join(case);
    let file = CaseFile::read(&folder).unwrap();
    let file = options.iter().fold(file, |file, option| file.set(*option));
    let resolved = file.resolve().unwrap_or_else(|problems| {
        let lines: Vec<String> = problems.iter().map(|one| file.describe(one)).collect();
        panic!("{}", lines.join("\n"))
    });
    let mut rows = Rows::default();
    resolved.case.build().unwrap().run(&mut [&mut rows]).unwrap();
    rows
}

/// All numbers of the last rows agree to the solver's accuracy.
fn assert_same(one: &Rows, other: &Rows) {
    for name in ["load_N", "approach_m", "peak_pressure_Pa", "contact_area_m2", "wear_depth_m"] {
        assert_relative_eq!(one.last(name), other.last(name), max_relative = 1e-6);
    }
}

/// The whole distance in one step, by both solvers: pressures change so much that the contact passes
/// through much larger ones on the way. In rigid terms the step wears the volume k F s off a
/// paraboloid, as many short ones do.
#[test]
fn one_step_may_be_the_whole_run() {
    for solver in ["conjugate_gradient", "uzawa"] {
        let tolerance = format!("solver.{solver}={{ tolerance = 1e-6 }}");
        let rows = run("pin_on_disc", &["motion.sliding.step=500 mm", &tolerance]);
        assert_relative_eq!(rows.last("wear_depth_m"), 2.078e-6, max_relative = 0.05);
        assert_relative_eq!(
            rows.last("worn_volume_pin_m3"),
            1.33e-13 * 10.2 * 0.5,
            max_relative = 1e-5
        );
    }
}

/// What `check` promises: exact for fixed steps, within a quarter for steps chosen by error.
#[test]
fn the_forecast_of_solves_is_right() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/pin_on_disc");
    let promised = |options: &[&str]| {
        let file = CaseFile::read(&folder).unwrap();
        let file = options.iter().fold(file, |file, option| file.set(*option));
        file.resolve().unwrap_or_else(|_| panic!("a case that holds")).forecast.solves
    };
    let by_error = ["motion.sliding.step=", "motion.sliding.tolerance=1e-2"];
    let strict = ["motion.sliding.step=", "motion.sliding.tolerance=3e-4"];
    for options in [&[][..], &by_error, &strict] {
        let solves = run("pin_on_disc", options).last("solves");
        match promised(options) {
            Solves::Exactly(promised) => assert_eq!(promised as f64, solves),
            Solves::AtLeast(promised) => assert!(promised as f64 <= solves),
            Solves::About(promised) => {
                assert_relative_eq!(promised as f64, solves, max_relative = 0.25)
            }
        }
    }
}

/// The same with steps chosen by error, which have to end although the pressure fades to nothing.
#[test]
fn sliding_at_constant_approach_by_error_ends() {
    let by_error = |tolerance: &str| {
        let options = [
            "motion.sliding.load=",
            "motion.sliding.approach=1 um",
            "motion.sliding.step=",
            tolerance,
        ];
        run("pin_on_disc", &options)
    };
    let depths =
        ["motion.sliding.tolerance=1e-2", "motion.sliding.tolerance=1e-3"].map(|tolerance| {
            let rows = by_error(tolerance);
            assert!(rows.last("solves") < 500.0, "{}", rows.last("solves"));
            rows.last("wear_depth_m")
        });
    assert_relative_eq!(depths[0], depths[1], max_relative = 1e-2);
}

/// At constant approach the load falls as the pin wears, the volume is the coefficient times the
/// load summed over the distance, and the bodies part where the depth has come to the approach.
#[test]
fn sliding_at_constant_approach_wears_until_the_bodies_part() {
    let rows = run(
        "pin_on_disc",
        &[
            "motion.sliding.load=",
            "motion.sliding.approach=0.44 um",
            "motion.sliding.distance=500 mm",
        ],
    );
    let loads = rows.column("load_N");
    assert!(loads.windows(2).all(|pair| pair[1] < pair[0]));
    let load_distance: f64 = loads[1..].iter().map(|load| 5e-3 * load).sum();
    assert_relative_eq!(
        rows.last("worn_volume_pin_m3"),
        1.33e-13 * load_distance,
        max_relative = 1e-10
    );
    assert!(rows.column("wear_depth_m").iter().all(|depth| *depth < 0.44e-6));
    // The deepest pairs are half an element, 0.02 mm along x and y, from the apex of the ball.
    let depth = 0.44e-6 - (2.0 * 0.02e-3 * 0.02e-3) / (2.0 * 0.05);
    assert_relative_eq!(rows.last("wear_depth_m"), depth, max_relative = 1e-3);
}

/// Below its bound the explicit scheme converges to the implicit one: they differ by the steps.
#[test]
fn explicit_and_implicit_steps_enclose_the_depth() {
    let steps = ["motion.sliding.step=2.5 mm", "motion.sliding.distance=100 mm"];
    let implicit = run("pin_on_disc", &steps);
    let explicit = run("pin_on_disc", &[&steps[..], &["motion.sliding.scheme=explicit"]].concat());
    let depth = |rows: &Rows| rows.last("wear_depth_m");
    assert!(depth(&explicit) > depth(&implicit));
    assert_relative_eq!(depth(&explicit), depth(&implicit), max_relative = 0.01);
    for rows in [&implicit, &explicit] {
        let volume = 1.33e-13 * 10.2 * 0.1; // k F s
        assert_relative_eq!(rows.last("worn_volume_pin_m3"), volume, max_relative = 1e-10);
    }
}

/// Heights of the sphere in a file, every 10 um and to a picometre, stand for the sphere.
#[test]
fn a_table_of_a_sphere_is_a_sphere() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("ball.csv");
    let mut text = "x_mm,y_mm,z_um\n".to_owned();
    let places = || (-65..=65).map(|i| 0.01 * f64::from(i));
    for (x, y) in places().flat_map(|y| places().map(move |x| (x, y))) {
        let height = 1e3 * ((50.0 * 50.0 - x * x - y * y).sqrt() - 50.0);
        writeln!(text, "{x:.2},{y:.2},{height:.6}").unwrap();
    }
    std::fs::write(&path, text).unwrap();
    let table = format!("body.pin.profile={{table={{file='{}'}}}}", path.display());
    let steps = "motion.sliding.step=20 mm";
    assert_same(&run("pin_on_disc", &[&table, steps]), &run("pin_on_disc", &[steps]));
}

/// Contact without friction does not know how it was reached, and each increment is Hertz's: the
/// peak goes with the cube root of the load, 0.2 % at 30 elements across the last contact.
#[test]
fn increments_end_where_one_step_ends() {
    let rows = run("hertz", &["motion.indentation.increments=4"]);
    assert_same(&rows, &run("hertz", &[]));
    let peaks = rows.column("centre_pressure_Pa");
    for (share, peak) in [(0.25f64, peaks[1]), (0.5, peaks[2]), (1.0, peaks[4])] {
        assert_relative_eq!(peak, 219.0547e6 * share.cbrt(), max_relative = 2e-3);
    }
}

/// Unlike materials: 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2.
#[test]
fn unlike_materials_meet_hertz() {
    let rows = run(
        "hertz",
        &[
            "body.ball.material={young=\"70 GPa\", poisson=0.2}",
            "frame.size=[\"0.46 mm\", \"0.46 mm\"]",
        ],
    );
    let modulus = 1.0 / (0.96 / 70e9 + 0.91 / 210e9);
    let hertz = Hertz::from_load([20.0; 2], modulus, 10.2).unwrap();
    assert_relative_eq!(rows.last("peak_pressure_Pa"), hertz.peak_pressure, max_relative = 1e-3);
    assert_relative_eq!(rows.last("approach_m"), hertz.approach, max_relative = 1e-3);
}

/// Elements that never touch change nothing, and x and y are alike.
#[test]
fn a_wider_frame_changes_nothing() {
    let steps = "motion.sliding.step=20 mm";
    let square = run("pin_on_disc", &[steps]);
    for (size, elements) in
        [("[\"2 mm\", \"1.2 mm\"]", "[50, 30]"), ("[\"1.2 mm\", \"2 mm\"]", "[30, 50]")]
    {
        let size = format!("frame.size={size}");
        let elements = format!("frame.elements={elements}");
        assert_same(&run("pin_on_disc", &[steps, &size, &elements]), &square);
    }
}
