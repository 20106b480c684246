//! Bodies by matrices of their nodes, against finite elements of the same mesh and the load that is known of a punched cube.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;
use std::sync::Arc;

use archard::body::mesh::{ContactMesh, MESHES, Shape};
use archard::body::{Elasticity, Finite, Interpolation, Support};
use archard::compliance::fem::{Carrier, OnNodes};
use archard::parameters::{Value, Values};
use glam::DVec3;

use super::tetrahedra::quadratic;
use crate::common::{STEEL, case, states};

/// Half of the zone of a cube of 1 m, in the middle of its top at z = 0 (m).
const HALF: f64 = 0.1;
/// The load (N) of a rigid punch of 100 m radius 0.07 mm into it (the book, meshes, tetrahedra that bear a contact).
const LOAD: f64 = 1.8309e6;

/// The cube in tetrahedra, so many across the zone; others grow with the distance from it, each by that factor.
fn cube(across: usize, growth: f64) -> String {
    let width = 2.0 * HALF / across as f64;
    // From the zone on to some distance, their sum put right.
    let away = |to: f64| {
        let mut sums = vec![0.0];
        let mut step = width;
        while sums[sums.len() - 1] < to {
            step *= growth;
            sums.push(sums[sums.len() - 1] + step);
        }
        let last = sums[sums.len() - 1];
        sums.into_iter().skip(1).map(move |sum| sum * to / last).collect::<Vec<f64>>()
    };
    let beside = away(0.5 - HALF);
    let low = beside.iter().rev().map(|own| -HALF - own);
    let zone = (0..=across).map(|own| own as f64 * width - HALF);
    let line: Vec<f64> = low.chain(zone).chain(beside.iter().map(|own| HALF + own)).collect();
    let down: Vec<f64> = [0.0].into_iter().chain(away(1.0)).collect();
    let mut places = vec![];
    for z in &down {
        for y in &line {
            places.extend(line.iter().map(|x| DVec3::new(*x, *y, -z)));
        }
    }
    let of = |meant: &dyn Fn(&DVec3) -> bool| -> Vec<usize> {
        (1..=places.len()).filter(|own| meant(&places[own - 1])).collect()
    };
    let within = |value: f64| value.abs() < HALF * (1.0 + 1e-9);
    let touching = of(&|at| at.z == 0.0 && within(at.x) && within(at.y));
    let sets = [("zone", touching), ("base", of(&|at| at.z < -1.0 + 1e-9))];
    let count = [line.len() - 1, line.len() - 1, down.len() - 1];
    quadratic(count, places.clone(), |a, b| 0.5 * (a + b), &sets)
}

/// The flexibility of a body in that input at the nodes of its zone by finite elements, in Matrix Market: by rising numbers of nodes, or
/// by falling ones. And these nodes in a table, numbered anew.
fn flexibility(text: &str, falling: bool) -> [String; 2] {
    let mut values = Values::default();
    let bytes = text.as_bytes().to_vec();
    values.insert("path", Value::File { bytes: bytes.into(), name: "cube.inp".to_owned() });
    values.insert("contact", Value::Word("zone".to_owned()));
    let choice = MESHES.iter().find(|choice| choice.name == "file").unwrap();
    let shape: Box<dyn Shape> = (choice.build)(&values).unwrap();
    let meshed: ContactMesh = shape.filled().unwrap().unwrap();
    let volume = Arc::clone(meshed.volume.as_ref().unwrap());
    let base = meshed.mesh.surfaces.iter().position(|name| name == "base").unwrap();
    let mut nodes = BTreeMap::new();
    let places = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.5, 0.0], [0.5, 0.5], [0.0, 0.5]];
    for face in &meshed.zone.faces {
        for (node, place) in volume.faces[*face].iter().zip(places) {
            nodes.insert(volume.numbers[*node], (*node, *face, place));
        }
    }
    // A force on a node is a traction at its place.
    let pair = |(_, face, place): &(usize, usize, [f64; 2])| {
        let mut pair = OnNodes::along(DVec3::AXES);
        pair.add((&volume, *face), *place, (1.0, DVec3::Z));
        pair.gathered()
    };
    let mut nodes: Vec<_> = nodes.into_values().collect();
    if falling {
        nodes.reverse();
    }
    let mut table = "node,x_mm,y_mm,z_mm\n".to_owned();
    for (number, (node, ..)) in nodes.iter().enumerate() {
        let [x, y, z] = volume.nodes[*node].map(|along| 1e3 * along);
        writeln!(table, "{},{x},{y},{z}", number + 70_001).unwrap();
    }
    let pairs: Vec<OnNodes> = nodes.iter().map(pair).collect();
    let all: Vec<usize> = (0..pairs.len()).collect();
    let finite = Finite {
        meshed,
        curvatures: Some([0.0; 2]),
        supports: vec![(base, Support::Clamped)],
        mirrored: [false; 2],
        interpolation: Interpolation::Continuous,
        tolerance: 1e-6,
        elasticity: Elasticity::FiniteElements,
    };
    let carrier = Carrier::new((&finite, &volume), &STEEL, pairs).unwrap();
    let size = 3 * all.len();
    let mut text = format!("%%MatrixMarket matrix array real general\n{size} {size}\n");
    for column in all.chunks(64).flat_map(|some| carrier.columns(some)) {
        column.iter().for_each(|value| writeln!(text, "{value:.15e}").unwrap());
    }
    [text, table]
}

