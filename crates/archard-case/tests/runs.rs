//! Cases run in ways the published ones are not, against closed forms and identities.

mod common;
mod framed;
#[path = "runs/resume.rs"]
mod resume;
#[path = "runs/sections.rs"]
mod sections;

use std::fmt::Write;

use approx::assert_relative_eq;
use archard::closed_form::Hertz;
use archard_case::{CaseFile, Solves};

use common::Rows;

/// The rows of a published case with options.
fn run(case: &str, options: &[&str]) -> Rows {
    let folder = framed::folder(case);
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
    let folder = framed::folder("pin_on_disc");
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

/// Elements that never touch change nothing, and x and y are equal.
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

/// Every row of a run carries the load prescribed for it.
fn assert_carried(rows: &Rows, expected: impl Fn(usize) -> f64) {
    let loads = rows.column("load_N");
    for (row, &load) in loads.iter().enumerate() {
        assert_relative_eq!(load, expected(row), max_relative = 1e-8, epsilon = 1e-12);
    }
    assert!(rows.column("approach_m").iter().all(|approach| approach.is_finite()));
}

/// A contact that begins on one pair, or on a few that leave at once, finds the pairs next to them.
#[test]
fn the_load_is_carried_on_the_coarsest_frames() {
    let steps = ["frame.elements=[3,3]", "motion.sliding.step=50 mm"];
    for solver in ["conjugate_gradient", "uzawa"] {
        let solver = format!("solver.{solver}.tolerance=1e-9");
        let rows = run("pin_on_disc", &[steps[0], steps[1], &solver]);
        assert_carried(&rows, |_| 10.2);
        // The contact grows beyond the pair that it began on.
        assert!(rows.last("contact_area_m2") > 4.0 * rows.column("contact_area_m2")[0]);
    }
    let wide = ["frame.elements=[25,25]", "frame.size=[\"2 mm\",\"2 mm\"]"];
    let rows = run("hertz", &[wide[0], wide[1], "motion.indentation.increments=20"]);
    assert_carried(&rows, |row| 10.2 * row as f64 / 20.0);
}

/// McColl's cylinder on a flat, in gross slip (I. R. McColl, J. Ding and S. B. Leen, Wear 256 (2004) 1114).
const MCCOLL: &str = r#"
    [body.cylinder]
    material = { young = "200 GPa", poisson = 0.3 }
    profile.cylinder = { radius = "6 mm", axis = "y" }
    wear.archard = { coefficient = "1.9e-8 1/MPa" }
    [body.flat]
    material = { young = "200 GPa", poisson = 0.3 }
    profile.flat = {}
    wear.archard = { coefficient = "2.9e-8 1/MPa" }
    [friction.coulomb]
    coefficient = 0.7
    [frame]
    size = ["0.8 mm", "10 mm"]
    elements = [160, 1]
    [motion.fretting]
    load = "185 N"
    amplitude = ["25 um", "0 um"]
"#;

/// Its rows with options.
fn mccoll(options: &[&str]) -> Rows {
    let file = CaseFile::from_text("McColl", MCCOLL, ".");
    let file = options.iter().fold(file, |file, option| file.set(*option));
    let mut rows = Rows::default();
    file.resolve().expect("a case").case.build().unwrap().run(&mut [&mut rows]).unwrap();
    rows
}

/// McColl's cylinder over 2,000 cycles: whatever tolerance is asked, the depth is off from that of a run of every cycle by less than the error stated, which is below
/// the tolerance.
#[test]
#[ignore = "long: in .ci/long"]
fn jumps_know_their_error() {
    let every = mccoll(&["motion.fretting.cycles=2000", "output.at=[500, 1000]"]);
    for tolerance in [3e-2, 1e-2, 1e-3] {
        let tolerance_given = format!("motion.fretting.tolerance={tolerance}");
        let rows =
            mccoll(&["motion.fretting.cycles=2000", "output.at=[500, 1000]", &tolerance_given]);
        let off = rows.last("wear_depth_m") / every.last("wear_depth_m") - 1.0;
        let stated = rows.last("time_error");
        assert!(off.abs() < stated && stated < tolerance, "{off} {stated} {tolerance}");
        assert!(rows.column("cycle").len() < every.column("cycle").len() / 10);
    }
}

/// So do a ball that slips at its edge, and one that slips in all of its contact: tractions remember what was before a jump,
/// and the first cycle, which comes from the rest, is no measure of those that follow.
#[test]
#[ignore = "long: in .ci/long"]
fn jumps_over_what_sticks_know_their_error() {
    for amplitude in ["1.023 um", "3 um"] {
        let amplitude = format!("motion.fretting.amplitude=[\"{amplitude}\", \"0 um\"]");
        let with = |stepping: &[&str]| {
            let common = [
                "frame.elements=[24, 24]",
                "frame.size=[\"0.7 mm\", \"0.7 mm\"]",
                "motion.fretting.cycles=240",
                "body.ball.wear.archard.coefficient=1e-12 1/Pa",
                "output=",
                &amplitude,
            ];
            run("fretting_sphere", &[&common, stepping].concat())
        };
        // A run of every cycle lags by a part of one, which is the most in the first ten.
        const LAGS: f64 = 5e-4;
        let every = with(&["motion.fretting.tolerance=", "motion.fretting.jump=1"]);
        let cycles = every.column("cycle");
        for tolerance in ["0.03", "0.01", "0.003"] {
            let rows = with(&[&format!("motion.fretting.tolerance={tolerance}")]);
            let (at, stated) = (rows.column("cycle"), rows.column("time_error"));
            for column in ["worn_volume_ball_m3", "wear_depth_ball_m"] {
                let (found, truth) = (rows.column(column), every.column(column));
                let ends = (0..at.len()).filter(|&row| at[row] > 2.5 && at[row].fract() == 0.0);
                for row in ends {
                    let same = cycles.iter().position(|cycle| *cycle == at[row]).unwrap();
                    let off = (found[row] / truth[same] - 1.0).abs();
                    let (cycle, most) = (at[row], stated[row] + LAGS);
                    assert!(
                        off < most,
                        "{amplitude} {tolerance} {column} at {cycle}: {off:e} of {most:e}"
                    );
                }
            }
        }
    }
}

/// Pairs that a jump brings into contact wear as their neighbours do, also where one of these had joined in the very
/// cycle before: the pressures fall from output to output, as they do in every cycle.
#[test]
fn jumps_leave_no_spikes_at_the_edge_of_the_scar() {
    let jumps = "motion.fretting.tolerance=0.01";
    let rows = mccoll(&["motion.fretting.cycles=18000", "output.at=[1000, 5000, 10000]", jumps]);
    let (cycles, peaks) = (rows.column("cycle"), rows.column("peak_pressure_Pa"));
    let ends: Vec<f64> = (0..cycles.len())
        .filter(|&row| cycles[row] > 100.0 && (cycles[row] - cycles[row].round()).abs() < 1e-9)
        .map(|row| peaks[row])
        .collect();
    assert!(ends.len() > 5);
    assert!(ends.windows(2).all(|two| two[1] < 1.01 * two[0]), "{ends:?}");
}

/// Discs that creep so little that less than an element slips: forces go as the creepage and wear as its square, as in
/// Kalker's linear theory (J. J. Kalker, Three-Dimensional Elastic Bodies in Rolling Contact, Kluwer 1990). That the
/// section is k/mu times the work of the force holds by the pairing of tractions and slip, short of what is cut off.
#[test]
fn discs_that_hardly_creep_wear_by_the_work_of_their_creepage() {
    let worn = |creepage: f64| {
        let creepage = format!("motion.rolling.creepage={creepage}");
        let rows = run("twin_disc", &[&creepage, "motion.rolling.revolutions=10", "output.at=[1]"]);
        [rows.last("worn_section_disc1_m2"), rows.last("force_x_N")]
    };
    let [section, force] = worn(1e-4);
    let [less, lesser] = worn(1e-5);
    // The linear theory: forces as the creepages, wear as their squares.
    assert_relative_eq!(force / lesser, 10.0, max_relative = 0.02);
    assert_relative_eq!(section / less, 100.0, max_relative = 0.03);
    // The same as at full slip, where k F xi a revolution is exact, but for the force.
    let [full, most] = worn(0.01);
    assert_relative_eq!(section / full, 1e-2 * force / most, max_relative = 1e-3);
}
