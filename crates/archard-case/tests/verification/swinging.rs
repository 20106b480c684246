//! Surfaces that swing past each other: fretting in gross slip.

use approx::assert_relative_eq;
use archard::simulation::Error;
use archard_case::{CaseFile, Solves};

use crate::common::{Rows, case};

const CASE: &str = include_str!("../framed/mccoll_fretting/case.toml");

fn rows(text: &str, options: &[&str]) -> Rows {
    let mut rows = Rows::default();
    case(text, options).run(&mut [&mut rows]).expect("a run");
    rows
}

fn at(rows: &Rows, cycle: f64, column: &str) -> f64 {
    let number = |row: &[(String, f64)], column: &str| {
        archard::simulation::history::number(row, column).expect(column)
    };
    let row = rows.0.iter().find(|row| (number(row, "cycle") - cycle).abs() < 1e-6);
    number(row.expect("a row there"), column)
}

/// The field's benchmark: I. R. McColl, J. Ding and S. B. Leen, Wear 256 (2004) 1114, as computed since with level sets.
#[test]
fn depths_are_those_published() {
    let found = rows(CASE, &[]);
    for (cycle, depth) in [(1e3, 0.378e-6), (5e3, 1.131e-6), (1e4, 1.815e-6), (1.8e4, 2.713e-6)] {
        assert_relative_eq!(at(&found, cycle, "wear_depth_flat_m"), depth, max_relative = 5e-3);
    }
    assert_relative_eq!(at(&found, 1.8e4, "wear_depth_cylinder_m"), 2.023e-6, max_relative = 0.012);
    // The friction of 16.65 N/mm slides four amplitudes a cycle, less the elastic shift of some 2 %.
    let dissipated = found.last("dissipated_J") / (0.9 * 18500.0 * 1e-4);
    assert!((0.97..0.99).contains(&dissipated), "{dissipated}");
}

/// Volumes are in the ratio of the coefficients, and k F s with the distance that is slid.
#[test]
fn volumes_follow_from_the_work() {
    let found = rows(CASE, &["motion.fretting.cycles=2000", "output={}"]);
    let [flat, cylinder] =
        ["flat", "cylinder"].map(|body| found.last(&format!("worn_volume_{body}_m3")));
    assert_relative_eq!(flat / cylinder / (2.9 / 1.9), 1.0, epsilon = 1e-9);
    // 18500 N times 2000 cycles of 0.1 mm: all of it less what is elastic.
    let slid = flat / (2.9e-14 * 18500.0) / 0.2;
    assert!((0.96..0.99).contains(&slid), "{slid}");
}

