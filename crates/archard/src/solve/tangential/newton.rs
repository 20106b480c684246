//! Semismooth Newton steps on the projection, solved by Krylov iterations, from coarse elements to fine.
//!
//! P. Alart and A. Curnier, *Comput. Methods Appl. Mech. Engrg.* 92 (1991) 353, for friction by projection. A step solves
//! a [linear system](super::linear). One that does not lower the residual is shortened; where that does not help, steps
//! of projection and contraction come between. Without a solution to start from, the problem is solved
//! on elements of twice the size first, so that few steps remain on the finest whatever their number.

use super::contraction::Contraction;
use super::linear::Linear;
use super::pairs::Pairs;
use super::{FrictionSolver, Outcome, Start, Step, TOLERANCE};
use crate::compliance::Coarser;
use crate::frame::Measure;
use crate::numerics::vector::in_pool;
use crate::parameters::Choice;
use crate::solve::blocks::{Blocks, FEWEST};
use crate::solve::semismooth::{Forcing, shorten};
use crate::solve::{PARAMETERS, Settings, Status, monolithic};

pub(super) const CHOICE: Choice<Box<dyn FrictionSolver>> = Choice {
    name: "newton",
    meaning: "semismooth Newton with Krylov iterations, from coarse elements to fine",
    parameters: PARAMETERS,
    build: |values| Ok(Box::new(Newton::new(Settings::read(values, Newton::default().settings)?))),
};

/// Steps of projection and contraction that come between. A choice of cost: they converge by themselves, in any number.
const BETWEEN: usize = 5;

/// Semismooth Newton with Krylov iterations, from coarse elements to fine, by default to 1e-6 in 200 iterations.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Newton {
    settings: Settings,
}

impl Newton {
    /// The solver with these settings.
    pub fn new(settings: Settings) -> Self {
        Self { settings }
    }
}

impl Default for Newton {
    fn default() -> Self {
        Self::new(Settings { tolerance: TOLERANCE, max_iterations: 200 })
    }
}

impl FrictionSolver for Newton {
    fn solve(&self, step: &Step<'_>, start: Option<Start<'_>>) -> Outcome {
        in_pool(|| match start {
            Some(start) => self.iterate(step, Some(start)),
            None => self.descend(step),
        })
    }

    fn solve_jointly(
        &self,
        step: &monolithic::Step<'_>,
        start: &monolithic::Solution,
        foreseen: Option<&monolithic::Solution>,
    ) -> Option<monolithic::Outcome> {
        Some(in_pool(|| monolithic::solve(step, start, foreseen, self.settings)))
    }

    fn with_tolerance(&self, tolerance: f64) -> Box<dyn FrictionSolver> {
        Box::new(Self::new(Settings { tolerance, ..self.settings }))
    }

    fn settings(&self) -> Settings {
        self.settings
    }
}

impl Newton {
    /// Solves on coarser elements first, if there are enough.
    fn descend(&self, step: &Step<'_>) -> Outcome {
        let pairs = step.limit.iter().filter(|&&limit| limit > 0.0).count();
        let fewest = step.elements[0].min(step.elements[1]);
        if pairs < FEWEST * FEWEST || fewest < FEWEST {
            return self.iterate(step, None);
        }
        let Some(Coarser { map, elements, slip: factor }) = step.map.coarser() else {
            return self.iterate(step, None);
        };
        let blocks = Blocks { fine: step.elements, coarse: elements };
        let [limit, one, two] = [step.limit, step.rigid[0], step.rigid[1]].map(|f| blocks.mean(f));
        let [one, two] =
            [one, two].map(|slip| slip.iter().map(|slip| factor * slip).collect::<Vec<_>>());
        let coarse = Step {
            map: &*map,
            elements,
            measure: Measure::even(4.0 * step.measure.area),
            limit: &limit,
            rigid: [&one, &two],
            prescribed: step.prescribed,
        };
        // Half of the digits: where a start is off by less, a Newton step doubles them.
        let settings = Settings { tolerance: self.settings.tolerance.sqrt(), ..self.settings };
        let first = Newton { settings }.descend(&coarse);
        let [one, two] = first.traction.each_ref().map(|traction| blocks.interpolate(traction));
        let rigid_slip: Vec<f64> =
            first.rigid_slip.iter().map(|rigid_slip| rigid_slip / factor).collect();
        let limit = blocks.interpolate(&limit);
        let start = Start { traction: [&one, &two], limit: &limit, rigid_slip: &rigid_slip };
        let outcome = self.iterate(step, Some(start));
        let applications = outcome.applications + first.applications.div_ceil(4);
        Outcome { applications, ..outcome }
    }

    fn iterate(&self, step: &Step<'_>, start: Option<Start<'_>>) -> Outcome {
        let mut pairs = Pairs::of(step);
        let mut state = pairs.start(start);
        let mut residual = pairs.residual(&state);
        let mut forcing = Forcing::default();
        let mut count = 0;
        while residual > self.settings.tolerance && count < self.settings.max_iterations {
            count += 1;
            let mut linear = Linear::about(&state, &mut pairs);
            let left = forcing.next(residual, self.settings.tolerance);
            let change = linear.solve(left * residual, self.settings.max_iterations);
            let moved = |length: f64| {
                let next = state.moved(&change, length);
                let residual = pairs.residual(&next);
                (next, residual)
            };
            match shorten(residual, moved) {
                Some(next) => (state, residual) = next,
                None => {
                    let mut between = Contraction::new(&pairs, state);
                    (0..BETWEEN).for_each(|_| between.advance(&mut pairs));
                    state = between.state;
                    residual = pairs.residual(&state);
                }
            }
        }
        let converged = residual <= self.settings.tolerance;
        let status = if converged { Status::Converged } else { Status::OutOfIterations };
        pairs.finish(state, status, count, residual)
    }
}
