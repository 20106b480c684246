//! `archard check`: the case in SI, what to expect, what is doubtful.

use archard::case::{BesideHalfSpace, Case as ContactCase, Task};
use archard::verdict::Verdict;

use crate::arguments::Case;
use crate::diagnose;
use crate::failure::Failure;
use crate::say::say;
use crate::verdict::in_words;

/// Checks a case.
pub fn check(arguments: &Case) -> Result<(), Failure> {
    let task = diagnose::resolve(arguments, false)?;
    let (case, forecast) = match &task {
        Task::Contact(resolved) => {
            let beside = beside_half_spaces(&resolved.case);
            (resolved.case.to_string(), format!("{}{beside}", resolved.forecast))
        }
        Task::Elastic(resolved) => (resolved.case.to_string(), resolved.forecast.to_string()),
    };
    say(&format!("# The case in SI\n\n{case}"))?;
    say(&format!("# What to expect\n\n{forecast}"))?;
    if let Task::Contact(resolved) = &task {
        foresee(&resolved.forecast.verdict)?;
    }
    match task.warnings().len() {
        0 => say("No warnings."),
        1 => say("1 warning, shown above."),
        n => say(&format!("{n} warnings, shown above.")),
    }
}

/// Says what of a verdict can be foreseen.
fn foresee(verdict: &Verdict) -> Result<(), Failure> {
    if verdict.lines.is_empty() {
        return Ok(());
    }
    let lines: Vec<String> = verdict.lines.iter().map(in_words).collect();
    say(&format!("# Verdict foreseen\n\n{}\n", lines.join("\n")))
}

/// What half-spaces in the place of meshed bodies would change.
fn beside_half_spaces(case: &ContactCase) -> String {
    let found = case.beside_half_spaces();
    let line = |one: &BesideHalfSpace| {
        let more = if one.share < 0.0 { "less" } else { "more" };
        let share = 100.0 * one.share.abs();
        format!(
            "half-space        in place of `{}`: about {share:.1} % {more} approach\n",
            one.body
        )
    };
    found.iter().map(line).collect()
}