/// Of amplitudes that are small against the contact, what friction finds increment by increment on surfaces that stay is the
/// same: each pair slides by the amplitude less its own elastic displacement.
#[test]
fn pairs_slide_by_what_friction_leaves_them() {
    let ball = |amplitude: &str, other: &str, rest: &str| {
        let text = format!(
            "body.ball = {{ material = {{ young = \"210 GPa\", poisson = 0.3 }}, profile.sphere.radius = \"50 mm\", wear.archard.coefficient = \"1e-15 1/Pa\" }}
             body.flat = {{ material = {{ {other} }}, profile.flat = {{}} }}
             frame = {{ size = [\"0.45 mm\", \"0.45 mm\"], elements = [45, 45] }}
             friction.coulomb.coefficient = 0.5
             friction_solver.newton.tolerance = 1e-9
             motion.fretting = {{ load = \"10.2 N\", amplitude = [\"{amplitude}\", \"0 um\"], cycles = 2, {rest} }}"
        );
        rows(&text, &[])
    };
    // Pressures of unlike bodies answer to friction too, which surfaces that swing leave out.
    for (amplitude, other, depth, volume) in [
        ("0.9 um", "young = \"210 GPa\", poisson = 0.3", 1e-3, 2e-3),
        ("1.5 um", "young = \"210 GPa\", poisson = 0.3", 1e-3, 4e-3),
        ("1.5 um", "young = \"70 GPa\", poisson = 0.3", 1e-3, 1e-2),
    ] {
        let swing = ball(amplitude, other, "surfaces = \"swing\"");
        let stay = ball(amplitude, other, "surfaces = \"stay\", increments = 80");
        // The first cycle of surfaces that stay begins in the middle.
        let second = |rows: &Rows, column: &str| at(rows, 2.0, column) - at(rows, 1.0, column);
        for (column, within) in [("wear_depth_ball_m", depth), ("worn_volume_ball_m3", volume)] {
            let ratio = second(&swing, column) / second(&stay, column);
            assert_relative_eq!(ratio, 1.0, epsilon = within);
        }
        let ratio = swing.last("dissipated_J") / stay.last("dissipated_J");
        assert_relative_eq!(ratio, 1.0, epsilon = 1e-2);
    }
}

/// Friction works without wear, too.
#[test]
fn what_does_not_wear_dissipates() {
    let none = ["body.flat.wear=", "body.cylinder.wear=", "motion.fretting.cycles=2", "output={}"];
    let swing = ["motion.fretting.surfaces=swing", "motion.fretting.tolerance=", "output={}"];
    let work = [&none[..3], &swing].concat();
    let dissipated = rows(CASE, &work).last("dissipated_J") / (0.9 * 18500.0 * 1e-4);
    assert!((0.97..0.99).contains(&dissipated), "{dissipated}");
}

/// Without friction nothing is elastic, and without an amplitude worth an element the surfaces stay. What is left is the
/// division of steps into nine tenths forward and one tenth back.
#[test]
fn short_swings_are_sliding_in_place() {
    let short = [
        "friction=",
        "motion.fretting.amplitude=[\"1 nm\", \"0 um\"]",
        "motion.fretting.surfaces=swing",
        "motion.fretting.cycles=1000000",
        "motion.fretting.tolerance=",
        "motion.fretting.jump=100000",
        "output={}",
    ];
    let sliding = [
        "friction=",
        "motion={ sliding = { load = \"18.5 N/mm\", distance = \"4 mm\", step = \"0.4 mm\", surfaces = \"stay\" } }",
        "output={}",
    ];
    let [short, sliding] = [rows(CASE, &short), rows(CASE, &sliding)];
    for column in ["wear_depth_flat_m", "wear_depth_cylinder_m", "worn_volume_flat_m3"] {
        assert_relative_eq!(short.last(column) / sliding.last(column), 1.0, epsilon = 5e-3);
    }
}

/// The bodies swapped, by their order in the case.
#[test]
fn bodies_may_be_swapped() {
    let (head, rest) = CASE.split_once("[body.cylinder]").expect("two bodies");
    let (title, flat) = head.split_once("[body.flat]").expect("a flat");
    let (cylinder, rest) = rest.split_once("[frame]").expect("a frame");
    let swapped = format!("{title}[body.cylinder]{cylinder}[body.flat]{flat}[frame]{rest}");
    let options =
        ["motion.fretting.cycles=1000", "output={}", "solver.conjugate_gradient.tolerance=1e-11"];
    let [one, other] = [rows(CASE, &options), rows(&swapped, &options)];
    for column in ["wear_depth_flat_m", "wear_depth_cylinder_m", "peak_pressure_Pa"] {
        assert_relative_eq!(one.last(column) / other.last(column), 1.0, epsilon = 1e-7);
    }
}

/// Jumps chosen by error against each cycle computed.
#[test]
fn jumps_meet_every_cycle() {
    let run = |rest: &[&str]| {
        let options =
            [&["motion.fretting.cycles=60", "output={}", "frame.size=0.4 mm"], rest].concat();
        rows(CASE, &options)
    };
    let every = run(&["motion.fretting.tolerance="]);
    let jumps = run(&["motion.fretting.tolerance=0.01"]);
    assert_eq!(every.0.len(), 61);
    assert!(jumps.0.len() < 30);
    let ratio = jumps.last("wear_depth_m") / every.last("wear_depth_m");
    assert_relative_eq!(ratio, 1.0, epsilon = 0.01);
}

/// A ball that swings along x and one that swings along y.
#[test]
fn a_ball_swings_along_either_axis() {
    let ball = |amplitude: &str| {
        let text = format!(
            "body.ball = {{ material = {{ young = \"210 GPa\", poisson = 0.3 }}, profile.sphere.radius = \"3 mm\", wear.archard.coefficient = \"1e-14 1/Pa\" }}
             body.flat = {{ material = {{ young = \"210 GPa\", poisson = 0.3 }}, profile.flat = {{}}, wear.archard.coefficient = \"2e-14 1/Pa\" }}
             frame = {{ size = [\"0.3 mm\", \"0.3 mm\"], elements = [41, 41] }}
             friction.coulomb.coefficient = 0.5
             motion.fretting = {{ load = \"10 N\", amplitude = {amplitude}, surfaces = \"swing\", cycles = 500, jump = 50 }}"
        );
        rows(&text, &[])
    };
    let [x, y] = [ball("[\"20 um\", \"0 um\"]"), ball("[\"0 um\", \"20 um\"]")];
    for column in ["wear_depth_ball_m", "wear_depth_flat_m", "worn_volume_flat_m3"] {
        assert_relative_eq!(x.last(column) / y.last(column), 1.0, epsilon = 1e-6);
    }
    // What swings is worn over a longer zone, and less deep than its share of volume.
    let share =
        |of: &str| x.last(&format!("wear_depth_{of}_m")) / x.last(&format!("worn_volume_{of}_m3"));
    assert!(share("flat") < share("ball"));
}

/// An amplitude of many elements, whose positions lie several apart, wears as on coarser elements.
#[test]
fn wide_swings_take_fewer_positions() {
    let run = |elements: &str| {
        let options = [
            "motion.fretting.amplitude=[\"250 um\", \"0 um\"]",
            "motion.fretting.cycles=500",
            "output={}",
            elements,
        ];
        rows(CASE, &options)
    };
    let [coarse, fine] = [run("frame.elements=80"), run("frame.elements=160")];
    for column in ["wear_depth_flat_m", "wear_depth_cylinder_m", "worn_volume_flat_m3"] {
        assert_relative_eq!(coarse.last(column) / fine.last(column), 1.0, epsilon = 0.02);
    }
    // 18500 N times 500 cycles of 1 mm, less what is elastic.
    let slid = fine.last("worn_volume_flat_m3") / (2.9e-14 * 18500.0) / 0.5;
    assert!((0.996..0.999).contains(&slid), "{slid}");
}

/// Elements much finer than the way from one position to the next wear as coarse ones do, and no pressure stands out.
#[test]
#[ignore = "long: in .ci/long"]
fn fine_elements_leave_no_teeth() {
    let run = |elements: &str| {
        let options = [
            "motion.fretting.cycles=4500",
            "motion.fretting.tolerance=0.0005",
            "frame.size=0.8 mm",
            "output={}",
            elements,
        ];
        rows(CASE, &options)
    };
    let [coarse, fine] = [run("frame.elements=128"), run("frame.elements=1024")];
    for (column, within) in [
        ("wear_depth_flat_m", 5e-3),
        ("wear_depth_cylinder_m", 5e-3),
        ("worn_volume_flat_m3", 1e-3),
        ("peak_pressure_Pa", 5e-2),
    ] {
        assert_relative_eq!(coarse.last(column) / fine.last(column), 1.0, epsilon = within);
    }
}

#[test]
fn bodies_that_stick_do_not_swing() {
    let options = [
        "output={}",
        "motion.fretting.amplitude=[\"0.3 um\", \"0 um\"]",
        "motion.fretting.surfaces=swing",
    ];
    let sticks = case(CASE, &options).run(&mut []).expect_err("an error");
    assert!(matches!(sticks, Error::NoGrossSlip { .. }), "{sticks}");
}

/// Where a case does not say how its surfaces meet, the amplitude relative to the contact decides: its half width is 35.9 um.
#[test]
fn surfaces_are_chosen_by_the_amplitude() {
    let swings = |options: &[&str]| {
        let file = CaseFile::from_text("case", CASE, ".");
        let file = options.iter().fold(file, |file, option| file.set(*option));
        let resolved = file.resolve().unwrap_or_else(|_| panic!("a case"));
        let swing = resolved.forecast.surfaces.expect("a fretting contact").swing;
        assert_eq!(resolved.case.to_string().contains("surfaces = \"swing\""), swing);
        swing
    };
    let amplitude = |um: f64| format!("motion.fretting.amplitude=[\"{um} um\", \"0 um\"]");
    assert!(swings(&[]) && swings(&[&amplitude(10.9)]));
    assert!(!swings(&[&amplitude(10.6)]));
    assert!(!swings(&["motion.fretting.surfaces=stay"]));
    // What only surfaces that stay take, what does not wear, and what the bodies may follow.
    assert!(!swings(&["motion.fretting.increments=40"]));
    assert!(!swings(&["body.flat.wear=", "body.cylinder.wear="]));
    assert!(!swings(&[&amplitude(12.0), "friction.coulomb.coefficient=20"]));
    // What resists slip along the motion counts, not the force that inclined axes bear there.
    let axes = |angle: f64| {
        format!(
            "friction={{ orthotropic = {{ coefficients = [20, 0.2], angle = \"{angle} deg\" }} }}"
        )
    };
    assert!(swings(&[&amplitude(12.0), &axes(90.0)]));
    assert!(!swings(&[&amplitude(12.0), &axes(0.0)]));
    assert!(!swings(&[&amplitude(12.0), &axes(45.0)]));
}

/// A forecast counts the positions of each step.
#[test]
fn solves_are_foretold() {
    for (options, within) in [
        (&["motion.fretting.tolerance=", "motion.fretting.cycles=40", "output={}"][..], 0.0),
        (&["output={}"], 0.5),
    ] {
        let file = options
            .iter()
            .fold(CaseFile::from_text("case", CASE, "."), |file, option| file.set(*option));
        let promised = match file.resolve().unwrap_or_else(|_| panic!("a case")).forecast.solves {
            Solves::Exactly(solves) | Solves::AtLeast(solves) | Solves::About(solves) => solves,
        };
        let found = rows(CASE, options).last("solves");
        assert_relative_eq!(promised as f64, found, max_relative = within);
    }
}
