//! Preconditioned conjugate gradients on the set of pairs in contact.
//!
//! Pressures that become negative leave the set, pairs that overlap join it (I. A. Polonsky and
//! L. M. Keer, *Wear* 231 (1999) 206; E. A. H. Vollebregt, *J. Comput. Phys.* 257 (2014) 333, for the
//! preconditioner by Fourier transforms). The load is a constraint of the same iteration: directions
//! are projected, in the metric of the preconditioner, on those that do not change it, and the
//! approach is the multiplier. The displacement follows by recurrence, so that an iteration applies
//! the compliance once, and once more only where pressures were cut off. Products of fields are weighted by
//! the areas of the pairs, in which the compliance is symmetric.

use super::residual::Measure;
use super::start::first_guess;
use super::{Outcome, PARAMETERS, Settings, Solver, Start, Status, Step, TOLERANCE};
use crate::compliance::Preconditioner;
use crate::motion::Control;
use crate::numerics::vector::{Values, in_pool, map, sum, sum_with, sweep, sweep_with, update};
use crate::parameters::Choice;

pub(super) const CHOICE: Choice<Box<dyn Solver>> = Choice {
    name: "conjugate_gradient",
    meaning: "preconditioned conjugate gradients on the pairs in contact",
    parameters: PARAMETERS,
    build: |values| {
        Ok(Box::new(ConjugateGradient::new(Settings::read(
            values,
            ConjugateGradient::default().settings,
        )?)))
    },
};

/// Preconditioned conjugate gradients on the pairs in contact, by default to 1e-8 in 500 iterations.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ConjugateGradient {
    settings: Settings,
}

impl ConjugateGradient {
    /// The solver with these settings.
    pub fn new(settings: Settings) -> Self {
        Self { settings }
    }
}

impl Default for ConjugateGradient {
    fn default() -> Self {
        Self::new(Settings { tolerance: TOLERANCE, max_iterations: 500 })
    }
}

impl Solver for ConjugateGradient {
    fn solve(&self, step: &Step<'_>, start: Option<Start<'_>>) -> Outcome {
        in_pool(|| self.iterate(Iteration::new(step, start)))
    }

    fn settings(&self) -> Settings {
        self.settings
    }
}

impl ConjugateGradient {
    fn iterate(&self, mut iteration: Iteration<'_>) -> Outcome {
        loop {
            let residual = iteration.balance();
            let status = if residual <= self.settings.tolerance {
                iteration.converged()
            } else if iteration.count == self.settings.max_iterations || residual.is_nan() {
                Status::OutOfIterations
            } else {
                iteration.advance();
                continue;
            };
            return iteration.finish(status, residual);
        }
    }
}

/// The state of an iteration.
struct Iteration<'a> {
    step: &'a Step<'a>,
    preconditioner: Box<dyn Preconditioner + 'a>,
    /// Pressure (Pa) and the displacement the compliance makes of it (m).
    pressure: Vec<f64>,
    displacement: Vec<f64>,
    approach: f64,
    /// Gap (m) at the present pressure and approach.
    gap: Vec<f64>,
    /// One where the pressure may change, zero elsewhere; how many ones, and whether they are those
    /// of the last iteration.
    contact: Vec<f64>,
    touching: usize,
    same_contact: bool,
    /// The gap of the contact, zero elsewhere (m).
    overlap: Vec<f64>,
    /// What the preconditioner makes of the gap and of the gap that an approach of one closes, on the contact.
    correction: Vec<f64>,
    uniform: Vec<f64>,
    uniform_sum: f64,
    /// Product of the correction with the gap, now and at the last iteration.
    product: f64,
    last_product: f64,
    /// Search direction (Pa) and the displacement the compliance makes of it (m).
    direction: Vec<f64>,
    response: Vec<f64>,
    count: usize,
    applications: usize,
}

impl<'a> Iteration<'a> {
    fn new(step: &'a Step<'a>, start: Option<Start<'_>>) -> Self {
        let pairs = step.gap.len();
        let (pressure, approach) = match start {
            Some(start) => (start.pressure.to_vec(), start.approach),
            None => first_guess(step),
        };
        let [total, count] = sum([&pressure, step.addition], |[pressure, addition]| {
            let contact = f64::from(pressure > 0.0);
            [contact * addition, contact]
        });
        let addition = if count > 0.0 { total / count } else { 0.0 };
        let zeros = || vec![0.0; pairs];
        let mut iteration = Self {
            step,
            preconditioner: step.compliance.normal_preconditioner(addition),
            pressure,
            displacement: start.map_or_else(zeros, |start| start.displacement.to_vec()),
            approach,
            gap: zeros(),
            contact: zeros(),
            touching: 0,
            same_contact: false,
            overlap: zeros(),
            correction: zeros(),
            uniform: zeros(),
            uniform_sum: 0.0,
            product: 0.0,
            last_product: 0.0,
            direction: zeros(),
            response: zeros(),
            count: 0,
            applications: 0,
        };
        iteration.meet_load();
        if start.is_none() {
            iteration.refresh();
        }
        iteration
    }

    /// Whether the load is given, and the approach unknown.
    fn load(&self) -> Option<f64> {
        match self.step.control {
            Control::Load(load) => Some(load),
            Control::Approach(_) => None,
        }
    }

    /// How each pair counts, and how much of the approach closes its gap.
    fn beside(&self) -> [Values<'a>; 2] {
        [self.step.measure.weight, self.step.measure.closing]
    }

