//! One number in, one error bar out: what is asked for is met, and the error that is stated encloses the true one.

use approx::assert_relative_eq;
use archard::case::{CaseFile, Following, Resolved};
use archard::closed_form::Hertz;
use archard::simulation::Observer;
use archard::simulation::history::{ERRORS, Row, SPACE_ERROR, TIME_ERROR, number};

use crate::common::Rows;

/// Nobody follows.
#[derive(Default)]
struct Alone(Rows);

impl Following for Alone {
    fn begins(&mut self, _: [usize; 2]) {}

    fn observer(&mut self) -> &mut dyn Observer {
        &mut self.0
    }
}

fn resolved(text: &str, options: &[&str]) -> Result<Resolved, String> {
    let file = CaseFile::from_text("case.toml", text, "");
    let file = options.iter().fold(file, |file, option| file.set(*option));
    let described = |problem: &archard::case::Problem| file.describe(problem);
    file.resolve().map_err(|problems| problems.iter().map(described).collect())
}

/// The last row of a case with its accuracy.
fn answer(text: &str, options: &[&str]) -> Row {
    run(resolved(text, options).expect("a case"))
}

/// The last row of a case.
fn run(resolved: Resolved) -> Row {
    let (resolved, companion) =
        resolved.with_companion(None, &mut Alone::default()).expect("a grid");
    let mut simulation = resolved.case.build().expect("a simulation");
    simulation.companion = companion;
    let mut rows = Rows::default();
    simulation.run(&mut [&mut rows]).expect("a run");
    rows.0.pop().expect("a row")
}

/// The value in a column and the error stated, by steps and elements.
fn with_error(row: &Row, column: &str) -> (f64, f64) {
    let of = |prefix: &str| number(row, &format!("{prefix}{column}"));
    let errors = ERRORS.map(|prefix| of(prefix).unwrap_or_default());
    (number(row, column).expect(column), errors[0] + errors[1])
}

const SIZES: [&str; 3] = ["accuracy=0.1", "accuracy=0.03", "accuracy=0.01"];

