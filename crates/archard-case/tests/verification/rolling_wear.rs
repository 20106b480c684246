//! Wear of discs that roll, against the work of the creepage, other steps and an independent table.

use approx::assert_relative_eq;
use archard::problem::ContactState;

use super::rolling::row;
use crate::common::{Rows, case, states};

/// Twin discs as in the paper's section 6.3.
pub fn twin_discs(size: [f64; 2], elements: [usize; 2], motion: &str) -> String {
    let [x, y] = size;
    let [nx, ny] = elements;
    format!(
        r#"
        [body.disc1]
        material = {{ young = "208 GPa", poisson = 0.3 }}
        profile.disc = {{ radius = "32.5 mm", crown = "125 mm" }}
        wear.archard = {{ coefficient = "1.333333e-6 1/MPa" }}
        [body.disc2]
        material = {{ young = "208 GPa", poisson = 0.3 }}
        profile.disc = {{ radius = "32.3 mm" }}
        wear.archard = {{ coefficient = "0.666667e-6 1/MPa" }}
        [frame]
        size = ["{x} mm", "{y} mm"]
        elements = [{nx}, {ny}]
        [friction.coulomb]
        coefficient = 0.6
        [motion.rolling]
        load = "300 N"
        {motion}
        "#
    )
}

/// k_w of both discs together (1/Pa).
pub const WEAR: f64 = 2e-12;

/// Deepest wear a revolution at 24 elements across the contact, against the limit of fine grids: 1.1495
/// MPa mm times k_w at 0.5 %, 4.078 at 1.5 %.
#[test]
fn wear_of_a_revolution_on_coarse_elements() {
    let spacing = [2.0 * 0.2165120 / 24.0, 2.0 * 0.8265901 / 24.0];
    let elements = [27, 27];
    let size = [0, 1].map(|axis| spacing[axis] * elements[axis] as f64);
    for (creepage, expected, within) in [(0.005, 1.1495e3, 0.003), (0.015, 4.078e3, 0.001)] {
        let motion = format!("creepage = {creepage}\nrevolutions = 1e-3\nstep = 1e-3");
        let depth = row(&twin_discs(size, elements, &motion)).last("wear_depth_m") / 1e-3;
        assert_relative_eq!(depth / WEAR, expected, max_relative = within);
    }
}

/// The same discs rolling along either axis, in either sense: one and the same contact, turned.
#[test]
fn the_direction_of_rolling_makes_no_difference() {
    let motion = "creepage = 0.004\nlateral_creepage = 0.001\nspin = \"0.5 1/m\"\nrevolutions = 20\nstep = 10";
    let along_x = twin_discs([0.52, 2.2], [20, 17], motion);
    let turned = along_x
        .replace(
            "profile.disc = { radius = \"32.5 mm\", crown = \"125 mm\" }",
            "profile.paraboloid = { radius_x = \"125 mm\", radius_y = \"32.5 mm\" }",
        )
        .replace(
            "profile.disc = { radius = \"32.3 mm\" }",
            "profile.paraboloid = { radius_x = \"1e9 m\", radius_y = \"32.3 mm\" }",
        )
        .replace("[\"0.52 mm\", \"2.2 mm\"]", "[\"2.2 mm\", \"0.52 mm\"]")
        .replace("[20, 17]", "[17, 20]");
    let straight = along_x
        .replace(
            "profile.disc = { radius = \"32.5 mm\", crown = \"125 mm\" }",
            "profile.paraboloid = { radius_x = \"32.5 mm\", radius_y = \"125 mm\" }",
        )
        .replace(
            "profile.disc = { radius = \"32.3 mm\" }",
            "profile.paraboloid = { radius_x = \"32.3 mm\", radius_y = \"1e9 m\" }",
        );
    let first = row(&straight);
    let force = |rows: &Rows| [rows.last("force_x_N"), rows.last("force_y_N")];
    let [forward, lateral] = force(&first);
    for (text, direction, [x, y]) in [
        (&straight, "-x", [-forward, -lateral]),
        (&turned, "y", [-lateral, forward]),
        (&turned, "-y", [lateral, -forward]),
    ] {
        let rows = row(&format!("{text}\ndirection = \"{direction}\""));
        let found = force(&rows);
        for (found, expected) in found.into_iter().zip([x, y]) {
            assert_relative_eq!(found, expected, epsilon = 2e-5 * 180.0);
        }
        for column in
            ["moment_z_Nm", "stick_area_m2", "wear_depth_m", "frictional_power_per_speed_N"]
        {
            assert_relative_eq!(rows.last(column), first.last(column), max_relative = 1e-4);
        }
    }
}

