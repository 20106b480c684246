//! Cases of a wheel on a rail: read, printed, refused with a place, and solved on both sides of the track.

#[path = "wheel_rail/judged.rs"]
mod judged;
#[path = "wheel_rail/routes.rs"]
mod routes;
#[path = "wheel_rail/service.rs"]
mod service;

use std::fs;
use std::ops::ControlFlow;

use archard_case::{CaseFile, ResolvedWheelRail, Task};
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
    let case = routes::with_route(text, &lubricated[1..]).expect("a case").case;
    let results = case.solve(|_, _| ControlFlow::Continue(())).expect("contacts");
    let used = |at: usize| {
        let patch = &results.contacts[at].patches[0].values;
        patch.force_x.hypot(patch.force_s) / patch.normal_force
    };
    assert!(used(1) < 0.2 && used(1) > 0.15 && used(0) > 0.2, "{} {}", used(0), used(1));
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
