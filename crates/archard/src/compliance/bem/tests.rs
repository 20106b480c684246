//! Bodies with known fields.

use glam::{DMat3, DVec3};

use std::sync::Mutex;

use super::contact::{Job, condense};
use super::{AxisCondition, Condition, Conditions, Listener, Solid, Stage, StageProgress, Surface};
use crate::body::mesh::{ContactMesh, Corners, Face, Mesh, Zone};
use crate::body::{Elasticity, Finite, Interpolation, Material};

pub(super) const MATERIAL: Material = Material { young: 2.6, poisson: 0.3 };

/// A unit box of that many quadrilaterals or pairs of triangles an edge, its vertices moved.
pub(super) fn cube(divisions: usize, triangles: bool, moved: impl Fn(DVec3) -> DVec3) -> Mesh {
    let (mut vertices, mut faces) = (vec![], vec![]);
    let n = divisions;
    for axis in 0..3 {
        for end in [0, n] {
            for i in 0..n {
                for j in 0..n {
                    let corner = |a: usize, b: usize| {
                        let mut at = [0; 3];
                        at[axis] = end;
                        at[(axis + 1) % 3] = i + a;
                        at[(axis + 2) % 3] = j + b;
                        at.map(|value| value as f64 / n as f64)
                    };
                    let mut quad = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
                    if end == 0 {
                        quad.reverse();
                    }
                    let corners = quad.map(|place| {
                        let known = vertices.iter().position(|known| *known == place);
                        known.unwrap_or_else(|| {
                            vertices.push(place);
                            vertices.len() - 1
                        })
                    });
                    let surface = 2 * axis + usize::from(end > 0);
                    let [a, b, c, d] = corners;
                    let kinds = if triangles {
                        vec![Corners::Triangle([a, b, c]), Corners::Triangle([a, c, d])]
                    } else {
                        vec![Corners::Quad(corners)]
                    };
                    faces.extend(kinds.into_iter().map(|corners| Face { corners, surface }));
                }
            }
        }
    }
    let vertices = vertices.into_iter().map(|place| moved(place.into()).to_array()).collect();
    let surfaces = ["left", "right", "front", "back", "bottom", "top"].map(String::from).to_vec();
    Mesh { vertices, faces, surfaces }
}

/// A linear field u = gradient (x - origin), and its stress.
pub(super) fn stress(gradient: DMat3) -> DMat3 {
    let strain = 0.5 * (gradient + gradient.transpose());
    let trace = strain.x_axis.x + strain.y_axis.y + strain.z_axis.z;
    let shear = MATERIAL.shear_modulus();
    let lame = 2.0 * shear * MATERIAL.poisson / (1.0 - 2.0 * MATERIAL.poisson);
    2.0 * shear * strain + lame * trace * DMat3::IDENTITY
}

pub(super) const GRADIENT: DMat3 = DMat3::from_cols(
    DVec3::new(0.3, -0.2, 0.15),
    DVec3::new(0.1, -0.4, 0.25),
    DVec3::new(-0.05, 0.35, 0.2),
);

/// Largest errors of displacement and traction relative to the largest of each, with displacements given on
/// the bottom and tractions elsewhere.
fn patch_test(mesh: &Mesh, interpolation: Interpolation, tolerance: f64) -> (f64, f64) {
    let surface = Surface::new(mesh, interpolation, [false; 2]);
    let stress = stress(GRADIENT);
    let of = |node: &super::TractionNode| {
        let (along, given): (DVec3, fn(f64) -> AxisCondition) = if node.surface == 4 {
            (GRADIENT * node.place, AxisCondition::Displacement)
        } else {
            (stress * node.normal, AxisCondition::Traction)
        };
        Condition::along_axes(along.to_array().map(given))
    };
    let conditions = Conditions::new(&surface, of, &[]).expect("it is held");
    let solid = Solid::new(&surface, &MATERIAL, &conditions, tolerance).expect("it is regular");
    let found = solid.boundary(&[]);
    let (mut error, mut largest) = ((0.0f64, 0.0f64), (0.0f64, 0.0f64));
    for (index, node) in surface.traction_nodes().iter().enumerate() {
        let (u, t) = (GRADIENT * node.place, stress * node.normal);
        error.0 = error.0.max(found.displacement[node.node].distance(u));
        error.1 = error.1.max(found.traction[index].distance(t));
        largest = (largest.0.max(u.length()), largest.1.max(t.length()));
    }
    (error.0 / largest.0, error.1 / largest.1)
}

