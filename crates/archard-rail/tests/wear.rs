//! Wear over a route, against closed forms and against itself.

#[path = "wear/laws.rs"]
mod laws;

use std::f64::consts::TAU;
use std::ops::ControlFlow;
use std::sync::Arc;

use approx::assert_relative_eq;
use archard::friction::Coulomb;
use archard::wear::Archard;
use archard::{Material, wear::WearLaw};
use archard_rail::Profile;
use archard_rail::contact::{Bodies, Operation, Resolution, contact};
use archard_rail::curve::{Curve, Smoothing};
use archard_rail::setup::{Attitude, Setup, Side, Track, Velocity, Wheelset};
use archard_rail::standard::{rail_60e1, wheel_s1002};
use archard_rail::wear::{Cracks, Journey, Kept, OperatingPoint, Route, RouteResult, WearError};

/// Wear coefficient (1/Pa), friction, radius of the wheel (m) and speed (m/s).
const K: f64 = 1e-13;
const MU: f64 = 0.3;
const RADIUS: f64 = 0.46;
const SPEED: f64 = 20.0;

fn friction() -> Arc<Coulomb> {
    Arc::new(Coulomb::new(MU).unwrap())
}

fn bodies(wears: [bool; 2]) -> Bodies {
    let steel = Material::new(210e9, 0.28).unwrap();
    let law: Arc<dyn WearLaw> = Arc::new(Archard::new(K).unwrap());
    let wear = wears.map(|wears| wears.then(|| law.clone()));
    Bodies {
        wheel: steel,
        rail: steel,
        thermal: [None, None],
        friction: friction(),
        flange: None,
        wear,
        flange_wear: None,
        shear_yield: 800e6,
    }
}

fn point(shift: f64, yaw: f64, share: f64) -> OperatingPoint {
    OperatingPoint {
        attitude: Attitude { shift, roll: 0.0, yaw },
        rolls: false,
        velocity: Velocity { forward: SPEED, pitch: -SPEED / RADIUS, ..Velocity::default() },
        moment: None,
        load: 60e3,
        transfer: 0.0,
        creepages: Default::default(),
        friction: friction(),
        flange: None,
        share,
    }
}

fn wheelset() -> Wheelset {
    Wheelset { flange_back_distance: 1.36, flange_back_position: -0.07, nominal_radius: RADIUS }
}

fn s1002_on_60e1() -> Setup {
    let rail = rail_60e1(0.2e-3).unwrap().curve(Smoothing::NONE).unwrap();
    let wheel = wheel_s1002(0.2e-3).unwrap().curve(Smoothing::NONE).unwrap();
    Setup::new(Track::standard(), &rail, wheelset(), &wheel).unwrap()
}

/// A cylinder on a head of 0.3 m radius.
fn cylinder() -> Setup {
    let angles = (-400..=400).map(|at| f64::from(at) * 5e-4);
    let head = angles.map(|angle| [0.3 * angle.sin(), 0.3 - 0.3 * angle.cos()]).collect();
    let flat = (-60..=60).rev().map(|at| [f64::from(at) * 1e-3, 0.0]).collect();
    let [head, flat]: [Curve; 2] =
        [head, flat].map(|points| Profile::new(points).unwrap().curve(Smoothing::NONE).unwrap());
    let track = Track { gauge: 2.0 * (0.75 - 0.3 * 0.2f64.sin()), gauge_height: 1.0, cant: 0.0 };
    Setup::new(track, &head, wheelset(), &flat).unwrap()
}

fn journey(setup: Setup, wears: [bool; 2], points: Vec<OperatingPoint>, distance: f64) -> Journey {
    Journey {
        setup,
        sides: vec![Side::Right],
        bodies: bodies(wears),
        cracks: [None; 2],
        route: Route { points, distance, axles: 1e5 },
        // In the plane, where closed forms hold.
        resolution: Resolution { elements: 16, curved: false, ..Resolution::default() },
        tolerance: 0.02,
        smoothing: 2e-3,
        thinnings: vec![],
        amplitude: None,
    }
}

fn travelled(journey: &Journey) -> RouteResult {
    journey.travel(|_, _| ControlFlow::Continue(())).unwrap()
}

