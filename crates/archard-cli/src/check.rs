//! `archard check`: the case in SI, what to expect, what is doubtful.

use archard::case;

use crate::arguments::Case;
use crate::diagnose;
use crate::failure::Failure;
use crate::say::say;

/// Checks a case.
pub fn check(arguments: &Case) -> Result<(), Failure> {
    let resolved = diagnose::resolve(arguments, false)?;
    say(&format!("# The case in SI\n\n{}", resolved.case))?;
    say(&format!(
        "# What to expect\n\n{}{}",
        resolved.forecast,
        beside_half_spaces(&resolved.case)
    ))?;
    match resolved.warnings.len() {
        0 => say("No warnings."),
        1 => say("1 warning, shown above."),
        n => say(&format!("{n} warnings, shown above.")),
    }
}

/// What half-spaces in the place of meshed bodies would change.
fn beside_half_spaces(case: &case::Case) -> String {
    let found = case.beside_half_spaces();
    let line = |one: &case::BesideHalfSpace| {
        let more = if one.share < 0.0 { "less" } else { "more" };
        let share = 100.0 * one.share.abs();
        format!(
            "half-space        in place of `{}`: about {share:.1} % {more} approach\n",
            one.body
        )
    };
    found.iter().map(line).collect()
}
