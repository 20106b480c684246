//! Contacts that are solved once, against closed forms.

use std::f64::consts::PI;

use approx::assert_relative_eq;
use archard::body::Layer;
use archard::body::contact_modulus;
use archard::body::profile::{Flat, Sphere, Wave};
use archard::closed_form::Hertz;
use archard::closed_form::cattaneo_mindlin::PartialSlip;
use archard::friction::Coulomb;
use archard::motion::{Control, Drive, Sliding, Station, Stepping};
use archard::simulation::{Builder, Run};
use archard::wear::Archard;
use archard::{Body, Contact, Material, Simulation};

const RADIUS: f64 = 50e-3;
const LOAD: f64 = 10.2;

fn steel() -> Material {
    Material::new(210e9, 0.3).expect("a material")
}

fn ball_on_flat() -> [Body; 2] {
    let ball = Body::new("ball", Sphere::new(RADIUS).expect("a radius")).material(steel());
    [ball, Body::new("flat", Flat).material(steel())]
}

fn hertz() -> Hertz {
    let modulus = contact_modulus([Some(&steel()); 2]);
    Hertz::from_load([1.0 / RADIUS; 2], modulus, LOAD).expect("a contact")
}

fn solved(builder: Builder) -> Contact {
    builder.frame([0.36e-3; 2], [48; 2]).solve().expect("a contact")
}

/// By load or by approach, on a body or on one that has a layer of its own stuff.
#[test]
fn a_ball_on_a_flat_is_hertz_s() {
    let hertz = hertz();
    let layer = Layer::new(steel(), 20e-6).expect("a layer");
    let [ball, flat] = ball_on_flat();
    for bodies in [ball_on_flat(), [ball, flat.layers([layer])]] {
        for control in [Control::Load(LOAD), Control::Approach(hertz.approach)] {
            let contact = solved(Contact::between(bodies.clone(), control).expect("a control"));
            assert_relative_eq!(contact.load(), LOAD, max_relative = 1e-3);
            assert_relative_eq!(contact.approach(), hertz.approach, max_relative = 1e-3);
            assert_relative_eq!(contact.peak_pressure(), hertz.peak_pressure, max_relative = 3e-3);
            assert_relative_eq!(contact.area(), hertz.contact_area(), max_relative = 5e-3);
            let open = contact.gap().into_iter().zip(contact.pressure());
            assert!(
                open.clone()
                    .all(|(gap, pressure)| gap > -1e-12 && (gap < 1e-12 || *pressure == 0.0))
            );
            assert_eq!(contact.force(), [0.0; 2]);
        }
    }
}

/// Of a ball, the approach grows with F^(2/3), the pressure at r by 1 / (2 pi a (a^2 - r^2)^(1/2)) as that of a flat punch (Johnson, Contact
/// Mechanics, 5.4), and both as between two loads.
#[test]
fn derivatives_by_the_load_are_hertz_s() {
    let hertz = hertz();
    let at = |load: f64| {
        solved(Contact::between(ball_on_flat(), Control::Load(load)).expect("a control"))
    };
    let contact = at(LOAD);
    let by_load = contact.by_load().expect("it converges").expect("it is known");
    assert_relative_eq!(by_load.approach, hertz.approach / (1.5 * LOAD), max_relative = 5e-3);
    let a = hertz.semi_axes[0];
    let frame = &contact.problem().frame;
    assert_relative_eq!(frame.integrate(&by_load.pressure), 1.0, max_relative = 1e-9);
    for pair in 0..frame.len() {
        let [x, y] = frame.place(pair);
        let r = x.hypot(y);
        if r < 0.7 * a {
            let known = 1.0 / (2.0 * PI * a * (a * a - r * r).sqrt());
            assert_relative_eq!(by_load.pressure[pair], known, max_relative = 0.02);
        }
    }
    // Loads so near that no pair comes into contact.
    let [less, more] = [-1e-5, 1e-5].map(|part| at(LOAD * (1.0 + part)));
    let slope = (more.approach() - less.approach()) / (2e-5 * LOAD);
    assert_relative_eq!(by_load.approach, slope, max_relative = 1e-4);
    let known = by_load.pressure.iter().copied().fold(0.0, f64::max);
    let pairs = by_load.pressure.iter().zip(more.pressure().iter().zip(less.pressure()));
    for (own, (more, less)) in pairs {
        let slope = (more - less) / (2e-5 * LOAD);
        assert!((own - slope).abs() < 1e-3 * known, "{own} {slope}");
    }
}

