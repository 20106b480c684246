//! Largest stresses of contacts that are solved on frames, against closed forms of what they approach.

use std::f64::consts::PI;

use archard::body::Profile;
use archard::body::profile::{Cylinder, Flat, Sphere};
use archard::closed_form::first_yield::FirstYield;
use archard::elastic::{Maxima, Pressed};
use archard::frame::VectorField;
use archard::motion::Control;
use archard::{Body, Contact, Material};

/// The largest stresses in body 1 or 2 of a contact under Hertz's load, with friction in proportion to the pressure.
fn maxima(contact: &Contact, which: usize, mu: f64) -> (Maxima, Pressed) {
    let problem = contact.problem();
    let pressure = contact.pressure();
    let tractions = VectorField {
        t1: pressure.iter().map(|p| mu * p).collect(),
        t2: vec![0.0; pressure.len()],
        n: pressure.iter().map(|p| -p).collect(),
    };
    let bodies = problem.bodies.each_ref();
    let pressed = Pressed::in_contact(bodies, which, &problem.frame, &tractions).unwrap();
    let depths = pressed.depths();
    (pressed.maxima(&depths, (&[0.0; 6], None), &mut |_, _| ()).unwrap(), pressed)
}

fn bodies(profile: impl Profile + 'static) -> [Body; 2] {
    let steel = Material { young: 210e9, poisson: 0.3 };
    [Body::new("ball", profile).material(steel), Body::new("flat", Flat).material(steel)]
}

/// A ball of 10 mm whose contact has a radius of 0.1 mm, so many elements over it; the peak pressure.
fn ball(per_radius: usize) -> (Contact, f64) {
    let (a, radius, modulus) = (1e-4, 1e-2, 210e9 / 0.91 / 2.0);
    let load = 4.0 / 3.0 * modulus * a * a * a / radius;
    let pressed =
        Contact::between(bodies(Sphere::new(radius).unwrap()), Control::Load(load)).unwrap();
    let contact = pressed.frame([3.0 * a; 2], [3 * per_radius; 2]).solve().unwrap();
    (contact, 1.5 * load / (PI * a * a))
}

/// What is found is within its error of what is known, with the error of the pressures themselves, a hundredth on the coarsest
/// grid, on top; and the error is no larger than it has to be.
#[test]
fn largest_stresses_of_a_ball_are_within_their_errors() {
    let poisson = 0.3;
    for mu in [0.0, 0.25, 0.5] {
        // Tables of the whole field (Hankel integrals).
        let (inside, depth) = match mu {
            0.0 => (0.620041, 0.48086),
            0.25 => (0.647593, 0.44405),
            _ => (0.732065, f64::NAN),
        };
        let edge = (1.0 - 2.0 * poisson) / 3.0 + mu * PI * (4.0 + poisson) / 8.0;
        let mut missed = vec![];
        for per_radius in [8, 16, 32] {
            let (contact, peak) = ball(per_radius);
            for which in [0, 1] {
                let (maxima, _) = maxima(&contact, which, mu);
                let (found, tension) = (maxima.inside[0], maxima.surface[2].unwrap());
                let pressures = 0.16 / per_radius as f64;
                let off = found.value / peak - inside;
                assert!(
                    off.abs() < found.error / peak + pressures * inside,
                    "von Mises, mu {mu}, {per_radius}: {} {}",
                    found.value / peak,
                    found.error / peak
                );
                let off = tension.value / peak - edge;
                assert!(
                    off.abs() < tension.error / peak + pressures * edge,
                    "tension, mu {mu}, {per_radius}: {} {} for {edge}",
                    tension.value / peak,
                    tension.error / peak
                );
                if mu < 0.4 && per_radius > 8 {
                    let deep = -found.place[2] / 1e-4;
                    assert!((deep - depth).abs() < 0.02, "{deep} for {depth}");
                }
                // Friction pushes body 1 along x, and pulls behind the contact; body 2 the other way.
                if mu > 0.0 && per_radius > 8 {
                    let x = tension.place[0] / if which == 0 { -1e-4 } else { 1e-4 };
                    assert!((x - 1.0).abs() < 0.1, "{x}");
                }
                missed.push((found.error / peak, tension.error / peak));
            }
        }
        let [coarse, .., fine] = &missed[..] else { panic!("grids") };
        assert!(fine.0 < coarse.0 / 6.0 && fine.0 < 2e-3, "mu {mu}: {missed:?}");
        assert!(fine.1 < 0.03 * edge.max(0.5), "mu {mu}: {missed:?}");
    }
}

/// McEwen's field: von Mises inside, and the shear along the surface by which lines shake down.
#[test]
fn largest_stresses_of_a_line_are_within_their_errors() {
    let (a, radius, modulus) = (1e-4, 1e-2, 210e9 / 0.91 / 2.0);
    let length = 1e-3;
    let load = PI * modulus * a * a / (4.0 * radius) * length;
    let peak = 2.0 * load / length / (PI * a);
    for (mu, yields, shakes) in [
        (0.0, 0.557516, 4.0),
        (0.2, 0.589993, 3.2024),
        (0.3, 0.634042, 2.8996),
        (0.5, f64::NAN, 2.0),
    ] {
        let profile = Cylinder::along_y(radius).unwrap();
        let pressed = Contact::between(bodies(profile), Control::Load(load)).unwrap();
        let contact = pressed.line([3.0 * a, length], 192).solve().unwrap();
        let (maxima, pressed) = maxima(&contact, 0, mu);
        let found = maxima.inside[0];
        if yields > 0.0 {
            assert!(
                (found.value / peak - yields).abs() < found.error / peak + 1e-3,
                "mu {mu}: {} {}",
                found.value / peak,
                found.error / peak
            );
        }
        let shear = pressed.shakes_down(&maxima).unwrap() / peak;
        assert!((shear * shakes - 1.0).abs() < 4e-3, "mu {mu}: {} for {shakes}", 1.0 / shear);
        if mu == 0.0 {
            let known = FirstYield::under_line(0.3);
            assert!((peak / found.value / known.pressure - 1.0).abs() < 2e-3);
            assert!((-found.place[2] / a - known.depth).abs() < 0.02);
        }
    }
}

#[test]
fn explore() {
    for per in [8, 10, 12, 16, 20, 24, 32, 48, 64] {
        let (contact, peak) = ball(per);
        for mu in [0.0, 0.1, 0.25, 0.5] {
            let (maxima, _) = maxima(&contact, 0, mu);
            let edge = 0.4 / 3.0 + mu * PI * 4.3 / 8.0;
            let of = |m: Option<archard::elastic::Maximum>| {
                m.map(|m| {
                    (m.value / peak, m.error / peak, m.order, m.place[0] / 1e-4, m.place[1] / 1e-4)
                })
            };
            let t = of(maxima.surface[2]).unwrap_or_default();
            println!(
                "per {per} mu {mu} off {:+.4} {t:.4?} vM {:.4?} | inside {:.4?}",
                t.0 - edge,
                of(maxima.surface[0]),
                of(Some(maxima.inside[0]))
            );
        }
    }
}
