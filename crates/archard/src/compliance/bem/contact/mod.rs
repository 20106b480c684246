//! Contact of meshed bodies: the pairs at their nodes, and how both bodies deform there.
//!
//! The pairs are nodes of a meshed body, the host: of two the one whose zone is plane, or the first. The other body is
//! rigid, a half-space or meshed itself; it need not have nodes in the same places. A meshed body may be told to deform
//! as a half-space: its mesh then gives the pairs and their gaps only.

mod fingerprint;
mod half_space;
mod host;
mod meeting;
mod near;
mod normals;
mod outline;
mod project;
mod rim;
mod transfer;

use std::sync::Arc;

use glam::DVec3;

use super::conditions::{Conditions, Indeterminacy};
use super::solid::CondensedBody;
use super::surface::Surface;
use super::{AssembledBody, AxisCondition, Condition, Listener, Stage, TractionNode, advice};
use crate::body::{Body, Finite, Material, Support};
use crate::compliance::Compliance;
use crate::frame::{ContactFrame, OffTheSurface, PairsError};
use crate::numerics::dense::SolveError;
use crate::numerics::large::NoMemory;

pub use meeting::BodiesInContact;
pub(in crate::compliance) use near::Near;

/// The cosine of 30 degrees. Normals that turn by more belong to two surfaces that meet in an edge, and to a zone for which no
/// half-space stands and whose pairs meet along their own normals.
pub(crate) const STEEP: f64 = 0.866_025_403_784_438_6;

/// Why meshed bodies cannot be brought into contact.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ContactError {
    /// A mesh without a zone that may touch.
    #[error("body {} says of no part of its mesh that it may touch: name it as `contact`", .body + 1)]
    NoZone {
        /// The body's index, 0 or 1.
        body: usize,
    },
    /// Symmetric and whole bodies.
    #[error(
        "one body is halved by a plane of symmetry and the other is not: give both the same `symmetry`"
    )]
    Symmetry,
    /// A body that is not held.
    #[error("body {}: {cause}", .body + 1)]
    Undetermined {
        /// The body's index, 0 or 1.
        body: usize,
        /// What is wrong.
        cause: Indeterminacy,
    },
    /// A matrix that says nothing of its body.
    #[error("body {}: {message}", .body + 1)]
    Matrix {
        /// The body's index, 0 or 1.
        body: usize,
        /// What is wrong.
        message: String,
    },
    /// Equations without a solution.
    #[error("body {}: {cause}; {}", .body + 1, advice(.cause))]
    Singular {
        /// The body's index, 0 or 1.
        body: usize,
        /// What is wrong.
        cause: SolveError,
    },
    /// The zones do not face each other.
    #[error(
        "the contact zone of the other body does not lie opposite to ({:e}, {:e}, {:e}) m of body {}: enlarge it or make this one smaller",
        .place[0], .place[1], .place[2], .body + 1
    )]
    NotOpposite {
        /// The body whose zone reaches too far, 0 or 1.
        body: usize,
        /// Where, in its own coordinates (m).
        place: [f64; 3],
    },
    /// Zones whose outward normals agree, instead of being opposite.
    #[error(
        "the contact zones of both bodies look the same way: files share their axes, in which the zones face each other"
    )]
    SameWay {
        /// The body that may be turned over, 0 or 1.
        body: usize,
    },
    /// A zone that a half-space cannot stand for.
    #[error(
        "body {}: the contact zone turns by {angle:.0} degrees from the plane of contact: no half-space stands for it",
        .body + 1
    )]
    Steep {
        /// The body's index, 0 or 1.
        body: usize,
        /// The largest angle between normals (degrees).
        angle: f64,
    },
    /// A body with an image field, whose mesh says nothing of its contact.
    #[error(
        "body {} has an image field: its mesh says nothing of its contact, nor of the stresses below; take `Elasticity::BoundaryElements`",
        .body + 1
    )]
    HasImage {
        /// The body's index, 0 or 1.
        body: usize,
    },
    /// A body whose inside nobody knows.
    #[error(
        "body {} has no tetrahedra inside, which finite elements take; take `Elasticity::BoundaryElements`",
        .body + 1
    )]
    Hollow {
        /// The body's index, 0 or 1.
        body: usize,
    },
    /// A frame that reaches beyond the flat face of a body.
    #[error("the frame reaches beyond the flat face of a body of finite shape: make it smaller")]
    BesideTheFace,
    /// A body that is moved until the frame leaves its flat face.
    #[error(
        "body {} is moved until the frame reaches beyond its flat face: move it less, or make it longer",
        .body + 1
    )]
    LeavesTheFace {
        /// The body's index, 0 or 1.
        body: usize,
    },
    /// A profile that ends within the frame.
    #[error(transparent)]
    OffTheSurface(#[from] OffTheSurface),
    /// The compliance of all pairs is too large.
    #[error("{0}; take fewer elements")]
    NoMemory(#[from] NoMemory),
    /// A description of pairs that is not sound.
    #[error(transparent)]
    Pairs(#[from] PairsError),
}

/// Where meshed bodies may touch and how they deform there.
#[derive(Debug)]
pub struct Contact {
    /// The pairs.
    pub frame: ContactFrame,
    /// Both bodies.
    pub compliance: Arc<dyn Compliance>,
}

/// What condenses a meshed body to its contact nodes, or remembers having done so.
pub type Condense<'a> =
    &'a dyn Fn(&Finite, &Material, &Job<'_>) -> Result<CondensedBody, SolveError>;

/// The equations of one body.
#[derive(Debug)]
pub struct Job<'a> {
    /// Its elements.
    pub surface: &'a Surface,
    /// What is known at its nodes.
    pub conditions: &'a Conditions,
    /// Who is told how far they are.
    pub told: Listener<'a>,
}

/// Condenses a body from its mesh.
///
/// # Errors
/// If its equations have no unique solution.
pub fn condense(
    finite: &Finite,
    material: &Material,
    job: &Job<'_>,
) -> Result<CondensedBody, SolveError> {
    let Job { surface, conditions, told } = *job;
    let equations =
        AssembledBody::telling((surface, conditions), material, finite.tolerance, told)?;
    told.tell(surface.unknowns(), Stage::Factorising, 0.0);
    Ok(equations.factorise()?.condense_telling(told))
}

impl Contact {
    /// The contact of two bodies, one of them meshed at least.
    ///
    /// # Errors
    /// If they cannot touch, are not held or profiles end within the zone.
    pub fn new(bodies: [&Body; 2], condense: Condense<'_>) -> Result<Self, ContactError> {
        BodiesInContact::of(bodies)?.condense(condense)
    }
}

/// What the supports of a body say of a node.
pub fn supported(finite: &Finite, node: &TractionNode) -> Condition {
    let support = finite.supports.iter().find(|(surface, _)| *surface == node.surface);
    match support.map(|(_, support)| *support) {
        None => Condition::free(),
        Some(Support::Clamped) => Condition::clamped(),
        Some(Support::Roller) => Condition::roller(node.normal),
        Some(Support::Pressure(pressure)) => Condition::pressed(node.normal, pressure),
        Some(Support::Traction(traction)) => {
            Condition::along_axes(traction.map(AxisCondition::Traction))
        }
        Some(Support::Displacement(displacement)) => {
            Condition::along_axes(displacement.map(|known| {
                known.map_or(AxisCondition::Traction(0.0), AxisCondition::Displacement)
            }))
        }
    }
}

/// Components of a vector along three others.
fn along(basis: [DVec3; 3], vector: DVec3) -> DVec3 {
    DVec3::from_array(basis.map(|unit| unit.dot(vector)))
}
