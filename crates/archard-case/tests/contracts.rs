//! What every implementation of a trait owes: one suite a trait, one line a newcomer.

mod common;
mod contracts {
    mod element;
    mod friction;
    mod mesh;
    mod rolling;
    mod shift;
    mod tied;
    mod worn_lines;
}

use approx::assert_relative_eq;
use archard::body::profile::PROFILES;
use archard::compliance::{Compliance, HalfSpace};
use archard::frame::VectorField;
use archard::motion::{Control, MOTIONS};
use archard::parameters::{Choice, Values};
use archard::solve::{SOLVERS, Status, Step};
use archard::wear::{
    Columns, Expression, Input, Map, Orthotropic, Over, Per, Rubbing, Table, WEAR_LAWS, WearLaw,
};

use common::{Ball, STEEL, at_rest, choose, solver};

/// Numbers (SI) to build each choice with.
type Examples = &'static [(&'static str, &'static [(&'static str, f64)])];

const PROFILE_EXAMPLES: Examples = &[
    ("sphere", &[("radius", 0.05)]),
    ("sphere", &[("radius", -0.05)]),
    ("cylinder", &[("radius", -0.01)]),
    ("ball", &[("radius", 0.014)]),
    ("socket", &[("radius", 0.0141)]),
    ("shaft", &[("radius", 0.01)]),
    ("bush", &[("radius", 0.01005)]),
    ("disc", &[("radius", -0.0325), ("crown", -0.125)]),
    ("paraboloid", &[("radius_x", 0.02), ("radius_y", -0.3)]),
    ("cylinder", &[("radius", 0.01)]),
    ("disc", &[("radius", 0.0325), ("crown", 0.125)]),
    ("flat", &[]),
    ("flat_end", &[("radius", 0.001)]),
    ("power", &[("coefficient", 0.005), ("exponent", 2.0)]),
    ("axisymmetric_power", &[("coefficient", 0.005), ("exponent", 2.0)]),
    ("axisymmetric_power", &[("coefficient", 0.02), ("exponent", 1.0)]),
    ("wave", &[("amplitude", 1e-6), ("length_x", 1e-3), ("length_y", 2e-3)]),
];
/// Profiles that need more than numbers or touch elsewhere, tested next to their code.
const OTHER_PROFILES: &[&str] = &["table", "self_affine"];

const WEAR_EXAMPLES: Examples = &[
    ("archard", &[("coefficient", 1.33e-13)]),
    ("archard", &[("k_ad", 1e-4), ("hardness", 2e9)]),
    ("energy", &[("coefficient", 1e-13)]),
    ("energy", &[("coefficient", 1e-13), ("threshold", 1e6)]),
    ("power", &[("coefficient", 1e-13), ("pressure_exponent", 1.3), ("reference_pressure", 1e8)]),
    (
        "power",
        &[
            ("coefficient", 1e-13),
            ("pressure_exponent", 0.7),
            ("reference_pressure", 1e8),
            ("speed_exponent", -0.5),
            ("reference_speed", 0.3),
        ],
    ),
    ("threshold", &[("coefficient", 1e-13), ("threshold", 3e7)]),
    (
        "running_in",
        &[
            ("initial_coefficient", 5e-13),
            ("final_coefficient", 1e-13),
            ("running_in_distance", 0.2),
        ],
    ),
    ("t_gamma", &[("density", 7850.0)]),
    (
        "cross_shear",
        &[
            ("unidirectional_coefficient", 1e-16),
            ("multidirectional_coefficient", 5e-16),
            ("exponent", 0.2),
        ],
    ),
];

