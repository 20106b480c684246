//! Histories of programs of vehicle dynamics: read under many heads, gathered to points whose loss is stated, refused with a remedy.

use std::fs;
use std::ops::ControlFlow;

use archard_case::output::{Claim, RailResults, Totals, write_rail};
use archard_case::{CaseFile, ResolvedWheelRail, Task};
use tempfile::tempdir;

const MANCHESTER: &str = include_str!("../../../cases/manchester/case.toml");

/// A case whose history is that text.
fn with_history(text: &str, options: &[&str]) -> Result<Box<ResolvedWheelRail>, String> {
    let dir = tempdir().unwrap();
    let path = dir.path().join("run.csv");
    fs::write(&path, text).unwrap();
    let history = format!("motion.wheel_rail.history.file={}", path.display());
    let usual = [
        "motion.wheel_rail.roll=",
        "motion.wheel_rail.pitch_rate=",
        "motion.wheel_rail.shift=",
        "motion.wheel_rail.yaw=",
        "frame.elements=16",
        &history,
    ];
    let file = CaseFile::from_text("case.toml", MANCHESTER, "");
    let file = usual.iter().chain(options).fold(file, |file, option| file.set(*option));
    match file.task() {
        Ok(Task::WheelRail(resolved)) => Ok(resolved),
        Ok(_) => Err("another case".to_owned()),
        Err(problems) => {
            Err(problems.iter().map(|one| file.describe(one)).collect::<Vec<_>>().join("\n"))
        }
    }
}

fn results(text: &str, options: &[&str]) -> RailResults {
    let case = with_history(text, options).expect("a case").case;
    case.solve(|_, _| ControlFlow::Continue(())).expect("contacts")
}

/// Work of friction (N) on a metre of the route, over the shares of its points.
fn work(results: &RailResults, shares: &[f64]) -> f64 {
    let of = |point: usize| -> f64 {
        let own = results.contacts.iter().filter(|one| one.at.is_some_and(|at| at.point == point));
        own.flat_map(|one| &one.patches).map(|patch| patch.values.frictional_power / 2.0).sum()
    };
    shares.iter().enumerate().map(|(at, share)| share * of(at + 1)).sum()
}

/// A wheelset that weaves into a curve and out of it, a row on each metre.
fn weaving(rows: usize) -> Vec<[f64; 4]> {
    let row = |row: usize| {
        let s = row as f64;
        let (sin, cos) = (s / 7.0).sin_cos();
        [s, 2.0 + 2.0 * sin, 1.0 + 0.6 * cos, 1e-3 * (s / rows as f64)]
    };
    (0..rows).map(row).collect()
}

fn columns(head: &str, rows: impl Iterator<Item = [f64; 4]>) -> String {
    let row = |row: [f64; 4]| row.map(|value| value.to_string()).join(",");
    format!("{head}\n{}\n", rows.map(row).collect::<Vec<_>>().join("\n"))
}

/// The points do the work of all steps to the loss that is stated, which is no more than is let pass; less takes more points.
#[test]
fn points_do_the_work_of_the_steps() {
    let rows = weaving(80);
    let text = columns("s [m],y [mm],yaw [mrad],curvature [1/m]", rows.iter().copied());
    let route = with_history(&text, &[]).unwrap();
    let shares = route.case.prepare().unwrap().running.states().unwrap();
    let shares: Vec<f64> = shares.iter().map(|state| state.share).collect();
    assert!((shares.iter().sum::<f64>() - 1.0).abs() < 1e-12 && shares[0] == 0.5 * shares[1]);
    // All steps as the points of a route.
    let all = results(&text, &["motion.wheel_rail.history.within=1e-9"]);
    let own = |results: &RailResults| {
        let history = results.history.as_ref().unwrap();
        (history.loss, history.rows[0].1.clone())
    };
    let truth = work(&all, &own(&all).1);
    assert_eq!(own(&all).1.len(), 80);
    // The points are written as a route.
    let dir = tempdir().unwrap();
    let mut claim = Claim::take(dir.path()).unwrap();
    write_rail(&mut claim, "", &all, &Totals::default()).unwrap();
    let written = fs::read_to_string(dir.path().join("gathered.csv")).unwrap();
    assert!(written.starts_with("share,shift [m],yaw [rad],curvature [1/m]\n"), "{written}");
    assert_eq!(written.lines().count(), 81);
    let mut before = 1;
    for within in [0.2, 0.05] {
        let option = format!("motion.wheel_rail.history.within={within}");
        let gathered = results(&text, &[&option]);
        let (loss, shares) = own(&gathered);
        let off = (work(&gathered, &shares) / truth - 1.0).abs();
        assert!(loss <= within && off <= loss, "{within}: {off} {loss}");
        assert!(shares.len() > before && shares.len() < 60, "{}", shares.len());
        before = shares.len();
    }
}