/// Of a ball under a load, the approach falls with R^(-1/3) and the pressure on the axis with R^(-2/3), and both go on as between two
/// radii.
#[test]
fn derivatives_by_the_shape_are_hertz_s() {
    let hertz = hertz();
    let of = |profile: Sphere| {
        let [_, flat] = ball_on_flat();
        let ball = Body::new("ball", profile).material(steel());
        solved(Contact::between([ball, flat], Control::Load(LOAD)).expect("a control"))
    };
    let at = |radius: f64| of(Sphere::new(radius).expect("a radius"));
    let contact = at(RADIUS);
    let frame = &contact.problem().frame;
    let gap: Vec<f64> = (0..frame.len())
        .map(|pair| {
            let [x, y] = frame.place(pair);
            -(x * x + y * y) / (2.0 * RADIUS * RADIUS)
        })
        .collect();
    let by_radius = contact.by_shape(&gap).expect("it converges").expect("it is known");
    // Elements see the edge, and with it the curvature, to a hundredth.
    assert_relative_eq!(by_radius.approach, -hertz.approach / (3.0 * RADIUS), max_relative = 1e-2);
    assert!(frame.integrate(&by_radius.pressure).abs() < 1e-6 * LOAD / RADIUS);
    let a = hertz.semi_axes[0];
    for pair in 0..frame.len() {
        let [x, y] = frame.place(pair);
        let r = x.hypot(y) / a;
        if r < 0.7 {
            // p = p0 sqrt(1 - r^2 / a^2), of which p0 goes with R^(-2/3) and a with R^(1/3).
            let known = (1.0 - r * r).sqrt().recip() * (r * r - 2.0 * (1.0 - r * r));
            let known = hertz.peak_pressure * known / (3.0 * RADIUS);
            // As far as the approach is.
            let largest = hertz.peak_pressure / RADIUS;
            assert!((by_radius.pressure[pair] - known).abs() < 0.01 * largest);
        }
    }
    let step = 1e-5 * RADIUS;
    let [less, more] = [-step, step].map(|step| at(RADIUS + step));
    let slope = (more.approach() - less.approach()) / (2.0 * step);
    assert_relative_eq!(by_radius.approach, slope, max_relative = 1e-4);
    let largest = hertz.peak_pressure / RADIUS;
    for (own, (more, less)) in
        by_radius.pressure.iter().zip(more.pressure().iter().zip(less.pressure()))
    {
        let slope = (more - less) / (2.0 * step);
        assert!((own - slope).abs() < 1e-3 * largest, "{own} {slope}");
    }
    assert_eq!(
        contact.by_shape(&vec![0.0; frame.len()]).expect("it converges").expect("known").approach,
        0.0
    );
    // The same everywhere: bodies that are further apart than at their first touch, pressed as they were.
    let apart = contact.by_shape(&vec![1.0; frame.len()]).expect("it converges").expect("known");
    assert_relative_eq!(apart.approach, 1.0, max_relative = 1e-6);
    let scale = hertz.peak_pressure / hertz.approach;
    assert!(apart.pressure.iter().all(|own| own.abs() < 1e-5 * scale));
}

/// What a ball loses over the first micrometre of its way changes the pressure in a run as the derivative by the distance says.
#[test]
fn derivatives_by_wear_are_those_of_a_run() {
    let (k, distance) = (1e-13, 1e-6);
    let [ball, flat] = ball_on_flat();
    let ball = ball.wear(Archard::new(k).expect("a coefficient"));
    let motion = Sliding::new()
        .over(distance, Control::Load(LOAD), Stepping::Explicit(distance))
        .expect("a motion");
    let builder = Simulation::builder([ball, flat], motion).frame([0.36e-3; 2], [48; 2]);
    let mut run = Run::begin(builder.build().expect("a simulation")).expect("a contact");
    let unworn = run.report().state.pressure.clone();
    while run.step().expect("a step") {}
    let contact = solved(Contact::between(ball_on_flat(), Control::Load(LOAD)).expect("a control"));
    let lost: Vec<f64> = contact.pressure().iter().map(|pressure| k * pressure).collect();
    let by_wear = contact.by_shape(&lost).expect("it converges").expect("it is known");
    let most = by_wear.pressure.iter().map(|own| own.abs()).fold(0.0, f64::max);
    for (own, (worn, unworn)) in
        by_wear.pressure.iter().zip(run.report().state.pressure.iter().zip(&unworn))
    {
        let slope = (worn - unworn) / distance;
        assert!((own - slope).abs() < 1e-3 * most, "{own} {slope}");
    }
}

