//! Sums over squares of elements against sums over all of them.

use super::kernels::random;
use super::layered::{HARD, SOFT, Stacked, under};
use super::square;
use crate::compliance::half_space::inside::{Below, corner, sums::Sums, tree};

const ELEMENTS: [usize; 2] = [150, 70];
const H: f64 = 0.02;

/// Element by element, each from its four corners or, by layers, with the images of these.
fn one_by_one(below: &Below, at: [f64; 2], z: f64) -> Sums {
    let mut sums = Sums::default();
    let poisson = below.material(z).poisson;
    below.corners(&below.elements.map(|count| 0..count), |corner, change| {
        let functions = corner::functions([at[0] - corner[0], at[1] - corner[1]], z);
        let stress = corner::stress(&functions, poisson);
        let moved = corner::displacement(&functions, poisson, z);
        for (axis, change) in change.iter().enumerate() {
            let share = change / std::f64::consts::TAU;
            (0..6).for_each(|i| sums.0[i] += share * stress[axis][i]);
            (0..3).for_each(|i| sums.1[i] += share * moved[axis][i]);
        }
    });
    if let Some((layers, piece)) = below.piece(z) {
        let far = layers.far(piece, z);
        for element in 0..below.pressure().len() {
            let place = below.place(element);
            let from = [at[0] - place[0], at[1] - place[1]];
            let own = far.element(from, below.spacing.map(|h| 0.5 * h));
            for axis in 0..3 {
                let traction = below.tractions[axis][element];
                (0..6).for_each(|i| sums.0[i] += traction * own.0[axis][i]);
                (0..3).for_each(|i| sums.1[i] += traction * own.1[axis][i]);
            }
        }
    }
    sums
}

/// Random tractions, which no polynomial fits: those up to one on a frame of any number of squares.
#[test]
fn squares_of_elements_do_what_their_elements_do() {
    let mut random = random();
    let all: Vec<[f64; 3]> =
        (0..ELEMENTS[0] * ELEMENTS[1]).map(|_| [random(), random(), random()]).collect();
    let next = std::cell::Cell::new(0);
    let traction = |_| {
        next.set(next.get() + 1);
        all[next.get() - 1]
    };
    let bare = square(ELEMENTS, H, traction, None);
    let stacked = |stacked: Stacked| {
        next.set(0);
        under(square(ELEMENTS, H, traction, None), stacked)
    };
    let size = H * ELEMENTS[0] as f64;
    for (below, images) in [(bare, 0.0), (stacked(HARD), 1e-5), (stacked(SOFT), 1e-5)] {
        for (x, y) in [(0.01, 0.01), (0.31, -0.17), (-1.49, 0.69), (1.11, 0.43), (2.41, 0.11)] {
            for depth in [0.0, 0.4 * H, 2.0 * H, 0.15, 0.299, 0.7, 3.0] {
                let (found, known) = (below.sums([x, y], depth), one_by_one(&below, [x, y], depth));
                for (found, known) in found.0.iter().zip(known.0) {
                    let off = (found - known).abs();
                    assert!(off < tree::MISSED + images, "{x} {y} {depth}: {found} {known}");
                }
                for (found, known) in found.1.iter().zip(known.1) {
                    let off = (found - known).abs();
                    assert!(
                        off < size * (tree::MISSED + images),
                        "{x} {y} {depth}: {found} {known}"
                    );
                }
            }
        }
    }
}
