//! A wheel on a roller: Hertz's contact of both curvatures, the place of a yawed wheel, creepages and spin in closed form.

mod simple;

use archard::body::contact_modulus;
use archard::closed_form::Hertz;
use archard_rail::contact::{Patch, Resolution, contact};
use archard_rail::creepage::Creepage;
use archard_rail::curve::Smoothing;
use archard_rail::search::{JOIN, Search};
use archard_rail::setup::{Attitude, Setup, Track, Velocity};
use archard_rail::standard::{rail_60e1, wheel_s1002};
use simple::{ARM, HEAD, WHEEL, bodies, cone, operation, steel, wheelset};

/// Radius (m) of the roller, load (N) and speed (m/s).
const ROLLER: f64 = 0.35;
const LOAD: f64 = 50e3;
const SPEED: f64 = 2.0;

/// A straight wheel of that slope on a roller whose rim is round.
fn on_a_roller(slope: f64) -> Setup {
    cone(slope, 0.06).on_a_roller(ROLLER).unwrap()
}

fn s1002_on_60e1() -> Setup {
    let rail = rail_60e1(0.2e-3).unwrap().curve(Smoothing::NONE).unwrap();
    let wheel = wheel_s1002(0.2e-3).unwrap().curve(Smoothing::NONE).unwrap();
    Setup::new(Track::standard(), &rail, wheelset(), &wheel).unwrap()
}

fn solved(setup: &Setup, attitude: Attitude, driven: f64) -> Vec<Patch> {
    let operation = operation(attitude, (SPEED, driven), LOAD);
    contact(setup, &bodies(0.3), &operation, &Resolution::default()).unwrap()
}

/// Peak, area and approach are those of Hertz with 1/R of the wheel and of the roller along the track, to the errors told.
#[test]
fn a_cylinder_is_pressed_on_a_roller_as_hertz_says() {
    let patches = solved(&on_a_roller(0.0), Attitude::default(), 0.02);
    let [patch] = &patches[..] else { panic!("{} patches", patches.len()) };
    let modulus = contact_modulus([Some(&steel()), Some(&steel())]);
    let along = 1.0 / WHEEL + 1.0 / ROLLER;
    let hertz = Hertz::from_load([along, 1.0 / HEAD], modulus, LOAD).unwrap();
    let (of, errors) = (patch.values, patch.errors);
    for (name, value, error, expected) in [
        ("peak", of.peak_pressure, errors.peak_pressure, hertz.peak_pressure),
        ("approach", of.approach, errors.approach, hertz.approach),
        ("area", of.contact_area, errors.contact_area, hertz.contact_area()),
    ] {
        eprintln!("{name}: {:+.2e}, error told {:.2e}", value / expected - 1.0, error / value);
        assert!((value - expected).abs() <= error && error < 0.03 * value, "{name}");
    }
    // Half of the places that touch lie within the semi-axis along the track.
    let map = &patch.map;
    let row = map.elements[1] / 2 * map.elements[0];
    let touching = map.pressure[row..row + map.elements[0]].iter().filter(|one| **one > 0.0);
    let half = 0.5 * touching.count() as f64 * map.spacing[0];
    assert!((half - hertz.semi_axes[0]).abs() < map.spacing[0], "{half} {:?}", hertz.semi_axes);
}