/// Worn section of a revolution against the work of the creepage, (k_w/mu) xi T, step by step.
#[test]
fn what_is_worn_is_the_work_of_the_creepage() {
    let size = ([0.52, 6.4], [41, 81]);
    for (creepage, step, revolutions, within) in
        [(0.005, 50.0, 300.0, 1e-5), (0.005, 500.0, 6000.0, 1e-5), (0.015, 200.0, 1000.0, 1e-5)]
    {
        let motion = format!("creepage = {creepage}\nrevolutions = {revolutions}\nstep = {step}");
        let rows = row(&twin_discs(size.0, size.1, &motion));
        let sections: Vec<f64> = ["worn_section_disc1_m2", "worn_section_disc2_m2"]
            .map(|column| rows.column(column))
            .into_iter()
            .reduce(|one, two| one.iter().zip(two).map(|(a, b)| a + b).collect())
            .expect("two discs");
        let forces = rows.column("force_x_N");
        for (section, force) in sections.windows(2).zip(&forces[1..]) {
            let worn = (section[1] - section[0]) / step;
            assert_relative_eq!(worn, WEAR / 0.6 * creepage * force, max_relative = within);
        }
    }
}

/// The same of discs that spin, alone and with a lateral creepage, either way round: the spin works on the moment,
/// with the sign that the slip has.
#[test]
fn what_is_worn_is_the_work_of_the_spin() {
    for motion in [
        "spin = \"20 1/m\"",
        "spin = \"-20 1/m\"\ndirection = \"-x\"",
        "spin = \"10 1/m\"\nlateral_creepage = 0.001",
    ] {
        let motion = format!("{motion}\nrevolutions = 1e-3\nstep = 1e-3");
        let rows = row(&twin_discs([0.52, 2.2], [30, 30], &motion));
        let sections = ["worn_section_disc1_m2", "worn_section_disc2_m2"];
        let worn: f64 = sections.map(|column| rows.last(column)).iter().sum();
        let work = rows.last("frictional_power_per_speed_N");
        assert!(rows.last("moment_z_Nm") != 0.0);
        assert_relative_eq!(worn / 1e-3, WEAR / 0.6 * work, max_relative = 1e-5);
    }
}

/// Where everything slips, only the product of coefficient, creepage and revolutions counts.
#[test]
fn creepage_times_revolutions_is_what_counts() {
    let size = ([0.52, 6.4], [31, 61]);
    let depth = |creepage: f64, revolutions: f64| {
        let motion =
            format!("creepage = {creepage}\nrevolutions = {revolutions}\ntolerance = 0.003");
        row(&twin_discs(size.0, size.1, &motion)).last("wear_depth_m")
    };
    assert_relative_eq!(depth(0.015, 10_000.0), depth(0.005, 30_000.0), max_relative = 5e-3);
}

/// Steps chosen by error against steps of 10 revolutions, at every output of the first sixth of the run; and
/// over the whole run the independent table: depth (um), and peak pressure (MPa), which no spike exceeds.
#[test]
fn steps_by_error_meet_the_run_without_acceleration() {
    let outputs = [1.0, 100.0, 1000.0, 5000.0, 10_000.0, 20_000.0];
    let run = |motion: &str| {
        let text = twin_discs([0.52, 6.4], [41, 81], &format!("creepage = 0.005\n{motion}"));
        let outputs = if motion.contains("step") { "" } else { &*format!("at = {outputs:?}") };
        row(&format!("{text}\n[output]\n{outputs}"))
    };
    let at = |rows: &Rows, column: &str, revolutions: f64| {
        let places = rows.column("revolutions");
        let near = |place: &f64| (place - revolutions).abs() <= 1e-9 * revolutions;
        rows.column(column)[places.iter().position(near).expect("an output")]
    };
    let adaptive = run("revolutions = 30000\ntolerance = 0.003");
    assert!(adaptive.last("solves") <= 60.0, "{} solves", adaptive.last("solves"));
    let fixed = run("revolutions = 5000\nstep = 10");
    for revolutions in [100.0, 1000.0, 5000.0] {
        let [one, other] = [&adaptive, &fixed].map(|rows| at(rows, "wear_depth_m", revolutions));
        assert_relative_eq!(one, other, max_relative = 0.01);
    }
    let table = [
        (100.0, 0.2288, 787.0),
        (1000.0, 2.06, 684.0),
        (5000.0, 7.59, 502.0),
        (10_000.0, 12.38, 440.0),
        (20_000.0, 19.87, 391.0),
        (30_000.0, 26.13, 364.0),
    ];
    for (revolutions, depth, peak) in table {
        let within = if revolutions == 30_000.0 { 1e-3 } else { 0.01 };
        let found = at(&adaptive, "wear_depth_m", revolutions);
        assert_relative_eq!(found, depth * 1e-6, max_relative = within);
        let found = at(&adaptive, "peak_pressure_Pa", revolutions);
        assert!(found < 1.05 * peak * 1e6, "{found:e} Pa after {revolutions} revolutions");
    }
}

