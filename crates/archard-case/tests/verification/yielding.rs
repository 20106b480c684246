//! Bodies that yield under their hardness, elastic and perfectly plastic.

use std::f64::consts::PI;

use approx::assert_relative_eq;
use archard::closed_form::hertz::Hertz;
use archard::motion::Control;
use archard::solve::{SOLVERS, Status, Step};

use crate::common::{Ball, Rows, at_rest, case, peak, solver, states};

const ROUGH: &str = include_str!("../../../../cases/rough_on_flat/case.toml");

const LOAD: f64 = 10.2;

const BALL_ON_FLAT: &str = "frame.size = [\"1 mm\", \"1 mm\"]\nframe.elements = [64, 64]\n\
    body.ball.material = { young = \"210 GPa\", poisson = 0.3 }\nbody.ball.profile.sphere.radius = \"20 mm\"\n\
    body.flat.material = { young = \"210 GPa\", poisson = 0.3 }\nbody.flat.profile.flat = {}\n\
    body.flat.hardness = \"500 MPa\"\n";

/// The ball under so many times its elastic peak pressure of hardness, by a solver.
fn pressed(name: &str, hardness: f64, elements: usize) -> (Vec<f64>, Vec<f64>, f64) {
    let ball = Ball { size: [0.8e-3; 2], ..Ball::pin_on_disc(elements) };
    let problem = ball.problem();
    let addition = vec![0.0; problem.frame.len()];
    let step = Step { hardness, ..at_rest(&problem, &addition, Control::Load(LOAD)) };
    let outcome = solver(name, 1e-9).solve(&step, None);
    assert_eq!(outcome.status, Status::Converged, "{name} {hardness:e}");
    (outcome.pressure, outcome.gap, outcome.approach)
}

/// All solvers find the same pressures, none above the hardness. Overlaps are only where it is reached.
#[test]
fn solvers_agree_on_bodies_that_yield() {
    let elastic = peak(&pressed("conjugate_gradient", f64::INFINITY, 24).0);
    for share in [0.9, 0.5, 0.2, 0.1] {
        let hardness = share * elastic;
        let all: Vec<_> = SOLVERS.iter().map(|choice| pressed(choice.name, hardness, 24)).collect();
        for (pressure, gap, approach) in &all {
            assert_relative_eq!(*approach, all[0].2, max_relative = 1e-7);
            for ((p, first), gap) in pressure.iter().zip(&all[0].0).zip(gap) {
                assert!((p - first).abs() < 1e-6 * hardness, "{share}: {p:e} and {first:e}");
                assert!((0.0..=hardness).contains(p), "{share}: {p:e}");
                assert!(*p == hardness || *gap > -1e-7 * approach, "{share}: {p:e} {gap:e}");
            }
        }
        let yields = all[0].0.iter().filter(|p| **p == hardness).count();
        assert!(yields > 0, "{share}");
    }
}

/// Pairs yield one after the other, and between two of them the load does not rise with the approach: it is found all the same.
#[test]
fn a_load_that_rises_in_steps_is_found() {
    let text = "frame.size = [\"2 mm\", \"2 mm\"]\nframe.elements = [24, 24]\n\
        body.a.material = { young = \"70 GPa\", poisson = 0.3 }\n\
        body.a.profile.power = { coefficient = \"0.0954033 mm^-1\", exponent = 2 }\n\
        body.b.material = { young = \"70 GPa\", poisson = 0.3 }\nbody.b.profile.flat = {}\n\
        body.b.hardness = \"58.7 MPa\"\nmotion.indentation = { load = \"110.23 N\", increments = 1 }\n";
    let approaches = SOLVERS.iter().map(|choice| {
        let solver = format!("solver.{}.tolerance=1e-7", choice.name);
        let mut rows = Rows::default();
        case(text, &[&solver]).run(&mut [&mut rows]).unwrap();
        [rows.last("approach_m"), rows.last("imprint_volume_b_m3")]
    });
    let approaches: Vec<[f64; 2]> = approaches.collect();
    for index in [0, 1] {
        assert_relative_eq!(approaches[0][index], approaches[1][index], max_relative = 1e-5);
    }
}

/// A body far softer than Hertz's pressure bears its hardness all over: the area is the load over it, and the imprint is the part of the
/// ball that overlaps, less what bends.
#[test]
fn a_soft_body_bears_its_hardness_all_over() {
    let text = "frame.size = [\"2 mm\", \"2 mm\"]\nframe.elements = [128, 128]\n\
        body.ball.material = { young = \"210 GPa\", poisson = 0.3 }\nbody.ball.profile.sphere.radius = \"20 mm\"\n\
        body.flat.material = { young = \"70 GPa\", poisson = 0.3 }\nbody.flat.profile.flat = {}\n\
        body.flat.hardness = \"50 MPa\"\n\
        motion.indentation = { load = \"60 N\", increments = 2 }\n";
    let simulation = case(text, &[]);
    let mut rows = Rows::default();
    simulation.run(&mut [&mut rows]).unwrap();
    let area = 60.0 / 50e6;
    assert_relative_eq!(rows.last("peak_pressure_Pa"), 50e6, max_relative = 1e-12);
    assert_relative_eq!(rows.last("load_N"), 60.0, max_relative = 1e-8);
    assert_relative_eq!(rows.last("contact_area_m2"), area, max_relative = 0.02);
    // A rigid ball pressed as deep as its circle of that area: a^2/(2 R), and half of that times the area.
    let depth = area / PI / (2.0 * 20e-3);
    assert_relative_eq!(rows.last("imprint_flat_m"), depth, max_relative = 0.1);
    assert_relative_eq!(
        rows.last("imprint_volume_flat_m3"),
        0.5 * depth * area,
        max_relative = 0.15
    );
    assert!(rows.0.iter().flatten().all(|(name, _)| name != "imprint_ball_m"));
    assert_eq!(rows.last("worn_volume_flat_m3"), 0.0);
}