/// Case, options, the columns that are judged and the accuracy of what they are held against.
type Judged = (&'static str, &'static [&'static str], &'static [&'static str], &'static str);

const PIN: &str = include_str!("../../../../cases/pin_on_disc/case.toml");
const TRACK: &str = include_str!("../../../../cases/pin_on_disc_track/case.toml");
const DISCS: &str = include_str!("../../../../cases/twin_disc/case.toml");
const FRETTING: &str = include_str!("../../../../cases/mccoll_fretting/case.toml");
const CATTANEO: &str = include_str!("../../../../cases/cattaneo_mindlin/case.toml");
const SPENCE: &str = include_str!("../../../../cases/spence/case.toml");
const HERTZ: &str = include_str!("../../../../cases/hertz/case.toml");

/// Whatever is asked for, the true errors of depth, approach, pressure and force lie within those stated, and the worst of
/// what counts is as asked: against runs several times as accurate.
#[test]
fn stated_errors_enclose_the_true_ones() {
    let cases: [Judged; 4] = [
        (
            PIN,
            &["frame=", "motion.sliding.step="],
            &["wear_depth_m", "approach_m", "centre_pressure_Pa"],
            "accuracy=0.001",
        ),
        (
            TRACK,
            &["frame=", "motion.sliding.tolerance="],
            &["wear_depth_ball_m", "wear_depth_disc_m", "approach_m"],
            "accuracy=0.001",
        ),
        (
            DISCS,
            &["frame=", "motion.rolling.tolerance=", "motion.rolling.revolutions=3000", "output="],
            &["wear_depth_m", "force_x_N"],
            "accuracy=0.003",
        ),
        (
            FRETTING,
            &[
                "frame.size=",
                "frame.elements=",
                "motion.fretting.tolerance=",
                "motion.fretting.cycles=2000",
                "output=",
            ],
            &["wear_depth_flat_m", "wear_depth_cylinder_m", "approach_m"],
            "accuracy=0.003",
        ),
    ];
    let mut lies = vec![];
    for (text, options, columns, best) in cases {
        let at = |accuracy: &str| {
            let all: Vec<&str> = options.iter().copied().chain([accuracy]).collect();
            answer(text, &all)
        };
        let truth = at(best);
        for accuracy in SIZES {
            let asked: f64 = accuracy.trim_start_matches("accuracy=").parse().unwrap();
            let row = at(accuracy);
            // The steps are stated with a margin of five.
            let stated =
                number(&row, SPACE_ERROR).unwrap() + 5.0 * number(&row, TIME_ERROR).unwrap();
            assert!(stated <= asked, "{stated} of {asked}");
            for column in columns {
                let ((found, error), (truth, rest)) =
                    (with_error(&row, column), with_error(&truth, column));
                let off = (found - truth).abs();
                println!(
                    "{accuracy} {column} {:.2e} stated {:.2e} ratio {:.2} time {:.2e}",
                    off / truth,
                    error / truth,
                    error / off,
                    number(&row, TIME_ERROR).unwrap()
                );
                if off > error + rest {
                    lies.push(format!("{column} at {asked}: {off:e} of {error:e}"));
                }
            }
        }
    }
    assert!(lies.is_empty(), "{lies:#?}");
}

/// Hertz's pressure and approach lie within the errors stated.
#[test]
fn hertz_lies_within_the_errors_stated() {
    let modulus = 0.5 * 210e9 / (1.0 - 0.09);
    let hertz = Hertz::from_load([20.0; 2], modulus, 10.2).unwrap();
    for accuracy in SIZES {
        let row = answer(HERTZ, &["frame=", accuracy]);
        for (column, truth) in
            [("centre_pressure_Pa", hertz.peak_pressure), ("approach_m", hertz.approach)]
        {
            let (found, error) = with_error(&row, column);
            let off = (found - truth).abs();
            println!("{accuracy} {column} {:.2e} stated {:.2e}", off / truth, error / truth);
            assert!(off <= error, "{column} at {accuracy}: {off:e} of {error:e}");
        }
    }
}

/// So do the forces, energies and areas of closed forms where friction decides what slips in increments; both the elements and
/// the increments are chosen.
#[test]
fn partial_slip_lies_within_the_errors_stated() {
    let cases = [
        (
            CATTANEO,
            ["frame=", "motion.fretting.increments="],
            [("dissipated_J", 1.396453e-8), ("approach_m", 0.44465074e-6)],
        ),
        (
            SPENCE,
            ["frame=", "motion.indentation.increments="],
            [("load_N", 389.6386), ("stick_area_m2", 0.494378e-6)],
        ),
    ];
    for (text, options, truths) in cases {
        for accuracy in SIZES {
            let row = answer(text, &[options[0], options[1], accuracy]);
            for (column, truth) in truths {
                let (found, error) = with_error(&row, column);
                let off = (found - truth).abs();
                println!("{accuracy} {column} {:.2e} stated {:.2e}", off / truth, error / truth);
                assert!(off <= error, "{column} at {accuracy}: {off:e} of {error:e}");
            }
        }
    }
}

/// A frame that is given keeps its elements, and the error that they make is stated; what is chosen prints as a case that
/// reads back to itself.
#[test]
fn what_is_given_is_kept() {
    let given = |elements: &'static str| ["accuracy=0.001", "motion.sliding.step=", elements];
    let coarse = answer(PIN, &given("frame.elements=[30, 30]"));
    assert!(number(&coarse, SPACE_ERROR).unwrap() > 1e-3);
    let coarser = resolved(PIN, &given("frame.elements=[14, 14]")).unwrap();
    let refused = coarser.with_companion(None, &mut Alone::default()).map(|_| ()).unwrap_err();
    assert!(refused.to_string().starts_with("3.5 elements"), "{refused}");
    let chosen = resolved(PIN, &["accuracy=0.02", "motion.sliding.step=", "frame="]).unwrap();
    let again = resolved(&chosen.case.to_string(), &[]).unwrap();
    assert_eq!(chosen.case, again.case);
    let size = chosen.case.frame.size;
    assert_relative_eq!(size[0], size[1]);
    assert!(resolved(PIN, &["frame=", "motion.sliding.step=", "accuracy=0.5"]).is_err());
    let fixed = resolved(PIN, &["accuracy=0.01"]).unwrap_err();
    assert!(fixed.contains("what a fixed step errs by is not known"), "{fixed}");
}

/// A case of a tabulated paraboloid of 50 mm, its apex off the middle by tilting the table, on a flat.
fn tilted(rows: usize, half: f64, apex: [f64; 2], rest: &str) -> tempfile::TempDir {
    let dir = tempfile::TempDir::new().unwrap();
    let place = |index: usize| half * (2.0 * index as f64 / (rows - 1) as f64 - 1.0);
    let mut table = "x_mm,y_mm,z_mm\n".to_owned();
    for (x, y) in (0..rows * rows).map(|point| (place(point % rows), place(point / rows))) {
        let z = (apex[0] * x + apex[1] * y) / 50.0 - (x * x + y * y) / 100.0;
        table += &format!("{x},{y},{z}\n");
    }
    std::fs::write(dir.path().join("ball.csv"), table).unwrap();
    let case = format!(
        "[body.ball]\nmaterial = {{ young = \"210 GPa\", poisson = 0.3 }}\nprofile.table.file = \"ball.csv\"\n\
         wear.archard.coefficient = \"1.33e-13 1/Pa\"\n[body.flat]\nmaterial = {{ young = \"210 GPa\", poisson = 0.3 }}\n\
         profile.flat = {{}}\n{rest}"
    );
    std::fs::write(dir.path().join("case.toml"), case).unwrap();
    dir
}

fn read(dir: &tempfile::TempDir, options: &[&str]) -> Result<Resolved, String> {
    let file = CaseFile::read(dir.path()).unwrap();
    let file = options.iter().fold(file, |file, option| file.set(*option));
    let described = |problem: &archard::case::Problem| file.describe(problem);
    file.resolve().map_err(|problems| problems.iter().map(described).collect())
}

/// The contact of measured surfaces is found wherever it is: the frame goes there, and the result is that of the ball whose
/// heights were measured.
#[test]
fn contacts_off_the_middle_are_found() {
    let pressed = "[motion.indentation]\nload = \"10.2 N\"\nincrements = 1\n";
    let modulus = 0.5 * 210e9 / (1.0 - 0.09);
    let hertz = Hertz::from_load([20.0; 2], modulus, 10.2).unwrap();
    for apex in [[0.0, 0.0], [0.31, -0.22], [-4.7, 3.1]] {
        let dir = tilted(41, 6.0, apex, pressed);
        let resolved = read(&dir, &["accuracy=0.01"]).unwrap();
        let frame = resolved.case.frame;
        for (centre, apex) in frame.centre.into_iter().zip(apex) {
            assert!((centre - 1e-3 * apex).abs() < 0.02 * hertz.semi_axes[0], "{frame:?}");
        }
        let row = run(resolved);
        for (column, truth) in
            [("peak_pressure_Pa", hertz.peak_pressure), ("approach_m", hertz.approach)]
        {
            let (found, error) = with_error(&row, column);
            assert!((found - truth).abs() <= error, "{column}: {found} of {truth} by {error}");
            assert!(error < 0.02 * truth);
        }
    }
    // The table ends where the contact would be.
    let beyond = read(&tilted(41, 6.0, [5.99, 0.0], pressed), &["accuracy=0.01"]).unwrap_err();
    assert!(beyond.contains("reaches the end of a surface along x"), "{beyond}");
}

/// Wear goes with it: a scar off the middle is that of the ball in the middle, in a frame that grows until it is held.
#[test]
fn scars_off_the_middle_are_held() {
    let worn = "[motion.sliding]\nload = \"10.2 N\"\ndistance = \"2000 mm\"\n";
    let dir = tilted(41, 6.0, [3.1, -1.2], worn);
    let resolved = read(&dir, &["accuracy=0.02"]).unwrap();
    let row = run(resolved);
    let truth = answer(
        PIN,
        &[
            "frame=",
            "motion.sliding.step=",
            "motion.sliding.distance=2000 mm",
            "output=",
            "accuracy=0.005",
        ],
    );
    for (column, same) in [("wear_depth_m", "wear_depth_m"), ("approach_m", "approach_m")] {
        let ((found, error), (truth, rest)) = (with_error(&row, column), with_error(&truth, same));
        let off = (found - truth).abs();
        assert!(off <= error + rest, "{column}: {off:e} of {error:e} and {rest:e}");
    }
}

/// Nothing depends on where the frame is, as long as its pairs are the same: forces, moments by spin and wear of bodies that
/// roll or slide on a track.
#[test]
fn a_frame_may_lie_anywhere() {
    let discs = [
        "frame.size=[\"0.52 mm\", \"6.4 mm\"]",
        "frame.elements=[52, 64]",
        "motion.rolling.spin=20 1/m",
        "motion.rolling.revolutions=2",
        "motion.rolling.tolerance=",
        "motion.rolling.step=1",
        "output=",
    ];
    let ball = [
        "frame.size=[\"0.8 mm\", \"0.8 mm\"]",
        "frame.elements=[40, 40]",
        "motion.sliding.tolerance=",
        "motion.sliding.step=10 mm",
        "motion.sliding.distance=20 mm",
    ];
    for (text, options, centre) in [
        (DISCS, &discs[..], "frame.centre=[\"0.02 mm\", \"-0.3 mm\"]"),
        (TRACK, &ball[..], "frame.centre=[\"0.04 mm\", \"-0.06 mm\"]"),
    ] {
        let all = |more: &[&'static str]| {
            let options: Vec<&str> = options.iter().chain(more).copied().collect();
            let resolved = resolved(text, &options).expect("a case");
            run(resolved)
        };
        let (middle, beside) = (all(&[]), all(&[centre]));
        for ((name, one), (_, other)) in middle.iter().zip(&beside) {
            // The pressure at the centre is that of another place.
            if !name.starts_with("centre") && one.is_finite() {
                assert_relative_eq!(*one, *other, max_relative = 1e-6, epsilon = 1e-20);
            }
        }
    }
}
