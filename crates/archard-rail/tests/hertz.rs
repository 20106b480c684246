//! A cylinder on a rail with a circular head, where Hertz's theory gives the contact, and what cannot be a contact.

mod simple;

use std::sync::Arc;

use archard::Material;
use archard::body::contact_modulus;
use archard::closed_form::Hertz;
use archard::friction::Coulomb;
use archard_rail::Invalid;
use archard_rail::contact::{Bodies, ContactError, Operation, Patch, Resolution, contact, pitch};
use archard_rail::curve::Smoothing;
use archard_rail::setup::{Attitude, Setup, Side, Track, Wheelset};
use archard_rail::standard::{rail_60e1, wheel_s1002};
use simple::{ARM, HEAD, WHEEL, bodies, cone, curve, wheelset};

const LOAD: f64 = 50e3;

/// A wheelset that yaws, is driven by a share of its speed and carries a load (N) on the wheel.
fn operation(yaw: f64, driven: f64, load: f64) -> Operation {
    simple::operation(Attitude { yaw, ..Attitude::default() }, (2.0, driven), load)
}

fn one(setup: &Setup, coefficient: f64, operation: &Operation) -> Patch {
    let mut found =
        contact(setup, &bodies(coefficient), operation, &Resolution::default()).unwrap();
    assert_eq!(found.len(), 1, "{found:?}");
    found.remove(0)
}

/// Hertz's peak, area and approach lie within the errors that are told, which are 1 % or less of peak and approach. All of it
/// slips: friction is Coulomb's.
#[test]
fn a_cylinder_is_pressed_as_hertz_says() {
    let patch = one(&cone(0.0, 0.06), 0.3, &operation(0.0, 0.05, LOAD));
    let (of, errors) = (patch.values, patch.errors);
    let steel = bodies(0.3).wheel;
    let modulus = contact_modulus([Some(&steel), Some(&steel)]);
    let hertz = Hertz::from_load([1.0 / WHEEL, 1.0 / HEAD], modulus, LOAD).unwrap();
    for (name, value, error, expected) in [
        ("peak", of.peak_pressure, errors.peak_pressure, hertz.peak_pressure),
        ("approach", of.approach, errors.approach, hertz.approach),
        ("area", of.contact_area, errors.contact_area, hertz.contact_area()),
    ] {
        let off = value / expected - 1.0;
        eprintln!("{name}: {off:+.2e}, error told {:.2e}", error / value);
        assert!((value - expected).abs() <= error && error < 0.03 * value, "{name}");
    }
    assert!((of.normal_force / LOAD - 1.0).abs() < 1e-5);
    assert!((of.force_x / (0.3 * LOAD) + 1.0).abs() < 1e-3);
    let power = 0.3 * LOAD * of.creepage * 2.0 * 1.025;
    assert!((of.frictional_power / power - 1.0).abs() < 1e-3);
    // The map bears the forces, and the driven wheel slips backwards.
    let map = &patch.map;
    let element = map.spacing[0] * map.spacing[1];
    let sum = |field: &[f64]| field.iter().sum::<f64>();
    assert!((sum(&map.pressure) * element / of.normal_force - 1.0).abs() < 1e-9);
    assert!((sum(&map.traction[0]) * element / of.force_x - 1.0).abs() < 1e-9);
    let touching = map.pressure.iter().filter(|&&pressure| pressure > 0.0).count() as f64;
    let slip = sum(&map.slip[0]) / touching;
    assert!((slip / of.creepage + 1.0).abs() < 0.05, "{slip} {}", of.creepage);
}

/// Normal force and friction in an inclined plane bear the load together; the left wheel is the right one in a mirror.
#[test]
fn an_inclined_plane_bears_the_load() {
    let setup = cone(0.1, 0.06);
    let right = operation(0.03, 0.0, LOAD);
    let of = one(&setup, 0.3, &right).values;
    let (sin, cos) = of.contact_angle.sin_cos();
    assert!(((of.normal_force * cos + of.force_s * sin) / LOAD - 1.0).abs() < 2e-5);
    assert!(of.force_s < -0.2 * LOAD, "{of:?}");
    let turned = Operation { attitude: Attitude { yaw: -0.03, ..right.attitude }, ..right };
    let left = Operation {
        attitude: Side::Left.attitude(turned.attitude),
        velocity: Side::Left.velocity(turned.velocity),
        ..turned
    };
    assert_eq!(one(&setup, 0.3, &left).values, of);
}

