use std::f64::consts::PI;

use approx::assert_relative_eq;

use super::{Branch, PartialSlip};
use crate::body::Material;

const STEEL: Material = Material { young: 210e9, poisson: 0.3 };

/// The contact of the reference values: R = 50 mm, 10.2 N, steel on steel, mu = 0.3.
fn pin() -> PartialSlip {
    PartialSlip::new(0.05, [Some(&STEEL); 2], 10.2, 0.3).unwrap()
}

/// 2 pi times the integral of f(r) r, 0 to the edge of the contact, r = a sin t.
fn over_contact(contact: &PartialSlip, f: impl Fn(f64) -> f64) -> f64 {
    let count = 200_000;
    let step = 0.5 * PI / f64::from(count);
    let a = contact.contact_radius;
    let part = |i: i32| {
        let (sine, cosine) = ((f64::from(i) + 0.5) * step).sin_cos();
        f(a * sine) * sine * cosine
    };
    2.0 * PI * a * a * step * (0..count).map(part).sum::<f64>()
}

/// Reference values at Q = 1.53 N: c = 0.118345 mm, shift 5.993896e-5 mm, 1.396453e-5 N mm a cycle.
#[test]
fn the_reference_contact() {
    let contact = pin();
    assert_relative_eq!(contact.contact_radius, 0.1491058e-3, max_relative = 1e-6);
    assert_relative_eq!(contact.stick_radius(1.53), 0.118345e-3, max_relative = 5e-6);
    assert_relative_eq!(contact.shift(1.53), 5.993896e-8, max_relative = 1e-7);
    assert_relative_eq!(contact.dissipation(1.53), 1.396453e-8, max_relative = 3e-7);
}

/// Reference value: R = 10 mm, 50 N, mu = 0.6, steel on steel, stick zone 0.6 of the contact at a
/// shift of 1.023 um.
#[test]
fn the_amplitude_of_a_stick_zone() {
    let contact = PartialSlip::new(0.01, [Some(&STEEL); 2], 50.0, 0.6).unwrap();
    let stick_radius = 0.6 * contact.contact_radius;
    let shift = contact.shift_at_stick_radius(stick_radius);
    assert_relative_eq!(shift, 1.023e-6, max_relative = 5e-4);
    let force = contact.force_at_stick_radius(stick_radius);
    assert_relative_eq!(force, 30.0 * (1.0 - 0.216), max_relative = 1e-12);
    assert_relative_eq!(contact.force(shift), force, max_relative = 1e-12);
    assert_relative_eq!(contact.stick_radius(force), stick_radius, max_relative = 1e-12);
}

#[test]
fn tractions_sum_to_the_force() {
    let contact = pin();
    for force in [0.4, 1.53, -2.9, 3.06] {
        let sum = over_contact(&contact, |r| contact.traction(r, force));
        assert_relative_eq!(sum, force, max_relative = 1e-6);
    }
    let swing = contact.oscillation(2.5);
    for (branch, force) in [(Branch::Unloading, -1.7), (Branch::Reloading, 2.4)] {
        let sum = over_contact(&contact, |r| swing.traction(branch, r, force));
        assert_relative_eq!(sum, force, max_relative = 1e-6);
    }
}

/// The energy is friction times four times the slip at the extreme, summed over the contact.
#[test]
fn slip_under_friction_makes_the_dissipation() {
    let contact = pin();
    for force in [0.3, 1.53, 3.0] {
        let rubbed = |r: f64| 4.0 * 0.3 * contact.pressure(r) * contact.slip(r, force);
        let energy = over_contact(&contact, rubbed);
        assert_relative_eq!(energy, contact.dissipation(force), max_relative = 1e-6);
    }
}

