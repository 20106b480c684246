//! Stresses below the surface against closed forms that share none of their formulas.

mod hertz;
mod kernels;
mod layered;
mod tree;
mod waves;

use super::Below;
use crate::body::Material;
use crate::stress::Components;

const STEEL: Material = Material { young: 2.6, poisson: 0.3 };

/// Even elements of that size under tractions (x, y, into the body), the lowest corner of the frame at half of its size.
fn square(
    elements: [usize; 2],
    h: f64,
    traction: impl Fn([f64; 2]) -> [f64; 3],
    line: Option<f64>,
) -> Below {
    let corner = elements.map(|n| -0.5 * h * n as f64);
    let place = |element: usize| {
        [element % elements[0], element / elements[0]].map(|index| h * (index as f64 + 0.5))
    };
    let all: Vec<[f64; 3]> = (0..elements[0] * elements[1])
        .map(|element| {
            let at = place(element);
            traction([corner[0] + at[0], corner[1] + at[1]])
        })
        .collect();
    let tractions = [0, 1, 2].map(|axis| all.iter().map(|own| own[axis]).collect());
    Below::on(STEEL, (elements, [h; 2], corner), tractions, line)
}

#[track_caller]
fn near(found: Components, known: Components, within: f64) {
    for (component, (found, known)) in found.iter().zip(known).enumerate() {
        assert!((found - known).abs() <= within, "{component}: {found} for {known}");
    }
}
