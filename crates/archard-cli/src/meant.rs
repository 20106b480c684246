//! Mistyped subcommands are answered with the nearest, letters that were swapped too.

use archard_case::nearest;
use clap::CommandFactory;
use clap::error::{ContextKind, ContextValue};

use crate::arguments::Arguments;

/// An error of the command line with the subcommand that may have been meant.
pub fn with_hint(mut error: clap::Error) -> clap::Error {
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
