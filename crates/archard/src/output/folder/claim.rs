//! A result folder on its way to a run: held, and as it was.

use std::ffi::OsStr;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use super::lock::Lock;
use super::{FRETTING_LOOP, HISTORY, PROFILES, ResultFolder, WORN_PROFILES};
use crate::output::elastic::{POINTS, SURFACE};
use crate::output::inside::SURFACES;
use crate::output::{Error, file};

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

    /// Removes what earlier runs left, whole or in parts; anything else is left alone.
    pub(in crate::output) fn clear(&self) -> Result<(), Error> {
        let fields = self.dir.join("fields");
        for folder in [&self.dir, &fields] {
            // The lock is held: whoever wrote them is gone.
            file::remove_parts(folder, |_| true);
        }
        let names = ["summary.json", "fields.pvd", HISTORY, PROFILES, WORN_PROFILES, FRETTING_LOOP];
        let names = names.into_iter().chain([POINTS, SURFACE]).chain(SURFACES);
        let mut old: Vec<PathBuf> = names.map(|name| self.dir.join(name)).collect();
        match fs::read_dir(&fields) {
            Ok(entries) => {
                let paths = entries.flatten().map(|entry| entry.path());
                old.extend(paths.filter(|path| is_output(path)));
            }
            Err(error) if error.kind() == io::ErrorKind::NotFound => {}
            Err(source) => return Err(Error::Write { path: fields, source }),
        }
        old.into_iter().try_for_each(|path| match fs::remove_file(&path) {
            Err(source) if source.kind() != io::ErrorKind::NotFound => {
                Err(Error::Write { path, source })
            }
            _ => Ok(()),
        })
    }
}

/// Whether that is the name of a numbered output.
fn is_output(path: &Path) -> bool {
    let digits = |stem: &str| stem.len() >= 4 && stem.bytes().all(|byte| byte.is_ascii_digit());
    [Some(OsStr::new("vti")), Some(OsStr::new("vtu"))].contains(&path.extension())
        && path.file_stem().and_then(OsStr::to_str).is_some_and(digits)
}
