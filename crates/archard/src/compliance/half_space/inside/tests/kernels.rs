//! One rectangle, one strip: a solution of the equations of elasticity that bears its traction and no other.

use std::f64::consts::PI;

use super::{STEEL, near, square};
use crate::body::profile::Flat;
use crate::compliance::Compliance;
use crate::compliance::half_space::HalfSpace;
use crate::compliance::half_space::inside::Below;
use crate::frame::{ContactFrame, VectorField};

/// Random numbers between -1 and 1.
pub(super) fn random() -> impl FnMut() -> f64 {
    let mut state = 7u64;
    move || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}

/// A half-space under uneven tractions along three axes, and a line.
fn bodies() -> [Below; 2] {
    let (mut one, mut two) = (random(), random());
    let plane = std::cell::RefCell::new(move || [one(), one(), one()]);
    let line = std::cell::RefCell::new(move || [two(), two(), two()]);
    [
        square([4, 3], 0.4, |_| plane.borrow_mut()(), None),
        square([5, 1], 0.3, |_| line.borrow_mut()(), Some(6.0)),
    ]
}

const PLACES: [[f64; 3]; 3] = [[0.13, -0.21, -0.57], [1.1, 0.4, -0.45], [-0.5, 0.9, -1.3]];

/// Central differences, for a field of N numbers: [axis][component].
fn slopes<const N: usize>(field: impl Fn([f64; 3]) -> [f64; N], place: [f64; 3]) -> [[f64; N]; 3] {
    let d = 1e-4;
    [0, 1, 2].map(|axis| {
        let at = |side: f64| {
            let mut place = place;
            place[axis] += side * d;
            field(place)
        };
        // Of the fourth order.
        let [near, far] = [1.0, 2.0].map(|side| {
            let (high, low) = (at(side), at(-side));
            std::array::from_fn::<f64, N, _>(|i| (high[i] - low[i]) / (2.0 * side * d))
        });
        std::array::from_fn(|i| (4.0 * near[i] - far[i]) / 3.0)
    })
}

/// On the surface logarithms of corners cancel: displacements in line with edges, and at corners, are those a little below.
#[test]
fn displacements_at_edges_on_the_surface_are_finite() {
    for below in bodies() {
        for at in [[0.0, 0.0], [0.0, 0.13], [0.4, -2.0], [3.0, 0.2]] {
            let [on, under] = [0.0, -1e-9].map(|z| below.displacement([at[0], at[1], z]));
            for (on, under) in on.iter().zip(under) {
                assert!((on - under).abs() < 1e-6, "{at:?}: {on} {under}");
            }
        }
    }
}

/// Hooke's law turns the slopes of displacements into stresses, and these are in equilibrium.
#[test]
fn displacements_and_stresses_solve_the_equations_of_elasticity() {
    let (g, n) = (STEEL.young / 2.0 / (1.0 + STEEL.poisson), STEEL.poisson);
    for below in bodies() {
        for place in PLACES {
            let u = slopes(|place| below.displacement(place), place);
            let sum = u[0][0] + u[1][1] + u[2][2];
            let own = |i: usize| 2.0 * g * (u[i][i] + n / (1.0 - 2.0 * n) * sum);
            let shear = |i: usize, j: usize| g * (u[i][j] + u[j][i]);
            let known = [own(0), own(1), own(2), shear(0, 1), shear(0, 2), shear(1, 2)];
            near(below.even([place[0], place[1]], -place[2]), known, 2e-10);
            let s = slopes(|[x, y, z]| below.even([x, y], -z), place);
            for rows in [[0, 3, 4], [3, 1, 5], [4, 5, 2]] {
                let left = s[0][rows[0]] + s[1][rows[1]] + s[2][rows[2]];
                assert!(left.abs() < 1e-9, "{left}");
            }
        }
    }
}

