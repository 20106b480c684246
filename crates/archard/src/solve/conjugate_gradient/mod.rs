//! Preconditioned conjugate gradients on sets of pairs in contact.
//!
//! A primal-dual active set method (M. Hintermüller, K. Ito and K. Kunisch, *SIAM J. Optim.* 13 (2003) 865): in contact are
//! the pairs with p > g / c, c the compliance of a pair to its own pressure. Conjugate gradients close the gap on that set
//! without cutting off any pressure, so that directions stay conjugate; then the set is chosen anew. A set is kept until
//! the violations of the pairs that are about to change sides outweigh the gaps left on it: the proportioning of Z.
//! Dostál and J. Schöberl, *Comput. Optim. Appl.* 30 (2005) 23, with their factor of one. Sets that are solved exactly
//! shrink until they are right where the inverse of the compliance is an M-matrix, which it nearly is. Where a new set
//! has not brought the residual down, the next are therefore solved more exactly.
//!
//! The preconditioner works by Fourier transforms (E. A. H. Vollebregt, *J. Comput. Phys.* 257 (2014) 333). The load is a
//! constraint of the same iteration: directions are projected, in the metric of the preconditioner, on those that do not
//! change it, and the approach is the multiplier. The displacement follows by recurrence, so that an iteration applies the
//! compliance once, and once more where pairs under pressure leave the set. Products of fields are weighted by the areas
//! of the pairs, in which the compliance is symmetric.
//!
//! Where bodies yield, pairs at the hardness are held there as others are at no pressure, until their gap opens: the scheme of
//! I. A. Polonsky and L. M. Keer, *Wear* 231 (1999) 206, with a second bound. What a load leaves next to them is borne by the set
//! alone. Where the set cannot, pressures are projected on those between the bounds that bear the load.

mod set;

use super::contact_set::{Proportioning, Violations, settle};
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
        in_pool(|| step.overloaded().unwrap_or_else(|| self.iterate(Iteration::new(step, start))))
    }

    fn settings(&self) -> Settings {
        self.settings
    }
}

impl ConjugateGradient {
    fn iterate(&self, mut iteration: Iteration<'_>) -> Outcome {
        let Settings { tolerance, max_iterations } = self.settings;
        let mut proportioning = Proportioning::default();
        loop {
            let violations = iteration.find_gap();
            let residual = violations.residual();
            if residual <= tolerance {
                if iteration.cut_off() {
                    continue;
                }
                let status = iteration.converged();
                return iteration.finish(status, residual);
            }
            if iteration.count == max_iterations || residual.is_nan() {
                return iteration.finish(Status::OutOfIterations, residual);
            }
            if proportioning.asks_for_another_set(&violations) && iteration.change_set() {
                proportioning.changed(residual);
                iteration.find_gap();
            }
            iteration.advance();
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
    /// Gap (m) at the present pressure and approach, and the same on the contact, zero elsewhere.
    gap: Vec<f64>,
    overlap: Vec<f64>,
    /// The set: one where the pressure may change, zero elsewhere, where it is nothing or the hardness.
    contact: Vec<f64>,
    /// What the preconditioner makes of the gap that an approach of one closes, on the contact, and the load of it.
    uniform: Vec<f64>,
    uniform_load: f64,
    /// Product of the correction with the overlap at the last iteration on this set; zero at its first.
    last_product: f64,
    /// Search direction (Pa).
    direction: Vec<f64>,
    /// What the preconditioner makes of the overlap (Pa), then the displacement the compliance makes of the direction (m).
    image: Vec<f64>,
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
            overlap: zeros(),
            contact: zeros(),
            uniform: zeros(),
            uniform_load: 0.0,
            last_product: 0.0,
            direction: zeros(),
            image: zeros(),
            count: 0,
            applications: 0,
        };
        if let Control::Approach(approach) = step.control {
            iteration.approach = approach;
        }
        iteration.meet_load();
        if start.is_none() {
            iteration.refresh();
        }
        update(&mut iteration.contact, [&iteration.pressure], |_, [p]| f64::from(p > 0.0));
        iteration.begin_set();
        let [beyond] = sum([&iteration.pressure], |[p]| [f64::from(p > step.hardness)]);
        if beyond > 0.0 {
            iteration.find_gap();
            iteration.cut_off();
        }
        iteration
    }

    /// The load that is given while the approach is unknown.
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