/// Area (m^2) between two profiles with the same ends: the polygon of one and back along the other.
fn between(one: &Profile, other: &Profile) -> f64 {
    let round: Vec<[f64; 2]> =
        one.points.iter().chain(other.points.iter().rev()).copied().collect();
    let cross = |at: usize| {
        let ([a, b], [c, d]) = (round[at], round[(at + 1) % round.len()]);
        a * d - b * c
    };
    0.5 * (0..round.len()).map(cross).sum::<f64>()
}

/// All of the patch slips by a tenth of what it rolls, so that a wheel loses k F s round its circumference, and a rail k F s
/// at each axle.
#[test]
fn a_cylinder_that_spins_loses_k_f_s() {
    let mut spinning = point(0.0, 0.0, 1.0);
    spinning.velocity.pitch *= 1.1;
    spinning.rolls = true;
    let done = travelled(&journey(cylinder(), [true; 2], vec![spinning], 1e3));
    let [worn] = &done.worn[..] else { panic!() };
    // Particles that enter the contact stick until they bear the limit, which takes 3e-4 of the way.
    let slid = 60e3 * K * 0.1;
    assert_relative_eq!(worn.wheel.volume(), slid * 1e3, max_relative = 1e-3);
    assert_relative_eq!(worn.wheel.area(), slid * 1e3 / (TAU * RADIUS), max_relative = 1e-3);
    assert_relative_eq!(worn.rail.volume(), slid * 1e5, max_relative = 1e-3);
    // As much lies between the profiles, which the spline of their points has to the fourth order.
    let lost = between(&worn.wheel.profile(), &worn.wheel.unworn()).abs();
    assert_relative_eq!(lost, worn.wheel.area(), max_relative = 1e-4);
    let lost = between(&worn.rail.profile(), &worn.rail.unworn()).abs();
    assert_relative_eq!(lost, worn.rail.area(), max_relative = 1e-4);
}

/// What is worn over a short way is the work of friction at each point times k over mu.
#[test]
fn a_route_loses_what_its_friction_works() {
    let setup = s1002_on_60e1();
    let points = vec![point(-2e-3, -1e-3, 0.25), point(1e-3, 1e-3, 0.65), point(6.5e-3, 4e-3, 0.1)];
    let journey = journey(setup.clone(), [true, false], points.clone(), 1.0);
    let mut work = 0.0;
    for point in &points {
        let roll = setup.roll(&setup, point.attitude.shift, point.attitude.yaw).unwrap();
        let attitude = Attitude { roll, ..point.attitude };
        let operation = Operation {
            attitude,
            velocity: point.velocity,
            load: point.load,
            transfer: 0.0,
            creepages: Default::default(),
        };
        let patches = contact(&setup, &journey.bodies, &operation, &journey.resolution).unwrap();
        let power: f64 = patches.iter().map(|patch| patch.values.frictional_power).sum();
        work += point.share * power / SPEED;
    }
    let done = travelled(&journey);
    // The height of the wheel is found to 1e-5 of the load, from another guess.
    assert_relative_eq!(done.worn[0].wheel.volume(), K / MU * work, max_relative = 3e-5);
    assert_eq!(done.worn[0].rail.volume(), 0.0);
}

/// A mirrored route wears the left wheel as the route wears the right one, and each follows its own contacts.
#[test]
fn left_is_right_in_a_mirror() {
    let mut points = vec![point(1e-3, 1e-3, 0.5), point(-3e-3, 0.0, 0.5)];
    // Half of the way is a curve.
    points[0].velocity.yaw = 0.04;
    let mirrored = points.iter().map(|point| {
        let attitude = Side::Left.attitude(point.attitude);
        let velocity = Side::Left.velocity(point.velocity);
        OperatingPoint { attitude, velocity, ..point.clone() }
    });
    let right = journey(s1002_on_60e1(), [true, false], points.clone(), 2e5);
    let left = Journey {
        sides: vec![Side::Left],
        route: Route { points: mirrored.collect(), ..right.route.clone() },
        ..right.clone()
    };
    let [right, left] = [&right, &left].map(|one| travelled(one).worn.remove(0).wheel);
    assert_relative_eq!(right.volume(), left.volume(), max_relative = 1e-9);
    for (one, other) in right.depths().iter().zip(left.depths()) {
        assert!((one - other).abs() < 1e-12, "{one} {other}");
    }
}

