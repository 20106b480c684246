//! Bodies with layers: the equations of elasticity in each, what is continuous across interfaces, what the surface bears, and Hankel
//! integrals of an independent solution (layer by layer, by Airy's function in 50 digits) under the pressures of Hertz.

use super::hertz::ball;
use super::{Below, near, square};
use crate::body::profile::Flat;
use crate::body::{Layer, Material};
use crate::compliance::Compliance;
use crate::compliance::half_space::HalfSpace;
use crate::frame::{ContactFrame, VectorField};
use crate::stress::Components;

fn material(shear: f64, poisson: f64) -> Material {
    Material { young: 2.0 * (1.0 + poisson) * shear, poisson }
}

fn layers(all: &[[f64; 3]]) -> Vec<Layer> {
    let layer = |&[shear, poisson, thickness]: &[f64; 3]| Layer {
        material: material(shear, poisson),
        thickness,
    };
    all.iter().map(layer).collect()
}

/// A stack: shear modulus, Poisson's ratio and thickness of its layers, then the first two of what is below.
pub(super) type Stacked = (&'static [[f64; 3]], Option<[f64; 2]>);

pub(super) fn under(below: Below, (all, base): Stacked) -> Below {
    let base = base.map(|[shear, poisson]| material(shear, poisson));
    below.layered(&layers(all), base.as_ref())
}

pub(super) const HARD: Stacked = (&[[4.0, 0.25, 0.3]], Some([1.0, 0.3]));
pub(super) const SOFT: Stacked = (&[[0.25, 0.4, 0.5]], Some([1.0, 0.3]));
const RIGID: Stacked = (&[[1.0, 0.45, 0.6]], None);
const TWO: Stacked = (&[[5.0, 0.25, 0.2], [0.5, 0.35, 0.4]], Some([1.0, 0.3]));
const GRADED: Stacked = (
    &[[3.5, 0.2, 0.1], [3.0, 0.25, 0.1], [2.5, 0.25, 0.1], [2.0, 0.3, 0.1], [1.5, 0.3, 0.1]],
    Some([1.0, 0.3]),
);
const RUBBER: Stacked = (&[[1.0, 0.5, 0.3], [2.0, 0.3, 0.2]], None);

/// A place, the layer it is seen from, and the stress there, z into the body.
type Known = ([f64; 3], usize, Components);

#[test]
fn hertz_pressures_on_layers_have_the_stresses_of_hankel_integrals() {
    let all: [(Stacked, f64, &[Known]); 3] = [
        (
            HARD,
            0.2,
            &[
                ([0.0, 0.0, 0.15], 0, [-0.573349, -0.573349, -0.952899, 0.0, -0.110573, 0.0]),
                ([0.0, 0.0, 0.3], 0, [0.208812, 0.208812, -0.858854, 0.0, -0.042774, 0.0]),
                ([0.0, 0.0, 0.3], 1, [-0.230160, -0.230160, -0.858854, 0.0, -0.042774, 0.0]),
                (
                    [1.0, 0.2, 0.3],
                    0,
                    [-0.490140, 0.039871, -0.242112, -0.096689, -0.214997, -0.040848],
                ),
                (
                    [1.0, 0.2, 0.3],
                    1,
                    [-0.210248, -0.077745, -0.242112, -0.024172, -0.214997, -0.040848],
                ),
                (
                    [-0.6, 0.4, 0.7],
                    1,
                    [-0.055977, -0.047020, -0.361425, 0.019418, 0.118512, -0.085167],
                ),
            ],
        ),
        (
            SOFT,
            0.0,
            &[
                ([0.0, 0.0, 0.25], 0, [-0.478218, -0.478218, -0.969430, 0.0, 0.0, 0.0]),
                ([0.0, 0.0, 0.5], 0, [-0.518015, -0.518015, -0.852908, 0.0, 0.0, 0.0]),
                ([0.0, 0.0, 0.5], 1, [-0.204469, -0.204469, -0.852908, 0.0, 0.0, 0.0]),
                ([0.8, 0.0, 0.5], 0, [-0.281234, -0.264375, -0.433683, 0.0, -0.223783, 0.0]),
            ],
        ),
        (
            RIGID,
            0.1,
            &[
                ([0.0, 0.0, 0.3], 0, [-0.473357, -0.473357, -0.980539, 0.0, -0.058697, 0.0]),
                (
                    [0.9, 0.1, 0.3],
                    0,
                    [-0.315269, -0.171704, -0.366959, -0.014958, -0.162164, -0.015692],
                ),
                ([0.9, 0.1, 0.6], 0, [-0.278725, -0.278725, -0.340664, 0.0, -0.258414, -0.027118]),
            ],
        ),
    ];
    for (stack, mu, points) in all {
        let grids = [24, 48].map(|per_radius| under(ball(per_radius, mu, 1.0), stack));
        for &([x, y, z], piece, known) in points {
            let [coarse, fine] = grids.each_ref().map(|below| below.within(piece).even([x, y], z));
            let limit = std::array::from_fn(|i| (4.0 * fine[i] - coarse[i]) / 3.0);
            let [xx, yy, zz, xy, xz, yz] = known;
            near(limit, [xx, yy, zz, xy, -xz, -yz], 3e-5);
        }
    }
}

/// Elements of which none is like another, on a line or not.
fn loaded(line: bool) -> Below {
    let elements = if line { [7, 1] } else { [7, 6] };
    let traction = |[x, y]: [f64; 2]| [0.3 * x - y, 0.5 + x * y, 2.0 + x - y * y];
    square(elements, 0.1, traction, line.then_some(10.0))
}

const STACKS: [Stacked; 6] = [HARD, SOFT, RIGID, TWO, GRADED, RUBBER];

/// Balance, the trace and Beltrami and Michell's equations hold in every layer, by differences.
#[test]
fn stresses_in_layers_are_those_of_elastic_bodies() {
    for (line, stack) in [false, true].into_iter().flat_map(|line| STACKS.map(|own| (line, own))) {
        let below = under(loaded(line), stack);
        for (piece, [top, end]) in below.pieces().into_iter().enumerate() {
            let own = below.within(piece);
            let poisson = own.material(top).poisson;
            let z = if end.is_finite() { 0.3 * top + 0.7 * end } else { 1.4 * top };
            let d = 2e-3;
            let place = [0.23, if line { 0.0 } else { -0.11 }, -z];
            let stress = |place: [f64; 3]| own.even([place[0], place[1]], -place[2]);
            let moved = |axis: usize, by: f64| {
                let mut moved = place;
                moved[axis] += by;
                stress(moved)
            };
            let here = stress(place);
            let first =
                |axis: usize, c: usize| (moved(axis, d)[c] - moved(axis, -d)[c]) / (2.0 * d);
            let size = here.iter().fold(0.0, |most: f64, own| most.max(own.abs()));
            for rows in [[0, 3, 4], [3, 1, 5], [4, 5, 2]] {
                let left: f64 = (0..3).map(|axis| first(axis, rows[axis])).sum();
                assert!(left.abs() < 2e-3 * size / z, "{stack:?} {piece} {line}: {left}");
            }
            let trace = |s: Components| s[0] + s[1] + s[2];
            let second = |one: usize, other: usize, of: &dyn Fn(Components) -> f64| {
                let corner = |a: f64, b: f64| {
                    let mut moved = place;
                    moved[one] += a * d;
                    moved[other] += b * d;
                    of(stress(moved))
                };
                let all = if one == other {
                    corner(1.0, 0.0) + corner(-1.0, 0.0) - 2.0 * of(here)
                } else {
                    (corner(1.0, 1.0) + corner(-1.0, -1.0) - corner(1.0, -1.0) - corner(-1.0, 1.0))
                        / 4.0
                };
                all / (d * d)
            };
            for (c, [one, other]) in
                [[0, 0], [1, 1], [2, 2], [0, 1], [0, 2], [1, 2]].into_iter().enumerate()
            {
                let component = |s: Components| s[c];
                let each: Vec<f64> = (0..3).map(|axis| second(axis, axis, &component)).collect();
                let left = each.iter().sum::<f64>() + second(one, other, &trace) / (1.0 + poisson);
                let size = each.iter().fold(size, |most, own| most.max(own.abs()));
                assert!(left.abs() < 1e-2 * size, "{stack:?} {piece} {line} {c}: {left} {size}");
            }
        }
    }
}

/// With the equations above these say all: what the surface bears, what crosses interfaces, and that nothing moves on rigid ground.
#[test]
fn tractions_and_displacements_cross_interfaces() {
    for (line, stack) in [false, true].into_iter().flat_map(|line| STACKS.map(|own| (line, own))) {
        let below = under(loaded(line), stack);
        let [x, y] = below.place(3);
        let surface = below.displacement([x, y, 0.0]);
        let size = surface.iter().fold(0.0, |most: f64, own| most.max(own.abs()));
        let missed = |piece: usize| below.within(piece).missed(0.0);
        assert!((0..below.pieces().len()).all(|piece| missed(piece) < 5e-4));
        for element in [0, 3, 5] {
            let [x, y] = below.place(element);
            let stress = below.even([x, y], 0.0);
            let t = below.tractions.each_ref().map(|own| own[element]);
            for (component, own) in [(4, t[0]), (5, t[1]), (2, -t[2])] {
                assert!((stress[component] - own).abs() < missed(0), "{component} {stack:?}");
            }
        }
        let pieces = below.pieces();
        for (piece, [_, end]) in pieces.iter().enumerate().filter(|(_, ends)| ends[1].is_finite()) {
            for [x, y] in [[0.05, 0.02], [-0.3, 0.21], [0.9, -0.4]] {
                let place = [x, if line { 0.0 } else { y }, -end];
                let above = below.within(piece);
                let u = above.displacement(place);
                if piece + 1 == pieces.len() {
                    assert!(u.iter().all(|own| own.abs() < 1e-5 * size), "{stack:?} {u:?}");
                    continue;
                }
                let under = below.within(piece + 1);
                let [one, other] = [&above, &under].map(|own| own.stress(place));
                let least = missed(piece) + missed(piece + 1);
                for c in [2, 4, 5] {
                    let apart = (one[c] - other[c]).abs();
                    assert!(apart < least, "{stack:?} {piece} {c}: {apart} {least}");
                }
                for (one, other) in u.into_iter().zip(under.displacement(place)) {
                    assert!((one - other).abs() < 1e-5 * size, "{stack:?} {piece}: {one} {other}");
                }
            }
        }
    }
}

/// The displacements of the surface are those of the compliance, which is fitted by itself.
#[test]
fn the_surface_moves_as_the_compliance_says() {
    for (line, stack) in [false, true].into_iter().flat_map(|line| STACKS.map(|own| (line, own))) {
        let below = under(loaded(line), stack);
        let (all, base) = (layers(stack.0), stack.1.map(|[g, nu]| material(g, nu)));
        let [nx, ny] = below.elements();
        let size = [0.1 * nx as f64, 0.1 * ny as f64];
        let frame = match line {
            false => ContactFrame::uniform(size, [nx, ny], [&Flat, &Flat]).unwrap(),
            true => ContactFrame::line(size, [nx, 1], [&Flat, &Flat]).unwrap(),
        };
        let [t1, t2, into] = (*below.tractions).clone();
        let tractions = VectorField { t1, t2, n: into.iter().map(|own| -own).collect() };
        let materials = [base.as_ref(), None];
        let compliance = match line {
            false => HalfSpace::layered(materials, [&all, &[]], &frame),
            true => HalfSpace::plane_strain(materials, [&all, &[]], [10.0; 2], &frame),
        };
        let known = compliance.apply(&tractions);
        let largest = known.n.iter().fold(0.0, |most: f64, own| most.max(own.abs()));
        for element in 0..nx * ny {
            let [x, y] = below.place(element);
            let u = below.displacement([x, y, 0.0]);
            for (found, known) in u.into_iter().zip(known.components()) {
                let apart = (found - known[element]).abs();
                assert!(apart < 2e-5 * largest, "{stack:?} {line}: {found} {}", known[element]);
            }
        }
    }
}

#[test]
fn equal_layers_are_a_half_space() {
    let equal: Stacked = (&[[1.0, 0.3, 0.1], [1.0, 0.3, 0.4]], Some([1.0, 0.3]));
    for line in [false, true] {
        let (below, plain) = (under(loaded(line), equal), loaded(line));
        for z in [0.0, 0.05, 0.3, 0.9] {
            let [x, y] = plain.place(3);
            near(below.stress([x, y, -z]), plain.stress([x, y, -z]), 1e-12);
            let fields = below.plane(z);
            for (field, plain) in fields.iter().zip(plain.plane(z)) {
                field
                    .iter()
                    .zip(plain)
                    .for_each(|(own, plain)| assert!((own - plain).abs() < 1e-12));
            }
        }
    }
}

#[test]
fn a_plane_in_a_layer_holds_what_sums_at_its_places_say() {
    for (line, stack) in [false, true].into_iter().flat_map(|line| STACKS.map(|own| (line, own))) {
        let below = under(loaded(line), stack);
        for (piece, [top, end]) in below.pieces().into_iter().enumerate() {
            let own = below.within(piece);
            let z = if end.is_finite() { 0.5 * (top + end) } else { 1.1 * top };
            let plane = own.plane(z);
            for element in 0..own.pressure().len() {
                let found = plane.each_ref().map(|field| field[element]);
                let [even, added] =
                    [own.even(own.place(element), z), own.varying(z).at(&own, element)];
                near(found, std::array::from_fn(|i| even[i] + added[i]), 1e-11);
            }
        }
    }
}

/// What repeats itself has the same stresses wave by wave: those of a spot in a wide frame, but for the even part, and crosses interfaces.
#[test]
fn waves_go_through_layers() {
    let spot = |[x, y]: [f64; 2]| {
        let pressure = (1.0 - x * x - y * y).max(0.0).sqrt();
        [0.2 * pressure, -0.1 * pressure, pressure]
    };
    let alone = under(square([96, 96], 0.125, spot, None), TWO);
    let repeated = under(square([96, 96], 0.125, spot, None), TWO).repeated(10.0);
    for (piece, z) in [(0, 0.1), (0, 0.2), (1, 0.2), (1, 0.6), (2, 0.6), (2, 1.0)] {
        let [one, other] = [&alone, &repeated].map(|below| below.within(piece));
        let place = [0.0625, -0.3125, -z];
        near(one.stress(place), other.stress(place), 0.03);
        let plane = other.plane(z);
        let element = 48 + 96 * 45;
        let [x, y] = other.place(element);
        let found = plane.each_ref().map(|field| field[element]);
        near(found, other.stress([x, y, -z]), 1e-9);
    }
    for [piece, z] in [[0.0, 0.2], [1.0, 0.6]] {
        let sides =
            [0, 1].map(|side| repeated.within(piece as usize + side).stress([0.3, 0.1, -z]));
        for c in [2, 4, 5] {
            assert!((sides[0][c] - sides[1][c]).abs() < 1e-10);
        }
    }
}