/// Laws that need more than numbers.
fn other_wear_laws() -> Vec<(&'static str, Box<dyn WearLaw>)> {
    let table = |over, places: [f64; 2]| {
        Box::new(Table::new(over, &places, &[3e-13, 2e-13]).expect("a table")) as _
    };
    let orthotropic = Orthotropic::new([3e-13, 1e-13], 0.4).expect("coefficients");
    let expression = |formula, constants: &[(&str, &str)], per| {
        Box::new(Expression::new(formula, constants, per).expect("a law")) as _
    };
    let k = ("k", "1e-13 1/Pa");
    let cycle = [k, ("p0", "30 MPa"), ("v0", "1 m/s"), ("w0", "1e5 J/m^2"), ("r0", "2 m")];
    vec![
        ("orthotropic", Box::new(orthotropic)),
        ("expression", expression("k*p*s", &[k], Per::Increment)),
        (
            "expression",
            expression(
                "k*p*s0*(1 - exp(-s/s0))*exp(-distance/s0)",
                &[k, ("s0", "0.2 m")],
                Per::Increment,
            ),
        ),
        (
            "expression",
            expression(
                "k*max(work - w0, 0)*mu*(p/p0)^0.3*(v/v0)^0.1*(1 + worn/r0 + rolled/r0)",
                &cycle,
                Per::Cycle,
            ),
        ),
        ("table", table(Over::Distance, [0.1, 0.5])),
        ("table", table(Over::Depth, [1e-8, 1e-6])),
        ("table", table(Over::Pressure, [3e7, 1e9])),
        ("table", table(Over::Speed, [0.01, 1.0])),
        ("map", Box::new(Map::new(2.5e9, &[[0.0, 0.0, 1e-4], [0.8, 0.0, 3e-4]]).expect("a map"))),
        ("table", table(Over::Temperature, [300.0, 600.0])),
        (
            "expression",
            expression("k*p*s*exp(-t0/temperature)", &[k, ("t0", "500 K")], Per::Increment),
        ),
    ]
}

const MOTION_EXAMPLES: Examples = &[
    ("indentation", &[("approach", 1e-6), ("increments", 5.0)]),
    ("indentation", &[("load", 10.2), ("increments", 5.0), ("cycles", 20.0), ("jump", 4.0)]),
    ("sliding", &[("load", 10.2), ("distance", 0.5), ("step", 0.005)]),
    ("sliding", &[("load", 10.2), ("distance", 0.5), ("tolerance", 1e-3)]),
    ("rotation", &[("load", 10.2), ("revolutions", 100.0), ("step", 5.0)]),
    ("rotation", &[("load", 10.2), ("amplitude", 0.1), ("cycles", 300.0), ("tolerance", 1e-3)]),
    ("rolling", &[("load", 300.0), ("creepage", 5e-3), ("revolutions", 3e4), ("step", 100.0)]),
    ("rolling", &[("load", 300.0), ("force", -90.0), ("revolutions", 3e4), ("tolerance", 3e-3)]),
    ("creepage_sweep", &[("load", 300.0), ("spin", 0.2), ("increments", 5.0)]),
];

/// Motions that need more than numbers: see `contracts/shift.rs`, `crates/archard/tests/stations.rs` and their own tests.
const OTHER_MOTIONS: &[&str] = &["fretting", "path", "table", "joint"];

fn all_have_examples<T>(list: &[Choice<T>], examples: Examples, others: &[&str]) {
    for choice in list {
        let known = examples.iter().any(|example| example.0 == choice.name)
            || others.contains(&choice.name);
        assert!(known, "`{}` needs a line in the contract list", choice.name);
    }
}

#[test]
fn profiles_touch_at_the_centre_with_the_curvatures_they_state() {
    all_have_examples(PROFILES, PROFILE_EXAMPLES, OTHER_PROFILES);
    for (name, numbers) in PROFILE_EXAMPLES {
        let profile = choose(PROFILES, name, numbers);
        assert_eq!(profile.recess(0.0, 0.0), 0.0, "{name}");
        assert_eq!(profile.recess(1e-4, 2e-4), profile.recess(-1e-4, -2e-4), "{name}");
        if let Some([along_x, along_y]) = profile.curvatures() {
            let h = 1e-5;
            assert_relative_eq!(
                2.0 * profile.recess(h, 0.0) / (h * h),
                along_x,
                max_relative = 1e-6
            );
            assert_relative_eq!(
                2.0 * profile.recess(0.0, h) / (h * h),
                along_y,
                max_relative = 1e-6
            );
        }
    }
}

