use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use approx::assert_relative_eq;
use archard::body::Material;
use archard::wear::{Archard, Power, WearLaw};

use super::super::{ANGLES, Cam, Follower, Lift, Loading, Profile, WornCam};
use super::{Limit, POINTS, Sweep};

const K: f64 = 1e-16;

fn cam_of(profile: Profile, follower: Follower, loading: Loading) -> Cam {
    let law: Arc<dyn WearLaw> = Arc::new(Archard::new(K).unwrap());
    let steel = Material::new(206e9, 0.3).unwrap();
    let laws = (None, [Some(law.clone()), Some(law)]);
    Cam::new((profile, follower), loading, 10e-3, [&steel; 2], laws).unwrap()
}

fn constant(load: f64) -> Loading {
    Loading::Spring { preload: load, stiffness: 0.0, mass: 0.0, speed: 0.0 }
}

fn eccentric(follower: Follower) -> Cam {
    let profile = Profile::Eccentric { radius: 20e-3, eccentricity: 4e-3 };
    cam_of(profile, follower, constant(1000.0))
}

/// What a place of a body loses a turn (m).
fn depth(cam: &Cam, body: usize, place: f64) -> f64 {
    let sweep = Sweep::new(cam, [ANGLES, POINTS]);
    K * sweep.passage(body, &sweep.places(body), place).work()
}

/// The depth at a node (rad, m) of what is worn, straight between nodes.
fn worn_at(worn: &WornCam, body: usize, node: f64) -> [f64; 2] {
    let nodes = &worn.nodes[body];
    let next = nodes.partition_point(|known| *known <= node).clamp(1, nodes.len() - 1);
    let share = (node - nodes[next - 1]) / (nodes[next] - nodes[next - 1]);
    [&worn.last().depths[body], &worn.errors[body]]
        .map(|of| of[next - 1] + share * (of[next] - of[next - 1]))
}

/// Closed forms of an eccentric circle of 20 mm, 4 mm off its axis, under 100 N/mm, and Hertz's pressure swept by adaptive quadrature
/// (QUADPACK) in a program of its own.
#[test]
fn an_eccentric_wears_what_closed_forms_say() {
    let cam = eccentric(Follower::Flat);
    let half_width = cam.station(0.0).half_width;
    assert_relative_eq!(1e3 * half_width, 0.149993, max_relative = 5e-6);
    let worn = cam.wear(1.0, &[]);
    for (angle, known) in [(0.0, 8.0), (0.5 * PI, 10.0), (PI, 12.0)] {
        let [depth, error] = worn_at(&worn, 0, angle);
        assert!((1e12 * depth - known).abs() < 1e-4 * known + 1e12 * error, "{depth} {known}");
        assert!(error < 1e-3 * depth, "{error} {depth}");
    }
    let known = [
        (0.0, 100.018),
        (2e-3, 115.524),
        (3.6e-3, 232.505),
        (4e-3 - half_width, 441.683),
        (4e-3 - 0.6 * half_width, 510.227),
        (4e-3 - 0.5 * half_width, 503.902),
        (4e-3, 407.411),
        (4e-3 + 0.5 * half_width, 232.860),
    ];
    for (place, known) in known {
        for place in [place, -place] {
            assert_relative_eq!(1e12 * depth(&cam, 1, place), known, max_relative = 5e-6);
            let [depth, error] = worn_at(&worn, 1, place);
            assert!((1e12 * depth - known).abs() < 2e-4 * known + 1e12 * error, "{depth} {known}");
            assert!(error < 1e-3 * depth, "{place}: {error} {depth}");
        }
    }
    let (_, [deepest, error]) = worn.deepest(1);
    assert!((1e12 * deepest - 511.22).abs() < 0.005 + 1e12 * error, "{deepest} {error}");
    assert!(error < 1e-3 * deepest);
    // Both lose 2 pi k q R a turn.
    for [volume, error] in worn.volumes {
        assert!((volume - TAU * K * 1000.0 * 20e-3).abs() <= error, "{volume} {error}");
        assert!(error < 1e-3 * volume, "{volume} {error}");
    }
}

