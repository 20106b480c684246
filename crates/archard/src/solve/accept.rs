//! One normal step through any solver, with what was prescribed held against what came out.
//!
//! A solver judges itself by the gaps and pressures it computed. Here the load it carries is compared
//! with the one prescribed, and no number that is not finite passes. Where the contact is on a part of the frame, so is the
//! solve.

use super::nested::{self, FromCoarser};
use super::residual::worse;
use super::{Outcome, Solver, Start, Status, Step, part};
use crate::compliance::normal_displacement;
use crate::motion::Control;

/// The pressures of a step, from those of an earlier one where they bear anything, otherwise from those on coarser elements.
pub fn press(solver: &dyn Solver, step: &Step<'_>, start: Option<Start<'_>>) -> Outcome {
    if step.control == Control::Load(0.0) {
        return apart(step);
    }
    let bears = |start: &Start<'_>| {
        let load = step.measure.load(start.pressure);
        load > 0.0 && load.is_finite() && start.approach.is_finite()
    };
    let start = start.filter(bears);
    if start.is_some() {
        return press_from(solver, step, start);
    }
    let coarser = nested::solve(step);
    let outcome = press_from(solver, step, coarser.as_ref().map(FromCoarser::start).filter(bears));
    let applications = coarser.map_or(0, |coarser| coarser.applications.round() as usize);
    Outcome { applications: outcome.applications + applications, ..outcome }
}

/// The same from pressures that bear something, or from nothing.
fn press_from(solver: &dyn Solver, step: &Step<'_>, start: Option<Start<'_>>) -> Outcome {
    let outcome =
        part::solve(solver, step, start).unwrap_or_else(|| on_the_frame(solver, step, start));
    if outcome.status != Status::FrameFull || outcome.part.is_none() {
        return outcome;
    }
    let Outcome { pressure, displacement, part, approach, .. } = &outcome;
    let start = Start { pressure, displacement, part: *part, approach: *approach };
    outcome.before(on_the_frame(solver, step, Some(start)))
}

/// The pressures of a step on the whole frame.
pub(super) fn on_the_frame(
    solver: &dyn Solver,
    step: &Step<'_>,
    start: Option<Start<'_>>,
) -> Outcome {
    let computed = start.filter(|start| start.part.is_some());
    let displacement = computed.map(|start| normal_displacement(step.compliance, start.pressure));
    let start = start.map(|start| Start {
        displacement: displacement.as_deref().unwrap_or(start.displacement),
        part: None,
        ..start
    });
    let outcome = judged(solver.solve(step, start), step, solver);
    let applications = outcome.applications + usize::from(displacement.is_some());
    Outcome { applications, ..outcome }
}

impl Outcome {
    /// The next attempt, with what both took.
    pub(super) fn before(&self, next: Self) -> Self {
        let iterations = self.iterations + next.iterations;
        Self { iterations, applications: self.applications + next.applications, ..next }
    }
}

/// Bodies that just touch.
fn apart(step: &Step<'_>) -> Outcome {
    let closing = |pair: usize| step.measure.closing.at(pair);
    let touches = |pair: usize| step.gap[pair] / closing(pair);
    let pairs = 0..step.gap.len();
    let closed = pairs.clone().filter(|&pair| closing(pair) > 0.0);
    let approach = closed.map(touches).fold(f64::INFINITY, f64::min);
    Outcome {
        status: Status::Converged,
        pressure: vec![0.0; step.gap.len()],
        displacement: vec![0.0; step.gap.len()],
        gap: pairs.map(|pair| step.gap[pair] - closing(pair) * approach).collect(),
        part: None,
        approach,
        iterations: 0,
        residual: 0.0,
        applications: 0,
    }
}

/// An outcome whose residual counts what is missing of the load.
pub(super) fn judged(outcome: Outcome, step: &Step<'_>, solver: &dyn Solver) -> Outcome {
    let carried = step.measure.load(&outcome.pressure);
    let missing = match step.control {
        // By how much the approach would be off, which grows with the load to the power 2/3.
        Control::Load(load) => ((carried / load).abs().cbrt().powi(2) - 1.0).abs(),
        Control::Approach(_) => 0.0,
    };
    let known = carried.is_finite() && outcome.approach.is_finite();
    let residual = if known { worse(outcome.residual, missing) } else { f64::NAN };
    let solved = residual <= solver.settings().tolerance;
    let status = match outcome.status {
        Status::Converged if !solved => Status::OutOfIterations,
        status => status,
    };
    Outcome { status, residual, ..outcome }
}

#[cfg(test)]
mod tests {
    use std::sync::Mutex;

