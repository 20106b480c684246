//! Friction with two axes against Coulomb's law, closed forms of full sliding, the rule of maximum dissipation and the
//! energy of the motion.

use approx::assert_relative_eq;
use archard::friction::{FRICTION, Friction, Map};
use archard::parameters::{Value, Values};
use archard::problem::{ContactProblem, ContactState};
use archard::simulation::{Effort, Simulation};

use crate::common::{Rows, case, states};

/// A state as it is shown.
type Shown = (ContactState, Effort, bool);

/// A sphere on a flat, like or unlike, without friction and motion.
fn ball(rigid: bool, elements: usize) -> String {
    let ball =
        if rigid { "rigid = true" } else { "material = { young = \"210 GPa\", poisson = 0.3 }" };
    format!(
        r#"
        [body.ball]
        {ball}
        profile.sphere = {{ radius = "50 mm" }}
        [body.flat]
        material = {{ young = "210 GPa", poisson = 0.3 }}
        profile.flat = {{}}
        [frame]
        size = ["0.36 mm", "0.36 mm"]
        elements = [{elements}, {elements}]
        [solver.conjugate_gradient]
        tolerance = 1e-11
        [friction_solver.newton]
        tolerance = 1e-11
        "#
    )
}

/// Discs of the publication on disc wear (load 300 N), unworn.
fn discs(motion: &str) -> String {
    format!(
        r#"
        [body.one]
        material = {{ young = "208 GPa", poisson = 0.3 }}
        profile.disc = {{ radius = "32.5 mm", crown = "32.5 mm" }}
        wear.archard.coefficient = "1e-16 1/Pa"
        [body.two]
        material = {{ young = "208 GPa", poisson = 0.3 }}
        profile.disc = {{ radius = "32.3 mm" }}
        [frame]
        size = ["0.66 mm", "1.0 mm"]
        elements = [33, 25]
        [friction_solver.newton]
        tolerance = 1e-10
        [motion.rolling]
        load = "300 N"
        revolutions = 2
        step = 1
        {motion}
        "#
    )
}

/// A rigid ball on a meshed block; the zone is plane, but the compliance is a matrix.
const ON_BLOCK: &str = r#"
    [body.ball]
    rigid = true
    profile.sphere = { radius = "50 mm" }
    [body.block]
    material = { young = "210 GPa", poisson = 0.3 }
    mesh.box = { size = ["10 mm", "10 mm", "10 mm"], contact = { face = "top", size = ["2.6 mm", "2.6 mm"], elements = [6, 6] } }
    supports = { bottom = "clamped" }
    [friction_solver.newton]
    tolerance = 1e-11
    "#;

/// A rigid sphere on the side of a meshed roll, whose pairs have bases of their own.
const ON_CYLINDER: &str = r#"
    [body.ball]
    rigid = true
    profile.sphere = { radius = "50 mm" }
    [body.roll]
    material = { young = "210 GPa", poisson = 0.3 }
    mesh.cylinder = { radius = "8 mm", length = "12 mm", contact = { face = "side", size = ["3 mm", "3 mm"], elements = [8, 8] } }
    supports = { front = "clamped", back = "clamped" }
    [friction_solver.newton]
    tolerance = 1e-11
    "#;

const FRETTING: &str = r#"
    [motion.fretting]
    load = "10.2 N"
    amplitude = ["0.04 um", "0.03 um"]
    phase = "1 rad"
    increments = 8
    "#;
const PUSHED: &str = r#"
    [motion.fretting]
    load = "10.2 N"
    force_amplitude = ["0.8 N", "0.5 N"]
    phase = "1 rad"
    increments = 8
    "#;
const PRESSED: &str = r#"
    [motion.indentation]
    load = "10.2 N"
    increments = 4
    rubbing = "end"
    "#;

