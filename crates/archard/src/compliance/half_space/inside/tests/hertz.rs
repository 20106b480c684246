//! Pressures of Hertz under balls and along lines, with friction in proportion: the radius and the largest pressure are one.

use std::f64::consts::PI;

use super::{Below, near, square};
use crate::closed_form::sliding_line;
use crate::stress::Components;

/// The mean of the pressure over elements of a frame four radii wide; tractions mu times as large along x.
pub(super) fn ball(per_radius: usize, mu: f64, pressing: f64) -> Below {
    let h = 1.0 / per_radius as f64;
    let n = 4 * per_radius;
    // Gauss's rule of eight along x; along y the integral is known.
    let root = |x2: f64, y: f64| -> f64 {
        let c = (1.0 - x2).max(0.0);
        let y = y.clamp(-c.sqrt(), c.sqrt());
        let angle = if c > 0.0 { (y / c.sqrt()).clamp(-1.0, 1.0).asin() } else { 0.0 };
        0.5 * (y * (c - y * y).max(0.0).sqrt() + c * angle)
    };
    square(
        [n, n],
        h,
        |[x, y]| {
            let parts = 32;
            let mean: f64 = (0..parts)
                .map(|i| {
                    let x = x + h * ((f64::from(i) + 0.5) / f64::from(parts) - 0.5);
                    (root(x * x, y + 0.5 * h) - root(x * x, y - 0.5 * h)) / h
                })
                .sum::<f64>()
                / f64::from(parts);
            [mu * mean, 0.0, pressing * mean]
        },
        None,
    )
}

/// The same along a line, without approximation.
fn line(per_radius: usize, mu: f64) -> Below {
    let h = 1.0 / per_radius as f64;
    let all = |x: f64| {
        let x = x.clamp(-1.0, 1.0);
        0.5 * (x * (1.0 - x * x).sqrt() + x.asin())
    };
    square(
        [4 * per_radius, 1],
        h,
        |[x, _]| {
            let mean = (all(x + 0.5 * h) - all(x - 0.5 * h)) / h;
            [mu * mean, 0.0, mean]
        },
        Some(10.0),
    )
}

/// Hankel integrals of the pressure (independent, to 1e-15), nu = 0.3, mu = 0.3, z into the body.
const TABLE: [([f64; 3], Components); 3] = [
    ([0.0, 0.0, 0.25], [-0.398521, -0.398521, -0.941176, 0.0, -0.159669, 0.0]),
    ([0.5, 0.3, 0.5], [-0.216950, -0.147240, -0.640305, -0.030807, -0.217032, -0.096490]),
    ([-1.1, 0.2, 0.2], [0.046580, -0.074926, -0.035313, -0.011830, 0.036401, -0.009945]),
];

#[test]
fn a_sliding_ball_has_the_stresses_of_hankel_integrals() {
    let grids = [ball(24, 0.3, 1.0), ball(48, 0.3, 1.0)];
    for ([x, y, z], known) in TABLE {
        let [coarse, fine] = grids.each_ref().map(|below| below.stress([x, y, -z]));
        let limit = std::array::from_fn(|i| (4.0 * fine[i] - coarse[i]) / 3.0);
        let [xx, yy, zz, xy, xz, yz] = known;
        near(limit, [xx, yy, zz, xy, -xz, -yz], 1e-5);
    }
}

/// Johnson, section 3.4: on the axis, and on the surface beyond the circle.
#[test]
fn a_ball_has_the_stresses_on_its_axis() {
    let nu = 0.3;
    for z in [0.1f64, 0.48, 2.0] {
        let zz = -1.0 / (1.0 + z * z);
        let rr = -(1.0 + nu) * (1.0 - z * (1.0 / z).atan()) - 0.5 * zz;
        let [coarse, fine] = [24, 48].map(|per| ball(per, 0.0, 1.0).stress([0.0, 0.0, -z]));
        let limit = std::array::from_fn(|i| (4.0 * fine[i] - coarse[i]) / 3.0);
        near(limit, [rr, rr, zz, 0.0, 0.0, 0.0], 2e-5);
    }
}

/// Hamilton & Goodman, *J. Appl. Mech.* 33 (1966) 371: friction alone, on the surface inside the circle. Without what varies within
/// elements the first order would be left.
#[test]
fn on_the_surface_friction_has_the_second_order() {
    let nu = 0.3;
    let missed = [8, 16].map(|per| {
        // A pressure of no weight says what is pressed.
        let below = ball(per, 1.0, 1e-9);
        let plane = below.plane(0.0);
        let at = |field: usize, element: usize| plane[field][element];
        let mut missed: f64 = 0.0;
        for element in 0..below.pressure().len() {
            let [x, y] = below.place(element);
            if x.hypot(y) < 0.7 {
                let known = [
                    -PI * (4.0 + nu) * x / 8.0,
                    -3.0 * PI * nu * x / 8.0,
                    -PI * (2.0 - nu) * y / 8.0,
                ];
                for (field, known) in [0, 1, 3].into_iter().zip(known) {
                    missed = missed.max((at(field, element) - known).abs());
                }
            }
        }
        missed
    });
    assert!(missed[0] / missed[1] > 3.0 && missed[1] < 2e-3, "{missed:?}");
}

/// With z out of the body.
fn sliding([x, z]: [f64; 2]) -> Components {
    super::super::turned(sliding_line::stress([x, z], 0.4, 0.3))
}

#[test]
fn a_sliding_line_has_the_stresses_of_mcewen_with_the_second_order() {
    for depth in [0.02, 0.25, 0.8] {
        let missed = [20, 40, 80].map(|per| {
            let below = line(per, 0.4);
            let plane = below.plane(depth);
            let missed = (0..below.pressure().len()).map(|element| {
                let [x, _] = below.place(element);
                if x.abs() > 0.8 {
                    return 0.0;
                }
                let known = sliding([x, depth]);
                let each = (0..6).map(|i| (plane[i][element] - known[i]).abs());
                each.fold(0.0, f64::max)
            });
            missed.fold(0.0, f64::max)
        });
        assert!(missed[2] < 2e-3 && missed[0] / missed[2] > 9.0, "{depth}: {missed:?}");
        // Along y nothing changes, and stresses at points are those of the plane.
        let below = line(40, 0.4);
        near(below.stress([0.3, 5.0, -0.8]), sliding([0.3, 0.8]), 1e-3);
    }
}
