//! What elements do by the images of a layer, corner by corner, and strips edge by edge.
//!
//! With ss, nn, ... the components of a wave from pressure (`z`), from a traction along it (`s`) and across it (`n`), the stresses along x
//! and y are, with c and s the cosine and sine of its direction,
//!
//! ```text
//! xx = c^2 ss + s^2 nn - 2 c s sn    yy = s^2 ss + c^2 nn + 2 c s sn    xy = c s (ss - nn) + (c^2 - s^2) sn
//! xz = c sz - s nz                   yz = s sz + c nz
//! ```

use super::layers::Seen;
use super::{corner, strip};
use crate::stress::Components;

/// Stresses, and displacements times twice the shear modulus (m), from unit tractions along x, y and into the body; z goes into the body.
pub(super) type Rest = ([Components; 3], [[f64; 3]; 3]);

fn add<const N: usize>(sum: &mut [[f64; N]; 3], own: [[f64; N]; 3], factor: f64) {
    for (sum, own) in sum.iter_mut().flatten().zip(own.into_iter().flatten()) {
        *sum += factor * own;
    }
}

/// What there is at X and Y from a corner of elements (m).
pub(super) fn at_corner(seen: &[Seen], at: [f64; 2]) -> Rest {
    let (mut stresses, mut moved) = ([[0.0; 6]; 3], [[0.0; 3]; 3]);
    for image in seen {
        let own = corner::functions(at, image.distance);
        let [e, cc, cs, ic, is, icss, iscc, qcc, qss, qcs, qic, qis, qicss, qiscc, rest @ ..] = own;
        let even = [e, cc, cs, ic, is, icss, iscc];
        let times = [qcc + qss, qcc, qcs, qic, qis, qicss, qiscc];
        add(&mut stresses, components(even, &image.stress[0]), 1.0);
        add(&mut stresses, components(times, &image.stress[1]), image.from / image.distance);
        add(&mut moved, displacements(rest, &image.moved[0]), 1.0);
        add(&mut moved, displacements([cc, e - cc, cs, ic, is], &image.moved[1]), image.from);
    }
    (stresses, moved)
}

/// The components by the functions E, c^2 E, c s E, i c E, i s E, i c s^2 E and i s c^2 E of a wave.
pub(super) fn components(
    [e, cc, cs, ic, is, icss, iscc]: [f64; 7],
    &[zz, ss, nn, sz, tz, ts, tn, tsz, nz, sn]: &[f64; 10],
) -> [Components; 3] {
    let (others, iccc, isss) = (e - cc, ic - icss, is - iscc);
    let (aside, apart, mixed) = (tn + 2.0 * sn, ts - 2.0 * sn, ts - tn - sn);
    let slant = (tsz - nz) * cs;
    [
        [
            ts * iccc + aside * icss,
            apart * icss + tn * iccc,
            tz * ic,
            mixed * iscc + sn * isss,
            tsz * cc + nz * others,
            slant,
        ],
        [
            apart * iscc + tn * isss,
            ts * isss + aside * iscc,
            tz * is,
            mixed * icss + sn * iccc,
            slant,
            tsz * others + nz * cc,
        ],
        [ss * cc + nn * others, ss * others + nn * cc, zz * e, (ss - nn) * cs, sz * ic, sz * is],
    ]
}

/// The displacements by the functions c^2, s^2, c s, i c and i s.
pub(super) fn displacements(
    [cc, ss, cs, ic, is]: [f64; 5],
    &[along, into, pushed, sunk, across]: &[f64; 5],
) -> [[f64; 3]; 3] {
    let slant = (pushed - across) * cs;
    [
        [pushed * cc + across * ss, slant, sunk * ic],
        [slant, pushed * ss + across * cc, sunk * is],
        [along * ic, along * is, into * (cc + ss)],
    ]
}

/// What there is at X from an edge of strips (m): waves along x alone.
pub(super) fn at_edge(seen: &[Seen], x: f64) -> Rest {
    let (mut stresses, mut moved) = ([[0.0; 6]; 3], [[0.0; 3]; 3]);
    let plane = |e: f64, i: f64, own: &[f64; 10]| {
        let &[zz, ss, nn, sz, tz, ts, tn, tsz, nz, sn] = own;
        [
            [ts * i, tn * i, tz * i, 0.0, tsz * e, 0.0],
            [0.0, 0.0, 0.0, sn * i, 0.0, nz * e],
            [ss * e, nn * e, zz * e, 0.0, sz * i, 0.0],
        ]
    };
    let shift = |e: f64, i: f64, &[along, into, pushed, sunk, across]: &[f64; 5]| {
        [[pushed * e, 0.0, sunk * i], [0.0, across * e, 0.0], [along * i, 0.0, into * e]]
    };
    for image in seen {
        let [e, q, i, iq, n, ni] = strip::functions(x, image.distance);
        add(&mut stresses, plane(e, i, &image.stress[0]), 1.0);
        add(&mut stresses, plane(q, iq, &image.stress[1]), image.from / image.distance);
        add(&mut moved, shift(n, ni, &image.moved[0]), 1.0);
        add(&mut moved, shift(e, i, &image.moved[1]), image.from);
    }
    (stresses, moved)
}