/// No pressure exceeds the hardness: the area is the load over it at least, on elements as coarse as they may be.
#[test]
fn no_area_is_less_than_the_load_over_the_hardness() {
    for elements in [8, 12, 16, 24, 33] {
        let size = format!("frame.elements=[{elements}, {elements}]");
        for load in [20.0, 40.0, 60.0] {
            let text = format!(
                "{BALL_ON_FLAT}motion.indentation = {{ load = \"{load} N\", increments = 2 }}\n"
            );
            let mut rows = Rows::default();
            case(
                &text,
                &[&size, "body.flat.hardness=\"100 MPa\"", "frame.size=[\"2 mm\", \"2 mm\"]"],
            )
            .run(&mut [&mut rows])
            .unwrap();
            let least = load / 100e6;
            assert!(rows.last("contact_area_m2") >= (1.0 - 1e-9) * least, "{elements} {load}");
        }
    }
}

/// What is pressed in does not depend on the increments on the way up.
#[test]
fn an_imprint_does_not_depend_on_the_way_up() {
    let text = |increments: usize| {
        format!(
            "{BALL_ON_FLAT}motion.indentation = {{ load = \"100 N\", increments = {increments} }}\n"
        )
    };
    let [once, often] = [1, 10].map(|increments| {
        let mut rows = Rows::default();
        case(&text(increments), &[]).run(&mut [&mut rows]).unwrap();
        ["imprint_flat_m", "imprint_volume_flat_m3", "approach_m", "contact_area_m2"]
            .map(|name| rows.last(name))
    });
    assert!(once[0] > 1e-7);
    for (one, other) in once.iter().zip(&often) {
        assert_relative_eq!(*one, *other, max_relative = 0.02);
    }
}

/// An imprint stays: under a third of the load the ball rests in it, on more area and with less pressure than on a flat; pressed as
/// before, it yields no further.
#[test]
fn an_imprint_stays() {
    let path = "time_s,load_N\n0,0\n1,100\n2,30\n3,100\n";
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("path.csv");
    std::fs::write(&file, path).unwrap();
    let simulation = case(&format!("{BALL_ON_FLAT}motion.path.file = {file:?}\n"), &[]);
    let mut rows = Rows::default();
    simulation.run(&mut [&mut rows]).unwrap();
    let [up, down, again] = [1, 2, 3].map(|row| {
        [
            "imprint_flat_m",
            "imprint_volume_flat_m3",
            "approach_m",
            "contact_area_m2",
            "peak_pressure_Pa",
        ]
        .map(|name| rows.column(name)[row])
    });
    for (one, other) in up.iter().zip(&again) {
        assert_relative_eq!(*one, *other, max_relative = 1e-6);
    }
    assert_eq!(up[..2], down[..2]);
    let fresh = Hertz::from_load([1.0 / 20e-3; 2], 210e9 / (2.0 * 0.91), 30.0).unwrap();
    let area = PI * fresh.semi_axes[0] * fresh.semi_axes[1];
    assert!(down[3] > 1.2 * area, "{:e} and {area:e}", down[3]);
    assert!(down[4] < 0.8 * fresh.peak_pressure, "{:e}", down[4]);
}

/// Nothing yields below the hardness, well below to the bit; the first yield of a ball is at Hertz's peak.
#[test]
fn nothing_yields_below_the_hardness() {
    let text = "frame.size = [\"0.6 mm\", \"0.6 mm\"]\nframe.elements = [40, 40]\n\
        body.ball.material = { young = \"210 GPa\", poisson = 0.3 }\nbody.ball.profile.sphere.radius = \"50 mm\"\n\
        body.flat.material = { young = \"210 GPa\", poisson = 0.3 }\nbody.flat.profile.flat = {}\n\
        motion.indentation = { load = \"10 N\", increments = 2 }\n";
    let modulus = 210e9 / (2.0 * 0.91);
    let hertz = Hertz::from_load([1.0 / 50e-3; 2], modulus, 10.0).unwrap().peak_pressure;
    let of = |hardness: Option<f64>| {
        let hardness = hardness.map(|pa| format!("body.flat.hardness = \"{pa} Pa\"\n"));
        let simulation = case(&format!("{text}{}", hardness.unwrap_or_default()), &[]);
        states(&simulation).unwrap().pop().unwrap().0
    };
    let [elastic, harder, hard, soft] =
        [None, Some(3.0), Some(1.02), Some(0.98)].map(|share| of(share.map(|share| share * hertz)));
    assert!(elastic.pressure == harder.pressure, "not the same to the bit");
    for (one, other) in elastic.pressure.iter().zip(&hard.pressure) {
        assert!((one - other).abs() < 1e-6 * hertz, "{one:e} and {other:e}");
    }
    assert!(hard.surfaces[1].imprint.iter().all(|imprint| *imprint == 0.0));
    assert!(soft.surfaces[1].imprint.iter().any(|imprint| *imprint > 0.0));
    assert!(elastic.surfaces[1].imprint.is_empty());
}

