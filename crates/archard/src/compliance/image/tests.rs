use crate::body::mesh::{MESHES, Supported};
use crate::body::profile::{AxisymmetricPower, Flat};
use crate::body::{Body, Elasticity, Finite, Interpolation, Material, Support};
use crate::motion::*;
use crate::parameters::{Value, Values};
use crate::simulation::{Run, Simulation};
use std::time::Instant;

#[test]
fn experiment() {
    let which = std::env::var("BODY").unwrap_or("cube".into());
    let n: usize = std::env::var("N").ok().and_then(|n| n.parse().ok()).unwrap_or(128);
    let size = match which.as_str() {
        "cube" => [1.0, 1.0, 1.0],
        "slab" => [1.0, 1.0, 0.2],
        "column" => [0.4, 0.4, 1.0],
        _ => [1.0, 1.0, 5.0],
    };
    let mut values = Values::default();
    values.insert("size", Value::Triple(size));
    let choice = MESHES.iter().find(|choice| choice.name == "box").unwrap();
    let shape = (choice.build)(&values).unwrap();
    let held: Supported = [("bottom".to_owned(), [true; 3])].into_iter().collect();
    let meshed = shape.coarse([0.2, 0.2], [false; 2], &held).unwrap();
    let faces = meshed.mesh.faces.len();
    let supports =
        vec![(meshed.mesh.surfaces.iter().position(|s| s == "bottom").unwrap(), Support::Clamped)];
    let finite = Finite {
        meshed,
        curvatures: Some([0.0; 2]),
        supports,
        mirrored: [false; 2],
        interpolation: Interpolation::Discontinuous,
        tolerance: 1e-6,
        elasticity: Elasticity::Image,
    };
    let block = Body::new("block", Flat).material(Material::new(210e9, 0.3).unwrap());
    let block = if which == "half" { block } else { block.finite(finite) };
    let punch = Body::new("punch", AxisymmetricPower::new(0.005, 2.0).unwrap());
    let start = Instant::now();
    let planned =
        Sliding::new().over(1.0, Control::Approach(7e-5), Stepping::Implicit(1.0)).unwrap();
    let simulation =
        Simulation::builder([punch, block], planned).frame([0.2; 2], [n; 2]).build().unwrap();
    let built = start.elapsed();
    let run = Run::begin(simulation).unwrap();
    let report = run.report();
    let load = report.problem.frame.integrate(&report.state.pressure);
    let n = report.state.pressure.clone();
    let zero = vec![0.0; n.len()];
    let missed = report.problem.compliance.missed(&crate::frame::VectorField {
        t1: zero.clone(),
        t2: zero,
        n,
    });
    let peak = report.state.pressure.iter().copied().fold(0.0, f64::max);
    println!(
        "{which} faces {faces} load {load:.1} peak {peak:.5e} missed {missed:?} built {built:?} all {:?}",
        start.elapsed()
    );
    println!("faces frame {:?} {:?}", report.problem.frame.rectangle(), report.problem.compliance);
}
