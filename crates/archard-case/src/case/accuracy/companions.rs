//! A case on the grid that its accuracy takes.

use super::increments;
use crate::case::check::check;
use crate::case::definition::{Case, Output};
use crate::case::problem::Severity;
use crate::case::resolved::RunnableCase;
use crate::output::{Life, Limit};
use archard::accuracy::{
    AccuracyFailure, Enough, Event, FARTHEST, Failed, Grid, SettledRun, Watch, settle,
};
use archard::parameters::Value;
use archard::simulation::{Observer, Simulation};

/// The key of the tolerance of the steps.
pub(super) const TOLERANCE: &str = "tolerance";

impl RunnableCase {
    /// The simulation of the case, as `build` makes it, and the case with the elements, tolerance and increments that its accuracy
    /// takes: coarser runs come first, which `watch` is shown. Where no accuracy is asked for the case stays as it is.
    ///
    /// # Errors
    /// If a run cannot be built, a companion fails, or elements are too few to estimate their error.
    pub fn settle(
        mut self,
        build: &mut dyn FnMut(&Case) -> Result<Simulation, Failed>,
        watch: &mut Watch<'_>,
    ) -> Result<(Self, Simulation), AccuracyFailure> {
        let Some(accuracy) = self.case.accuracy else {
            let simulation = build(&self.case).map_err(AccuracyFailure::Build)?;
            return Ok((self, simulation));
        };
        let read = self.clone();
        let mut on_grid = |grid: &Grid| {
            let case = read.on(grid)?;
            if grid.ratio > 1.0 {
                return build(&case);
            }
            if case != self.case {
                self = read.with(case)?;
            }
            build(&self.case)
        };
        // A companion differs from the run by one less than its ratio times the error; beyond its limit by as much, all of them have
        // passed the life of the run.
        let beyond = 1.0 + accuracy * (FARTHEST - 1.0);
        let limits: Vec<Limit> = read.case.until.iter().map(|limit| limit.times(beyond)).collect();
        let mut life = Life::default();
        let mut watch = |event: Event<'_>| {
            watch(event)?;
            match event {
                Event::Begins(_) => life = Life::until(limits.clone()),
                Event::Shows(report) => {
                    life.observe(report)?;
                    if life.ends() {
                        return Err(Enough.into());
                    }
                }
                _ => {}
            }
            Ok(())
        };
        let settled = settle(accuracy, read.grid(), &mut on_grid, &mut watch);
        settled.map(|SettledRun { simulation, .. }| (self, simulation))
    }

    /// The grid of the case as it was read.
    pub(super) fn grid(&self) -> Grid {
        Grid {
            tolerance: self.case.motion.values.number(TOLERANCE),
            increments: increments::of_rubbing(&self.case),
            refines: self.chose.elements,
            tightens: self.chose.tolerance,
            divides: self.chose.increments,
            ..Grid::new(self.case.frame.elements)
        }
    }

    /// The case on a grid.
    pub(super) fn on(&self, grid: &Grid) -> Result<Case, Failed> {
        let mut case = self.case.clone();
        case.frame.elements = grid.elements;
        for axis in 0..2 {
            case.frame.centre[axis] += grid.moved[axis];
        }
        if let Some(tolerance) = grid.tolerance {
            case.motion.values.insert(TOLERANCE, Value::Number(tolerance));
        }
        if let Some(count) = grid.increments {
            increments::set(&mut case, count);
        }
        if grid.ratio > 1.0 {
            let (_, schedule) = case.motion.build()?;
            case.output = Output::At(grid.outputs(&case.output.places(schedule.extent)));
        }
        Ok(case)
    }

    /// The same with another case, checked anew.
    fn with(&self, case: Case) -> Result<Self, Failed> {
        let (forecast, problems) = check(&case);
        if let Some(problem) = problems.iter().find(|one| one.severity == Severity::Error) {
            return Err(problem.title().into());
        }
        let mut warnings = self.warnings.clone();
        warnings.retain(|warning| !problems.iter().any(|one| one.key == warning.key));
        warnings.extend(problems);
        Ok(Self { case, chose: self.chose, forecast, warnings })
    }
}
