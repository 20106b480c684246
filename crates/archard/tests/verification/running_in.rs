//! A flat round punch that slides and wears: its pressure evens out mode by mode.

use std::f64::consts::PI;

use approx::assert_relative_eq;
use archard::closed_form::flat_punch_wear::Modes;

use crate::common::{case, states};

/// Rates at which the first three modes decay on so many elements along a side.
///
/// An implicit step of T makes 1 / (1 + m T) of a mode, whatever its length, which tells m. The disc is a
/// staircase of whole elements; its radius is that of a circle of the same area.
fn rates(elements: usize, steps: usize) -> [f64; 3] {
    let case_file = include_str!("../../../../cases/running_in_flat_punch/case.toml");
    let elements = format!("frame.elements=[{elements}, {elements}]");
    let simulation = case(
        case_file,
        &[&elements, "output=", "motion.sliding.distance=20 mm", &format!("motion.sliding.step={} mm", 20.0 / steps as f64)],
    );
    let frame = &simulation.problem.frame;
    let states = states(&simulation).expect("it converges");
    let pairs: Vec<usize> = (0..frame.len()).filter(|&pair| frame.gap()[pair] == 0.0).collect();
    let radius = (pairs.len() as f64 * frame.element_area() / PI).sqrt();
    let modulus = 210e9 / (1.0 - 0.09);
    let time = 1e-13 * modulus * 0.02 / steps as f64 / radius;
    let modes = Modes::new(3).expect("three modes");
    let shares: Vec<[f64; 3]> = states
        .iter()
        .map(|(state, ..)| {
            [0, 1, 2].map(|mode| {
                let part = |&pair: &usize| {
                    let [x, y] = frame.place(pair);
                    let place = (x.hypot(y) / radius).min(1.0);
                    state.pressure[pair] * modes.shape(mode, place).expect("on the punch")
                };
                pairs.iter().map(part).sum::<f64>()
            })
        })
        .collect();
    for pair in shares.windows(2) {
        println!("{:?}", [0, 1, 2].map(|mode| (pair[0][mode] / pair[1][mode] - 1.0) / time));
    }
    [0, 1, 2].map(|mode| {
        let (first, last) = (shares[2][mode], shares[steps][mode]);
        ((first / last).powf(1.0 / (steps as f64 - 2.0)) - 1.0) / time
    })
}

#[test]
fn pressures_even_out_at_the_rates_of_the_modes() {
    for n in [32, 48, 64, 65, 96, 128] {
        println!("{n} {:?}", rates(n, 10));
    }
    assert_relative_eq!(1.0, 1.0);
}
