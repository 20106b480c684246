//! Gauss-Seidel sweeps over the pairs, each of which closes its own gap under the pressures as they are.
//!
//! p_i <- max(0, p_i - g_i / c_ii), pair by pair, forwards and backwards in turn, every change at once felt by all
//! gaps (P. Wriggers, *Computational Contact Mechanics*, 2nd ed., Springer 2006, ch. 5; O. L. Mangasarian,
//! *J. Optim. Theory Appl.* 22 (1977) 465, for the convergence on symmetric positive definite matrices). After a
//! sweep the pressures are scaled to a load that is given, and the approach is that at which they do no work on
//! the gaps.
//!
//! A sweep takes a column of the matrix for every pair that changes, as much as an application; elsewhere than on
//! meshed bodies the matrix has to be made first, by an application a pair.

use faer::Mat;

use super::residual::Measure;
use super::start::first_guess;
use super::{Outcome, PARAMETERS, Settings, Solver, Start, Status, Step, TOLERANCE};
use crate::kinematics::Control;
use crate::numerics::vector::{in_pool, sum_with, update};
use crate::parameters::Choice;

pub(super) const CHOICE: Choice<Box<dyn Solver>> = Choice {
    name: "gauss_seidel",
    meaning: "projected Gauss-Seidel sweeps, pair by pair; for meshed bodies",
    parameters: PARAMETERS,
    build: |values| {
        Ok(Box::new(GaussSeidel { settings: Settings::read(values, TOLERANCE, 5_000) }))
    },
};

/// See the module.
#[derive(Debug)]
struct GaussSeidel {
    settings: Settings,
}

impl Solver for GaussSeidel {
    fn solve(&self, step: &Step<'_>, start: Option<Start<'_>>) -> Outcome {
        in_pool(|| {
            let mut sweeps = Sweeps::new(step, start);
            let mut count = 0;
            loop {
                let mut residual = sweeps.residual();
                if residual <= self.settings.tolerance {
                    // Once more without what the sweeps have rounded.
                    sweeps.refresh();
                    residual = sweeps.residual();
                }
                let status = if residual <= self.settings.tolerance {
                    sweeps.converged()
                } else if count >= self.settings.max_iterations || residual.is_nan() {
                    Status::OutOfIterations
                } else {
                    count += 1;
                    sweeps.sweep(count % 2 == 1);
                    sweeps.meet_load();
                    continue;
                };
                return sweeps.finish(status, count, residual);
            }
        })
    }

    fn settings(&self) -> Settings {
        self.settings
    }

    /// The matrix of all pairs.
    fn memory(&self, pairs: f64, _in_contact: f64) -> f64 {
        8.0 * pairs * pairs
    }
}

/// The state of an iteration.
struct Sweeps<'a> {
    step: &'a Step<'a>,
    /// Gap of each row under the pressure of each column (m/Pa), the addition apart.
    matrix: Mat<f64>,
    pressure: Vec<f64>,
    /// Displacement the compliance makes of the pressure (m).
    displacement: Vec<f64>,
    approach: f64,
    gap: Vec<f64>,
    applications: usize,
}

impl<'a> Sweeps<'a> {
    fn new(step: &'a Step<'a>, start: Option<Start<'_>>) -> Self {
        let (pressure, approach) = match start {
            Some(start) => (start.pressure.to_vec(), start.approach),
            None => first_guess(step),
        };
        let pairs: Vec<usize> = (0..pressure.len()).collect();
        let zeros = vec![0.0; pairs.len()];
        let mut sweeps = Self {
            step,
            matrix: step.compliance.normal_matrix(&pairs, pairs.len()),
            pressure,
            displacement: zeros.clone(),
            approach,
            gap: zeros,
            applications: 0,
        };
        sweeps.refresh();
        sweeps.meet_load();
        sweeps
    }

    /// Computes the displacement anew from the pressure, and the gap.
    fn refresh(&mut self) {
        self.applications += 1;
        self.step.compliance.apply_normal(&self.pressure, &mut self.displacement);
        self.open();
    }

    /// The gap at the present displacement and approach.
    fn open(&mut self) {
        for (pair, gap) in self.gap.iter_mut().enumerate() {
            *gap = self.step.gap[pair]
                + self.displacement[pair]
                + self.step.addition[pair] * self.pressure[pair]
                - self.step.measure.closing.at(pair) * self.approach;
        }
    }

    /// Scales the pressures to a load that is given, with the approach at which the gaps are zero in the mean
    /// over them; takes an approach that is given.
    fn meet_load(&mut self) {
        match self.step.control {
            Control::Approach(approach) if approach == self.approach => return,
            Control::Approach(approach) => self.approach = approach,
            Control::Load(load) => {
                let measure = self.step.measure;
                if measure.load(&self.pressure) <= 0.0 {
                    // The sweep has parted the bodies: on from where they touch.
                    (self.pressure, self.approach) = first_guess(self.step);
                    self.refresh();
                }
                let factor = load / measure.load(&self.pressure);
                update(&mut self.pressure, [], |pressure, []| factor * pressure);
                update(&mut self.displacement, [], |displacement, []| factor * displacement);
                self.open();
                let [work, pressed] = sum_with(
                    [measure.weight, measure.closing],
                    [&self.pressure, &self.gap],
                    |[weight, closing], [p, gap]| [weight * p * gap, weight * p * closing],
                );
                self.approach += work / pressed;
            }
        }
        self.open();
    }

    /// Goes once through all pairs.
    fn sweep(&mut self, forwards: bool) {
        self.applications += 1;
        let pairs = self.pressure.len();
        for index in 0..pairs {
            let pair = if forwards { index } else { pairs - 1 - index };
            let column = self.matrix.col_as_slice(pair);
            let addition = self.step.addition[pair];
            let before = self.pressure[pair];
            let pressure = (before - self.gap[pair] / (column[pair] + addition)).max(0.0);
            let change = pressure - before;
            if change != 0.0 {
                self.pressure[pair] = pressure;
                for (gap, own) in self.gap.iter_mut().zip(column) {
                    *gap += change * own;
                }
                self.gap[pair] += change * addition;
            }
        }
        for (pair, displacement) in self.displacement.iter_mut().enumerate() {
            let closed = self.step.measure.closing.at(pair) * self.approach;
            let added = self.step.addition[pair] * self.pressure[pair];
            *displacement = self.gap[pair] - self.step.gap[pair] - added + closed;
        }
    }

    fn residual(&self) -> f64 {
        Measure::of(self.step).residual(self.step, &self.pressure, &self.gap)
    }

    /// A solution, unless the frame cuts it off.
    fn converged(&self) -> Status {
        let full = !self.step.measure.closed && self.pressure.iter().all(|&p| p > 0.0);
        if full { Status::FrameFull } else { Status::Converged }
    }

    fn finish(self, status: Status, iterations: usize, residual: f64) -> Outcome {
        let Self { pressure, displacement, gap, approach, applications, .. } = self;
        Outcome {
            status,
            pressure,
            displacement,
            gap,
            approach,
            iterations,
            residual,
            applications,
        }
    }
}
