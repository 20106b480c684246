//! Superelements by CalculiX 2.20 against finite elements of the same tetrahedra: 4 x 4 x 2 mm, held below, and 2 x 2 x 2 mm, free.

use crate::body::mesh::{ContactMesh, MESHES, Shape};
use crate::body::profile::Flat;
use crate::body::{Body, Elasticity, Finite, Interpolation, Material, Support};
use crate::compliance::bem::contact::{Contact, ContactError, condense};
use crate::frame::VectorField;
use crate::parameters::{Invalid, Value, Values};

const HELD: [&str; 2] = [
    include_str!("../../../../tests/meshes/superelement_held.inp"),
    include_str!("../../../../tests/meshes/superelement_held.mtx"),
];
const FREE: [&str; 2] = [
    include_str!("../../../../tests/meshes/superelement_free.inp"),
    include_str!("../../../../tests/meshes/superelement_free.mtx"),
];
const STEEL: Material = Material { young: 210e9, poisson: 0.3 };

/// A body of a mesh and a matrix, in a unit if one is said.
fn meshed([mesh, matrix]: [&str; 2], unit: Option<&str>) -> Result<ContactMesh, String> {
    let file = |text: &str, name: &str| {
        let bytes = text.as_bytes().to_vec();
        Value::File { bytes: bytes.into(), name: name.to_owned() }
    };
    let mut values = Values::default();
    values.insert("path", file(mesh, "part.inp"));
    values.insert("compliance", file(matrix, "part.mtx"));
    values.insert("unit", Value::Word("mm".to_owned()));
    values.insert("contact", Value::Word("zone".to_owned()));
    if let Some(unit) = unit {
        values.insert("compliance_unit", Value::Word(unit.to_owned()));
    }
    let choice = MESHES.iter().find(|choice| choice.name == "file").unwrap();
    let shape: Result<Box<dyn Shape>, Invalid> = (choice.build)(&values);
    let shape = shape.map_err(|invalid| invalid.message)?;
    shape.filled().unwrap().map_err(|error| error.to_string())
}

fn bodies(meshed: ContactMesh, elasticity: Elasticity, held: Option<Support>) -> [Body; 2] {
    let base = meshed.mesh.surfaces.iter().position(|name| name == "base").unwrap();
    let finite = Finite {
        meshed,
        curvatures: Some([0.0; 2]),
        supports: held.map(|support| (base, support)).into_iter().collect(),
        mirrored: [false; 2],
        interpolation: Interpolation::Continuous,
        tolerance: 1e-6,
        elasticity,
    };
    let body = Body::new("block", Flat).material(STEEL);
    [Body { finite: Some(finite), ..body }, Body::new("punch", Flat)]
}

fn contact(bodies: &[Body; 2]) -> Result<Contact, ContactError> {
    Contact::new(bodies.each_ref(), &condense)
}

/// Some tractions that vary from pair to pair.
fn tractions(count: usize) -> VectorField {
    let along = |own: usize| (0..count).map(move |pair| ((7 * pair + 3 * own) % 11) as f64 - 4.0);
    VectorField { t1: along(0).collect(), t2: along(1).collect(), n: along(2).collect() }
}

/// The largest difference of displacements by a matrix from those by finite elements inside, relative to the largest.
fn off(files: [&str; 2], unit: Option<&str>, held: Option<Support>) -> f64 {
    let meshed = meshed(files, unit).unwrap();
    let displaced = |elasticity: Elasticity, held: Option<Support>| {
        let Contact { frame, compliance } =
            contact(&bodies(meshed.clone(), elasticity, held)).unwrap();
        compliance.apply(&tractions(frame.len())).components().concat()
    };
    let known = displaced(Elasticity::FiniteElements, Some(Support::Clamped));
    let found = displaced(Elasticity::Reduced, held);
    let largest = known.iter().fold(0.0, |largest: f64, one| largest.max(one.abs()));
    let differences = known.iter().zip(&found).map(|(one, other)| (one - other).abs());
    differences.fold(0.0, f64::max) / largest
}

/// What CalculiX stores of the same quadratic tetrahedra, with fourteen digits, reduced to the zone or as it is.
#[test]
fn superelements_of_calculix_give_way_as_their_elements() {
    let held = off(HELD, None, None);
    let free = off(FREE, Some("N/mm"), Some(Support::Clamped));
    assert!(held < 1e-9 && free < 1e-9, "{held:e} {free:e}");
}

/// The flexibility of the substructure, found from its compliance at the nodes, gives the same as the stiffness.
#[test]
fn flexibilities_are_inverse_stiffnesses() {
    let reduced = meshed(HELD, None).unwrap().reduced.unwrap();
    let size = reduced.size();
    let mut stiffness = faer::Mat::<f64>::zeros(size, size);
    for &(row, column, value) in &reduced.entries {
        stiffness[(row, column)] = value;
        stiffness[(column, row)] = value;
    }
    let inverse =
        crate::numerics::dense::Cholesky::new(size, |row, column| stiffness[(row, column)]);
    let inverse = inverse.unwrap();
    let mut text = format!("%%MatrixMarket matrix array real symmetric\n{size} {size}\n");
    for column in 0..size {
        let unit: Vec<f64> = (0..size).map(|row| f64::from(row == column)).collect();
        let displaced = inverse.solve(&unit);
        displaced[column..].iter().for_each(|one| text += &format!("{:.16e}\n", 1e3 * one));
    }
    // Rows by the numbers of the nodes, as CalculiX was told them.
    let off = off([HELD[0], &text], Some("mm/N"), None);
    assert!(off < 1e-9, "{off:e}");
}

#[test]
fn what_a_matrix_does_not_hold_is_said() {
    let said = |elasticity: Elasticity, files: [&str; 2], unit: Option<&str>, held| {
        contact(&bodies(meshed(files, unit).unwrap(), elasticity, held)).unwrap_err().to_string()
    };
    let free = said(Elasticity::Reduced, FREE, None, None);
    assert!(free.contains("nothing holds the body against displacement along"), "{free}");
    assert!(free.contains("rotation about z"), "{free}");
    let roller = said(Elasticity::Reduced, FREE, None, Some(Support::Roller));
    assert!(roller.contains("displacement along x") && !roller.contains("along z"), "{roller}");
    let missing = said(Elasticity::Reduced, HELD, None, Some(Support::Clamped));
    assert!(missing.contains("is to be held, and the matrix does not have it"), "{missing}");
    let loaded = said(Elasticity::Reduced, FREE, None, Some(Support::Pressure(1e6)));
    assert!(loaded.contains("`base` loads the body"), "{loaded}");
    for unit in ["N/m", "kN/mm"] {
        let off = said(Elasticity::Reduced, HELD, Some(unit), None);
        assert!(off.contains("times what a material of E = 2.1e11 Pa"), "{off}");
    }
}
