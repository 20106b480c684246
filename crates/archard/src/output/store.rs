//! Compliances of meshed bodies, kept from one run to the next.
//!
//! A file is a line that names the format, its version, the key of the body, the number of rows, the
//! balance, the values and a checksum of all before it. The key is a hash of all that the compliance follows from. What is
//! damaged, foreign or of another version is computed anew and replaced.

use std::fs;
use std::path::{Path, PathBuf};

use faer::Mat;
use sha2::{Digest, Sha256};

use super::file;
use crate::body::{Finite, Material};
use crate::compliance::bem::contact::{Job, condense};
use crate::compliance::bem::{Balance, Condensed};
use crate::numerics::dense::Singular;

/// What a file begins with; the version changes with the format and with the equations.
const FORMAT: &[u8] = b"archard compliance 3\n";
/// Bytes of a hash.
const HASH: usize = 32;

/// A folder of compliances.
#[derive(Debug, Clone)]
pub struct Store {
    folder: PathBuf,
}

impl Store {
    /// The store in a folder, which is made when something is kept there.
    pub fn new(folder: impl Into<PathBuf>) -> Self {
        Self { folder: folder.into() }
    }

    /// The compliance of a body: kept from an earlier run, or computed and kept. A folder that cannot be
    /// written to only costs the time of computing it again.
    ///
    /// # Errors
    /// If the body's equations have no unique solution.
    pub fn condense(
        &self,
        finite: &Finite,
        material: &Material,
        job: &Job<'_>,
    ) -> Result<Condensed, Singular> {
        let mut hash = Sha256::new_with_prefix(FORMAT);
        job.fingerprint(finite, material, &mut |bytes| hash.update(bytes));
        let key: [u8; HASH] = hash.finalize().into();
        let path = self.path(&key);
        if let Some(known) = read(&path, &key) {
            return Ok(known);
        }
        let condensed = condense(finite, material, job)?;
        if fs::create_dir_all(&self.folder).is_ok() {
            let _ = file::write_whole(&path, &encode(&condensed, &key));
        }
        Ok(condensed)
    }

    fn path(&self, key: &[u8; HASH]) -> PathBuf {
        let name: String = key[..16].iter().map(|byte| format!("{byte:02x}")).collect();
        self.folder.join(name + ".compliance")
    }
}

fn encode(condensed: &Condensed, key: &[u8; HASH]) -> Vec<u8> {
    let size = condensed.free.len();
    let mut bytes = Vec::with_capacity(FORMAT.len() + 2 * HASH + 8 * (3 + size + size * size));
    bytes.extend_from_slice(FORMAT);
    bytes.extend_from_slice(key);
    bytes.extend_from_slice(&(size as u64).to_le_bytes());
    let mut put = |value: f64| bytes.extend_from_slice(&value.to_le_bytes());
    [condensed.balance.force, condensed.balance.moment].into_iter().for_each(&mut put);
    condensed.free.iter().for_each(|&value| put(value));
    for column in 0..size {
        (0..size).for_each(|row| put(condensed.compliance[(row, column)]));
    }
    let sum = Sha256::digest(&bytes);
    bytes.extend_from_slice(&sum);
    bytes
}

/// The compliance in a file, if it is sound and that of this key.
fn read(path: &Path, key: &[u8; HASH]) -> Option<Condensed> {
    let bytes = fs::read(path).ok()?;
    let (content, sum) = bytes.split_at_checked(bytes.len().checked_sub(HASH)?)?;
    let rest = content.strip_prefix(FORMAT)?.strip_prefix(key)?;
    if Sha256::digest(content)[..] != *sum {
        return None;
    }
    let (values, []) = rest.as_chunks::<8>() else { return None };
    let ([size, force, moment], values) = values.split_first_chunk::<3>()?;
    let [force, moment] = [force, moment].map(|bytes| f64::from_le_bytes(*bytes));
    let size = usize::try_from(u64::from_le_bytes(*size)).ok()?;
    if size.checked_mul(size)?.checked_add(size)? != values.len() {
        return None;
    }
    let value = |index: usize| f64::from_le_bytes(values[index]);
    let free = (0..size).map(value).collect();
    let compliance = Mat::from_fn(size, size, |row, column| value(size * (1 + column) + row));
    Some(Condensed { compliance, free, balance: Balance { force, moment } })
}

#[cfg(test)]
mod tests {
    use faer::Mat;

    use super::{HASH, encode, read};
    use crate::compliance::bem::{Balance, Condensed};

    #[test]
    fn what_is_kept_is_read_and_nothing_else() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("known");
        let free = vec![1e-7, -2.0 / 3.0, 0.0];
        let compliance =
            Mat::from_fn(3, 3, |row, column| 1.0 / (1.0 + row as f64 + 10.0 * column as f64));
        let key = [7; HASH];
        let balance = Balance { force: 0.01, moment: 0.02 };
        let kept = Condensed { compliance: compliance.clone(), free: free.clone(), balance };
        let bytes = encode(&kept, &key);
        std::fs::write(&path, &bytes).unwrap();
        let known = read(&path, &key).expect("it is sound");
        assert_eq!((known.free, known.compliance, known.balance), (free, compliance, balance));
        assert!(read(&path, &[8; HASH]).is_none());
        assert!(read(&folder.path().join("none"), &key).is_none());
        for cut in 0..bytes.len() {
            std::fs::write(&path, &bytes[..cut]).unwrap();
            assert!(read(&path, &key).is_none(), "{cut} of {} bytes", bytes.len());
        }
        for at in 0..bytes.len() {
            let mut damaged = bytes.clone();
            damaged[at] ^= 1;
            std::fs::write(&path, &damaged).unwrap();
            assert!(read(&path, &key).is_none(), "byte {at}");
        }
    }
}