#[test]
fn wear_laws_grow_with_pressure_and_know_their_slope() {
    let others = other_wear_laws();
    let names: Vec<&str> = others.iter().map(|(name, _)| *name).collect();
    all_have_examples(WEAR_LAWS, WEAR_EXAMPLES, &names);
    let examples = WEAR_EXAMPLES.iter();
    let examples = examples.map(|(name, numbers)| (*name, choose(WEAR_LAWS, name, numbers)));
    for (name, law) in examples.chain(others) {
        let rubbing = |pressure: f64, slip: f64| {
            Rubbing::new(pressure, slip)
                .with_friction(0.4 * pressure * slip, 0.4)
                .with_vectors([0.8 * slip, 0.6 * slip], [0.32 * pressure, 0.24 * pressure])
                .at_speed(0.1)
                .at_temperature(400.0)
                .rolling(4.0 * slip)
        };
        let depth = |pressure: f64, slip: f64| law.depth(rubbing(pressure, slip));
        assert!(depth(3e9, 0.3) > 0.0, "{name}: the example wears nothing");
        assert_eq!(depth(0.0, 1.0), 0.0, "{name}");
        assert_eq!(depth(1e8, 0.0), 0.0, "{name}");
        for pressure in [0.0, 1e6, 1e8, 3e9] {
            let change = 1e-4 * f64::max(pressure, 1.0);
            let slope = law.slope(rubbing(pressure, 0.3));
            let rise = depth(pressure + change, 0.3) - depth(pressure, 0.3);
            assert!(slope >= 0.0 && rise >= 0.0, "{name}");
            assert_relative_eq!(rise / change, slope, max_relative = 1e-3);
            if law.per() == Per::Increment && !law.inputs().contains(&Input::Depth) {
                let first = depth(pressure, 0.3);
                let second = law.depth(rubbing(pressure, 0.3).after(0.3, first));
                let both = depth(pressure, 0.6);
                assert_relative_eq!(1e6 * both, 1e6 * (first + second), max_relative = 1e-12);
            }
        }
        let pressures = [0.0, 1e6, 1e8, 3e9];
        let points = pressures.map(|p| rubbing(p, 0.3).after(0.2, 1e-7));
        let points = Columns::of(points, law.inputs());
        let (mut depths, mut slopes) = ([f64::NAN; 4], [f64::NAN; 4]);
        law.depths(&points, &mut depths, &mut slopes);
        for point in 0..points.len() {
            let rubbing = points.at(point);
            assert_eq!(depths[point], law.depth(rubbing), "{name}");
            assert_eq!(slopes[point], law.slope(rubbing), "{name}");
        }
    }
}

#[test]
fn motions_go_somewhere() {
    all_have_examples(MOTIONS, MOTION_EXAMPLES, OTHER_MOTIONS);
    for (name, numbers) in MOTION_EXAMPLES {
        let (motion, schedule) = choose(MOTIONS, name, numbers);
        assert!(schedule.extent > 0.0, "{name}");
        let slips = [0.0, 0.1, 0.2].map(|advance| motion.slip(advance));
        assert!(slips[0] == 0.0 && slips[1] >= 0.0 && slips[2] >= slips[1], "{name}");
        assert!(motion.progress.column.contains(char::is_alphabetic), "{name}");
    }
}

/// Pairs of that frame.
const PAIRS: usize = 48;

/// Every compliance, on one frame.
fn compliances() -> Vec<Box<dyn Compliance>> {
    let frame = Ball { elements: [8, 6], ..Ball::pin_on_disc(1) }.problem().frame;
    vec![
        Box::new(HalfSpace::new([Some(&STEEL), Some(&STEEL)], &frame)),
        Box::new(HalfSpace::new([Some(&STEEL), None], &frame)),
    ]
}

