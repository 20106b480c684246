//! A patch that bears so little that only some of the grids have it.

mod simple;

use archard_rail::contact::{Patch, Resolution, contact};
use archard_rail::setup::{Attitude, Setup, Track};
use simple::{ARM, bodies, curve, operation, wheelset};

/// Load (N) on the wheel.
const LOAD: f64 = 20e3;

/// Two bumps of a wheel, 100 mm in radius and 24 mm apart, of which the one towards the flange is so much (m) less high, on a
/// nearly flat rail.
fn bumps(less: f64) -> Setup {
    let angles = (-400..=400).map(|at| f64::from(at) * 1e-4);
    let head = curve(angles.map(|angle| [angle, 0.5 * angle * angle]));
    let places = (-250..=250).rev().map(|at| f64::from(at) * 1e-4);
    let height = |y: f64| -(y.abs() - 12e-3).powi(2) / 0.2 - if y < 0.0 { less } else { 0.0 };
    let wheel = curve(places.map(|y| [y, height(y)]));
    let track = Track { gauge: 2.0 * (ARM - 0.04), gauge_height: 1.0, cant: 0.0 };
    Setup::new(track, &head, wheelset(), &wheel).unwrap()
}

fn patches(setup: &Setup, elements: usize) -> Vec<Patch> {
    let operation = operation(Attitude::default(), (2.0, 0.01), LOAD);
    let resolution = Resolution { elements, ..Resolution::default() };
    contact(setup, &bodies(0.3), &operation, &resolution).unwrap()
}

/// Between the least height that a grid misses and the most that it has, which a bisection finds, the second bump bears next to
/// nothing: its errors are numbers that hold what four times as many elements find, and what it bears is uncertain by all of it.
#[test]
fn a_patch_that_coarser_grids_miss_has_true_errors() {
    for elements in [32, 36] {
        let (mut both, mut one) = (0.0, 1e-4);
        for _ in 0..30 {
            let less = 0.5 * (both + one);
            match patches(&bumps(less), elements).len() {
                1 => one = less,
                _ => both = less,
            }
        }
        let setup = bumps(both);
        let found = patches(&setup, elements);
        let [_, light] = &found[..] else { panic!("{} patches", found.len()) };
        assert!(light.values.normal_force < 1e-3 * LOAD, "{:?}", light.values);
        assert!(light.values.normal_force <= light.errors.normal_force);
        assert!(light.errors.peak_pressure >= light.values.peak_pressure);
        let fine = patches(&setup, 4 * elements);
        for (at, patch) in found.iter().enumerate() {
            let (values, errors) = (patch.values.values(), patch.errors.values());
            assert!(errors.iter().all(|error| !error.is_nan()), "{errors:?}");
            let Some(fine) = fine.get(at) else {
                // Gone on finer elements: nothing is left of what it bore.
                assert!(patch.errors.normal_force >= patch.values.normal_force);
                continue;
            };
            let all = values.into_iter().zip(errors).zip(fine.values.values());
            for (((value, error), fine), own) in all.zip(fine.errors.values()) {
                assert!((value - fine).abs() <= error + own, "{value} {error} {fine} {own}");
            }
        }
    }
}