/// Away from where the contact turns round each body loses k F' |v1 - v2|/v_i, whatever the follower, the lift and the load.
#[test]
fn each_body_wears_by_its_own_speed() {
    let height = 8e-3;
    let rows = (0..=360).map(|row| {
        let angle = TAU * f64::from(row) / 360.0;
        [angle, 0.25 * height * (1.0 - angle.cos()).powi(2)]
    });
    let lift = Profile::Lift { base_radius: 16e-3, lift: Lift::new(rows.collect()).unwrap() };
    let spring = || Loading::Spring { preload: 200.0, stiffness: 20e3, mass: 0.1, speed: 50.0 };
    for cam in [
        cam_of(lift.clone(), Follower::Flat, spring()),
        cam_of(lift, Follower::Round(12e-3), spring()),
        eccentric(Follower::Round(5e-3)),
    ] {
        let sweep = Sweep::new(&cam, [ANGLES, POINTS]);
        for step in 0..24 {
            let station = cam.station(TAU * (f64::from(step) + 0.3) / 24.0);
            let [one, two] = station.touch.speeds;
            let place = sweep.place(0, &station);
            let known = K * station.load * station.touch.sliding / one;
            assert_relative_eq!(depth(&cam, 0, place), known, max_relative = 1e-3);
            let touch = |angle: f64| cam.station(angle);
            // The follower is passed at other angles as well; here as often as the contact comes there.
            let mut sum = 0.0;
            let fine = 4_000;
            let mut slowest = f64::INFINITY;
            for at in 0..fine {
                let [here, next] =
                    [at, at + 1].map(|at| touch(TAU * f64::from(at) / f64::from(fine)));
                let [low, high] = [here.touch.place, next.touch.place];
                if (low - station.touch.place) * (high - station.touch.place) <= 0.0 && low != high
                {
                    let speed = here.touch.speeds[1].abs();
                    slowest = slowest.min(speed);
                    sum += K * here.load * here.touch.sliding / speed;
                }
            }
            // Smooth over the width of the contact.
            if slowest > 0.25 * one && two != 0.0 {
                assert_relative_eq!(depth(&cam, 1, station.touch.place), sum, max_relative = 5e-3);
            }
        }
        let worn = cam.wear(1.0, &[]);
        let way = sweep.stations.windows(2).map(|pair| {
            let mean = |of: fn(&super::Station) -> f64| 0.5 * (of(&pair[0]) + of(&pair[1]));
            mean(|one| one.load * one.touch.sliding) * (pair[1].angle - pair[0].angle)
        });
        let known = K * cam.width * way.sum::<f64>();
        for [volume, error] in worn.volumes {
            assert!((volume - known).abs() <= error + 1e-4 * known, "{volume} {error} {known}");
            assert!(error < 5e-3 * volume, "{volume} {error}");
        }
    }
}

/// Where the contact rests, the follower loses k 2/pi q/a times what the cam slides there, and the cam nothing more than elsewhere.
#[test]
fn a_dwell_is_one_place_of_the_follower() {
    // Half of a turn without lift; a smooth one over the rest.
    let rows = (0..=720).map(|row| {
        let angle = TAU * f64::from(row) / 720.0;
        let part = (angle / PI).min(1.0);
        [angle, 2e-3 * (PI * part).sin().powi(4)]
    });
    let lift = Lift::new(rows.collect()).unwrap();
    let cam = cam_of(Profile::Lift { base_radius: 20e-3, lift }, Follower::Flat, constant(1000.0));
    let worn = cam.wear(1.0, &[]);
    let station = cam.station(1.5 * PI);
    let resting = K * station.peak_pressure * PI * 20e-3;
    let [depth, _] = worn_at(&worn, 1, 0.0);
    // Besides, it is passed as the lift begins, is highest, and ends.
    assert!(depth > resting && depth < 1.2 * resting, "{depth} {resting}");
    let [depth, error] = worn_at(&worn, 0, 1.5 * PI);
    assert_relative_eq!(depth, K * 100e3, max_relative = 1e-4);
    // The follower has a groove there which the cam is pressed into.
    assert!(error < 1e-2 * depth);
}

