//! Steps chosen by error, against a run on the same grid that is converged in time.

use approx::assert_relative_eq;
use archard::estimate::Subject;
use archard::motion::Stepping;
use archard::problem::{ContactProblem, ContactState};
use archard::simulation::{Effort, Simulation};

use super::accuracy::PIN;
use crate::common::{Ball, case, depth, peak, states};

/// Outputs (m).
const OUTPUTS: [f64; 9] = [5e-3, 10e-3, 20e-3, 50e-3, 100e-3, 200e-3, 300e-3, 400e-3, 500e-3];
/// Elements along a side.
const CELLS: usize = 24;

/// A run's outputs after the initial contact.
fn outputs(tolerance: f64) -> Vec<(ContactState, Effort)> {
    due(&ball(tolerance))
}

fn ball(tolerance: f64) -> Simulation {
    Ball::pin_on_disc(CELLS).sliding(0.5, Stepping::Tolerance(tolerance), &OUTPUTS)
}

/// A converged history made without the scheme under test: plain implicit steps a fixed share of the
/// distance slid, and half as long; the depths extrapolated.
fn converged() -> Vec<f64> {
    extrapolated(|| Ball::pin_on_disc(CELLS).problem(), &OUTPUTS)
}

fn extrapolated(problem: impl Fn() -> ContactProblem, outputs: &[f64]) -> Vec<f64> {
    let [coarse, fine] = [100, 200].map(|parts| plain(problem(), outputs, parts).0);
    coarse.iter().zip(fine).map(|(coarse, fine)| 2.0 * fine - coarse).collect()
}

/// Depths at the outputs and the whole history, with that many steps from output to output.
fn plain(
    problem: ContactProblem,
    outputs: &[f64],
    parts: usize,
) -> (Vec<f64>, Vec<(f64, Vec<f64>)>) {
    let mut wear = Plain::new(problem);
    let (mut depths, mut start) = (Vec::new(), 0.0);
    for &end in outputs {
        let count = parts * if start == 0.0 { 4 } else { 1 };
        wear.slide((end - start) / count as f64, count);
        depths.push(wear.depth());
        start = end;
    }
    (depths, wear.history)
}

/// Implicit Euler without anything around it.
struct Plain {
    problem: ContactProblem,
    worn: Vec<f64>,
    /// Distance slid (m).
    distance: f64,
    /// Distance and pressures after every step.
    history: Vec<(f64, Vec<f64>)>,
    last: Option<archard::solve::Outcome>,
}

impl Plain {
    fn new(problem: ContactProblem) -> Self {
        let zeros = vec![0.0; problem.frame.len()];
        Self { worn: zeros, distance: 0.0, history: vec![], last: None, problem }
    }

    fn slide(&mut self, step: f64, count: usize) {
        let solver = crate::common::solver("conjugate_gradient", 1e-8);
        let addition = vec![1.33e-13 * step; self.worn.len()];
        for _ in 0..count {
            let gap: Vec<f64> =
                self.problem.frame.gap().iter().zip(&self.worn).map(|(g, w)| g + w).collect();
            let rest = crate::common::at_rest(
                &self.problem,
                &addition,
                archard::motion::Control::Load(10.2),
            );
            let start = self.last.as_ref().map(|last| archard::solve::Start {
                pressure: &last.pressure,
                displacement: &last.displacement,
                part: last.part,
                approach: last.approach,
            });
            let outcome = solver.solve(&archard::solve::Step { gap: &gap, ..rest }, start);
            let pressures = outcome.pressure.iter();
            self.worn.iter_mut().zip(pressures).for_each(|(worn, p)| *worn += 1.33e-13 * step * p);
            self.distance += step;
            self.history.push((self.distance, outcome.pressure.clone()));
            self.last = Some(outcome);
        }
    }

    fn depth(&self) -> f64 {
        peak(&self.worn)
    }
}