/// Summits that yield bear no more as the load grows.
#[test]
fn derivatives_are_not_known_where_pairs_yield() {
    let [ball, flat] = ball_on_flat();
    let soft = flat.hardness(150e6);
    let contact = solved(Contact::between([ball, soft], Control::Load(LOAD)).expect("a control"));
    assert_eq!(contact.by_load().expect("it converges"), None);
    let apart = vec![1.0; contact.pressure().len()];
    assert_eq!(contact.by_shape(&apart).expect("it converges"), None);
}

/// Waves that are pressed flat: p = mean + p* cos(2 pi x / length), with p* = pi E* 2 a / length (Johnson, Contact Mechanics, 13.2).
#[test]
fn waves_that_repeat_themselves_are_pressed_flat() {
    let (amplitude, length) = (0.1e-6, 1e-3);
    let wave = Wave::new(amplitude, [Some(length), None]).expect("a wave");
    let bodies =
        [Body::new("wave", wave).material(steel()), Body::new("flat", Flat).material(steel())];
    let most = std::f64::consts::PI * contact_modulus([Some(&steel()); 2]) * amplitude / length;
    let mean = 2.0 * most;
    let pressed = Contact::between(bodies, Control::Load(mean * length * length)).expect("a load");
    let contact = pressed.frame([length; 2], [32; 2]).periodic().solve().expect("a contact");
    for (pair, pressure) in contact.pressure().iter().enumerate() {
        let [x, _] = contact.problem().frame.place(pair);
        let expected = mean + most * (std::f64::consts::TAU * x / length).cos();
        assert_relative_eq!(*pressure, expected, max_relative = 1e-6);
    }
}

/// A shift or a force short of sliding, in one increment or in many: bodies of one elasticity do not ask for the way.
#[test]
fn a_ball_that_is_shifted_is_cattaneo_s() {
    let friction = 0.3;
    let theory = PartialSlip::new(RADIUS, [Some(&steel()); 2], LOAD, friction).expect("a contact");
    let shift = 0.5 * theory.sliding_shift;
    let force = theory.force(shift);
    for (drive, increments) in
        [(Drive::Slip(shift), 1), (Drive::Force(force), 1), (Drive::Slip(shift), 4)]
    {
        let station = Station::pressed(Control::Load(LOAD)).guided([drive, Drive::Slip(0.0)]);
        let shifted = Contact::shifted(ball_on_flat(), station, increments).expect("a station");
        let contact = solved(shifted.friction(Coulomb::new(friction).expect("a coefficient")));
        let tangential = contact.state().tangential.as_ref().expect("friction");
        // The theory leaves out what slips across the force.
        assert_relative_eq!(contact.force()[0], force, max_relative = 2e-3);
        assert_relative_eq!(tangential.shift[0], shift, max_relative = 2e-3);
        let stick = std::f64::consts::PI * theory.stick_radius(force).powi(2);
        let found = tangential.stick_area(contact.problem(), contact.pressure());
        assert_relative_eq!(found, stick, max_relative = 0.03);
    }
}

/// What is shifted has rubbed on the way, and is as unworn as what is pressed.
#[test]
fn a_contact_does_not_wear() {
    let wears = |body: Body| body.wear(Archard::new(1e-9).expect("a coefficient"));
    let station =
        Station::pressed(Control::Load(LOAD)).guided([Drive::Force(1.0), Drive::Slip(0.0)]);
    let shifted = Contact::shifted(ball_on_flat().map(wears), station, 4).expect("a station");
    let contact = solved(shifted.friction(Coulomb::new(0.3).expect("a coefficient")));
    assert!(contact.force()[0] > 0.99);
    assert_eq!(contact.state().total_worn().into_iter().fold(0.0, f64::max), 0.0);
}

#[test]
fn wrong_values_are_named() {
    let error = |control| Contact::between(ball_on_flat(), control).unwrap_err().parameter;
    assert_eq!(error(Control::Load(0.0)), "load");
    assert_eq!(error(Control::Approach(f64::NAN)), "approach");
    let far = Station::pressed(Control::Load(1.0)).guided([Drive::Slip(f64::INFINITY); 2]);
    assert!(Contact::shifted(ball_on_flat(), far, 1).is_err());
    let held = Station::pressed(Control::Load(1.0));
    assert!(Contact::shifted(ball_on_flat(), held, 0).is_err());
    let nowhere = Contact::between(ball_on_flat(), Control::Load(1.0)).expect("a load").solve();
    assert!(nowhere.unwrap_err().to_string().contains("frame"));
}
