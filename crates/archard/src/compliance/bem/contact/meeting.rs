//! Two bodies opposite each other: all that their contact needs but how they deform.

use std::sync::Arc;

use faer::Mat;
use glam::DVec3;

use super::super::solid::CondensedBody;
use super::super::{Conditions, Indeterminacy, Listener, Surface};
use super::STEEP;
use super::host::Host;
use super::near::Near;
use super::transfer::Transfer;
use super::{Condense, Contact, ContactError, Job, half_space, supported};
use crate::body::{Body, Elasticity, Finite, Interpolation};
use crate::compliance::fem::{Carrier, Inside, OnNodes, Superelement, Unfit};
use crate::compliance::{Compliance, Dense, MeshCompliance};
use crate::frame::{ContactFrame, OffTheSurface, Pairs, VectorField};
use crate::numerics::SAME;

/// Two bodies, one of them meshed at least, and the pairs where they may touch.
pub struct BodiesInContact<'a> {
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
    /// The pairs on the nodes inside it; of a body of finite elements.
    bearing: Option<Vec<OnNodes>>,
    /// The matrix that says how these nodes give way; of a body that has one.
    reduced: Option<Superelement>,
}

impl<'a> BodiesInContact<'a> {
    /// Brings two bodies opposite each other.
    ///
    /// # Errors
    /// If they cannot touch, are not held or profiles end within the zone.
    pub fn of(bodies: [&'a Body; 2]) -> Result<Self, ContactError> {
        if let Some(body) = bodies.iter().position(|body| body.has_image()) {
            return Err(ContactError::HasImage { body });
        }
        let first = bears_the_pairs(bodies);
        if !bodies.iter().all(|body| body.carries()) {
            return Self::on(bodies, first, first);
        }
        // A zone that reaches beyond the other leaves the pairs to it.
        let coarser = coarser(bodies, first);
        Self::on(bodies, coarser, first).or_else(|error| match error {
            ContactError::NotOpposite { .. } => {
                Self::on(bodies, 1 - coarser, first).map_err(|_| error)
            }
            _ => Err(error),
        })
    }

    /// With the pairs at the nodes of a body, in axes by the zone of the same or of the other.
    fn on(bodies: [&'a Body; 2], which: usize, axes: usize) -> Result<Self, ContactError> {
        let by_other = (axes != which).then(|| Host::new(bodies[axes], axes, None)).flatten();
        let host = Side::new(bodies[which], which, by_other.map(|other| other.axes))?;
        let mut pairs = host.host.pairs();
        let opposite = match &bodies[1 - which].finite {
            None => None,
            Some(_) => {
                // Files have the same axes.
                let placed = host.host.finite.meshed.placed.then_some(host.host.axes);
                let mut opposite = Side::new(bodies[1 - which], 1 - which, placed)?;
                if opposite.host.surface.mirrored != host.host.surface.mirrored {
                    return Err(ContactError::Symmetry);
                }
                if opposite.host.looks() * host.host.looks() > SAME {
                    return Err(ContactError::SameWay { body: 1 });
                }
                let transfer = Transfer::new(&host.host, &opposite.host)?;
                for (gap, distance) in pairs.gap.iter_mut().zip(&transfer.gap) {
                    *gap += distance;
                }
                opposite.bearing = transfer.bearing();
                Some((opposite, transfer))
            }
        };
        add_profiles(bodies, &host.host, &mut pairs)?;
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
        Some((side.job()?, acting))
    }

    /// The inside of a body that bears the pairs on its own elements, under tractions (Pa) of the pairs on body 1, with its surface;
    /// `None` if it does not.
    ///
    /// # Errors
    /// If its equations have no solution.
    pub fn inside(
        &self,
        which: usize,
        tractions: &VectorField,
    ) -> Result<Option<(&Surface, Inside)>, ContactError> {
        let side = match &self.opposite {
            Some((side, _)) if side.host.which == which => side,
            _ => &self.host,
        };
        if side.host.which != which {
            return Ok(None);
        }
        let Some(carrier) = side.carrier(self.bodies)? else { return Ok(None) };
        let sign = if which == 1 { -1.0 } else { 1.0 };
        let of_pair = |pair: usize| tractions.components().map(|along| sign * along[pair]);
        let acting: Vec<f64> = (0..self.pairs.gap.len()).flat_map(of_pair).collect();
        Ok(Some((&side.host.surface, carrier.inside(&acting))))
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
        let Self { bodies, host: side, opposite, mut pairs } = self;
        let host = &side.host;
        let sign = if host.first { 1.0 } else { -1.0 };
        let (mut parts, mut balance, mut carriers) = (vec![], vec![], vec![]);
        let mut near = vec![];
        // Gap by what the loads elsewhere displace: body 2 less body 1 along n.
        let mut part = |free: &[f64], sign: f64| {
            pairs.gap.iter_mut().zip(free).for_each(|(gap, free)| *gap += sign * free);
        };
        let normal = |free: Vec<f64>| -> Vec<f64> { free.into_iter().skip(2).step_by(3).collect() };
        if let Some(own) = side.carrier(bodies)? {
            part(&normal(own.free()), -sign);
            carriers.push(own);
        } else if let Some((own, off)) = side.reduced(bodies, host)? {
            parts.push(own);
            near.push(off);
        } else if let Some(own) = side.condensed(bodies, condense)? {
            part(&normal(own.free), -sign);
            parts.push(own.compliance);
            balance.push((host.which, own.balance));
        }
        if let Some((side, transfer)) = opposite {
            let other = &side.host;
            if let Some(own) = side.carrier(bodies)? {
                // It sees the pairs themselves.
                part(&normal(own.free()), sign);
                carriers.push(own);
            } else if let Some((own, off)) = side.reduced(bodies, host)? {
                parts.push(own);
                near.push(off);
            } else if let Some(own) = side.condensed(bodies, condense)? {
                part(&transfer.displacements(&own.free), sign);
                // What is near is done at the pairs themselves, what is left is smooth.
                if let Some(material) = &bodies[other.which].material {
                    let near = half_space::on_the_surface(other, material, other.which);
                    let left = transfer.compliance(&(own.compliance - near));
                    balance.push((other.which, own.balance));
                    parts.extend([left, half_space::on_the_surface(host, material, other.which)]);
                }
            }
        }
        for (which, body) in bodies.into_iter().enumerate() {
            if let (true, Some(material)) = (is_half_space(body), &body.material) {
                parts.push(half_space::compliance(host, material, which));
            }
        }
        touch(&mut pairs, host);
        let frame = ContactFrame::described(pairs)?;
        let compliance: Arc<dyn Compliance> = if carriers.is_empty() {
            let parts: Vec<_> = parts.iter().map(Mat::as_ref).collect();
            Arc::new(Dense::new(&parts)?.balanced(balance).judged(near))
        } else {
            Arc::new(MeshCompliance::new(&frame, carriers, (parts, balance)).judged(near))
        };
        Ok(Contact { frame, compliance })
    }
}

impl<'a> Side<'a> {
    fn new(body: &'a Body, which: usize, axes: Option<[DVec3; 3]>) -> Result<Self, ContactError> {
        let (Some(finite), Some(host)) = (&body.finite, Host::new(body, which, axes)) else {
            return Err(ContactError::NoZone { body: which });
        };
        if finite.elasticity == Elasticity::HalfSpace || body.material.is_none() {
            let closing = (0..host.contact.len()).map(|pair| host.closing(pair));
            let steepest = closing.fold(1.0, f64::min).clamp(-1.0, 1.0);
            let angle = steepest.acos().to_degrees();
            if steepest < STEEP && body.material.is_some() {
                return Err(ContactError::Steep { body: which, angle });
            }
            return Ok(Self { host, conditions: None, bearing: None, reduced: None });
        }
        if finite.elasticity == Elasticity::Reduced {
            let reduced = superelement(body, finite, which)?;
            let bearing = host.bearing();
            return Ok(Self { host, conditions: None, bearing, reduced: Some(reduced) });
        }
        if finite.elasticity == Elasticity::FiniteElements {
            // Nodes inside are held on several surfaces at once, as elements of their own are.
            let surface =
                Surface::new(&finite.meshed.mesh, Interpolation::Discontinuous, finite.mirrored);
            Conditions::new(&surface, |node| supported(finite, node), &[])
                .map_err(|cause| ContactError::Undetermined { body: which, cause })?;
            let bearing = host.bearing().ok_or(ContactError::Hollow { body: which })?;
            let conditions = Some(Conditions::of_contact(&host.surface, &host.contact));
            return Ok(Self { host, conditions, bearing: Some(bearing), reduced: None });
        }
        let conditions =
            Conditions::new(&host.surface, |node| supported(finite, node), &host.contact)
                .map_err(|cause| ContactError::Undetermined { body: which, cause })?;
        Ok(Self { host, conditions: Some(conditions), bearing: None, reduced: None })
    }

    /// Its equations; `None` if they do not tell how it deforms.
    fn job(&self) -> Option<Job<'_>> {
        let (surface, conditions) = (&self.host.surface, self.conditions.as_ref()?);
        Some(Job { surface, conditions, told: Listener::default() })
    }

    /// The body with the pairs that it bears on its own elements, if it does.
    fn carrier(&self, bodies: [&Body; 2]) -> Result<Option<Carrier>, ContactError> {
        let (which, finite) = (self.host.which, self.host.finite);
        let (Some(pairs), Some(volume), Some(material), None) =
            (&self.bearing, &finite.meshed.volume, &bodies[which].material, &self.reduced)
        else {
            return Ok(None);
        };
        Carrier::new((finite, volume), material, pairs.clone())
            .map(Some)
            .map_err(|cause| ContactError::Singular { body: which, cause })
    }

    /// The compliance of a body by its matrix, at the pairs of a host, and how far that is off; `None` of one without.
    fn reduced(
        &self,
        bodies: [&Body; 2],
        host: &Host<'_>,
    ) -> Result<Option<(Mat<f64>, Near)>, ContactError> {
        let which = self.host.which;
        let (Some(reduced), Some(pairs), Some(material)) =
            (&self.reduced, &self.bearing, &bodies[which].material)
        else {
            return Ok(None);
        };
        let compliance = reduced.compliance(pairs);
        let compliance =
            compliance.map_err(|cause| ContactError::Singular { body: which, cause })?;
        let near = Near::new(host, material, &compliance);
        Ok(Some((compliance, near)))
    }

    /// The body condensed to its contact nodes; `None` if that does not tell how it deforms.
    fn condensed(
        &self,
        bodies: [&Body; 2],
        condense: Condense<'_>,
    ) -> Result<Option<CondensedBody>, ContactError> {
        let which = self.host.which;
        let (Some(material), Some(job), None) =
            (&bodies[which].material, self.job(), &self.bearing)
        else {
            return Ok(None);
        };
        condense(self.host.finite, material, &job)
            .map(Some)
            .map_err(|cause| ContactError::Singular { body: which, cause })
    }
}

/// The matrix of a body at its nodes.
fn superelement(body: &Body, finite: &Finite, which: usize) -> Result<Superelement, ContactError> {
    let (Some(volume), Some(reduced), Some(material)) =
        (&finite.meshed.volume, &finite.meshed.reduced, &body.material)
    else {
        let message = "there is no matrix of it".to_owned();
        return Err(ContactError::Matrix { body: which, message });
    };
    Superelement::new((finite, volume), reduced, material).map_err(|unfit| match unfit {
        Unfit::Wrong(message) => ContactError::Matrix { body: which, message },
        Unfit::Free(modes) => {
            ContactError::Undetermined { body: which, cause: Indeterminacy::Free { modes } }
        }
    })
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

/// Of two bodies of finite elements the one whose zone has the larger elements, unless the zone of the other is plane: pressures that
/// vary from node to node where the displacements of the other do not follow find what its elements leave out, and alternate.
fn coarser(bodies: [&Body; 2], plane: usize) -> usize {
    let area = |body: &Body| {
        let meshed = &body.finite.as_ref()?.meshed;
        let of_face = |face: &usize| DVec3::from(meshed.mesh.area_vector(*face)).length();
        let areas = meshed.zone.faces.iter().map(of_face);
        (!meshed.has_plane_zone()).then(|| areas.sum::<f64>() / meshed.zone.faces.len() as f64)
    };
    match bodies.map(area) {
        [Some(one), Some(other)] => usize::from(other > one),
        _ => plane,
    }
}

/// Whether a body deforms as a half-space.
fn is_half_space(body: &Body) -> bool {
    body.finite.as_ref().is_none_or(|finite| finite.elasticity == Elasticity::HalfSpace)
}

/// Adds the recesses of the profiles, along the normal of each pair.
fn add_profiles(
    bodies: [&Body; 2],
    host: &Host<'_>,
    pairs: &mut Pairs,
) -> Result<(), OffTheSurface> {
    for (body, profile) in bodies.map(|body| &body.profile).into_iter().enumerate() {
        let recess = |place: DVec3| {
            let recess = profile.recess(place.x, place.y);
            let known = recess.is_finite().then_some(recess);
            known.ok_or(OffTheSurface { body, place: [place.x, place.y] })
        };
        let recesses = host.closed(recess)?;
        pairs.gap.iter_mut().zip(recesses).for_each(|(gap, recess)| *gap += recess);
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
