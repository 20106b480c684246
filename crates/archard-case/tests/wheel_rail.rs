//! Cases of a wheel on a rail: read, printed, refused with a place, and solved on both sides of the track.

#[path = "wheel_rail/service.rs"]
mod service;

use std::fs;
use std::ops::ControlFlow;

use archard_case::output::{AtPoint, Claim, RailResults, Totals, write_rail};
use archard_case::verdict::{self, Verdict, Word};
use archard_case::{CaseFile, ResolvedWheelRail, Task};
use archard_rail::contact::Quantities;
use tempfile::tempdir;

const MANCHESTER: &str = include_str!("../../../cases/manchester/case.toml");

fn resolve(text: &str, options: &[&str]) -> Result<Box<ResolvedWheelRail>, String> {
    let file = CaseFile::from_text("case.toml", text, "");
    let file = options.iter().fold(file, |file, option| file.set(*option));
    match file.task() {
        Ok(Task::WheelRail(resolved)) => Ok(resolved),
        Ok(_) => Err("another case".to_owned()),
        Err(problems) => {
            Err(problems.iter().map(|one| file.describe(one)).collect::<Vec<_>>().join("\n"))
        }
    }
}

fn solved(options: &[&str]) -> Vec<f64> {
    let resolved = resolve(MANCHESTER, options).expect("a case");
    let contacts =
        resolved.case.solve(|_, _| ControlFlow::Continue(())).expect("a contact").contacts;
    let [contact] = &contacts[..] else { panic!("{} wheels", contacts.len()) };
    assert!(contact.off() < 1e-5, "{}", contact.off());
    let [patch] = &contact.patches[..] else { panic!("{} patches", contact.patches.len()) };
    patch.values.values()
}

/// Every error that is stated of a wheel belongs to the verdict, creepages relative to all slip of the patch.
#[test]
fn errors_of_creepages_are_judged() {
    let resolved = resolve(MANCHESTER, &[]).expect("a case");
    let results = resolved.case.solve(|_, _| ControlFlow::Continue(())).expect("a contact");
    // What is made of the errors of a patch with so much slip.
    type Change<'a> = &'a dyn Fn(&mut Quantities, f64);
    let judged = |change: Change<'_>| {
        let mut results = results.clone();
        let patch = &mut results.contacts[0].patches[0];
        let Quantities { creepage, lateral_creepage, spin, contact_area, .. } = patch.values;
        let radius = (contact_area / std::f64::consts::PI).sqrt();
        let slip = creepage.hypot(lateral_creepage).hypot(radius * spin);
        change(&mut patch.errors, slip);
        let dir = tempdir().unwrap();
        let mut claim = Claim::take(dir.path()).unwrap();
        write_rail(&mut claim, "", &results, &Totals::default()).unwrap()
    };
    assert_eq!(judged(&|_, _| {}).word(), Word::Good);
    let changes: [(&str, Change<'_>); 3] = [
        ("`creepage`", &|errors, slip| errors.creepage = 0.2 * slip),
        ("`lateral_creepage`", &|errors, slip| errors.lateral_creepage = 0.2 * slip),
        ("`spin_1_per_m`", &|errors, slip| errors.spin = 100.0 * slip),
    ];
    for (column, change) in changes {
        let verdict = judged(change);
        assert_eq!(verdict.word(), Word::Doubtful, "{column}");
        let line = verdict.complaints().next().unwrap().to_string();
        assert!(line.contains(column), "{line}");
    }
}

/// A case prints as one that reads back to the same.
#[test]
fn a_case_reads_back() {
    let options = ["frame.elements=16", "motion.wheel_rail.join=4 mm", "title=a wheel"];
    let first = resolve(MANCHESTER, &options).expect("a case").case;
    let again = resolve(&first.to_string(), &[]).expect("what was printed").case;
    assert_eq!(first, again);
}

