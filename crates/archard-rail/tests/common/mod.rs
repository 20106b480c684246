//! The benchmark's files, which are not in the repository.

use std::path::PathBuf;

use archard_rail::file::{Document, Format, read};

/// The folder that `ARCHARD_WHEEL_RAIL` names; `None`, with a note, if it is unset.
pub fn folder() -> Option<PathBuf> {
    let folder = std::env::var_os("ARCHARD_WHEEL_RAIL").map(PathBuf::from);
    if folder.is_none() {
        eprintln!("skipped: set ARCHARD_WHEEL_RAIL to the folder with the Manchester benchmark");
    }
    folder
}

/// A file of the folder.
pub fn document(folder: &std::path::Path, name: &str, format: Format) -> Document {
    let bytes = std::fs::read(folder.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"));
    read(&bytes, format).unwrap_or_else(|error| panic!("{name}: {error}"))
}
