//! Words on standard output, which may be closed before the last of them, and on standard error, which may be closed
//! or full.

use std::io::{ErrorKind, IsTerminal, Write};

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

/// Writes a text on standard error and ends its line. There is no place to say that this failed, and no reason to end
/// a run.
pub fn tell(text: &str) {
    let _ = std::io::stderr().write_all(format!("{text}\n").as_bytes());
}

/// Whether standard error is a terminal that can move its cursor.
pub fn on_terminal() -> bool {
    let dumb = std::env::var_os("TERM").is_some_and(|term| term == "dumb");
    std::io::stderr().is_terminal() && !dumb
}

/// Whether standard error takes colours, and the user does (<https://no-color.org>).
pub fn in_colour() -> bool {
    let refused = std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty());
    on_terminal() && !refused
}
