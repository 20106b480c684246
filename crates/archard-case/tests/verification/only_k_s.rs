//! Under a constant load and Holm-Archard's law the worn state follows from k s alone.

use std::error::Error;

use archard::simulation::history::{self, rescaled};
use archard::simulation::{Observer, Report, Simulation};
use archard_case::{Case, CaseFile};

/// The rows of the history, one a step.
#[derive(Default)]
struct Rows(Vec<Vec<(String, f64)>>);

impl Observer for Rows {
    fn observe(&mut self, report: &Report<'_>) -> Result<(), Box<dyn Error + Send + Sync>> {
        self.0.push(history::row(report));
        Ok(())
    }
}

fn rows(simulation: &Simulation) -> Vec<Vec<(String, f64)>> {
    let mut rows = Rows::default();
    simulation.run(&mut [&mut rows]).unwrap();
    rows.0
}

/// A published case with options, wear coefficients (1/Pa) of some bodies among them.
fn case(name: &str, options: &[&str], coefficients: &[(&str, f64)]) -> Case {
    let path = crate::framed::folder(name);
    let file = CaseFile::read(&path).unwrap();
    let file = options.iter().fold(file, |file, option| file.set(*option));
    let wear =
        |(body, k): &(&str, f64)| format!("body.{body}.wear.archard.coefficient=\"{k:e} 1/Pa\"");
    coefficients.iter().fold(file, |file, one| file.set(wear(one))).resolve().unwrap().case
}

/// The same to 1e-9 of either; what solves took is their own.
fn assert_alike(one: &[(String, f64)], other: &[(String, f64)]) {
    const EFFORT: [&str; 4] = ["iterations", "residual", "solves", "rejected"];
    assert_eq!(one.len(), other.len());
    let load = history::number(one, history::LOAD).unwrap();
    for ((column, one), (_, other)) in one.iter().zip(other) {
        let alike = (one - other).abs() <= 1e-9 * one.abs().max(other.abs());
        let of_effort = EFFORT.contains(&column.as_str()) || one.is_nan();
        // Forces across the motion, and the moment, are nothing but rounding.
        let force = column.ends_with("_N") || column == "moment_z_Nm";
        let nothing = force && one.abs().max(other.abs()) < 1e-9 * load;
        assert!(alike || of_effort || nothing, "{column}: {one:e} and {other:e}");
    }
}

/// Every state in which one run passes the end of another is that of the other run by itself, whose steps are as many.
fn assert_that_one_run_is_all(name: &str, options: &[&str], coefficients: &[(&str, f64)]) {
    const SHARES: [f64; 4] = [0.13, 0.4, 0.57, 1.0];
    let precise = [options, &["solver.conjugate_gradient.tolerance=1e-12"]].concat();
    let largest = case(name, &precise, coefficients);
    let known = largest.wears_by_k_s().unwrap();
    let mut one = largest.build().unwrap();
    let fixed = largest.motion.values.get("step").is_some();
    one.schedule = one.schedule.through(&SHARES);
    let all = rows(&one);
    for share in SHARES {
        let place = share * one.schedule.extent;
        let at = all.iter().find(|row| (row[0].1 - place).abs() <= 1e-12 * place);
        let told = rescaled(at.unwrap(), share);
        let scaled: Vec<_> = coefficients.iter().map(|(body, k)| (*body, share * k)).collect();
        let other = case(name, &precise, &scaled);
        let kind = other.wears_by_k_s().unwrap();
        assert_eq!(kind.kind, known.kind);
        assert!((kind.coefficient / known.coefficient / share - 1.0).abs() < 1e-12);
        let mut separate = other.build().unwrap();
        if fixed && share == SHARES[0] {
            // Exactly as its case says.
            assert_alike(&told, rows(&separate).last().unwrap());
        }
        // As far as the one run goes, by its own measure: where steps are looser at first depends on the way as a whole.
        let end = separate.schedule.extent;
        separate.schedule.extent = one.schedule.extent / share;
        separate.schedule.stepping = one.schedule.stepping;
        separate.schedule.outputs =
            one.schedule.outputs.iter().map(|place| place / share).collect();
        let all = rows(&separate);
        let at = all.iter().find(|row| (row[0].1 - end).abs() <= 1e-12 * end);
        assert_alike(&told, at.unwrap());
    }
}

