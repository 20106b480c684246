//! Gauss-Seidel sweeps over the pairs of [meshed bodies](crate::solve::joint), pressures and friction together.
//!
//! Where there is no matrix, where forces are given and in rolling, in which sweeps from pair to pair diverge,
//! Newton's steps take their place.

use super::newton::Newton;
use super::{FrictionSolver, Outcome, Start, Step, TOLERANCE};
use crate::numerics::vector::in_pool;
use crate::parameters::Choice;
use crate::solve::{PARAMETERS, Settings, joint};

pub(super) const CHOICE: Choice<Box<dyn FrictionSolver>> = Choice {
    name: "gauss_seidel",
    meaning: "sweeps from pair to pair, for meshed bodies that do not roll; newton elsewhere",
    parameters: PARAMETERS,
    build: |values| {
        let settings = Settings::read(values, TOLERANCE, 5_000);
        Ok(Box::new(GaussSeidel { settings, newton: Newton { settings } }))
    },
};

/// See the module.
#[derive(Debug)]
struct GaussSeidel {
    settings: Settings,
    newton: Newton,
}

impl FrictionSolver for GaussSeidel {
    fn solve(&self, step: &Step<'_>, start: Option<Start<'_>>) -> Outcome {
        self.newton.solve(step, start)
    }

    fn solve_jointly(
        &self,
        step: &joint::Step<'_>,
        start: &joint::Solution,
        foreseen: Option<&joint::Solution>,
    ) -> Option<joint::Outcome> {
        in_pool(|| joint::sweep(step, start, self.settings))
            .or_else(|| self.newton.solve_jointly(step, start, foreseen))
    }

    fn settings(&self) -> Settings {
        self.settings
    }

    /// The matrix of all directions of all pairs.
    fn memory(&self, pairs: f64) -> f64 {
        72.0 * pairs * pairs
    }
}
