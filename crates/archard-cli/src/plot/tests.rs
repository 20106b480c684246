//! Pictures of a made-up run: no solver, Hertz's pressure on a growing scar.

#[path = "../../../archard-case/tests/common/damage.rs"]
mod damage;
mod damaged;
mod described;
mod fretting;
#[path = "../../../archard-case/tests/common/random.rs"]
mod random;
mod rolling;

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use archard::body::profile::{Flat, Sphere};
use archard::body::{Body, Material};
use archard::closed_form::pin_on_disc;
use archard::compliance::Compliance;
use archard::frame::{ContactFrame, VectorField};
use archard::motion::{Control, MOTIONS, Stepping};
use archard::parameters::{Choice, Value, Values};
use archard::problem::{ContactProblem, ContactState, Surface};
use archard::simulation::{Effort, Observer, Report, Simulation};
use archard::wear::Archard;
use archard_case::output::{ResultFolder, Totals};
use tempfile::tempdir;

use super::draw::{Format, Paper, Width};
use super::results::Results;
use super::run;
use super::tables::Axis;

/// Bodies that do not deform.
#[derive(Debug)]
struct Stiff;

impl Compliance for Stiff {
    fn apply(&self, tractions: &VectorField) -> VectorField {
        VectorField::zeros(tractions.n.len())
    }

    fn normal_self_term(&self) -> f64 {
        0.0
    }
}