/// The area of the loop of force over shift.
#[test]
fn the_loop_encloses_the_dissipation() {
    let contact = pin();
    for amplitude in [0.5, 1.53, 3.06] {
        let swing = contact.oscillation(amplitude);
        let extreme = swing.shift_amplitude();
        let count = 200_000;
        let step = 2.0 * extreme / f64::from(count);
        let opening = |i: i32| {
            let shift = (f64::from(i) + 0.5) * step - extreme;
            swing.force(Branch::Unloading, shift) - swing.force(Branch::Reloading, shift)
        };
        let area = -step * (0..count).map(opening).sum::<f64>();
        assert_relative_eq!(area, contact.dissipation(amplitude), max_relative = 1e-6);
    }
}

/// A swing starts where the first loading ended, ends opposite to it and never passes friction.
#[test]
fn a_swing_goes_from_one_extreme_to_the_other() {
    let contact = pin();
    let swing = contact.oscillation(2.0);
    for r in [0.0, 0.3, 0.6, 0.8, 0.95].map(|share| share * contact.contact_radius) {
        let first = contact.traction(r, 2.0);
        assert_relative_eq!(swing.traction(Branch::Unloading, r, 2.0), first);
        let last = swing.traction(Branch::Unloading, r, -2.0);
        assert_relative_eq!(last, -first, max_relative = 1e-9, epsilon = 1.0);
        for force in [-1.5, -0.3, 0.0, 1.1, 1.9] {
            let traction = swing.traction(Branch::Unloading, r, force);
            let limit = 0.3 * contact.pressure(r);
            assert!(traction.abs() <= limit * (1.0 + 1e-12));
            let slipped = r > swing.stick_radius(Branch::Unloading, force);
            assert_eq!(slipped, traction < -limit * (1.0 - 1e-9), "at {r} under {force}");
            let mirrored = swing.traction(Branch::Reloading, r, -force);
            assert_relative_eq!(mirrored, -traction);
        }
    }
    for (force, branch) in [(1.2, Branch::Unloading), (-1.9, Branch::Reloading)] {
        let shift = swing.shift(branch, force);
        assert_relative_eq!(swing.force(branch, shift), force, max_relative = 1e-12);
    }
    let end = swing.shift(Branch::Unloading, -2.0);
    assert_relative_eq!(end, -contact.shift(2.0), max_relative = 1e-12);
}

/// Limits of a small force: the bodies stick all over, shift = S Q/(8 a), and lose
/// S Q^3/(36 mu P a) a cycle.
#[test]
fn small_forces_keep_their_digits() {
    let contact = pin();
    let compliance = 2.0 * 1.7 / (210e9 / 2.6);
    let force = 3e-9;
    let a = contact.contact_radius;
    let shift = compliance * force / (8.0 * a);
    assert_relative_eq!(contact.shift(-force), -shift, max_relative = 1e-8);
    assert_relative_eq!(contact.force(shift), force, max_relative = 1e-8);
    let energy = compliance * force.powi(3) / (36.0 * 3.06 * a);
    assert_relative_eq!(contact.dissipation(force), energy, max_relative = 1e-8);
}

#[test]
fn all_slips_in_the_end() {
    let contact = pin();
    assert_eq!(contact.stick_radius(5.0), 0.0);
    assert_eq!(contact.shift(-5.0), -contact.sliding_shift);
    assert_eq!(contact.force(1.0), contact.sliding_force);
    let r = 0.5 * contact.contact_radius;
    assert_eq!(contact.traction(r, 5.0), 0.3 * contact.pressure(r));
    assert_relative_eq!(contact.slip(r, 5.0), contact.sliding_shift / 8.0);
    assert_eq!(contact.oscillation(-5.0).force_amplitude(), contact.sliding_force);
}

#[test]
fn no_contact_without_load_friction_or_elasticity() {
    for (radius, load, friction) in [(0.0, 1.0, 0.3), (0.05, -1.0, 0.3), (0.05, 1.0, 0.0)] {
        assert_eq!(PartialSlip::new(radius, [Some(&STEEL); 2], load, friction), None);
    }
    assert_eq!(PartialSlip::new(0.05, [None; 2], 1.0, 0.3), None);
}
