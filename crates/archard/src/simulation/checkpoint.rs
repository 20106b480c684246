//! Runs that are kept, to go on with later to the same bits.
//!
//! What is kept is a [`March`]: every number that further steps follow from, as it is. The simulation itself is not; a
//! digest says whether another one is the same.

use super::digest::digest;
use super::error::ResumeError;
use super::march::March;
use super::report::Kept;
use super::setup::Simulation;
use crate::numerics::seal::{seal, unseal};

/// What is kept begins with this; another layout of a [`March`] begins with another.
const LAYOUT: &str = "march 4\n";

impl Kept for March {
    /// All that further steps follow from.
    fn to_bytes(&self) -> Vec<u8> {
        // Vectors and numbers, which always can be written.
        let numbers = postcard::to_allocvec(self).unwrap_or_default();
        let mut bytes = [LAYOUT.as_bytes(), &numbers].concat();
        seal(&mut bytes);
        bytes
    }
}

impl March {
    /// A run of a simulation from what was kept of it.
    pub(super) fn from_bytes(bytes: &[u8], simulation: &Simulation) -> Result<Self, ResumeError> {
        let content = unseal(bytes).and_then(|content| content.strip_prefix(LAYOUT.as_bytes()));
        let content = content.ok_or(ResumeError::Unreadable)?;
        let march: Self = postcard::from_bytes(content).map_err(|_| ResumeError::Unreadable)?;
        if march.digest != digest(simulation) {
            return Err(ResumeError::OtherCase);
        }
        if !march.can_go_on(simulation) {
            return Err(ResumeError::Unreadable);
        }
        Ok(march)
    }
}
