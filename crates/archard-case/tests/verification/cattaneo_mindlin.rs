//! Partial slip of a sphere (Cattaneo, Mindlin, Deresiewicz): the reference contact R = 50 mm, 10.2 N,
//! steel on steel, mu = 0.3.

use approx::assert_relative_eq;
use archard::closed_form::cattaneo_mindlin::{Branch, Oscillation, PartialSlip};
use archard::motion::Drive;
use archard::problem::{ContactProblem, ContactState};

use crate::common::{Rows, STEEL, case, states};

/// Tangential force (N) of the reference: half of what friction bears.
const FORCE: f64 = 1.53;
/// Shift (m) that makes it.
const SHIFT: &str = "0.05993896 um";

fn contact() -> PartialSlip {
    PartialSlip::new(0.05, [Some(&STEEL); 2], 10.2, 0.3).expect("a contact")
}

/// The contact on so many elements along a side of 2.4 a, in a motion under the load.
pub fn sphere(elements: usize, poisson: f64, motion: &str) -> String {
    let material = format!(r#"{{ young = "210 GPa", poisson = {poisson} }}"#);
    format!(
        r#"
        [body.ball]
        material = {material}
        profile.sphere = {{ radius = "50 mm" }}
        [body.flat]
        material = {material}
        profile.flat = {{}}
        [frame]
        size = ["0.357854 mm", "0.357854 mm"]
        elements = [{elements}, {elements}]
        [friction.coulomb]
        coefficient = 0.3
        [friction_solver.newton]
        tolerance = 1e-9
        [motion.fretting]
        load = "10.2 N"
        {motion}
        "#
    )
}

fn rows(text: &str) -> Rows {
    let mut rows = Rows::default();
    case(text, &[]).run(&mut [&mut rows]).expect("it converges");
    rows
}

/// Two cycles on the elements of the reference, 128 along a side.
fn two_cycles() -> Rows {
    rows(&sphere(
        128,
        0.3,
        &format!(
            r#"amplitude = ["{SHIFT}", "0 um"]
        cycles = 2
        increments = 40"#
        ),
    ))
}

/// The way on which a swing is; at its turns the one that ends there.
fn branch(cycle: f64) -> Branch {
    let unloads = (cycle - 0.25 - 1e-9).rem_euclid(1.0) < 0.5;
    if unloads { Branch::Unloading } else { Branch::Reloading }
}

/// The state of a swing at a shift: the force (N) and the radius (m) beyond which it has slipped since its
/// last turn.
fn of_swing(swing: &Oscillation, cycle: f64, shift: f64) -> (f64, f64) {
    if cycle <= 0.25 {
        let force = contact().force(shift);
        return (force, contact().stick_radius(force));
    }
    let branch = branch(cycle);
    let force = swing.force(branch, shift);
    (force, swing.stick_radius(branch, force))
}

/// On the way there, back (Mindlin and Deresiewicz) and again. The force lies some 4e-4 above Mindlin's:
/// half-spaces with a Poisson ratio other than zero slip a little across the force too, which his traction
/// leaves out, so that less slips along it. The edge of the stick zone runs between whole elements.
#[test]
fn forces_and_stick_zones_are_mindlins() {
    let swing = contact().oscillation(FORCE);
    let rows = two_cycles();
    let columns =
        ["cycle", "shift_x_m", "force_x_N", "stick_area_m2"].map(|name| rows.column(name));
    let element = 0.357854e-3 / 128.0;
    for row in 1..columns[0].len() {
        let [cycle, shift, force, area] = columns.each_ref().map(|column| column[row]);
        let (expected, stick_radius) = of_swing(&swing, cycle, shift);
        let bound = if cycle <= 0.25 { expected } else { FORCE };
        assert!((force - expected).abs() <= 5e-4 * bound, "{force} N for {expected} N at {cycle}");
        let found = (area / std::f64::consts::PI).sqrt();
        assert!((found - stick_radius).abs() < element, "{found} for {stick_radius} at {cycle}");
    }
}

/// Without a Poisson ratio nothing slips across the force and Mindlin's solution is the exact one: what is
/// left is the grid: measured 5e-4 of the force on 32 elements, 1.4e-5 on 128.
#[test]
fn without_a_poisson_ratio_mindlin_is_exact() {
    let steel = archard::body::Material { young: 210e9, poisson: 0.0 };
    let contact = PartialSlip::new(0.05, [Some(&steel); 2], 10.2, 0.3).expect("a contact");
    let off = |elements: usize| {
        let motion = format!(r#"amplitude = ["{SHIFT}", "0 um"]"#);
        let rows = rows(&sphere(elements, 0.0, &motion));
        let [shifts, forces] = ["shift_x_m", "force_x_N"].map(|name| rows.column(name));
        // Row 0 is the contact before the shift; a quarter of 20 increments leads to the amplitude.
        let off = (1..=5).map(|row| forces[row] / contact.force(shifts[row]) - 1.0);
        off.fold(0.0, |most: f64, off| most.max(off.abs()))
    };
    let [coarse, fine] = [32, 128].map(off);
    assert!(fine < 3e-5 && coarse < 1e-3, "{coarse:e} and {fine:e}");
}

/// Friction takes the mean of the tractions before and after an increment; with 40 increments a cycle the
/// chords of the loop enclose 0.8 % less than its arcs.
#[test]
#[ignore = "long: in .ci/long"]
fn the_loop_encloses_the_energy() {
    let rows = two_cycles();
    let cycle = rows.column("cycle");
    let [shift, force] = ["shift_x_m", "force_x_N"].map(|name| rows.column(name));
    let expected = contact().dissipation(FORCE);
    assert_relative_eq!(rows.last("dissipated_J"), expected, max_relative = 0.01);
    // What is dissipated is the work of the force on the shift.
    let second = cycle.iter().position(|&cycle| cycle == 1.0).expect("the end of the first cycle");
    let work: f64 = (second + 1..cycle.len())
        .map(|row| 0.5 * (force[row] + force[row - 1]) * (shift[row] - shift[row - 1]))
        .sum();
    // The second loop is not quite closed yet, by 3e-6 of the force: see `loops_close`.
    assert_relative_eq!(work, rows.last("dissipated_J"), max_relative = 1e-5);
}

fn contact_at(elements: usize, motion: &str) -> (ContactProblem, Vec<ContactState>) {
    let simulation = case(&sphere(elements, 0.3, motion), &[]);
    let states = states(&simulation).expect("it converges");
    (simulation.problem, states.into_iter().map(|(state, ..)| state).collect())
}

/// The tractions at +Q and at rest on the way back, away from the edges of contact and stick, where they
/// have infinite slopes: within 0.2 % of mu p0. Across the force tractions only hold what would slip that way, up
/// to 0.09 mu p0 in places that have slipped.
#[test]
fn tractions_are_mindlins() {
    let motion = format!("amplitude = [\"{SHIFT}\", \"0 um\"]");
    let (problem, states) = contact_at(128, &motion);
    let contact = contact();
    let swing = contact.oscillation(FORCE);
    let element = problem.frame.spacing()[0];
    // Increments 5 and 10 of 20: the amplitude, and no shift on the way back.
    for (index, back) in [(5, false), (10, true)] {
        let tangential = states[index].tangential.as_ref().expect("friction");
        let force = tangential.force(&problem.frame)[0];
        let limit = contact.friction * contact.peak_pressure;
        let edges = [
            contact.contact_radius,
            contact.stick_radius(FORCE),
            swing.stick_radius(Branch::Unloading, force),
        ];
        let (mut across, mut most) = (0.0f64, 0.0f64);
        for pair in 0..problem.frame.len() {
            let [x, y] = problem.frame.place(pair);
            let r = x.hypot(y);
            let expected = match back {
                true => swing.traction(Branch::Unloading, r, force),
                false => contact.traction(r, force.min(FORCE)),
            };
            let off = (tangential.traction[0][pair] - expected).abs() / limit;
            if edges.iter().all(|edge| (edge - r).abs() > 2.0 * element) {
                most = most.max(off);
                assert!(off < 2e-3, "{off} at {r} of {edges:?}");
            }
            across = across.max(tangential.traction[1][pair].abs() / limit);
        }
        assert!(across < 0.1, "{across}");
    }
}

/// Forces at the quarters of ten cycles.
fn quarters(poisson: f64) -> Vec<[f64; 4]> {
    let motion = format!("amplitude = [\"{SHIFT}\", \"0 um\"]\ncycles = 10\nincrements = 12");
    let rows = rows(&sphere(48, poisson, &motion));
    let forces = rows.column("force_x_N");
    let cycle = |index: usize| [3, 6, 9, 12].map(|increment| forces[12 * index + increment]);
    (0..10).map(cycle).collect()
}

fn apart(one: &[f64; 4], other: &[f64; 4]) -> f64 {
    one.iter().zip(other).map(|(a, b)| (a - b).abs() / FORCE).fold(0.0, f64::max)
}

/// Loops close at once without a Poisson ratio. With one, the slip across the force shakes down: what the
/// loop still moves by halves from cycle to cycle.
#[test]
fn loops_close() {
    let cycles = quarters(0.0);
    for cycle in &cycles[1..] {
        assert!(apart(cycle, &cycles[1]) < 1e-8, "{cycle:?}");
    }
    let cycles = quarters(0.3);
    let moved: Vec<f64> = cycles.windows(2).map(|pair| apart(&pair[0], &pair[1])).collect();
    assert!(moved[1] < 1e-5 && moved[8] < 1e-7, "{moved:?}");
    assert!(moved.windows(2).all(|pair| pair[1] < 0.7 * pair[0]), "{moved:?}");
}

/// The force given instead: the shift lies 4.5e-4 below Mindlin's, as there it grows 1.14 times as fast as the
/// force, both relative to themselves.
#[test]
fn forces_given_make_mindlins_shifts() {
    let motion = r#"force_amplitude = ["1.53 N", "0 N"]"#;
    let swing = contact().oscillation(FORCE);
    let rows = rows(&sphere(128, 0.3, motion));
    let columns = ["cycle", "shift_x_m", "force_x_N"].map(|name| rows.column(name));
    let asked = case(&sphere(8, 0.3, motion), &[]).problem.motion;
    let stations = &asked.increments().expect("increments").cycle;
    for row in 1..columns[0].len() {
        let [cycle, shift, force] = columns.each_ref().map(|column| column[row]);
        assert_eq!(stations[row - 1].guides[1], Drive::Force(0.0));
        let Drive::Force(asked) = stations[row - 1].guides[0] else { panic!("a force") };
        assert_relative_eq!(force, asked, epsilon = 1e-8 * FORCE);
        let expected = match cycle <= 0.25 {
            true => contact().shift(force),
            false => swing.shift(branch(cycle), force),
        };
        let off = (shift - expected).abs() / swing.shift_amplitude();
        assert!(off < 7e-4, "{shift} for {expected} at {cycle}: {off:e}");
    }
}

/// Along y as along x: the same contact turned, to what the friction solver leaves.
#[test]
fn the_direction_of_the_shift_makes_no_difference() {
    for (along_x, along_y) in [
        (r#"amplitude = ["0.06 um", "0 um"]"#, r#"amplitude = ["0 um", "0.06 um"]"#),
        (r#"force_amplitude = ["1.53 N", "0 N"]"#, r#"force_amplitude = ["0 N", "1.53 N"]"#),
    ] {
        let along_y = format!("{along_y}\nphase = \"0 deg\"");
        let [x, y] = [along_x, &along_y].map(|motion| rows(&sphere(31, 0.3, motion)));
        for (one, other) in [("force_x_N", "force_y_N"), ("shift_x_m", "shift_y_m")] {
            let (one, other) = (x.column(one), y.column(other));
            let scale = one.iter().copied().fold(0.0, f64::max);
            for (one, other) in one.iter().zip(&other) {
                assert_relative_eq!(one, other, epsilon = 1e-7 * scale);
            }
        }
        let energies = [&x, &y].map(|rows| rows.last("dissipated_J"));
        assert_relative_eq!(energies[0], energies[1], max_relative = 1e-6);
    }
}

/// Round a circle: the force turns with the shift, a quarter of the path later it is the same turned by a
/// right angle; the path closes and dissipates the work done. After two rounds it still moves by 2e-5 of the
/// force from one to the next, as straight paths do.
#[test]
fn a_circular_path_turns_the_force() {
    let amplitude = format!("amplitude = [\"{SHIFT}\", \"{SHIFT}\"]");
    let motion = format!("{amplitude}\nphase = \"90 deg\"\ncycles = 3\nincrements = 20");
    let rows = rows(&sphere(48, 0.3, &motion));
    let at = |x: &str, y: &str| -> Vec<[f64; 2]> {
        rows.column(x).into_iter().zip(rows.column(y)).map(|(x, y)| [x, y]).collect()
    };
    let (shift, force) = (at("shift_x_m", "shift_y_m"), at("force_x_N", "force_y_N"));
    let last = force.len() - 1;
    let largest = force[last][0].hypot(force[last][1]);
    let off = (last - 15..=last).map(|row| {
        let ([x, y], [earlier_x, earlier_y]) = (force[row], force[row - 5]);
        // Along y ahead of x by a quarter: the path runs clockwise.
        (x - earlier_y).hypot(y + earlier_x) / largest
    });
    let turned = off.fold(0.0, f64::max);
    let closed = (force[last][0] - force[last - 20][0]).hypot(force[last][1] - force[last - 20][1]);
    assert!(turned < 1e-4 && closed < 1e-4 * largest, "{turned:e} and {closed:e}");
    let work: f64 = (last - 19..=last)
        .map(|row| {
            let along = |axis: usize| {
                let mean = 0.5 * (force[row][axis] + force[row - 1][axis]);
                mean * (shift[row][axis] - shift[row - 1][axis])
            };
            along(0) + along(1)
        })
        .sum();
    assert!(work > contact().dissipation(FORCE));
    assert_relative_eq!(work, rows.last("dissipated_J"), max_relative = 1e-4);
}
