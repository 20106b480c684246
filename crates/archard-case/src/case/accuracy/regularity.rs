//! How the error of a case behaves in the size of its elements, by its bodies, its motion and its laws.

use crate::case::check::Parts;
use crate::case::definition::{BuildError, Case};
use archard::body::Body;
use archard::estimate::Estimator;
use archard::motion::{Control, Drive, Shift, Slip};
use archard::simulation::Regularity;
use archard::simulation::history::{APPROACH, CREEPAGE, FORCE, LOAD};

/// What says how fast the quantities of a case converge.
pub(super) fn regularity(case: &Case) -> Result<Regularity, BuildError> {
    let parts = Parts::of(case)?;
    Ok(Regularity {
        sharpest: sharpest(&parts),
        centre: centre(&parts),
        may_stick: parts.motion.driven(0.0).is_some() && !slips(&parts),
        given: given(&parts),
        areas: areas(case),
        line: case.frame.line,
        period: parts.motion.increments().map(Shift::period),
    })
}

/// Whether surfaces that do not yield are smooth at the middle of the frame: given by formulas, and without a tip.
fn centre(parts: &Parts<'_>) -> bool {
    let measured = |body: &Body| body.profile.places().iter().any(|places| !places.is_empty());
    let regular = |body: &Body| body.hardness.is_none() && !measured(body);
    !has_tip(parts) && parts.bodies.iter().all(regular)
}

/// The columns of what is prescribed.
fn given(parts: &Parts<'_>) -> Vec<&'static str> {
    let normal = match parts.schedule.control {
        Control::Load(_) => LOAD,
        Control::Approach(_) => APPROACH,
    };
    let mut drives = parts.motion.driven(0.0).map_or(vec![], |drives| drives.both().to_vec());
    if parts.motion.direction.axis == 1 {
        drives.reverse();
    }
    let drives = drives.into_iter().enumerate();
    let driven = drives.map(|(axis, drive)| match drive {
        Drive::Force(_) => FORCE[axis],
        Drive::Slip(_) => CREEPAGE[axis],
    });
    [normal].into_iter().chain(driven).collect()
}

/// Whether cylinders slip all over by Carter's theory; worn, they slip no less.
fn slips(parts: &Parts<'_>) -> bool {
    let rolled = parts.estimate(&Estimator::default(), 0.0).rolled;
    rolled.is_some_and(|rolled| rolled.line && rolled.stick_share == Some(0.0))
}

/// From where on elements have which area (m^2).
fn areas(case: &Case) -> Vec<[f64; 2]> {
    let places = [0.0].into_iter().chain(case.doubles.iter().copied());
    let area = |doubled| case.frame_after(doubled).spacing().iter().product();
    places.enumerate().map(|(doubled, from)| [from, area(doubled)]).collect()
}

/// The order of the error by which elements are chosen and refined.
pub(super) fn order(parts: &Parts<'_>) -> f64 {
    if sharpest(parts) == 0.0 { 1.0 } else { 2.0 }
}

/// Whether friction decides what slips.
pub(super) fn slips_partly(parts: &Parts<'_>) -> bool {
    matches!(parts.motion.slip, Slip::Sought(_)) && parts.friction.is_some()
}

/// Whether a body is sharp, but not along an edge: most happens at the middle of the contact, where elements must not miss it.
pub(super) fn has_tip(parts: &Parts<'_>) -> bool {
    let sharpest = sharpest(parts);
    sharpest > 0.0 && sharpest < 2.0
}

/// The power of the distance by which the sharper body recedes from where it is sharpest.
fn sharpest(parts: &Parts<'_>) -> f64 {
    parts.bodies.iter().map(|body| body.profile.sharpest()).fold(2.0, f64::min)
}
