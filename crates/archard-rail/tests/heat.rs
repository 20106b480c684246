//! Heat of friction between a wheel and its rail: flash temperatures in closed form, and friction that falls with them.

use std::sync::Arc;

use archard::Material;
use archard::body::{Thermal, contact_modulus};
use archard::closed_form::Hertz;
use archard::closed_form::flash_temperature::{peclet, semi_ellipse};
use archard::friction::{Circumstance, Coulomb, Friction, Table};
use archard_rail::Profile;
use archard_rail::contact::{Bodies, Operation, Patch, Resolution, contact};
use archard_rail::curve::{Curve, Smoothing};
use archard_rail::setup::{Attitude, Setup, Track, Velocity, Wheelset};

/// Radii (m) of the wheel and of the head of the rail, where the rail stands (m), the load (N), the speed (m/s).
const WHEEL: f64 = 0.46;
const HEAD: f64 = 0.3;
const ARM: f64 = 0.75;
const LOAD: f64 = 50e3;
const SPEED: f64 = 10.0;
/// Temperature (K) of wheel and rail.
const BULK: f64 = 293.15;

fn curve(points: impl Iterator<Item = [f64; 2]>) -> Curve {
    Profile::new(points.collect()).unwrap().curve(Smoothing::NONE).unwrap()
}

fn steel() -> Material {
    Material::new(210e9, 0.3).unwrap()
}

/// A cylinder on a round head, driven by a share of its speed.
fn driven(share: f64, friction: Arc<dyn Friction>, elements: usize) -> Patch {
    let angles = (-400..=400).map(|at| f64::from(at) * 5e-4);
    let head = curve(angles.map(|angle| [HEAD * angle.sin(), HEAD - HEAD * angle.cos()]));
    let wheel = curve((-60..=60).rev().map(|at| [f64::from(at) * 1e-3, 0.0]));
    let gauge = 2.0 * (ARM - HEAD * 0.2f64.sin());
    let track = Track { gauge, gauge_height: 1.0, cant: 0.0 };
    let wheelset =
        Wheelset { flange_back_distance: 1.36, flange_back_position: -0.07, nominal_radius: WHEEL };
    let setup = Setup::new(track, &head, wheelset, &wheel).unwrap();
    let heat = Thermal::new(50.0, 13e-6).unwrap().at(BULK).unwrap();
    let bodies = Bodies {
        wheel: steel(),
        rail: steel(),
        thermal: [Some(heat); 2],
        friction,
        flange: None,
        wear: [None, None],
        flange_wear: None,
        shear_yield: 800e6,
    };
    let pitch = -SPEED * (1.0 + share) / WHEEL;
    let operation = Operation {
        attitude: Attitude::default(),
        velocity: Velocity { forward: SPEED, pitch, ..Velocity::default() },
        load: LOAD,
        transfer: 0.0,
        creepages: Default::default(),
    };
    let resolution = Resolution { elements, curved: false, ..Resolution::default() };
    contact(&setup, &bodies, &operation, &resolution).unwrap().remove(0)
}

/// All slips at nearly one speed: the rise is that below Hertz's heat, taken up by both surfaces by their speeds (Blok; Ertz and Knothe).
#[test]
fn a_wheel_that_spins_is_as_warm_as_the_closed_form() {
    let (mu, share) = (0.3, 0.2);
    let patch = driven(share, Arc::new(Coulomb::new(mu).unwrap()), 48);
    let warmth = patch.warmth.unwrap();
    let modulus = contact_modulus([Some(&steel()), Some(&steel())]);
    let hertz = Hertz::from_load([1.0 / WHEEL, 1.0 / HEAD], modulus, LOAD).unwrap();
    let half = hertz.semi_axes[0];
    let effusivity = Thermal::new(50.0, 13e-6).unwrap().effusivity();
    let taken = effusivity * (SPEED.sqrt() + (SPEED * (1.0 + share)).sqrt());
    // Creepage at which a strip of that length slips all over: mu a over the radius.
    let begins = mu * half / WHEEL / share;
    let [largest, _] = semi_ellipse(begins);
    let rise = largest * mu * hertz.peak_pressure * share * SPEED * half.sqrt() / taken;
    let [found, error] = warmth.rise;
    eprintln!("{found} K, {:+.2e}, error told {:.2e}", found / rise - 1.0, error / found);
    // The approximation of strips is worth as much as what it corrects.
    assert!((found - rise).abs() <= error + begins * rise, "{found} {rise} {error}");
    assert!(error < 0.05 * found);
    let slower = peclet(SPEED, half, 13e-6);
    assert!((warmth.peclet / slower - 1.0).abs() < 0.1, "{} {slower}", warmth.peclet);
    let most = patch.map.rise.iter().copied().fold(0.0, f64::max);
    assert_eq!(most, found);
}

/// Where all slips each place bears the coefficient of its own temperature, and the wheel pulls less than a cold one.
#[test]
fn friction_falls_with_the_temperature_of_each_place() {
    let coefficient = |kelvin: f64| 0.4 - 0.3 * (kelvin - BULK) / 1000.0;
    let table = |hot: f64| {
        let places = [BULK, BULK + 1000.0];
        Arc::new(Table::over(Circumstance::Temperature, &places, &[0.4, hot]).unwrap())
    };
    let [cold, falls] = [table(0.4), table(0.1)].map(|law| driven(0.2, law, 32));
    let plain = driven(0.2, Arc::new(Coulomb::new(0.4).unwrap()), 32);
    assert!((cold.values.force_x / plain.values.force_x - 1.0).abs() < 1e-6);
    assert!(falls.values.force_x.abs() < 0.95 * cold.values.force_x.abs());
    let map = &falls.map;
    let mut held = 0;
    for at in 0..map.pressure.len() {
        // In the first half of a row what was strained before it slips goes back.
        if map.pressure[at] < 0.3 * falls.values.peak_pressure {
            continue;
        }
        let traction = map.traction[0][at].hypot(map.traction[1][at]);
        let own = coefficient(BULK + map.rise[at]);
        assert!((traction / map.pressure[at] - own).abs() < 2e-3, "{traction} {own}");
        held += 1;
    }
    assert!(held > 200, "{held}");
}