/// Ten times the revolutions in a step wear ten times as much and take hardly more iterations a solve.
#[test]
fn longer_steps_take_hardly_more_iterations() {
    let iterations = |step: f64| {
        let motion = format!("creepage = 0.005\nrevolutions = {step}\nstep = {step}");
        let rows = row(&twin_discs([0.52, 6.4], [41, 81], &motion));
        let solves = rows.column("solves");
        rows.last("iterations") / (solves[1] - solves[0])
    };
    let [short, long] = [100.0, 1000.0].map(iterations);
    assert!(long < 1.5 * short, "{short} and {long} iterations a solve");
}

/// Over ten thousand revolutions each pair that joins the contact or leaves it shifts the gap of its whole line. The sets
/// of pairs in contact settle all the same.
#[test]
fn the_contact_settles_over_ten_thousand_revolutions() {
    let motion = "creepage = 0.005\nrevolutions = 30000\nstep = 10000";
    let few = ["solver.conjugate_gradient.max_iterations=60"];
    let ended = states(&case(&twin_discs([0.52, 6.4], [21, 101], motion), &few));
    let (_, effort, _) = ended.expect("it converges").pop().expect("a last state");
    assert_eq!(effort.steps, 3);
}

/// Where everything slips and the creepage follows the worn radii, a plane wears by its load times its own
/// creepage, xi - w1/R1 + w2/R2.
#[test]
fn creepage_follows_the_worn_radii() {
    let motion = "creepage = 0.005\nradius = \"worn\"\nrevolutions = 8000\nstep = 400";
    let text = twin_discs([0.52, 4.8], [41, 61], motion);
    let states = states(&case(&text, &[])).expect("it converges");
    let problem = case(&text, &[]).problem;
    let frame = &problem.frame;
    let [.., (before, ..), (after, ..)] = &states[..] else { panic!("two states") };
    let section = |state: &ContactState| frame.integrate(&state.total_worn()) / frame.size()[0];
    let worn = (section(after) - section(before)) / 400.0;
    let sum = |creepage: &dyn Fn(usize) -> f64| -> f64 {
        let pairs = after.pressure.iter().enumerate();
        pairs.map(|(pair, pressure)| pressure * creepage(pair)).sum::<f64>() * frame.element_area()
    };
    let follows =
        sum(&|pair| 0.005 - before.worn(0)[pair] / 0.0325 + before.worn(1)[pair] / 0.0323);
    assert_relative_eq!(worn, WEAR * follows, max_relative = 1e-3);
    assert!(follows < 0.99 * sum(&|_| 0.005), "the radii hardly changed");
}

/// Steps without wear change nothing, forces across least of all: how spin turns the slip on its way belongs to the solution,
/// whatever is known when a step begins.
#[test]
fn forces_stay_where_nothing_wears() {
    let unlike = r#"
        [body.wheel]
        material = { young = "96 GPa", poisson = 0.3 }
        profile.paraboloid = { radius_x = "340 mm", radius_y = "38 mm" }
        [body.rail]
        material = { young = "27 GPa", poisson = 0.3 }
        profile.flat = {}
        [friction.coulomb]
        coefficient = 0.28
        [frame]
        size = ["1.3 mm", "0.31 mm"]
        elements = [24, 24]
        [motion.rolling]
        load = "3.12 N"
        force = "-0.75 N"
        spin = "-0.0042 1/mm"
        revolutions = 3
        step = 1
    "#;
    let mut rows = Rows::default();
    case(unlike, &[]).run(&mut [&mut rows]).unwrap();
    let across = rows.column("force_y_N");
    assert_eq!(across.len(), 4);
    for force in &across {
        // Ten times the tolerance of friction.
        assert_relative_eq!(*force, across[0], max_relative = 1e-5);
    }
}