/// The left wheel of a wheelset that stands the other way is the right one in a mirror.
#[test]
fn left_is_right_in_a_mirror() {
    let turned = |sign: f64, side: &str| {
        let options = [
            format!("motion.wheel_rail.shift={} mm", 3.0 * sign),
            format!("motion.wheel_rail.yaw={} mrad", 7.2 * sign),
            format!("motion.wheel_rail.roll={} mrad", -0.1803 * sign),
            format!("motion.wheel_rail.side={side}"),
        ];
        solved(&options.each_ref().map(String::as_str))
    };
    assert_eq!(turned(1.0, "right"), turned(-1.0, "left"));
}

/// A roll that is not given brings both wheels onto their rails at one height: at first touch, then under their load.
#[test]
fn the_roll_is_found_from_both_wheels() {
    for shift in ["0 mm", "3 mm", "6 mm"] {
        let shift = format!("motion.wheel_rail.shift={shift}");
        let both = ["motion.wheel_rail.side=both", "motion.wheel_rail.roll=", &shift];
        let forecast = resolve(MANCHESTER, &both).expect("a case").forecast;
        let [(_, left), (_, right)] = &forecast.sides[..] else { panic!("one side") };
        assert!((left.height - right.height).abs() < 1e-7, "{} {}", left.height, right.height);
        let contacts = resolve(MANCHESTER, &both).expect("a case").case;
        let contacts = contacts.solve(|_, _| ControlFlow::Continue(())).expect("contacts").contacts;
        let [left, right] = &contacts[..] else { panic!("one side") };
        let [left, right] = [left, right].map(|one| one.patches[0].values.z_wheel);
        assert!((left - right).abs() < 1e-8, "{left} {right}");
    }
}

/// Pure rolling at the nominal radius needs no rate; another rate drives the wheel.
#[test]
fn a_wheel_rolls_by_itself() {
    let given = solved(&["motion.wheel_rail.pitch_rate=-4.34782608695652 rad/s"]);
    let left_out = solved(&["motion.wheel_rail.pitch_rate="]);
    for (one, other) in given.iter().zip(&left_out) {
        assert!((one - other).abs() <= 1e-8 * one.abs(), "{one} {other}");
    }
}

#[test]
fn wrong_cases_are_refused_in_words() {
    let wheel = "body.wheel.profile.wheel";
    let rail = "body.rail.profile.rail";
    let dir = tempdir().unwrap();
    let file = |name: &str, text: &str| {
        let path = dir.path().join(name);
        fs::write(&path, text).unwrap();
        path.display().to_string()
    };
    let short = file("short.csv", "0,0\n1,x\n2,0\n");
    let odd = file("odd.xyz", "0 0\n");
    for (options, expected) in [
        (vec!["motion.wheel_rail.shift=120 mm".to_owned()], "not over"),
        (vec!["motion.wheel_rail.yaw=1 rad".to_owned()], "`motion.wheel_rail.yaw`"),
        (vec!["motion.wheel_rail.wheel_load=-1 N".to_owned()], "`motion.wheel_rail.wheel_load`"),
        (vec!["motion.wheel_rail.speed=".to_owned()], "speed along the track"),
        (vec!["friction=".to_owned()], "a friction law"),
        (vec![format!("{rail}.cant=steep")], "`steep` is no inclination"),
        (vec![format!("{rail}.file=none.prr")], "none.prr"),
        (vec![format!("{rail}.standard="), format!("{rail}.file={short}")], "line 2"),
        (vec![format!("{wheel}.standard="), format!("{wheel}.file={odd}")], "no known ending"),
        (vec![format!("{wheel}.standard=")], "one of `file` and `standard`"),
        (vec![format!("{wheel}.radius=460")], "unit"),
        (vec!["body.wheel.material.young=210 GPa".to_owned()], "exclude each other"),
        (vec!["body.third.profile.flat={}".to_owned()], "neither wheel nor rail"),
        (vec!["frame.elements=7".to_owned()], "a multiple of 4 from 16"),
        (vec!["frame.elements=18".to_owned()], "a multiple of 4 from 16"),
        (vec!["accuracy=0.01".to_owned()], "is not a known key"),
        (vec![format!("{wheel}.radius=1 mm")], "`body.wheel.profile.wheel.radius`"),
    ] {
        let options: Vec<&str> = options.iter().map(String::as_str).collect();
        let said = resolve(MANCHESTER, &options).err();
        let said = said.unwrap_or_else(|| panic!("{options:?} passes"));
        assert!(said.contains(expected), "{options:?}: {said}");
    }
}

