//! What a shell and a reader of manuals want: completions and man pages, from the declaration of the command line.

use std::io;
use std::path::Path;

use clap::CommandFactory;
use clap_complete::Shell;

use crate::arguments::Arguments;
use crate::failure::Failure;
use crate::say::say;

/// Writes what completes the command line in a shell on standard output.
pub fn completions(shell: Shell) -> Result<(), Failure> {
    let mut script = vec![];
    clap_complete::generate(shell, &mut Arguments::command(), "archard", &mut script);
    say(String::from_utf8_lossy(&script).trim_end())
}

/// Writes a manual page for the command and one for each of its parts into a folder.
pub fn man(dir: &Path) -> Result<(), Failure> {
    let written = std::fs::create_dir_all(dir)
        .and_then(|()| clap_mangen::generate_to(Arguments::command(), dir));
    written.map_err(|error: io::Error| {
        Failure::wrong(format!("cannot write into `{}`: {error}", dir.display()))
    })?;
    say(&format!(
        "man pages written into {}; next: man -l {}",
        dir.display(),
        dir.join("archard.1").display()
    ))
}