/// One history under the heads, units and axes of different programs.
#[test]
fn heads_units_and_axes_are_told() {
    let rows = weaving(12);
    let first = columns("s [m],y [mm],yaw [mrad],curvature [1/m]", rows.iter().copied());
    let timed = rows.iter().map(|[s, y, yaw, kappa]| [s / 20.0, 1e-3 * y, 1e-3 * yaw, *kappa]);
    let timed = columns("Time (s),Lateral displacement (m),psi (rad),kappa (1/m)", timed);
    let up = rows.iter().map(|[s, y, yaw, kappa]| {
        [*s, -y, -yaw.to_radians() * 1e-3 * (180.0 / std::f64::consts::PI).powi(2), -kappa]
    });
    let up = columns("$way [m],$WS1.y,Yaw Angle [deg],Track-Curvature [1/m]", up);
    let named = [
        "motion.wheel_rail.history.upwards=true",
        "motion.wheel_rail.history.distance=$way [m]",
        "motion.wheel_rail.history.shift=$WS1.y [mm]",
    ];
    let speed = ["motion.wheel_rail.speed=20 m/s"];
    let route = |text: &str, options: &[&str]| {
        with_history(text, options).unwrap().case.prepare().unwrap().running.states().unwrap()
    };
    let first = route(&first, &speed);
    let options = [&speed[..], &named].concat();
    for other in [route(&timed, &speed), route(&up, &options)] {
        assert_eq!(other.len(), 12);
        for (one, other) in first.iter().zip(&other) {
            let near = |one: f64, other: f64| assert!((one - other).abs() < 1e-12, "{one} {other}");
            near(one.share, other.share);
            near(one.attitude.shift, other.attitude.shift);
            near(one.attitude.yaw, other.attitude.yaw);
            near(one.curvature, other.curvature);
        }
    }
}

/// A half turn about x takes y to the left and z upwards: what lies along either changes its sign, and so does what turns about either.
#[test]
fn axes_upwards_are_a_half_turn() {
    let text = |sign: f64| {
        let row = [3e-3, 1e-3, 1e-4, 2e-3, 0.05, 0.01, 0.02, -5.0].map(|one| sign * one);
        let row = row.map(|one| one.to_string()).join(",");
        let head = "s [m],y [m],yaw [rad],curvature [1/m],cant [m],lateral_speed [m/s],vertical_speed [m/s],yaw_rate [rad/s],\
                    pitch_rate [rad/s],roll [rad],roll_rate [rad/s],speed [m/s],creepage_right";
        let rest = "1e-3,4e-3,2,1e-3";
        format!("{head}\n0,{row},{rest}\n5,{row},{rest}\n")
    };
    let states = |text: &str, upwards: bool| {
        let option = format!("motion.wheel_rail.history.upwards={upwards}");
        let case = with_history(text, &[&option]).unwrap().case;
        case.prepare().unwrap().running.states().unwrap()
    };
    assert_eq!(states(&text(1.0), false), states(&text(-1.0), true));
}

/// Each wheel bears its own load, as given or by the balance in a curve, and creeps as is prescribed.
#[test]
fn each_wheel_has_its_load_and_its_creepage() {
    let both = "motion.wheel_rail.side=both";
    let loads = |text: &str, options: &[&str]| {
        let results = results(text, &[&[both], options].concat());
        let load = |side: &str| {
            let one = results.contacts.iter().find(|one| one.side.name() == side).unwrap();
            assert!(one.off() < 1e-5);
            one.load
        };
        [load("right"), load("left")]
    };
    let given = loads("s [m],y [mm],Q_right [kN],Q_left [kN]\n0,1,12,8\n5,1,12,8\n", &[]);
    assert!((given[0] - 12e3).abs() < 1e-6 && (given[1] - 8e3).abs() < 1e-6, "{given:?}");
    // 20 m/s on 500 m to the right: 0.8 m/s^2 outwards, less 9.80665 x 60/1500 inwards; 1.5 m up on 1.5 m.
    let text = "s [m],radius [m],cant [mm],v [m/s]\n0,500,60,20\n5,500,60,20\n";
    let curve = loads(text, &["motion.wheel_rail.centre_height=1.5 m"]);
    // Forces that are given have the balance in them.
    let text = "s [m],Q_right [kN],Q_left [kN],radius [m],v [m/s]\n0,12,8,500,20\n5,12,8,500,20\n";
    let given = loads(text, &["motion.wheel_rail.centre_height=1.5 m"]);
    assert!((given[0] - 12e3).abs() < 1e-6 && (given[1] - 8e3).abs() < 1e-6, "{given:?}");
    let moved = 20e3 * (0.8 / 9.80665 - 0.04);
    assert!((curve[0] - (10e3 - moved)).abs() < 1e-6, "{curve:?} {moved}");
    assert!((curve[1] - (10e3 + moved)).abs() < 1e-6, "{curve:?} {moved}");
    let text = "s [m],creepage_right,lateral_creepage_right,spin_left [1/m]\n0,1e-3,-2e-3,0.3\n5,1e-3,-2e-3,0.3\n";
    let results = results(text, &[both]);
    let of = |side: &str| {
        let one = results.contacts.iter().find(|one| one.side.name() == side).unwrap();
        one.patches[0].values
    };
    let right = of("right");
    assert_eq!((right.creepage, right.lateral_creepage), (1e-3, -2e-3));
    assert!(right.spin != 0.3 && of("left").spin == 0.3 && of("left").creepage != 1e-3);
}

