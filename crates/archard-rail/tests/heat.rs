//! Heat of friction between a wheel and its rail: flash temperatures in closed form, and friction that falls with them.

mod simple;

use std::sync::Arc;

use archard::body::{Thermal, contact_modulus};
use archard::closed_form::Hertz;
use archard::closed_form::flash_temperature::{peclet, semi_ellipse};
use archard::friction::{Circumstance, Coulomb, Friction, Table};
use archard_rail::contact::{Bodies, Patch, Resolution, contact};
use archard_rail::setup::Attitude;
use simple::{HEAD, WHEEL, bodies, cone, operation, steel};

/// Load (N) and speed (m/s).
const LOAD: f64 = 50e3;
const SPEED: f64 = 10.0;
/// Temperature (K) of wheel and rail.
const BULK: f64 = 293.15;

/// A cylinder on a round head, driven by a share of its speed.
fn driven(share: f64, friction: Arc<dyn Friction>, elements: usize) -> Patch {
    let setup = cone(0.0, 0.06);
    let heat = Thermal::new(50.0, 13e-6).unwrap().at(BULK).unwrap();
    let bodies = Bodies { thermal: [Some(heat); 2], friction, ..bodies(0.3) };
    let operation = operation(Attitude::default(), (SPEED, share), LOAD);
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
