//! Pictures of made-up runs of a ball that frets on a flat: Hertz's pressure, Mindlin's forces.

use std::f64::consts::TAU;
use std::fs;

use archard::closed_form::cattaneo_mindlin::PartialSlip;
use archard::problem::{ContactProblem, ContactState, Surface, Tangential};
use archard_case::CaseFile;
use tempfile::tempdir;

use super::{drawn, write};

/// Load (N), friction coefficient and amplitude (m).
const LOAD: f64 = 10.2;
const FRICTION: f64 = 0.3;
const AMPLITUDE: f64 = 60e-9;

/// A steel ball on a flat under that motion.
fn case(motion: &str, wear: &str) -> String {
    let steel = "material = { young = \"210 GPa\", poisson = 0.3 }\n";
    format!(
        "[body.ball]\n{steel}profile.sphere = {{ radius = \"50 mm\" }}\n{wear}\
         [body.flat]\n{steel}profile.flat = {{}}\n\
         [frame]\nsize = [\"0.4 mm\", \"0.4 mm\"]\nelements = [24, 24]\n\
         [friction.coulomb]\ncoefficient = {FRICTION}\n[motion.{motion}]\nload = \"{LOAD} N\"\n"
    )
}

fn problem(case: &str) -> ContactProblem {
    let resolved = CaseFile::from_text("case", case, ".").resolve();
    resolved.unwrap_or_else(|problems| panic!("{problems:?}")).case.build().unwrap().problem
}

/// The ball at some instant of its oscillation, worn to that depth (m).
fn state(problem: &ContactProblem, cycles: f64, depth: f64) -> ContactState {
    let frame = &problem.frame;
    let materials = problem.bodies.each_ref().map(|body| body.material.as_ref());
    let ball = PartialSlip::new(50e-3, materials, LOAD, FRICTION).unwrap();
    let shift = AMPLITUDE * (TAU * cycles).sin();
    let field = |value: &dyn Fn(f64) -> f64| -> Vec<f64> {
        let distance = |pair: usize| frame.place(pair).map(|x| x * x).iter().sum::<f64>().sqrt();
        (0..frame.len()).map(|pair| value(distance(pair))).collect()
    };
    let none = || vec![0.0; frame.len()];
    ContactState {
        progress: cycles,
        load: LOAD,
        approach: 0.44e-6,
        tangential: Some(Tangential {
            traction: [field(&|r| ball.traction(r, ball.force(shift))), none()],
            slip: [none(), none()],
            creepage: [0.0; 2],
            shift: [shift, 0.0],
            ..Tangential::default()
        }),
        pressure: field(&|r| ball.pressure(r)),
        surfaces: [field(&|r| if r < 0.12e-3 { 0.0 } else { depth }), none()]
            .map(|depth| Surface::of_pairs(frame.elements(), depth)),
        ..ContactState::untouched(frame)
    }
}

const OSCILLATION: &str = "amplitude = [\"60 nm\", \"0 um\"]\nincrements = 8\n";

#[test]
fn an_oscillation_has_its_loops_beside_the_closed_form() {
    let dir = tempdir().unwrap();
    let case = case("fretting", "") + OSCILLATION + "cycles = 3\n";
    let problem = problem(&case);
    let states: Vec<_> = (0..=24).map(|step| state(&problem, f64::from(step) / 8.0, 0.0)).collect();
    write(dir.path(), &case, &problem, &states, true);
    let files = drawn(dir.path());
    let known = ["fretting_loop", "traction", "profiles", "pressure_map", "overview"];
    let both = known.iter().flat_map(|name| [format!("{name}.svg"), format!("{name}.png")]);
    assert_eq!(files, both.collect::<Vec<_>>());
    let picture = |name: &str| {
        fs::read_to_string(dir.path().join("plots").join(name).with_extension("svg")).unwrap()
    };
    let loops = picture("fretting_loop");
    for text in ["Fretting loop along x", "Force on ball (N)", "Mindlin", "cycle 1", "cycle 3"] {
        assert!(loops.contains(text), "{text}");
    }
    assert!(picture("traction").contains("Traction along x on ball"));
    assert!(picture("pressure_map").contains("stick outlined"));
    assert!(picture("overview").contains("Fretting loop along x"));
}

#[test]
fn fretting_wear_is_drawn_over_cycles() {
    let dir = tempdir().unwrap();
    let wear = "wear.archard = { coefficient = \"1e-13 1/Pa\" }\n";
    let case = case("fretting", wear) + OSCILLATION + "cycles = 5000\njump = 1000\n";
    let problem = problem(&case);
    let cycles = (0..=8).chain((1..=5).flat_map(|jump| 8 * (1000 * jump - 1) + 1..=8000 * jump));
    let states: Vec<_> = cycles
        .map(|step| f64::from(step) / 8.0)
        .map(|cycle| state(&problem, cycle, 1e-11 * cycle))
        .collect();
    write(dir.path(), &case, &problem, &states, true);
    let files = drawn(dir.path());
    assert_eq!(files[..4], ["wear.svg", "wear.png", "fretting_loop.svg", "fretting_loop.png"]);
    let svg = |name: &str| fs::read_to_string(dir.path().join("plots").join(name)).unwrap();
    for text in ["Cycle", "Wear depth (µm)"] {
        assert!(svg("wear.svg").contains(text), "{text}");
    }
    assert!(svg("fretting_loop.svg").contains("Mindlin, unworn"));
}

/// Unlike a motion that rolls, one that only presses the bodies has forces that are nothing.
#[test]
fn an_indentation_with_friction_is_drawn_as_one() {
    let dir = tempdir().unwrap();
    let case = case("indentation", "") + "increments = 4\n";
    let problem = problem(&case);
    let states: Vec<_> = [0.25, 0.5, 0.75, 1.0]
        .map(|share| ContactState { progress: share, ..state(&problem, 0.0, 0.0) })
        .to_vec();
    write(dir.path(), &case, &problem, &states, true);
    let files = drawn(dir.path());
    assert_eq!(files[..4], ["load.svg", "load.png", "traction.svg", "traction.png"]);
}
