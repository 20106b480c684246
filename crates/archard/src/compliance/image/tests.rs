use approx::assert_relative_eq;

use super::super::bem::contact::{Contact, ContactError, condense};
use super::{Compliance, Image};
use crate::body::mesh::{MESHES, Shape, SupportedSurfaces};
use crate::body::profile::{AxisymmetricPower, Flat};
use crate::body::{Body, Elasticity, Finite, Interpolation, Material, Support};
use crate::frame::{ContactFrame, Direction, Part, Rectangle, VectorField};
use crate::parameters::{Value, Values};

/// The side of the zone (m).
const ZONE: f64 = 0.2;

fn clamped() -> SupportedSurfaces {
    [("bottom".to_owned(), [true; 3])].into_iter().collect()
}

/// A block of that size (m) with a zone of so many elements, or none.
fn shape(size: [f64; 3], elements: Option<f64>) -> Box<dyn Shape> {
    let mut values = Values::default();
    values.insert("size", Value::Triple(size));
    if let Some(elements) = elements {
        let mut contact = Values::default();
        contact.insert("size", Value::Pair([ZONE; 2]));
        contact.insert("elements", Value::Pair([elements; 2]));
        values.insert("contact", Value::Section(contact));
    }
    let choice = MESHES.iter().find(|choice| choice.name == "box").unwrap();
    (choice.build)(&values).unwrap()
}

/// A block of steel clamped at its bottom; of so many elements in the zone, or with an image field.
fn block(size: [f64; 3], elements: Option<f64>) -> Body {
    let shape = shape(size, elements);
    let (meshed, elasticity) = match elements {
        Some(_) => (shape.mesh([false; 2], &clamped()).unwrap(), Elasticity::BoundaryElements),
        None => (
            shape.coarse(Some([[0.0; 2], [ZONE; 2]]), [false; 2], &clamped()).unwrap(),
            Elasticity::Image,
        ),
    };
    let bottom = meshed.mesh.surfaces.iter().position(|name| name == "bottom").unwrap();
    let finite = Finite {
        meshed,
        curvatures: Some([0.0; 2]),
        supports: vec![(bottom, Support::Clamped)],
        mirrored: [false; 2],
        interpolation: Interpolation::Discontinuous,
        tolerance: 1e-6,
        elasticity,
    };
    Body::new("block", Flat).material(Material::new(210e9, 0.3).unwrap()).finite(finite)
}

fn punch() -> Body {
    Body::new("punch", AxisymmetricPower::new(0.005, 2.0).unwrap())
}

/// Even tractions and such that rise along an axis displace pairs as the nodes of a mesh, less what half-spaces of both would, whose
/// pairs are others: what is smooth is told apart by its means over the zone, weighed with the tractions. Body 2 lies above.
#[test]
#[ignore = "long: in .ci/long"]
fn image_fields_are_those_of_meshes_along_all_axes() {
    let [dense, image] = [Some(6.0), None].map(|elements| block([0.6, 0.5, 0.4], elements));
    let half_space = || Body { finite: None, ..image.clone() };
    let frame = ContactFrame::uniform([ZONE; 2], [24; 2], [&Flat, &Flat]).unwrap();
    for which in 0..2 {
        let of = |body: &Body| {
            if which == 0 { [body.clone(), punch()] } else { [punch(), body.clone()] }
        };
        let on_half_space = |body: Body| {
            let [one, two] = of(&body);
            let finite = dense
                .finite
                .as_ref()
                .map(|finite| Finite { elasticity: Elasticity::HalfSpace, ..finite.clone() });
            let laid = |body: Body| {
                if body.material.is_some() { Body { finite: finite.clone(), ..body } } else { body }
            };
            [laid(one), laid(two)]
        };
        let meshed = |bodies: [Body; 2]| {
            let bodies = bodies.map(|body| Body { profile: std::sync::Arc::new(Flat), ..body });
            Contact::new(bodies.each_ref(), &condense).unwrap()
        };
        let (whole, laid) = (meshed(of(&dense)), meshed(on_half_space(half_space())));
        let imaged = Image::new(of(&image).each_ref(), &frame).unwrap();
        let plain = Image::new(of(&half_space()).each_ref(), &frame).unwrap();
        // Loads of one component, even or rising along x, seen by the others.
        for acting in 0..6 {
            for seeing in 0..6 {
                let work = |frame: &ContactFrame, compliance: &dyn Compliance| {
                    let field = |load: usize| {
                        let mut field = VectorField::zeros(frame.len());
                        let along = [&mut field.t1, &mut field.t2, &mut field.n];
                        let [t1, t2, n] = along;
                        let values = [t1, t2, n].into_iter().nth(load % 3).unwrap();
                        for (pair, value) in values.iter_mut().enumerate() {
                            let x = frame.place(pair)[0] / (0.5 * ZONE);
                            *value = if load < 3 { 1.0 } else { 3_f64.sqrt() * x };
                        }
                        field
                    };
                    let (load, seen) = (field(acting), field(seeing));
                    let displaced = compliance.apply(&load);
                    let products = displaced.components().into_iter().zip(seen.components());
                    let products: Vec<f64> = products
                        .flat_map(|(one, other)| one.iter().zip(other).map(|(a, b)| a * b))
                        .collect();
                    let areas = (0..3 * frame.len()).map(|at| frame.area(at % frame.len()));
                    products.iter().zip(areas).map(|(product, area)| product * area).sum::<f64>()
                };
                let scale = work(&frame, &imaged).abs().max(1e-16);
                let known =
                    work(&whole.frame, &*whole.compliance) - work(&laid.frame, &*laid.compliance);
                let found = work(&frame, &imaged) - work(&frame, &plain);
                let least = 5e-3 * work(&frame, &plain).abs().max(1e-15);
                assert!(
                    (found - known).abs() <= 0.03 * known.abs() + least,
                    "{which} {acting} {seeing}: {found:e} {known:e} of {scale:e}"
                );
            }
        }
    }
}