const SMALL: [&str; 3] =
    ["frame.elements=[16, 16]", "motion.sliding.distance=100 mm", "motion.sliding.step=10 mm"];

#[test]
fn of_a_pin_in_fixed_steps() {
    assert_that_one_run_is_all("pin_on_disc", &SMALL, &[("pin", 1.33e-13)]);
}

#[test]
fn of_two_bodies_in_steps_by_error() {
    let by_error = ["motion.sliding.step=", "motion.sliding.tolerance=1e-2", "output.every=50 mm"];
    let options = [&SMALL[..], &by_error].concat();
    assert_that_one_run_is_all("pin_on_disc_both", &options, &[("pin", 2e-13), ("disc", 5e-14)]);
}

/// Turns and time follow the distance, and the wear rate is k.
#[test]
fn of_a_disc_that_turns() {
    let options = ["frame.elements=[16, 16]", "motion.sliding.speed=0.1 m/s"];
    assert_that_one_run_is_all("pin_on_disc_track", &options, &[("ball", 1e-16), ("disc", 5e-15)]);
}

#[test]
fn of_discs_that_roll() {
    let options = [
        "frame.elements=[15, 15]",
        "motion.rolling.revolutions=200",
        "motion.rolling.tolerance=",
        "motion.rolling.step=50",
        "output=",
        "friction_solver.newton.tolerance=1e-11",
    ];
    assert_that_one_run_is_all("twin_disc", &options, &[("disc1", 1e-12), ("disc2", 5e-13)]);
}

/// Each point wears by the law of what it has reached, at the same k s.
#[test]
fn of_a_coating_worn_through() {
    let options = [
        "accuracy=",
        "frame={ size = [\"0.24 mm\", \"0.24 mm\"], elements = [16, 16] }",
        "motion.sliding.step=20 m",
        "output=",
    ];
    assert_that_one_run_is_all(
        "coated_disc",
        &options,
        &[("disc.layers.0", 1e-15), ("disc", 5e-15)],
    );
}

/// Cases that are equal in all but the size of the coefficients, and nothing else, are of one kind.
#[test]
fn only_where_k_alone_differs() {
    let kind = |options: &[&str]| case("pin_on_disc_both", options, &[]).wears_by_k_s();
    let base = kind(&[]).unwrap();
    let alike = [
        "body.pin.wear.archard.coefficient=13.3e-14 1/Pa",
        "body.disc.wear.archard.coefficient=1.33e-4 mm^3/(N m)",
    ];
    assert_eq!(kind(&alike).unwrap().kind, base.kind);
    for other in [&alike[..1], &["motion.sliding.load=5 N"], &["motion.sliding.step=4 mm"]] {
        assert_ne!(kind(other).unwrap().kind, base.kind, "{other:?}");
    }
    for other in [
        "body.disc.wear={ power = { coefficient = \"1e-13 1/Pa\", pressure_exponent = 1.2, reference_pressure = \"1 MPa\" } }",
        "body.disc.wear={ threshold = { coefficient = \"1e-13 1/Pa\", threshold = \"1 MPa\" } }",
        "motion.sliding.scheme=explicit",
        "frame.doubles=[\"0.2 m\"]",
    ] {
        assert_eq!(kind(&[other]), None, "{other}");
    }
    let approach = ["motion.sliding.load=", "motion.sliding.approach=1 um"];
    assert_eq!(kind(&approach), None);
    assert_eq!(case("fretting_sphere", &[], &[]).wears_by_k_s(), None);
}
