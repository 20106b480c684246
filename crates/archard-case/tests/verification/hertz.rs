//! Hertz: Johnson, *Contact Mechanics*, sections 4.2 and 5.4.

use approx::assert_relative_eq;
use archard::body::Material;
use archard::closed_form::Hertz;
use archard::motion::Control;
use archard::solve::{SOLVERS, Status, Step};

use crate::common::{Ball, at_rest, peak, solver};

/// Contact radius of the reference sphere (m).
const RADIUS: f64 = 0.1491058e-3;
/// Its peak pressure (Pa).
const PEAK: f64 = 219.0547e6;
/// Its approach (m).
const APPROACH: f64 = 0.44465074e-6;

fn sphere(cells: usize) -> Ball {
    Ball { size: [2.4 * RADIUS; 2], ..Ball::pin_on_disc(cells) }
}

/// Reference values, sphere R = 50 mm, 210 GPa / 0.3, 10.2 N, on a frame 2.4 radii wide. The bounds
/// at 30, 60, 120 and 240 cells are the project's.
#[test]
fn the_peak_of_a_sphere_converges() {
    let errors =
        [(30, 0.2e-2), (60, 0.05e-2), (120, 0.02e-2), (240, 0.005e-2)].map(|(cells, bound)| {
            let error = (peak(&sphere(cells).contact().pressure) / PEAK - 1.0).abs();
            assert!(error < bound, "{cells} cells: {error:e}");
            error
        });
    let order = (errors[0] / errors[3]).log2() / 3.0;
    assert!((order - 2.0).abs() < 0.1, "order {order}");
}

/// The approach, measured from first touch between the pairs, is better still, and the load is met.
#[test]
fn the_approach_of_a_sphere_converges() {
    for (cells, bound) in [(30, 3e-4), (60, 1.5e-4), (120, 4e-5)] {
        let state = sphere(cells).contact();
        assert_relative_eq!(state.load, 10.2, max_relative = 1e-12);
        assert_relative_eq!(state.approach, APPROACH, max_relative = bound);
    }
}

/// The pressure everywhere, not only at its peak: half a cell from the edge, where the slope of the
/// pressure has no bound, the error is that of half a cell.
#[test]
fn the_pressure_of_a_sphere_is_right_everywhere() {
    let ball = sphere(120);
    let (state, frame) = (ball.contact(), ball.problem().frame);
    let hertz = Hertz::from_load([20.0; 2], 210e9 / (2.0 * 0.91), 10.2).unwrap();
    for (pair, &pressure) in state.pressure.iter().enumerate() {
        let [x, y] = frame.place(pair);
        let near_edge = (x.hypot(y) / RADIUS - 1.0).abs() < 0.05;
        let bound = if near_edge { 0.1 } else { 0.002 };
        let error = (pressure - hertz.pressure([x, y])).abs() / PEAK;
        assert!(error < bound, "{error:e} at {x:e}, {y:e}");
    }
}

/// Reference values of the twin discs: 0.1 % at 41 x 41 cells.
#[test]
fn the_ellipse_of_the_twin_discs() {
    let material = Some(Material { young: 208e9, poisson: 0.3 });
    let (a, b, peak_pressure, approach) = (0.2165120e-3, 0.8265901e-3, 800.3693e6, 4.1798535e-6);
    let ball = Ball {
        radii: [16.199846e-3, 125e-3],
        materials: [material; 2],
        size: [2.4 * a, 2.4 * b],
        elements: [41, 41],
        control: Control::Load(300.0),
        ..Ball::pin_on_disc(1)
    };
    let state = ball.contact();
    assert_relative_eq!(peak(&state.pressure), peak_pressure, max_relative = 1e-3);
    assert_relative_eq!(state.approach, approach, max_relative = 1e-3);
}

/// By approach instead of load, and with the elasticity of one body only.
#[test]
fn a_given_approach_meets_the_load() {
    let ball = Ball { control: Control::Approach(APPROACH), ..sphere(60) };
    assert_relative_eq!(ball.contact().load, 10.2, max_relative = 2e-3);
    let rigid =
        Ball { materials: [None, ball.materials[1]], control: Control::Load(10.2), ..sphere(60) };
    let hertz = Hertz::from_load([20.0; 2], 210e9 / 0.91, 10.2).unwrap();
    assert_relative_eq!(peak(&rigid.contact().pressure), hertz.peak_pressure, max_relative = 1e-3);
}

/// The reference solver and the fast one find the same contact, to the tolerance.
#[test]
fn every_solver_finds_the_same_contact() {
    for control in [Control::Load(10.2), Control::Approach(APPROACH)] {
        for added in [0.0, 2e-15] {
            let problem = Ball { size: [4.0 * RADIUS; 2], ..Ball::pin_on_disc(24) }.problem();
            let addition = vec![added; problem.frame.len()];
            let step = at_rest(&problem, &addition, control);
            let outcomes: Vec<_> =
                SOLVERS.iter().map(|choice| solver(choice.name, 1e-8).solve(&step, None)).collect();
            for outcome in &outcomes {
                assert_eq!(outcome.status, Status::Converged);
                assert_relative_eq!(outcome.approach, outcomes[0].approach, max_relative = 1e-7);
                let scale = peak(&outcomes[0].pressure);
                for (a, b) in outcome.pressure.iter().zip(&outcomes[0].pressure) {
                    assert!((a - b).abs() < 1e-6 * scale, "{a} and {b}");
                }
            }
        }
    }
}

/// A load that needs more than the frame, and too few iterations: data, not a wrong answer.
#[test]
fn a_solve_that_cannot_succeed_says_so() {
    let problem = Ball { size: [0.2 * RADIUS; 2], ..Ball::pin_on_disc(10) }.problem();
    let addition = vec![0.0; 100];
    for choice in SOLVERS {
        let outcome = solver(choice.name, 1e-8)
            .solve(&at_rest(&problem, &addition, Control::Load(10.2)), None);
        assert_eq!(outcome.status, Status::FrameFull, "{}", choice.name);
    }
    let problem = sphere(40).problem();
    let addition = vec![0.0; 1600];
    // Bumps, or a direct solver would guess the contact of a ball.
    let bumps = (0..1600).map(|pair: usize| 1e-7 * (pair * 7919 % 13) as f64);
    let bumpy: Vec<f64> = problem.frame.gap().iter().zip(bumps).map(|(gap, h)| gap + h).collect();
    for choice in SOLVERS {
        let hasty = crate::common::choose(SOLVERS, choice.name, &[("max_iterations", 1.0)]);
        let step = Step { gap: &bumpy, ..at_rest(&problem, &addition, Control::Load(10.2)) };
        let outcome = hasty.solve(&step, None);
        assert_eq!(outcome.status, Status::OutOfIterations, "{}", choice.name);
        assert!(outcome.residual > 1e-8);
    }
}
