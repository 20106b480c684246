//! `archard check`: the case in SI, what to expect, what is doubtful.

use crate::arguments::Case;
use crate::diagnose;
use crate::failure::Failure;

/// Checks a case.
pub fn check(arguments: &Case) -> Result<(), Failure> {
    let resolved = diagnose::resolve(arguments, false)?;
    println!("# The case in SI\n\n{}", resolved.case);
    println!("# What to expect\n\n{}", resolved.forecast);
    match resolved.warnings.len() {
        0 => println!("No warnings."),
        1 => println!("1 warning, shown above."),
        n => println!("{n} warnings, shown above."),
    }
    Ok(())
}
