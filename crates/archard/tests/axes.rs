//! Rollers and balls that creep as their axes and shapes say, against strips of Carter's (D. J. Haines & E. Ollerton, *Proc. IMechE* 177
//! (1963) 95) by a program of its own.

use std::sync::Arc;

use archard::body::Profile;
use archard::body::contact_modulus;
use archard::body::profile::{Disc, Flat, Paraboloid};
use archard::closed_form::Hertz;
use archard::compliance::{Compliance, HalfSpace};
use archard::frame::Direction;
use archard::friction::Coulomb;
use archard::motion::{Axis, Control, Drive, Rolling};
use archard::wear::Archard;
use archard::{Body, Contact, Material};

/// Steel of 206 GPa that wears by 1e-7 mm^3/(N m), with a friction of a tenth.
fn body(name: &str, profile: impl Profile + 'static) -> Body {
    let steel = Material::new(206e9, 0.3).unwrap();
    Body::new(name, profile).material(steel).wear(Archard::new(1e-16).unwrap())
}

/// A contact that rolls freely on a frame (m) of so many elements: power over speed (N), and depth a passage of body 2 (m) at places
/// across (m).
fn rolled(
    bodies: [Body; 2],
    load: f64,
    axes: [Axis; 2],
    (size, elements): ([f64; 2], [usize; 2]),
    places: &[f64],
) -> (f64, Vec<f64>) {
    let rolling = Rolling::along(Direction::X).longitudinal(Drive::Force(0.0)).about(axes);
    let line = bodies.iter().all(|body| body.curvatures().is_some_and(|both| both[1] == 0.0));
    let mut builder = Contact::rolling(bodies, rolling, Control::Load(load)).unwrap();
    builder.friction = Some(Arc::new(Coulomb::new(0.1).unwrap()));
    let builder = if line { builder.strips(size, elements) } else { builder.frame(size, elements) };
    let contact = builder.solve().unwrap();
    let problem = contact.problem();
    let drives = problem.motion.driven(0.0).unwrap();
    let power = contact.state().tangential.as_ref().unwrap().creep_power(problem, &drives);
    let worn = contact.passage().unwrap();
    let depth = |place: &f64| {
        let next = worn.iter().position(|line| line.place > *place).unwrap();
        let [low, high] = [&worn[next - 1], &worn[next]];
        let share = (place - low.place) / (high.place - low.place);
        low.depths[1] + share * (high.depths[1] - low.depths[1])
    };
    (power, places.iter().map(depth).collect())
}

fn near(found: f64, known: f64, within: f64) {
    assert!((found / known - 1.0).abs() < within, "{found} for {known}");
}

/// A crowned roller of a thrust bearing: the axis of its washer is normal to the contact, which spins.
#[test]
fn a_roller_on_a_washer_creeps_to_both_sides() {
    let bodies = [body("roller", Disc::crowned(5.5e-3, 2.0).unwrap()), body("washer", Flat)];
    let axes = [
        Axis { radius: 5.5e-3, tilt: 0.0 },
        Axis { radius: 38.75e-3, tilt: std::f64::consts::FRAC_PI_2 },
    ];
    let b = 4.08310e-3;
    let places = [-0.5 * b, 0.5 * b, 0.75 * b];
    let frame = ([0.3e-3, 9e-3], [60, 90]);
    let (power, depths) = rolled(bodies, 1000.0, axes, frame, &places);
    near(power, 3.95094, 3e-3);
    near(depths[0], 0.725806e-12, 1e-2);
    near(depths[1], 0.725806e-12, 1e-2);
    near(depths[2], 0.635081e-12, 1e-2);
}

/// A ball in the groove of an inner race: its middle rolls slower than its sides (Heathcote).
#[test]
fn a_ball_in_a_groove_creeps_as_its_shape_says() {
    let bodies = [
        body("ball", Paraboloid::new([5.5e-3; 2]).unwrap()),
        body("race", Paraboloid::new([20e-3, -5.72e-3]).unwrap()),
    ];
    let axes = [Axis { radius: 5.5e-3, tilt: 0.0 }, Axis { radius: 20e-3, tilt: 0.0 }];
    let b = 1.16921e-3;
    let places = [0.0, 0.1 * b, 0.2 * b, 0.5 * b, 0.75 * b, 0.9 * b];
    let frame = ([0.34e-3, 2.6e-3], [68, 104]);
    let (power, depths) = rolled(bodies, 500.0, axes, frame, &places);
    near(power, 0.223323, 2e-2);
    let known = [0.114042, 0.103930, 0.0730175, 0.0843899, 0.173129, 0.117804];
    // Strips know nothing of what their neighbours pull: where slip changes its direction, depths differ most.
    for (depth, known) in depths.into_iter().zip(known) {
        assert!((1e12 * depth - known).abs() < 2e-2 * 0.173129, "{depth} for {known}");
    }
}

