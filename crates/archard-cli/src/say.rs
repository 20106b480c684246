//! Words on standard output, which may be closed before the last of them.

use std::io::{ErrorKind, Write};

use crate::failure::Failure;

/// Writes a text and ends its line. Whoever closes the pipe has read enough.
pub fn say(text: &str) -> Result<(), Failure> {
    match writeln!(std::io::stdout(), "{text}") {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(Failure::wrong(format!("cannot write to standard output: {error}")))
        }
        _ => Ok(()),
    }
}