/// A point in ten parts, and twice the distance at half of the wear coefficient, make no difference.
#[test]
fn parts_of_a_point_add_up() {
    let whole = vec![point(1e-3, 1e-3, 0.5), point(-3e-3, 0.0, 0.5)];
    let mut parts: Vec<_> =
        (0..10).map(|_| OperatingPoint { share: 0.05, ..whole[0].clone() }).collect();
    parts.push(whole[1].clone());
    let whole = journey(s1002_on_60e1(), [true, false], whole, 2e5);
    let parts = journey(s1002_on_60e1(), [true, false], parts, 2e5);
    let mut far = whole.clone();
    far.route.distance *= 2.0;
    far.bodies.wear[0] = Some(Arc::new(Archard::new(0.5 * K).unwrap()));
    let [whole, parts, far] = [&whole, &parts, &far].map(|one| travelled(one).worn.remove(0).wheel);
    let deepest = whole.depths().into_iter().fold(0.0, f64::max);
    for other in [parts, far] {
        assert_relative_eq!(whole.volume(), other.volume(), max_relative = 1e-9);
        for (one, other) in whole.depths().iter().zip(other.depths()) {
            assert!((one - other).abs() < 1e-9 * deepest, "{one} {other}");
        }
    }
}

/// The stated error covers what half of the elements again, and steps of a quarter of the error, change.
#[test]
fn the_error_of_a_route_is_true() {
    let points = vec![point(1e-3, 1e-3, 0.5), point(-3e-3, 0.0, 0.3), point(5e-3, 4e-3, 0.2)];
    let coarse = journey(s1002_on_60e1(), [true, false], points, 4e5);
    let fine = Journey {
        resolution: Resolution { elements: 48, ..coarse.resolution },
        tolerance: coarse.tolerance / 8.0,
        ..coarse.clone()
    };
    let [coarse, fine] = [travelled(&coarse), travelled(&fine)];
    let deepest = |worn: &[archard_rail::wear::WornSide]| {
        worn[0].wheel.depths().into_iter().fold(0.0, f64::max)
    };
    let volume = |worn: &[archard_rail::wear::WornSide]| worn[0].wheel.volume();
    for value in [&deepest as &dyn Fn(&[_]) -> f64, &volume] {
        let (off, error) = ((value(&coarse.worn) - value(&fine.worn)).abs(), coarse.error(value));
        assert!(off <= error + fine.error(value), "{off} {error}");
        assert!(error < 0.2 * value(&fine.worn));
    }
}

#[test]
fn what_cannot_be_travelled_says_why() {
    let refused = |points: Vec<OperatingPoint>, wears, distance| {
        let journey = journey(s1002_on_60e1(), [wears, false], points, distance);
        journey.travel(|_, _| ControlFlow::Continue(())).unwrap_err().to_string()
    };
    let one = || vec![point(0.0, 0.0, 1.0)];
    assert!(refused(one(), false, 1.0).contains("neither the wheel nor the rail"));
    assert!(refused(vec![], true, 1.0).contains("a point or more"));
    assert!(refused(vec![point(0.0, 0.0, 0.7)], true, 1.0).contains("add up to 0.7"));
    assert!(
        refused(vec![point(0.0, 0.0, -1.0), point(0.0, 0.0, 2.0)], true, 1.0).contains("point 1")
    );
    assert!(refused(one(), true, f64::NAN).contains("finite"));
    let off = refused(vec![point(0.0, 0.0, 0.5), point(0.2, 0.0, 0.5)], true, 1.0);
    assert!(off.starts_with("point 2 of the route, after 0.0000 of the distance"), "{off}");
    let stopped = journey(s1002_on_60e1(), [true, false], one(), 1.0)
        .travel(|_, _| ControlFlow::Break(()))
        .unwrap_err();
    assert!(matches!(stopped, WearError::Stopped { progress: 0.0 }));
}