    /// Scales all pressures to the load asked for, and the displacement with them.
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
    }

    /// Finds the gap and, under a given load, the approach that suits the set; returns what violates the conditions.
    fn find_gap(&mut self) -> Violations {
        let approach = self.approach;
        let [mean] = sweep_with(
            self.beside(),
            [&mut self.gap],
            [self.step.gap, &self.displacement, &self.pressure, self.step.addition, &self.uniform],
            |[weight, closing], [_], [undeformed, displacement, pressure, addition, uniform]| {
                let gap = undeformed + displacement + addition * pressure - closing * approach;
                ([gap], [weight * uniform * gap])
            },
        );
        let shift = if self.uniform_load > 0.0 { mean / self.uniform_load } else { 0.0 };
        self.approach += shift;
        let measure = Measure::of(self.step);
        let own = self.step.compliance.normal_self_term();
        let hardness = self.step.hardness;
        let [gaps, changing, all, pressures] = sweep_with(
            self.beside(),
            [&mut self.gap, &mut self.overlap],
            [&self.pressure, &self.contact, self.step.addition],
            |[weight, closing], [gap, _], [pressure, contact, addition]| {
                let gap = gap - shift * closing;
                let overlap = contact * gap;
                let left = overlap / (own + addition);
                let violation = measure.violation(pressure, gap, addition);
                let square = violation * violation;
                let own = own + addition;
                let changes = settle(pressure, gap, own, hardness) != [pressure, contact];
                let changing = if changes { square } else { 0.0 };
                let sums = [left * left, changing, square, pressure * pressure];
                ([gap, overlap], sums.map(|sum| weight * sum))
            },
        );
        Violations { gaps, changing, all, pressures }
    }

    /// Prepares the iteration on another set.
    fn begin_set(&mut self) {
        self.last_product = 0.0;
        self.preconditioner.keep_to(&self.contact);
        if self.load().is_none() {
            return;
        }
        match self.step.measure.closing {
            Values::All(_) => self.preconditioner.apply(&self.contact, &mut self.uniform),
            Values::Each(closing) => {
                let closed = map([&self.contact, closing], |[contact, closing]| contact * closing);
                self.preconditioner.apply(&closed, &mut self.uniform);
            }
        }
        [self.uniform_load] = sweep_with(
            self.beside(),
            [&mut self.uniform],
            [&self.contact],
            |[weight, closing], [uniform], [contact]| {
                let uniform = contact * uniform;
                ([uniform], [weight * closing * uniform])
            },
        );
    }

    /// Goes along a new direction to its lowest energy.
    fn advance(&mut self) {
        self.count += 1;
        self.turn();
        self.applications += 1;
        self.step.compliance.apply_normal(&self.direction, &mut self.image);
        let [slope, curvature] = sum_with(
            [self.step.measure.weight],
            [&self.direction, &self.image, &self.overlap, self.step.addition],
            |[weight], [direction, response, overlap, addition]| {
                let curvature = direction * (response + addition * direction);
                [weight * (-overlap * direction), weight * curvature]
            },
        );
        // A pair alone under a load has no direction to go: those that overlap next to it join it next.
        let length = if curvature > 0.0 { slope / curvature } else { 0.0 };
        let [] = sweep(
            [&mut self.pressure, &mut self.displacement],
            [&self.direction, &self.image],
            |[pressure, displacement], [direction, response]| {
                ([pressure + length * direction, displacement + length * response], [])
            },
        );
    }

    /// Finds the next direction: the preconditioned overlap that leaves the load as it is, conjugate to the direction
    /// before.
    fn turn(&mut self) {
        self.preconditioner.apply(&self.overlap, &mut self.image);
        let [product, load] = sum_with(
            self.beside(),
            [&self.overlap, &self.image, &self.contact],
            |[weight, closing], [overlap, correction, contact]| {
                [weight * (overlap * correction), weight * closing * contact * correction]
            },
        );
        let shift = if self.uniform_load > 0.0 { load / self.uniform_load } else { 0.0 };
        let conjugation = if self.last_product > 0.0 { product / self.last_product } else { 0.0 };
        self.last_product = product;
        update(
            &mut self.direction,
            [&self.image, &self.uniform, &self.contact],
            |direction, [correction, uniform, contact]| {
                conjugation * direction - (contact * correction - shift * uniform)
            },
        );
    }

    /// A solution, unless the frame cuts it off.
    fn converged(&self) -> Status {
        let [touching] = sum([&self.pressure], |[pressure]| [f64::from(pressure > 0.0)]);
        let full = touching as usize == self.contact.len() && !self.step.measure.closed;
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