/// What looks wrong in a file is a warning with its line: here a wheel whose points run the other way.
#[test]
fn oddities_of_files_are_told() {
    let dir = tempdir().unwrap();
    let path = dir.path().join("wheel.csv");
    let rows: Vec<String> =
        (-60..=60).map(|y| format!("{y},{}", 0.002 * f64::from(y * y))).collect();
    fs::write(&path, rows.join("\n")).unwrap();
    let file = format!("body.wheel.profile.wheel.file={}", path.display());
    let said = match resolve(MANCHESTER, &["body.wheel.profile.wheel.standard=", &file]) {
        Ok(resolved) => resolved.warnings.iter().map(|one| one.title()).collect::<String>(),
        Err(said) => said,
    };
    assert!(said.contains("wheel.file"), "{said}");
}

/// A wheel of 130 mm in inches is 5.1 "mm" wide: it is refused with the unit, and read where the unit is stated.
#[test]
fn profiles_in_another_unit_are_refused() {
    let dir = tempdir().unwrap();
    let path = dir.path().join("wheel.csv");
    let wheel = archard_rail::standard::wheel_s1002(1e-3).unwrap();
    let rows = wheel.points.iter().map(|[y, z]| format!("{:.6},{:.6}", y / 0.0254, z / 0.0254));
    fs::write(&path, format!("y,z\n{}\n", rows.collect::<Vec<_>>().join("\n"))).unwrap();
    let file = format!("body.wheel.profile.wheel.file={}", path.display());
    let options = ["body.wheel.profile.wheel.standard=", &file];
    let said = resolve(MANCHESTER, &options).expect_err("inches");
    assert!(said.contains("inches read as millimetres") && said.contains("unit"), "{said}");
    let unit = "body.wheel.profile.wheel.unit=25.4 mm";
    resolve(MANCHESTER, &[&options[..], &[unit]].concat()).expect("a wheel");
}

/// The contact and the verdict of a wheel in that file, on the rail of its standard.
fn judged_wheel(points: &[[f64; 2]], more: &[&str]) -> (Quantities, Quantities, Verdict) {
    let dir = tempdir().unwrap();
    let path = dir.path().join("wheel.csv");
    let rows = points.iter().map(|[y, z]| format!("{:.7},{:.7}", 1e3 * y, 1e3 * z));
    fs::write(&path, rows.collect::<Vec<_>>().join("\n")).unwrap();
    let file = format!("body.wheel.profile.wheel.file={}", path.display());
    let options = ["body.wheel.profile.wheel.standard=", &file];
    let resolved = resolve(MANCHESTER, &[&options[..], more].concat()).expect("a case");
    let results = resolved.case.solve(|_, _| ControlFlow::Continue(())).expect("a contact");
    let patch = results.contacts[0].patches[0].clone();
    let totals = Totals {
        warnings: resolved.warnings.iter().map(archard_case::Problem::warning_of).collect(),
        ..Totals::default()
    };
    (patch.values, patch.errors, verdict_of(&results, &totals))
}

fn verdict_of(results: &RailResults, totals: &Totals) -> Verdict {
    let dir = tempdir().unwrap();
    let mut claim = Claim::take(dir.path()).unwrap();
    write_rail(&mut claim, "", results, totals).unwrap()
}