/// The table of the law.
fn friction(coefficients: [f64; 2], angle: f64) -> String {
    let [first, second] = coefficients;
    format!("[friction.orthotropic]\ncoefficients = [{first}, {second}]\nangle = \"{angle} deg\"\n")
}

fn rows(simulation: &Simulation) -> Rows {
    let mut rows = Rows::default();
    simulation.run(&mut [&mut rows]).expect("it converges");
    rows
}

/// The law itself.
fn law(coefficients: [f64; 2], angle: f64) -> Box<dyn Friction> {
    let mut values = Values::default();
    values.insert("coefficients", Value::Pair(coefficients));
    values.insert("angle", Value::Number(angle.to_radians()));
    let choice = FRICTION.iter().find(|choice| choice.name == "orthotropic").expect("a law");
    (choice.build)(&values).expect("valid values")
}

/// The place of the discs that spin among the kinds.
const SPINS: usize = 5;

/// Like and unlike bodies in all kinds of motion under Coulomb's law, mu = 0.3, half-spaces and a quarter of a meshed
/// block.
fn all_kinds() -> Vec<Simulation> {
    let block = format!("{ON_BLOCK}{}", PRESSED.replace("10.2 N", "200 N"));
    let spins = "creepage = 0.004\nlateral_creepage = 0.001\nspin = \"2 1/m\"";
    let kinds = [
        ball(false, 20) + FRETTING,
        ball(false, 20) + PUSHED,
        ball(true, 20) + FRETTING,
        ball(true, 20) + PUSHED,
        ball(true, 20) + PRESSED,
        discs(spins),
        discs("force = \"40 N\"\nlateral_force = \"20 N\""),
        block.replace("[friction_solver", "symmetry = [\"x\", \"y\"]\n[friction_solver"),
    ];
    kinds.map(|text| case(&format!("{text}\n[friction.coulomb]\ncoefficient = 0.3"), &[])).into()
}

/// The same simulation under another law.
fn under(friction: Box<dyn Friction>, mut simulation: Simulation) -> Simulation {
    simulation.problem.friction = Some(friction.into());
    simulation
}

/// Equal coefficients make Coulomb's law, to the last bit.
#[test]
fn equal_coefficients_are_coulombs() {
    let bits = |rows: &Rows| -> Vec<u64> {
        rows.0.iter().flatten().map(|(_, value)| value.to_bits()).collect()
    };
    for simulation in all_kinds() {
        let coulomb = rows(&simulation);
        let equal = rows(&under(law([0.3, 0.3], 40.0), simulation));
        assert_eq!(bits(&coulomb), bits(&equal));
    }
}

/// Coulomb's law, mu = 0.3, by way of a disc of another size.
#[derive(Debug)]
struct Scaled(f64);

impl Friction for Scaled {
    fn limit(&self, pressure: f64) -> f64 {
        0.3 / self.0 * pressure
    }

    fn map(&self) -> Map {
        Map::ellipse([self.0; 2], 0.3)
    }
}

/// The size of the disc makes no difference: the solution is that of Coulomb's law, though the solvers see another
/// problem.
#[test]
fn the_size_of_the_disc_makes_no_difference() {
    for (kind, simulation) in all_kinds().into_iter().enumerate() {
        let coulomb = states(&simulation).expect("it converges");
        let scaled = states(&under(Box::new(Scaled(3.0)), simulation)).expect("it converges");
        assert_same(&coulomb, &scaled, kind);
    }
}

/// A turn by 90 degrees is the exchange of both coefficients.
#[test]
fn ninety_degrees_swap_the_axes() {
    for (kind, simulation) in all_kinds().into_iter().enumerate() {
        let simulation = under(law([0.15, 0.5], 90.0), simulation);
        let turned = states(&simulation).expect("it converges");
        let swapped = states(&under(law([0.5, 0.15], 0.0), simulation)).expect("it converges");
        assert_same(&turned, &swapped, kind);
    }
}

