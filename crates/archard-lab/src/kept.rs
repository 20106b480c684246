//! Runs of a fit that are done, kept until the fit is: one that was interrupted goes on behind them.

use std::fs;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use super::quantity::Quantity;
use archard::numerics::seal::{seal, unseal};
use archard::simulation::{Simulation, digest};
use archard_case::Case;
use archard_case::files::{self, Contents};
use archard_case::output::Place;

/// What is kept of a run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Kept {
    /// Its steps.
    pub rows: Vec<Row>,
    /// What is doubtful about it, in words.
    pub doubts: Vec<String>,
}

/// How far a step was, by each column, and what was there to be measured.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Row {
    pub far: Vec<Option<f64>>,
    pub values: Vec<Option<f64>>,
}

/// The folder of what is kept.
fn folder(dir: &Path) -> PathBuf {
    dir.join("kept")
}

/// The file of a simulation of a case whose steps tell these quantities by these columns. Quantities may follow from values
/// that no step does, as a mass from the density.
pub(super) fn file(
    dir: &Path,
    (case, simulation): (&Case, &Simulation),
    (quantities, columns): (&[Quantity], &[&str]),
) -> PathBuf {
    let mut hash = blake3::Hasher::new();
    hash.update(&digest(simulation));
    hash.update(case.to_string().as_bytes());
    hash.update(format!("{}{quantities:?}{columns:?}", env!("CARGO_PKG_VERSION")).as_bytes());
    let name: String =
        hash.finalize().as_bytes()[..16].iter().map(|byte| format!("{byte:02x}")).collect();
    folder(dir).join(name)
}

impl Kept {
    /// What a file holds; `None` where none exists, or it is damaged.
    pub fn read(path: &Path) -> Option<Self> {
        let bytes = files::read(path, Contents::Numbers).ok()?;
        postcard::from_bytes(unseal(&bytes)?).ok()
    }

    /// Keeps it. What cannot be written is run again.
    pub fn write(&self, path: &Path) {
        let mut bytes = postcard::to_allocvec(self).unwrap_or_default();
        seal(&mut bytes);
        if path.parent().is_some_and(|dir| fs::create_dir_all(dir).is_ok()) {
            let place = Place::free_or(path, |known| unseal(known).is_some());
            let _ = place.and_then(|place| place.write(&bytes));
        }
    }
}

/// Removes the files of a fit that is done, and their folder if nothing else is in it.
pub(super) fn clear(dir: &Path, files: &[PathBuf]) {
    for file in files {
        let _ = fs::remove_file(file);
    }
    let _ = fs::remove_dir(folder(dir));
}

#[cfg(test)]
mod tests {
    use super::{Kept, Row, clear};

    /// What others have put into a folder of that name is theirs.
    #[test]
    fn files_of_others_stay() {
        let dir = tempfile::tempdir().unwrap();
        let [own, other] = ["kept/one", "kept/data.txt"].map(|name| dir.path().join(name));
        Kept { rows: vec![], doubts: vec![] }.write(&own);
        std::fs::write(&other, "precious").unwrap();
        clear(dir.path(), std::slice::from_ref(&own));
        assert!(!own.exists() && other.exists());
        std::fs::remove_file(other).unwrap();
        clear(dir.path(), &[own]);
        assert!(!dir.path().join("kept").exists());
    }

    #[test]
    fn what_is_damaged_is_not_taken() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("kept/one");
        let rows = vec![Row { far: vec![Some(0.1), None], values: vec![Some(1e-13 / 3.0)] }];
        let kept = Kept { rows, doubts: vec!["doubtful".to_owned()] };
        kept.write(&path);
        assert_eq!(Kept::read(&path), Some(kept));
        let mut bytes = std::fs::read(&path).unwrap();
        bytes[1] ^= 1;
        std::fs::write(&path, bytes).unwrap();
        assert_eq!(Kept::read(&path), None);
    }
}
