//! Compliances of meshed bodies, kept from one run to the next, and what tractions of contact make of the whole body,
//! where stresses inside are asked for.
//!
//! Each is a file of its own that says what it is ([`envelope`]), named by a hash of all that the compliance follows
//! from. What is damaged, foreign, of another size or of another version is computed anew and replaced. What others may
//! have written is not read ([`trust`]).

mod envelope;
mod trust;

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use blake3::OUT_LEN;
use envelope::Envelope;
use faer::Mat;

use super::{Error, Place, file};
use crate::files::{self, Contents};
use archard::body::{Finite, Material};
use archard::compliance::bem::contact::{Job, condense};
use archard::compliance::bem::{Balance, CondensedBody, Responses, Solid};
use archard::numerics::dense::SolveError;

/// What a file begins with; the version changes with the format and with the equations.
const FORMAT: &[u8] = b"archard compliance 5\n";
/// The same for what tractions make of the whole body.
const RESPONSES: &[u8] = b"archard responses 2\n";

/// A folder of compliances.
#[derive(Debug)]
pub struct Store {
    folder: PathBuf,
    doubts: Mutex<Vec<String>>,
}

impl Store {
    /// The store in a folder, which is made when something is kept there.
    pub fn new(folder: impl Into<PathBuf>) -> Self {
        Self { folder: folder.into(), doubts: Mutex::default() }
    }

    /// The store in the user's folder of caches; `None` where there is no such folder.
    pub fn of_user() -> Option<Self> {
        let named = |name: &str| {
            std::env::var_os(name).filter(|value| !value.is_empty()).map(PathBuf::from)
        };
        let caches = named("XDG_CACHE_HOME").or_else(|| {
            if cfg!(windows) { named("LOCALAPPDATA") } else { Some(named("HOME")?.join(".cache")) }
        });
        caches.map(|folder| Self::new(folder.join("archard")))
    }

    /// Where the compliances are.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// The compliance of a body: kept from an earlier run, or computed and kept. A folder that cannot be
    /// written to only costs the time of computing it again.
    ///
    /// # Errors
    /// If the body's equations have no unique solution.
    #[doc(hidden)]
    pub fn condense(
        &self,
        finite: &Finite,
        material: &Material,
        job: &Job<'_>,
    ) -> Result<CondensedBody, SolveError> {
        let envelope = envelope(key(FORMAT, finite, material, job), job.size());
        let found = self.find(&envelope, "compliance", |numbers| condensed(numbers, job.size()));
        if let Some(known) = found {
            return Ok(known);
        }
        let condensed = condense(finite, material, job)?;
        self.keep(&envelope, "compliance", numbers(&condensed));
        Ok(condensed)
    }

    /// What tractions of contact make of a whole body, likewise.
    ///
    /// # Errors
    /// As [`Store::condense`].
    #[doc(hidden)]
    pub fn respond(
        &self,
        finite: &Finite,
        material: &Material,
        job: &Job<'_>,
    ) -> Result<Responses, SolveError> {
        let [rows, columns] = Responses::size(job.surface, job.conditions);
        let key = key(RESPONSES, finite, material, job);
        let envelope = Envelope { format: RESPONSES, key, count: rows * columns };
        let number = |numbers: &[[u8; 8]], index: usize| f64::from_le_bytes(numbers[index]);
        let found = self.find(&envelope, "responses", |numbers| Responses {
            sought: Mat::from_fn(rows, columns, |row, column| number(numbers, row + rows * column)),
        });
        if let Some(known) = found {
            return Ok(known);
        }
        let responses =
            Solid::new(job.surface, material, job.conditions, finite.tolerance)?.responses();
        let sought = &responses.sought;
        let all = (0..rows * columns).map(|at| sought[(at % rows, at / rows)]);
        self.keep(&envelope, "responses", all);
        Ok(responses)
    }

    /// What a file of the folder holds, if the folder is trusted, and the file sound and what is looked for.
    fn find<T>(
        &self,
        envelope: &Envelope,
        kind: &str,
        make: impl FnOnce(&[[u8; 8]]) -> T,
    ) -> Option<T> {
        if let Err(doubt) = trust::folder(&self.folder) {
            self.doubt(&self.folder, doubt, "compliances are neither read from it nor kept in it");
            return None;
        }
        self.read(&self.path(&envelope.key, kind), envelope, make)
    }

    /// Keeps numbers, where the folder is trusted and can be written to.
    fn keep(&self, envelope: &Envelope, kind: &str, numbers: impl Iterator<Item = f64>) {
        if trust::folder(&self.folder).is_ok() && trust::make(&self.folder).is_ok() {
            file::remove_parts(&self.folder, trust::gone, |_| true);
            let path = self.path(&envelope.key, kind);
            let _ = file::write_private(&path, &envelope.seal(numbers));
        }
    }

