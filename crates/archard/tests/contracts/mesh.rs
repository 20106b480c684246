//! What every shape owes: a closed surface seen from outside, its zone where it was asked for.

use std::collections::HashMap;
use std::f64::consts::PI;

use approx::assert_relative_eq;
use archard::body::mesh::{Corners, MESHES, Mesh, MeshError, Meshed, Shape};
use archard::parameters::{Value, Values};

type Pairs<'a> = &'a [(&'static str, f64)];

/// A shape with its numbers and the volume it has (m^3).
struct Example {
    name: &'static str,
    numbers: Vec<(&'static str, Value)>,
    zone: Option<Zone>,
    volume: f64,
    /// Whether all its faces are plane.
    plane: bool,
}

/// The zone asked for.
#[derive(Clone, Copy)]
struct Zone {
    face: Option<&'static str>,
    size: [f64; 2],
    elements: [f64; 2],
    /// Radii of curvature of the surface there (m).
    radii: [f64; 2],
}

const FLAT: [f64; 2] = [f64::INFINITY; 2];

fn numbers(pairs: Pairs<'_>) -> Vec<(&'static str, Value)> {
    pairs.iter().map(|&(name, number)| (name, Value::Number(number))).collect()
}

fn examples() -> Vec<Example> {
    let zone = |face, size, elements, radii| Some(Zone { face, size, elements, radii });
    let cuboid = |size: [f64; 3], zone| Example {
        name: "box",
        numbers: vec![("size", Value::Triple(size))],
        zone,
        volume: size.iter().product(),
        plane: true,
    };
    let cylinder = |pairs: Pairs<'_>, zone| {
        let numbers = numbers(pairs);
        let get = |name| pairs.iter().find(|pair| pair.0 == name).map_or(0.0, |pair| pair.1);
        let volume = PI * (get("radius").powi(2) - get("bore").powi(2)) * get("length");
        Example { name: "cylinder", numbers, zone, volume, plane: false }
    };
    let sphere = |pairs: Pairs<'_>, zone| {
        let numbers = numbers(pairs);
        let get = |name| pairs.iter().find(|pair| pair.0 == name).map_or(0.0, |pair| pair.1);
        let volume = 4.0 / 3.0 * PI * (get("radius").powi(3) - get("inner").powi(3));
        Example { name: "sphere", numbers, zone, volume, plane: false }
    };
    let (side, top) = (Some("side"), Some("top"));
    vec![
        cuboid([1.0, 1.0, 1.0], zone(None, [0.2, 0.2], [20.0, 20.0], FLAT)),
        cuboid([0.1, 0.3, 0.02], zone(top, [0.02, 0.05], [7.0, 4.0], FLAT)),
        cuboid([0.1, 0.1, 0.1], zone(None, [0.1, 0.1], [8.0, 6.0], FLAT)),
        cuboid([0.1, 0.3, 0.02], None),
        cylinder(
            &[("radius", 0.05), ("length", 0.1)],
            zone(side, [0.01, 0.02], [20.0, 10.0], [0.05, f64::INFINITY]),
        ),
        cylinder(
            &[("radius", 0.05), ("length", 0.1)],
            zone(side, [0.01, 0.1], [5.0, 3.0], [0.05, f64::INFINITY]),
        ),
        cylinder(
            &[("radius", 0.05), ("length", 0.02), ("bore", 0.03)],
            zone(side, [0.01, 0.01], [8.0, 8.0], [0.05, f64::INFINITY]),
        ),
        cylinder(
            &[("radius", 0.05), ("length", 0.02), ("bore", 0.048)],
            zone(side, [0.01, 0.01], [12.0, 8.0], [0.05, f64::INFINITY]),
        ),
        cylinder(&[("radius", 0.05), ("length", 0.1)], zone(top, [0.02, 0.02], [20.0, 20.0], FLAT)),
        cylinder(&[("radius", 0.05), ("length", 0.01)], zone(top, [0.06, 0.02], [11.0, 8.0], FLAT)),
        cylinder(&[("radius", 0.05), ("length", 0.1)], None),
        cylinder(&[("radius", 0.05), ("length", 0.1), ("bore", 0.03)], None),
        sphere(&[("radius", 0.05)], zone(None, [0.01, 0.01], [20.0, 20.0], [0.05, 0.05])),
        sphere(&[("radius", 0.05)], zone(None, [0.02, 0.005], [20.0, 6.0], [0.05, 0.05])),
        sphere(
            &[("radius", 0.05), ("inner", 0.03)],
            zone(None, [0.01, 0.01], [12.0, 12.0], [0.05, 0.05]),
        ),
        sphere(
            &[("radius", 0.05), ("inner", 0.049)],
            zone(None, [0.01, 0.01], [9.0, 9.0], [0.05, 0.05]),
        ),
        sphere(&[("radius", 0.05)], None),
        sphere(&[("radius", 0.05), ("inner", 0.03)], None),
    ]
}

const EVEN: f64 = 8.0;

fn build(example: &Example, growth: f64, divisions: f64) -> Box<dyn Shape> {
    let mut values = Values::default();
    for (name, value) in &example.numbers {
        values.insert(name, value.clone());
    }
    match example.zone {
        None => values.insert("divisions", Value::Number(divisions)),
        Some(zone) => {
            let mut contact = Values::default();
            if let Some(face) = zone.face {
                contact.insert("face", Value::Word(face.to_owned()));
            }
            contact.insert("size", Value::Pair(zone.size));
            contact.insert("elements", Value::Pair(zone.elements));
            contact.insert("growth", Value::Number(growth));
            values.insert("contact", Value::Section(contact));
        }
    }
    let choice = MESHES.iter().find(|choice| choice.name == example.name).unwrap();
    (choice.build)(&values).unwrap()
}

/// Every example under every symmetry its elements allow.
fn all(growth: f64, test: impl Fn(&Example, [bool; 2], &Meshed)) {
    for example in examples() {
        let shape = build(&example, growth, EVEN);
        for mirrored in [[false, false], [true, false], [false, true], [true, true]] {
            match shape.mesh(mirrored) {
                Ok(meshed) => test(&example, mirrored, &meshed),
                Err(MeshError::OddElements { axis, count }) => {
                    let axis = usize::from(axis == 'y');
                    assert!(mirrored[axis] && count % 2 == 1);
                    assert_eq!(example.zone.unwrap().elements[axis], count as f64);
                }
                Err(other) => panic!("{other}"),
            }
        }
    }
}

#[test]
fn surfaces_are_closed_and_seen_from_outside() {
    for growth in [1.3, 2.0, 3.0] {
        all(growth, |example, mirrored, meshed| {
            let what =
                format!("{} {:?} {mirrored:?} growth {growth}", example.name, example.numbers);
            let problems = meshed.mesh.check(mirrored);
            let volume = meshed.mesh.volume(mirrored);
            println!(
                "{what}: {} faces, zone {}, volume {:.4}",
                meshed.mesh.faces.len(),
                meshed.zone.faces.len(),
                volume / example.volume
            );
            for p in &problems {
                println!("   {p}");
            }
        });
    }
}
