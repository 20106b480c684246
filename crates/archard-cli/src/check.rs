//! `archard check`: the case in SI, what to expect, what is doubtful.

use crate::arguments::Check;
use crate::diagnose;
use crate::failure::Failure;
use crate::say::say;

/// Checks a case.
pub fn check(arguments: &Check) -> Result<(), Failure> {
    if arguments.json {
        let checked = diagnose::read(&arguments.case)?.checked_json();
        say(&format!("{checked:#}"))?;
        return if checked["valid"] == true { Ok(()) } else { Err(Failure::Shown) };
    }
    let task = diagnose::resolve(&arguments.case, false)?;
    say(&format!("# The case in SI\n\n{}", task.case_toml()))?;
    say(&task.expectations())?;
    match task.warnings().len() {
        0 => say("No warnings."),
        1 => say("1 warning, shown above."),
        n => say(&format!("{n} warnings, shown above.")),
    }
}
