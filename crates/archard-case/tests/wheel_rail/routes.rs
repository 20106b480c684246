//! Routes of a wheel: their points, and the wear over them.

use std::fs;
use std::ops::ControlFlow;

use archard_case::ResolvedWheelRail;
use archard_case::output::AtPoint;
use tempfile::tempdir;

use super::{MANCHESTER, resolve, solved};

pub(super) const WEARS: &str = "body.wheel.wear.archard.coefficient=1e-13 1/Pa";

/// A case whose wheel wears over that route.
pub(super) fn with_route(text: &str, options: &[&str]) -> Result<Box<ResolvedWheelRail>, String> {
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
