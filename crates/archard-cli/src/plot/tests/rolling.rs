//! Pictures of made-up runs of discs: a bowl of pressure, worn plane by plane.

use std::fs;
use std::path::Path;

use archard::problem::{ContactProblem, ContactState, Surface, Tangential};
use archard_case::CaseFile;
use tempfile::tempdir;

use super::{drawn, write};

/// Load (N).
const LOAD: f64 = 300.0;
/// Coefficient of friction.
const FRICTION: f64 = 0.6;

/// Twin discs under that motion.
fn case(motion: &str) -> String {
    let disc = |name: &str, crown: &str| {
        format!(
            "[body.{name}]\n\
             material = {{ young = \"208 GPa\", poisson = 0.3 }}\n\
             profile.disc = {{ radius = \"32.5 mm\"{crown} }}\n\
             wear.archard = {{ coefficient = \"1e-6 1/MPa\" }}\n"
        )
    };
    format!(
        "{}{}[frame]\nsize = [\"0.52 mm\", \"6.4 mm\"]\nelements = [21, 41]\n\
         [friction.coulomb]\ncoefficient = {FRICTION}\n[motion.{motion}]\nload = \"{LOAD} N\"\n",
        disc("disc1", ", crown = \"125 mm\""),
        disc("disc2", "")
    )
}

/// The bodies of a case.
fn problem(case: &str) -> ContactProblem {
    let file = CaseFile::from_text("case", case, ".");
    let resolved = file.resolve().unwrap_or_else(|problems| panic!("{problems:?}"));
    resolved.case.build().unwrap().problem
}

/// A contact that bears a share of what friction allows, both bodies worn to that depth (m).
fn state(problem: &ContactProblem, progress: f64, share: f64, depth: f64) -> ContactState {
    let frame = &problem.frame;
    let bowl = |pair: usize| {
        let [x, y] = frame.place(pair);
        (1.0 - (x / 0.2e-3).powi(2) - (y / 2e-3).powi(2)).max(0.0).sqrt()
    };
    let bowl: Vec<f64> = (0..frame.len()).map(bowl).collect();
    let peak = LOAD / frame.integrate(&bowl);
    let scaled = |factor: f64| -> Vec<f64> { bowl.iter().map(|bowl| factor * bowl).collect() };
    let forward = problem.motion.direction.forward();
    let mut worn = vec![0.0; frame.len()];
    for line in problem.motion.direction.lines(frame.elements()) {
        let most = line.clone().map(|pair| bowl[pair]).fold(0.0, f64::max);
        line.for_each(|pair| worn[pair] = depth * most);
    }
    ContactState {
        progress,
        load: LOAD,
        approach: 4e-6 + depth,
        tangential: Some(Tangential {
            traction: forward.map(|unit| scaled(share * FRICTION * peak * unit)),
            slip: forward.map(|unit| vec![1e-8 * unit; frame.len()]),
            creepage: [0.005 * share, 0.0],
            shift: [0.0; 2],
            ..Tangential::default()
        }),
        pressure: scaled(peak),
        surfaces: [worn.clone(), worn].map(|depth| Surface::of_pairs(frame.elements(), depth)),
        ..ContactState::untouched(frame)
    }
}

/// Writes a run of 10,000 revolutions.
fn roll(dir: &Path, case: &str, written: &str) {
    let problem = problem(case);
    let states: Vec<_> = (0..=20)
        .map(|step| 500.0 * f64::from(step))
        .map(|n| state(&problem, n, 0.9, 12e-6 * (n / 1e4).powf(0.67)))
        .collect();
    write(dir, written, &problem, &states, true);
}

/// A picture as text.
fn picture(dir: &Path, name: &str) -> String {
    fs::read_to_string(dir.join("plots").join(name).with_extension("svg")).unwrap()
}

/// A run of discs along that direction.
fn rolling(direction: &str) -> String {
    case("rolling")
        + &format!(
            "creepage = 0.005\nrevolutions = 10000\nstep = 500\ndirection = \"{direction}\"\n"
        )
}

#[test]
fn a_rolling_run_has_its_pictures() {
    let dir = tempdir().unwrap();
    let case = rolling("x");
    roll(dir.path(), &case, &case);
    let files = drawn(dir.path());
    let known = ["wear", "worn_profiles", "traction", "profiles", "pressure_map", "overview"];
    let both = known.iter().flat_map(|name| [format!("{name}.svg"), format!("{name}.png")]);
    assert_eq!(files, both.collect::<Vec<_>>());
    for (name, texts) in [
        ("wear", &["Revolutions", "Wear depth (µm)", "mm²", "incremental model"][..]),
        ("worn_profiles", &["y (mm)", "disc1, new", "disc2, worn", "after 10000 revolutions"]),
        ("traction", &["x (mm)", "limit", "Traction along x on disc1, rolling towards +x"]),
    ] {
        let svg = picture(dir.path(), name);
        for text in texts {
            assert!(svg.contains(text), "{text} is not in {name}");
        }
    }
}

#[test]
fn sections_follow_the_direction_of_rolling() {
    let dir = tempdir().unwrap();
    let case = rolling("-y");
    roll(dir.path(), &case, &case);
    drawn(dir.path());
    let traction = picture(dir.path(), "traction");
    assert!(traction.contains("Traction along y on disc1, rolling towards \u{2212}y"));
    assert!(traction.contains("Pressure along y") && !traction.contains("Traction along x"));
    assert!(picture(dir.path(), "worn_profiles").contains("x (mm)"));
}

#[test]
#[ignore = "long: in .ci/long"]
fn a_folder_without_a_case_is_drawn_without_the_limit() {
    let dir = tempdir().unwrap();
    roll(dir.path(), &rolling("x"), "");
    assert_eq!(drawn(dir.path()).len(), 12);
    let traction = picture(dir.path(), "traction");
    assert!(traction.contains("Traction along x") && !traction.contains("limit"));
}

#[test]
fn a_sweep_has_its_forces_beside_a_closed_form() {
    let dir = tempdir().unwrap();
    let case = case("creepage_sweep") + "creepage = 0.005\n";
    let case = case.replace("wear.archard = { coefficient = \"1e-6 1/MPa\" }\n", "");
    let problem = problem(&case);
    let states: Vec<_> = (0..=10)
        .map(|step| 0.1 * f64::from(step))
        .map(|share| state(&problem, share, share, 0.0))
        .collect();
    write(dir.path(), &case, &problem, &states, true);
    assert_eq!(drawn(dir.path())[0], "creep_force.svg");
    let svg = picture(dir.path(), "creep_force");
    for text in ["Force on disc1", "Creepage (%)", "limit", "along x", "Vermeulen and Johnson"] {
        assert!(svg.contains(text), "{text}");
    }
    assert!(!svg.contains("along y"));
}