/// Two bumps of the wheel, 100 mm in radius and 12 mm apart, on a nearly flat rail: with a plane and a grid each, pressed
/// apart by each other, they are as on one grid, to what the pressures of a point leave out, the square of 2 over 12 mm.
#[test]
fn patches_press_each_other_apart() {
    let angles = (-400..=400).map(|at| f64::from(at) * 1e-4);
    let head = curve(angles.map(|angle| [angle, 0.5 * angle * angle]));
    let places = (-150..=150).rev().map(|at| f64::from(at) * 1e-4);
    let wheel = curve(places.map(|y| [y, -(y.abs() - 6e-3).powi(2) / 0.2]));
    let track = Track { gauge: 2.0 * (ARM - 0.04), gauge_height: 1.0, cant: 0.0 };
    let setup = Setup::new(track, &head, wheelset(), &wheel).unwrap();
    let found = |join: f64| {
        let resolution = Resolution { join, ..Resolution::default() };
        contact(&setup, &bodies(0.3), &operation(0.0, 0.0, LOAD), &resolution).unwrap()
    };
    let (joined, apart) = (found(1.0), found(0.0));
    let ([joined], [one, other]) = (&joined[..], &apart[..]) else {
        panic!("{joined:?}, {apart:?}")
    };
    let depth = |patch: &Patch| patch.values.z_wheel - patch.values.onset;
    let off = [
        depth(one) / depth(joined) - 1.0,
        one.values.peak_pressure / joined.values.peak_pressure - 1.0,
        (one.values.contact_area + other.values.contact_area) / joined.values.contact_area - 1.0,
    ];
    eprintln!("apart over joined: {off:.4?}");
    assert!(off.iter().all(|off| off.abs() < 0.03), "{off:?}");
}

#[test]
fn what_is_no_contact_is_told() {
    let found = |setup: &Setup, coefficient: f64, operation: &Operation| {
        contact(setup, &bodies(coefficient), operation, &Resolution::default())
    };
    let usual = operation(0.0, 0.0, LOAD);
    let beside = Attitude { shift: 0.3, ..Attitude::default() };
    let setup = cone(0.0, 0.06);
    let no_contact = found(&setup, 0.3, &Operation { attitude: beside, ..usual });
    assert!(matches!(no_contact, Err(ContactError::NoContact)), "{no_contact:?}");
    let short = found(&cone(0.0, 2e-3), 0.3, &usual);
    assert!(matches!(short, Err(ContactError::Short { .. })), "{short:?}");
    let heavy = found(&setup, 0.3, &operation(0.0, 0.0, 1e12));
    assert!(matches!(heavy, Err(ContactError::Short { .. })), "{heavy:?}");
    for load in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let invalid = found(&setup, 0.3, &operation(0.0, 0.0, load));
        let Err(ContactError::Invalid(Invalid { parameter, .. })) = invalid else { panic!() };
        assert_eq!(parameter, "load");
    }
}

/// Random attitudes of the standard's wheel on its rail: an error, or patches that bear the load with finite values.
#[test]
fn any_attitude_ends_in_a_contact_or_an_error() {
    let rail = rail_60e1(0.5e-3).unwrap().curve(Smoothing::NONE).unwrap();
    let wheel = wheel_s1002(0.5e-3).unwrap().curve(Smoothing::NONE).unwrap();
    let setup = Setup::new(Track::standard(), &rail, wheelset(), &wheel).unwrap();
    let (mut found, mut failed) = (0, vec![]);
    for seed in 0..60 {
        let mut random = fastrand::Rng::with_seed(seed);
        let mut any = |size: f64| (2.0 * random.f64() - 1.0) * size;
        let attitude = Attitude { shift: any(0.012), roll: any(2e-3), yaw: any(0.03) };
        let load = 10f64.powf(4.0 + any(1.5));
        let operation = Operation { attitude, load, ..operation(0.0, any(0.02), load) };
        let resolution = Resolution { elements: 16, ..Resolution::default() };
        match contact(&setup, &bodies(0.3), &operation, &resolution) {
            Ok(patches) => {
                found += 1;
                let vertical = patches.iter().map(|patch| {
                    let of = patch.values;
                    assert!(of.values().iter().all(|value| value.is_finite()), "seed {seed}");
                    of.normal_force * of.contact_angle.cos() + of.force_s * of.contact_angle.sin()
                });
                assert!((vertical.sum::<f64>() / load - 1.0).abs() < 1e-5, "seed {seed}");
            }
            Err(error) => failed.push(format!("seed {seed}: {attitude:?} {load:.0}: {error}")),
        }
    }
    eprintln!("{found} contacts; {failed:#?}");
    assert!(found > 40);
}

