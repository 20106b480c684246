//! `archard new`: lists the built-in cases, or writes one out.

use std::fs::{self, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use crate::arguments::New;
use crate::builtin::{Builtin, CASES};
use crate::failure::Failure;
use crate::say::say;

/// Lists the built-in cases, or writes one out.
pub fn new(arguments: &New) -> Result<(), Failure> {
    let Some(name) = &arguments.name else {
        return list();
    };
    let Some(builtin) = CASES.iter().find(|builtin| builtin.name == name) else {
        let known: Vec<&str> = CASES.iter().map(|builtin| builtin.name).collect();
        let message = format!("there is no built-in case `{name}`; there are {}", known.join(", "));
        return Err(Failure::wrong(message));
    };
    let dir = arguments.output.clone().unwrap_or_else(|| PathBuf::from(name));
    let path = dir.join("case.toml");
    write(&dir, &path, builtin).map_err(|error| {
        let next = match error.kind() {
            io::ErrorKind::AlreadyExists => "; it is kept: choose another folder with -o",
            _ => "",
        };
        Failure::wrong(format!("cannot write `{}`: {error}{next}", path.display()))
    })?;
    say(&format!("{} written; next: archard run {}", path.display(), path.display()))
}

fn list() -> Result<(), Failure> {
    let width = CASES.iter().map(|builtin| builtin.name.len()).max().unwrap_or(0);
    for builtin in CASES {
        say(&format!("{:width$}  {}", builtin.name, builtin.title()))?;
    }
    say("\narchard new NAME writes one out to start from")
}

/// Writes the case and the files it reads, never over a file that is there.
fn write(dir: &Path, path: &Path, builtin: &Builtin) -> io::Result<()> {
    fs::create_dir_all(dir)?;
    let write = |path: &Path, bytes: &[u8]| {
        OpenOptions::new().write(true).create_new(true).open(path)?.write_all(bytes)
    };
    write(path, builtin.text.as_bytes())?;
    builtin.files.iter().try_for_each(|(name, bytes)| write(&dir.join(name), bytes))
}
