//! Largest stresses of contacts that are solved on frames, against closed forms of what they approach; and criteria of fatigue.

mod stress {
    mod criteria;
    mod fretting;
    mod layers;
}

use std::f64::consts::PI;

use archard::body::Profile;
use archard::body::profile::{Cylinder, Flat, FlatEnd, Sphere};
use archard::closed_form::first_yield::FirstYield;
use archard::closed_form::sliding_line;
use archard::elastic::{Criterion, ElasticError, Maxima, Maximum, PressedHalfSpace};
use archard::frame::VectorField;
use archard::motion::Control;
use archard::stress::{Components, MEASURES, von_mises};
use archard::{Body, Contact, Material};

/// Body 1 or 2 of a contact, with friction along x (Pa) by the place and the pressure.
fn pressed(
    contact: &Contact,
    which: usize,
    friction: impl Fn([f64; 2], f64) -> f64,
) -> PressedHalfSpace {
    let (problem, pressure) = (contact.problem(), contact.pressure());
    let frame = &problem.frame;
    let tractions = VectorField {
        t1: pressure.iter().enumerate().map(|(i, p)| friction(frame.place(i), *p)).collect(),
        t2: vec![0.0; pressure.len()],
        n: pressure.iter().map(|p| -p).collect(),
    };
    PressedHalfSpace::in_contact(problem.bodies.each_ref(), which, frame, &tractions).unwrap()
}

/// The largest stresses, with an even one.
fn largest(pressed: &PressedHalfSpace, initial: Components) -> Maxima {
    pressed.maxima(&pressed.depths(), (&initial, &[]), &mut |_, _| ()).unwrap()
}

/// The largest stresses in body 1 or 2 of a contact, with friction in proportion to the pressure.
fn maxima(contact: &Contact, which: usize, mu: f64) -> (Maxima, PressedHalfSpace) {
    let pressed = pressed(contact, which, |_, pressure| mu * pressure);
    (largest(&pressed, [0.0; 6]), pressed)
}

fn bodies(profile: impl Profile + 'static) -> [Body; 2] {
    let steel = Material { young: 210e9, poisson: 0.3 };
    [Body::new("ball", profile).material(steel), Body::new("flat", Flat).material(steel)]
}

/// A ball of 10 mm whose contact has a radius of 0.1 mm, so many elements over it; the peak pressure.
fn ball(per_radius: usize) -> (Contact, f64) {
    ball_on([per_radius; 2])
}