/// A yawed cylinder touches the ring of the roller's rim where the way from the middle of the rim's section to the axle is shortest: that is
/// found by halving, from nothing but two lines in space.
#[test]
fn a_yawed_cylinder_touches_where_axle_and_ring_are_nearest() {
    let setup = on_a_roller(0.0);
    for yaw in [0.0f64, 0.01, -0.04] {
        let (sin, cos) = yaw.sin_cos();
        let ring = ROLLER - HEAD;
        // Distances in the plane across the axle, from the middle of the section at that x, with the axle so high above the track.
        let way = |x: f64, axle: f64| {
            let lower = ROLLER - (ring * ring - x * x).sqrt();
            [x * cos + ARM * sin, lower + axle]
        };
        let nearest = |axle: f64| {
            let (mut from, mut to) = (-0.9 * ring, 0.9 * ring);
            for _ in 0..200 {
                let x = 0.5 * (from + to);
                let [u, w] = way(x, axle);
                let grows = u * cos + w * x / (ring * ring - x * x).sqrt();
                if grows > 0.0 { to = x } else { from = x }
            }
            0.5 * (from + to)
        };
        let (mut low, mut high) = (WHEEL - 0.01, WHEEL + 0.01);
        for _ in 0..60 {
            let axle = 0.5 * (low + high);
            let [u, w] = way(nearest(axle), axle);
            if u.hypot(w) > WHEEL + HEAD { high = axle } else { low = axle }
        }
        let x = nearest(low);
        let [u, w] = way(x, low);
        let on_the_rim = x - HEAD * u / u.hypot(w) * cos;
        let onset = Search::new(&setup, Attitude { yaw, ..Attitude::default() }).unwrap().onset();
        let onset = onset.unwrap();
        assert!((onset.height - (WHEEL - low)).abs() < 1e-9, "{} {}", onset.height, WHEEL - low);
        assert!((onset.at.point.x - on_the_rim).abs() < 1e-6, "{} {on_the_rim}", onset.at.point.x);
        let patches = solved(&setup, Attitude { yaw, ..Attitude::default() }, 0.0);
        let down: f64 = patches.iter().map(|patch| patch.force()[2]).sum();
        assert!((down / LOAD - 1.0).abs() < 1e-5, "{down}");
    }
}

/// Both surfaces turn about their axes: the creepage is the difference of their speeds at the contact, and each turns about the normal
/// by the sine of the contact angle.
#[test]
fn spin_and_creepage_are_those_of_both_rotations() {
    let setup = on_a_roller(0.1);
    let search = Search::new(&setup, Attitude::default()).unwrap();
    let height = search.onset().unwrap().height + 20e-6;
    let patch = search.patches(height, JOIN).unwrap().remove(0);
    let rate = 1.003 * SPEED / WHEEL;
    let velocity = Velocity { forward: SPEED, pitch: -rate, ..Velocity::default() };
    let approach = 15e-6;
    let found = Creepage::new(&search, &patch, &velocity, approach);
    let z = patch.reference.z + approach * patch.angle.cos();
    let wheel = rate * (z - setup.centre(search.attitude(), height).z);
    let roller = SPEED / ROLLER * (ROLLER - z);
    let mean = 0.5 * (wheel + roller);
    let spin = -patch.angle.sin() * (rate + SPEED / ROLLER) / mean;
    assert!((found.speed / mean - 1.0).abs() < 1e-9);
    assert!((found.longitudinal - (wheel - roller) / mean).abs() < 1e-9);
    assert!(found.lateral.abs() < 1e-12);
    assert!((found.spin / spin - 1.0).abs() < 1e-9, "{} {spin}", found.spin);
}

/// On a roller of endless radius a wheel does what it does on a rail.
#[test]
fn a_roller_of_endless_radius_is_a_rail() {
    let attitude = Attitude { shift: 3e-3, roll: -0.18e-3, yaw: 7e-3 };
    let rail = solved(&s1002_on_60e1(), attitude, 1e-3);
    let roller = solved(&s1002_on_60e1().on_a_roller(1e9).unwrap(), attitude, 1e-3);
    assert_eq!(rail.len(), roller.len());
    for (rail, roller) in rail.iter().zip(&roller) {
        let all = rail.values.values().into_iter().zip(roller.values.values());
        for ((rail, roller), error) in all.zip(rail.errors.values()) {
            let same = 1e-6 * rail.abs() + 1e-3 * error;
            assert!((rail - roller).abs() <= same, "{rail} {roller}");
        }
    }
}

#[test]
fn what_is_no_roller_is_refused() {
    let setup = s1002_on_60e1();
    for radius in [0.0, -1.0, f64::NAN, f64::INFINITY, 5e-3] {
        let refused = setup.clone().on_a_roller(radius).unwrap_err();
        assert_eq!(refused.parameter, "rail_radius", "{radius}");
    }
}
