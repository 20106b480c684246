//! The paper's Uzawa iteration (eqs. 51 to 53 with the sign of eq. 10), the reference the other solvers
//! are held against.
//!
//! t <- P(t + r s) on every pair at once. Rolling is nearly skew: the damping of the slowest mode is that
//! of the upwind difference, an element over the length of the contact, and r has to be as small.

use super::pairs::Pairs;
use super::{FrictionSolver, Outcome, Start, Step, TOLERANCE};
use crate::numerics::vector::in_pool;
use crate::parameters::Choice;
use crate::solve::{PARAMETERS, Settings, Status};

pub(super) const CHOICE: Choice<Box<dyn FrictionSolver>> = Choice {
    name: "uzawa",
    meaning: "the paper's Uzawa iteration; slow, the reference for the others",
    parameters: PARAMETERS,
    build: |values| Ok(Box::new(Uzawa::new(Settings::read(values, Uzawa::default().settings)?))),
};

/// The paper's Uzawa iteration, by default to 1e-6 in a million iterations.
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

impl FrictionSolver for Uzawa {
    fn solve(&self, step: &Step<'_>, start: Option<Start<'_>>) -> Outcome {
        in_pool(|| self.iterate(Pairs::of(step), start))
    }

    fn with_tolerance(&self, tolerance: f64) -> Box<dyn FrictionSolver> {
        Box::new(Self::new(Settings { tolerance, ..self.settings }))
    }

    fn settings(&self) -> Settings {
        self.settings
    }
}

impl Uzawa {
    fn iterate(&self, mut pairs: Pairs<'_>, start: Option<Start<'_>>) -> Outcome {
        let mut state = pairs.start(start);
        let across = (pairs.len() as f64).sqrt().max(1.0);
        // The slowest mode of so many pairs in a row takes r to be as small.
        let penalty = 1.0 / (across * pairs.own);
        // A force off by all the limits moves the slip like a traction off by the mean limit.
        let compliance = penalty * pairs.own * pairs.own / pairs.len().max(1) as f64;
        let area = pairs.step.measure.area;
        let mut count = 0;
        loop {
            let residual = pairs.residual(&state);
            let status = if residual <= self.settings.tolerance {
                Status::Converged
            } else if count == self.settings.max_iterations || residual.is_nan() {
                Status::OutOfIterations
            } else {
                count += 1;
                let missing = pairs.missing(&state.traction).into_iter();
                let rigid_slip: Vec<f64> =
                    missing.map(|missing| compliance * missing / area).collect();
                pairs.predict(&mut state, penalty, &rigid_slip);
                continue;
            };
            return pairs.finish(state, status, count, residual);
        }
    }
}
