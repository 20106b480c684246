//! A route that is kept in its folder, to go on with after an interruption: the case, and a checkpoint.
//!
//! The file `checkpoint` is a line that names its format and the program's version, the hash of what the route was computed from, the
//! route, and a hash of both. It is written after a step, and never so often that it takes more than a fiftieth of the time. The results of
//! the whole route take its place.

use std::time::Instant;

use archard::numerics::seal::seal;
use archard_rail::wear::Kept;

use super::checkpoint::{self, Clock, NAME};
use super::claim::Claim;
use crate::output::{CASE, Error};

/// The line it begins with: another one with every change of what is kept.
const FORMAT: &str = concat!("archard ", env!("CARGO_PKG_VERSION"), " route 2\n");

/// Keeps a route in its folder.
#[derive(Debug)]
pub struct RouteKeeper {
    /// The case as it is printed.
    case_toml: String,
    /// The hash of all that it is computed from.
    hash: Vec<u8>,
    clock: Clock,
}

impl RouteKeeper {
    /// For a case as it is printed, and all that it is computed from in words.
    pub fn new(case_toml: String, from: &str) -> Self {
        let mut sealed = [case_toml.as_bytes(), from.as_bytes()].concat();
        let length = sealed.len();
        seal(&mut sealed);
        let hash = sealed.split_off(length);
        Self { case_toml, hash, clock: Clock::new() }
    }

    /// Keeps a route where that is due; the first time what earlier runs wrote is removed.
    ///
    /// # Errors
    /// If a file cannot be removed or written.
    pub fn keep(&mut self, claim: &mut Claim, kept: &Kept) -> Result<(), Error> {
        if !self.clock.is_due(true, 0) {
            return Ok(());
        }
        let begun = Instant::now();
        if !claim.on_a_route {
            claim.admit()?;
            claim.manifest.begin([CASE, NAME])?;
            claim.manifest.write(CASE, self.case_toml.as_bytes())?;
            claim.on_a_route = true;
        }
        // Numbers and lists, which always can be written.
        let mut content = self.hash.clone();
        content.extend(postcard::to_allocvec(kept).unwrap_or_default());
        seal(&mut content);
        let place = claim.manifest.claim(NAME)?;
        place.write(&[FORMAT.as_bytes(), &content].concat())?;
        self.clock.was_kept(begun);
        Ok(())
    }

    /// The route that was kept in a folder.
    ///
    /// # Errors
    /// If none exists, it is damaged, or what it was computed from has changed.
    pub fn find(&self, claim: &mut Claim) -> Result<Kept, Error> {
        let content = checkpoint::open(&claim.dir, FORMAT)?;
        let dir = claim.dir.clone();
        let torn = || checkpoint::torn(&dir);
        let (hash, rest) = content.split_at_checked(self.hash.len()).ok_or_else(torn)?;
        if hash != self.hash {
            let why = "its case, its profiles or its route have changed; start the run anew";
            return Err(Error::NoCheckpoint { dir: claim.dir.clone(), why });
        }
        let kept = postcard::from_bytes(rest).map_err(|_| torn())?;
        claim.on_a_route = true;
        Ok(kept)
    }
}
