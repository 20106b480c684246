//! Contacts of many patches: a wavy and a random surface, far from the convex shapes the rest of the
//! suite lives on.

use archard::frame::Part;
use archard::motion::Control;
use archard::solve::{Outcome, SOLVERS, Start, Status, Step, press};

use crate::common::{Ball, at_rest, solver};
use crate::surfaces::OnAFlat;

/// Roughness without pattern between -1 and 1, one value a pair.
fn scattered(pairs: usize) -> Vec<f64> {
    (0..pairs).map(|i| ((12.9898 * i as f64 + 4.1).sin() * 43_758.545_3) % 1.0).collect()
}

/// The ball's gap with waves or scatter of some height (m) on it.
fn rough_gap(ball: &Ball, height: f64, waves: bool) -> Vec<f64> {
    let frame = ball.problem().frame;
    let scatter = scattered(frame.len());
    let bump = |pair: usize| {
        let [x, y] = frame.place(pair);
        let wave = (40.0 * x / frame.size()[0]).cos() * (52.0 * y / frame.size()[1]).sin();
        height * if waves { wave } else { scatter[pair] }
    };
    let gap: Vec<f64> =
        frame.gap().iter().enumerate().map(|(pair, gap)| gap + bump(pair)).collect();
    let lowest = gap.iter().copied().fold(f64::INFINITY, f64::min);
    gap.iter().map(|gap| gap - lowest).collect()
}

/// The fast solver converges on surfaces from smooth to rougher than the approach is deep, in a number
/// of iterations that stays moderate, and so does a wear step on them.
#[test]
fn many_patches_converge() {
    let ball = Ball { size: [0.6e-3; 2], ..Ball::pin_on_disc(96) };
    let problem = ball.problem();
    for height in [0.02e-6, 0.2e-6, 1e-6] {
        for waves in [true, false] {
            let gap = rough_gap(&ball, height, waves);
            for added in [0.0, 1e-16, 1e-15] {
                let addition = vec![added; gap.len()];
                let step = Step { gap: &gap, ..at_rest(&problem, &addition, Control::Load(10.2)) };
                let outcome = solver("conjugate_gradient", 1e-8).solve(&step, None);
                assert_eq!(outcome.status, Status::Converged, "{height:e} {waves} {added:e}");
                assert!(
                    outcome.iterations <= 40,
                    "{} at {height:e} {waves} {added:e}",
                    outcome.iterations
                );
            }
        }
    }
}

/// On a rough surface too, every solver finds the same pressures.
#[test]
fn solvers_agree_on_a_rough_surface() {
    let ball = Ball { size: [0.6e-3; 2], ..Ball::pin_on_disc(20) };
    let problem = ball.problem();
    let gap = rough_gap(&ball, 0.2e-6, false);
    let addition = vec![0.0; gap.len()];
    let step = Step { gap: &gap, ..at_rest(&problem, &addition, Control::Load(10.2)) };
    let outcomes: Vec<_> =
        SOLVERS.iter().map(|choice| solver(choice.name, 1e-9).solve(&step, None)).collect();
    let scale = crate::common::peak(&outcomes[0].pressure);
    for outcome in &outcomes[1..] {
        for (a, b) in outcome.pressure.iter().zip(&outcomes[0].pressure) {
            assert!((a - b).abs() < 1e-6 * scale, "{a:e} and {b:e}");
        }
    }
}

/// A self-affine surface of `n` by `n` elements on a flat, rms slope 0.1, pressed by 0.04 of that times E*, alone or
/// repeating itself: a twelfth or so touches. From pressures all over the frame or from nothing.
fn self_affine_contact(n: usize, repeats: bool, start: Option<&[f64]>) -> Outcome {
    let surface = OnAFlat::new(n, repeats);
    let step = surface.pressed(0.04);
    let start = start.map(|pressure| Start {
        pressure,
        displacement: &[],
        part: Some(Part::none([n; 2])),
        approach: 0.0,
    });
    let outcome = press(&*solver("conjugate_gradient", 1e-8), &step, start);
    assert_eq!(outcome.status, Status::Converged);
    outcome
}

/// What coarser elements say is a start and no more: the pressures are those that even ones lead to. On a frame that
/// divides into coarser elements, on one that does not, and on surfaces that repeat themselves.
#[test]
fn the_solution_does_not_depend_on_coarser_elements() {
    for (n, repeats) in [(128, false), (99, false), (128, true)] {
        let coarse = self_affine_contact(n, repeats, None);
        let even = self_affine_contact(n, repeats, Some(&vec![1.0; n * n]));
        let square = |values: &mut dyn Iterator<Item = f64>| values.map(|v| v * v).sum::<f64>();
        let pairs = coarse.pressure.iter().zip(&even.pressure);
        let off = square(&mut pairs.map(|(one, other)| one - other));
        let off = (off / square(&mut even.pressure.iter().copied())).sqrt();
        // Residuals of 1e-8 times what the condition makes of them.
        assert!(off < 2e-7, "{n} {repeats}: {off:e}");
        assert!(coarse.applications < even.applications, "{n} {repeats}");
    }
}

/// Counts of this program: from a first guess of Hertz's form, 50 and 46.
#[test]
fn rough_contact_takes_few_applications() {
    for (repeats, most) in [(false, 42), (true, 40)] {
        let outcome = self_affine_contact(256, repeats, None);
        assert!(outcome.applications <= most, "{} applications", outcome.applications);
    }
}
