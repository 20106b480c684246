//! Contract of lines that wear as one: a compliance as any other, which longer steps do not make harder to solve.

use approx::assert_relative_eq;
use archard::compliance::{Compliance, WornLines};
use archard::frame::Direction;
use archard::motion::Control;
use archard::solve::{Start, Status, Step};

use super::rolling::{DIRECTIONS, ELEMENTS, PAIRS, arbitrary, compliances, dot, norm, small_frame};
use crate::common::{Ball, at_rest, solver};

/// Slopes (m/Pa) of lines that wear unevenly.
fn slopes(lines: usize, slope: f64) -> Vec<f64> {
    (0..lines).map(|line| slope * (1.0 + 0.5 * (line as f64).cos())).collect()
}

/// The elastic compliance and, in every line, the slope times the sum of its pressures; symmetric and
/// positive, and so is its preconditioner.
#[test]
fn planes_that_wear_are_symmetric_and_positive() {
    let frame = small_frame();
    // Some lines touch, others do not, and preconditioners see the contact alone.
    let bowl = |[x, y]: [f64; 2]| (1.0 - (x / 0.5e-3).powi(2) - (y / 0.3e-3).powi(2)).max(0.0);
    let pressure: Vec<f64> = (0..PAIRS).map(|pair| bowl(frame.place(pair))).collect();
    let in_contact = |seed: u32| -> Vec<f64> {
        let numbers = arbitrary(seed).into_iter().zip(&pressure);
        numbers.map(|(number, &pressure)| if pressure > 0.0 { number } else { 0.0 }).collect()
    };
    let (a, b) = (in_contact(1), in_contact(2));
    for elastic in compliances(&frame) {
        for direction in DIRECTIONS {
            for slope in [0.0, 0.1, 1e6].map(|factor| factor * elastic.normal_self_term()) {
                let slopes = slopes(ELEMENTS[1 - direction.axis], slope);
                let worn =
                    WornLines::new(&elastic, frame.flow(direction).unwrap(), &slopes, &pressure);
                let image = |pressure: &[f64]| {
                    let mut displacement = vec![0.0; PAIRS];
                    worn.apply_normal(pressure, &mut displacement);
                    displacement
                };
                let mut expected = vec![0.0; PAIRS];
                elastic.apply_normal(&a, &mut expected);
                for (line, slope) in direction.lines(ELEMENTS).zip(&slopes) {
                    let sum: f64 = line.clone().map(|pair| a[pair]).sum();
                    line.for_each(|pair| expected[pair] += slope * sum);
                }
                let scale = norm([&expected, &[]]);
                for (found, expected) in image(&a).iter().zip(&expected) {
                    assert_relative_eq!(found, expected, epsilon = 1e-12 * scale);
                }
                let preconditioner = worn.normal_preconditioner(0.0);
                let precondition = |displacement: &[f64]| {
                    let mut pressure = vec![0.0; PAIRS];
                    preconditioner.apply(displacement, &mut pressure);
                    pressure
                };
                for map in [&image as &dyn Fn(&[f64]) -> Vec<f64>, &precondition] {
                    let (of_a, of_b) = (map(&a), map(&b));
                    let (aa, bb) = (dot(&a, &of_a), dot(&b, &of_b));
                    assert!(aa > 0.0 && bb > 0.0);
                    let skew = dot(&a, &of_b) - dot(&b, &of_a);
                    assert!(skew.abs() < 1e-12 * (aa * bb).sqrt());
                }
            }
        }
    }
}

/// Iterations of a step from unworn twin discs that makes a line wear by that many self terms under a unit
/// pressure on one pair.
fn iterations_of_a_step(direction: Direction, self_terms: f64) -> usize {
    let turn = |both: [f64; 2]| if direction.axis == 0 { both } else { [both[1], both[0]] };
    let elements = if direction.axis == 0 { [41, 81] } else { [81, 41] };
    let (size, radii) = (turn([0.52e-3, 6.4e-3]), turn([16.2e-3, 0.125]));
    let problem = Ball { size, radii, elements, ..Ball::pin_on_disc(1) }.problem();
    let (frame, elastic) = (&problem.frame, &*problem.compliance);
    let addition = vec![0.0; frame.len()];
    let rest = at_rest(&problem, &addition, Control::Load(300.0));
    let unworn = solver("conjugate_gradient", 1e-8).solve(&rest, None);
    let slopes = vec![self_terms * elastic.normal_self_term(); elements[1 - direction.axis]];
    let worn = WornLines::new(elastic, frame.flow(direction).unwrap(), &slopes, &unworn.pressure);
    let total = unworn.pressure.iter().sum();
    let foreseen = worn.foresee(frame.gap(), total, &unworn.pressure);
    let pressure = foreseen.unwrap_or(unworn.pressure);
    let mut displacement = vec![0.0; frame.len()];
    worn.apply_normal(&pressure, &mut displacement);
    let start =
        Start { pressure: &pressure, displacement: &displacement, part: None, approach: 0.0 };
    let step = Step { compliance: &worn, ..rest };
    let outcome = solver("conjugate_gradient", 1e-8).solve(&step, Some(start));
    assert_eq!(outcome.status, Status::Converged, "{self_terms} along {direction:?}");
    outcome.iterations
}

/// A thousand revolutions of the twin discs at 0.5 % are half a self term.
#[test]
fn longer_steps_of_wear_take_few_more_iterations() {
    for direction in DIRECTIONS {
        let short = iterations_of_a_step(direction, 0.01);
        for self_terms in [0.1, 1.0] {
            assert!(iterations_of_a_step(direction, self_terms) < 2 * short);
        }
    }
}
