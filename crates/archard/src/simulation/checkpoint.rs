//! Runs that are kept, to go on with later to the same bits.
//!
//! What is kept is a [`March`]: every number that further steps follow from, as it is. The simulation itself is not; a
//! digest says whether another one is the same.

use sha2::{Digest, Sha256};

use super::Simulation;
use super::march::March;

/// Bytes of a checksum.
const SUM: usize = 32;

/// Why a run does not go on from what was kept.
#[non_exhaustive]
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum NotResumed {
    /// It does not read as a run of this version.
    #[error("what was kept of the run cannot be read; start it anew")]
    Unreadable,
    /// It is of another simulation.
    #[error(
        "what was kept is of another case, or a file that the case names has changed; start it anew"
    )]
    OtherCase,
}

impl March {
    /// All that further steps follow from.
    pub(super) fn to_bytes(&self) -> Vec<u8> {
        // Vectors and numbers, which always can be written.
        let mut bytes = postcard::to_allocvec(self).unwrap_or_default();
        let sum = Sha256::digest(&bytes);
        bytes.extend_from_slice(&sum);
        bytes
    }

    /// A run of a simulation from what was kept of it.
    pub(super) fn from_bytes(bytes: &[u8], simulation: &Simulation) -> Result<Self, NotResumed> {
        let content = bytes.split_last_chunk::<SUM>();
        let content = content.filter(|(content, sum)| Sha256::digest(content)[..] == **sum);
        let (content, _) = content.ok_or(NotResumed::Unreadable)?;
        let march: Self = postcard::from_bytes(content).map_err(|_| NotResumed::Unreadable)?;
        if march.digest != digest(simulation) {
            return Err(NotResumed::OtherCase);
        }
        Ok(march)
    }
}

/// A hash of what the steps of a simulation follow from. Of compliances that have a matrix, which follow from meshes, it
/// takes a few entries.
pub(crate) fn digest(simulation: &Simulation) -> [u8; 32] {
    let Simulation { problem, solver, friction_solver, schedule, .. } = simulation;
    let mut hash = Sha256::new();
    for body in &problem.bodies {
        hash.update(format!(
            "{}{:?}{:?}{:?}{:?}",
            body.name,
            body.material,
            body.wear,
            body.curvatures(),
            body.depth
        ));
        if let Some(thermal) = &body.thermal {
            hash.update(format!("{thermal:?}"));
        }
    }
    hash.update(format!("{:?}{:?}{schedule:?}", problem.friction, problem.motion));
    hash.update(format!("{:?}{:?}", solver.settings(), friction_solver.settings()));
    hash.update(format!("{solver:?}{friction_solver:?}"));
    let frame = &problem.frame;
    hash.update(format!("{:?}{:?}{}", frame.elements(), frame.rectangle(), frame.is_line()));
    let pairs = frame.len();
    let few = [0, pairs / 2, pairs.saturating_sub(1)];
    let few = problem.compliance.matrix(&few);
    let few = few.iter().flatten();
    let own = [problem.compliance.normal_self_term()];
    // Elements and size tell the places on a uniform grid.
    let listed = if frame.is_uniform() { 0 } else { pairs };
    let places = (0..listed).flat_map(|pair| frame.place(pair));
    let numbers = frame.gap().iter().chain(&own).chain(few).copied().chain(places);
    numbers.for_each(|number| hash.update(number.to_le_bytes()));
    if let Some(wider) = &simulation.wider {
        hash.update(wider.from.to_le_bytes());
        hash.update(digest(&wider.simulation));
    }
    hash.finalize().into()
}
