//! A result folder on its way to a run: held, and as it was.

use std::ffi::OsStr;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use super::lock::Lock;
use super::{HISTORY, ResultFolder, TABLES, checkpoint};
use crate::output::elastic::{POINTS, SECTIONS, SURFACE};
use crate::output::inside::SURFACES;
use crate::output::{COLLECTION, Error, file};

/// A folder that no other run writes into. What is in it stays as it is until the results begin, so that a case that
/// cannot be built costs no results.
#[derive(Debug)]
pub struct Claim {
    pub(super) dir: PathBuf,
    pub(super) lock: Lock,
    /// Whether the folder was made for it.
    made: bool,
}

impl Claim {
    /// Makes the folder if there is none and holds it.
    ///
    /// # Errors
    /// If another run holds it, or it cannot be written to.
    pub fn take(dir: &Path) -> Result<Self, Error> {
        let made = !dir.exists();
        fs::create_dir_all(dir).map_err(|source| Error::Write { path: dir.to_owned(), source })?;
        Ok(Self { dir: dir.to_owned(), lock: Lock::take(dir)?, made })
    }

    /// The folder.
    pub fn dir(&self) -> &Path {
        &self.dir
    }

    /// Whether the folder holds results of another case than the one that prints like this, or a case by itself.
    pub fn holds_another(&self, case_toml: &str) -> bool {
        match fs::read(self.dir.join("case.toml")) {
            Ok(known) => known != case_toml.as_bytes(),
            Err(_) => ["summary.json", HISTORY].iter().any(|name| self.dir.join(name).exists()),
        }
    }

    /// Gives the folder up; one that was made for it and is empty is removed.
    pub fn give_up(self) {
        if self.made {
            self.lock.remove();
            let _ = fs::remove_dir(self.dir);
        }
    }

    /// Removes what earlier runs left and begins the results of a case.
    ///
    /// # Errors
    /// If a file cannot be removed or written.
    pub fn begin(self, case_toml: &str) -> Result<ResultFolder, Error> {
        ResultFolder::begin(self, case_toml)
    }

    /// Goes on with the results of a run that was interrupted; the run itself comes with them, for
    /// [`Simulation::resume`](crate::simulation::Simulation::resume).
    ///
    /// # Errors
    /// If there is no checkpoint of this version, it is damaged, or files of the results are.
    pub fn resume(self) -> Result<(ResultFolder, Vec<u8>), Error> {
        ResultFolder::resume(self)
    }

    /// Removes parts of files. The lock is held: whoever wrote them is gone.
    pub(super) fn remove_parts(&self) {
        file::remove_parts(&self.dir, |_| true);
        file::remove_parts(&self.dir.join("fields"), |_| true);
        file::remove_parts(&self.dir.join(SECTIONS), |_| true);
    }

    /// Removes what earlier runs left, whole or in parts; anything else is left alone.
    pub(in crate::output) fn clear(&self) -> Result<(), Error> {
        let fields = self.dir.join("fields");
        self.remove_parts();
        let names = ["summary.json", COLLECTION, checkpoint::NAME].into_iter().chain(TABLES);
        let mut names = names.chain([POINTS, SURFACE]).chain(SURFACES);
        names.try_for_each(|name| file::remove(&self.dir.join(name)))?;
        let sections = self.dir.join(SECTIONS);
        let old = fs::read_dir(&sections).into_iter().flatten().flatten().map(|entry| entry.path());
        let mut old = old.filter(|path| path.extension() == Some(OsStr::new("vtu")));
        old.try_for_each(|path| file::remove(&path))?;
        remove_fields(&fields, 0)
    }
}

/// Removes the outputs from a number on.
pub(super) fn remove_fields(fields: &Path, first: usize) -> Result<(), Error> {
    match fs::read_dir(fields) {
        Ok(entries) => {
            let paths = entries.flatten().map(|entry| entry.path());
            let mut old = paths.filter(|path| number(path).is_some_and(|number| number >= first));
            old.try_for_each(|path| file::remove(&path))
        }
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(()),
        Err(source) => Err(Error::Write { path: fields.to_owned(), source }),
    }
}

/// The number of an output, if that is the name of one.
fn number(path: &Path) -> Option<usize> {
    let digits = |stem: &&str| stem.len() >= 4 && stem.bytes().all(|byte| byte.is_ascii_digit());
    let fields = [Some(OsStr::new("vti")), Some(OsStr::new("vtu"))].contains(&path.extension());
    let stem = path.file_stem().and_then(OsStr::to_str).filter(|_| fields).filter(digits)?;
    // More digits than a number has are of no run that goes on.
    Some(stem.parse().unwrap_or(usize::MAX))
}
