//! A cylinder or a cone on a rail with a circular head, where everything has a closed form.

use approx::assert_abs_diff_eq as close;
use archard_rail::Profile;
use archard_rail::creepage::Creepage;
use archard_rail::curve::{Curve, Smoothing};
use archard_rail::search::{JOIN, Search};
use archard_rail::setup::{Attitude, Setup, Side, Track, Velocity, Wheelset};
use glam::DVec3;

/// Radius (m) of the head of the rail.
const HEAD: f64 = 0.3;
/// Radius (m) of the wheel at the middle of its profile.
const WHEEL: f64 = 0.46;
/// y (m) of the middle of the rail and of the wheel.
const ARM: f64 = 0.75;

/// The head of a rail: an arc of 0.2 rad to both sides, its points 0.15 mm apart.
fn head() -> Curve {
    let angles = (-400..=400).map(|at| f64::from(at) * 5e-4);
    let points = angles.map(|angle| [HEAD * angle.sin(), HEAD - HEAD * angle.cos()]);
    Profile::new(points.collect()).unwrap().curve(Smoothing::NONE).unwrap()
}

/// A straight profile that rises by the slope towards the field side.
fn cone(slope: f64) -> Curve {
    let points = (-60..=60).rev().map(|at| f64::from(at) * 1e-3).map(|y| [y, -slope * y]);
    Profile::new(points.collect()).unwrap().curve(Smoothing::NONE).unwrap()
}

fn setup(wheel: &Curve) -> Setup {
    // Within 1 m below its top the head is as wide as it is drawn.
    let gauge = 2.0 * (ARM - HEAD * 0.2f64.sin());
    let track = Track { gauge, gauge_height: 1.0, cant: 0.0 };
    let wheelset =
        Wheelset { flange_back_distance: 1.36, flange_back_position: -0.07, nominal_radius: WHEEL };
    Setup::new(track, &head(), wheelset, wheel).unwrap()
}

/// The overlap (m) in these tests.
const DEPTH: f64 = 20e-6;

#[test]
fn a_yawed_cylinder_overlaps_as_circles_do() {
    let setup = setup(&cone(0.0));
    for yaw in [0.0, 0.02, -0.05] {
        let search = Search::new(&setup, Attitude { shift: 1e-3, roll: 0.0, yaw }).unwrap();
        // What is left is the interpolation of the head: its spline is 1e-12 m off.
        close!(search.onset().unwrap().height, 0.0, epsilon = 1e-10);
        let patches = search.patches(DEPTH, JOIN).unwrap();
        let [patch] = &patches[..] else { panic!("{patches:?}") };
        let width = (2.0 * HEAD * DEPTH - DEPTH * DEPTH).sqrt();
        close!(patch.reference.x, -(ARM - 1e-3) * yaw.tan(), epsilon = 1e-7);
        close!(patch.reference.y, ARM, epsilon = 1e-8);
        close!(patch.angle, 0.0, epsilon = 1e-7);
        close!(patch.across[1], width, epsilon = 1e-7);
        close!(patch.across[0], -width, epsilon = 1e-7);
        close!(patch.depth, DEPTH, epsilon = 1e-9);
        let (along, across) = ([-4e-3, -1e-3, 0.0, 3e-3], [-3e-3, 0.0, 2e-3]);
        let gap = search.gap(patch).grid(&along, &across);
        for (at, gap) in gap.into_iter().enumerate() {
            let (x, s) = (along[at / 3], across[at % 3]);
            let [x, s] = [x + patch.reference.x, s + patch.reference.y - 1e-3];
            let u = x * yaw.cos() + s * yaw.sin();
            let s = s + 1e-3 - ARM;
            let circles =
                HEAD - (HEAD * HEAD - s * s).sqrt() + WHEEL - (WHEEL * WHEEL - u * u).sqrt();
            close!(gap, circles - DEPTH, epsilon = 1e-9);
        }
    }
}