/// Whether pressures and tractions are the same in all states, relative to the largest of them.
fn assert_same(one: &[Shown], other: &[Shown], kind: usize) {
    assert_eq!(one.len(), other.len());
    for ((one, ..), (other, ..)) in one.iter().zip(other) {
        let [one, other] = [one, other].map(|state| state.tractions().components().concat());
        let most = one.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        let off = one.iter().zip(&other).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        // How spin turns the slip follows from a solution to a thousand times the tolerance, 1e-7.
        let within = if kind == SPINS { 1e-5 } else { 2e-8 };
        assert!(off <= within * most, "{off:e} of {most:e} in kind {kind}");
    }
}

/// How far tractions and slips are from the law, whose axes lie at an angle (deg), at pairs that touched before: the most by which a traction exceeds the
/// ellipse, relative to its pressure; the slip where pairs stick and the part of it off the normal of the ellipse where
/// they slip, relative to the largest. With the numbers of pairs that stick and slip.
fn off_the_law(
    [before, state]: [&ContactState; 2],
    coefficients: [f64; 2],
    angle: f64,
) -> ([f64; 3], [usize; 2]) {
    let tangential = state.tangential.as_ref().expect("friction");
    let (sin, cos) = angle.to_radians().sin_cos();
    let own = |field: &[Vec<f64>; 2], pair: usize| {
        let [x, y] = [field[0][pair], field[1][pair]];
        [cos * x + sin * y, cos * y - sin * x]
    };
    let touches = |&pair: &usize| state.pressure[pair] > 0.0 && before.pressure[pair] > 0.0;
    let touching = (0..state.pressure.len()).filter(touches);
    let peak = state.pressure.iter().copied().fold(0.0, f64::max);
    let length = |[x, y]: [f64; 2]| x.hypot(y);
    let most = touching.clone().map(|pair| length(own(&tangential.slip, pair)));
    let most = most.fold(0.0, f64::max);
    let (mut off, mut counts) = ([0.0_f64; 3], [0; 2]);
    for pair in touching {
        let (pressure, [s1, s2]) = (state.pressure[pair], own(&tangential.slip, pair));
        let [t1, t2] = own(&tangential.traction, pair);
        let share = (t1 / coefficients[0]).hypot(t2 / coefficients[1]) / pressure;
        off[0] = off[0].max((share - 1.0) * pressure / peak);
        if share < 1.0 - 1e-6 {
            off[1] = off[1].max(length([s1, s2]) / most);
            counts[0] += 1;
            continue;
        }
        let normal = [t1 / coefficients[0].powi(2), t2 / coefficients[1].powi(2)];
        let unit = normal.map(|part| part / length(normal));
        let (along, across) = (s1 * unit[0] + s2 * unit[1], s2 * unit[0] - s1 * unit[1]);
        off[2] = off[2].max((across.abs() + (-along).max(0.0)) / most);
        counts[1] += 1;
    }
    (off, counts)
}

/// Every state of bodies that are shifted or pressed obeys the law: no traction beyond the ellipse, no slip inside it, and
/// slip along its normal where a pair is on it.
#[test]
#[ignore = "long: in .ci/long"]
fn slip_dissipates_most() {
    let curved = format!("{ON_CYLINDER}\n{}", PRESSED.replace("10.2 N", "500 N"));
    let pushed = FRETTING.replace("10.2 N", "500 N").replace("0.04", "0.5").replace("0.03", "0.4");
    let kinds = [
        (ball(false, 20) + FRETTING, true),
        (ball(false, 20) + PUSHED, true),
        (ball(true, 20) + FRETTING, true),
        (ball(true, 20) + PRESSED, true),
        (format!("{ON_BLOCK}\n{}", PRESSED.replace("10.2 N", "200 N")), true),
        (curved, true),
        (format!("{ON_CYLINDER}\n{pushed}"), true),
    ];
    let (coefficients, angle) = ([0.12, 0.4], 30.0);
    for (text, sticks) in kinds {
        let states = states(&case(&(friction(coefficients, angle) + &text), &[]));
        let states = states.expect("it converges");
        let mut counts = [0; 2];
        for pair in states.windows(2).filter(|pair| pair[0].0.load > 0.0) {
            let state = &pair[1].0;
            let (off, own) = off_the_law([&pair[0].0, state], coefficients, angle);
            assert!(off.iter().all(|off| *off < 1e-6), "{off:?} at {} in {text}", state.progress);
            (0..2).for_each(|kind| counts[kind] += own[kind]);
        }
        assert!(counts[1] > 0 && (counts[0] > 0) == sticks, "{counts:?} in {text}");
    }
}

