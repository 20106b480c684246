//! Contracts of friction between bodies shifted against each other: every solver finds the same tractions, for
//! like bodies and together with the pressures of unlike ones; every law knows its slope.

use approx::assert_relative_eq;
use archard::closed_form::Hertz;
use archard::compliance::{Compliance, HalfSpace};
use archard::frame::ContactFrame;
use archard::solve::Status;
use archard::solve::tangential::{self, FRICTION_SOLVERS, Outcome, PrescribedForce};

use super::rolling::{BRASS, friction_laws, norm};
use crate::common::{Ball, STEEL, case, choose, states};

/// What shifts a small contact: rigid slip of an element (relative to mu p0 times its self term) along x
/// and y, and forces along x and y (relative to what friction bears) instead.
struct Shifted {
    slip: [f64; 2],
    forces: &'static [([f64; 2], f64)],
}

const SHIFTED: &[Shifted] = &[
    Shifted { slip: [1.0, 0.0], forces: &[] },
    Shifted { slip: [1.5, -1.0], forces: &[] },
    Shifted { slip: [20.0, 10.0], forces: &[] },
    Shifted { slip: [0.0, 0.5], forces: &[([1.0, 0.0], 0.5)] },
    Shifted { slip: [0.0, 0.0], forces: &[([1.0, 0.0], -0.4), ([0.0, 1.0], 0.3)] },
];

/// Hertz's contact on 15 x 15 elements, shifted and then half the way back: all solvers find the same
/// tractions, and they obey the law.
#[test]
fn friction_solvers_agree_on_shifted_bodies() {
    let elements = [15, 15];
    let ball = Ball { size: [0.34e-3, 0.38e-3], elements, ..Ball::pin_on_disc(1) };
    let frame = ball.problem().frame;
    let hertz = Hertz::from_load([20.0; 2], 115e9, 10.2).expect("a contact");
    let limit: Vec<f64> =
        (0..frame.len()).map(|pair| 0.3 * hertz.pressure(frame.place(pair))).collect();
    for materials in [[Some(&STEEL), Some(&STEEL)], [Some(&STEEL), Some(&BRASS)]] {
        let compliance = HalfSpace::new(materials, &frame);
        let map = compliance.shifting(&frame);
        let unit = map.own() * 0.3 * hertz.peak_pressure;
        for Shifted { slip, forces } in SHIFTED {
            let mut strained = [vec![0.0; frame.len()], vec![0.0; frame.len()]];
            for way in [1.0, -0.5] {
                let rigid = [0, 1].map(|axis| -> Vec<f64> {
                    strained[axis]
                        .iter()
                        .map(|strained| strained + way * unit * slip[axis])
                        .collect()
                });
                // Forces go half the way back too: from f to f / 2.
                let force = |share: f64| way.abs() * share * frame.integrate(&limit);
                let prescribed =
                    |&(direction, share)| PrescribedForce { direction, force: force(share) };
                let step = tangential::Step {
                    map: &*map,
                    elements,
                    measure: frame.measure(),
                    limit: &limit,
                    rigid: [&rigid[0], &rigid[1]],
                    prescribed: &forces.iter().map(prescribed).collect::<Vec<_>>(),
                };
                let found = all_agree(&step, &frame);
                let [one, two] = &mut strained;
                map.apply([&found[0], &found[1]], [one, two]);
            }
        }
    }
}

/// Solves a step by every solver; the tractions of the first.
fn all_agree(step: &tangential::Step<'_>, frame: &ContactFrame) -> [Vec<f64>; 2] {
    let largest = norm([step.limit, &[]]);
    let mut first: Option<Outcome> = None;
    for choice in FRICTION_SOLVERS {
        let name = choice.name;
        let outcome = choose(FRICTION_SOLVERS, name, &[("tolerance", 1e-8)]).solve(step, None);
        assert_eq!(outcome.status, Status::Converged, "{name}");
        assert!(outcome.residual <= 1e-8, "{name}");
        let sizes = outcome.traction[0].iter().zip(&outcome.traction[1]);
        for ((x, y), limit) in sizes.zip(step.limit) {
            assert!(x.hypot(*y) <= limit + 1e-8 * largest, "{name}");
        }
        let bears = frame.integrate(step.limit);
        for prescribed in step.prescribed {
            let force = [0, 1].map(|axis| frame.integrate(&outcome.traction[axis]));
            let force = force[0] * prescribed.direction[0] + force[1] * prescribed.direction[1];
            assert_relative_eq!(force, prescribed.force, epsilon = 1e-7 * bears);
        }
        let known = first.get_or_insert_with(|| outcome.clone());
        let apart = [0, 1].map(|axis| {
            let pairs = outcome.traction[axis].iter().zip(&known.traction[axis]);
            pairs.map(|(one, other)| one - other).collect::<Vec<_>>()
        });
        let apart = norm([&apart[0], &apart[1]]) / largest;
        assert!(apart < 1e-5, "{name}: {apart:e} apart");
    }
    first.expect("a solver").traction
}

/// A rigid ball pressed on steel and pushed, which friction and pressures govern together: at once by
/// Newton's method, in turn by the others.
#[test]
fn solvers_of_unlike_bodies_agree() {
    let run = |solver: &str, motion: &str| {
        let text = format!(
            r#"
            [body.ball]
            rigid = true
            profile.sphere = {{ radius = "50 mm" }}
            [body.block]
            material = {{ young = "210 GPa", poisson = 0.2 }}
            profile.flat = {{}}
            [frame]
            size = ["0.36 mm", "0.36 mm"]
            elements = [14, 14]
            [friction.coulomb]
            coefficient = 0.2
            [solver.conjugate_gradient]
            tolerance = 1e-10
            [friction_solver.{solver}]
            tolerance = 1e-8
            [motion]
            {motion}
            "#
        );
        let (state, ..) = states(&case(&text, &[])).expect("it converges").pop().expect("a state");
        let [t1, t2] = state.tangential.expect("friction").traction;
        [state.pressure, t1, t2].concat()
    };
    for motion in [
        r#"indentation = { approach = "0.3 um", increments = 4 }"#,
        r#"indentation = { load = "10 N", increments = 4 }"#,
        r#"fretting = { load = "10 N", force_amplitude = ["1 N", "0.5 N"], phase = "1 rad", increments = 4 }"#,
    ] {
        let known = run(FRICTION_SOLVERS[0].name, motion);
        for choice in &FRICTION_SOLVERS[1..] {
            let other = run(choice.name, motion);
            let apart: Vec<f64> = known.iter().zip(&other).map(|(a, b)| a - b).collect();
            let apart = norm([&apart, &[]]) / norm([&known, &[]]);
            // Measured: 2e-8, twice the tolerance.
            assert!(apart < 1e-6, "{}: {apart:e} apart in {motion}", choice.name);
        }
    }
}

/// The slope of the limit against its difference quotient.
#[test]
fn friction_laws_know_their_slope() {
    for (_, law) in friction_laws() {
        for pressure in [1e5, 1e8, 3e9] {
            let change = 1e-4 * pressure;
            let rise = law.limit(pressure + change) - law.limit(pressure - change);
            assert_relative_eq!(law.slope(pressure), rise / (2.0 * change), max_relative = 1e-3);
        }
    }
}
