//! Surfaces that repeat themselves and slide past each other for ever.

use approx::assert_relative_eq;
use archard::body::profile::{Flat, Wave};
use archard::frame::Direction;
use archard::motion::{Control, Sliding, Stepping};
use archard::simulation::Run;
use archard::wear::Archard;
use archard::{Body, Material, Simulation};

const LENGTH: f64 = 1e-3;
const AMPLITUDE: f64 = 0.1e-6;
const MEAN: f64 = 20e6;

fn body(name: &str, wave: Option<[Option<f64>; 2]>, coefficient: Option<f64>) -> Body {
    let body = match wave {
        Some(lengths) => Body::new(name, Wave::new(AMPLITUDE, lengths).expect("waves")),
        None => Body::new(name, Flat),
    };
    let body = body.material(Material::new(210e9, 0.3).expect("steel"));
    match coefficient {
        Some(k) => body.wear(Archard::new(k).expect("a coefficient")),
        None => body,
    }
}

/// The end of sliding along an axis over a distance (m).
fn slid(bodies: [Body; 2], axis: usize, distance: f64, stepping: Stepping) -> Run {
    let direction = Direction { axis, reversed: false };
    let load = Control::Load(MEAN * LENGTH * LENGTH);
    let sliding = Sliding::new().along(direction).endless().over(distance, load, stepping);
    let builder = Simulation::builder(bodies, sliding.expect("a motion"));
    let simulation =
        builder.frame([LENGTH; 2], [16; 2]).periodic().build().expect("parts that fit");
    let mut run = Run::begin(simulation).expect("a first contact");
    while run.step().expect("a step") {}
    run
}

/// Both wear by k F s, and what a flat wears is the same on every line along the motion, whatever slides over it.
#[test]
fn both_wear_by_the_load_and_the_distance() {
    let (distance, k) = (100.0, [1e-16, 3e-16]);
    for axis in [0, 1] {
        let bodies =
            [body("flat", None, Some(k[0])), body("wavy", Some([Some(LENGTH); 2]), Some(k[1]))];
        let run = slid(bodies, axis, distance, Stepping::Implicit(10.0));
        let (problem, state) = (&run.simulation().problem, run.report().state);
        for (body, k) in k.iter().enumerate() {
            let volume = problem.frame.integrate(&state.worn(body));
            assert_relative_eq!(volume, k * MEAN * LENGTH * LENGTH * distance, max_relative = 1e-9);
        }
        let worn = state.worn(0);
        let deepest = worn.iter().copied().fold(0.0, f64::max);
        for pair in 0..worn.len() {
            let [x, y] = [pair % 16, pair / 16];
            let first = if axis == 0 { 16 * y } else { x };
            assert!((worn[pair] - worn[first]).abs() < 2e-2 * deepest, "{axis} {pair}");
        }
        // What stays under the crests of the waves wears least where they never come.
        assert!(deepest > 1.05 * worn.iter().copied().fold(f64::INFINITY, f64::min));
    }
}

/// Waves across the motion on a plane: all of them meet all of the plane, which stays one, and their crests go first.
#[test]
fn waves_across_the_motion_level_out() {
    let bodies =
        |k: f64| [body("plane", None, Some(k)), body("wavy", Some([Some(LENGTH), None]), Some(k))];
    let roughness = |distance: f64| {
        let run = slid(bodies(5e-15), 0, distance, Stepping::Tolerance(1e-2));
        let (problem, state) = (&run.simulation().problem, run.report().state);
        let [plane, waves] = [0, 1].map(|body| problem.spread(state, body)[0]);
        (plane, waves, run.report().effort.time_error)
    };
    // A wave of amplitude a has a rms height of a / sqrt 2.
    let (mut before, unworn) = (f64::INFINITY, AMPLITUDE / 2.0_f64.sqrt());
    for distance in [0.1, 0.5, 2.0] {
        let (plane, waves, error) = roughness(distance);
        assert!(waves < 0.999 * before.min(unworn), "{waves:e}");
        assert!(plane < 0.02 * unworn, "{plane:e}");
        assert!(error.is_some_and(|error| error < 2e-2));
        before = waves;
    }
}

/// Along waves that do not change along the motion sliding past each other is sliding on the spot.
#[test]
fn what_is_the_same_along_the_motion_wears_as_if_it_stayed() {
    let bodies =
        || [body("flat", None, Some(1e-16)), body("wavy", Some([None, Some(LENGTH)]), Some(2e-16))];
    let step = Stepping::Implicit(25.0);
    let past = slid(bodies(), 0, 100.0, step);
    let load = Control::Load(MEAN * LENGTH * LENGTH);
    let stays =
        Sliding::new().over(100.0, load, Stepping::Implicit(25.0 / 16.0)).expect("a motion");
    let builder = Simulation::builder(bodies(), stays).frame([LENGTH; 2], [16; 2]).periodic();
    let mut run = Run::begin(builder.build().expect("parts")).expect("a contact");
    while run.step().expect("a step") {}
    for body in 0..2 {
        let [one, other] = [&past, &run].map(|run| run.report().state.worn(body).into_owned());
        let deepest = other.iter().copied().fold(0.0, f64::max);
        assert!(one.iter().zip(&other).all(|(one, other)| (one - other).abs() < 1e-6 * deepest));
    }
}

#[test]
fn surfaces_that_end_are_refused() {
    let load = Control::Load(1.0);
    let sliding =
        Sliding::new().endless().over(1.0, load, Stepping::Implicit(0.1)).expect("a motion");
    let bodies = [body("flat", None, None), body("wavy", Some([Some(LENGTH); 2]), None)];
    let refused = Simulation::builder(bodies, sliding).frame([LENGTH; 2], [16; 2]).build();
    assert!(refused.unwrap_err().to_string().contains("repeat themselves"));
    let explicit = Sliding::new().endless().over(1.0, load, Stepping::Explicit(0.1));
    assert_eq!(explicit.unwrap_err().parameter, "scheme");
}