/// Force on body 1 (N) where all slides along a direction at an angle (deg): p M^2 s / |M s| in the axes of the law.
fn sliding_force(load: f64, coefficients: [f64; 2], angle: f64, direction: f64) -> [f64; 2] {
    let (sin, cos) = (direction - angle).to_radians().sin_cos();
    let [first, second] = [coefficients[0] * cos, coefficients[1] * sin];
    let [t1, t2] = [coefficients[0] * first, coefficients[1] * second]
        .map(|part| load * part / first.hypot(second));
    let (sin, cos) = angle.to_radians().sin_cos();
    [cos * t1 - sin * t2, sin * t1 + cos * t2]
}

/// The states of bodies that are led along a line at an angle (deg) until all slides.
fn dragged(text: &str, load: f64, distance: f64, direction: f64) -> (ContactProblem, ContactState) {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("path.csv");
    let (sin, cos) = direction.to_radians().sin_cos();
    let [x, y] = [distance * cos, distance * sin];
    let table = format!("time_s,load_N,shift_x_um,shift_y_um\n0,{load},0,0\n1,{load},{x},{y}\n");
    std::fs::write(&file, table).expect("a file");
    let motion = format!("[motion.path]\nfile = {file:?}\nincrements = 8");
    let simulation = case(&format!("{text}\n{motion}"), &[]);
    let mut states = states(&simulation).expect("it converges");
    let (last, ..) = states.pop().expect("a state");
    (simulation.problem, last)
}

/// Dragged along x over an ellipse at 45 degrees the bodies are pushed sideways as well, as they are in any other
/// direction: like and unlike half-spaces and a meshed block.
#[test]
fn a_force_across_the_slip() {
    let coefficients = [0.1, 0.65];
    for (text, [load, distance], angle, direction) in [
        (ball(false, 20), [10.2, 4.0], 45.0, 0.0),
        (ball(false, 20), [10.2, 4.0], 20.0, 130.0),
        (ball(true, 20), [10.2, 4.0], 45.0, 0.0),
        (ball(true, 20), [10.2, 4.0], 20.0, 130.0),
        (ON_BLOCK.to_owned(), [200.0, 40.0], 45.0, 0.0),
    ] {
        let text = friction(coefficients, angle) + &text;
        let (problem, state) = dragged(&text, load, distance, direction);
        let tangential = state.tangential.as_ref().expect("friction");
        let found = tangential.force(&problem.frame);
        let expected = sliding_force(load, coefficients, angle, direction);
        for axis in 0..2 {
            assert_relative_eq!(found[axis], expected[axis], epsilon = 1e-6 * load);
        }
        assert_eq!(tangential.stick_area(&problem, &state.pressure), 0.0);
    }
}

