//! Bodies in tetrahedra that bear a contact on curved zones of their own, against a solution of revolution.

use std::collections::HashMap;
use std::fmt::Write;
use std::path::Path;

use archard::body::contact_modulus;
use archard::closed_form::{Hertz, cattaneo_mindlin::PartialSlip};
use archard::compliance::bem::contact::BodiesInContact;
use glam::DVec3;

use crate::common::{Rows, STEEL, case, peak, states};

/// A part of a spherical shell about the origin in quadratic tetrahedra.
struct Shell {
    /// Elements across it and through it.
    divisions: [usize; 2],
    /// As far from the axis, downwards (degrees).
    degrees: f64,
    /// Between two radii (m), the first of which is its `zone` and the last what is `held`.
    radii: [f64; 2],
    /// How much larger elements are at the other radius, as a logarithm.
    grows: f64,
}

/// Nodes inside are moved along the shell by up to this share of an element, to and fro.
const MOVED: f64 = 0.15;

/// The input of a shell.
fn input(Shell { divisions: [across, through], degrees, radii, grows }: &Shell) -> String {
    let (across, through) = (*across, *through);
    let shift = |at: usize, axis: usize| {
        let mixed = (at * 2 + axis).wrapping_mul(2_654_435_761) >> 7;
        MOVED * ((mixed % 1000) as f64 / 500.0 - 1.0)
    };
    let index = |[i, j, k]: [usize; 3]| 1 + i + (across + 1) * (j + (across + 1) * k);
    let mut places = vec![];
    for k in 0..=through {
        for j in 0..=across {
            for i in 0..=across {
                let inside = 0 < i && i < across && 0 < j && j < across;
                let at = |own: usize, axis: usize| {
                    let shift = if inside { shift(index([i, j, 0]), axis) } else { 0.0 };
                    2.0 * (own as f64 + shift) / across as f64 - 1.0
                };
                places.push([at(i, 0), at(j, 1), k as f64 / through as f64]);
            }
        }
    }
    // Squares become circles, their lines ellipses.
    let place = |[x, y, depth]: [f64; 3]| {
        let [u, v] = [x * (1.0 - 0.5 * y * y).sqrt(), y * (1.0 - 0.5 * x * x).sqrt()];
        let (reach, turn) = (u.hypot(v), v.atan2(u));
        let angle = reach * degrees.to_radians();
        let share = (grows * depth).exp_m1() / grows.exp_m1();
        let radius = radii[0] + share * (radii[1] - radii[0]);
        [angle.sin() * turn.cos(), angle.sin() * turn.sin(), -angle.cos()].map(|one| radius * one)
    };
    let places = places.into_iter().map(|at| place(at).into()).collect();
    // In the middle of the arc, where generators of meshes put it.
    let middle = |a: DVec3, b: DVec3| 0.5 * (a.length() + b.length()) * (a + b).normalize();
    let last = (across + 1) * (across + 1) * (through + 1);
    let first = index([0, 0, through]);
    let sets = [("zone", (1..=(across + 1).pow(2)).collect()), ("held", (first..=last).collect())];
    quadratic([across, across, through], places, middle, &sets)
}

