//! Largest stresses of contacts that are solved on frames, against closed forms of what they approach.

use std::f64::consts::PI;

use archard::body::Profile;
use archard::body::profile::{Cylinder, Flat, Sphere};
use archard::closed_form::first_yield::FirstYield;
use archard::elastic::{MEASURES, Maxima, Maximum, Pressed};
use archard::frame::VectorField;
use archard::motion::Control;
use archard::stress::Components;
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

/// What pressures on a frame miss on top of what is stated, relative to the stress: they are those of the solver, no means of
/// Hertz's.
const PRESSURES: f64 = 0.01;

#[track_caller]
fn within(found: Maximum, known: f64, peak: f64) {
    let [value, error] = [found.value, found.error].map(|own| own / peak);
    assert!((value - known).abs() < error + PRESSURES * known, "{value} +- {error} for {known}");
}

#[test]
fn largest_stresses_of_a_ball_are_within_their_errors() {
    // Of the whole field (Hankel integrals): below the surface, and at the trailing edge on it.
    for (mu, inside, rim) in
        [(0.0, 0.620041, 0.230940), (0.25, 0.647593, 0.579284), (0.5, f64::NAN, 0.956684)]
    {
        let tension = 0.4 / 3.0 + mu * PI * 4.3 / 8.0;
        let mut errors = vec![];
        for per_radius in [8, 12, 16, 20, 32, 48] {
            let (contact, peak) = ball(per_radius);
            for which in [0, 1] {
                let (maxima, _) = maxima(&contact, which, mu);
                let [deep, largest, pulled] =
                    [maxima.inside[0], maxima.surface[0].unwrap(), maxima.surface[2].unwrap()];
                within(largest, rim, peak);
                within(pulled, tension, peak);
                if inside > 0.0 {
                    within(deep, inside, peak);
                    let known = if mu == 0.0 { 0.48086 } else { 0.44405 };
                    assert!((-deep.place[2] / 1e-4 - known).abs() < 0.02, "{:?}", deep.place);
                }
                // Friction pushes body 1 along x, and pulls behind the contact; body 2 the other way.
                if mu > 0.0 {
                    let x = pulled.place[0] / if which == 0 { -1e-4 } else { 1e-4 };
                    assert!((x - 1.0).abs() < 0.1, "{x}");
                }
                errors.push([deep.error, pulled.error].map(|own| own / peak));
            }
        }
        let [coarse, .., fine] = &errors[..] else { panic!("grids") };
        assert!(fine[0] < coarse[0] / 8.0 && fine[0] < 1e-3, "mu {mu}: {errors:?}");
        assert!(fine[1] < 0.02, "mu {mu}: {errors:?}");
    }
}

/// E. McEwen, *Phil. Mag.* 40 (1949) 454; J. O. Smith & C. K. Liu, *J. Appl. Mech.* 20 (1953) 157: z into the body.
fn mcewen(x: f64, z: f64, mu: f64) -> Components {
    let b = 1.0 - x * x + z * z;
    let r = b.hypot(2.0 * x * z);
    let (m, n) = ((0.5 * (r + b)).sqrt(), (0.5 * (r - b)).max(0.0).sqrt().copysign(x));
    let sum = m * m + n * n;
    let xx = -(m * (1.0 + (z * z + n * n) / sum) - 2.0 * z);
    let (zz, xz) = (-m * (1.0 - (z * z + n * n) / sum), -n * (m * m - z * z) / sum);
    let sheared = n * (2.0 - (z * z - m * m) / sum) - 2.0 * x;
    let (xx, zz, xz) = (xx + mu * sheared, zz + mu * xz, xz + mu * xx);
    [xx, 0.3 * (xx + zz), zz, 0.0, xz, 0.0]
}

/// The field of McEwen at the places that are found, its largest equivalent stress, below the surface or on it, and the shear along
/// the surface by which lines shake down.
#[test]
fn largest_stresses_of_a_line_are_within_their_errors() {
    let (a, radius, modulus) = (1e-4, 1e-2, 210e9 / 0.91 / 2.0);
    let length = 1e-3;
    let load = PI * modulus * a * a / (4.0 * radius) * length;
    let peak = 2.0 * load / length / (PI * a);
    for (mu, yields, shakes) in [
        (0.0, 0.557516, 4.0),
        (0.2, 0.589993, 3.2024),
        (0.3, 0.666633, 2.8996),
        (0.5, 0.974679, 2.0),
    ] {
        let profile = Cylinder::along_y(radius).unwrap();
        let pressed = Contact::between(bodies(profile), Control::Load(load)).unwrap();
        let contact = pressed.line([3.0 * a, length], 192).solve().unwrap();
        let (maxima, pressed) = maxima(&contact, 0, mu);
        within(maxima.largest(0), yields, peak);
        if mu > 0.0 {
            within(maxima.surface[2].unwrap(), 2.0 * mu, peak);
        }
        for (found, (name, measure)) in maxima.inside.iter().zip(MEASURES) {
            let [x, _, z] = found.place;
            let known = measure(&mcewen(x / a, -z / a, mu));
            let off = (found.value / peak - known).abs();
            assert!(off < found.error / peak + PRESSURES, "{name}, mu {mu}: {found:?} for {known}");
        }
        let shear = pressed.shakes_down(&maxima).unwrap() / peak;
        assert!((shear * shakes - 1.0).abs() < 4e-3, "mu {mu}: {} for {shakes}", 1.0 / shear);
        if mu == 0.0 {
            let (known, found) = (FirstYield::under_line(0.3), maxima.inside[0]);
            assert!((peak / found.value / known.pressure - 1.0).abs() < 2e-3);
            assert!((-found.place[2] / a - known.depth).abs() < 0.02);
        }
    }
}