#[test]
fn the_surface_bears_the_tractions_and_displacements_are_those_of_the_compliance() {
    for below in bodies() {
        let line = below.depth;
        let [nx, ny] = below.elements();
        let size = [nx, ny].map(|n| n as f64 * below.spacing[0]);
        let frame = match line {
            None => ContactFrame::uniform(size, [nx, ny], [&Flat, &Flat]).unwrap(),
            Some(_) => ContactFrame::line(size, [nx, 1], [&Flat, &Flat]).unwrap(),
        };
        let [t1, t2, into] = (*below.tractions).clone();
        let n = into.iter().map(|value| -value).collect();
        let tractions = VectorField { t1, t2, n };
        let compliance = match line {
            None => HalfSpace::new([Some(&STEEL), None], &frame),
            Some(depth) => {
                HalfSpace::plane_strain([Some(&STEEL), None], [&[]; 2], [depth; 2], &frame)
            }
        };
        let known = compliance.apply(&tractions);
        for element in 0..nx * ny {
            let [x, y] = below.place(element);
            let stress = below.even([x, y], 0.0);
            let t = tractions.components().map(|own| own[element]);
            for (component, own) in [(4, t[0]), (5, t[1]), (2, t[2])] {
                assert!((stress[component] - own).abs() < 1e-14, "{component}");
            }
            let u = below.displacement([x, y, 0.0]);
            for (found, known) in u.into_iter().zip(known.components()) {
                assert!((found - known[element]).abs() < 1e-13, "{found} {}", known[element]);
            }
        }
    }
}

#[test]
fn a_plane_holds_what_sums_at_its_places_say() {
    let mut bodies = Vec::from(bodies());
    // Frictionless, and with neighbours that are pressed.
    bodies.push(square([6, 5], 0.3, |[x, y]| [0.0, 0.0, 2.0 + x - y * y], None));
    bodies.push(square([6, 5], 0.3, |[x, y]| [x * y, x + y, 2.0 + x - y * y], None));
    for below in bodies {
        for depth in [0.0, 0.03, 0.2, 1.1] {
            let plane = below.plane(depth);
            for element in 0..below.pressure().len() {
                let [x, y] = below.place(element);
                let found = plane.each_ref().map(|field| field[element]);
                let known = if depth < 0.4 {
                    below.stress([x, y, -depth])
                } else {
                    below.even([x, y], depth)
                };
                let added = below.varying(depth).at(&below, element);
                let left = if depth < 0.4 { [0.0; 6] } else { added };
                near(found, std::array::from_fn(|i| known[i] + left[i]), 2e-14);
            }
        }
    }
}

/// Boussinesq and Cerruti (Johnson, sections 3.2 and 3.6), far from a small element.
#[test]
fn far_away_an_element_is_a_point_force() {
    let n = STEEL.poisson;
    let [x, y, z] = [0.7, -0.4, 0.6f64];
    let r = (x * x + y * y + z * z).sqrt();
    let (f, r2) = (1.0 - 2.0 * n, x * x + y * y);
    let pressed = [
        [x, y].map(|own| {
            let aside = r2 - own * own;
            f / r2 * ((1.0 - z / r) * (own * own - aside) / r2 + z * aside / r.powi(3))
                - 3.0 * z * own * own / r.powi(5)
        }),
        [-3.0 * z.powi(3) / r.powi(5), 0.0],
    ];
    let xy = f / r2 * ((1.0 - z / r) * x * y * 2.0 / r2 - x * y * z / r.powi(3))
        - 3.0 * x * y * z / r.powi(5);
    let [xz, yz] = [x, y].map(|own| -3.0 * own * z * z / r.powi(5));
    let boussinesq = [pressed[0][0], pressed[0][1], pressed[1][0], xy, xz, yz];
    let h = 1e-3;
    let element = |t: [f64; 3]| square([1, 1], h, |_| t, None).even([x, y], z);
    // From z into the body to z out of it.
    let known = boussinesq.map(|value| value * h * h / (2.0 * PI));
    near(super::super::turned(element([0.0, 0.0, 1.0])), known, 1e-6 * h * h);
    let s = r + z;
    let cerruti = [
        -3.0 * x.powi(3) / r.powi(5)
            + f * (x / r.powi(3) - 3.0 * x / (r * s * s)
                + x.powi(3) / (r.powi(3) * s * s)
                + 2.0 * x.powi(3) / (r * r * s.powi(3))),
        -3.0 * x * y * y / r.powi(5)
            + f * (x / r.powi(3) - x / (r * s * s)
                + x * y * y / (r.powi(3) * s * s)
                + 2.0 * x * y * y / (r * r * s.powi(3))),
        -3.0 * x * z * z / r.powi(5),
        -3.0 * x * x * y / r.powi(5)
            + f * (-y / (r * s * s)
                + x * x * y / (r.powi(3) * s * s)
                + 2.0 * x * x * y / (r * r * s.powi(3))),
        -3.0 * x * x * z / r.powi(5),
        -3.0 * x * y * z / r.powi(5),
    ];
    let known = cerruti.map(|value| value * h * h / (2.0 * PI));
    near(super::super::turned(element([1.0, 0.0, 0.0])), known, 1e-6 * h * h);
}
