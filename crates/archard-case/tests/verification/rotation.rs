//! Bodies that turn on each other about the normal: the slip grows with the radius.

use std::f64::consts::TAU;

use approx::assert_relative_eq;
use archard::problem::ContactState;
use archard::simulation::Simulation;

use crate::common::{Rows, case, states};

const K: f64 = 1e-6 * 1e-9;

/// A flat pin of 2 mm on a flat that does not wear.
fn text(motion: &str) -> String {
    format!(
        r#"
        [body.pin]
        material = {{ young = "2 GPa", poisson = 0.4 }}
        profile.flat_end = {{ radius = "2 mm" }}
        wear.archard = {{ coefficient = "1e-6 mm^3/(N m)" }}
        [body.disc]
        material = {{ young = "210 GPa", poisson = 0.3 }}
        profile.flat = {{}}
        [frame]
        size = ["4.4 mm", "4.4 mm"]
        elements = [45, 45]
        [motion.rotation]
        load = "100 N"
        {motion}
    "#
    )
}

/// Integral of the pressure over the distance slid from a step at its start to its end (N m).
fn worked(simulation: &Simulation, state: &ContactState, angle: f64) -> f64 {
    let frame = &simulation.problem.frame;
    let slid = |pair: usize| {
        let [x, y] = frame.place(pair);
        state.pressure[pair] * angle * x.hypot(y)
    };
    frame.integrate(&(0..frame.len()).map(slid).collect::<Vec<_>>())
}

/// The first step of a punch wears k p r times the angle, deepest towards its edge: at the end of an implicit step.
#[test]
fn a_pair_wears_by_its_radius() {
    let simulation = case(&text("revolutions = 0.01\nstep = 0.01"), &[]);
    let states = states(&simulation).expect("it converges");
    let (state, angle) = (&states[1].0, 0.01 * TAU);
    let (worn, frame) = (state.worn(0), &simulation.problem.frame);
    for pair in 0..frame.len() {
        let [x, y] = frame.place(pair);
        let expected = K * state.pressure[pair] * angle * x.hypot(y);
        assert_relative_eq!(worn[pair], expected, max_relative = 1e-9, epsilon = 1e-20);
    }
    let expected = worked(&simulation, state, angle);
    assert_relative_eq!(states[1].1.load_distance, expected, max_relative = 1e-9);
    assert_relative_eq!(frame.integrate(&worn) / K, expected, max_relative = 1e-9);
}

/// To and fro by an angle, a cycle is four times it: as many radians as in revolutions wear the same.
#[test]
fn to_and_fro_is_four_times_the_angle() {
    let volume = |motion: &str| {
        let mut rows = Rows::default();
        case(&text(motion), &[]).run(&mut [&mut rows]).expect("it converges");
        rows.last("worn_volume_pin_m3")
    };
    let round = volume("revolutions = 2\nstep = 0.5");
    let to_and_fro = volume("amplitude = \"90 deg\"\ncycles = 2\nstep = 0.5");
    assert_relative_eq!(round, to_and_fro, max_relative = 1e-12);
}

/// Worn in, a thrust washer wears evenly: p r is F / (2 pi (b - a)) everywhere, the uniform wear of clutches. Its rims are
/// those of whole elements.
#[test]
fn a_worn_in_washer_wears_evenly() {
    let washer = text("revolutions = 3e5\ntolerance = 0.01");
    let washer = washer.replace("radius = \"2 mm\"", "radius = \"2 mm\", hole = \"1 mm\"");
    let simulation = case(&washer, &["frame.elements=[67, 67]"]);
    let states = states(&simulation).expect("it converges");
    let state = &states[states.len() - 1].0;
    let frame = &simulation.problem.frame;
    let product = |pair: usize| {
        let [x, y] = frame.place(pair);
        state.pressure[pair] * x.hypot(y)
    };
    let pressed: Vec<f64> = (0..frame.len()).map(product).filter(|one| *one > 0.0).collect();
    let mean = pressed.iter().sum::<f64>() / pressed.len() as f64;
    let expected = 100.0 / (TAU * 1e-3);
    assert!((mean / expected - 1.0).abs() < 0.02, "{}", mean / expected);
    for one in &pressed {
        assert!((one / mean - 1.0).abs() < 0.01, "{}", one / mean);
    }
    assert!(pressed.len() > 1000);
}
