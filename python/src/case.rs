//! Cases as Python hands them over: a text, and options laid over it.

use std::path::PathBuf;
use std::sync::Arc;

use archard_case::{Problem, Source, Task};
use pyo3::prelude::*;

use crate::away::{away, pool};

/// A problem: severity, key, message, what to do, and where it stands.
pub type ProblemParts = (String, String, String, Option<String>, String);

pyo3::import_exception!(archard._errors, CaseError);

/// A case as written.
#[pyclass(frozen, module = "archard._archard")]
pub struct CaseFile(pub archard_case::CaseFile);

/// A case that passed every check.
#[pyclass(frozen, module = "archard._archard")]
pub struct Checked {
    file: archard_case::CaseFile,
    task: Arc<Task>,
}

#[pymethods]
impl CaseFile {
    #[new]
    fn new(name: &str, text: &str, folder: PathBuf, options: Vec<String>) -> Self {
        let file = archard_case::CaseFile::from_text(name, text, folder);
        Self(options.into_iter().fold(file, archard_case::CaseFile::set))
    }

    /// Reads and checks it.
    fn check(&self, py: Python<'_>) -> PyResult<Checked> {
        let file = self.0.clone();
        let work = move || resolve(&file);
        let task = away(py, &pool(None)?, work).unless_interrupted()?.map_err(refused)?;
        Ok(Checked { file: self.0.clone(), task: Arc::new(task) })
    }
}

#[pymethods]
impl Checked {
    /// The case in SI, as a case file.
    #[getter]
    fn toml(&self) -> String {
        self.task.case_toml()
    }

    /// Whether a case that a run has kept is this one, apart from what was chosen for its accuracy.
    fn is_kept(&self, toml: &str) -> bool {
        match &*self.task {
            Task::Contact(resolved) => resolved.is_printed(toml),
            Task::Cam(_) | Task::Elastic(_) | Task::Gear(_) | Task::WheelRail(_) => {
                self.task.case_toml() == toml
            }
        }
    }

    /// What is doubtful about it.
    #[getter]
    fn warnings(&self) -> Vec<ProblemParts> {
        self.task.warnings().iter().map(|problem| told(&self.file, problem)).collect()
    }

    /// Whether it is of one elastic body without contact.
    #[getter]
    fn elastic(&self) -> bool {
        matches!(*self.task, Task::Elastic(_))
    }

    /// What to expect.
    fn expectations(&self, py: Python<'_>) -> PyResult<String> {
        let task = self.task.clone();
        away(py, &pool(None)?, move || task.expectations()).unless_interrupted()
    }
}

/// What a case asks for, or all that is wrong with it.
pub fn resolve(file: &archard_case::CaseFile) -> Result<Task, Vec<ProblemParts>> {
    let tell = |problems: Vec<Problem>| problems.iter().map(|one| told(file, one)).collect();
    file.task().map_err(tell)
}

/// The error of a case that cannot be run.
pub fn refused(problems: Vec<ProblemParts>) -> PyErr {
    CaseError::new_err((problems,))
}

/// A problem in words.
pub fn told(file: &archard_case::CaseFile, problem: &Problem) -> ProblemParts {
    let place = match &problem.location {
        Some(at) if at.source == Source::File => {
            format!("{}:{}", file.name(at.source), file.line(at))
        }
        Some(at) => file.text(at.source).to_owned(),
        None => file.name(Source::File).to_owned(),
    };
    let Problem { severity, key, message, help, .. } = problem;
    (severity.to_string(), key.to_string(), message.clone(), help.clone(), place)
}
