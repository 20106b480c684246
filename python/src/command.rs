//! The command `archard`, for the script that is installed with the package.

use std::ffi::OsString;
use std::io::Write;
use std::panic::catch_unwind;

use pyo3::prelude::*;

/// The exit code of a program in Rust that panicked.
const PANICKED: u8 = 101;

/// Does what a command line asks for, the words after `archard`, and returns the exit code. What panics has told why.
#[pyfunction]
pub fn command(py: Python<'_>, words: Vec<OsString>) -> u8 {
    py.detach(|| {
        let code = catch_unwind(|| archard_cli::main(words)).unwrap_or(PANICKED);
        // A program in Rust does so where it ends.
        let _ = std::io::stdout().flush();
        code
    })
}