/// The outputs of a case after the initial contact.
fn due(simulation: &Simulation) -> Vec<(ContactState, Effort)> {
    let states = states(simulation).unwrap().into_iter().skip(1);
    states.filter_map(|(state, effort, due)| due.then_some((state, effort))).collect()
}

/// The largest true error of the deepest wear, which at every output is below the estimate, and that below `most`.
fn enclosed(outputs: &[(ContactState, Effort)], converged: &[f64], most: f64, what: &str) -> f64 {
    assert_eq!(outputs.len(), converged.len(), "{what}");
    let mut largest = 0.0f64;
    for ((state, effort), reference) in outputs.iter().zip(converged) {
        let error = (depth(state) / reference - 1.0).abs();
        let estimate = effort.time_error.unwrap();
        let place = state.progress;
        assert!(error <= estimate, "{what} at {place}: {error:e} > {estimate:e}");
        assert!(estimate <= most, "{what} at {place}: {estimate:e} > {most:e}");
        largest = largest.max(error);
    }
    largest
}

/// The true error of the deepest wear stays below the estimate, the estimate below 2.5 times the tolerance, at every output and
/// for five tolerances; and the error shrinks with the tolerance.
#[test]
fn the_estimate_is_honest() {
    let converged = converged();
    let mut last = f64::INFINITY;
    for tolerance in [1e-2, 3e-3, 1e-3, 3e-4, 1e-4] {
        let largest =
            enclosed(&outputs(tolerance), &converged, 2.5 * tolerance, &tolerance.to_string());
        assert!(largest < last, "{largest:e} after {last:e}");
        last = largest;
    }
}

/// So it does where pressures fall faster than a ball's or hardly at all: of a cone and of punches as r^6 and r^12, whose ripples
/// alone may be three times the tolerance.
#[test]
#[ignore = "long: in .ci/long"]
fn the_estimate_is_honest_for_other_shapes() {
    let outputs = [1e-3, 5e-3, 20e-3, 0.1, 0.5];
    let at = "output={ at = [\"1 mm\", \"5 mm\", \"20 mm\", \"100 mm\", \"500 mm\"] }";
    for exponent in [1, 6, 12] {
        let profile = power_profile(exponent);
        let with = |tolerance: f64| {
            let tolerance = format!("motion.sliding.tolerance={tolerance}");
            let elements = "frame.elements=[60, 60]";
            case(PIN, &["motion.sliding.step=", &tolerance, &profile, elements, at])
        };
        let converged = extrapolated(|| with(0.1).problem, &outputs);
        for tolerance in [1e-2, 3e-3, 1e-3, 3e-4] {
            let what = format!("r^{exponent}, {tolerance}");
            enclosed(&due(&with(tolerance)), &converged, 3.5 * tolerance, &what);
        }
    }
}

/// And where the wear of a pair stops below a pressure, or its coefficient runs in, or a blunt punch ripples, on few elements
/// and on many: against steps that are held to 3e-6, which end as fixed steps do that are extrapolated. What these laws leave
/// shrinks less than the tolerance, and up to twenty-five times that is stated.
#[test]
#[ignore = "long: in .ci/long"]
fn the_estimate_is_honest_for_laws_that_turn() {
    let wear = |law: &str| format!("body.pin.wear={{ {law} }}");
    let archard = wear("archard = { coefficient = \"3e-13 1/Pa\" }");
    let cases = [
        vec![wear("threshold = { coefficient = \"1.33e-13 1/Pa\", threshold = \"20 MPa\" }")],
        vec![wear(
            "running_in = { initial_coefficient = \"1e-12 1/Pa\", \
             final_coefficient = \"1e-13 1/Pa\", running_in_distance = \"30 mm\" }",
        )],
        vec![archard, power_profile(6)],
    ];
    for (law, cells) in cases.iter().zip([36, 36, 60]) {
        let run = |stepping: &str| on_elements(cells, law, stepping);
        let converged = depths(&run("motion.sliding.tolerance=3e-6"));
        let [coarse, fine] = ["0.25 mm", "0.125 mm"]
            .map(|step| depths(&run(&format!("motion.sliding.step={step}")))[4]);
        assert_relative_eq!(2.0 * fine - coarse, converged[4], max_relative = 2e-4);
        for tolerance in [1e-2, 1e-3, 3e-4, 1e-4] {
            let what = format!("{law:?}, {cells}, {tolerance}");
            let outputs = run(&format!("motion.sliding.tolerance={tolerance}"));
            enclosed(&outputs, &converged, 25.0 * tolerance, &what);
        }
    }
}