/// What wears and yields at once keeps both apart: the worn volume is k F s.
#[test]
fn wear_and_imprint_are_apart() {
    let text = "frame.size = [\"0.8 mm\", \"0.8 mm\"]\nframe.elements = [48, 48]\n\
        body.ball.material = { young = \"210 GPa\", poisson = 0.3 }\nbody.ball.profile.sphere.radius = \"20 mm\"\n\
        body.flat.material = { young = \"210 GPa\", poisson = 0.3 }\nbody.flat.profile.flat = {}\n\
        body.flat.hardness = \"400 MPa\"\nbody.flat.wear.archard.coefficient = \"1e-7 mm^3/(N m)\"\n\
        motion.sliding = { load = \"20 N\", distance = \"1 m\", tolerance = 1e-2 }\n";
    let mut rows = Rows::default();
    case(text, &[]).run(&mut [&mut rows]).unwrap();
    assert_relative_eq!(rows.last("worn_volume_flat_m3"), 1e-16 * 20.0, max_relative = 1e-9);
    let [first, last] =
        [rows.column("imprint_volume_flat_m3")[0], rows.last("imprint_volume_flat_m3")];
    assert!(first > 0.0);
    // Pressures fall as the surfaces wear to fit: nothing yields any more.
    assert!(last < 1.05 * first, "{first:e} and {last:e}");
    assert!(rows.column("peak_pressure_Pa").iter().all(|peak| *peak <= 400e6));
}

/// Where it is not computed it is refused, with the body's name.
#[test]
fn a_hardness_is_refused_where_bodies_stay_elastic() {
    let text = "frame.size = [\"0.8 mm\", \"0.8 mm\"]\nframe.elements = [16, 16]\nfriction.coulomb.coefficient = 0.3\n\
        body.ball.material = { young = \"210 GPa\", poisson = 0.3 }\nbody.ball.profile.sphere.radius = \"20 mm\"\n\
        body.flat.material = { young = \"210 GPa\", poisson = 0.3 }\nbody.flat.profile.flat = {}\n\
        body.flat.hardness = \"400 MPa\"\n\
        motion.fretting = { load = \"20 N\", amplitude = [\"1 um\", \"0 um\"], cycles = 2 }\n";
    let file = archard_case::CaseFile::from_text("case.toml", text, "");
    let problems = file.resolve().unwrap_err();
    let said = problems.iter().map(|one| file.describe(one)).collect::<String>();
    assert!(said.contains("flat") && said.contains("hardness"), "{said}");
}

/// Surfaces that repeat themselves bear no more than the hardness all over, and say so.
#[test]
fn a_load_beyond_the_hardness_is_told() {
    let text = |hardness: f64| {
        format!(
            "frame.size = [\"1 mm\", \"1 mm\"]\nframe.elements = [32, 32]\nframe.periodic = true\n\
             body.wavy.material = {{ young = \"210 GPa\", poisson = 0.3 }}\n\
             body.wavy.profile.wave = {{ amplitude = \"1 um\", length_x = \"1 mm\", length_y = \"1 mm\" }}\n\
             body.flat.rigid = true\nbody.flat.profile.flat = {{}}\n\
             body.wavy.hardness = \"{hardness} MPa\"\nmotion.indentation = {{ load = \"50 N\", increments = 1 }}\n"
        )
    };
    let mut rows = Rows::default();
    case(&text(51.0), &[]).run(&mut [&mut rows]).unwrap();
    assert_relative_eq!(rows.last("contact_area_m2"), 50.0 / 51e6, max_relative = 0.02);
    let error = case(&text(49.0), &[]).run(&mut []).unwrap_err();
    assert!(error.to_string().contains("4.9000e1 N"), "{error}");
}

/// The rough surface of a case as another program presses it, elastic and perfectly plastic too: `benches/peers/rough_on_flat.py`.
#[test]
fn a_rough_surface_yields_as_in_another_program() {
    let set = ["body.ground.hardness=1 GPa", "motion.indentation.increments=1"];
    let mut rows = Rows::default();
    case(ROUGH, &set).run(&mut [&mut rows]).unwrap();
    assert_eq!(rows.last("peak_pressure_Pa"), 1e9);
    assert_relative_eq!(rows.last("imprint_ground_m"), 0.12090286e-6, max_relative = 1e-6);
    assert_relative_eq!(rows.last("imprint_volume_ground_m3"), 4.5274794e-17, max_relative = 1e-6);
}
