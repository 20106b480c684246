//! `archard check`: the case in SI, what to expect, what is doubtful.

use crate::arguments::Case;
use crate::diagnose;
use crate::failure::Failure;
use crate::say::say;

/// Checks a case.
pub fn check(arguments: &Case) -> Result<(), Failure> {
    let task = diagnose::resolve(arguments, false)?;
    say(&format!("# The case in SI\n\n{}", task.case_toml()))?;
    say(&task.expectations())?;
    match task.warnings().len() {
        0 => say("No warnings."),
        1 => say("1 warning, shown above."),
        n => say(&format!("{n} warnings, shown above.")),
    }
}