#[test]
fn a_cone_touches_where_the_slopes_agree() {
    let slope = 0.1f64;
    let setup = setup(&cone(slope));
    for roll in [0.0, 0.01, -0.03] {
        let search = Search::new(&setup, Attitude { roll, ..Attitude::default() }).unwrap();
        let angle = roll - slope.atan();
        let onset = search.onset().unwrap();
        // The gap is flat at its least: the place is known to the root of what the height is known to.
        close!(onset.at.point.y, ARM + HEAD * angle.sin(), epsilon = 1e-6);
        let patches = search.patches(onset.height + DEPTH, JOIN).unwrap();
        let [patch] = &patches[..] else { panic!("{patches:?}") };
        // Overlap along the vertical leans to one side of the normal by a part of depth.
        close!(patch.angle, angle, epsilon = 1e-4);
        close!(patch.depth, DEPTH, epsilon = 1e-8);
    }
}

/// Under any attitude, the rail's circle less the gap has to lie on the cone: at its radius about the axle.
#[test]
fn the_gap_ends_on_the_cone() {
    let slope = 0.2;
    let setup = setup(&cone(slope));
    let attitude = Attitude { shift: -3e-3, roll: 0.02, yaw: -0.03 };
    let search = Search::new(&setup, attitude).unwrap();
    let height = search.onset().unwrap().height + DEPTH;
    let patch = search.patches(height, JOIN).unwrap().remove(0);
    let gap = search.gap(&patch);
    let across = [-4e-3, -1e-3, 0.0, 2e-3];
    for x in [-6e-3, 0.0, 5e-3] {
        for (s, gap) in across.into_iter().zip(gap.column(x, &across)) {
            // The middle of the rail's circle in the frame of the contact.
            let middle = patch.local(DVec3::new(patch.reference.x, ARM, HEAD));
            let rail = middle.z - (HEAD * HEAD - (s - middle.y).powi(2)).sqrt();
            let point = patch.reference + patch.frame() * DVec3::new(x, s, rail - gap);
            let own = search.in_wheel(point, height);
            close!(own.x.hypot(own.z + WHEEL), WHEEL - slope * own.y, epsilon = 1e-10);
        }
    }
}

#[test]
fn a_cylinder_creeps_as_a_driven_yawed_roller() {
    let setup = setup(&cone(0.0));
    let (yaw, driven, speed, rate) = (0.02f64, 0.003, 2.0, 0.5);
    let search = Search::new(&setup, Attitude { yaw, ..Attitude::default() }).unwrap();
    let patches = search.patches(DEPTH, JOIN).unwrap();
    let velocity =
        Velocity { forward: speed, pitch: -speed * (1.0 + driven) / WHEEL, ..Velocity::default() };
    let creepage = Creepage::new(&search, &patches[0], &velocity, DEPTH);
    let mean = speed * (1.0 + driven / 2.0);
    close!(creepage.speed, mean, epsilon = 1e-8);
    close!(
        creepage.longitudinal,
        (speed * (1.0 + driven) * yaw.cos() - speed) / mean,
        epsilon = 1e-8
    );
    close!(creepage.lateral, speed * (1.0 + driven) * yaw.sin() / mean, epsilon = 1e-8);
    close!(creepage.spin, 0.0, epsilon = 1e-6);
    let turning =
        Velocity { forward: speed, pitch: -speed / WHEEL, yaw: rate, ..Velocity::default() };
    let turned = Creepage::new(&search, &patches[0], &turning, DEPTH);
    close!(turned.spin * turned.speed, -rate, epsilon = 1e-6);
}

/// The left contact computed in the mirror is where the left wheel is in the track, and moves as its point does there.
#[test]
fn left_is_right_in_a_mirror() {
    let setup = setup(&cone(0.1));
    let attitude = Attitude { shift: 2e-3, roll: 0.01, yaw: 0.015 };
    let velocity =
        Velocity { forward: 2.0, lateral: 0.01, vertical: 0.0, roll: 0.02, yaw: 0.03, pitch: -4.3 };
    let seen = Side::Left.attitude(attitude);
    let search = Search::new(&setup, seen).unwrap();
    let height = search.onset().unwrap().height + DEPTH;
    let patch = search.patches(height, JOIN).unwrap().remove(0);
    let creepage = Creepage::new(&search, &patch, &Side::Left.velocity(velocity), 0.0);
    // The left wheel rises with a positive roll: the mirror shows it negative.
    close!(patch.angle, -attitude.roll - 0.1f64.atan(), epsilon = 1e-4);
    let contact = Side::Left.in_track(patch.reference);
    assert!(
        contact.y < -0.7 && contact.x > 0.0,
        "a wheelset turned to the right touches ahead on the left"
    );
    let arm = contact - setup.centre(&attitude, height);
    let moved = velocity.translation() + velocity.rotation(&attitude).cross(arm);
    close!(creepage.longitudinal, -moved.x / creepage.speed, epsilon = 1e-12);
    let along = Side::Left.in_track(patch.frame().y_axis);
    close!(creepage.lateral, -moved.dot(along) / creepage.speed, epsilon = 1e-12);
    assert_eq!(Side::Right.in_track(contact), contact);
    assert_eq!(Side::Left.velocity(Side::Left.velocity(velocity)), velocity);
}

