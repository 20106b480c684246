//! Finite elements inside bodies, and matrices of other programs in their place.

mod reduced;

use std::sync::Arc;

use faer::Mat;

use super::Solid;
use super::held::held;
use crate::body::Body;
use crate::body::mesh::{ContactMesh, MESHES, Mesh, Shape, SupportedSurfaces, Volume};
use crate::body::profile::Flat;
use crate::body::{Elasticity, Finite, Interpolation, Material, Support};
use crate::compliance::bem::contact::{BodiesInContact, Contact, condense};
use crate::compliance::bem::image::{ImageBody, Polynomials};
use crate::frame::Rectangle;
use crate::frame::VectorField;
use crate::parameters::{Value, Values};

/// A block below z = 0 of that size (m), in cubes divided along x, y and z, each in six tetrahedra; the surface is named by its sides.
pub(crate) fn block(size: [f64; 3], divisions: [usize; 3]) -> ContactMesh {
    let [nx, ny, nz] = divisions;
    let index = |[x, y, z]: [usize; 3]| x + (nx + 1) * (y + (ny + 1) * z);
    let mut places = vec![];
    for z in 0..=nz {
        for y in 0..=ny {
            for x in 0..=nx {
                let share = [x as f64 / nx as f64, y as f64 / ny as f64, z as f64 / nz as f64];
                places.push([
                    (share[0] - 0.5) * size[0],
                    (share[1] - 0.5) * size[1],
                    (share[2] - 1.0) * size[2],
                ]);
            }
        }
    }
    // The ways from one corner of a cube to the opposite one along its edges.
    let ways = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
    let mut tetrahedra = vec![];
    for z in 0..nz {
        for y in 0..ny {
            for x in 0..nx {
                for way in ways {
                    let mut at = [x, y, z];
                    let mut corners = [index(at); 4];
                    for (step, axis) in way.into_iter().enumerate() {
                        at[axis] += 1;
                        corners[step + 1] = index(at);
                    }
                    tetrahedra.push(corners);
                }
            }
        }
    }
    let volume = Volume::of_corners(places, &tetrahedra);
    let names = ["top", "bottom", "sides"].map(str::to_owned).to_vec();
    let nodes = volume.nodes.clone();
    let mesh: Mesh = volume.surface(names, |corners| {
        let all = |level: f64| corners.iter().all(|node| (nodes[*node][2] - level).abs() < 1e-9);
        if all(0.0) { 0 } else { 1 + usize::from(!all(-size[2])) }
    });
    ContactMesh { mesh, volume: Some(Arc::new(volume)), ..ContactMesh::default() }
}

fn finite(meshed: ContactMesh) -> Finite {
    let bottom = meshed.mesh.surfaces.iter().position(|name| name == "bottom").unwrap();
    Finite {
        meshed,
        curvatures: Some([0.0; 2]),
        supports: vec![(bottom, Support::Clamped)],
        mirrored: [false; 2],
        interpolation: Interpolation::Discontinuous,
        tolerance: 1e-6,
        elasticity: Elasticity::Image,
    }
}

const MATERIAL: Material = Material { young: 2.6, poisson: 0.3 };
const SIZE: [f64; 3] = [1.0, 0.8, 0.6];

fn polynomials() -> Polynomials {
    Polynomials::new(Rectangle { centre: [0.05, 0.0], size: [0.2, 0.3] }, 2)
}

/// K of a block in so many cubes, and what it may be off.
fn by_volume(divisions: [usize; 3]) -> [Mat<f64>; 2] {
    let finite = finite(block(SIZE, divisions));
    let volume = Arc::clone(finite.meshed.volume.as_ref().unwrap());
    let found = Solid::new(&finite, &volume, &MATERIAL).unwrap().image(&polynomials());
    [found.compliance, found.change]
}

/// K of the same block by boundary elements, and what halving them changed.
fn by_surface() -> [Mat<f64>; 2] {
    let mut values = Values::default();
    values.insert("size", Value::Triple(SIZE));
    let choice = MESHES.iter().find(|choice| choice.name == "box").unwrap();
    let shape: Box<dyn Shape> = (choice.build)(&values).unwrap();
    let held: SupportedSurfaces = [("bottom".to_owned(), [true; 3])].into_iter().collect();
    let meshed = shape.coarse(Some([[0.05, 0.0], [0.2, 0.3]]), [false; 2], &held).unwrap();
    let finite = finite(meshed);
    let of = |mesh: &Mesh| {
        let imaged = ImageBody { finite: &finite, mesh, material: &MATERIAL };
        imaged.compliance(&polynomials()).unwrap()
    };
    let (coarse, fine) = (of(&finite.meshed.mesh), of(&finite.meshed.mesh.divided()));
    let change = &fine - coarse;
    [fine, change]
}

/// Finite elements inside and boundary elements around the same block find one field, along all axes; and they are off by no more than
/// both say, to a tenth, nor by much less.
#[test]
fn image_fields_are_those_of_boundary_elements() {
    let [known, unknown] = by_surface();
    let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
    for divisions in [[5, 4, 3], [10, 8, 6]] {
        let [found, stated] = by_volume(divisions);
        for load in 0..known.ncols() {
            let at = |matrix: &Mat<f64>| matrix[(load, load)];
            let off = (at(&found) - at(&known)).abs();
            let share = off / (at(&stated) + at(&unknown).abs());
            (least, most) = (least.min(off / at(&stated)), most.max(share));
        }
    }
    assert!(most < 1.1 && least > 0.5, "{least} {most}");
}