    /// Scales the pressures to the load asked for, and the displacement with them.
    fn meet_load(&mut self) {
        let Some(load) = self.load() else { return };
        let factor = load / self.step.measure.load(&self.pressure);
        update(&mut self.pressure, [], |pressure, []| factor * pressure);
        update(&mut self.displacement, [], |displacement, []| factor * displacement);
    }

    /// Computes the displacement anew from the pressure.
    fn refresh(&mut self) {
        self.applications += 1;
        self.step.compliance.apply_normal(&self.pressure, &mut self.displacement);
        self.same_contact = false;
    }

    /// Finds the gap, the contact, the correction and, under a given load, the approach; returns the
    /// residual.
    fn balance(&mut self) -> f64 {
        if let Control::Approach(approach) = self.step.control {
            self.approach = approach;
        }
        self.find_contact();
        self.preconditioner.apply(&self.overlap, &mut self.correction);
        let shift = if self.load().is_some() { self.approach_change() } else { 0.0 };
        self.approach += shift;
        let measure = Measure::of(self.step);
        let [violations, pressures, product] = sweep_with(
            self.beside(),
            [&mut self.gap, &mut self.overlap, &mut self.correction],
            [&self.pressure, &self.contact, &self.uniform, self.step.addition],
            |[weight, closing],
             [gap, overlap, correction],
             [pressure, contact, uniform, addition]| {
                let (gap, overlap) = (gap - shift * closing, overlap - shift * closing * contact);
                let correction = contact * (correction - shift * uniform);
                let violation = measure.violation(pressure, gap, addition);
                let sums = [violation * violation, pressure * pressure, overlap * correction];
                ([gap, overlap, correction], sums.map(|sum| weight * sum))
            },
        );
        self.product = product;
        Measure::relative(violations, pressures)
    }

    /// Takes the pairs under pressure and those that overlap as the contact.
    fn find_contact(&mut self) {
        let approach = self.approach;
        let [touching, changed] = sweep_with(
            [self.step.measure.closing],
            [&mut self.gap, &mut self.contact, &mut self.overlap],
            [self.step.gap, &self.displacement, &self.pressure, self.step.addition],
            |[closing], [_, before, _], [undeformed, displacement, pressure, addition]| {
                let gap = undeformed + displacement + addition * pressure - closing * approach;
                let contact = f64::from(pressure > 0.0 || gap < 0.0);
                ([gap, contact, contact * gap], [contact, f64::from(contact != before)])
            },
        );
        self.touching = touching as usize;
        self.same_contact &= changed == 0.0;
    }

    /// The change of the approach (m) that lets the correction keep the load.
    fn approach_change(&mut self) -> f64 {
        let load = |beside: [f64; 2], [contact, pressure]: [f64; 2]| {
            let [weight, closing] = beside;
            [weight * closing * contact * pressure]
        };
        if !self.same_contact {
            match self.step.measure.closing {
                Values::All(_) => self.preconditioner.apply(&self.contact, &mut self.uniform),
                Values::Each(closing) => {
                    let closed =
                        map([&self.contact, closing], |[contact, closing]| contact * closing);
                    self.preconditioner.apply(&closed, &mut self.uniform);
                }
            }
            [self.uniform_sum] = sum_with(self.beside(), [&self.contact, &self.uniform], load);
        }
        let [total] = sum_with(self.beside(), [&self.contact, &self.correction], load);
        total / self.uniform_sum
    }

    /// Goes along a new direction to its lowest energy, and cuts off what became negative.
    fn advance(&mut self) {
        self.count += 1;
        let conjugates = self.same_contact && self.last_product > 0.0;
        let conjugation = if conjugates { self.product / self.last_product } else { 0.0 };
        self.last_product = self.product;
        update(&mut self.direction, [&self.correction], |direction, [correction]| {
            conjugation * direction - correction
        });
        self.applications += 1;
        self.step.compliance.apply_normal(&self.direction, &mut self.response);
        let [slope, curvature] = sum_with(
            [self.step.measure.weight],
            [&self.direction, &self.response, &self.overlap, self.step.addition],
            |[weight], [direction, response, overlap, addition]| {
                let curvature = direction * (response + addition * direction);
                [weight * (-overlap * direction), weight * curvature]
            },
        );
        // A pair alone under a load has no direction to go: those that overlap beside it join it next.
        let length = if curvature > 0.0 { slope / curvature } else { 0.0 };
        let [cut] = sweep(
            [&mut self.pressure, &mut self.displacement],
            [&self.direction, &self.response],
            |[pressure, displacement], [direction, response]| {
                let pressure = pressure + length * direction;
                ([pressure.max(0.0), displacement + length * response], [f64::from(pressure < 0.0)])
            },
        );
        self.same_contact = true;
        if cut > 0.0 {
            self.meet_load();
            self.refresh();
        }
    }

    /// A solution, unless the frame cuts it off.
    fn converged(&self) -> Status {
        let full = self.touching == self.pressure.len() && !self.step.measure.closed;
        if full { Status::FrameFull } else { Status::Converged }
    }

    fn finish(self, status: Status, residual: f64) -> Outcome {
        Outcome {
            status,
            pressure: self.pressure,
            displacement: self.displacement,
            gap: self.gap,
            part: None,
            approach: self.approach,
            iterations: self.count,
            residual,
            applications: self.applications,
        }
    }
}