/// A wheel of 420 mm whose tread is round, of 10 mm, in a groove of 20 mm.
fn groove() -> Setup {
    let angles = || (-600..=600).map(|at| f64::from(at) * 1.6e-3);
    let arc = |radius: f64, angle: f64| [radius * angle.sin(), radius * angle.cos() - radius];
    let rail = curve(angles().map(|angle| arc(20e-3, angle)));
    let round = curve(angles().rev().map(|angle| arc(10e-3, angle)));
    let gauge = 2.0 * (ARM - 20e-3 * 0.96f64.sin());
    let track = Track { gauge, gauge_height: 1.0, cant: 0.0 };
    let wheelset = Wheelset { nominal_radius: 0.42, ..wheelset() };
    Setup::new(track, &rail, wheelset, &round).unwrap()
}

/// A free wheel in a groove slips but for two lines at 0.347 of the half-width, where its rolling radius is that of its speed (Heathcote;
/// Johnson, *Contact Mechanics*, section 8.5): so much friction dissipates where next to nothing sticks. In the plane it rolls freely.
#[test]
fn a_groove_slips_but_for_two_lines() {
    let steel = Material::new(210e9, 0.3).unwrap();
    let (mu, load, setup) = (1e-4, 10e3, groove());
    let rolled = |curved: bool| {
        let friction = Arc::new(Coulomb::new(mu).unwrap());
        let wear = [None, None];
        let bodies = Bodies {
            wheel: steel,
            rail: steel,
            thermal: [None, None],
            friction,
            flange: None,
            wear,
            flange_wear: None,
            shear_yield: 800e6,
        };
        let resolution = Resolution { elements: 64, curved, ..Resolution::default() };
        let mut operation = operation(0.0, 0.0, load);
        operation.velocity.pitch =
            pitch([&setup; 2], &bodies, &operation, &resolution, 0.0).unwrap();
        contact(&setup, &bodies, &operation, &resolution).unwrap().remove(0)
    };
    let plane = rolled(false).values;
    assert!(plane.frictional_power.abs() < 1e-9 && plane.creepage.abs() < 1e-8, "{plane:?}");
    let modulus = contact_modulus([Some(&steel), Some(&steel)]);
    let hertz = Hertz::from_load([1.0 / 0.42, 1.0 / 10e-3 - 1.0 / 20e-3], modulus, load).unwrap();
    let half = hertz.semi_axes[1];
    // Halfway between both bodies.
    let bow = 0.5 * (1.0 / 10e-3 + 1.0 / 20e-3) / (2.0 * 0.42);
    // The root of x - x^3/3 = 1/3: rows bear in proportion to 1 - x^2, and forwards as much as backwards.
    let line = 0.347_296_f64;
    let found = rolled(true);
    // Whole rows slip forwards or backwards.
    let row = found.map.spacing[1] / half;
    let slips_from = (found.values.creepage / bow).sqrt() / half;
    assert!((slips_from - line).abs() < row, "{slips_from} {row}");
    let steps = 10_000;
    let rows = (0..steps).map(|at| (f64::from(at) + 0.5) / f64::from(steps));
    let slip = rows.map(|x| 1.5 * (1.0 - x * x) * (x * x - line * line).abs()).sum::<f64>();
    let power = mu * load * bow * half * half * slip / f64::from(steps) * 2.0;
    let off = found.values.frictional_power / power - 1.0;
    eprintln!("from {slips_from:.3}, power {off:+.2e}, bent by {}", found.angle_spread);
    assert!(off.abs() < 0.005, "{off}");
}
