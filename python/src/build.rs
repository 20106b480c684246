//! Simulations of cases, with what Python puts into them.

use std::error::Error as StdError;
use std::path::PathBuf;
use std::sync::Arc;

use archard::problem::ContactProblem;
use archard::simulation::{Companions, Observer, Report, Simulation};
use archard::wear::try_out;
use archard_case::output::Store;
use archard_case::{Case, Following, Resolved, Unsettled};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use rayon::ThreadPool;

use crate::away::away;
use crate::friction::Sampled;
use crate::law::{Failed, Given, Law};
use crate::run::{Broken, guarded, raised};

pyo3::import_exception!(archard._errors, NotConverged);
pyo3::import_exception!(archard._errors, RunError);

/// Rising pressures (Pa) and the limits of friction (Pa) there.
pub type Samples = (Vec<f64>, Vec<f64>);

/// Laws in Python, for the run and for those on fewer elements that say what it errs by.
pub struct Laws {
    /// Of wear, each with its body.
    pub wear: Vec<Given>,
    /// Of friction.
    pub friction: Option<Samples>,
    /// Where what they raise waits.
    pub failed: Failed,
}

impl Laws {
    /// Whether they stand in place of nothing that the case says: layers wear by laws of their own.
    pub fn fit(&self, case: &Case) -> PyResult<()> {
        for (name, ..) in &self.wear {
            let mut layers = case.bodies.iter().filter(|body| body.name == *name);
            if layers.any(|body| body.layers.iter().any(|layer| layer.wear.is_some())) {
                let message = format!(
                    "the layers of `{name}` have laws of their own in the case: leave them out, or the law"
                );
                return Err(PyValueError::new_err(message));
            }
        }
        Ok(())
    }

    /// Puts them into a simulation, once they were tried.
    fn put(&self, simulation: &mut Simulation) -> PyResult<()> {
        simulation.each_frame(&mut |one| self.put_into(&mut one.problem))
    }

    fn put_into(&self, problem: &mut ContactProblem) -> PyResult<()> {
        if let Some((pressures, limits)) = &self.friction {
            problem.friction = Some(Arc::new(Sampled::new(pressures.clone(), limits.clone())?));
        }
        for given in &self.wear {
            let again = |py: Python<'_>| {
                let (body, function, name, columns, cycle) = given;
                (body.clone(), function.clone_ref(py), name.clone(), columns.clone(), *cycle)
            };
            let law = Law::new(problem, Python::attach(again), &self.failed)?;
            match guarded(|| Ok(try_out(&law))) {
                Ok(Ok(())) => {}
                Ok(Err(refused)) => {
                    let message =
                        format!("{law} breaks what a law owes: its depth {}", refused.message);
                    return Err(PyValueError::new_err(message));
                }
                Err(_) => return Err(raised(&self.failed)),
            }
            match problem.bodies.iter_mut().find(|body| body.name == given.0) {
                Some(body) => body.wear = Some(Arc::new(law)),
                None => {
                    return Err(PyValueError::new_err(format!("no body is called `{}`", given.0)));
                }
            }
        }
        Ok(())
    }
}

/// Nobody follows the runs on fewer elements.
impl Observer for Laws {
    fn observe(&mut self, _: &Report<'_>) -> Result<(), Box<dyn StdError + Send + Sync>> {
        Ok(())
    }
}

impl Following for Laws {
    fn begins(&mut self, _: [usize; 2]) {}

    fn observer(&mut self) -> &mut dyn Observer {
        self
    }

    fn prepare(
        &mut self,
        simulation: &mut Simulation,
    ) -> Result<(), Box<dyn StdError + Send + Sync>> {
        Ok(self.put(simulation)?)
    }
}

/// The case on the elements that its accuracy takes, what says how far off they are, and the laws again.
pub fn companions(
    py: Python<'_>,
    pool: &ThreadPool,
    resolved: Resolved,
    cache: Option<PathBuf>,
    mut laws: Laws,
) -> PyResult<(Resolved, Option<Companions>, Laws)> {
    let failed = laws.failed.clone();
    let work = move || {
        let store = cache.map(Store::new).or_else(Store::of_user);
        let settled = guarded(|| Ok(resolved.with_companions(store.as_ref(), &mut laws)));
        (settled, laws)
    };
    let (settled, laws) = away(py, pool, work).unless_interrupted()?;
    let settled = settled.map_err(|_: Broken| raised(&failed))?;
    let (resolved, companions) = settled.map_err(|error| match error {
        Unsettled::Run { cause, .. } if cause.is_of_convergence() => {
            NotConverged::new_err(cause.to_string())
        }
        Unsettled::Unprepared(error) => match error.downcast::<PyErr>() {
            Ok(raised) => *raised,
            Err(error) => RunError::new_err(error.to_string()),
        },
        error => RunError::new_err(error.to_string()),
    })?;
    Ok((resolved, companions, laws))
}

/// Builds a simulation with its laws; also what is doubtful about kept compliances.
pub fn build(
    py: Python<'_>,
    pool: &ThreadPool,
    case: &Case,
    cache: Option<PathBuf>,
    laws: Laws,
) -> PyResult<(Simulation, Vec<String>)> {
    let case = case.clone();
    let work = move || {
        let store = cache.map(Store::new).or_else(Store::of_user);
        let built = match &store {
            Some(store) => case.build_keeping(store),
            None => case.build(),
        };
        let doubts = store.map(|store| store.doubts()).unwrap_or_default();
        let mut simulation = built.map_err(|error| RunError::new_err(error.to_string()))?;
        laws.put(&mut simulation)?;
        Ok((simulation, doubts))
    };
    away(py, pool, work).unless_interrupted()?
}