/// A spline through rounded lifts knows its second derivative badly, and the errors hold what comes of that.
#[test]
#[ignore = "long: in .ci/long"]
fn rounded_lifts_are_in_the_errors() {
    let exact = eccentric(Follower::Flat).wear(1.0, &[]);
    for (degrees, digits) in [(5, 12), (1, 7), (1, 6)] {
        let ten = 10f64.powi(digits);
        let rows = (0..=360 / degrees).map(|row| {
            let angle = f64::from(row * degrees).to_radians();
            [angle, (4e-3 * (1.0 - angle.cos()) * ten).round() / ten]
        });
        let lift = Lift::new(rows.collect()).unwrap();
        let cam =
            cam_of(Profile::Lift { base_radius: 16e-3, lift }, Follower::Flat, constant(1000.0));
        let worn = cam.wear(1.0, &[]);
        for body in 0..2 {
            let count = worn.nodes[body].len();
            let held = (0..count).filter(|&node| {
                let [known, _] = worn_at(&exact, body, worn.nodes[body][node]);
                let off = (worn.last().depths[body][node] - known).abs();
                off <= 3.0 * worn.errors[body][node] + 2e-4 * known
            });
            // Noise is off by chance; most of it is held.
            let held = held.count() as f64 / count as f64;
            assert!(held > 0.9, "{degrees} {digits} {body}: {held}");
        }
    }
}

/// Lives are those of a depth in proportion to turns; a spring of bodies that wear is softer, and the error says so.
#[test]
fn a_life_ends_where_the_depth_is_reached() {
    let mut cam = eccentric(Follower::Flat);
    cam.laws[1] = None;
    let worn = cam.wear(1e7, &[Limit { body: 0, depth: 12e-6 }]);
    let (limit, error) = worn.life.unwrap();
    assert_eq!(limit.body, 0);
    assert!((worn.last().passages - 1e6).abs() <= error, "{} {error}", worn.last().passages);
    assert!(error < 1e-2 * 1e6, "{error}");
    assert!(worn.last().depths[1].iter().all(|depth| *depth == 0.0));
    assert_eq!(cam.wear(1e5, &[Limit { body: 0, depth: 12e-6 }]).life, None);
    // Followers whose ends are deeper than the contact is do not wear as new ones.
    let both = eccentric(Follower::Flat).wear(1e4, &[]);
    assert!(both.changed[1] > 1.0 && both.changed[0] < 0.2, "{:?}", both.changed);
}

/// A power of the pressure wears by the integral of Hertz's pressure squared: K p0^2 4/3 a |v1 - v2|/v.
#[test]
fn other_laws_see_the_pressure_across_the_contact() {
    let mut cam = eccentric(Follower::Flat);
    cam.laws[0] = Some(Arc::new(Power::new(1e-25, 2.0, 1.0).unwrap()));
    let worn = cam.wear(1.0, &[]);
    for angle in [0.3, 2.0, 4.0] {
        let station = cam.station(angle);
        let width = 4.0 / 3.0 * station.half_width * station.touch.sliding;
        let known = 1e-25 * station.peak_pressure.powi(2) * width / station.touch.speeds[0];
        let [depth, error] = worn_at(&worn, 0, angle);
        assert!((depth - known).abs() < 1e-4 * known + error, "{depth} {known}");
    }
}

#[test]
fn cams_that_do_not_touch_along_a_line_are_refused() {
    let steel = Material::new(206e9, 0.3).unwrap();
    let refused = |profile: &Profile, follower, loading: Loading| {
        let cam =
            Cam::new((profile.clone(), follower), loading, 1e-2, [&steel; 2], (None, [None, None]));
        cam.unwrap_err().to_string()
    };
    let rows = (0..=360).map(|row| {
        let angle = TAU * f64::from(row) / 360.0;
        [angle, 2e-3 * (1.0 - angle.cos()).powi(4) / 16.0]
    });
    let pointed = Profile::Lift { base_radius: 1e-3, lift: Lift::new(rows.collect()).unwrap() };
    let flat = refused(&pointed, Follower::Flat, constant(1.0));
    assert!(flat.contains("not convex at "), "{flat}");
    let round = refused(&pointed, Follower::Round(12e-3), constant(1.0));
    assert!(round.contains("undercut at "), "{round}");
    let circle = Profile::Eccentric { radius: 20e-3, eccentricity: 4e-3 };
    let fast = Loading::Spring { preload: 100.0, stiffness: 0.0, mass: 1.0, speed: 200.0 };
    let lifts = refused(&circle, Follower::Flat, fast);
    assert!(lifts.contains("lifts off at 1") && lifts.contains("preload"), "{lifts}");
}