/// Damage that rises with the work of friction: a wheel has it once round its circumference and a rail at every axle, over the width of the
/// patch and nowhere else; work that heals takes off what is there, and leaves no credit.
#[test]
fn cracks_grow_at_every_passage() {
    let mut slides = point(0.0, 0.0, 1.0);
    slides.velocity.pitch *= 1.001;
    let peak = 1e6;
    let cracks = Cracks { threshold: 0.0, peak, balance: 2.0 * peak, most: 1e-3, heals: true };
    let distance = 1e3;
    let plain = journey(cylinder(), [true; 2], vec![slides.clone()], distance);
    let operation = Operation {
        attitude: slides.attitude,
        velocity: slides.velocity,
        load: slides.load,
        transfer: 0.0,
        creepages: Default::default(),
    };
    let patches = contact(&plain.setup, &plain.bodies, &operation, &plain.resolution).unwrap();
    let [patch] = &patches[..] else { panic!("{} patches", patches.len()) };
    let (work, errors) = (patch.values.t_gamma, patch.errors.t_gamma);
    assert_relative_eq!(work, -patch.values.force_x * patch.values.creepage, max_relative = 1e-9);
    let power = patch.values.frictional_power / SPEED;
    assert_relative_eq!(work, power, max_relative = 1e-2);
    let index = MU.min(patch.values.force_x.abs() / patch.values.normal_force)
        - plain.bodies.shear_yield / patch.values.peak_pressure;
    assert_relative_eq!(patch.values.surface_fatigue, index, epsilon = 1e-3);

    let cracked = Journey { cracks: [Some(cracks); 2], ..plain.clone() };
    let gone = travelled(&cracked);
    let passages = [distance / (TAU * RADIUS), 1e5];
    for (profile, passages) in gone.worn[0].profiles().into_iter().zip(passages) {
        let expected = 1e-3 * work / peak * passages;
        let most = profile.damage().iter().copied().fold(0.0, f64::max);
        let off = 1e-3 * errors / peak * passages + 2e-3 * expected;
        assert!((most - expected).abs() < off, "{most} {expected} {off}");
        let touched = profile.damage().iter().filter(|damage| **damage > 0.5 * most).count();
        let all = profile.damage().iter().filter(|damage| **damage > 0.0).count();
        // Nothing but what touches, as the patch widens.
        assert!(touched > 10 && all < touched + touched / 2, "{touched} {all}");
    }
    // Half of the axles crack, the others take more off.
    let slow = OperatingPoint { share: 0.5, ..point(0.0, 0.0, 0.5) };
    let fast = OperatingPoint { share: 0.5, ..slides };
    let balance = 0.5 * work;
    let heals = Cracks { threshold: 0.0, peak: 0.1 * balance, balance, most: 1e-3, heals: true };
    let healed = Journey {
        cracks: [None, Some(heals)],
        ..journey(cylinder(), [true; 2], vec![slow, fast], distance)
    };
    let healed = travelled(&healed);
    assert!(healed.worn[0].rail.damage().iter().all(|damage| *damage == 0.0));
    assert!(healed.worn[0].wheel.damage().iter().all(|damage| *damage == 0.0));
}

/// A route that is stopped at any of its steps, kept in bytes and gone on with comes to the same end, to the bit.
#[test]
fn a_route_goes_on_to_the_bit() {
    let points = vec![point(0.5e-3, 1e-3, 0.6), point(3e-3, 1.5e-3, 0.4)];
    let mut journey = journey(s1002_on_60e1(), [true, true], points, 2e6);
    journey.cracks = [Some(Cracks::R260); 2];
    journey.tolerance = 0.2;
    let whole = travelled(&journey);
    let mut kept = Kept::default();
    let stopped = loop {
        let mut steps = 0;
        // The step that was kept is shown again: each time it gets three farther.
        let stopped = journey.go_on(kept.clone(), |_, step| {
            steps += 1;
            kept = postcard::from_bytes(&postcard::to_allocvec(step.kept).unwrap()).unwrap();
            if steps == 4 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        });
        match stopped {
            Err(WearError::Stopped { .. }) => {}
            other => break other,
        }
    };
    assert_eq!(format!("{:?}", stopped.unwrap()), format!("{whole:?}"));
}
