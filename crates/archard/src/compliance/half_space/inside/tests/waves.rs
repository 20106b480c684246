//! Fields of tractions that repeat themselves.

use std::f64::consts::TAU;

use approx::assert_relative_eq;

use super::Below;
use crate::Material;
use crate::body::Layer;
use crate::compliance::Compliance;
use crate::compliance::half_space::Periodic;
use crate::frame::{ContactFrame, Rectangle, VectorField};

const SIZE: [f64; 2] = [1e-3, 0.5e-3];
const ELEMENTS: [usize; 2] = [32, 16];

/// Below tractions (Pa) on the body along x and y and a pressure, functions of the place (m).
fn below(tractions: impl Fn([f64; 2]) -> [f64; 3]) -> Below {
    let (frame, field) = pressed(tractions);
    let steel = Material::new(210e9, 0.3).unwrap();
    Below::new(&steel, &frame, &field, 1e-2).unwrap()
}

/// A frame under these tractions.
fn pressed(tractions: impl Fn([f64; 2]) -> [f64; 3]) -> (ContactFrame, VectorField) {
    let corner = [0, 1].map(|axis| -0.5 * SIZE[axis]);
    let rectangle = Rectangle { centre: [0.0; 2], size: SIZE };
    let flat = &crate::body::profile::Flat;
    let frame = ContactFrame::uniform(rectangle, ELEMENTS, [flat, flat]).unwrap();
    let spacing = frame.spacing();
    let mut field = VectorField::zeros(frame.len());
    for pair in 0..frame.len() {
        let at = [pair % ELEMENTS[0], pair / ELEMENTS[0]];
        let place = [0, 1].map(|axis| corner[axis] + spacing[axis] * (at[axis] as f64 + 0.5));
        let [x, y, p] = tractions(place);
        (field.t1[pair], field.t2[pair], field.n[pair]) = (x, y, -p);
    }
    (frame, field)
}

/// The stresses are in balance, meet the tractions on the surface, and are those of Hooke's law with strains that fit together: the
/// trace is harmonic, and the laplacian of each component is minus its second derivative over 1 + nu (Beltrami and Michell).
#[test]
fn waves_are_fields_of_an_elastic_body() {
    let [p, q] = [TAU * 2.0 / SIZE[0], TAU / SIZE[1]];
    let tractions = |[x, y]: [f64; 2]| {
        let [one, other] = [(p * x + q * y + 0.3).cos(), (p * x - q * y).sin()];
        [2e6 * one + 1e6, 1.5e6 * other - 0.5e6, 5e6 + 3e6 * other + 2e6 * one]
    };
    let below = below(tractions).repeated(DEPTH);
    let h = 5e-7;
    let stress = |[x, y, z]: [f64; 3]| below.stress([x, y, z]);
    for place in [[0.1e-3, 0.07e-3, -0.05e-3], [-0.2e-3, 0.11e-3, -0.09e-3]] {
        let moved = |axis: usize, by: f64| {
            let mut moved = place;
            moved[axis] += by;
            stress(moved)
        };
        let slope = |axis: usize, c: usize| (moved(axis, h)[c] - moved(axis, -h)[c]) / (2.0 * h);
        for [x, y, z] in [[0, 3, 4], [3, 1, 5], [4, 5, 2]] {
            let sum = slope(0, x) + slope(1, y) + slope(2, z);
            let size = slope(0, x).abs() + slope(1, y).abs() + slope(2, z).abs();
            assert!(sum.abs() < 1e-4 * size, "{sum} {size}");
        }
        let here = stress(place);
        let second = |axis: usize, of: &dyn Fn([f64; 6]) -> f64| {
            (of(moved(axis, h)) + of(moved(axis, -h)) - 2.0 * of(here)) / (h * h)
        };
        let trace = |s: [f64; 6]| s[0] + s[1] + s[2];
        let laplacian =
            |of: &dyn Fn([f64; 6]) -> f64| (0..3).map(|axis| second(axis, of)).sum::<f64>();
        let size = (0..3).map(|axis| second(axis, &trace).abs()).sum::<f64>();
        assert!(laplacian(&trace).abs() < 1e-3 * size, "{} {size}", laplacian(&trace));
        for c in 0..3 {
            let own = laplacian(&|s| s[c]) + second(c, &trace) / 1.3;
            assert!(own.abs() < 1e-3 * size, "{c}: {own} {size}");
        }
    }
    // On the surface, at the centre of an element.
    let element = 5 + ELEMENTS[0] * 3;
    let [x, y] = below.place(element);
    let [along, across, pressure] = tractions([x, y]);
    let [_, _, zz, _, xz, yz] = stress([x, y, 0.0]);
    assert_relative_eq!(zz, -pressure, max_relative = 1e-9);
    assert_relative_eq!(xz, along, max_relative = 1e-9);
    assert_relative_eq!(yz, across, max_relative = 1e-9);
    // A plane is what its points are.
    let plane = below.plane(0.04e-3);
    let known = stress([x, y, -0.04e-3]);
    for (plane, known) in plane.iter().zip(known) {
        assert_relative_eq!(plane[element], known, max_relative = 1e-9, epsilon = 1e-3);
    }
}