/// The input of a grid of hexahedra between these corners, along x first, each in six quadratic tetrahedra, with a node between two
/// corners and sets of corners, counted from 1.
pub(super) fn quadratic(
    [nx, ny, nz]: [usize; 3],
    mut places: Vec<DVec3>,
    middle: impl Fn(DVec3, DVec3) -> DVec3,
    sets: &[(&str, Vec<usize>)],
) -> String {
    let index = |[i, j, k]: [usize; 3]| 1 + i + (nx + 1) * (j + (ny + 1) * k);
    let ways = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
    let edges = [[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]];
    let (mut middles, mut elements) = (HashMap::new(), vec![]);
    for first in (0..nx * ny * nz).map(|one| [one % nx, one / nx % ny, one / nx / ny]) {
        for way in ways {
            let mut at = first;
            let mut nodes = vec![index(at)];
            for axis in way {
                at[axis] += 1;
                nodes.push(index(at));
            }
            for [one, other] in edges {
                let [one, other] = [nodes[one], nodes[other]];
                let between =
                    *middles.entry([one.min(other), one.max(other)]).or_insert_with(|| {
                        places.push(middle(places[one - 1], places[other - 1]));
                        places.len()
                    });
                nodes.push(between);
            }
            elements.push(nodes);
        }
    }
    let mut text = "*NODE\n".to_owned();
    for (index, at) in places.iter().enumerate() {
        let [x, y, z] = at.to_array();
        writeln!(text, "{}, {x}, {y}, {z}", index + 1).unwrap();
    }
    text += "*ELEMENT, TYPE=C3D10\n";
    let listed = |numbers: &[usize]| -> String {
        numbers.iter().map(usize::to_string).collect::<Vec<_>>().join(", ")
    };
    for (index, nodes) in elements.iter().enumerate() {
        writeln!(text, "{}, {}", index + 1, listed(nodes)).unwrap();
    }
    for (name, numbers) in sets {
        writeln!(text, "*NSET, NSET={name}").unwrap();
        numbers.chunks(8).for_each(|some| writeln!(text, "{}", listed(some)).unwrap());
    }
    text
}

/// A body of steel in that input.
fn body(dir: &Path, name: &str, text: &str) -> String {
    let path = dir.join(format!("{name}.inp"));
    std::fs::write(&path, text).unwrap();
    format!(
        "[body.{name}]\nmaterial = {{ young = \"210 GPa\", poisson = 0.3 }}\n\
         mesh.file = {{ path = {path:?}, unit = \"m\", contact = \"zone\" }}\nelasticity = \"finite_elements\"\nsupports = {{ held = \"clamped\" }}\n"
    )
}

/// A ball of .999 m, hollow and held at .3 m, as far down as 60 degrees or so, in a socket of 1 m held at 1.6 m, as far as 55 degrees.
fn socket(dir: &Path, [cup, ball]: [usize; 2], degrees: f64) -> String {
    let of = |across: usize, degrees: f64, radii: [f64; 2]| {
        let through = (across / 4).max(3);
        input(&Shell { divisions: [across, through], degrees, radii, grows: 1.5 })
    };
    let cup = body(dir, "cup", &of(cup, 55.0, [1.0, 1.6]));
    let ball = body(dir, "ball", &of(ball, degrees, [0.999, 0.3]));
    cup + &ball + "[motion.indentation]\napproach = \"0.5 mm\"\nincrements = 1\n"
}

/// Of the same bodies as bodies of revolution, by quadratic quadrilaterals in the plane of the axis, 132 along the zone and 48 through
/// each body: the load (N), the pressure (Pa) at the axis, where it is largest, and at 10, 20 and 30 degrees from it.
const KNOWN: (f64, [f64; 4]) = (5.429e7, [7.91e7, 7.486e7, 6.208e7, 3.798e7]);

/// The load, the largest pressure and the mean pressure about the axis are those of revolution. The load is to half as much again as is
/// stated, the largest pressure to that and to what single pressures stand off those around them.
#[test]
#[ignore = "long: in .ci/long"]
fn a_ball_in_a_socket_is_that_of_revolution() {
    let dir = tempfile::tempdir().unwrap();
    for across in [[10, 11], [14, 15], [18, 19], [12, 18]] {
        let simulation = case(&socket(dir.path(), across, 60.0), &[]);
        let state = states(&simulation).unwrap().pop().unwrap().0;
        let (frame, compliance) = (&simulation.problem.frame, &simulation.problem.compliance);
        let missed = compliance.missed(&state.tractions()).unwrap();
        let (load, known) = KNOWN;
        let off = (state.load / load - 1.0).abs();
        // What is known is known to .04 %; gaps on elements as coarse as these add as much again.
        assert!(off < 1.5 * missed + 4e-4 && missed < 0.05, "{across:?}: {off} {missed}");
        let alone = simulation.problem.alone(&state.pressure).unwrap();
        let off = (peak(&state.pressure) / known[0] - 1.0).abs();
        assert!(off < 1.5 * missed + alone && alone < 0.5, "{across:?}: {off} {missed} {alone}");
        // Pressures of nodes alternate by a few percent, their mean about the axis does not.
        let near =
            |pair: &usize| frame.place(*pair).iter().map(|one| one * one).sum::<f64>() < 0.12;
        let pairs: Vec<usize> = (0..frame.len()).filter(near).collect();
        let sum = |of: &dyn Fn(usize) -> f64| pairs.iter().map(|pair| of(*pair)).sum::<f64>();
        let found = sum(&|pair| frame.area(pair) * state.pressure[pair]);
        let expected = sum(&|pair| {
            let [x, y] = frame.place(pair);
            let angle = x.hypot(y).asin().to_degrees() / 10.0;
            let index = (angle as usize).min(2);
            let share = angle - index as f64;
            frame.area(pair) * (known[index] + share * (known[index + 1] - known[index]))
        });
        let off = (found / expected - 1.0).abs();
        assert!(off < 0.08, "{across:?}: {off}");
    }
}