    /// Writes a file of the program's own below the folder, by its name there, unless it holds that already; returns its path.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn put(&self, name: &str, content: &[u8]) -> Result<PathBuf, Error> {
        let path = self.folder.join(name);
        if files::read(&path, Contents::Numbers).is_ok_and(|known| known == content) {
            return Ok(path);
        }
        if let Some(folder) = path.parent() {
            fs::create_dir_all(folder)
                .map_err(|source| Error::Write { path: folder.to_owned(), source })?;
        }
        Place::known(path.clone()).write(content)?;
        Ok(path)
    }

    /// What was not read, and why, in a sentence each.
    pub fn doubts(&self) -> Vec<String> {
        self.doubts.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    fn doubt(&self, path: &Path, doubt: trust::Doubt, result: &str) {
        let sentence = format!("`{}` {doubt}: {result}", path.display());
        let mut doubts = self.doubts.lock().unwrap_or_else(PoisonError::into_inner);
        if !doubts.contains(&sentence) {
            doubts.push(sentence);
        }
    }

    fn path(&self, key: &[u8; OUT_LEN], kind: &str) -> PathBuf {
        let name: String = key[..16].iter().map(|byte| format!("{byte:02x}")).collect();
        self.folder.join(format!("{name}.{kind}"))
    }

    /// What is made of the numbers in a file, if it is sound and what is looked for.
    fn read<T>(
        &self,
        path: &Path,
        envelope: &Envelope,
        make: impl FnOnce(&[[u8; 8]]) -> T,
    ) -> Option<T> {
        match trust::read(path, envelope.length()?) {
            Ok(bytes) => Some(make(envelope.open(&bytes?)?)),
            Err(doubt) => {
                self.doubt(path, doubt, "the compliance is computed anew and replaces it");
                None
            }
        }
    }
}

/// The hash of all that what is kept of a body follows from.
fn key(format: &[u8], finite: &Finite, material: &Material, job: &Job<'_>) -> [u8; OUT_LEN] {
    let mut hash = blake3::Hasher::new();
    hash.update(format);
    job.fingerprint(finite, material, &mut |bytes| {
        hash.update(bytes);
    });
    hash.finalize().into()
}

/// What the file of a compliance of that size says about itself.
fn envelope(key: [u8; OUT_LEN], size: usize) -> Envelope {
    Envelope { format: FORMAT, key, count: 2 + size + size * size }
}

/// All numbers of a compliance, in the order of the file.
fn numbers(condensed: &CondensedBody) -> impl Iterator<Item = f64> {
    let size = condensed.free.len();
    let matrix = (0..size * size).map(move |at| condensed.compliance[(at % size, at / size)]);
    let Balance { force, moment } = condensed.balance;
    [force, moment].into_iter().chain(condensed.free.iter().copied()).chain(matrix)
}

/// The compliance of that size with these numbers.
fn condensed(numbers: &[[u8; 8]], size: usize) -> CondensedBody {
    let number = |index: usize| f64::from_le_bytes(numbers[index]);
    let balance = Balance { force: number(0), moment: number(1) };
    let free = (2..2 + size).map(number).collect();
    let compliance = Mat::from_fn(size, size, |row, column| number(2 + size * (1 + column) + row));
    CondensedBody { compliance, free, balance }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use faer::Mat;

    use super::{Envelope, OUT_LEN, Store, condensed as condensed_of, envelope, numbers};
    use archard::compliance::bem::{Balance, CondensedBody};

    #[test]
    fn what_is_kept_is_read_and_nothing_of_another_size() {
        let folder = tempfile::tempdir().unwrap();
        let store = Store::new(folder.path());
        let path = folder.path().join("known");
        let free = vec![1e-7, -2.0 / 3.0, 0.0];
        let compliance =
            Mat::from_fn(3, 3, |row, column| 1.0 / (1.0 + row as f64 + 10.0 * column as f64));
        let balance = Balance { force: 0.01, moment: 0.02 };
        let condensed =
            CondensedBody { compliance: compliance.clone(), free: free.clone(), balance };
        let known = envelope([7; OUT_LEN], 3);
        crate::output::file::write_private(&path, &known.seal(numbers(&condensed))).unwrap();
        let read = |path: &Path, known: &Envelope, size: usize| {
            store.read(path, known, |numbers| condensed_of(numbers, size))
        };
        let found = read(&path, &known, 3).expect("it is sound");
        assert_eq!((found.free, found.compliance, found.balance), (free, compliance, balance));
        assert!(read(&path, &envelope([8; OUT_LEN], 3), 3).is_none());
        assert!(read(&path, &envelope([7; OUT_LEN], 6), 6).is_none());
        assert!(read(&folder.path().join("none"), &known, 3).is_none());
        assert!(store.doubts().is_empty());
    }
}
