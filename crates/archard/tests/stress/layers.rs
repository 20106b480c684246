//! The largest stresses at interfaces of layers under Hertz's pressure and friction in proportion to it, against Hankel integrals of an
//! independent solution, searched over both coordinates: the radius and the largest pressure are one.

use archard::body::profile::Flat;
use archard::body::{Body, Layer, Material};
use archard::elastic::{ElasticError, Maxima, Maximum, Point, PressedHalfSpace};
use archard::frame::{ContactFrame, VectorField};

fn material([shear, poisson]: [f64; 2]) -> Material {
    Material { young: 2.0 * (1.0 + poisson) * shear, poisson }
}

/// A flat of layers (shear modulus, Poisson's ratio, thickness) on a material or on rigid ground.
fn flat(layers: &[[f64; 3]], base: Option<[f64; 2]>) -> Body {
    let layer = |&[shear, poisson, thickness]: &[f64; 3]| Layer {
        material: material([shear, poisson]),
        thickness,
    };
    let body = Body::new("flat", Flat).layers(layers.iter().map(layer).collect::<Vec<_>>());
    match base {
        Some(base) => body.material(material(base)),
        None => body,
    }
}

/// The mean of Hertz's pressure over elements, by a rule of 32 points, on a frame so many radii wide; friction along x on body 1.
fn pressed(
    body: Body,
    which: usize,
    (per_radius, radii): (usize, usize),
    mu: f64,
) -> PressedHalfSpace {
    let (h, n) = (1.0 / per_radius as f64, radii * per_radius);
    let size = [radii as f64; 2];
    let frame = ContactFrame::uniform(size, [n, n], [&Flat, &Flat]).unwrap();
    let mean = |[x, y]: [f64; 2]| {
        let at = |i: usize| h * ((i as f64 + 0.5) / 32.0 - 0.5);
        let all = (0..32 * 32).map(|i| {
            let (x, y) = (x + at(i % 32), y + at(i / 32));
            (1.0 - x * x - y * y).max(0.0).sqrt()
        });
        all.sum::<f64>() / 1024.0
    };
    let pressure: Vec<f64> = (0..n * n).map(|pair| mean(frame.place(pair))).collect();
    let tractions = VectorField {
        t1: pressure.iter().map(|p| mu * p).collect(),
        t2: vec![0.0; n * n],
        n: pressure.iter().map(|p| -p).collect(),
    };
    let other = Body::new("ball", Flat).material(material([1.0, 0.3]));
    let bodies = if which == 0 { [&body, &other] } else { [&other, &body] };
    PressedHalfSpace::in_contact(bodies, which, &frame, &tractions).unwrap()
}

fn maxima(pressed: &PressedHalfSpace) -> Maxima {
    pressed.maxima(&pressed.depths(), (&[0.0; 6], &[]), &mut |_, _| ()).unwrap()
}

#[track_caller]
fn within(found: &Maximum, known: f64, what: &str) {
    let (value, error) = (found.value, found.error);
    assert!((value - known).abs() < error + 1e-5, "{what}: {value} +- {error} for {known}");
}