/// A block whose top may touch, on rollers all around, and a rigid punch.
fn rod(divisions: [usize; 3]) -> [Body; 2] {
    let mut meshed = block(SIZE, divisions);
    meshed.placed = true;
    meshed.zone = meshed.mesh.zone("top").unwrap();
    let held = |name: &str| meshed.mesh.surfaces.iter().position(|known| known == name).unwrap();
    let finite = Finite {
        supports: ["bottom", "sides"].map(|name| (held(name), Support::Roller)).to_vec(),
        interpolation: Interpolation::Continuous,
        elasticity: Elasticity::FiniteElements,
        ..finite(meshed)
    };
    let body = Body::new("block", Flat).material(MATERIAL);
    [Body { finite: Some(finite), ..body }, Body::new("punch", Flat)]
}

/// A block that cannot widen is pressed by p L (1 + nu) (1 - 2 nu) / ((1 - nu) E), and its stress is the same all over it.
#[test]
fn a_block_that_bears_its_contact_is_pressed_as_a_rod() {
    let bodies = rod([4, 3, 2]);
    let Contact { frame, compliance } = Contact::new(bodies.each_ref(), &condense).unwrap();
    let area: f64 = (0..frame.len()).map(|pair| frame.area(pair)).sum();
    assert!((area - SIZE[0] * SIZE[1]).abs() < 1e-12, "{area}");
    let Material { young, poisson } = MATERIAL;
    let modulus = young * (1.0 - poisson) / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
    let mut displaced = vec![0.0; frame.len()];
    compliance.apply_normal(&vec![1.0; frame.len()], &mut displaced);
    for own in displaced {
        assert!((own * modulus / SIZE[2] - 1.0).abs() < 1e-9, "{own}");
    }
    // Tractions on body 1, whose normal the pressure acts against.
    let even = VectorField { n: vec![-1.0; frame.len()], ..VectorField::zeros(frame.len()) };
    assert!(compliance.missed(&even).unwrap() < 1e-6);
    let meeting = BodiesInContact::of(bodies.each_ref()).unwrap();
    let (_, inside) = meeting.inside(0, &even).unwrap().unwrap();
    let across = -poisson / (1.0 - poisson);
    for place in [[0.0, 0.0, -0.3], [0.31, -0.2, -0.01], [-0.5, 0.4, 0.0]] {
        let stress = inside.at(place.into()).unwrap().stress;
        assert!((stress.z_axis.z + 1.0).abs() < 1e-9 && (stress.x_axis.x - across).abs() < 1e-9);
        assert!(stress.x_axis.y.abs() < 1e-9 && stress.y_axis.z.abs() < 1e-9);
    }
    assert!(inside.at([0.0, 0.0, 0.2].into()).is_none());
}

/// Tractions of two fields do the same work on each other's displacements; and the matrix of all pairs says what applications do.
#[test]
fn applications_keep_the_work_and_are_those_of_the_matrix() {
    let bodies = rod([4, 3, 2]);
    let Contact { frame, compliance } = Contact::new(bodies.each_ref(), &condense).unwrap();
    let field = |seed: usize| {
        let along = |own: usize| {
            (0..frame.len()).map(|pair| ((7 * pair + 3 * own + seed) % 11) as f64 - 5.0).collect()
        };
        VectorField { t1: along(0), t2: along(1), n: along(2) }
    };
    let work = |one: &VectorField, other: &VectorField| -> f64 {
        let pairs = 0..frame.len();
        let along = one.components().into_iter().zip(other.components());
        along
            .map(|(one, other)| {
                pairs.clone().map(|pair| frame.area(pair) * one[pair] * other[pair]).sum::<f64>()
            })
            .sum()
    };
    let [one, other] = [field(1), field(4)];
    let [of_one, of_other] = [&one, &other].map(|own| compliance.apply(own));
    let [given, taken] = [work(&one, &of_other), work(&other, &of_one)];
    assert!((given - taken).abs() < 1e-9 * work(&one, &of_one).abs(), "{given} {taken}");
    assert!(compliance.matrix(&[0]).is_some());
    let again = compliance.apply(&one);
    for (before, after) in of_one.components().into_iter().zip(again.components()) {
        let largest = before.iter().fold(0.0_f64, |largest, own| largest.max(own.abs()));
        assert!(before.iter().zip(after).all(|(a, b)| (a - b).abs() < 1e-9 * largest));
    }
}

/// A group of the four sides of a block holds its edges across both sides that meet there, and its bottom the corners along z too.
#[test]
fn rollers_on_one_group_of_several_faces_hold_their_edges_both_ways() {
    let meshed = block(SIZE, [2, 2, 2]);
    let volume = meshed.volume.clone().unwrap();
    let own = |name: &str| meshed.mesh.surfaces.iter().position(|known| known == name).unwrap();
    let supports = ["bottom", "sides"].map(|name| (own(name), Support::Roller)).to_vec();
    let [nodes, _] = held(&Finite { supports, ..finite(meshed) }, &volume);
    for (node, held) in volume.nodes.iter().zip(&nodes) {
        let on = |axis: usize| (2.0 * node[axis].abs() - SIZE[axis]).abs() < 1e-9;
        let bottom = (node[2] + SIZE[2]).abs() < 1e-9;
        let known = [on(0), on(1), bottom].into_iter().filter(|on| *on).count();
        assert_eq!(held.count, known, "{node:?}");
    }
}