/// What a part of the frame, elements of twice the size, a larger frame and the passage from pair to pair make of a compliance is what
/// they make of its displacements.
#[test]
fn other_elements_and_passages_see_the_same_field() {
    let bodies = [punch(), block([1.0, 1.0, 1.0], None)];
    let frame = ContactFrame::uniform([ZONE; 2], [16, 12], [&Flat, &Flat]).unwrap();
    let image = Image::new(bodies.each_ref(), &frame).unwrap();
    let pressure: Vec<f64> = (0..192).map(|pair| f64::from(pair % 7)).collect();
    // A part: pressures on it alone.
    let part = Part::inside([6, 5], [[3, 7], [2, 5]]);
    let on_part = part.cut(&pressure);
    let (mut whole, mut within) = (vec![0.0; 192], vec![0.0; 30]);
    image.apply_normal(&part.put(&on_part), &mut whole);
    image.within(&part).unwrap().apply_normal(&on_part, &mut within);
    for (one, other) in within.iter().zip(part.cut(&whole)) {
        assert_relative_eq!(*one, other, max_relative = 1e-9);
    }
    // Twice the size: the same pressures displace the middle of four elements by their mean, nearly.
    let coarse: Vec<f64> = (0..48).map(|pair| f64::from(pair % 5)).collect();
    let fine: Vec<f64> = (0..192).map(|pair| coarse[pair % 16 / 2 + 8 * (pair / 16 / 2)]).collect();
    let mut on_coarse = vec![0.0; 48];
    image.coarser().unwrap().apply_normal(&coarse, &mut on_coarse);
    image.apply_normal(&fine, &mut whole);
    let mean: f64 = whole.iter().sum::<f64>() / 192.0;
    assert_relative_eq!(on_coarse.iter().sum::<f64>() / 48.0, mean, max_relative = 1e-2);
    // A larger frame.
    let larger = ContactFrame::uniform([ZONE * 1.5; 2], [24, 18], [&Flat, &Flat]).unwrap();
    let lying = Part::inside([16, 12], [[4, 4], [3, 3]]);
    let mut over = vec![0.0; 24 * 18];
    image.on(&larger).unwrap().apply_normal(&lying.put(&pressure), &mut over);
    image.apply_normal(&pressure, &mut whole);
    for (one, other) in lying.cut(&over).iter().zip(&whole) {
        assert_relative_eq!(*one, *other, max_relative = 1e-4);
    }
    assert!(image.on(&ContactFrame::uniform([1.1; 2], [8; 2], [&Flat, &Flat]).unwrap()).is_none());
    // Passages.
    let ones = vec![1.0; 192];
    let tractions = VectorField { t1: pressure.clone(), t2: ones.clone(), n: vec![0.0; 192] };
    let displaced = image.apply(&tractions);
    for direction in [Direction::X, Direction::Y.back()] {
        let flow = frame.flow(direction).unwrap();
        let map = image.rolling(flow);
        let (mut one, mut two) = (vec![0.0; 192], vec![0.0; 192]);
        map.apply([&pressure, &ones], [&mut one, &mut two]);
        let gained = flow.gained([&displaced.t1, &displaced.t2]);
        for pair in (0..192).filter(|&pair| direction.ahead(pair, [16, 12]).is_some()) {
            for (found, known) in [(one[pair], gained[0][pair]), (two[pair], gained[1][pair])] {
                assert_relative_eq!(found, known, epsilon = 1e-12 * map.own() * 100.0);
            }
        }
    }
}

