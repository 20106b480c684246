//! A run that is kept in its folder, to go on with after an interruption.
//!
//! The file `checkpoint` is a line that names its format and the program's version, what the results so far amount to,
//! the run itself, and a hash of both. It is written when fields are put out, and at least twice a minute
//! as far as steps end in that time; never so often that it takes more than a fiftieth of the time. When the
//! run has come to its end, it goes.

use std::io;
use std::path::Path;
use std::time::{Duration, Instant};

use serde::{Deserialize, Serialize};

use super::super::evidence::Evidence;
use super::super::fretting_loop::FrettingLoop;
use super::super::life::Life;
use super::super::table::Kept as KeptTable;
use super::super::{Error, Place};
use super::{Claim, TABLES, claim};
use crate::files::{self, Contents};
use archard::numerics::seal::{seal, unseal};
use archard::simulation::Simulation;

/// The file.
pub(in crate::output) const NAME: &str = "checkpoint";
/// The line it begins with: another one with every change of what is kept.
const FORMAT: &str = concat!("archard ", env!("CARGO_PKG_VERSION"), " checkpoint 16\n");
/// The longest a run is not kept where it could be.
const LONGEST: Duration = Duration::from_secs(30);
/// Time between two times it is kept over the time that takes, at least.
const SPARE: u32 = 50;
/// Time to keep a run for the first time, a pair: 43 bytes took 40 ns to make on 256 x 256 elements, and as much again to
/// write.
const PAIR: Duration = Duration::from_nanos(100);

/// What the results of a run amount to, besides what is in their files.
#[derive(Debug, Serialize, Deserialize)]
pub(super) struct Kept {
    /// The tables, in their order in the folder.
    pub tables: [Option<KeptTable>; TABLES.len()],
    pub fretting_loop: FrettingLoop,
    pub outputs: Vec<(f64, String)>,
    pub iterations: usize,
    pub evidence: Evidence,
    pub life: Life,
    /// Time the run has taken (s).
    pub seconds: f64,
}

impl Kept {
    /// Says whether the files of a folder are those of these results.
    ///
    /// # Errors
    /// If one of them is missing, shorter than it was or somebody else's.
    fn find(&self, claim: &Claim) -> Result<(), Error> {
        let dir = &claim.dir;
        let damaged = || torn(dir);
        let [history, profiles, ..] = self.tables;
        if history.is_none() || profiles.is_none() {
            return Err(damaged());
        }
        let mut names = self.outputs.iter().map(|(_, name)| claim::output(name)).enumerate();
        if !names.all(|(index, number)| number == Some(index)) {
            return Err(damaged());
        }
        claim.admit()?;
        TABLES.iter().zip(self.tables).try_for_each(|(name, kept)| match kept {
            Some(kept) => kept.find(&dir.join(name)),
            None => Ok(()),
        })
    }
}

/// When a run was kept last, and how long that took.
#[derive(Debug)]
pub(super) struct Clock {
    last: Instant,
    took: Option<Duration>,
}

impl Clock {
    pub fn new() -> Self {
        Self { last: Instant::now(), took: None }
    }

    /// Whether a run of so many pairs is to be kept again.
    pub fn is_due(&self, output: bool, pairs: usize) -> bool {
        let since = self.last.elapsed();
        let takes = || self.took.unwrap_or(PAIR.saturating_mul(pairs as u32));
        since >= LONGEST || output && since >= SPARE * takes()
    }

    /// Takes note that the run was kept, which began then.
    pub fn was_kept(&mut self, begun: Instant) {
        *self = Self { last: Instant::now(), took: Some(begun.elapsed()) };
    }
}

/// Keeps a run at its place in a folder: the results so far, and the run.
pub(super) fn write(place: &Place, kept: &Kept, run: &[u8]) -> Result<(), Error> {
    // Numbers, names and lists, which always can be written.
    let mut content = postcard::to_allocvec(kept).unwrap_or_default();
    content.extend_from_slice(run);
    seal(&mut content);
    place.write(&[FORMAT.as_bytes(), &content].concat())
}

/// What was kept in a folder of a simulation: the results so far, and the run, which belong together.
///
/// # Errors
/// If there is nothing, it is of another simulation, or the files are not those of these results.
pub(super) fn find(claim: &Claim, simulation: &Simulation) -> Result<(Kept, Vec<u8>), Error> {
    let (kept, run) = read(&claim.dir)?;
    let refused = |source| Error::NotResumed { dir: claim.dir.clone(), source };
    simulation.recognise(&run).map_err(refused)?;
    kept.find(claim)?;
    Ok((kept, run))
}

/// Says whether what was kept in a folder, of whichever simulation, is whole. The files of the results are compared with it once
/// the simulation is known: those of another are not damaged.
///
/// # Errors
/// If there is nothing, it is damaged or of another version.
pub(super) fn find_any(claim: &Claim) -> Result<(), Error> {
    read(&claim.dir).map(|_| ())
}

/// What was kept in a folder: the results so far, and the run.
fn read(dir: &Path) -> Result<(Kept, Vec<u8>), Error> {
    let content = open(dir, FORMAT)?;
    let (kept, run) = postcard::take_from_bytes(&content).map_err(|_| torn(dir))?;
    Ok((kept, run.to_vec()))
}

/// What the checkpoint in a folder holds that begins with that line.
///
/// # Errors
/// If none exists, or it is damaged or of another version.
pub(super) fn open(dir: &Path, format: &str) -> Result<Vec<u8>, Error> {
    let path = dir.join(NAME);
    let refuse = |why: &'static str| Error::NoCheckpoint { dir: dir.to_owned(), why };
    let bytes = match files::read(&path, Contents::Numbers) {
        Ok(bytes) => bytes,
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Err(refuse(missing(dir))),
        Err(source) => return Err(Error::Read { path, source }),
    };
    let Some(rest) = bytes.strip_prefix(format.as_bytes()) else {
        return Err(refuse(
            "its checkpoint is of another version of the program, or none; start the run anew",
        ));
    };
    unseal(rest).map(<[u8]>::to_vec).ok_or_else(|| torn(dir))
}

/// A checkpoint that is not as it was written.
pub(super) fn torn(dir: &Path) -> Error {
    let why = "its checkpoint is damaged; start the run anew";
    Error::NoCheckpoint { dir: dir.to_owned(), why }
}

/// Why there is no checkpoint.
fn missing(dir: &Path) -> &'static str {
    if dir.join("summary.json").is_file() {
        "the run came to its end, or ended before there was a checkpoint"
    } else {
        "there is no checkpoint in it"
    }
}