/// Lateral forces of a history are held against those of the contacts, and against Nadal's limit at every step.
#[test]
fn lateral_forces_are_held_against_the_contacts() {
    let judged = |[first, last]: [f64; 2]| {
        let text = format!("s [m],y [mm],Y_right [N]\n0,3,{first}\n5,3,{last}\n");
        let results = results(&text, &[]);
        let dir = tempdir().unwrap();
        let mut claim = Claim::take(dir.path()).unwrap();
        let verdict = write_rail(&mut claim, "", &results, &Totals::default()).unwrap();
        let complaints: Vec<String> = verdict.complaints().map(|line| line.to_string()).collect();
        (results, complaints.join("\n"))
    };
    let (results, _) = judged([0.0; 2]);
    let [lateral, vertical] = results.contacts[0].forces();
    let (results, same) = judged([lateral; 2]);
    assert_eq!(results.contacts[0].told, Some(lateral));
    assert!(!same.contains("history") && !same.contains("Nadal"), "{same}");
    let (_, off) = judged([lateral + 0.2 * vertical; 2]);
    assert!(off.contains("the right wheel at point 1") && !off.contains("Nadal"), "{off}");
    // A step above the limit, whose mean with the other is below it.
    let limit = results.contacts[0].nadal.unwrap();
    let (results, climbs) = judged([1.1 * limit * vertical, 0.0]);
    assert!((results.history.unwrap().climb.unwrap() - 1.1).abs() < 1e-3);
    assert!(climbs.contains("Nadal"), "{climbs}");
}

#[test]
fn wrong_histories_are_refused_in_words() {
    let rows = "0,1\n1,2\n";
    for (text, options, expected) in [
        (format!("s [m],y\n{rows}"), vec![], "the column `y` has no unit"),
        (format!("s [m],y [kN]\n{rows}"), vec![], "expected a length"),
        (format!("s [m],height [mm]\n{rows}"), vec![], "none of the columns"),
        (format!("a [m],y [mm]\n{rows}"), vec![], "neither a distance nor a time"),
        ("s [m],y [mm]\n0,1\n2,1\n1,1\n".to_owned(), vec![], "line 4: the way falls"),
        ("s [m],y [mm]\n0,1\n0,1\n".to_owned(), vec![], "goes no way"),
        (format!("s [m],Q_right [kN]\n{rows}"), vec![], "`q_right` and `q_left` count together"),
        ("s [m],radius [m],kappa [1/m]\n0,1,1\n1,1,1\n".to_owned(), vec![], "keep one of them"),
        (
            "s [m],Q_right [kN],Q_left [kN],wheel_load [kN]\n0,1,1,1\n1,1,1,1\n".to_owned(),
            vec![],
            "`wheel_load` and `q_right`",
        ),
        (format!("s [m],y [mm]\n{rows}"), vec!["yaw=heading"], "heading"),
        (format!("s [m],y [mm]\n{rows}"), vec!["within=2"], "between 0 and 1"),
        (
            "s [m],Q_right [kN],Q_left [kN]\n0,20,-1\n1,20,-1\n".to_owned(),
            vec![],
            "point 1: a transfer of 1.0500e4 N lifts a wheel",
        ),
    ] {
        let options: Vec<String> =
            options.iter().map(|one| format!("motion.wheel_rail.history.{one}")).collect();
        let options: Vec<&str> = options.iter().map(String::as_str).collect();
        let said = with_history(&text, &options).err();
        let said = said.unwrap_or_else(|| panic!("{text} {options:?} passes"));
        assert!(said.contains(expected) && said.contains("motion.wheel_rail"), "{text}: {said}");
    }
}
