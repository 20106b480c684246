//! Mistyped subcommands are answered with the nearest, letters that were swapped too.

use archard_case::nearest;
use clap::CommandFactory;
use clap::error::{ContextKind, ContextValue};

use crate::arguments::Arguments;
use crate::failure::Failure;

/// Shows an error of the command line, or the help that was asked for, and returns the exit code.
pub fn show(error: clap::Error) -> u8 {
    let error = with_hint(error);
    // Whoever closes the pipe has read enough.
    let _ = error.print();
    match error.use_stderr() {
        true => Failure::Shown.code(),
        false => 0,
    }
}

/// An error of the command line with the subcommand that may have been meant.
fn with_hint(mut error: clap::Error) -> clap::Error {
    let Some(ContextValue::String(written)) = error.get(ContextKind::InvalidSubcommand) else {
        return error;
    };
    let command = Arguments::command();
    let known: Vec<&str> = command.get_subcommands().map(clap::Command::get_name).collect();
    if let Some(near) = nearest(written, &known) {
        let near = ContextValue::Strings(vec![near.to_owned()]);
        error.insert(ContextKind::SuggestedSubcommand, near);
    }
    error
}
