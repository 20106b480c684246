//! Blocks with image fields under a punch bear what fine meshes of them do.

use approx::assert_relative_eq;
use archard::body::mesh::{MESHES, Supported};
use archard::body::profile::{AxisymmetricPower, Flat};
use archard::body::{Body, Elasticity, Finite, Interpolation, Material, Support};
use archard::frame::VectorField;
use archard::motion::{Control, Sliding, Stepping};
use archard::parameters::{Value, Values};
use archard::simulation::{Run, Simulation};

/// The side of the zone (m).
const ZONE: f64 = 0.2;

/// A block of steel of that size (m) with an image field, clamped at its bottom.
fn block(size: [f64; 3]) -> Body {
    let mut values = Values::default();
    values.insert("size", Value::Triple(size));
    let choice = MESHES.iter().find(|choice| choice.name == "box").unwrap();
    let clamped: Supported = [("bottom".to_owned(), [true; 3])].into_iter().collect();
    let shape = (choice.build)(&values).unwrap();
    let meshed = shape.coarse([ZONE; 2], [false; 2], &clamped).unwrap();
    let bottom = meshed.mesh.surfaces.iter().position(|name| name == "bottom").unwrap();
    let finite = Finite {
        meshed,
        curvatures: Some([0.0; 2]),
        supports: vec![(bottom, Support::Clamped)],
        mirrored: [false; 2],
        interpolation: Interpolation::Discontinuous,
        tolerance: 1e-6,
        elasticity: Elasticity::Image,
    };
    Body::new("block", Flat).material(Material::new(210e9, 0.3).unwrap()).finite(finite)
}

fn punch() -> Body {
    Body::new("punch", AxisymmetricPower::new(0.005, 2.0).unwrap())
}

/// The load (N) of a punch at an approach of 0.07 mm, and by how much it is said to be off.
fn load(size: [f64; 3]) -> (f64, f64) {
    let planned = Sliding::new().over(1.0, Control::Approach(7e-5), Stepping::Implicit(1.0));
    let builder = Simulation::builder([punch(), block(size)], planned.unwrap());
    let run = Run::begin(builder.frame([ZONE; 2], [96; 2]).build().unwrap()).unwrap();
    let report = run.report();
    assert_eq!(report.problem.frame.elements(), [96; 2], "the zone holds the contact");
    let tractions = VectorField { n: report.state.pressure.clone(), ..VectorField::zeros(96 * 96) };
    (report.state.load, report.problem.compliance.missed(&tractions).unwrap())
}

/// Loads extrapolated from meshes around the zone, and from finite elements: of a cube, a slab as thick as the zone is wide, a column
/// twice as wide as it and a block five times as high as wide. Half-spaces bear 1.80205e6 N.
#[test]
fn loads_of_punched_blocks_are_those_of_fine_meshes() {
    let known = [
        ([1.0, 1.0, 1.0], 1.8309e6, 5e-4),
        ([1.0, 1.0, 0.2], 2.8081e6, 1e-3),
        ([0.4, 0.4, 1.0], 1.1174e6, 1e-3),
        ([1.0, 1.0, 5.0], 1.0813e6, 1e-3),
    ];
    for (size, known, within) in known {
        let (load, missed) = load(size);
        assert_relative_eq!(load, known, max_relative = within);
        assert!((load / known - 1.0).abs() < missed && missed < 5e-3, "{size:?}: {load} {missed}");
    }
}
