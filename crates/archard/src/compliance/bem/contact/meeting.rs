//! Two bodies opposite each other: all that their contact needs but how they deform.

use faer::Mat;

use super::super::solid::Condensed;
use super::super::{Conditions, Told};
use super::STEEP;
use super::host::Host;
use super::transfer::Transfer;
use super::{Condense, Contact, ContactError, Job, half_space, supported};
use crate::body::{Body, Elasticity};
use crate::compliance::Dense;
use crate::frame::{ContactFrame, OffTheSurface, Pairs, VectorField};

/// Two bodies, one of them meshed at least, and the pairs where they may touch.
pub struct Meeting<'a> {
    bodies: [&'a Body; 2],
    host: Side<'a>,
    opposite: Option<(Side<'a>, Transfer)>,
    pairs: Pairs,
}

/// A meshed body.
struct Side<'a> {
    host: Host<'a>,
    /// What is known at its nodes; `None` where it does not matter.
    conditions: Option<Conditions>,
}

impl<'a> Meeting<'a> {
    /// Brings two bodies opposite each other.
    ///
    /// # Errors
    /// If they cannot touch, are not held or profiles end within the zone.
    pub fn of(bodies: [&'a Body; 2]) -> Result<Self, ContactError> {
        if let Some(body) = bodies.iter().position(|body| body.has_image()) {
            return Err(ContactError::HasImage { body });
        }
        let which = bears_the_pairs(bodies);
        let host = Side::new(bodies[which], which)?;
        let mut pairs = host.host.pairs();
        let opposite = match &bodies[1 - which].finite {
            None => None,
            Some(_) => {
                let opposite = Side::new(bodies[1 - which], 1 - which)?;
                if opposite.host.surface.mirrored != host.host.surface.mirrored {
                    return Err(ContactError::Symmetry);
                }
                let transfer = Transfer::new(&host.host, &opposite.host)?;
                for (gap, distance) in pairs.gap.iter_mut().zip(&transfer.gap) {
                    *gap += distance;
                }
                Some((opposite, transfer))
            }
        };
        add_profiles(bodies, &mut pairs)?;
        Ok(Self { bodies, host, opposite, pairs })
    }

    /// The pairs; their gaps may differ by the same distance everywhere from those of bodies that touch.
    pub fn pairs(&self) -> &Pairs {
        &self.pairs
    }

    /// Whether the pairs lie on a plane, as rolling asks for.
    pub fn is_plane(&self) -> bool {
        self.pairs.bases.is_empty()
    }

    /// The equations of a meshed body and the tractions (Pa) on it, three a contact node in their bases, where
    /// those of the pairs are given; `None` if something else says how it deforms.
    pub fn acting_on(&self, which: usize, tractions: &VectorField) -> Option<(Job<'_>, Vec<f64>)> {
        let of_pairs = |pair: usize| tractions.components().map(|along| along[pair]);
        let pairs: Vec<f64> = (0..self.pairs.gap.len()).flat_map(of_pairs).collect();
        let (side, mut acting) = match &self.opposite {
            Some((side, transfer)) if side.host.which == which => (side, transfer.act(&pairs)),
            _ => (&self.host, pairs),
        };
        if side.host.which != which {
            return None;
        }
        if which == 1 {
            acting.iter_mut().for_each(|traction| *traction = -*traction);
        }
        let (surface, conditions) = (&side.host.surface, side.conditions.as_ref()?);
        Some((Job { surface, conditions, told: Told::default() }, acting))
    }

    /// Values of the pairs at the nodes of tractions of a meshed body, zero away from the contact; those of the other
    /// body are means over what lies opposite to each of its nodes.
    pub fn on_nodes(&self, which: usize, pairs: &[f64]) -> Vec<f64> {
        let (host, values) = match &self.opposite {
            Some((side, transfer)) if side.host.which == which => {
                (&side.host, transfer.mean(pairs))
            }
            _ => (&self.host.host, pairs.to_vec()),
        };
        if values.is_empty() {
            return vec![];
        }
        let mut nodes = vec![0.0; host.surface.tractions.len()];
        host.contact.iter().zip(values).for_each(|((node, _), value)| nodes[*node] = value);
        nodes
    }

    /// The contact, with what says how meshed bodies deform.
    ///
    /// # Errors
    /// If equations have no solution.
    pub fn condense(self, condense: Condense<'_>) -> Result<Contact, ContactError> {
        let Self { bodies, host: Side { host, conditions }, opposite, mut pairs } = self;
        let sign = if host.first { 1.0 } else { -1.0 };
        let (mut parts, mut balance) = (vec![], vec![]);
        if let Some(own) = condensed(bodies, &host, conditions.as_ref(), condense)? {
            // Gap by what the loads elsewhere displace: body 2 less body 1 along n.
            let normal = own.free.iter().skip(2).step_by(3);
            pairs.gap.iter_mut().zip(normal).for_each(|(gap, free)| *gap -= sign * free);
            parts.push(own.compliance);
            balance.push((host.which, own.balance));
        }
        if let Some((Side { host: other, conditions }, transfer)) = opposite
            && let Some(own) = condensed(bodies, &other, conditions.as_ref(), condense)?
        {
            let normal = transfer.displacements(&own.free);
            pairs.gap.iter_mut().zip(&normal).for_each(|(gap, free)| *gap += sign * free);
            // What is near is done at the pairs themselves, what is left is smooth.
            if let Some(material) = &bodies[other.which].material {
                let near = half_space::on_the_surface(&other, material, other.which);
                let left = transfer.compliance(&(own.compliance - near));
                balance.push((other.which, own.balance));
                parts.extend([left, half_space::on_the_surface(&host, material, other.which)]);
            }
        }
        for (which, body) in bodies.into_iter().enumerate() {
            if let (true, Some(material)) = (is_half_space(body), &body.material) {
                parts.push(half_space::compliance(&host, material, which));
            }
        }
        touch(&mut pairs, &host);
        let frame = ContactFrame::described(pairs)?;
        let parts: Vec<_> = parts.iter().map(Mat::as_ref).collect();
        let compliance = Dense::new(&parts)?.balanced(balance);
        Ok(Contact { frame, compliance })
    }
}

impl<'a> Side<'a> {
    fn new(body: &'a Body, which: usize) -> Result<Self, ContactError> {
        let (Some(finite), Some(host)) = (&body.finite, Host::new(body, which)) else {
            return Err(ContactError::NoZone { body: which });
        };
        if finite.elasticity == Elasticity::HalfSpace || body.material.is_none() {
            let closing = (0..host.contact.len()).map(|pair| host.closing(pair));
            let steepest = closing.fold(1.0, f64::min).clamp(-1.0, 1.0);
            let angle = steepest.acos().to_degrees();
            if steepest < STEEP && body.material.is_some() {
                return Err(ContactError::Steep { body: which, angle });
            }
            return Ok(Self { host, conditions: None });
        }
        let conditions =
            Conditions::new(&host.surface, |node| supported(finite, node), &host.contact)
                .map_err(|cause| ContactError::Undetermined { body: which, cause })?;
        Ok(Self { host, conditions: Some(conditions) })
    }
}

/// The body whose nodes are the pairs: the meshed one; of two the one whose zone is plane, as rolling asks for, or the
/// first.
fn bears_the_pairs(bodies: [&Body; 2]) -> usize {
    let plane = |which: usize| {
        bodies[which].finite.as_ref().is_some_and(|finite| finite.meshed.has_plane_zone())
    };
    match bodies.map(|body| body.finite.is_some()) {
        [true, true] => usize::from(!plane(0) && plane(1)),
        [first, _] => usize::from(!first),
    }
}

/// Whether a body deforms as a half-space.
fn is_half_space(body: &Body) -> bool {
    body.finite.as_ref().is_none_or(|finite| finite.elasticity == Elasticity::HalfSpace)
}

/// A body condensed to its contact nodes; `None` if that does not tell how it deforms.
fn condensed(
    bodies: [&Body; 2],
    host: &Host<'_>,
    conditions: Option<&Conditions>,
    condense: Condense<'_>,
) -> Result<Option<Condensed>, ContactError> {
    let (Some(material), Some(conditions)) = (&bodies[host.which].material, conditions) else {
        return Ok(None);
    };
    condense(
        host.finite,
        material,
        &Job { surface: &host.surface, conditions, told: Told::default() },
    )
    .map(Some)
    .map_err(|cause| ContactError::Singular { body: host.which, cause })
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
fn touch(pairs: &mut Pairs, host: &Host<'_>) {
    const FACING: f64 = 0.1;
    let closing: Vec<f64> = (0..pairs.gap.len()).map(|pair| host.closing(pair)).collect();
    let apart = pairs.gap.iter().zip(&closing).filter(|(_, closing)| **closing > FACING);
    let least = apart.map(|(gap, closing)| gap / closing).fold(f64::INFINITY, f64::min);
    if least.is_finite() {
        pairs.gap.iter_mut().zip(&closing).for_each(|(gap, closing)| *gap -= least * closing);
    }
}
