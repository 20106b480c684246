//! Why there is no fit.

use super::NoFit;
use archard_case::{CaseFile, Problem, measured};

/// Why a case cannot be fitted to what was measured.
#[non_exhaustive]
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The table cannot be used.
    #[error(transparent)]
    Table(#[from] measured::Error),
    /// A reading cannot be used.
    #[error("{table}, line {line}: {why}")]
    Reading {
        /// What the table is called.
        table: String,
        /// The line.
        line: u64,
        /// Why, and what to do.
        why: String,
    },
    /// Case, parameter and columns do not go together.
    #[error("{0}")]
    Mismatch(String),
    /// A case with a value in place of its own is wrong.
    #[error("the case with {settings} cannot be run: {why}")]
    Case {
        /// What was put into it.
        settings: String,
        /// What is wrong with it.
        why: String,
    },
    /// A run failed, or what came out of it cannot be right.
    #[error("the run with {settings}: {why}")]
    Run {
        /// What was put into the case.
        settings: String,
        /// Why.
        why: String,
    },
    /// The folder of runs cannot be used.
    #[error(transparent)]
    Folder(Box<dyn std::error::Error + Send + Sync>),
    /// Whoever follows the runs ended the fit.
    #[error("{cause} after {runs} runs, which are kept: the same call goes on behind them")]
    Stopped {
        /// Why.
        cause: Box<dyn std::error::Error + Send + Sync>,
        /// Runs that are done.
        runs: usize,
    },
    /// A test has no coefficient.
    #[error("test `{test}`: {why}")]
    Untold {
        /// The test.
        test: String,
        /// Why.
        why: String,
    },
}

impl Error {
    /// Whether something did not converge, rather than being wrong from the start.
    pub fn is_of_convergence(&self) -> bool {
        matches!(self, Self::Run { .. })
    }

    /// What is wrong with a case.
    pub(super) fn of_case(file: &CaseFile, problems: &[Problem]) -> Self {
        let why: Vec<String> = problems.iter().map(|problem| file.describe(problem)).collect();
        Self::Mismatch(why.join("\n"))
    }

    pub(super) fn untold(test: &str, cause: NoFit<Error>) -> Self {
        match cause {
            NoFit::Model(error) => error,
            other => Self::Untold { test: test.to_owned(), why: other.to_string() },
        }
    }
}
