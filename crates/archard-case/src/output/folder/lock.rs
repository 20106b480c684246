//! The lock of a result folder: one run writes into it at a time.
//!
//! The lock is the operating system's advisory lock of a file in the folder, so it ends with the process that holds it,
//! however that ends. The file holds the number of that process. Readers need no lock.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, Read, Seek, Write};
use std::path::{Path, PathBuf};

use crate::output::Error;

/// The file that is locked.
const NAME: &str = ".archard.lock";

/// A lock that is held until it is dropped.
#[derive(Debug)]
pub(super) struct Lock {
    path: PathBuf,
    _file: File,
    /// Whether its file was made for it.
    made: bool,
}

impl Lock {
    /// Locks a folder. Where the file system knows no locks, none is held.
    ///
    /// # Errors
    /// If another process holds the lock or the file cannot be written.
    pub(super) fn take(dir: &Path) -> Result<Self, Error> {
        let path = dir.join(NAME);
        let refused = |source| Error::Write { path: path.clone(), source };
        let made = !path.exists();
        loop {
            let mut file = open(&path).map_err(refused)?;
            match file.try_lock() {
                Err(TryLockError::WouldBlock) => {
                    return Err(Error::InUse { dir: dir.to_owned(), process: holder(&mut file) });
                }
                // A file system without locks.
                Err(TryLockError::Error(_)) => {}
                // Whoever held it before may have removed the file that is now locked.
                Ok(()) if !is_at(&file, &path) => continue,
                Ok(()) => {}
            }
            sign(&mut file).map_err(refused)?;
            return Ok(Self { path, _file: file, made });
        }
    }

    /// Leaves the folder as it was: a file that was made for the lock is removed.
    pub(super) fn give_up(self) {
        if self.made {
            let _ = fs::remove_file(&self.path);
        }
    }
}

/// The file, made if it is not there; never what a link points at.
fn open(path: &Path) -> io::Result<File> {
    if fs::symlink_metadata(path).is_ok_and(|known| !known.is_file()) {
        return Err(io::Error::other("it is no plain file; remove it"));
    }
    OpenOptions::new().read(true).write(true).create(true).truncate(false).open(path)
}

/// Writes the number of this process.
fn sign(file: &mut File) -> io::Result<()> {
    file.set_len(0)?;
    file.rewind()?;
    writeln!(file, "{}", std::process::id())
}

/// The process that signed.
fn holder(file: &mut File) -> Option<u32> {
    let mut text = String::new();
    file.take(32).read_to_string(&mut text).ok()?;
    text.trim().parse().ok()
}

/// Whether that file is the one at a path.
#[cfg(unix)]
fn is_at(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let place = |known: fs::Metadata| (known.dev(), known.ino());
    file.metadata().map(place).ok() == fs::metadata(path).map(place).ok()
}

/// Elsewhere an open file is not removed.
#[cfg(not(unix))]
fn is_at(_file: &File, _path: &Path) -> bool {
    true
}

#[cfg(test)]
mod tests {
    use super::Lock;
    use crate::output::Error;

    #[test]
    fn one_holds_the_lock_until_it_is_dropped() {
        let dir = tempfile::tempdir().unwrap();
        let lock = Lock::take(dir.path()).unwrap();
        let Err(Error::InUse { process, .. }) = Lock::take(dir.path()) else {
            panic!("held twice")
        };
        if cfg!(unix) {
            assert_eq!(process, Some(std::process::id()));
        }
        drop(lock);
        let count = || std::fs::read_dir(dir.path()).unwrap().count();
        Lock::take(dir.path()).unwrap().give_up();
        assert_eq!(count(), 1);
        std::fs::remove_file(dir.path().join(super::NAME)).unwrap();
        Lock::take(dir.path()).unwrap().give_up();
        assert_eq!(count(), 0);
    }

    #[cfg(unix)]
    #[test]
    fn a_link_is_not_locked() {
        let dir = tempfile::tempdir().unwrap();
        let other = dir.path().join("mine");
        std::fs::write(&other, "kept").unwrap();
        std::os::unix::fs::symlink(&other, dir.path().join(super::NAME)).unwrap();
        assert!(matches!(Lock::take(dir.path()), Err(Error::Write { .. })));
        assert_eq!(std::fs::read_to_string(&other).unwrap(), "kept");
    }
}