/// The pairs are corners of the larger elements, whichever body has them, unless their zone reaches beyond the other.
#[test]
fn larger_elements_have_the_pairs() {
    let dir = tempfile::tempdir().unwrap();
    for (across, degrees, has) in [([8, 10], 60.0, 8), ([10, 8], 50.0, 8), ([10, 8], 60.0, 10)] {
        let simulation = case(&socket(dir.path(), across, degrees), &[]);
        assert_eq!(simulation.problem.frame.len(), (has + 1) * (has + 1), "{across:?} {degrees}");
    }
}

/// A ball of 100 mm with a contact of 1 mm radius, as a half-space, on a block in tetrahedra of a fifth of that, of the same material.
const PRESSED: &str = r#"
[body.ball]
material = { young = "210 GPa", poisson = 0.3 }
profile.sphere.radius = "100 mm"
[body.block]
material = { young = "210 GPa", poisson = 0.3 }
mesh.file = { path = "../archard/tests/meshes/pressed.msh", unit = "mm", contact = "zone" }
elasticity = "finite_elements"
supports = { base = "clamped" }
"#;

/// The load (N) of that contact, by Hertz.
const LOAD: f64 = 1_538.461_538;

/// Pressures are those of Hertz, and so are stresses below the middle (M. T. Huber, *Annalen der Physik* 319 (1904), 153).
#[test]
#[ignore = "long: in .ci/long"]
fn a_small_contact_on_a_block_is_that_of_hertz() {
    let motion = format!("[motion.indentation]\nload = \"{LOAD} N\"\nincrements = 1\n");
    let simulation = case(&format!("{PRESSED}{motion}"), &[]);
    let state = states(&simulation).unwrap().pop().unwrap().0;
    let problem = &simulation.problem;
    let missed = problem.compliance.missed(&state.tractions()).unwrap();
    let alone = problem.alone(&state.pressure).unwrap();
    let modulus = contact_modulus([Some(&STEEL); 2]);
    let hertz = Hertz::from_load([10.0; 2], modulus, LOAD).unwrap();
    let off = (peak(&state.pressure) / hertz.peak_pressure - 1.0).abs();
    assert!(off < missed + alone && missed < 0.01 && alone < 0.05, "{off} {missed} {alone}");
    let [ball, block] = &problem.bodies;
    let meeting = BodiesInContact::of([ball, block]).unwrap();
    let (_, inside) = meeting.inside(1, &state.tractions()).unwrap().unwrap();
    for depth in [0.1, 0.25, 0.5, 0.75, 1.0, 1.5] {
        let at = DVec3::new(0.0, 0.0, -depth * hertz.semi_axes[0]);
        let stress = inside.at(at).unwrap().stress * (1.0 / hertz.peak_pressure);
        let along = -1.0 / (1.0 + depth * depth);
        let across = -1.3 * (1.0 - depth * (1.0 / depth).atan()) - 0.5 * along;
        let off = [stress.x_axis.x - across, stress.y_axis.y - across, stress.z_axis.z - along];
        assert!(off.iter().all(|off| off.abs() < missed + alone / 3.0), "{depth}: {off:?}");
    }
}

