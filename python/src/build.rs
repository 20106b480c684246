//! Simulations of cases, with what Python puts into them.

use std::path::PathBuf;
use std::sync::Arc;

use archard::accuracy::AccuracyFailure;
use archard::problem::ContactProblem;
use archard::simulation::Simulation;
use archard::wear::try_out;
use archard_case::output::Store;
use archard_case::{Case, RunnableCase};
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

/// The simulation of a case with its laws, and the case on the elements that its accuracy takes; also what is doubtful about kept
/// compliances.
pub fn settled(
    py: Python<'_>,
    pool: &ThreadPool,
    resolved: RunnableCase,
    cache: Option<PathBuf>,
    laws: Laws,
) -> PyResult<(RunnableCase, Simulation, Vec<String>)> {
    let failed = laws.failed.clone();
    let work = move || {
        let store = cache.map(Store::new).or_else(Store::of_user);
        let mut refused = None;
        let mut build = |case: &Case| {
            let built =
                store.as_ref().map_or_else(|| case.build(), |store| case.build_keeping(store));
            let mut simulation = built?;
            match laws.put(&mut simulation) {
                Ok(()) => Ok(simulation),
                Err(error) => Err(refused.insert(error).to_string().into()),
            }
        };
        let settled = guarded(|| Ok(resolved.settle(&mut build, &mut |_| Ok(()))));
        let doubts = store.map(|store| store.doubts()).unwrap_or_default();
        (settled, refused, doubts)
    };
    let (settled, refused, doubts) = away(py, pool, work).unless_interrupted()?;
    let settled = settled.map_err(|_: Broken| raised(&failed))?;
    if let Some(refused) = refused {
        return Err(refused);
    }
    let (resolved, simulation) = settled.map_err(|error| match error {
        AccuracyFailure::Run { cause, .. } if cause.is_of_convergence() => {
            NotConverged::new_err(cause.to_string())
        }
        error => RunError::new_err(error.to_string()),
    })?;
    Ok((resolved, simulation, doubts))
}
