//! Wear laws that ask for what was before, for vectors and for the speed.

use std::sync::Arc;

use approx::assert_relative_eq;
use archard::body::{Material, contact_modulus};
use archard::closed_form::Hertz;
use archard::simulation::Error;
use archard::simulation::refusal::Part;
use archard::wear::{Input, Rubbing, WearLaw};

use crate::common::{case, peak, states};

/// A coefficient so small (1/Pa) that the contact stays as it is.
const K: f64 = 1e-20;

/// k p s times a factor that grows evenly with the distance: 1 + distance / LENGTH, over the slip itself too.
#[derive(Debug)]
struct Grows;
const LENGTH: f64 = 0.02;

impl WearLaw for Grows {
    fn inputs(&self) -> &'static [Input] {
        &[Input::Distance]
    }

    fn depth(&self, Rubbing { pressure, slip, distance, .. }: Rubbing) -> f64 {
        K * pressure * slip * (1.0 + (distance + 0.5 * slip) / LENGTH)
    }
}

/// k p s, and the slower the deeper.
#[derive(Debug)]
struct Slows;
const DEPTH: f64 = 1e-13;

impl WearLaw for Slows {
    fn inputs(&self) -> &'static [Input] {
        &[Input::Depth]
    }

    fn depth(&self, Rubbing { pressure, slip, depth, .. }: Rubbing) -> f64 {
        K * pressure * slip * (-depth / DEPTH).exp()
    }
}

/// k times the work of the traction on the slip, both as vectors, or as they are given.
#[derive(Debug)]
struct Work {
    vectors: bool,
}

impl WearLaw for Work {
    fn inputs(&self) -> &'static [Input] {
        &[Input::Friction, Input::Vectors]
    }

    fn depth(&self, Rubbing { work, slip_vector: [x, y], traction, .. }: Rubbing) -> f64 {
        K * if self.vectors { traction[0] * x + traction[1] * y } else { work }
    }
}

/// k p s times the speed.
#[derive(Debug)]
struct Fast;

impl WearLaw for Fast {
    fn inputs(&self) -> &'static [Input] {
        &[Input::Speed]
    }

    fn depth(&self, Rubbing { pressure, slip, speed, .. }: Rubbing) -> f64 {
        K * pressure * slip * speed
    }
}

const BODIES: &str = r#"
    [body.ball]
    material = { young = "210 GPa", poisson = 0.3 }
    profile.sphere = { radius = "50 mm" }
    wear.archard.coefficient = "1e-20 1/Pa"
    [body.flat]
    material = { young = "210 GPa", poisson = 0.3 }
    profile.flat = {}
    wear.archard.coefficient = "1e-20 1/Pa"
    [frame]
    size = ["0.6 mm", "0.6 mm"]
    elements = [20, 20]
"#;
const COULOMB: &str = "[friction.coulomb]\ncoefficient = 0.3";
const ELLIPSE: &str = "[friction.orthotropic]\ncoefficients = [0.3, 0.1]\nangle = \"30 deg\"";

/// Pressures at the end (Pa) and depths worn off both bodies (m), by Archard's law or another.
fn run(text: &str, law: Option<fn() -> Box<dyn WearLaw>>) -> (Vec<f64>, [Vec<f64>; 2]) {
    let mut simulation = case(&format!("{BODIES}{text}"), &[]);
    if let Some(law) = law {
        simulation.problem.bodies.iter_mut().for_each(|body| body.wear = Some(law().into()));
    }
    let mut states = states(&simulation).expect("it converges");
    let state = states.pop().expect("a state").0;
    let worn = [0, 1].map(|body| state.worn(body).into_owned());
    (state.pressure, worn)
}

