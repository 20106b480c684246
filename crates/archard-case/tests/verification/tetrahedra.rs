//! Bodies in tetrahedra that bear a contact on curved zones of their own, against a solution of revolution.

use std::collections::HashMap;
use std::fmt::Write;
use std::path::Path;

use glam::DVec3;

use crate::common::{case, states};

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
    let mut places: Vec<DVec3> = places.into_iter().map(|at| place(at).into()).collect();
    let ways = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
    let edges = [[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]];
    let (mut middles, mut elements) = (HashMap::new(), vec![]);
    for first in (0..across * across * through)
        .map(|one| [one % across, one / across % across, one / across / across])
    {
        for way in ways {
            let mut at = first;
            let mut nodes = vec![index(at)];
            for axis in way {
                at[axis] += 1;
                nodes.push(index(at));
            }
            for [one, other] in edges {
                let [one, other] = [nodes[one], nodes[other]];
                let middle =
                    *middles.entry([one.min(other), one.max(other)]).or_insert_with(|| {
                        // In the middle of the arc, where generators of meshes put it.
                        let [a, b] = [places[one - 1], places[other - 1]];
                        places.push(0.5 * (a.length() + b.length()) * (a + b).normalize());
                        places.len()
                    });
                nodes.push(middle);
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
    for (index, nodes) in elements.iter().enumerate() {
        let nodes: Vec<String> = nodes.iter().map(usize::to_string).collect();
        writeln!(text, "{}, {}", index + 1, nodes.join(", ")).unwrap();
    }
    let last = (across + 1) * (across + 1) * (through + 1);
    writeln!(text, "*NSET, NSET=zone, GENERATE\n1, {}, 1", (across + 1).pow(2)).unwrap();
    let first = index([0, 0, through]);
    writeln!(text, "*NSET, NSET=held, GENERATE\n{first}, {last}, 1").unwrap();
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

/// A ball of .999 m, hollow and held at .3 m, in a socket of 1 m held at 1.6 m: shells as far down as 60 and 55 degrees.
fn socket(dir: &Path, across: usize) -> String {
    let through = (across / 4).max(3);
    let of = |across: usize, degrees: f64, radii: [f64; 2]| {
        let shell = Shell { divisions: [across, through], degrees, radii, grows: 1.5 };
        input(&shell)
    };
    let cup = body(dir, "cup", &of(across, 55.0, [1.0, 1.6]));
    let ball = body(dir, "ball", &of(across + 1, 60.0, [0.999, 0.3]));
    cup + &ball + "[motion.indentation]\napproach = \"0.5 mm\"\nincrements = 1\n"
}

/// Of the same bodies as bodies of revolution, by quadratic quadrilaterals in the plane of the axis, 132 along the zone and 48 through
/// each body: the load (N), the pressure (Pa) at the axis, where it is largest, and at 10, 20 and 30 degrees from it.
const KNOWN: (f64, [f64; 4]) = (5.429e7, [7.91e7, 7.486e7, 6.208e7, 3.798e7]);

/// The load and the mean pressure about the axis are those of revolution, the load to twice what is stated.
#[test]
fn a_ball_in_a_socket_is_that_of_revolution() {
    let dir = tempfile::tempdir().unwrap();
    for across in [10, 14, 18] {
        let simulation = case(&socket(dir.path(), across), &[]);
        let state = states(&simulation).unwrap().pop().unwrap().0;
        let (frame, compliance) = (&simulation.problem.frame, &simulation.problem.compliance);
        let missed = compliance.missed(&state.tractions()).unwrap();
        let (load, known) = KNOWN;
        let off = (state.load / load - 1.0).abs();
        // What is known is known to .04 %.
        // What is known is known to .04 %; gaps on elements as coarse as these add as much again.
        assert!(off < 2.0 * missed + 4e-4 && missed < 0.05, "{across}: {off} {missed}");
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
        assert!(off < 0.08, "{across}: {off}");
    }
}
