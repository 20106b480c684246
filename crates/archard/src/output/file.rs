//! Files that are whole or not there.

use std::fs;
use std::path::Path;

use super::Error;

/// Writes a file under a temporary name beside its place and moves it there, so that no reader ever
/// finds half of it.
pub(super) fn write_whole(path: &Path, content: &[u8]) -> Result<(), Error> {
    let mut name = path.as_os_str().to_owned();
    name.push(".part");
    fs::write(&name, content)
        .and_then(|()| fs::rename(&name, path))
        .map_err(|source| Error::Write { path: path.to_owned(), source })
}