/// What the steps before left of running in, no shorter step takes back: steps go on at their length. This run once halved them at
/// its first output until they were a part of 1e-10 of the way.
#[test]
fn steps_do_not_shrink_without_end() {
    const BOTH: &str = r#"
        [body.one]
        material = { young = "129 GPa", poisson = 0.42 }
        profile.sphere = { radius = "5.5 mm" }
        wear.running_in = { initial_coefficient = "2.737e-18 1/Pa", final_coefficient = "6.17e-19 1/Pa", running_in_distance = "21.3 m" }
        [body.two]
        material = { young = "211 GPa", poisson = 0.39 }
        profile.flat = {}
        wear.running_in = { initial_coefficient = "5.751e-15 1/Pa", final_coefficient = "1.322e-15 1/Pa", running_in_distance = "41.8 mm" }
        [frame]
        size = ["86.86 um", "105 um"]
        elements = [84, 100]
        [motion.sliding]
        load = "0.3893 N"
        stroke = "62.56 mm"
        passes = "two"
        distance = "146 m"
        tolerance = 8.333e-4
        [output]
        at = ["14.6 m", "43.8 m", "146 m"]
    "#;
    let mut steps = 0;
    let mut run = archard::simulation::Run::begin(case(BOTH, &[])).unwrap();
    while run.step().unwrap() && steps < 200 {
        steps += 1;
    }
    assert!(steps < 100, "{steps}");
}

/// What hardly wears keeps its pressures, whose coefficient alone changes: steps make next to no error, and say so.
#[test]
fn a_coefficient_that_changes_is_no_ripple() {
    let law = "body.pin.wear={ running_in = { initial_coefficient = \"1e-18 1/Pa\", \
        final_coefficient = \"3e-18 1/Pa\", running_in_distance = \"60 mm\" } }";
    let outputs = on_elements(36, &[law.to_owned()], "motion.sliding.tolerance=0.01");
    let [initial, last, distance] = [1e-18, 3e-18, 0.06];
    for (state, effort) in &outputs {
        let s = state.progress;
        let faded = distance * (1.0 - f64::exp(-s / distance));
        let truth = peak(&state.pressure) * (last * s + (initial - last) * faded);
        assert_relative_eq!(depth(state), truth, max_relative = 1e-3);
        let stated = effort.time_error.unwrap();
        assert!(stated < 0.01, "{stated} at {s}");
    }
}