/// A contact in the middle of a frame much wider than it has the stresses of one that stands alone, but for the even part.
#[test]
fn a_small_spot_has_the_stresses_of_a_half_space() {
    let spot = |[x, y]: [f64; 2]| {
        let left = 1.0 - (x * x + y * y) / (0.09e-3f64).powi(2);
        let pressure = 1e9 * left.max(0.0);
        [0.2 * pressure, -0.1 * pressure, pressure]
    };
    let [repeated, alone] = [below(spot).repeated(DEPTH), below(spot)];
    let peak = 1e9;
    for place in [[0.0, 0.0, -0.06e-3], [0.03e-3, -0.02e-3, -0.05e-3]] {
        let [one, other] = [&repeated, &alone].map(|below| below.stress(place));
        for (one, other) in one.iter().zip(other) {
            assert!((one - other).abs() < 0.05 * peak, "{one} {other}");
        }
    }
}

/// How deep below the contact (m) displacements of tests are measured from.
const DEPTH: f64 = 4e-3;

/// Waves of pressure and of friction along and across them (K. L. Johnson, *Contact Mechanics*, section 13.2 for those of pressure; those of
/// friction by Airy's function and by shear out of the plane), on a mean of each.
#[test]
fn a_wave_of_tractions_has_its_closed_form_at_any_place() {
    let k = TAU * 3.0 / SIZE[0];
    let (g, n) = (210e9 / 2.6, 0.3);
    let [p, q, t] = [4e6, 3e6, 2e6];
    let means = [0.5e6, -0.7e6, 5e6];
    let below = below(|[x, _]| {
        let wave = (k * x).cos();
        [means[0] + q * wave, means[1] + t * wave, means[2] + p * wave]
    });
    let below = below.repeated(DEPTH);
    let mut places = vec![];
    for x in [-0.43e-3, 0.0, 0.117e-3] {
        places.extend([0.0, 3e-6, 0.05e-3, 0.4e-3].map(|z| [x, 0.03e-3, -z]));
    }
    for (place, (moved, stress)) in places.iter().zip(below.fields(&places)) {
        let [x, _, z] = *place;
        let d = -k * z;
        let [cos, sin] = [(k * x).cos(), (k * x).sin()].map(|own| own * (-d).exp());
        let xx = -p * (1.0 - d) * cos - q * (2.0 - d) * sin;
        let zz = -p * (1.0 + d) * cos - q * d * sin;
        let aside = -n / (1.0 - n) * means[2];
        let known = [
            xx + aside,
            n * (xx + zz) + aside,
            zz - means[2],
            -t * sin,
            p * d * sin + q * (1.0 - d) * cos + means[0],
            t * cos + means[1],
        ];
        for (found, known) in stress.iter().zip(known) {
            assert!((found - known).abs() < 1e-9 * p, "{place:?}: {found} {known}");
        }
        let far = 1.0 - 2.0 * n;
        let scale = 0.5 / (g * k);
        let down = DEPTH + z;
        let known = [
            scale * (q * (1.0 + far - d) * cos - p * (far - d) * sin) + down * means[0] / g,
            scale * 2.0 * t * cos + down * means[1] / g,
            -scale * (p * (1.0 + far + d) * cos + q * (far + d) * sin)
                - 0.5 * far / (1.0 - n) * down * means[2] / g,
        ];
        for (found, known) in moved.iter().zip(known) {
            assert!((found - known).abs() < 1e-9 * DEPTH * p / g, "{place:?}: {found} {known}");
        }
        assert_eq!(below.displacement(*place), moved);
        assert_eq!(below.stress(*place), stress);
    }
}

/// With layers too, which move as one across their interfaces.
#[test]
fn the_surface_moves_as_the_compliance_of_waves_says() {
    let steel = Material::new(210e9, 0.3).unwrap();
    let layer = |young: f64, poisson: f64, thickness: f64| Layer {
        material: Material::new(young, poisson).unwrap(),
        thickness,
    };
    let stacks = [vec![], vec![layer(400e9, 0.2, 0.04e-3), layer(5e9, 0.4, 0.1e-3)]];
    let bases = [Some(&steel), None];
    let spot = |[x, y]: [f64; 2]| {
        let left: f64 = (x * x + 2.0 * y * y + x * y) / (0.2e-3f64).powi(2);
        let pressure = 1e9 * (1.0 - left).max(0.0);
        [0.2 * pressure, 1e7 - 0.1 * pressure, pressure]
    };
    for (layers, base) in [(0, 0), (1, 0), (1, 1)] {
        let (layers, base) = (&stacks[layers][..], bases[base]);
        let (frame, tractions) = pressed(spot);
        let compliance = Periodic::new([base, None], [layers, &[]], [DEPTH; 2], &frame);
        let known = compliance.apply(&tractions);
        let below = below(spot).layered(layers, base).repeated(DEPTH);
        let largest = known.n.iter().fold(0.0, |most: f64, own| most.max(own.abs()));
        for element in [0, 17, 5 + ELEMENTS[0] * 3, 16 + ELEMENTS[0] * 8] {
            let [x, y] = below.place(element);
            let found = below.displacement([x, y, 0.0]);
            for (found, known) in found.iter().zip(known.components()) {
                let known = known[element];
                assert!((found - known).abs() < 1e-9 * largest, "{element}: {found} {known}");
            }
        }
        for (upper, [_, end]) in below.pieces().into_iter().enumerate() {
            if upper + 1 < below.pieces().len() {
                let sides = [upper, upper + 1]
                    .map(|piece| below.within(piece).displacement([0.1e-3, 0.03e-3, -end]));
                for (one, other) in sides[0].iter().zip(sides[1]) {
                    assert!((one - other).abs() < 1e-9 * largest, "{upper}: {one} {other}");
                }
            }
        }
    }
}
