//! Contact of meshed bodies: the pairs at their nodes, and how both bodies deform there.
//!
//! The pairs are nodes of the first meshed body, the host. The other body is rigid, a half-space or meshed
//! itself; it need not have nodes in the same places.

mod fingerprint;
mod half_space;
mod host;
mod outline;
mod project;
mod transfer;

use faer::Mat;
use glam::DVec3;

use super::conditions::{Conditions, Undetermined};
use super::solid::{Condensed, Solid};
use super::surface::Surface;
use super::{Condition, Given, TractionNode};
use crate::body::{Body, Finite, Material, Support};
use crate::compliance::Dense;
use crate::frame::{ContactFrame, OffTheSurface, Pairs, PairsError};
use crate::numerics::dense::Singular;

use host::Host;

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
        cause: Undetermined,
    },
    /// Equations without a solution.
    #[error("body {}: {cause}; are elements degenerate?", .body + 1)]
    Singular {
        /// The body's index, 0 or 1.
        body: usize,
        /// What is wrong.
        cause: Singular,
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
    /// A profile that ends within the frame.
    #[error(transparent)]
    OffTheSurface(#[from] OffTheSurface),
    /// Pairs that are none.
    #[error(transparent)]
    Pairs(#[from] PairsError),
}

/// Where meshed bodies may touch and how they deform there.
#[derive(Debug)]
pub struct Contact {
    /// The pairs.
    pub frame: ContactFrame,
    /// Both bodies.
    pub compliance: Dense,
}

/// What condenses a meshed body to its contact nodes, or remembers having done so.
pub type Condense<'a> = &'a dyn Fn(&Finite, &Material, &Job<'_>) -> Result<Condensed, Singular>;

/// The equations of one body.
#[derive(Debug)]
pub struct Job<'a> {
    /// Its elements.
    pub surface: &'a Surface,
    /// What is known at its nodes.
    pub conditions: &'a Conditions,
}

/// Condenses a body from its mesh.
///
/// # Errors
/// If its equations have no unique solution.
pub fn condense(
    finite: &Finite,
    material: &Material,
    job: &Job<'_>,
) -> Result<Condensed, Singular> {
    Ok(Solid::new(job.surface, material, job.conditions, finite.tolerance)?.condense())
}

impl Contact {
    /// The contact of two bodies, one of them meshed at least.
    ///
    /// # Errors
    /// If they cannot touch, are not held or profiles end within the zone.
    pub fn new(bodies: [&Body; 2], condense: Condense<'_>) -> Result<Self, ContactError> {
        let which = usize::from(bodies[0].finite.is_none());
        let (body, other) = (bodies[which], bodies[1 - which]);
        let none = ContactError::NoZone { body: which };
        let host = Host::new(body, which).ok_or(none)?;
        let own = condensed(body, which, &host, condense)?;
        let mut pairs = host.pairs();
        let mut parts = vec![own.compliance];
        let sign = if which == 0 { 1.0 } else { -1.0 };
        // Gap by what the loads elsewhere displace: body 2 less body 1 along n.
        let mut opened: Vec<f64> = own.free.iter().skip(2).step_by(3).map(|n| -sign * n).collect();
        match (&other.finite, &other.material) {
            (Some(finite), Some(material)) => {
                let opposite =
                    Host::new(other, 1 - which).ok_or(ContactError::NoZone { body: 1 - which })?;
                if opposite.surface.mirrored != host.surface.mirrored {
                    return Err(ContactError::Symmetry);
                }
                let _ = (finite, material);
                let transfer = transfer::Transfer::new(&host, &opposite)?;
                let theirs = condensed(other, 1 - which, &opposite, condense)?;
                for (gap, distance) in pairs.gap.iter_mut().zip(&transfer.gap) {
                    *gap += distance;
                }
                let free = transfer.displacements(&theirs.free);
                opened.iter_mut().zip(&free).for_each(|(gap, free)| *gap += sign * free);
                parts.push(transfer.compliance(&theirs.compliance));
            }
            (None, Some(material)) => parts.push(half_space::compliance(&host, material, which)),
            _ => {}
        }
        pairs.gap.iter_mut().zip(opened).for_each(|(gap, opened)| *gap += opened);
        add_profiles(bodies, &mut pairs)?;
        touch(&mut pairs, &host);
        let frame = ContactFrame::described(pairs)?;
        let parts: Vec<_> = parts.iter().map(Mat::as_ref).collect();
        let compliance = Dense::new(&parts);
        Ok(Self { frame, compliance })
    }
}

/// Adds the recesses of the profiles, along the normal of each pair.
fn add_profiles(bodies: [&Body; 2], pairs: &mut Pairs) -> Result<(), OffTheSurface> {
    for (pair, [x, y, _]) in pairs.places.iter().enumerate() {
        let closing = pairs.bases.get(pair).map_or(1.0, |basis| basis[2][2]);
        for (body, recess) in bodies.map(|body| body.profile.recess(*x, *y)).iter().enumerate() {
            if !recess.is_finite() {
                return Err(OffTheSurface { body, place: [*x, *y] });
            }
            pairs.gap[pair] += recess * closing;
        }
    }
    Ok(())
}

/// Brings the bodies together until they touch somewhere.
fn touch(pairs: &mut Pairs, host: &Host) {
    const FACING: f64 = 0.1;
    let closing: Vec<f64> = (0..pairs.gap.len()).map(|pair| host.closing(pair)).collect();
    let apart = pairs.gap.iter().zip(&closing).filter(|(_, closing)| **closing > FACING);
    let least = apart.map(|(gap, closing)| gap / closing).fold(f64::INFINITY, f64::min);
    if least.is_finite() {
        pairs.gap.iter_mut().zip(&closing).for_each(|(gap, closing)| *gap -= least * closing);
    }
}

/// The body condensed to its contact nodes.
fn condensed(
    body: &Body,
    which: usize,
    host: &Host,
    condense: Condense<'_>,
) -> Result<Condensed, ContactError> {
    let (Some(finite), Some(material)) = (&body.finite, &body.material) else {
        return Err(ContactError::NoZone { body: which });
    };
    let of = |node: &TractionNode| supported(finite, node);
    let conditions = Conditions::new(&host.surface, of, &host.contact)
        .map_err(|cause| ContactError::Undetermined { body: which, cause })?;
    let job = Job { surface: &host.surface, conditions: &conditions };
    condense(finite, material, &job).map_err(|cause| ContactError::Singular { body: which, cause })
}

/// What the supports of a body say of a node.
pub fn supported(finite: &Finite, node: &TractionNode) -> Condition {
    let support = finite.supports.iter().find(|(surface, _)| *surface == node.surface);
    match support.map(|(_, support)| *support) {
        None => Condition::free(),
        Some(Support::Clamped) => Condition::clamped(),
        Some(Support::Roller) => Condition::roller(node.normal),
        Some(Support::Pressure(pressure)) => Condition::pressed(node.normal, pressure),
        Some(Support::Traction(traction)) => Condition::along_axes(traction.map(Given::Traction)),
        Some(Support::Displacement(displacement)) => Condition::along_axes(
            displacement.map(|known| known.map_or(Given::Traction(0.0), Given::Displacement)),
        ),
    }
}

/// Components of a vector along three others.
fn along(basis: [DVec3; 3], vector: DVec3) -> DVec3 {
    DVec3::from_array(basis.map(|unit| unit.dot(vector)))
}