/// The load (N) of the punch on a body of that file, and the share of its displacements that is said to be uncertain.
fn punched(dir: &Path, body: &str) -> [f64; 2] {
    let path = dir.join("cube.inp");
    let simulation = case(
        &format!(
            "[body.punch]\nrigid = true\nprofile.power = {{ coefficient = \"0.005 1/m\", exponent = 2 }}\n\
             [body.block]\nmaterial = {{ young = \"210 GPa\", poisson = 0.3 }}\n\
             mesh.file.path = {path:?}\nmesh.file.contact = \"zone\"\n{body}\n\
             [motion.indentation]\napproach = \"0.07 mm\"\nincrements = 1\n"
        ),
        &[],
    );
    let state = states(&simulation).unwrap().pop().unwrap().0;
    let missed = simulation.problem.compliance.missed(&state.tractions()).unwrap();
    [state.load, missed]
}

/// A superelement gives the load of the elements that it was made of, and says by how much that may be off: no less than it is, and no
/// more than six times as much.
#[test]
#[ignore = "long: in .ci/long"]
fn superelements_say_by_how_much_their_elements_are_off() {
    let dir = tempfile::tempdir().unwrap();
    for (across, growth) in [(6, 2.0), (8, 2.0)] {
        let text = cube(across, growth);
        std::fs::write(dir.path().join("cube.inp"), &text).unwrap();
        let matrix = dir.path().join("cube.mtx");
        std::fs::write(&matrix, &flexibility(&text, false)[0]).unwrap();
        let elements = "elasticity = \"finite_elements\"\nsupports.base = \"clamped\"";
        let [known, _] = punched(dir.path(), elements);
        let given =
            format!("mesh.file.compliance = {matrix:?}\nmesh.file.compliance_unit = \"m/N\"");
        let [load, stated] = punched(dir.path(), &given);
        assert!((load / known - 1.0).abs() < 1e-6, "{across} {growth}: {load} {known}");
        let off = (load / LOAD - 1.0).abs();
        assert!(off < stated && stated < 6.0 * off, "{across} {growth}: {off} {stated}");
    }
}

/// Rows in another order than the mesh numbers its nodes are those of the places of a table.
#[test]
#[ignore = "long: in .ci/long"]
fn rows_of_a_matrix_are_those_of_the_places_given() {
    let dir = tempfile::tempdir().unwrap();
    let text = cube(4, 2.0);
    let [matrix, table] = ["cube.mtx", "nodes.csv"].map(|name| dir.path().join(name));
    std::fs::write(dir.path().join("cube.inp"), &text).unwrap();
    let given = format!("mesh.file.compliance = {matrix:?}\nmesh.file.compliance_unit = \"m/N\"");
    std::fs::write(&matrix, &flexibility(&text, false)[0]).unwrap();
    let [known, _] = punched(dir.path(), &given);
    let [falling, places] = flexibility(&text, true);
    std::fs::write(&matrix, falling).unwrap();
    std::fs::write(&table, places).unwrap();
    let placed = format!("{given}\nmesh.file.places = {table:?}");
    let [load, _] = punched(dir.path(), &placed);
    assert!((load / known - 1.0).abs() < 1e-9, "{load} {known}");
}