    use super::{Control, Outcome, Solver, Start, Status, Step, press};
    use crate::body::profile::PROFILES;
    use crate::compliance::Compliance;
    use crate::frame::{ContactFrame, VectorField};
    use crate::parameters::Values;
    use crate::solve::Settings;

    #[derive(Debug)]
    struct Stiff;

    impl Compliance for Stiff {
        fn apply(&self, tractions: &VectorField) -> VectorField {
            VectorField::zeros(tractions.n.len())
        }

        fn normal_self_term(&self) -> f64 {
            1.0
        }
    }

    /// Claims to have converged on these pressures; the next is for the next call. Notes which calls had a start.
    #[derive(Debug)]
    struct Claims(Mutex<(Vec<f64>, Vec<bool>)>, Status);

    impl Solver for Claims {
        fn solve(&self, step: &Step<'_>, start: Option<Start<'_>>) -> Outcome {
            let mut kept = self.0.lock().unwrap();
            kept.1.push(start.is_some());
            let pressure = vec![kept.0.remove(0); step.gap.len()];
            Outcome {
                status: self.1,
                displacement: vec![0.0; pressure.len()],
                gap: vec![0.0; pressure.len()],
                part: None,
                pressure,
                approach: 1e-6,
                iterations: 3,
                residual: 0.0,
                applications: 4,
            }
        }

        fn settings(&self) -> Settings {
            Settings { tolerance: 1e-6, max_iterations: 10 }
        }
    }

    fn frame() -> ContactFrame {
        let flat = PROFILES.iter().find(|choice| choice.name == "flat").unwrap();
        let flat = (flat.build)(&Values::default()).unwrap();
        ContactFrame::uniform([2.0; 2], [2; 2], [&*flat, &*flat]).unwrap()
    }

    /// Status and iterations on four pairs of 1 m^2 under a load of 4 N, and which calls had a start.
    fn pressed(claims: &[f64], status: Status, start: Option<f64>) -> (Status, usize, Vec<bool>) {
        let frame = frame();
        let (gap, addition) = (vec![0.0; 4], vec![0.0; 4]);
        let step = Step {
            compliance: &Stiff,
            gap: &gap,
            addition: &addition,
            elements: [2, 2],
            measure: frame.measure(),
            control: Control::Load(4.0),
            hardness: f64::INFINITY,
        };
        let from = start.map(|pressure| vec![pressure; 4]);
        let start = from.as_ref().map(|pressure| Start {
            pressure,
            displacement: &gap,
            part: None,
            approach: 1e-6,
        });
        let solver = Claims(Mutex::new((claims.to_vec(), vec![])), status);
        let outcome = press(&solver, &step, start);
        (outcome.status, outcome.iterations, solver.0.into_inner().unwrap().1)
    }

    /// Whatever a solver claims, it has to carry the load.
    #[test]
    fn claims_are_held_against_the_load() {
        let (claims, fails) = (Status::Converged, Status::OutOfIterations);
        assert_eq!(pressed(&[1.0], claims, None), (claims, 3, vec![false]));
        for carried in [0.0, 0.9, 1.1, f64::NAN] {
            assert_eq!(pressed(&[carried], claims, None), (fails, 3, vec![false]));
        }
    }

    /// A start that bears nothing does not count, and a failure is one.
    #[test]
    fn what_bears_nothing_is_no_start() {
        let (claims, fails) = (Status::Converged, Status::OutOfIterations);
        assert_eq!(pressed(&[1.0], claims, Some(2.0)), (claims, 3, vec![true]));
        assert_eq!(pressed(&[0.5], claims, Some(2.0)), (fails, 3, vec![true]));
        for nothing in [0.0, f64::NAN] {
            assert_eq!(pressed(&[1.0], claims, Some(nothing)), (claims, 3, vec![false]));
        }
        let full = Status::FrameFull;
        assert_eq!(pressed(&[1.0], full, Some(2.0)), (full, 3, vec![true]));
    }

    /// Under no load the bodies touch where they are closest.
    #[test]
    fn bodies_without_load_just_touch() {
        let frame = frame();
        let (gap, addition) = ([3.0, 1.0, 2.0, 5.0], [0.0; 4]);
        let step = Step {
            compliance: &Stiff,
            gap: &gap,
            addition: &addition,
            elements: [2, 2],
            measure: frame.measure(),
            control: Control::Load(0.0),
            hardness: f64::INFINITY,
        };
        let solver = Claims(Mutex::new((vec![], vec![])), Status::Converged);
        let outcome = press(&solver, &step, None);
        assert_eq!((outcome.approach, outcome.gap), (1.0, vec![2.0, 0.0, 1.0, 4.0]));
        assert_eq!(outcome.pressure, [0.0; 4]);
    }
}
