//! The paper's Uzawa iteration (eqs. 44 to 50), the reference the other solvers are held against.
//!
//! p <- max(0, p - r g) on every pair at once, with the gap g at the pressure p. The iteration converges
//! for 0 < r < 2 / lambda_max; the penalty r is computed from a bound on the largest eigenvalue. A given
//! load is met by an outer iteration on the approach.

use super::residual::Measure;
use super::start::first_guess;
use super::{Outcome, PARAMETERS, RELAXATION, Settings, Solver, Start, Status, Step, TOLERANCE};
use crate::motion::Control;
use crate::numerics::vector;
use crate::parameters::Choice;

pub(super) const CHOICE: Choice<Box<dyn Solver>> = Choice {
    name: "uzawa",
    meaning: "the paper's Uzawa iteration; slow, the reference for the others",
    parameters: PARAMETERS,
    build: |values| Ok(Box::new(Uzawa::new(Settings::read(values, Uzawa::default().settings)?))),
};

/// The paper's Uzawa iteration, by default to 1e-8 in a million iterations.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Uzawa {
    settings: Settings,
}

impl Uzawa {
    /// The solver with these settings.
    pub fn new(settings: Settings) -> Self {
        Self { settings }
    }
}

impl Default for Uzawa {
    fn default() -> Self {
        Self::new(Settings { tolerance: TOLERANCE, max_iterations: 1_000_000 })
    }
}

impl Solver for Uzawa {
    fn solve(&self, step: &Step<'_>, start: Option<Start<'_>>) -> Outcome {
        if let Some(overloaded) = step.overloaded() {
            return overloaded;
        }
        let (pressure, approach) = match start {
            Some(start) => (start.pressure.to_vec(), start.approach),
            None => first_guess(step),
        };
        vector::in_pool(|| {
            let mut iteration = Iteration::new(step, pressure, self.settings);
            match step.control {
                Control::Approach(approach) => iteration.settle(approach),
                Control::Load(load) => iteration.meet(load, approach),
            }
        })
    }

    fn settings(&self) -> Settings {
        self.settings
    }
}

/// Pressures on their way to the solution.
struct Iteration<'a> {
    step: &'a Step<'a>,
    settings: Settings,
    /// r (Pa/m).
    penalty: f64,
    pressure: Vec<f64>,
    displacement: Vec<f64>,
    gap: Vec<f64>,
    count: usize,
    applications: usize,
}

impl<'a> Iteration<'a> {
    fn new(step: &'a Step<'a>, pressure: Vec<f64>, settings: Settings) -> Self {
        let bound = largest_eigenvalue(step);
        let zeros = vec![0.0; pressure.len()];
        let (displacement, gap) = (zeros.clone(), zeros);
        Self {
            step,
            settings,
            penalty: RELAXATION / bound,
            pressure,
            displacement,
            gap,
            count: 0,
            applications: 1,
        }
    }

    /// Iterates at a fixed approach (m).
    fn settle(&mut self, approach: f64) -> Outcome {
        loop {
            self.applications += 1;
            self.step.compliance.apply_normal(&self.pressure, &mut self.displacement);
            let opening = [self.step.gap, &self.displacement, self.step.addition, &self.pressure];
            let [] = vector::sweep_with(
                [self.step.measure.closing],
                [&mut self.gap],
                opening,
                |[closing], [_], [gap, displacement, addition, pressure]| {
                    ([gap + displacement + addition * pressure - closing * approach], [])
                },
            );
            let residual = Measure::of(self.step).residual(self.step, &self.pressure, &self.gap);
            let status = if residual <= self.settings.tolerance {
                Status::Converged
            } else if self.count >= self.settings.max_iterations || residual.is_nan() {
                Status::OutOfIterations
            } else {
                self.count += 1;
                let (penalty, hardness) = (self.penalty, self.step.hardness);
                vector::update(&mut self.pressure, [&self.gap], |p, [gap]| {
                    (p - penalty * gap).max(0.0).min(hardness)
                });
                continue;
            };
            let full = !self.step.measure.closed && self.pressure.iter().all(|&p| p > 0.0);
            return self.outcome(if full { Status::FrameFull } else { status }, approach, residual);
        }
    }

    /// Finds the approach that answers to a load (N), starting from a guess (m): secants on the load to the power 2/3, which is
    /// proportional to the approach for a sphere, or the middle between what is known to be too little and too much where a secant
    /// leaves these. Pairs yield one after the other: between two of them the load may not rise with the approach.
    fn meet(&mut self, load: f64, guess: f64) -> Outcome {
        let lowest = self.step.gap.iter().copied().fold(f64::INFINITY, f64::min);
        let measure = self.step.measure;
        let reached = |pressure: &[f64]| measure.load(pressure);
        let excess_of = |force: f64| (force / load).cbrt().powi(2) - 1.0;
        let [mut little, mut much] = [lowest, f64::INFINITY];
        let mut last = (lowest, -1.0);
        // A guess at which nothing touches does not count.
        let mut approach = if guess > lowest { guess } else { first_guess(self.step).1 };
        loop {
            let outcome = self.settle(approach);
            let excess = excess_of(reached(&outcome.pressure));
            let settled = excess.abs() <= self.settings.tolerance;
            // A frame that is full of more than the load need not be full of it.
            let beyond = outcome.status == Status::FrameFull && excess > 0.0;
            if settled || !(beyond || outcome.status == Status::Converged) {
                return outcome;
            }
            if excess > 0.0 {
                much = approach
            } else {
                little = approach
            }
            let between = if much.is_finite() {
                0.5 * (little + much)
            } else {
                approach + (approach - lowest)
            };
            if self.count >= self.settings.max_iterations || between == approach {
                return Outcome { status: Status::OutOfIterations, ..outcome };
            }
            let secant = approach - excess * (approach - last.0) / (excess - last.1);
            last = (approach, excess);
            approach = if little < secant && secant < much { secant } else { between };
        }
    }

    fn outcome(&self, status: Status, approach: f64, residual: f64) -> Outcome {
        Outcome {
            status,
            pressure: self.pressure.clone(),
            displacement: self.displacement.clone(),
            gap: self.gap.clone(),
            part: None,
            approach,
            iterations: self.count,
            residual,
            applications: self.applications,
        }
    }
}

/// An upper bound on the largest eigenvalue of the step's operator (m/Pa): the largest sum of a row, since no element is negative.
fn largest_eigenvalue(step: &Step<'_>) -> f64 {
    let mut rows = vec![0.0; step.gap.len()];
    step.compliance.apply_normal(&vec![1.0; rows.len()], &mut rows);
    vector::update(&mut rows, [step.addition], |row, [addition]| row + addition);
    rows.into_iter().fold(0.0, f64::max)
}
