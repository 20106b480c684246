//! `archard check`: the case in SI, what to expect, what is doubtful.

use archard::case::Task;

use crate::arguments::Case;
use crate::diagnose;
use crate::failure::Failure;
use crate::say::say;

/// Checks a case.
pub fn check(arguments: &Case) -> Result<(), Failure> {
    let task = diagnose::resolve(arguments, false)?;
    let (case, forecast) = match &task {
        Task::Contact(resolved) => (resolved.case.to_string(), resolved.forecast.to_string()),
        Task::Elastic(resolved) => (resolved.case.to_string(), resolved.forecast.to_string()),
    };
    say(&format!("# The case in SI\n\n{case}"))?;
    say(&format!("# What to expect\n\n{forecast}"))?;
    match task.warnings().len() {
        0 => say("No warnings."),
        1 => say("1 warning, shown above."),
        n => say(&format!("{n} warnings, shown above.")),
    }
}