/// Layers, base, friction; above the interface the largest and the least stress along it, across it the least and the largest shear, below it
/// the first two, and the equivalent stress there.
type Known = (&'static [[f64; 3]], Option<[f64; 2]>, f64, [f64; 4], Option<[f64; 2]>);

const KNOWN: [Known; 4] = [
    (
        &[[4.0, 0.25, 0.3]],
        Some([1.0, 0.3]),
        0.2,
        [0.265929, -0.567231, -0.859593, 0.247916],
        Some([0.009682, -0.240645]),
    ),
    (
        &[[0.25, 0.4, 0.5]],
        Some([1.0, 0.3]),
        0.1,
        [0.001360, -0.519290, -0.853497, 0.255517],
        Some([0.005892, -0.215665]),
    ),
    (&[[1.0, 0.45, 0.6]], None, 0.1, [f64::NAN, -0.691536, -0.845211, 0.267244], None),
    // A coating of half an element to one and a half.
    (
        &[[4.0, 0.25, 0.06]],
        Some([1.0, 0.3]),
        0.3,
        [0.592237, -1.305155, -0.993157, f64::NAN],
        Some([0.139342, -0.656518]),
    ),
];

#[test]
#[ignore = "long: in .ci/long"]
fn interfaces_bear_what_hankel_integrals_say_within_the_error() {
    for (layers, base, mu, above, below) in KNOWN {
        for grid in [(8, 8), (16, 6)] {
            let found = maxima(&pressed(flat(layers, base), 0, grid, mu));
            let [interface] = &found.interfaces[..] else { panic!("{:?}", found.interfaces) };
            let own = [
                (&interface.above.most, above[0]),
                (&interface.above.least, above[1]),
                (&interface.press, above[2]),
                (&interface.shear, above[3]),
            ];
            let of = format!("{layers:?} {grid:?}");
            for (found, known) in own.into_iter().filter(|(_, known)| !known.is_nan()) {
                within(found, known, &of);
                // So much that the number is of use, where it is not small and the interface not within a few elements.
                let resolved = grid.0 >= 16 && interface.depth * grid.0 as f64 >= 4.0;
                let fine = !resolved || known.abs() < 0.1 || found.error < 0.1 * known.abs();
                assert!(fine, "{of}: {found:?}");
            }
            match (below, &interface.below) {
                (None, None) => {}
                (Some([most, least]), Some(side)) => {
                    within(&side.most, most, &of);
                    within(&side.least, least, &of);
                }
                other => panic!("{other:?}"),
            }
        }
    }
}

/// Friction acts on body 2 the other way, and all else is the same.
#[test]
fn the_other_body_bears_the_mirror_image() {
    let (layers, base, ..) = KNOWN[0];
    let [one, other] =
        [0, 1].map(|which| maxima(&pressed(flat(layers, base), which, (12, 4), 0.2)));
    for (one, other) in one.interfaces.iter().zip(&other.interfaces) {
        let pairs = [
            (&one.shear, &other.shear),
            (&one.above.most, &other.above.most),
            (&one.press, &other.press),
        ];
        for (one, other) in pairs {
            assert!((one.value - other.value).abs() < 1e-9);
            assert!((one.place[0] + other.place[0]).abs() < 1e-9, "{one:?} {other:?}");
        }
    }
    assert_eq!(one.pieces.len(), 2);
    assert!(one.interfaces[0].shear.place[0] > 0.5);
}

/// Each layer has its own largest stresses: those of the whole are the largest of these.
#[test]
fn a_layer_yields_by_its_own_strength() {
    let (layers, base, ..) = KNOWN[0];
    let pressed = pressed(flat(layers, base), 0, (16, 4), 0.2);
    let strengths = [Some(2.0), Some(0.6)];
    let found = pressed.maxima(&pressed.depths(), (&[0.0; 6], &strengths), &mut |_, _| ()).unwrap();
    let [coat, below] = &found.pieces[..] else { panic!("{:?}", found.pieces) };
    // At the lower face of the coating, and a little below it, by the integrals.
    within(&coat.inside[0], 1.071112, "coating");
    within(&below.inside[0], 0.639754, "below");
    assert_eq!(found.inside[0], coat.inside[0]);
    assert!((coat.inside[0].place[2] + 0.3).abs() < 1e-12);
    for layer in &found.layers {
        let strength = strengths[layer.piece].unwrap();
        assert_eq!(layer.yields.unwrap() > 0.0, layer.largest[0].0 > strength);
    }
    let faces: Vec<usize> =
        found.layers.iter().filter(|own| own.depth == 0.3).map(|own| own.piece).collect();
    assert_eq!(faces, [0, 1]);
}

#[test]
fn points_on_interfaces_have_two_sides_and_rigid_ground_none() {
    let at = |z: f64| Point { name: "one".to_owned(), place: [0.0, 0.0, z] };
    let coat = pressed(flat(&[[4.0, 0.25, 0.3]], Some([1.0, 0.3])), 0, (12, 4), 0.0);
    let above = coat.points(&[at(-0.3)]).unwrap()[0];
    let below = coat.under([0.0, 0.0, -0.3]).unwrap();
    assert!((above.stress[2][2] - below.stress[2][2]).abs() < 1e-5);
    assert!(above.stress[0][0] > 0.1 && below.stress[0][0] < -0.1);
    assert!(coat.under([0.0, 0.0, -0.29]).is_none());
    let rigid = pressed(flat(&[[1.0, 0.45, 0.6]], None), 0, (12, 4), 0.1);
    assert!(rigid.points(&[at(-0.6)]).is_ok() && rigid.under([0.0, 0.0, -0.6]).is_none());
    assert!(matches!(rigid.points(&[at(-0.61)]), Err(ElasticError::Ground { .. })));
    assert!(rigid.check(&[0.7]).is_err());
}

/// Pressures that go on beyond the frame: layers carry their stresses along.
#[test]
fn nothing_is_said_where_pressures_are_cut() {
    let cut = pressed(flat(&[[4.0, 0.25, 0.3]], Some([1.0, 0.3])), 0, (8, 1), 0.0);
    assert!(matches!(cut.check(&[]), Err(ElasticError::Reach)));
    let point = Point { name: "one".to_owned(), place: [0.0, 0.0, -0.1] };
    assert!(cut.points(&[point]).is_err());
}