/// Both bodies are blocks: each gives way as by itself.
#[test]
#[ignore = "long: in .ci/long"]
fn image_fields_of_two_bodies_add_up() {
    let frame = ContactFrame::uniform([ZONE; 2], [10; 2], [&Flat, &Flat]).unwrap();
    let [low, wide] = [[1.0, 1.0, 0.3], [0.8, 1.0, 0.6]].map(|size| block(size, None));
    let wide = Body { name: "wide".to_owned(), ..wide };
    let of = |bodies: [&Body; 2]| Image::new(bodies, &frame).unwrap();
    let values = |scale: usize| (0..100).map(|pair| ((pair * scale) % 11) as f64).collect();
    let tractions = VectorField { t1: values(3), t2: values(5), n: values(7) };
    let both = of([&low, &wide]).apply(&tractions);
    let [first, second] =
        [of([&low, &punch()]), of([&punch(), &wide])].map(|one| one.apply(&tractions));
    for (axis, both) in both.components().into_iter().enumerate() {
        let sums = first.components()[axis].iter().zip(second.components()[axis]);
        for (both, (one, other)) in both.iter().zip(sums) {
            assert_relative_eq!(*both, one + other, epsilon = 2e-4 * first.n[0].abs());
        }
    }
}

/// Even pressure on a block that is moved: what is missed grows by what the field at the ends of its way differs from that in the middle,
/// and a way past the end of the face is refused.
#[test]
#[ignore = "long: in .ci/long"]
fn what_is_missed_holds_what_moving_a_body_changes() {
    let bodies = [punch(), block([1.0, 0.6, 0.5], None)];
    let at = |x: f64| {
        let rectangle = Rectangle { centre: [x, 0.0], size: [ZONE; 2] };
        ContactFrame::uniform(rectangle, [16; 2], [&Flat, &Flat]).unwrap()
    };
    let moved = |way: f64| {
        let offsets = [Rectangle::from([0.0; 2]), Rectangle::from([2.0 * way, 0.0])];
        Image::moved(bodies.each_ref(), offsets, &at(0.0))
    };
    let even = VectorField { n: vec![1.0; 256], ..VectorField::zeros(256) };
    let still = Image::new(bodies.each_ref(), &at(0.0)).unwrap();
    let here = still.apply(&even);
    let largest = |field: &VectorField| {
        let size = |pair: usize| field.components().map(|along| along[pair].powi(2)).iter().sum();
        (0..256).map(size).fold(0.0, f64::max).sqrt()
    };
    for way in [0.1, 0.3] {
        let there = Image::new(bodies.each_ref(), &at(way)).unwrap();
        let mut change = there.apply(&even);
        let VectorField { t1, t2, n } = &mut change;
        for (there, here) in [t1, t2, n].into_iter().zip(here.components()) {
            there.iter_mut().zip(here).for_each(|(there, here)| *there -= here);
        }
        let changed = largest(&change) / largest(&here);
        let known = still.missed(&even).unwrap();
        let stated = moved(way).unwrap().missed(&even).unwrap();
        assert!(changed > 2.0 * known, "{way}: {changed} {known}");
        // The change is that between coarse meshes, each off by what it misses.
        let off = known + there.missed(&even).unwrap();
        assert!((stated - changed - known).abs() <= off, "{way}: {stated} {changed} {known} {off}");
    }
    assert!(matches!(moved(0.41), Err(ContactError::LeavesTheFace { body: 1 })));
}