/// A cylinder on a washer, each strip of which is one of Carter's: the creepage at a place y is y over the radius of the track. Away from
/// the middle all of a strip slips, and wears by k F' y/R a passage.
#[test]
fn a_cylinder_on_a_washer_is_strips_of_carters() {
    for (r, track, length, load) in [(5.5e-3, 38.75e-3, 11e-3, 1000.0), (4e-3, 30e-3, 8e-3, 600.0)]
    {
        let bodies = [body("roller", Disc::new(r).unwrap()), body("washer", Flat)];
        let axes = [
            Axis { radius: r, tilt: 0.0 },
            Axis { radius: track, tilt: std::f64::consts::FRAC_PI_2 },
        ];
        let (k, mu, modulus): (f64, f64, f64) = (1e-16, 0.1, 206e9 / (2.0 * (1.0 - 0.09)));
        let per_length = load / length;
        let half_width = (4.0 * per_length * r / (std::f64::consts::PI * modulus)).sqrt();
        let saturation = mu * half_width / r;
        // The creepage at the end of the line over that of full slip, below which a strip dissipates t^2 (2 - t).
        let most = 0.5 * length / track / saturation;
        let shared = 5.0 / 12.0 + 0.5 * (most * most - 1.0);
        let dissipated = 2.0 * mu * per_length * saturation * saturation * track * shared;
        let places = [-0.75, 0.25, 0.5, 0.75].map(|share: f64| share * 0.5 * length);
        let frame = ([4.0 * half_width, length], [64, 40]);
        let (power, depths) = rolled(bodies, load, axes, frame, &places);
        near(power, dissipated, 3e-3);
        for (depth, y) in depths.into_iter().zip(places) {
            near(depth, k * per_length * y.abs() / track, 1e-3);
        }
    }
}

/// Strips whose loads differ press on one another: what that moves them by is the difference of the half-spaces under the whole frame and of
/// those in plane strain, and the loads follow by what a strip yields to.
#[test]
fn strips_neglect_what_others_press_them_by() {
    let (r, length, strips) = (5.5e-3, 11e-3, 11);
    let contact = |load: f64| {
        let bodies = [body("roller", Disc::new(r).unwrap()), body("washer", Flat)];
        let rolling = Rolling::along(Direction::X).longitudinal(Drive::Force(0.0)).spin(25.0);
        let mut builder = Contact::rolling(bodies, rolling, Control::Load(load)).unwrap();
        builder.friction = Some(Arc::new(Coulomb::new(0.1).unwrap()));
        builder.strips([0.3e-3, length], [96, strips]).solve().unwrap()
    };
    let (own, more) = (contact(1000.0), contact(1010.0));
    let yields = (more.approach() - own.approach()) / (10.0 / length);
    let problem = own.problem();
    // A tenth more on one side, a tenth less on the other: straight in between.
    let middle = 0.5 * (strips - 1) as f64;
    let more = |pair: usize| 0.1 * ((pair / 96) as f64 - middle) / middle;
    let pressure: Vec<f64> =
        own.pressure().iter().enumerate().map(|(at, p)| (1.0 + more(at)) * p).collect();
    let apart: Vec<f64> = own.pressure().iter().enumerate().map(|(at, p)| more(at) * p).collect();
    let displaced = |compliance: &dyn Compliance| {
        let mut moved = vec![0.0; apart.len()];
        compliance.apply_normal(&apart, &mut moved);
        moved
    };
    let materials = problem.bodies.each_ref().map(|body| body.material.as_ref());
    let whole = displaced(&HalfSpace::new(materials, &problem.frame));
    let alone = displaced(&*problem.compliance);
    // In the middle of each strip, where the load acts.
    let off = (0..strips).map(|strip| {
        let at = 96 * strip + 48;
        0.5 * (whole[at] - alone[at] + whole[at - 1] - alone[at - 1]) / yields / (1000.0 / length)
    });
    let known = off.fold(0.0, |most: f64, one| most.max(one.abs()));
    let found = problem.strips_neglect(&pressure).unwrap();
    assert!(known > 0.01, "{known}");
    near(found, known, 0.05);
}

/// Where a ball that rolls on a flat slides all the way, a point slides the creepage times the chord of Hertz's contact, wherever elements
/// lie.
#[test]
fn points_slide_from_edge_to_edge() {
    let (radius, load, creepage) = (20e-3, 100.0, 0.05);
    let steel = Material::new(206e9, 0.3).unwrap();
    let modulus = contact_modulus([Some(&steel), Some(&steel)]);
    let a = Hertz::from_load([1.0 / radius; 2], modulus, load).unwrap().semi_axes[0];
    for (across, within) in [(16, 8e-3), (32, 4e-3)] {
        let element = 2.0 * a / f64::from(across);
        for size in [2.2, 2.25, 2.3, 2.35].map(|size| size * a) {
            let elements = (size / element) as usize;
            let bodies = [body("ball", Paraboloid::new([radius; 2]).unwrap()), body("flat", Flat)];
            let rolling = Rolling::along(Direction::X).longitudinal(Drive::Slip(creepage));
            let mut builder = Contact::rolling(bodies, rolling, Control::Load(load)).unwrap();
            builder.friction = Some(Arc::new(Coulomb::new(0.1).unwrap()));
            let contact = builder.frame([size; 2], [elements; 2]).solve().unwrap();
            for line in contact.passage().unwrap() {
                if line.place.abs() < 0.7 * a {
                    let chord = 2.0 * (a * a - line.place * line.place).sqrt();
                    near(line.slid, creepage * chord, within);
                }
            }
        }
    }
}