/// Builds the choice of that name.
fn build<T>(choices: &[Choice<T>], name: &str, numbers: &[(&'static str, f64)]) -> T {
    let mut values = Values::default();
    numbers.iter().for_each(|(name, number)| values.insert(name, Value::Number(*number)));
    let choice = choices.iter().find(|choice| choice.name == name).unwrap();
    (choice.build)(&values).unwrap()
}

/// A sphere of 50 mm on a flat, with these wear coefficients (1/Pa) and that motion.
fn problem(
    coefficients: [f64; 2],
    motion: &str,
    numbers: &[(&'static str, f64)],
) -> ContactProblem {
    let steel = Material::new(210e9, 0.3).unwrap();
    let mut bodies = [Body::new("pin", Sphere::new(50e-3).unwrap()), Body::new("disc", Flat)];
    for (body, coefficient) in bodies.iter_mut().zip(coefficients) {
        let worn = coefficient > 0.0;
        body.material = Some(steel);
        body.wear = worn.then(|| Arc::new(Archard::new(coefficient).unwrap()) as _);
    }
    let profiles = bodies.each_ref().map(|body| &*body.profile);
    let frame = ContactFrame::uniform([1.2e-3; 2], [60, 60], profiles).unwrap();
    let planned = build(MOTIONS, motion, numbers);
    Simulation::builder(bodies, planned).contact(frame, Stiff).build().unwrap().problem
}

/// A state with that load (N) on a scar as deep as `volume` (m^3) makes it, shared as given.
fn state(problem: &ContactProblem, load: f64, volume: f64, shares: [f64; 2]) -> ContactState {
    let frame = &problem.frame;
    let depth = pin_on_disc::depth(50e-3, volume);
    let hertz = 0.149e-3 * (load / 10.2).cbrt();
    let radius = (hertz * hertz + 2.0 * 50e-3 * depth).sqrt();
    let shape = |power: f64| -> Vec<f64> {
        let value =
            |[x, y]: [f64; 2]| (1.0 - (x * x + y * y) / (radius * radius)).max(0.0).powf(power);
        (0..frame.len()).map(|pair| value(frame.place(pair))).collect()
    };
    let scaled = |shape: &[f64], total: f64| -> Vec<f64> {
        let factor = total / frame.integrate(shape).max(f64::MIN_POSITIVE);
        shape.iter().map(|value| factor * value).collect()
    };
    let (bowl, cap) = (shape(0.5 / (1.0 + 3e6 * depth)), shape(1.0));
    ContactState {
        approach: 0.445e-6 * (load / 10.2).powf(2.0 / 3.0) + depth,
        load,
        pressure: scaled(&bowl, load),
        surfaces: shares
            .map(|share| Surface::of_pairs(frame.elements(), scaled(&cap, share * volume))),
        ..ContactState::untouched(frame)
    }
}

/// Writes the result folder of a made-up run of a case, which need not be one.
fn write(
    dir: &Path,
    case: &str,
    problem: &ContactProblem,
    states: &[ContactState],
    finished: bool,
) {
    let mut folder = ResultFolder::create(dir, case).unwrap();
    let last = states.len() - 1;
    for (step, state) in states.iter().enumerate() {
        let load_distance = 10.2 * state.progress;
        let effort = Effort { steps: step, load_distance, ..Effort::default() };
        let output = step % (last / 5).max(1) == 0;
        let report = Report {
            problem,
            state,
            effort,
            output,
            extent: states[last].progress,
            prescribed: Control::Load(state.load),
            stepping: Stepping::Implicit(1.0),
            companions: None,
            again: false,
            march: None,
        };
        folder.observe(&report).unwrap();
    }
    if finished {
        folder.finish(&Totals::default()).unwrap();
    }
}

/// Writes a run of sliding over 500 mm in 100 steps.
fn slide(dir: &Path, coefficients: [f64; 2], finished: bool) {
    let numbers = [("load", 10.2), ("distance", 0.5), ("step", 5e-3)];
    let problem = problem(coefficients, "sliding", &numbers);
    let total = coefficients[0] + coefficients[1];
    let shares = coefficients.map(|coefficient| coefficient / total);
    let states: Vec<_> = (0..=100)
        .map(|step| 5e-3 * f64::from(step))
        .map(|s| ContactState { progress: s, ..state(&problem, 10.2, 10.2 * total * s, shares) })
        .collect();
    write(dir, "", &problem, &states, finished);
}

/// The names of the files that were drawn, checked to be there.
fn drawn(dir: &Path) -> Vec<String> {
    drawn_with(dir, &[])
}

/// The same, with other runs next to it.
fn drawn_with(dir: &Path, others: &[PathBuf]) -> Vec<String> {
    let files = run(dir, others, &Paper::default()).unwrap();
    for file in &files {
        let bytes = fs::read(file).unwrap();
        let start: &[u8] = if file.extension().unwrap() == "png" { b"\x89PNG" } else { b"<" };
        assert!(bytes.starts_with(start), "{}", file.display());
    }
    files.iter().map(|file| file.file_name().unwrap().to_str().unwrap().to_owned()).collect()
}

#[test]
fn a_sliding_run_has_its_four_pictures() {
    let dir = tempdir().unwrap();
    slide(dir.path(), [1.33e-13, 0.0], true);
    let files = drawn(dir.path());
    let known = ["wear", "profiles", "pressure_map", "overview"];
    let both = known.iter().flat_map(|name| [format!("{name}.svg"), format!("{name}.png")]);
    assert_eq!(files, both.collect::<Vec<_>>());
    let svg = fs::read_to_string(dir.path().join("plots/wear.svg")).unwrap();
    for text in ["Distance (mm)", "Wear depth (µm)", "10⁻³ mm³", "sphere worn flat"] {
        assert!(svg.contains(text), "{text}");
    }
}

/// A folder of a stranger may hold a link in the place of `plots`.
#[cfg(unix)]
#[test]
fn pictures_are_not_written_through_a_link() {
    let [dir, other] = [tempdir().unwrap(), tempdir().unwrap()];
    slide(dir.path(), [1.33e-13, 0.0], true);
    let victim = other.path().join("wear.svg");
    fs::write(&victim, "mine").unwrap();
    std::os::unix::fs::symlink(other.path(), dir.path().join("plots")).unwrap();
    let error = run(dir.path(), &[], &Paper::default()).unwrap_err().to_string();
    assert!(error.contains("is a link"), "{error}");
    assert_eq!(fs::read_to_string(&victim).unwrap(), "mine");
    assert_eq!(fs::read_dir(other.path()).unwrap().count(), 1);
}

#[test]
fn an_interrupted_run_is_drawn_without_closed_forms() {
    let dir = tempdir().unwrap();
    slide(dir.path(), [0.887e-13, 0.443e-13], false);
    assert_eq!(drawn(dir.path()).len(), 8);
    let svg = fs::read_to_string(dir.path().join("plots/wear.svg")).unwrap();
    assert!(!svg.contains("sphere worn flat") && svg.contains("both bodies"));
}

#[test]
fn an_indentation_is_drawn_beside_hertz() {
    let dir = tempdir().unwrap();
    let problem = problem([0.0; 2], "indentation", &[("load", 10.2)]);
    let states: Vec<_> = (0..=10)
        .map(|step| 0.1 * f64::from(step))
        .map(|share| ContactState {
            progress: share,
            ..state(&problem, 10.2 * share, 0.0, [0.0; 2])
        })
        .collect();
    write(dir.path(), "", &problem, &states, true);
    assert_eq!(drawn(dir.path())[0], "load.svg");
    let svg = fs::read_to_string(dir.path().join("plots/load.svg")).unwrap();
    assert!(svg.contains("Hertz") && svg.contains("Approach (µm)"));
}

#[test]
fn a_run_that_has_only_begun_is_drawn() {
    let dir = tempdir().unwrap();
    let problem = problem([0.0; 2], "indentation", &[("load", 10.2)]);
    write(dir.path(), "", &problem, &[ContactState::untouched(&problem.frame)], false);
    // There is no load yet to draw over the approach.
    assert_eq!(drawn(dir.path()).len(), 6);
}

#[test]
fn pictures_for_a_column_are_as_wide_as_one() {
    let dir = tempdir().unwrap();
    slide(dir.path(), [1.33e-13, 0.0], true);
    let paper = Paper { width: Some(Width::Column), formats: vec![Format::Svg] };
    let files = run(dir.path(), &[], &paper).unwrap();
    let named = |name: &str| files.iter().find(|file| file.ends_with(name)).unwrap();
    let svg = fs::read_to_string(named("wear.svg")).unwrap();
    assert!(svg.contains("width=\"85mm\"") && svg.contains("viewBox=\"0 0 "), "{}", &svg[..200]);
    assert!(files.iter().all(|file| file.extension().unwrap() == "svg"));
}

/// PDF is written by programs that were built with it; others say how to get it.
#[test]
fn pictures_are_pdf_where_that_is_built() {
    let dir = tempdir().unwrap();
    slide(dir.path(), [1.33e-13, 0.0], true);
    let paper = Paper { width: Some(Width::Column), formats: vec![Format::Pdf] };
    let drawn = run(dir.path(), &[], &paper);
    assert_eq!(drawn.is_ok(), cfg!(feature = "pdf"));
    match drawn {
        Ok(files) => assert!(fs::read(&files[0]).unwrap().starts_with(b"%PDF")),
        Err(error) => assert!(format!("{error:#}").contains("--features pdf"), "{error:#}"),
    }
}

/// A contact from 0.2 to 0.5 mm is shown with an eighth of its width on either side, not from the middle of the frame on.
#[test]
fn pictures_are_framed_by_the_contact() {
    let dir = tempdir().unwrap();
    let problem = problem([0.0; 2], "indentation", &[("load", 10.2)]);
    let mut aside = state(&problem, 10.2, 0.0, [0.0; 2]);
    let within = |pair: usize| (0.2e-3..0.5e-3).contains(&problem.frame.place(pair)[0]);
    aside.pressure = (0..problem.frame.len()).map(|pair| f64::from(within(pair)) * 1e8).collect();
    write(dir.path(), "", &problem, &[aside], true);
    let [low, high] = Results::read(dir.path()).unwrap().window(Axis::X).unwrap();
    // Centres of elements of 20 um from 0.21 to 0.49 mm.
    assert!(
        (low - (0.21e-3 - 0.035e-3)).abs() < 1e-9 && (high - 0.525e-3).abs() < 1e-9,
        "{low} {high}"
    );
}

/// Sections that are not there are missed in words.
#[test]
fn sections_along_one_axis_alone_are_refused() {
    let dir = tempdir().unwrap();
    let problem = problem([0.0; 2], "indentation", &[("load", 10.2)]);
    let pressed = state(&problem, 10.2, 0.0, [0.0; 2]);
    write(dir.path(), "", &problem, &[pressed], true);
    let path = dir.path().join("profiles.csv");
    let along: Vec<String> = fs::read_to_string(&path)
        .unwrap()
        .lines()
        .filter(|line| !line.contains(",y,"))
        .map(str::to_owned)
        .collect();
    fs::write(&path, along.join("\n")).unwrap();
    // Whose sum is another.
    fs::remove_file(dir.path().join("manifest.txt")).unwrap();
    let results = Results::read(dir.path()).unwrap();
    assert!(results.window(Axis::X).is_ok());
    let missed = results.window(Axis::Y).unwrap_err().to_string();
    assert!(missed.contains("no places along Y"), "{missed}");
}

/// A scar of 0.4 mm to either side, wider than the contact, is shown with a tenth of room; a track all along x is not.
#[test]
fn worn_shapes_reach_over_the_scar() {
    let dir = tempdir().unwrap();
    let numbers = [("load", 10.2), ("distance", 0.5), ("step", 5e-3)];
    let problem = problem([1e-13; 2], "sliding", &numbers);
    let mut worn = state(&problem, 10.2, 0.0, [0.0; 2]);
    worn.surfaces = [0.4e-3, 9.0].map(|reach| {
        let depth = |pair: usize| f64::from(problem.frame.place(pair)[0].abs() < reach) * 1e-6;
        let depths = (0..problem.frame.len()).map(depth).collect();
        Surface::of_pairs(problem.frame.elements(), depths)
    });
    write(dir.path(), "", &problem, &[worn], true);
    let results = Results::read(dir.path()).unwrap();
    // The contact of 0.149 mm ends with the element around 0.13 mm, the scar with that around 0.39 mm.
    let [contact, scar] = [results.window(Axis::X), results.worn_window(Axis::X)];
    assert!((contact.unwrap()[1] - 1.25 * 0.13e-3).abs() < 1e-9);
    assert!((scar.unwrap()[1] - 1.1 * 0.39e-3).abs() < 1e-9);
}

#[test]
fn other_folders_are_refused_in_words() {
    let dir = tempdir().unwrap();
    let error = run(dir.path(), &[], &Paper::default()).unwrap_err().to_string();
    assert!(error.contains("is not a result folder"), "{error}");
    ResultFolder::create(dir.path(), "").unwrap();
    let error = run(dir.path(), &[], &Paper::default()).unwrap_err().to_string();
    assert!(error.contains("no rows"), "{error}");
}

#[test]
fn runs_are_compared_under_the_names_of_their_folders() {
    let dir = tempdir().unwrap();
    let [fine, coarse] = ["fine", "coarse"].map(|name| dir.path().join(name));
    slide(&fine, [0.887e-13, 0.443e-13], true);
    slide(&coarse, [0.9e-13, 0.45e-13], false);
    let files = drawn_with(&fine, std::slice::from_ref(&coarse));
    assert_eq!(files[files.len() - 2..], ["comparison.svg", "comparison.png"]);
    let svg = fs::read_to_string(fine.join("plots/comparison.svg")).unwrap();
    for text in ["fine", "coarse", "pin", "disc", "both", "Distance (mm)", "Wear depth (µm)"] {
        assert!(svg.contains(&format!(">{text}<")), "{text}");
    }
    assert!(!coarse.join("plots").exists());
}

#[test]
fn runs_in_folders_of_one_name_are_told_apart_by_their_paths() {
    let dir = tempdir().unwrap();
    let [one, other] = ["one/run", "other/run"].map(|name| dir.path().join(name));
    slide(&one, [1.33e-13, 0.0], true);
    slide(&other, [1.33e-13, 0.0], true);
    drawn_with(&one, std::slice::from_ref(&other));
    let svg = fs::read_to_string(one.join("plots/comparison.svg")).unwrap();
    assert!(svg.contains(&other.display().to_string()));
    // What is worn of one body is worn in all.
    assert!(!svg.contains(">both<"));
}

#[test]
fn runs_that_cannot_be_compared_are_refused_in_words() {
    let dir = tempdir().unwrap();
    let [slid, pressed] = ["slid", "pressed"].map(|name| dir.path().join(name));
    slide(&slid, [1.33e-13, 0.0], true);
    let problem = problem([0.0; 2], "indentation", &[("load", 10.2)]);
    write(&pressed, "", &problem, &[ContactState::untouched(&problem.frame)], true);
    let refused = |dir: &PathBuf, other: &PathBuf| {
        run(dir, std::slice::from_ref(other), &Paper::default()).unwrap_err().to_string()
    };
    let error = refused(&slid, &pressed);
    assert!(error.contains("its progress is `share`") && error.contains("`distance_m`"), "{error}");
    let error = refused(&pressed, &pressed);
    assert!(error.contains("nothing has worn"), "{error}");
    let error = refused(&slid, &dir.path().to_owned());
    assert!(error.contains("is not a result folder"), "{error}");
}