/// Two bumps of the wheel (radius 100 mm, 8 mm apart) on a flat rail.
fn bumps() -> Setup {
    let depth = |y: f64| -((y.abs() - 4e-3).powi(2)) / 0.2;
    let points = (-150..=150).rev().map(|at| f64::from(at) * 1e-4).map(|y| [y, depth(y)]);
    let wheel = Profile::new(points.collect()).unwrap().curve(Smoothing::NONE).unwrap();
    setup(&wheel)
}

#[test]
fn patches_join_by_their_distance() {
    let setup = bumps();
    // Bumps on an arched rail are as deep as a wheel that leans against the slope: here 0, so they are equal.
    let search = Search::new(&setup, Attitude::default()).unwrap();
    let height = search.onset().unwrap().height + 5e-6;
    let find = |join: f64| search.patches(height, join).unwrap();
    let apart = find(0.0);
    assert_eq!(apart.len(), 2);
    let between = (apart[0].reference - apart[1].reference).length();
    let distance = between - apart[0].across[1] - apart[1].across[1];
    assert_eq!(find(distance * 0.98), apart);
    let joined = find(distance * 1.02);
    assert_eq!(joined.len(), 1);
    close!(joined[0].reference.y, ARM, epsilon = 1e-7);
}

/// Random wheels over random rails: an error, or patches with finite values.
#[test]
fn nothing_that_is_given_does_harm() {
    let mut found = 0;
    for seed in 0..500 {
        let mut random = fastrand::Rng::with_seed(seed);
        let mut any = |size: f64| match random.u8(..12) {
            0 => f64::NAN,
            1 => f64::INFINITY,
            2 => 0.0,
            _ => (2.0 * random.f64() - 1.0) * size,
        };
        let mut random = fastrand::Rng::with_seed(seed + 1000);
        let rough = [0.0, 1e-5, 1e-4, 2e-3][random.usize(..4)];
        let mut shape = |sign: f64| {
            let points = (-40..=40).map(|at| f64::from(at) * sign * 1e-3);
            let mut off = || rough * (random.f64() - 0.5);
            points.map(|y| [y + off(), sign * y * y / 0.6 + off()]).collect()
        };
        let (rail, wheel) = (shape(1.0), shape(-1.0));
        let curves = [Profile::new(rail), Profile::new(wheel)]
            .map(|profile| profile.and_then(|profile| profile.curve(Smoothing::NONE)));
        let [Ok(rail), Ok(wheel)] = curves else { continue };
        let wheelset = Wheelset {
            flange_back_distance: 1.36,
            flange_back_position: -0.07,
            nominal_radius: WHEEL,
        };
        let Ok(setup) = Setup::new(Track::standard(), &rail, wheelset, &wheel) else { continue };
        let attitude = Attitude { shift: any(0.02), roll: any(0.2), yaw: any(0.3) };
        let Ok(search) = Search::new(&setup, attitude) else { continue };
        let Some(onset) = search.onset() else { continue };
        let Ok(patches) = search.patches(onset.height + any(1e-3).abs(), JOIN) else {
            continue;
        };
        found += patches.len();
        for patch in &patches {
            assert!(patch.reference.is_finite() && patch.angle.is_finite(), "seed {seed}");
            let gaps = search.gap(patch).grid(&[-1e-3, 0.0, any(1.0)], &[0.0, 1e-3, any(1.0)]);
            assert!(gaps.iter().all(|gap| !gap.is_nan()), "seed {seed}");
            assert!(patch.local(DVec3::ZERO).is_finite());
        }
    }
    assert!(found > 100, "{found} patches");
}