/// The same with so many elements along x and y.
fn ball_on(per_radius: [usize; 2]) -> (Contact, f64) {
    let (a, radius, modulus) = (1e-4, 1e-2, 210e9 / 0.91 / 2.0);
    let load = 4.0 / 3.0 * modulus * a * a * a / radius;
    let pressed =
        Contact::between(bodies(Sphere::new(radius).unwrap()), Control::Load(load)).unwrap();
    let contact = pressed.frame([3.0 * a; 2], per_radius.map(|n| 3 * n)).solve().unwrap();
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
#[ignore = "long: in .ci/long"]
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

/// Next rows do not say by how much elements stand out from an edge that is nearly along them: less so where elements are long across
/// it. The largest stresses are known on the rim of a ball, as above.
#[test]
fn unequal_elements_say_how_far_off_their_edges_are() {
    for per_radius in [[8, 16], [8, 32], [10, 10], [10, 20], [12, 24], [16, 8], [16, 32], [32, 8]] {
        for (mu, rim) in [(0.25, 0.579284), (0.5, 0.956684)] {
            let (contact, peak) = ball_on(per_radius);
            let (maxima, _) = maxima(&contact, 0, mu);
            for (measure, known) in [(0, rim), (2, 0.4 / 3.0 + mu * PI * 4.3 / 8.0)] {
                let [value, error] = maxima.surface[measure]
                    .map(|found| [found.value / peak, found.error / peak])
                    .unwrap();
                assert!((value - known).abs() < error, "{per_radius:?} {mu}: {value} +- {error}");
            }
        }
    }
}

/// Under an even stress other edges than those of the largest tension by friction may count. On the rim: Johnson, section 3.4, and
/// Hamilton & Goodman, *J. Appl. Mech.* 33 (1966) 371.
#[test]
fn an_even_stress_is_added_before_edges_are_chosen() {
    let (contact, peak) = ball(20);
    let (mu, nu) = (0.3, 0.3);
    let pressed = pressed(&contact, 0, |_, pressure| mu * pressure);
    for [added_x, added_y] in [[-2.7, 0.0], [0.0, -2.7], [3.4, 0.0]] {
        let rim = (0..3600).map(|step| {
            let (y, x) = (PI * f64::from(step) / 1800.0).sin_cos();
            let (ring, rubbed) = ((1.0 - 2.0 * nu) / 3.0, mu * PI / 8.0);
            let xx = ring * (x * x - y * y) - rubbed * (4.0 + nu) * x + added_x;
            let yy = ring * (y * y - x * x) - rubbed * 3.0 * nu * x + added_y;
            [xx, yy, 0.0, ring * 2.0 * x * y - rubbed * (2.0 - nu) * y, 0.0, 0.0]
        });
        let rim: Vec<Components> = rim.collect();
        let added = [added_x, added_y, 0.0, 0.0, 0.0, 0.0].map(|own| own * peak);
        let maxima = largest(&pressed, added);
        for (found, (_, measure)) in maxima.surface.iter().zip(MEASURES).take(3) {
            let known = rim.iter().map(measure).fold(f64::NEG_INFINITY, f64::max);
            if let Some(found) = found {
                within(*found, known, peak);
            }
        }
        assert!(maxima.surface[2].is_some());
    }
}

/// Under a flat punch stresses have no bound: what elements have says nothing about first yield.
#[test]
fn what_a_flat_punch_yields_by_is_not_known() {
    let steel = Material { young: 210e9, poisson: 0.3 };
    let punch = Body::new("punch", FlatEnd::new(1e-4).unwrap());
    let flat = Body::new("flat", Flat).material(steel);
    let pressed = Contact::between([punch, flat], Control::Load(10.0)).unwrap();
    let contact = pressed.frame([3e-4; 2], [36; 2]).solve().unwrap();
    let (maxima, _) = maxima(&contact, 1, 0.0);
    assert_eq!((maxima.surface[0], maxima.largest(0)), (None, None));
}

/// A cylinder that a frame cuts off: what is looked at lies in front of its sides at least four times as far as it is deep.
#[test]
fn stresses_next_to_sides_that_cut_pressures_are_left_out() {
    let profile = Cylinder::along_y(1e-2).unwrap();
    let solved = Contact::between(bodies(profile), Control::Load(90.0)).unwrap();
    let contact = solved.frame([3e-4, 1e-3], [48, 80]).solve().unwrap();
    let pressed = pressed(&contact, 0, |_, _| 0.0);
    let maxima = largest(&pressed, [0.0; 6]);
    let known = |[_, y]: [f64; 2], depth: f64| depth <= 0.25 * (5e-4 - y.abs()) + 1e-15;
    for layer in &maxima.layers {
        assert!(layer.largest.iter().all(|(_, place)| known(*place, layer.depth)), "{layer:?}");
    }
    let places = maxima.inside.map(|own| own.place);
    assert!(places.iter().all(|[x, y, z]| known([*x, *y], -z)), "{places:?}");
    assert!(pressed.check(&[1e-5, 1e-4]).is_ok());
    let error = pressed.check(&[1e-5, 2e-4]);
    assert!(matches!(error, Err(ElasticError::Deep { depth: 2e-4, .. })), "{error:?}");
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
        within(maxima.largest(0).unwrap(), yields, peak);
        if mu > 0.0 {
            within(maxima.surface[2].unwrap(), 2.0 * mu, peak);
        }
        for (found, (name, measure)) in maxima.inside.iter().zip(MEASURES) {
            let [x, _, z] = found.place;
            let known = measure(&sliding_line::stress([x / a, -z / a], mu, 0.3));
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

/// F. W. Carter's tractions (*Proc. R. Soc. A* 112 (1926) 151): where the stick zone ends, the stress along the surface has a cusp, and
/// there it is largest.
#[test]
fn where_stick_ends_errors_are_those_of_a_cusp() {
    let (a, radius, modulus) = (1e-4, 1e-2, 210e9 / 0.91 / 2.0);
    let load = PI * modulus * a * a / (4.0 * radius) * 1e-3;
    let peak = 2.0 * load / 1e-3 / (PI * a);
    let (mu, stick) = (0.3, 0.5);
    // The stick zone ends at x = 0 and reaches to the edge of the contact at x = 1.
    let within_stick = |x: f64| (x - stick) / stick;
    let known = |x: f64| -> Components {
        let within = [within_stick(x), 0.0];
        let [slid, pressed] = [1.0, 0.0].map(|mu| sliding_line::stress(within, mu, 0.3));
        let full = sliding_line::stress([x, 0.0], mu, 0.3);
        std::array::from_fn(|i| full[i] - mu * stick * (slid[i] - pressed[i]))
    };
    let known = (-999..1000).map(|step| von_mises(&known(f64::from(step) * 1e-3)));
    let known = known.fold(0.0, f64::max);
    for elements in [36, 48, 72, 96, 192] {
        let profile = Cylinder::along_y(radius).unwrap();
        let solved = Contact::between(bodies(profile), Control::Load(load)).unwrap();
        let contact = solved.line([3.0 * a, 1e-3], elements).solve().unwrap();
        let friction = |[x, _]: [f64; 2], pressure: f64| {
            let left = 1.0 - within_stick(x / a).powi(2);
            mu * (pressure - peak * stick * left.max(0.0).sqrt())
        };
        for (which, side) in [(0, 1.0), (1, -1.0)] {
            let pressed =
                pressed(&contact, which, |place, pressure| side * friction(place, pressure));
            within(largest(&pressed, [0.0; 6]).surface[0].unwrap(), known, peak);
        }
    }
}

/// A line of contact that passes with a tenth of friction, by Crossland and Dang Van along the paths of McEwen's field.
#[test]
fn a_point_that_is_passed_tires_as_its_path_says() {
    let (a, radius, modulus) = (1e-4, 1e-2, 210e9 / 0.91 / 2.0);
    let load = PI * modulus * a * a / (4.0 * radius) * 1e-3;
    let peak = 2.0 * load / 1e-3 / (PI * a);
    let profile = Cylinder::along_y(radius).unwrap();
    let solved = Contact::between(bodies(profile), Control::Load(load)).unwrap();
    let contact = solved.line([6.0 * a, 1e-3], 240).solve().unwrap();
    let pressed = pressed(&contact, 0, |_, pressure| 0.1 * pressure);
    let along = |depth: f64| -> Vec<Components> {
        let places = (-400..=400).map(|step| f64::from(step) * 2e-2);
        places.map(|x| sliding_line::stress([x, depth], 0.1, 0.3)).collect()
    };
    for criterion in [Criterion::Crossland(0.3), Criterion::DangVan(0.3)] {
        let found = pressed.fatigue(&criterion, (&pressed.depths(), &[0.0; 6]), 0).unwrap();
        let depths = (5..100).map(|step| f64::from(step) * 1e-2);
        let known = depths.map(|depth| criterion.of(&along(depth))).fold(0.0, f64::max);
        let (off, error) = ((found.value / peak - known).abs(), found.error / peak);
        assert!(off < error + 2e-3, "{}: {found:?} for {known}", criterion.name());
        assert!(error < 0.02, "{}: {found:?}", criterion.name());
    }
}

/// A wave of pressure on a body that repeats itself, pressed all over: on the surface it pulls most where the pressure is least, wherever the
/// frame begins; where nothing is pressed in places, nothing is said of the edges.
#[test]
fn waves_of_pressure_pull_in_their_troughs() {
    let (mean, wave, size) = (4e8, 3e8, 4e-4);
    let contact =
        Contact::between(bodies(Cylinder::along_y(1.0).unwrap()), Control::Load(1.0)).unwrap();
    let contact = contact.line([size, 1e-3], 64).solve().unwrap();
    let frame = &contact.problem().frame;
    let largest_of = |shift: f64, mean: f64| {
        let pressure = |pair: usize| {
            let angle = 2.0 * PI * (frame.place(pair)[0] / size + shift);
            (mean + wave * angle.cos()).max(0.0)
        };
        let none = vec![0.0; frame.len()];
        let n = (0..frame.len()).map(|pair| -pressure(pair)).collect();
        let tractions = VectorField { t1: none.clone(), t2: none, n };
        let bodies = contact.problem().bodies.each_ref();
        let pressed =
            PressedHalfSpace::in_contact(bodies, 1, frame, &tractions).unwrap().repeated(size);
        largest(&pressed, [0.0; 6])
    };
    let pulls = wave - 0.3 / 0.7 * mean;
    // The trough lies at a centre of an element, or between two, at the border of the frame or within.
    for shift in [0.0, 0.5, 0.25 + 1.0 / 128.0] {
        let found = largest_of(shift, mean).surface[2].unwrap();
        assert!((found.value / pulls - 1.0).abs() < 3e-3, "{shift}: {found:?} for {pulls}");
    }
    assert!(largest_of(0.0, 1e8).surface[2].is_none());
}