#[test]
fn compliances_are_linear_symmetric_and_positive() {
    for compliance in compliances() {
        let columns: Vec<Vec<f64>> = (0..PAIRS)
            .map(|pair| {
                let mut tractions = VectorField::zeros(PAIRS);
                tractions.n[pair] = 1.0;
                let mut normal = vec![0.0; PAIRS];
                compliance.apply_normal(&tractions.n, &mut normal);
                let rounding = 1e-12 * compliance.normal_self_term();
                for (a, b) in normal.iter().zip(&compliance.apply(&tractions).n) {
                    assert_relative_eq!(a, b, epsilon = rounding);
                }
                assert_relative_eq!(
                    normal[pair],
                    compliance.normal_self_term(),
                    max_relative = 1e-12
                );
                normal
            })
            .collect();
        let pressure: Vec<f64> = (0..PAIRS).map(|i| (i as f64).sin()).collect();
        let mut image = vec![0.0; PAIRS];
        compliance.apply_normal(&pressure, &mut image);
        for (row, value) in image.iter().enumerate() {
            let sum: f64 = columns.iter().zip(&pressure).map(|(column, p)| column[row] * p).sum();
            assert_relative_eq!(*value, sum, epsilon = 1e-12 * columns[0][0]);
            for (column, values) in columns.iter().enumerate() {
                assert_relative_eq!(
                    values[row],
                    columns[row][column],
                    epsilon = 1e-12 * columns[0][0]
                );
            }
        }
        let work: f64 = pressure.iter().zip(&image).map(|(p, u)| p * u).sum();
        assert!(work > 0.0);
    }
}

#[test]
fn preconditioners_are_symmetric_and_positive() {
    for compliance in compliances() {
        for addition in [0.0, 1e-14] {
            let preconditioner = compliance.normal_preconditioner(addition);
            let apply = |displacement: &[f64]| {
                let mut pressure = vec![0.0; PAIRS];
                preconditioner.apply(displacement, &mut pressure);
                pressure
            };
            let (a, b): (Vec<f64>, Vec<f64>) =
                (0..PAIRS).map(|i| ((i as f64).sin(), ((i * i) as f64).cos())).unzip();
            let dot = |a: &[f64], b: &[f64]| -> f64 { a.iter().zip(b).map(|(a, b)| a * b).sum() };
            let scale = (dot(&a, &apply(&a)) * dot(&b, &apply(&b))).sqrt();
            assert!((dot(&a, &apply(&b)) - dot(&b, &apply(&a))).abs() < 1e-13 * scale);
        }
    }
}

/// p >= 0, g >= 0, p g = 0 and the load, by every solver, with and without an addition.
#[test]
fn solvers_meet_the_contact_conditions() {
    let problem = Ball { size: [0.6e-3; 2], ..Ball::pin_on_disc(20) }.problem();
    for choice in SOLVERS {
        for added in [0.0, 5e-15] {
            let addition = vec![added; problem.frame.len()];
            let outcome = solver(choice.name, 1e-9)
                .solve(&at_rest(&problem, &addition, Control::Load(10.2)), None);
            assert_eq!(outcome.status, Status::Converged, "{}", choice.name);
            assert_relative_eq!(
                problem.frame.integrate(&outcome.pressure),
                10.2,
                max_relative = 1e-8
            );
            for (pressure, gap) in outcome.pressure.iter().zip(&outcome.gap) {
                assert!(*pressure >= 0.0 && *gap > -1e-8 * outcome.approach);
                assert!(*pressure == 0.0 || gap.abs() < 1e-8 * outcome.approach);
            }
        }
    }
}

/// An approach that leaves the bodies apart is an answer too.
#[test]
fn solvers_leave_bodies_apart() {
    let problem = Ball::pin_on_disc(10).problem();
    let addition = vec![0.0; 100];
    let gap: Vec<f64> = problem.frame.gap().iter().map(|gap| gap + 2e-6).collect();
    for choice in SOLVERS {
        let rest = at_rest(&problem, &addition, Control::Approach(1e-6));
        let outcome = solver(choice.name, 1e-8).solve(&Step { gap: &gap, ..rest }, None);
        assert_eq!(outcome.status, Status::Converged, "{}", choice.name);
        assert!(outcome.pressure.iter().all(|&pressure| pressure == 0.0));
        assert!(outcome.gap.iter().all(|&gap| gap >= 1e-6 * (1.0 - 1e-12)));
    }
}

#[test]
fn choices_say_what_they_miss() {
    for choice in PROFILES {
        if choice.parameters.iter().any(|parameter| parameter.required) {
            assert!((choice.build)(&Values::default()).is_err(), "{}", choice.name);
        }
    }
    for choice in MOTIONS {
        assert!((choice.build)(&Values::default()).is_err(), "{}", choice.name);
    }
}
