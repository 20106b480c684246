//! Steps chosen by error, against a run on the same grid that is converged in time.

use archard::motion::Stepping;
use archard::problem::{ContactProblem, ContactState};
use archard::simulation::Effort;

use super::accuracy::PIN;
use crate::common::{Ball, case, depth, peak, states};

/// Outputs (m).
const OUTPUTS: [f64; 9] = [5e-3, 10e-3, 20e-3, 50e-3, 100e-3, 200e-3, 300e-3, 400e-3, 500e-3];
/// Elements along a side.
const CELLS: usize = 24;

/// A run's outputs after the initial contact.
fn outputs(tolerance: f64) -> Vec<(ContactState, Effort)> {
    all(tolerance)
        .into_iter()
        .skip(1)
        .filter_map(|(state, effort, due)| due.then_some((state, effort)))
        .collect()
}

fn all(tolerance: f64) -> Vec<(ContactState, Effort, bool)> {
    states(&Ball::pin_on_disc(CELLS).sliding(0.5, Stepping::Tolerance(tolerance), &OUTPUTS))
        .unwrap()
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

/// The true error of the deepest wear stays below the estimate, the estimate below the tolerance, at
/// every output and for five tolerances; and the error shrinks with the tolerance.
#[test]
fn the_estimate_is_honest() {
    let converged = converged();
    let mut last = f64::INFINITY;
    for tolerance in [1e-2, 3e-3, 1e-3, 3e-4, 1e-4] {
        let outputs = outputs(tolerance);
        assert_eq!(outputs.len(), OUTPUTS.len());
        let mut largest = 0.0f64;
        for ((state, effort), reference) in outputs.iter().zip(&converged) {
            let error = (depth(state) / reference - 1.0).abs();
            let estimate = effort.time_error.unwrap();
            assert!(
                error <= estimate,
                "tolerance {tolerance} at {}: {error:e} > {estimate:e}",
                state.progress
            );
            assert!(estimate <= tolerance, "{estimate:e} > {tolerance:e}");
            largest = largest.max(error);
        }
        assert!(largest < last, "{largest:e} after {last:e}");
        last = largest;
    }
}

/// So it does where pressures fall faster than a ball's or hardly at all: of a cone and of punches as r^6 and r^12.
#[test]
fn the_estimate_is_honest_for_other_shapes() {
    let outputs = [1e-3, 5e-3, 20e-3, 0.1, 0.5];
    let at = "output={ at = [\"1 mm\", \"5 mm\", \"20 mm\", \"100 mm\", \"500 mm\"] }";
    for exponent in [1, 6, 12] {
        let profile = power_profile(exponent);
        let with = |tolerance: &str| {
            let tolerance = format!("motion.sliding.tolerance={tolerance}");
            let elements = "frame.elements=[60, 60]";
            case(PIN, &["motion.sliding.step=", &tolerance, &profile, elements, at])
        };
        let converged = extrapolated(|| with("0.1").problem, &outputs);
        for tolerance in ["1e-2", "3e-3", "1e-3"] {
            let states = states(&with(tolerance)).unwrap().into_iter().skip(1);
            let due = states.filter(|(_, _, due)| *due);
            for ((state, effort, _), reference) in due.zip(&converged) {
                let error = (depth(&state) / reference - 1.0).abs();
                let estimate = effort.time_error.unwrap();
                assert!(
                    error <= estimate,
                    "r^{exponent}, {tolerance} at {}: {error:e} > {estimate:e}",
                    state.progress
                );
            }
        }
    }
}

/// And where the wear of a pair stops below a pressure, or its coefficient runs in, or a blunt punch ripples, on few elements
/// and on many: against steps that are held to a thousandth.
#[test]
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
    let at = "output={ at = [\"2 mm\", \"10 mm\", \"50 mm\", \"200 mm\", \"500 mm\"] }";
    for (case_of, cells) in cases.iter().flat_map(|one| [(one, 36), (one, 60)]) {
        let elements = format!("frame.elements=[{cells}, {cells}]");
        let due = |tolerance: &str| {
            let tolerance = format!("motion.sliding.tolerance={tolerance}");
            let size = "frame.size=[\"1.6 mm\", \"1.6 mm\"]";
            let mut options = vec!["motion.sliding.step=", &tolerance, &elements, size, at];
            options.extend(case_of.iter().map(String::as_str));
            let states = states(&case(PIN, &options)).unwrap().into_iter().skip(1);
            states.filter(|(_, _, due)| *due).collect::<Vec<_>>()
        };
        let converged = due("1e-5");
        for tolerance in ["1e-2", "1e-3", "3e-4"] {
            for ((state, effort, _), (reference, ..)) in due(tolerance).iter().zip(&converged) {
                let error = (depth(state) / depth(reference) - 1.0).abs();
                let estimate = effort.time_error.unwrap();
                assert!(
                    error <= estimate,
                    "{case_of:?}, {cells}, {tolerance} at {}: {error:e} > {estimate:e}",
                    state.progress
                );
            }
        }
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

/// A tolerance of 1e-3: depths within 0.5 % and at most 150 solves.
#[test]
fn a_thousandth_takes_at_most_150_solves() {
    let outputs = outputs(1e-3);
    for ((state, _), reference) in outputs.iter().zip(converged()) {
        assert!((depth(state) / reference - 1.0).abs() < 0.005);
    }
    let solves = outputs.last().unwrap().1.solves;
    assert!(solves <= 150, "{solves} solves");
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
    let states = all(3e-3);
    let frame = Ball::pin_on_disc(CELLS).problem().frame;
    for pair in states.windows(2) {
        let (before, after) = (&pair[0].0, &pair[1].0);
        assert!(before.worn[0].iter().zip(&after.worn[0]).all(|(before, after)| after >= before));
        let volume = frame.integrate(&after.worn[0]);
        assert!((volume / (1.33e-13 * 10.2 * after.progress) - 1.0).abs() < 1e-10);
    }
}
