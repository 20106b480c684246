//! Words on standard output, which may be closed before the last of them, and on standard error, which may be closed
//! or full.

use std::ffi::{OsStr, OsString};
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
    is_able(std::io::stderr().is_terminal(), set("TERM").as_deref())
}

/// Whether standard error takes colours, and the user does (<https://no-color.org>).
pub fn in_colour() -> bool {
    on_terminal() && is_wanted(set("NO_COLOR").as_deref())
}

/// The same of standard output.
pub fn out_in_colour() -> bool {
    let able = is_able(std::io::stdout().is_terminal(), set("TERM").as_deref());
    able && is_wanted(set("NO_COLOR").as_deref())
}

fn set(name: &str) -> Option<OsString> {
    std::env::var_os(name)
}

/// Whether a stream is a terminal with a cursor.
fn is_able(terminal: bool, term: Option<&OsStr>) -> bool {
    terminal && term != Some(OsStr::new("dumb"))
}

/// Whether colours are wanted, by the value of `NO_COLOR`.
fn is_wanted(refused: Option<&OsStr>) -> bool {
    refused.is_none_or(OsStr::is_empty)
}

#[cfg(test)]
mod tests {
    use std::ffi::OsStr;

    use super::{is_able, is_wanted};

    #[test]
    fn colours_are_for_terminals_of_those_who_take_them() {
        let able =
            [(true, Some("xterm")), (true, None), (true, Some("dumb")), (false, Some("xterm"))];
        let able = able.map(|(terminal, term)| is_able(terminal, term.map(OsStr::new)));
        assert_eq!(able, [true, true, false, false]);
        let wanted =
            [None, Some(""), Some("1"), Some("0")].map(|set| is_wanted(set.map(OsStr::new)));
        assert_eq!(wanted, [true, true, false, false]);
    }
}