/// Pairs that stay slide the distance; a point of a track slides the chord of Hertz's contact a turn; one of a wheel the creepage on
/// that chord. The law integrates a distance that is known.
#[test]
#[ignore = "long: in .ci/long"]
fn distances_are_those_of_the_points() {
    let slides = "[motion.sliding]\nload = \"10 N\"\ndistance = \"30 mm\"\nsurfaces = \"stay\"";
    let track = "[motion.sliding]\nload = \"10 N\"\ntrack = \"3 mm\"\ndistance = \"30 mm\"\npasses = \"flat\"";
    let rolls =
        format!("{COULOMB}\n[motion.rolling]\nload = \"10 N\"\ncreepage = 1\nrevolutions = 30");
    let fretting = format!(
        "{COULOMB}\n[motion.fretting]\nload = \"10 N\"\namplitude = [\"8 um\", \"0 um\"]\ncycles = 100\nincrements = 80"
    );
    let swings = fretting.replace("increments = 80", "surfaces = \"swing\"");
    let steel = Material { young: 210e9, poisson: 0.3 };
    let modulus = contact_modulus([Some(&steel), Some(&steel)]);
    let radius = Hertz::from_load([20.0; 2], modulus, 10.0).unwrap().semi_axes[0];
    for (motion, step) in [
        (slides, "step = \"10 mm\""),
        (slides, "tolerance = 1e-3"),
        (track, "step = \"1.5 mm\""),
        (track, "tolerance = 1e-3"),
        (&rolls, "step = 5"),
        (&rolls, "step = 1"),
        (&fretting, ""),
        (&fretting, "jump = 10"),
        (&fretting, "tolerance = 0.01"),
        (&swings, "jump = 10"),
    ] {
        let text = format!("{motion}\n{step}");
        let (pressure, plain) = run(&text, None);
        let (_, grown) = run(&text, Some(|| Box::new(Grows)));
        for body in 0..2 {
            let most = peak(&plain[body]);
            for pair in 0..pressure.len() {
                let aside = 0.03e-3 * (9.5 - (pair / 20) as f64).abs();
                let passes = motion == rolls || (motion == track && body == 1);
                let chord = 2.0 * (radius * radius - aside * aside).max(0.0).sqrt();
                let distance = match (motion, body) {
                    _ if plain[body][pair] < 1e-3 * most => continue,
                    _ if passes && aside > 0.7 * radius => continue,
                    (motion, _) if motion == rolls => 30.0 * chord,
                    (motion, 1) if motion == track => 10.0 * chord,
                    // The flat is rubbed where it moves.
                    (motion, 1) if motion == swings => continue,
                    (motion, _) if motion == fretting || motion == swings => {
                        plain[body][pair] / (K * pressure[pair])
                    }
                    _ => 30e-3,
                };
                let expected = 1.0 + 0.5 * distance / LENGTH;
                let ratio = grown[body][pair] / plain[body][pair];
                // A jump goes on at the rate before it.
                let allowed = match step {
                    "jump = 10" if motion == fretting => 0.1,
                    _ if motion == fretting => 5e-3,
                    // As well as elements know where the edges are.
                    _ if passes => 0.015,
                    _ => 2e-5,
                };
                let found = (ratio - 1.0) / (expected - 1.0);
                assert!((found - 1.0).abs() < allowed, "{text} {body} {pair}: {found}");
            }
        }
    }
}

/// Where the rate falls with the depth as exp(-d / D), the depth is D ln(1 + k p s / D).
#[test]
fn depths_are_those_so_far() {
    let slides = "[motion.sliding]\nload = \"10 N\"\ndistance = \"300 mm\"\nsurfaces = \"stay\"";
    let (_, plain) = run(&format!("{slides}\nstep = \"300 mm\""), None);
    let most = peak(&plain[0]);
    assert!(most > 5.0 * DEPTH);
    for (step, allowed) in [
        ("step = \"1 mm\"", 0.02),
        ("tolerance = 1e-2", 1e-2),
        ("tolerance = 1e-3", 1e-3),
        ("tolerance = 1e-4", 1e-4),
    ] {
        let (_, slowed) = run(&format!("{slides}\n{step}"), Some(|| Box::new(Slows)));
        for (plain, slowed) in plain[0].iter().zip(&slowed[0]) {
            let expected = DEPTH * (plain / DEPTH).ln_1p();
            assert!(
                (slowed - expected).abs() < allowed * DEPTH * (most / DEPTH).ln_1p(),
                "{step} {slowed:e} {expected:e}"
            );
        }
    }
}

/// The traction on the slip works what friction does: in sliding along both axes, rolling and fretting, friction the same in
/// all directions or not.
#[test]
fn vectors_work_what_friction_does() {
    for motion in [
        "[motion.sliding]\nload = \"10 N\"\ndistance = \"30 mm\"\nstep = \"10 mm\"\ndirection = \"y\"",
        "[motion.sliding]\nload = \"10 N\"\ndistance = \"30 mm\"\nstep = \"10 mm\"\ntrack = \"3 mm\"\npasses = \"flat\"",
        "[motion.rolling]\nload = \"10 N\"\ncreepage = 1\nrevolutions = 30\nstep = 10",
        "[motion.fretting]\nload = \"10 N\"\namplitude = [\"0.3 um\", \"0.2 um\"]\nphase = \"60 deg\"\ncycles = 2",
    ] {
        for friction in [COULOMB, ELLIPSE] {
            let text = format!("{friction}\n{motion}");
            let (_, given) = run(&text, Some(|| Box::new(Work { vectors: false })));
            let (_, vectors) = run(&text, Some(|| Box::new(Work { vectors: true })));
            let most = peak(&given[0]);
            assert!(most > 0.0);
            for (given, vectors) in given[0].iter().zip(&vectors[0]) {
                assert!((given - vectors).abs() < 1e-9 * most, "{motion}: {given:e} {vectors:e}");
            }
        }
    }
}

/// The speed comes from the motion, or the law is refused.
#[test]
fn the_speed_is_asked_for() {
    let slides = "[motion.sliding]\nload = \"10 N\"\ndistance = \"30 mm\"\nstep = \"10 mm\"\nsurfaces = \"stay\"";
    let (_, plain) = run(slides, None);
    let (_, fast) = run(&format!("{slides}\nspeed = \"0.2 m/s\""), Some(|| Box::new(Fast)));
    assert_relative_eq!(peak(&fast[0]) / peak(&plain[0]), 0.2, max_relative = 1e-6);
    let mut simulation = case(&format!("{BODIES}{slides}"), &[]);
    simulation.problem.bodies[0].wear = Some(Arc::new(Fast));
    let refused = simulation.run(&mut []);
    assert!(
        matches!(&refused, Err(Error::Refused(all)) if all.0[0].part == Part::Wear("ball".into())),
        "{refused:?}"
    );
}