/// Friction dissipates the work of the forces on the shifts and of the load on the approach, less what the bodies store:
/// to rounding in like bodies, whose pressures do not change.
#[test]
fn the_loops_enclose_the_energy() {
    for (rigid, within) in [(false, 1e-9), (true, 1e-4)] {
        let motion = FRETTING.replace("increments = 8", "increments = 24");
        let simulation = case(&(friction([0.12, 0.4], 30.0) + &ball(rigid, 24) + &motion), &[]);
        let (problem, states) = (&simulation.problem, states(&simulation).expect("it converges"));
        let stored = |state: &ContactState| {
            let tractions = state.tractions();
            let displacement = problem.compliance.apply(&tractions);
            let work = tractions.components().into_iter().zip(displacement.components());
            0.5 * work.map(|(t, u)| dot(t, u)).sum::<f64>() * problem.frame.element_area()
        };
        let mut work = 0.0;
        for pair in states.windows(2) {
            let [before, after] = [&pair[0].0, &pair[1].0];
            let ends = [before, after].map(|state| state.tangential.as_ref().expect("friction"));
            let forces = ends.map(|end| end.force(&problem.frame));
            let along = |axis: usize| {
                let moved = ends[1].shift[axis] - ends[0].shift[axis];
                0.5 * (forces[0][axis] + forces[1][axis]) * moved
            };
            work += along(0) + along(1) + after.load * (after.approach - before.approach);
        }
        let ([first, ..], [.., last]) = (&states[..], &states[..]) else { panic!("no states") };
        let dissipated = last.1.dissipated[1];
        assert!(dissipated > 1e-9);
        assert_relative_eq!(
            work - stored(&last.0) + stored(&first.0),
            dissipated,
            max_relative = within
        );
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Discs that slide all over as they roll: the forces are those of the ellipse, across the direction of rolling too, and
/// what is worn a revolution is k times the load times the creepage.
#[test]
fn saturated_rolling_is_full_sliding() {
    let coefficients = [0.6, 0.3];
    for angle in [0.0, 45.0, 90.0, -30.0] {
        for (creepage, lateral) in [(0.2, 0.0), (0.1, -0.15)] {
            let motion = format!("creepage = {creepage}\nlateral_creepage = {lateral}");
            let rows = rows(&case(&(friction(coefficients, angle) + &discs(&motion)), &[]));
            let direction = f64::atan2(lateral, creepage).to_degrees();
            let expected = sliding_force(300.0, coefficients, angle, direction);
            for (column, expected) in ["force_x_N", "force_y_N"].into_iter().zip(expected) {
                let found = rows.last(column);
                assert_relative_eq!(found, expected, epsilon = 300.0 * 2e-3);
            }
            let worn = rows.last("worn_section_one_m2");
            let expected = 2.0 * 1e-16 * 300.0 * f64::hypot(creepage, lateral);
            assert_relative_eq!(worn, expected, max_relative = 2e-4);
        }
    }
}

/// Total depth (mm) that C. Julia and L. Rodriguez-Tembleque, Int. J. Mech. Sci. (2025), doi
/// 10.1016/j.ijmecsci.2025.110195, section 8.2, find after 2500 revolutions of discs under 300 N and 0.5 % creepage, read off
/// a figure: axes along and across the direction of rolling, and the coefficient of wear along it (1/MPa). The contact slips
/// partly.
const DEPTHS: [(f64, f64, &str); 2] = [(0.0, 0.0074, "2e-6"), (90.0, 0.0050, "1e-6")];

/// Worn discs of the publication; nothing pushes them sideways along the axes.
#[test]
fn worn_discs_are_those_published() {
    for (angle, depth, wear) in DEPTHS {
        let text = discs("creepage = 0.005")
            .replace("1e-16 1/Pa", &format!("{wear} 1/MPa"))
            .replace("[\"0.66 mm\", \"1.0 mm\"]", "[\"0.7 mm\", \"2.8 mm\"]")
            .replace("[33, 25]", "[25, 49]")
            .replace("revolutions = 2\n", "revolutions = 2500\n")
            .replace("step = 1\n", "step = 250\n");
        let rows = rows(&case(&(friction([0.6, 0.3], angle) + &text), &[]));
        assert_relative_eq!(rows.last("wear_depth_m"), 1e-3 * depth, max_relative = 0.2);
        assert!(rows.last("force_y_N").abs() < 1e-6 * rows.last("force_x_N"));
    }
}
