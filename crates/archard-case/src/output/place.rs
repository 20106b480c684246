//! Places that this program may write to.

use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use super::{Error, file};
use crate::files::{self, Contents};

/// The path of a file that may be written: one that a [`Manifest`](super::Manifest) gives, or one that nobody else has written.
/// All that is written goes to such a place.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Place(PathBuf);

impl Place {
    /// One that is known to be this program's.
    pub(super) fn known(path: PathBuf) -> Self {
        Self(path)
    }

    /// A path that the user chose: nothing stands there, or a file whose content this program is known to have written.
    ///
    /// # Errors
    /// If anything else does, or it cannot be read.
    pub fn free_or(path: &Path, is_ours: impl Fn(&[u8]) -> bool) -> Result<Self, Error> {
        let place = Self(path.to_owned());
        match fs::metadata(path) {
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(place),
            Ok(known) if known.is_file() => {}
            _ => return Err(Error::NotOurs { path: place.0, help: "" }),
        }
        match files::read(path, Contents::Numbers) {
            Ok(known) if is_ours(&known) => Ok(place),
            Ok(_) => Err(Error::NotOurs { path: place.0, help: "" }),
            Err(source) => Err(Error::Read { path: place.0, source }),
        }
    }

    /// Writes the file, whole or not at all; what stands there is replaced.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn write(&self, content: &[u8]) -> Result<(), Error> {
        file::write_whole(&self.0, content)
    }

    /// The path.
    pub fn path(&self) -> &Path {
        &self.0
    }

    /// The path.
    pub fn into_path(self) -> PathBuf {
        self.0
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::Place;
    use crate::output::Error;

    #[test]
    fn what_others_wrote_is_no_place() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("page");
        let place = || Place::free_or(&path, |known| known.starts_with(b"ours"));
        place().unwrap().write(b"ours 1").unwrap();
        place().unwrap().write(b"ours 2").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"ours 2");
        fs::write(&path, "mine").unwrap();
        assert!(matches!(place(), Err(Error::NotOurs { .. })));
        assert!(matches!(Place::free_or(dir.path(), |_| true), Err(Error::NotOurs { .. })));
    }
}