/// And where coefficients rise with the distance slid, by the law of wear or by the friction whose work wears. Twenty tolerances
/// may be stated then, and three hundredths however small the tolerance, but no run fails. Against fixed steps that are
/// extrapolated.
#[test]
#[ignore = "long: in .ci/long"]
fn the_estimate_is_honest_where_coefficients_rise() {
    let dir = tempfile::tempdir().unwrap();
    let table = dir.path().join("mu.csv");
    std::fs::write(&table, "distance [mm],coefficient\n0,0.1\n20,0.7\n").unwrap();
    let friction = format!("friction.table.file={}", table.display());
    let energy = "body.pin.wear={ energy = { coefficient = \"6e-13 1/Pa\" } }";
    let running_in = "body.pin.wear={ running_in = { initial_coefficient = \"0.6e-13 1/Pa\", \
        final_coefficient = \"4.2e-13 1/Pa\", running_in_distance = \"20 mm\" } }";
    for law in [vec![energy.to_owned(), friction], vec![running_in.to_owned()]] {
        let run = |stepping: &str| on_elements(40, &law, stepping);
        let [coarse, fine] = ["0.25 mm", "0.125 mm"]
            .map(|step| depths(&run(&format!("motion.sliding.step={step}"))));
        let converged: Vec<f64> =
            coarse.iter().zip(&fine).map(|(coarse, fine)| 2.0 * fine - coarse).collect();
        // At the last, a lag from the steps before ends the run if it may reject steps.
        for tolerance in [1e-2, 1e-3, 1e-4] {
            let what = format!("{law:?}, {tolerance}");
            let outputs = run(&format!("motion.sliding.tolerance={tolerance}"));
            enclosed(&outputs, &converged, f64::max(20.0 * tolerance, 0.03), &what);
        }
    }
}

/// The outputs of a pin with some law on so many elements a side.
fn on_elements(cells: usize, law: &[String], stepping: &str) -> Vec<(ContactState, Effort)> {
    let elements = format!("frame.elements=[{cells}, {cells}]");
    let at = "output={ at = [\"2 mm\", \"10 mm\", \"50 mm\", \"200 mm\", \"500 mm\"] }";
    let size = "frame.size=[\"1.6 mm\", \"1.6 mm\"]";
    let mut options = vec!["motion.sliding.step=", stepping, &elements, size, at];
    options.extend(law.iter().map(String::as_str));
    due(&case(PIN, &options))
}

/// The deepest wear at outputs (m).
fn depths(outputs: &[(ContactState, Effort)]) -> Vec<f64> {
    outputs.iter().map(|(state, _)| depth(state)).collect()
}

/// How ripples count depends on whether wear is proportional to the pressure, by its law and by its friction. A volume follows
/// from load and distance only where there is one coefficient.
#[test]
fn laws_tell_whether_they_are_proportional() {
    let dir = tempfile::tempdir().unwrap();
    let table = |name: &str, rows: &str| {
        let file = dir.path().join(name);
        std::fs::write(&file, rows).unwrap();
        format!("friction.table.file={}", file.display())
    };
    let pressure = table("p.csv", "pressure [MPa],coefficient\n10,0.1\n200,0.6\n");
    let distance = table("s.csv", "distance [mm],coefficient\n0,0.1\n20,0.7\n");
    let speed = table("v.csv", "speed [m/s],coefficient\n0.1,0.1\n10,0.7\n");
    let wear = |law: &str| format!("body.pin.wear={{ {law} }}");
    let energy = wear("energy = { coefficient = \"6e-13 1/Pa\" }");
    let coulomb = "friction.coulomb.coefficient=0.3";
    let archard = "body.pin.wear.archard.coefficient=1e-13 1/Pa".to_owned();
    let threshold = wear("threshold = { coefficient = \"1e-13 1/Pa\", threshold = \"20 MPa\" }");
    for (law, friction, expected, one_coefficient) in [
        (&archard, coulomb, true, true),
        (&archard, &pressure, true, true),
        (&energy, coulomb, true, true),
        (&energy, &pressure, false, false),
        (&energy, &distance, false, false),
        (&energy, &speed, true, false),
        (&threshold, coulomb, false, false),
    ] {
        let problem = case(PIN, &[law, friction, "motion.sliding.speed=1 m/s"]).problem;
        assert_eq!(problem.is_proportional(1e8), expected, "{law} {friction}");
        let coefficient = Subject::from(&problem).wear_coefficient(0);
        assert_eq!(coefficient.is_some(), one_coefficient, "{law} {friction}");
    }
}