/// The largest pressure is off by less than both errors together, or the contact has fewer pairs than those around one: under contacts of
/// .35 to 1.1 mm radius.
#[test]
#[ignore = "long: in .ci/long"]
fn errors_of_largest_pressures_are_covered() {
    for radius in [0.35_f64, 0.5, 0.6, 0.8, 1.1] {
        let load = LOAD * radius.powi(3);
        let motion = format!("[motion.indentation]\nload = \"{load} N\"\nincrements = 1\n");
        let simulation = case(&format!("{PRESSED}{motion}"), &[]);
        let state = states(&simulation).unwrap().pop().unwrap().0;
        let modulus = contact_modulus([Some(&STEEL); 2]);
        let hertz = Hertz::from_load([10.0; 2], modulus, load).unwrap();
        let off = (peak(&state.pressure) / hertz.peak_pressure - 1.0).abs();
        let missed = simulation.problem.compliance.missed(&state.tractions()).unwrap();
        let alone = simulation.problem.alone(&state.pressure);
        let bearing = state.pressure.iter().filter(|pressure| **pressure > 0.0).count();
        let covered = alone.map_or(bearing < 19, |alone| off < missed + alone);
        assert!(covered, "{radius}: {off} {missed} {alone:?} {bearing}");
    }
}

/// Shifted to and fro, the ball sticks and dissipates as Cattaneo's and Mindlin's does under the same force.
#[test]
fn a_ball_frets_on_tetrahedra_as_mindlins_does() {
    let motion = format!(
        "[friction.coulomb]\ncoefficient = 0.3\n[motion.fretting]\nload = \"{LOAD} N\"\namplitude = [\"3 um\", \"0 um\"]\n\
         cycles = 2\n"
    );
    let simulation = case(&format!("{PRESSED}{motion}"), &[]);
    let mut rows = Rows::default();
    simulation.run(&mut [&mut rows]).unwrap();
    let force = peak(&rows.column("force_x_N"));
    let partial = PartialSlip::new(0.1, [Some(&STEEL); 2], LOAD, 0.3).unwrap();
    assert!(force > 0.8 * partial.sliding_force && force < partial.sliding_force);
    // Of the second cycle alone.
    let dissipated = rows.last("dissipated_J") / partial.dissipation(force) - 1.0;
    assert!(dissipated.abs() < 0.04, "{dissipated}");
    let area = rows.column("stick_area_m2").into_iter().fold(f64::INFINITY, f64::min);
    let radius = (area / std::f64::consts::PI).sqrt();
    let off = radius / partial.stick_radius(force) - 1.0;
    // Areas are those of whole pairs: half of one of .2 mm around a radius of .47 mm.
    assert!(off.abs() < 0.2, "{off}");
}

/// A ball that slides and wears on the block loses k F s, and is as flat as on the same pairs of a half-space.
#[test]
#[ignore = "long: in .ci/long"]
fn a_ball_wears_on_tetrahedra_as_on_a_half_space() {
    let motion =
        format!("[motion.sliding]\nload = \"{LOAD} N\"\ndistance = \"5 m\"\nstep = \"0.5 m\"\n");
    let of = |elasticity: &str| {
        let text = format!("{PRESSED}{motion}");
        let options = [
            &format!("body.block.elasticity={elasticity}")[..],
            "body.ball.wear.archard.coefficient=1e-15 1/Pa",
        ];
        let mut rows = Rows::default();
        case(&text, &options).run(&mut [&mut rows]).unwrap();
        let volume = rows.last("worn_volume_ball_m3") / (1e-15 * LOAD * 5.0);
        assert!((volume - 1.0).abs() < 1e-6, "{elasticity}: {volume}");
        [rows.last("wear_depth_ball_m"), rows.last("peak_pressure_Pa")]
    };
    let [elements, half_space] = ["finite_elements", "half_space"].map(of);
    for (one, other) in elements.into_iter().zip(half_space) {
        assert!((one / other - 1.0).abs() < 0.03, "{elements:?} {half_space:?}");
    }
}