/// Noise of 10 um from point to point, smoothed a little or well: pressure, area and force lie within their stated errors about those of
/// the profile without noise, and what is smoothed too little is doubtful.
#[test]
fn errors_cover_the_noise_of_a_measured_profile() {
    let clean = archard_rail::standard::wheel_s1002(0.35e-3).unwrap().points;
    let (truth, none, _) = judged_wheel(&clean, &[]);
    assert!(none.peak_pressure < 0.01 * truth.peak_pressure, "{}", none.peak_pressure);
    let mut outside = 0;
    for seed in 1..=6_u64 {
        // A sum of twelve has a variance of one.
        let mut state = seed;
        let mut one = || {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        let mut noise = || (0..12).map(|_| one()).sum::<f64>() - 6.0;
        let noisy: Vec<_> = clean.iter().map(|[y, z]| [*y, z + 1e-5 * noise()]).collect();
        for smoothing in ["3 mm", "8 mm"] {
            let smoothed = format!("body.wheel.profile.wheel.smoothing={smoothing}");
            let (values, errors, verdict) = judged_wheel(&noisy, &[&smoothed]);
            let off = [
                (values.peak_pressure - truth.peak_pressure) / errors.peak_pressure,
                (values.contact_area - truth.contact_area) / errors.contact_area,
                (values.force_x - truth.force_x) / errors.force_x,
            ];
            outside += off.iter().filter(|off| off.abs() > 1.0).count();
            if smoothing == "3 mm" {
                assert_ne!(verdict.word(), Word::Good, "{:?}", verdict.lines);
            }
        }
    }
    // One in twenty by chance: of 36 more than five once in a hundred.
    assert!(outside <= 5, "{outside} of 36");
}

/// What is wrong with a set-up is never good: a profile upside down, a flange 85 mm from the back of its wheel, a contact that bears twice
/// its load, a pressure above the shakedown limit, a wheel that slides.
#[test]
fn a_wrong_set_up_is_not_good() {
    let clean = archard_rail::standard::wheel_s1002(0.35e-3).unwrap().points;
    let (_, _, verdict) = judged_wheel(&clean, &[]);
    assert_eq!(verdict.word(), Word::Good, "{:?}", verdict.lines);
    let turned: Vec<_> = clean.iter().map(|[y, z]| [*y, -z]).collect();
    assert_eq!(judged_wheel(&turned, &[]).2.word(), Word::Doubtful);
    let said = resolve(MANCHESTER, &["motion.wheel_rail.flange_back_position=-140 mm"]);
    let said = said.expect_err("a thick flange");
    assert!(
        said.contains("85.0 mm from the back") && said.contains("flange_back_position"),
        "{said}"
    );
    let words = |options: &[&str], change: &dyn Fn(&mut RailResults)| {
        let case = resolve(MANCHESTER, options).expect("a case").case;
        let mut results = case.solve(|_, _| ControlFlow::Continue(())).expect("a contact");
        change(&mut results);
        let verdict = verdict_of(&results, &Totals::default());
        let subjects = verdict.complaints().map(|line| line.subject).collect::<Vec<_>>();
        (verdict.word(), subjects)
    };
    let twice = |results: &mut RailResults| results.contacts[0].load *= 0.5;
    assert_eq!(words(&[], &twice), (Word::Wrong, vec!["load"]));
    // 720 MPa on k = 600 MPa/(3 sqrt 3): 6.2 k; on k = 1 GPa/(3 sqrt 3) 3.7 k, with 0.30 of friction used.
    let soft =
        |hardness: &str| words(&[&*format!("body.rail.material.hardness={hardness}")], &|_| {});
    assert_eq!(soft("800 MPa"), (Word::Doubtful, vec!["shakedown"]));
    assert_eq!(soft("1 GPa"), (Word::Doubtful, vec!["shakedown"]));
    assert_eq!(soft("1.3 GPa"), (Word::Good, vec![]));
    let braked = words(&["motion.wheel_rail.pitch_rate=-3.4 rad/s"], &|_| {});
    assert_eq!(braked, (Word::Doubtful, vec!["creepage"]));
}

/// A lubricated flange has its own friction and the tread keeps that of the law: each patch is that of a wheel with one friction all over.
#[test]
fn a_flange_may_be_lubricated() {
    let forces = |shift: &str, options: &[&str]| {
        let shift = format!("motion.wheel_rail.shift={shift}");
        solved(&[&[&*shift, "motion.wheel_rail.roll=0 rad"], options].concat())
    };
    let lubricated =
        ["motion.wheel_rail.flange_friction=0.1", "motion.wheel_rail.flange_from=-32 mm"];
    let slippery = ["friction.coulomb.coefficient=0.1"];
    assert_eq!(forces("0 mm", &lubricated), forces("0 mm", &[]));
    assert_eq!(forces("7 mm", &lubricated), forces("7 mm", &slippery));
    assert_ne!(forces("7 mm", &lubricated), forces("7 mm", &[]));
    let said = resolve(MANCHESTER, &lubricated[..1]).expect_err("half of a zone");
    assert!(
        said.contains("motion.wheel_rail.flange_from") && said.contains("is missing"),
        "{said}"
    );
    let text = "share,shift [mm],flange_friction\n0.5,0,0.1\n0.5,7,0.2\n";
    let case = with_route(text, &lubricated[1..]).expect("a case").case;
    let results = case.solve(|_, _| ControlFlow::Continue(())).expect("contacts");
    let used = |at: usize| {
        let patch = &results.contacts[at].patches[0].values;
        patch.force_x.hypot(patch.force_s) / patch.normal_force
    };
    assert!(used(1) < 0.2 && used(1) > 0.15 && used(0) > 0.2, "{} {}", used(0), used(1));
}

/// With 0.3 of friction used at 4 k the surface index of shakedown, f - k/p, is 0.05; without friction 4 k is the limit.
#[test]
fn shakedown_is_that_of_its_formulas() {
    let hardness = 3.0 * 3.0_f64.sqrt();
    for (over_k, friction, index) in [(4.0, 0.3, 0.05), (5.0, 0.2, 0.0), (2.5, 0.35, -0.05)] {
        let over = verdict::shaken(over_k / hardness, friction);
        let surface = friction * over_k;
        assert!((friction - 1.0 / over_k - index).abs() < 1e-12);
        assert!((over - surface.max(over_k / 4.0)).abs() < 1e-12, "{over}");
    }
}

/// A wheel on its flange is held up by it: lateral over vertical force is the tangent of the inclination less or more friction, and
/// above Nadal's limit; on its tread it is far below.
#[test]
fn a_wheel_that_may_climb_is_doubtful() {
    let judged = |shift: &str| {
        let set = [
            &*format!("motion.wheel_rail.shift={shift}"),
            "motion.wheel_rail.roll=",
            "motion.wheel_rail.yaw=0 rad",
        ];
        let resolved = resolve(MANCHESTER, &set).expect("a case");
        let results = resolved.case.solve(|_, _| ControlFlow::Continue(())).expect("a contact");
        let contact = results.contacts[0].clone();
        let dir = tempdir().unwrap();
        let mut claim = Claim::take(dir.path()).unwrap();
        let verdict = write_rail(&mut claim, "", &results, &Totals::default()).unwrap();
        (contact, verdict.complaints().map(ToString::to_string).collect::<String>())
    };
    let (tread, words) = judged("0 mm");
    let [lateral, vertical] = tread.forces();
    assert!(lateral.abs() < 0.1 * vertical && !words.contains("Nadal"), "{words}");
    let (flange, words) = judged("7 mm");
    let [lateral, vertical] = flange.forces();
    let [patch] = &flange.patches[..] else { panic!("{} patches", flange.patches.len()) };
    let angle = patch.values.contact_angle.abs().tan();
    let ends = [-0.3, 0.3].map(|mu| (angle + mu) / (1.0 - mu * angle));
    assert!((ends[0]..=ends[1]).contains(&(lateral / vertical)), "{lateral} {vertical} {ends:?}");
    assert!(words.contains("Nadal"), "{words}");
    // A flange of 70 degrees and a coefficient of .36, of textbooks: 1.2003; one of 60 degrees .8451.
    let limit = |degrees: f64| {
        archard_case::output::Flank { y: 0.0, angle: degrees.to_radians() }.nadal(0.36).unwrap()
    };
    assert!((limit(70.0) - 1.20029).abs() < 1e-5 && (limit(60.0) - 0.84510).abs() < 1e-5);
}

const WEARS: &str = "body.wheel.wear.archard.coefficient=1e-13 1/Pa";

/// A case whose wheel wears over that route.
fn with_route(text: &str, options: &[&str]) -> Result<Box<ResolvedWheelRail>, String> {
    let dir = tempdir().unwrap();
    let path = dir.path().join("route.csv");
    fs::write(&path, text).unwrap();
    let route = format!("motion.wheel_rail.route={}", path.display());
    let all =
        ["motion.wheel_rail.roll=", "motion.wheel_rail.pitch_rate=", "frame.elements=16", &route];
    let all: Vec<&str> = all.iter().chain(options).copied().collect();
    resolve(MANCHESTER, &all)
}

/// Columns of a route count in the place of the values of the motion; a track that curves turns its wheelset.
#[test]
fn a_route_is_its_points() {
    let route = "share,shift [mm],yaw [mrad],curvature [1/m]\n0.75,3,7.2,0\n0.25,1,2.4,1e-3\n";
    let given = "motion.wheel_rail.roll=-0.1803 mrad";
    let resolved = with_route(route, &[given]).expect("a case");
    let results = resolved.case.solve(|_, _| ControlFlow::Continue(())).expect("contacts");
    assert!(results.wear.is_none());
    let [first, second] = &results.contacts[..] else { panic!("{}", results.contacts.len()) };
    let yaw = "motion.wheel_rail.yaw_rate=2e-3 rad/s";
    let usual = [given, "motion.wheel_rail.pitch_rate=", "frame.elements=16"];
    let of = |more: &[&str]| solved(&[&usual[..], more].concat());
    let alone = of(&[]);
    let curved = of(&["motion.wheel_rail.shift=1 mm", "motion.wheel_rail.yaw=2.4 mrad", yaw]);
    for (contact, values) in [(first, alone), (second, curved)] {
        for (one, other) in contact.patches[0].values.values().iter().zip(values) {
            assert!((one - other).abs() <= 1e-12 * other.abs(), "{one} {other}");
        }
    }
}

/// The wheel loses what friction works times k over mu, in rows a step, and the case reads back.
#[test]
fn a_wheel_wears_over_its_route() {
    let route = "share,shift [mm]\n0.5,3\n0.5,0\n";
    let options = [WEARS, "motion.wheel_rail.distance=10 m", "motion.wheel_rail.side=both"];
    let case = with_route(route, &options).expect("a case").case;
    let results = case.solve(|_, _| ControlFlow::Continue(())).expect("wear");
    let wear = results.wear.expect("wear");
    for side in ["left", "right"] {
        let new = results
            .contacts
            .iter()
            .filter(|one| one.side.name() == side && one.at.unwrap().point == 1);
        let of = |point: usize| -> f64 {
            let own = results.contacts.iter().filter(|one| one.side.name() == side);
            let own = own.filter(|one| one.at == Some(AtPoint { point, worn: false }));
            own.flat_map(|one| &one.patches).map(|patch| patch.values.frictional_power).sum()
        };
        assert_eq!(new.count(), 2);
        let expected = 1e-13 / 0.3 * 10.0 * 0.5 * (of(1) + of(2)) / 2.0;
        let rows = wear.rows();
        let (_, last) = rows.iter().rev().find(|(own, _)| own.name() == side).unwrap();
        let volume = last.iter().find(|(name, _)| name == "wheel_worn_volume_m3").unwrap().1;
        assert!((volume / expected - 1.0).abs() < 3e-5, "{side}: {volume} {expected}");
    }
}

#[test]
fn wrong_routes_are_refused_in_words() {
    let far = "motion.wheel_rail.distance=10 m";
    for (text, options, expected) in [
        ("share,shift [mm]\n0.5,3\n0.4,0\n", vec![WEARS, far], "add up to 0.9"),
        ("share,shift [mm]\n0.5,3\n-0.5,0\n", vec![WEARS, far], "point 2"),
        ("shift [mm]\n3\n", vec![WEARS, far], "`share`"),
        ("share,height [mm]\n1,3\n", vec![WEARS, far], "`height` is no value"),
        ("share,shift\n1,3\n", vec![WEARS, far], "no unit"),
        ("share,yaw [rad]\n1,2\n", vec![WEARS, far], "yaw"),
        ("share,friction\n1,-0.2\n", vec![WEARS, far], "coefficient"),
        ("share,speed [m/s]\n1,0\n", vec![WEARS, far], "point 1"),
        ("share\n1\n", vec![WEARS], "`motion.wheel_rail.distance`"),
        ("share\n1\n", vec![far], "has no wear law"),
        ("share\n1\n", vec![WEARS, far, "motion.wheel_rail.axles=5"], "`rail` has no wear law"),
        ("share\n1\n", vec![WEARS, far, "motion.wheel_rail.tolerance=2"], "tolerance"),
    ] {
        let said = with_route(text, &options).err();
        let said = said.unwrap_or_else(|| panic!("{text} {options:?} passes"));
        assert!(said.contains(expected), "{text} {options:?}: {said}");
    }
}

/// A free wheelset turns as its contacts have it, a driven one passes its moment on to the rails, and friction bears so much and no more.
#[test]
fn an_axle_bears_its_moment() {
    let contacts = |moment: &str| {
        let options = [
            "motion.wheel_rail.side=both",
            "motion.wheel_rail.shift=0 mm",
            "motion.wheel_rail.yaw=0 rad",
            "motion.wheel_rail.roll=0 rad",
            "motion.wheel_rail.pitch_rate=",
            moment,
        ];
        let case = resolve(MANCHESTER, &options).expect("a case").case;
        case.solve(|_, _| ControlFlow::Continue(())).map(|results| results.contacts)
    };
    for moment in [-800.0, 0.0, 800.0] {
        let found =
            contacts(&format!("motion.wheel_rail.axle_moment={moment} N m")).expect("contacts");
        let forces = found.iter().flat_map(|one| &one.patches).map(|patch| -patch.values.force_x);
        // Both contacts lie below the axle, at a radius within .1 % of the nominal one.
        let off = forces.sum::<f64>() * 0.46 - moment;
        assert!(off.abs() < 1e-3 * 800.0, "{moment}: {off}");
    }
    // 0.3 of 20 kN at 0.46 m.
    let said = contacts("motion.wheel_rail.axle_moment=3 kN m").unwrap_err().to_string();
    assert!(said.contains("does not bear") && said.contains("2.7"), "{said}");
}

/// A wheel that wears at one point, without a route, gives whole tables: rows of new and of worn profiles have the same columns.
#[test]
fn a_point_that_wears_is_written() {
    let options = [WEARS, "motion.wheel_rail.distance=1 km", "frame.elements=16"];
    let resolved = resolve(MANCHESTER, &options).expect("a case");
    let results = resolved.case.solve(|_, _| ControlFlow::Continue(())).expect("wear");
    let at: Vec<_> = results.contacts.iter().map(|one| one.at).collect();
    let [new, worn] = [false, true].map(|worn| Some(AtPoint { point: 1, worn }));
    assert_eq!(at, [new, worn]);
}