/// Whoever waits is told of every block of nodes, the factors, and the columns of the zone; what comes out is the same.
#[test]
fn stages_are_told_in_their_order() {
    let mesh = cube(4, false, |place| place);
    let surface = Surface::new(&mesh, Interpolation::Discontinuous, [false; 2]);
    let nodes = surface.traction_nodes().iter().enumerate();
    let zone: Vec<(usize, [DVec3; 3])> = nodes
        .filter(|(_, node)| node.surface == 5)
        .map(|(index, _)| (index, [DVec3::X, DVec3::Y, DVec3::Z]))
        .collect();
    let held = |node: &super::TractionNode| match node.surface {
        4 => Condition::clamped(),
        _ => Condition::free(),
    };
    let conditions = Conditions::new(&surface, held, &zone).expect("it is held");
    let meshed = ContactMesh {
        mesh: mesh.clone(),
        zone: Zone::default(),
        placed: true,
        ..ContactMesh::default()
    };
    let finite = Finite {
        meshed,
        curvatures: None,
        supports: vec![],
        mirrored: [false; 2],
        interpolation: Interpolation::Discontinuous,
        tolerance: 1e-4,
        elasticity: Elasticity::BoundaryElements,
    };
    let told = Mutex::new(vec![]);
    let tell = |making: StageProgress| told.lock().unwrap().push(making);
    let job = Job { surface: &surface, conditions: &conditions, told: Listener::by(&tell) };
    let condensed = condense(&finite, &MATERIAL, &job).unwrap();
    let alone = condense(&finite, &MATERIAL, &Job { told: Listener::default(), ..job }).unwrap();
    assert_eq!(condensed.compliance, alone.compliance);
    let told = told.into_inner().unwrap();
    assert!(told.iter().all(|one| one.equations == surface.unknowns()));
    let shares = |stage: Stage| -> Vec<f64> {
        told.iter().filter(|one| one.stage == stage).map(|one| one.share).collect()
    };
    // 384 nodes in blocks of 64.
    let mut blocks = shares(Stage::Assembling);
    blocks.sort_by(f64::total_cmp);
    assert_eq!(blocks, [0, 1, 2, 3, 4, 5, 6].map(|done| f64::from(done) / 6.0));
    assert_eq!(shares(Stage::Factorising), [0.0]);
    assert_eq!(shares(Stage::Condensing), [0.0]);
    let order: Vec<Stage> = told.iter().map(|one| one.stage).collect();
    assert!(order.is_sorted_by_key(|stage| *stage as u8), "{order:?}");
}

#[test]
fn linear_fields_are_met_to_the_tolerance() {
    let skewed = |p: DVec3| DVec3::new(p.x + 0.3 * p.y + 0.2 * p.z, p.y - 0.2 * p.z, 1.5 * p.z);
    for (tolerance, most) in [(1e-4, 1e-3), (1e-6, 1e-5), (1e-8, 1e-7)] {
        for interpolation in [Interpolation::Discontinuous, Interpolation::Continuous] {
            for (triangles, divisions) in [(false, 1), (false, 2), (false, 4), (true, 1), (true, 3)]
            {
                let mesh = cube(divisions, triangles, skewed);
                let (displacement, traction) = patch_test(&mesh, interpolation, tolerance);
                let which = format!("{tolerance:e} {interpolation:?} {triangles} {divisions}");
                assert!(displacement < most, "{which}: displacement off by {displacement:e}");
                assert!(traction < most, "{which}: traction off by {traction:e}");
            }
        }
    }
}
