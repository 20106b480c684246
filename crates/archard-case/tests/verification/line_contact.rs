//! Contact along a line in plane strain.

use approx::assert_relative_eq;
use archard::body::contact_modulus;
use archard::body::{Body, Material, profile::Cylinder, profile::Flat};
use archard::closed_form::hertz::Line;
use archard::closed_form::{carter, free_rolling};
use archard::compliance::{Compliance, HalfSpace};
use archard::frame::{ContactFrame, VectorField};
use archard::problem::ContactState;
use archard::simulation::Simulation;

use crate::common::{Rows, STEEL, States, case};

const PI: f64 = std::f64::consts::PI;

/// Materials as TOML.
const STEELS: [&str; 2] = ["{ young = \"210 GPa\", poisson = 0.3 }"; 2];
const UNLIKE: [&str; 2] =
    ["{ young = \"210 GPa\", poisson = 0.3 }", "{ young = \"70 GPa\", poisson = 0.2 }"];

/// A cylinder of 40 mm on a flat, depths of 50 and 20 mm, in a frame that wide.
fn bodies(materials: [&str; 2], width: &str, elements: usize, rest: &str) -> String {
    format!(
        "body.roll = {{ material = {}, profile.cylinder = {{ radius = \"40 mm\", axis = \"y\" }}, depth = \"50 mm\" }}
         body.plate = {{ material = {}, profile.flat = {{}}, depth = \"20 mm\" }}
         frame = {{ size = \"{width}\", elements = {elements}, plane_strain = true }}
         solver.conjugate_gradient.tolerance = 1e-11
         {rest}",
        materials[0], materials[1]
    )
}

fn rows(text: &str) -> Rows {
    let mut rows = Rows::default();
    case(text, &[]).run(&mut [&mut rows]).expect("a run");
    rows
}

fn last(simulation: &Simulation) -> ContactState {
    let mut states = States::of(simulation);
    simulation.run(&mut [&mut states]).expect("a run");
    states.0.pop().expect("a state").0
}

fn line(materials: [Material; 2], load: f64) -> Line {
    let modulus = contact_modulus([Some(&materials[0]), Some(&materials[1])]);
    Line::from_load(1.0 / 40e-3, modulus, load).expect("a line")
}

const ALUMINIUM: Material = Material { young: 70e9, poisson: 0.2 };

/// Johnson's approach, eq. 5.58, by load and by approach, of like and unlike bodies.
#[test]
fn approach_and_pressure_are_johnsons() {
    for (written, materials) in [(STEELS, [STEEL; 2]), (UNLIKE, [STEEL, ALUMINIUM])] {
        let known = line(materials, 200e3);
        let approach = known.sinking(&materials[0], 50e-3) + known.sinking(&materials[1], 20e-3);
        for control in ["load = \"200 N/mm\"".to_owned(), format!("approach = \"{approach} m\"")] {
            let motion = format!("motion.indentation = {{ {control} }}");
            let found = rows(&bodies(written, "1 mm", 240, &motion));
            assert_relative_eq!(found.last("approach_m"), approach, max_relative = 1e-4);
            assert_relative_eq!(
                found.last("peak_pressure_Pa"),
                known.peak_pressure,
                max_relative = 1e-4
            );
            assert_relative_eq!(found.last("load_N"), 200e3, max_relative = 3e-4);
        }
    }
}

/// The same contact on a row of a very long frame of half-spaces: pressures, and tractions of unlike bodies.
#[test]
fn a_long_row_comes_to_the_same() {
    let width = 0.6e-3;
    let profiles: [&dyn archard::body::Profile; 2] = [&Cylinder::along_y(40e-3).unwrap(), &Flat];
    let materials = [Some(&STEEL), Some(&ALUMINIUM)];
    let line = ContactFrame::line([width, 1.0], [30, 1], profiles).unwrap();
    let row = ContactFrame::uniform([width, 10.0], [30, 1], profiles).unwrap();
    let strips = HalfSpace::plane_strain(materials, [&[]; 2], [1.0; 2], &line);
    let rectangles = HalfSpace::new(materials, &row);
    let wave = |k: f64| (0..30).map(|i| (0.7 * k + 0.4 * k * f64::from(i)).sin()).collect();
    let mut tractions = VectorField { t1: wave(1.0), t2: wave(1.3), n: wave(0.6) };
    // Without a resultant depths and lengths do not matter.
    for field in [&mut tractions.t1, &mut tractions.t2, &mut tractions.n] {
        let mean: f64 = field.iter().sum::<f64>() / 30.0;
        field.iter_mut().for_each(|value| *value -= mean);
    }
    let [one, other] = [strips.apply(&tractions), rectangles.apply(&tractions)];
    let scale = one.t1.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    for (one, other) in [(one.t1, other.t1), (one.t2, other.t2), (one.n, other.n)] {
        // A pressure whose moment does not vanish leaves a little of the ends of the row.
        for (one, other) in one.iter().zip(&other) {
            assert_relative_eq!(*one, *other, epsilon = 1e-5 * scale);
        }
    }
}

/// Cattaneo and Mindlin along a line: the stick zone, and the shift, measured from the depths (Johnson, section 7.2, and the
/// displacement of Flamant's tangential solution).
#[test]
fn partial_slip_is_cattaneos() {
    let (load, share, friction) = (200e3, 0.5, 0.6);
    let known = line([STEEL; 2], load);
    let motion = format!(
        "friction.coulomb.coefficient = {friction}
         motion.fretting = {{ load = \"200 N/mm\", force_amplitude = [\"{} N/mm\", \"0 N/mm\"], cycles = 1, increments = 40 }}
         friction_solver.newton.tolerance = 1e-9",
        1e-3 * share * friction * load
    );
    let found = rows(&bodies(STEELS, "1.2 mm", 160, &motion));
    let quarter = found.0.iter().position(|row| (value(row, "cycle") - 0.25).abs() < 1e-9);
    let row = &found.0[quarter.expect("a quarter")];
    let stick = known.half_width * (1.0 - share).sqrt();
    // Elements stick as a whole.
    assert_relative_eq!(value(row, "stick_area_m2"), 2.0 * stick, max_relative = 0.03);
    let surface = |load: f64, half_width: f64| -> f64 {
        let Material { young, poisson, .. } = STEEL;
        let one =
            |depth: f64| 2.0 * (2.0 * depth / half_width).ln() + (2.0 - poisson) / (1.0 - poisson);
        (1.0 - poisson * poisson) / (PI * young) * load * (one(50e-3) + one(20e-3))
    };
    let shift = friction * (surface(load, known.half_width) - surface(load * (1.0 - share), stick));
    assert_relative_eq!(value(row, "shift_x_m"), shift, max_relative = 3e-3);
    // From one turn of the force to the next the bodies keep what is elastic: friction dissipates all that the force works.
    let half = &found.0[quarter.expect("a quarter")..=3 * found.0.len() / 4];
    let columns = |row: &Vec<(String, f64)>| {
        ["force_x_N", "shift_x_m", "dissipated_J"].map(|column| value(row, column))
    };
    let work: f64 = half
        .windows(2)
        .map(|rows| {
            let [one, two] = [&rows[0], &rows[1]].map(columns);
            0.5 * (one[0] + two[0]) * (two[1] - one[1])
        })
        .sum();
    let dissipated = columns(&half[half.len() - 1])[2] - columns(&half[0])[2];
    assert_relative_eq!(work, dissipated, max_relative = 1e-6);
    // Of the loop of Masing's rule over the first loading.
    let most = share * friction * load;
    let first = |force: f64| {
        let sticks = 1.0 - force / (friction * load);
        friction
            * (surface(load, known.half_width)
                - surface(load * sticks, known.half_width * sticks.sqrt()))
    };
    let integral: f64 =
        (0..2000).map(|i| first(most * (f64::from(i) + 0.5) / 2000.0) * most / 2000.0).sum();
    let loop_of_masing = 2.0 * most * first(most) - 4.0 * integral;
    assert_relative_eq!(dissipated, loop_of_masing, max_relative = 3e-3);
}

fn value(row: &[(String, f64)], column: &str) -> f64 {
    archard::simulation::history::number(row, column).expect(column)
}

/// Carter at 80 elements.
#[test]
fn creep_forces_are_carters() {
    let (load, friction) = (200e3, 0.3);
    let known = line([STEEL; 2], load);
    let saturation = carter::saturation_creepage(friction, known.half_width, 40e-3);
    for share in [0.25, 0.5, 0.75] {
        let motion = format!(
            "friction.coulomb.coefficient = {friction}
             motion.rolling = {{ load = \"200 N/mm\", creepage = {}, revolutions = 0 }}",
            share * saturation
        );
        let width = format!("{} m", 2.2 * known.half_width);
        let found = rows(&bodies(STEELS, &width, 88, &motion)).last("force_x_N");
        let expected = friction * load * carter::relative_force(share);
        assert_relative_eq!(found, expected, max_relative = 5e-3);
    }
}

/// Bodies of unlike elasticity that roll freely creep by what their strains differ (Bentall and Johnson).
#[test]
fn unlike_bodies_creep() {
    let materials = [STEEL, ALUMINIUM];
    let known = line(materials, 200e3);
    let beta = archard::closed_form::spence::coupling([Some(&materials[0]), Some(&materials[1])]);
    let expected = free_rolling::creepage(beta, known.half_width, 40e-3);
    let motion = "friction.coulomb.coefficient = 0.001
         motion.rolling = { load = \"200 N/mm\", force = \"0 N/mm\", revolutions = 0 }";
    let found = rows(&bodies(UNLIKE, "1.2 mm", 160, motion)).last("creepage");
    assert_relative_eq!(found, expected, max_relative = 5e-3);
}

/// Bodies swapped; lengths four times as long under four times the load per length.
#[test]
fn swapped_and_scaled() {
    let text = |scale: f64, swapped: bool| {
        let roll = format!(
            "body.roll = {{ material = {}, profile.cylinder = {{ radius = \"{} mm\", axis = \"y\" }}, depth = \"{} mm\", wear.archard.coefficient = \"1e-15 1/Pa\" }}",
            UNLIKE[0],
            40.0 * scale,
            50.0 * scale
        );
        let plate = format!(
            "body.plate = {{ material = {}, profile.flat = {{}}, depth = \"{} mm\", wear.archard.coefficient = \"3e-15 1/Pa\" }}",
            UNLIKE[1],
            20.0 * scale
        );
        let [one, two] = if swapped { [&plate, &roll] } else { [&roll, &plate] };
        format!(
            "{one}\n{two}
             frame = {{ size = \"{} mm\", elements = 60, length = \"{} mm\" }}
             motion.sliding = {{ load = \"{} N/mm\", distance = \"{} m\", step = \"{} m\", surfaces = \"stay\" }}
             solver.conjugate_gradient.tolerance = 1e-11",
            2.0 * scale, 7.0 * scale, 200.0 * scale, scale, 0.1 * scale
        )
    };
    let [one, swapped, scaled] = [(1.0, false), (1.0, true), (4.0, false)]
        .map(|(scale, swapped)| rows(&text(scale, swapped)));
    for (column, power) in [
        ("approach_m", 1),
        ("peak_pressure_Pa", 0),
        ("wear_depth_roll_m", 1),
        ("wear_depth_plate_m", 1),
        ("worn_volume_roll_m3", 3),
    ] {
        let known = one.last(column);
        assert_relative_eq!(swapped.last(column) / known, 1.0, epsilon = 1e-9);
        assert_relative_eq!(scaled.last(column) / known, 4f64.powi(power), max_relative = 1e-9);
    }
    // 200 N/mm over 7 mm, 1 m, 1e-15 1/Pa.
    assert_relative_eq!(one.last("worn_volume_roll_m3") / 1.4e-12, 1.0, epsilon = 1e-9);
    assert_relative_eq!(one.last("load_N"), 1400.0, max_relative = 1e-9);
}

/// Deeper bodies approach further; what happens in the contact is the same.
#[test]
fn depths_change_the_approach_alone() {
    let steel = || STEEL;
    let run = |depth: f64| {
        let roll = Body::new("roll", Cylinder::along_y(40e-3).unwrap()).material(steel());
        let plate = Body::new("plate", Flat).material(steel()).depth(depth);
        let indentation = archard::motion::Indentation::new(1)
            .under(archard::motion::Control::Load(200e3))
            .unwrap();
        let builder = Simulation::builder([roll, plate], indentation).line([1.2e-3, 1.0], 60);
        last(&builder.build().unwrap())
    };
    let [shallow, deep] = [run(10e-3), run(80e-3)];
    let Material { young, poisson, .. } = STEEL;
    let more = (1.0 - poisson * poisson) / (PI * young) * 200e3 * 2.0 * 8f64.ln();
    assert_relative_eq!(deep.approach - shallow.approach, more, max_relative = 1e-6);
    for (one, other) in shallow.pressure.iter().zip(&deep.pressure) {
        assert_relative_eq!(*one, *other, epsilon = 1e-6 * 1e9);
    }
}

/// A cylinder of 10 mm, pressed on with 10 N/mm and shifted to and fro by a share of what friction bears.
fn fretting_by_force(friction: f64, share: f64, elements: usize) -> String {
    let half_width = (4.0 * 10e3 * 10e-3 / (PI * 210e9 / (2.0 * 0.91))).sqrt();
    format!(
        "body.roll = {{ material = {0}, profile.cylinder = {{ radius = \"10 mm\", axis = \"y\" }} }}
         body.plate = {{ material = {0}, profile.flat = {{}} }}
         frame = {{ size = \"{1} m\", elements = {elements}, plane_strain = true }}
         friction.coulomb.coefficient = {friction}
         motion.fretting = {{ load = \"10 N/mm\", force_amplitude = [\"{2} N/mm\", \"0 N/mm\"], cycles = 1 }}",
        STEELS[0],
        2.3 * half_width,
        10.0 * share * friction,
    )
}

/// Cattaneo's line sticks in sqrt(1 - Q / mu P) of the contact, whatever the friction, the force and the elements, which
/// follow a sequence that fills their ranges (M. Roberts, 2018).
#[test]
fn lines_fret_by_a_given_force_on_any_elements() {
    for number in 1..=12 {
        let at = |step: f64| (f64::from(number) * step).fract();
        let (friction, share) = (0.1 + 0.8 * at(0.618_034), 0.3 + 0.65 * at(0.754_878));
        let elements = 200 + (600.0 * at(0.569_84)) as usize;
        let rows = rows(&fretting_by_force(friction, share, elements));
        let last = |name: &str| *rows.column(name).last().expect("a row");
        let turning =
            rows.column("force_x_N").iter().fold(0.0, |most: f64, force| most.max(*force));
        assert_relative_eq!(turning, 10e3 * share * friction, max_relative = 1e-5);
        let sticks = rows.column("stick_area_m2").into_iter();
        let (area, stick) = (last("contact_area_m2"), sticks.skip(1).fold(f64::INFINITY, f64::min));
        // Counted in whole elements, one at either edge.
        let within = 2.0 * 2.3 / elements as f64 + 1e-3;
        assert!((stick / area - (1.0 - share).sqrt()).abs() < within, "{number}: {}", stick / area);
    }
}
