//! Where the frame lies that an accuracy takes: it finds the contact, holds it, grows with it, and nothing depends on it.

use approx::assert_relative_eq;
use archard::closed_form::Hertz;
use archard::simulation::history::{Row, number};
use archard::simulation::{Report, Run};
use archard_case::output::Image;
use archard_case::{CaseFile, RunnableCase};

use super::accuracy::{
    DISCS, PIN, TRACK, answer, assert_within, resolved, run, settled, with_error,
};
use crate::common::{Rows, states};

/// A case of a tabulated paraboloid of 50 mm, its apex off the middle by tilting the table, on a flat.
fn tilted(rows: usize, half: f64, apex: [f64; 2], rest: &str) -> tempfile::TempDir {
    let height = |x: f64, y: f64| (apex[0] * x + apex[1] * y) / 50.0 - (x * x + y * y) / 100.0;
    tabulated(rows, half, height, rest)
}

/// A case of heights (mm) over x and y (mm) in a square table on a flat.
fn tabulated(
    rows: usize,
    half: f64,
    height: impl Fn(f64, f64) -> f64,
    rest: &str,
) -> tempfile::TempDir {
    let dir = tempfile::TempDir::new().unwrap();
    let place = |index: usize| half * (2.0 * index as f64 / (rows - 1) as f64 - 1.0);
    let mut table = "x_mm,y_mm,z_mm\n".to_owned();
    for (x, y) in (0..rows * rows).map(|point| (place(point % rows), place(point / rows))) {
        table += &format!("{x},{y},{}\n", height(x, y));
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

fn read(dir: &tempfile::TempDir, options: &[&str]) -> Result<RunnableCase, String> {
    let file = CaseFile::read(dir.path()).unwrap();
    let file = options.iter().fold(file, |file, option| file.set(*option));
    let described = |problem: &archard_case::Problem| file.describe(problem);
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
    // The files say where it is: the pressure is largest at the apex.
    let apex = [-4.7, 3.1];
    let resolved = read(&tilted(41, 6.0, apex, pressed), &["accuracy=0.05"]).unwrap();
    let simulation = resolved.case.build().unwrap();
    let (state, ..) = states(&simulation).unwrap().pop().unwrap();
    let image = Image::of(&simulation.problem, &state);
    let pressure = image.field("pressure_Pa").unwrap();
    let load: f64 = pressure.iter().sum();
    for axis in 0..2 {
        let along = |element: usize| {
            [element % image.elements[0], element / image.elements[0]][axis] as f64
        };
        let moment: f64 = pressure.iter().enumerate().map(|(at, p)| p * along(at)).sum();
        let centre = image.origin[axis] + (moment / load + 0.5) * image.spacing[axis];
        assert!((centre - 1e-3 * apex[axis]).abs() < 0.02 * hertz.semi_axes[0], "{axis}: {centre}");
    }
    // The table ends where the contact would be.
    let beyond = read(&tilted(41, 6.0, [5.99, 0.0], pressed), &["accuracy=0.01"]).unwrap_err();
    assert!(beyond.contains("reaches the end of a surface along x"), "{beyond}");
}

/// So are lines of contact of a measured section, in the middle too, where rounding must not move the frame.
#[test]
fn lines_of_contact_of_measured_sections_are_found() {
    for apex in [1.3, 0.0] {
        let dir = tempfile::TempDir::new().unwrap();
        let rows = (-300..=300).map(|i| {
            let x = 0.01 * f64::from(i);
            format!("{x},{}\n", (2.0 * apex * x - x * x) / 100.0)
        });
        let table = format!("x_mm,z_mm\n{}", rows.collect::<String>());
        std::fs::write(dir.path().join("bar.csv"), table).unwrap();
        let steel = "material = { young = \"210 GPa\", poisson = 0.3 }";
        let case = format!(
            "accuracy = 0.02\n[body.bar]\n{steel}\nprofile.table.file = \"bar.csv\"\n[body.flat]\n{steel}\nprofile.flat = {{}}\n\
             [frame]\nlength = \"10 mm\"\n[motion.indentation]\nload = \"1000 N\"\nincrements = 1\n"
        );
        std::fs::write(dir.path().join("case.toml"), case).unwrap();
        let resolved = read(&dir, &[]).unwrap();
        let frame = resolved.case.frame;
        assert!((frame.centre[0] - 1e-3 * apex).abs() < 1e-6, "{frame:?}");
        // The peak of a line, sqrt(F E*/(pi L R)) (K. L. Johnson, *Contact Mechanics*, 1985, section 4.2).
        let truth = (1e5 * 0.5 * 210e9 / (1.0 - 0.09) / (std::f64::consts::PI * 50e-3)).sqrt();
        let (found, error) = with_error(&run(resolved), "peak_pressure_Pa");
        assert!((found - truth).abs() <= error, "{found} of {truth} by {error}");
        assert!(error < 0.02 * truth);
    }
}

/// A spike that the few elements of the search step over is not left out: the frame grows until it holds it, one that was given
/// too. One that stays below the deformed ball is nobody's business.
#[test]
fn frames_grow_to_what_touches_beyond() {
    let pressed = "[motion.indentation]\nload = \"10.2 N\"\nincrements = 1\n";
    let hertz = Hertz::from_load([20.0; 2], 0.5 * 210e9 / (1.0 - 0.09), 10.2).unwrap();
    // The gap next to a contact of radius a under the approach d (K. L. Johnson, *Contact Mechanics*, 1985, section 3.4).
    let gap = |apart: f64| {
        let root = (apart * apart - 1.0).sqrt();
        let sunk = (2.0 - apart * apart) * (1.0 / apart).asin() + root;
        hertz.approach * (0.5 * apart * apart - 1.0 + sunk / std::f64::consts::PI)
    };
    // On a place of the table some contact radii away, that share of the gap high.
    let spiked = |radii: f64, share: f64| {
        let away = 0.03 * (radii * hertz.semi_axes[0] / 0.03e-3).round();
        let height = share * gap(1e-3 * away / hertz.semi_axes[0]);
        let spike = move |x: f64, y: f64| (1.0 - (x - away).hypot(y) / 0.06).max(0.0);
        let ball = |x: f64, y: f64| -(x * x + y * y) / 100.0;
        let table = move |x, y| 1e3 * height * spike(x, y) + ball(x, y);
        (tabulated(301, 4.5, table, pressed), 1e-3 * away)
    };
    let touches = |resolved: RunnableCase, place: f64| {
        let mut run = Run::begin(resolved.case.build().unwrap()).unwrap();
        while run.step().unwrap() {}
        let Report { problem, state, .. } = run.report();
        let near = |pair: usize| {
            let [x, y] = problem.frame.place(pair);
            state.pressure[pair] > 0.0 && (x - place).hypot(y) < 0.06e-3
        };
        (0..problem.frame.len()).any(near)
    };
    let frame = ["frame.size=[\"0.4 mm\", \"0.4 mm\"]", "frame.elements=[40, 40]"];
    // The middle of an element lies a part of it next to the tip.
    for radii in [2.0, 5.0] {
        for (share, meets) in [(0.9, false), (1.3, true)] {
            let (dir, place) = spiked(radii, share);
            let resolved = read(&dir, &frame).unwrap();
            assert!(!resolved.case.frame.rectangle().holds([place, 0.0]));
            assert_eq!(touches(resolved, place), meets, "{radii} {share}");
        }
    }
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
    for column in ["wear_depth_m", "approach_m"] {
        let ((found, error), (truth, rest)) =
            (with_error(&row, column), with_error(&truth, column));
        let off = (found - truth).abs();
        assert!(off <= error + rest, "{column}: {off:e} of {error:e} and {rest:e}");
    }
}

/// A ball that slides so far that its scar is twenty times as wide as the first contact takes few elements, in a frame that
/// becomes wider; the errors that are stated enclose the true ones at every output, and volumes are k F s.
#[test]
#[ignore = "long: in .ci/long"]
fn scars_that_outgrow_the_first_contact_take_wider_frames() {
    const PLACES: [f64; 4] = [5e-3, 0.5, 10.0, 200.0];
    // An independent axisymmetric solution, four digits.
    const KNOWN: [(f64, f64); 2] = [(5e-3, 0.1264e-6), (0.5, 2.059e-6)];
    let rows = |accuracy: &str| {
        let options = [
            "frame=",
            "motion.sliding.step=",
            "motion.sliding.distance=200 m",
            "output.every=",
            "output.at=[\"5 mm\", \"500 mm\", \"10 m\"]",
            accuracy,
        ];
        let resolved = resolved(PIN, &options).expect("a case");
        let (resolved, simulation) = settled(resolved).expect("a grid");
        let case = resolved.case;
        assert_eq!(case.doubles.len(), 3, "{:?}", case.doubles);
        // One frame as wide as the last would take eight times as many.
        assert!(case.frame.elements[0] < 400, "{:?}", case.frame);
        let printed = CaseFile::from_text("case.toml", case.to_string(), "").resolve().unwrap();
        assert_eq!(printed.case, case);
        let mut rows = Rows::default();
        simulation.run(&mut [&mut rows]).expect("a run");
        rows.0
    };
    let [asked, finer] = ["accuracy=0.02", "accuracy=0.006"].map(rows);
    for place in PLACES {
        let at = |rows: &[Row]| {
            rows.iter()
                .find(|row| (row[0].1 / place - 1.0).abs() < 1e-9)
                .expect("an output")
                .clone()
        };
        let [row, truth] = [at(&asked), at(&finer)];
        for column in ["wear_depth_m", "approach_m", "centre_pressure_Pa", "worn_volume_pin_m3"] {
            let (found, error) = with_error(&row, column);
            assert_within(&row, column, with_error(&truth, column), &format!("at {place}"));
            // The accuracy is met at the end; steps are coarser at first.
            let asked = if place == PLACES[3] { 0.02 } else { 0.024 };
            let counts = column != "centre_pressure_Pa";
            assert!(
                !counts || error <= asked * found,
                "{column} at {place}: {error:e} of {found:e}"
            );
        }
        if let Some((_, depth)) = KNOWN.iter().find(|(at, _)| *at == place) {
            let (found, error) = with_error(&row, "wear_depth_m");
            assert!((found - depth).abs() <= error + 4e-4 * depth, "{place}: {found:e} {depth:e}");
        }
        let volume = number(&row, "worn_volume_pin_m3").unwrap();
        assert_relative_eq!(volume, 1.33e-13 * 10.2 * place, max_relative = 1e-9);
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
            // The pressure at the centre is that of another place; a residual at rounding is no result, and one of the frames
            // may have grown.
            let effort = ["residual", "solves", "iterations"].contains(&&**name);
            if !name.starts_with("centre") && !effort && one.is_finite() {
                assert_relative_eq!(*one, *other, max_relative = 1e-6, epsilon = 1e-20);
            }
        }
    }
}

/// A ball that no closed form knows, since it has a coated partner, at an approach that none of the first elements sees.
#[test]
fn a_small_approach_is_found_under_a_large_ball() {
    let text = r#"
        accuracy = 0.05
        [body.ball]
        rigid = true
        profile.sphere = { radius = "73 mm" }
        [body.disc]
        layers = [{ thickness = "1.5 mm", young = "11.5 GPa", poisson = 0.29 }]
        material = { young = "30.6 GPa", poisson = 0.37 }
        profile.flat = {}
        [motion.indentation]
        approach = "1.66 um"
    "#;
    let frame = CaseFile::from_text("case.toml", text, "").resolve().expect("a frame").case.frame;
    // Between the contact and four of it: sqrt(R d) to sqrt(2 R d) to each side.
    assert!(frame.size.iter().all(|size| (0.7e-3..4e-3).contains(size)), "{frame:?}");
}