/// The option that makes the pin a punch as a power of r, 0.9 um deep at 0.3 mm.
fn power_profile(exponent: i32) -> String {
    let coefficient = 0.9e-6 / 0.3e-3f64.powi(exponent);
    let unit = if exponent == 1 { String::new() } else { format!(" 1/m^{}", exponent - 1) };
    format!(
        "body.pin.profile={{ axisymmetric_power = {{ exponent = {exponent}, coefficient = \"{coefficient}{unit}\" }} }}"
    )
}

/// A tolerance of 1e-3 and ten outputs: at most 80 solves, and from 5 mm on depths within 1e-3 and the pressure at the centre
/// within 1 %, at every step. What is stated is 4.5 times the tolerance at most before the first output, and 2.5 times after.
#[test]
fn a_thousandth_takes_at_most_80_solves() {
    let outputs: Vec<f64> = (1..=10).map(|output| 50e-3 * f64::from(output)).collect();
    let pin = || Ball::pin_on_disc(30);
    let simulation = pin().sliding(0.5, Stepping::Tolerance(1e-3), &outputs);
    let all = states(&simulation).unwrap();
    let solves = all.last().unwrap().1.solves;
    assert!(solves <= 80, "{solves} solves");
    let steps: Vec<_> = all.iter().filter(|(state, ..)| state.progress >= 5e-3).collect();
    let ends: Vec<f64> = steps.iter().map(|(state, ..)| state.progress).collect();
    let depths = extrapolated(|| pin().problem(), &ends);
    let history = plain(pin().problem(), &ends, 100).1;
    for ((state, effort, _), reference) in steps.iter().zip(depths) {
        assert_relative_eq!(depth(state), reference, max_relative = 1e-3);
        let near = |distance: f64| (distance - state.progress).abs() < 1e-9;
        let (_, pressure) = history.iter().find(|(distance, _)| near(*distance)).unwrap();
        let frame = &simulation.problem.frame;
        let centre = frame.at_centre(&state.pressure) - effort.centre_lag;
        assert_relative_eq!(centre, frame.at_centre(pressure), max_relative = 0.01);
        let most = if state.progress < outputs[0] { 4.5e-3 } else { 2.5e-3 };
        assert!(effort.time_error.unwrap() <= most, "{:?} at {}", effort, state.progress);
    }
}

/// No spike at the moving edge. A pair that has just been touched climbs fast, and so differs at any
/// one instant; but nowhere does a pressure exceed the most that the converged history shows there
/// within a tenth of the distance slid, by more than 3 % of the peak.
#[test]
fn no_pressure_spikes_at_the_moving_edge() {
    let history = plain(Ball::pin_on_disc(CELLS).problem(), &OUTPUTS, 200).1;
    for (state, _) in outputs(1e-3) {
        let near: Vec<&Vec<f64>> = history
            .iter()
            .filter(|(distance, _)| (distance / state.progress - 1.0).abs() <= 0.1)
            .map(|(_, pressure)| pressure)
            .collect();
        let largest = peak(near.last().unwrap());
        for (pair, pressure) in state.pressure.iter().enumerate() {
            let most = near.iter().map(|known| known[pair]).fold(0.0, f64::max);
            assert!(
                pressure - most < 0.03 * largest,
                "{pressure:e} above {most:e} at {}",
                state.progress
            );
        }
    }
}

/// Wear never grows back, and every state keeps the volume.
#[test]
fn wear_only_grows() {
    let states = states(&ball(3e-3)).unwrap();
    let frame = Ball::pin_on_disc(CELLS).problem().frame;
    for pair in states.windows(2) {
        let (before, after) = (&pair[0].0, &pair[1].0);
        assert!(before.worn(0).iter().zip(&*after.worn(0)).all(|(before, after)| after >= before));
        let volume = frame.integrate(&after.worn(0));
        assert!((volume / (1.33e-13 * 10.2 * after.progress) - 1.0).abs() < 1e-10);
    }
}
