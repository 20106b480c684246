//! Runs that are kept, to go on with later to the same bits.
//!
//! What is kept is a [`March`]: every number that further steps follow from, as it is. The simulation itself is not; a
//! digest says whether another one is the same.

use super::Simulation;
use super::march::March;
use crate::numerics::seal::{seal, unseal};

/// What is kept begins with this; another layout of a [`March`] begins with another.
const LAYOUT: &str = "march 3\n";

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
        let numbers = postcard::to_allocvec(self).unwrap_or_default();
        let mut bytes = [LAYOUT.as_bytes(), &numbers].concat();
        seal(&mut bytes);
        bytes
    }

    /// A run of a simulation from what was kept of it.
    pub(super) fn from_bytes(bytes: &[u8], simulation: &Simulation) -> Result<Self, NotResumed> {
        let content = unseal(bytes).and_then(|content| content.strip_prefix(LAYOUT.as_bytes()));
        let content = content.ok_or(NotResumed::Unreadable)?;
        let march: Self = postcard::from_bytes(content).map_err(|_| NotResumed::Unreadable)?;
        if march.digest != digest(simulation) {
            return Err(NotResumed::OtherCase);
        }
        if !march.can_go_on(simulation) {
            return Err(NotResumed::Unreadable);
        }
        Ok(march)
    }
}

/// A hash of what the steps of a simulation follow from. Of compliances that have a matrix, which follow from meshes, it
/// takes a few entries.
pub fn digest(simulation: &Simulation) -> [u8; 32] {
    let Simulation { problem, solver, friction_solver, schedule, .. } = simulation;
    let mut hash = blake3::Hasher::new();
    for body in &problem.bodies {
        hash.update(
            format!(
                "{}{:?}{:?}{:?}{:?}",
                body.name,
                body.material,
                body.wear,
                body.curvatures(),
                body.depth
            )
            .as_bytes(),
        );
        if let Some(hardness) = body.hardness {
            hash.update(&hardness.to_le_bytes());
        }
        if let Some(thermal) = &body.thermal {
            hash.update(format!("{thermal:?}").as_bytes());
        }
    }
    hash.update(format!("{:?}{:?}{schedule:?}", problem.friction, problem.motion).as_bytes());
    hash.update(format!("{:?}{:?}", solver.settings(), friction_solver.settings()).as_bytes());
    hash.update(format!("{solver:?}{friction_solver:?}").as_bytes());
    let frame = &problem.frame;
    hash.update(
        format!("{:?}{:?}{}", frame.elements(), frame.rectangle(), frame.is_line()).as_bytes(),
    );
    let pairs = frame.len();
    let few = [0, pairs / 2, pairs.saturating_sub(1)];
    let few = problem.compliance.matrix(&few);
    let few = few.iter().flatten();
    let own = [problem.compliance.normal_self_term()];
    // Elements and size tell the places on a uniform grid.
    let listed = if frame.is_uniform() { 0 } else { pairs };
    let places = (0..listed).flat_map(|pair| frame.place(pair));
    let numbers = frame.gap().iter().chain(&own).chain(few).copied().chain(places);
    let bytes: Vec<u8> = numbers.flat_map(f64::to_le_bytes).collect();
    hash.update(&bytes);
    if let Some(wider) = &simulation.wider {
        hash.update(&wider.from.to_le_bytes());
        hash.update(&digest(&wider.simulation));
    }
    hash.finalize().into()
}
