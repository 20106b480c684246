//! Heat of friction in bodies whose materials are known.

use super::Parts;
use crate::case::material::MaterialCase;
use archard::closed_form::flash_temperature::FAST;
use archard::estimate::Estimator;
use archard::problem::Heating;

/// Lets bodies conduct heat as their materials do where the case says nothing of it, friction makes some, and the flash temperature
/// of fast surfaces follows: nobody has asked for one that is doubtful.
pub(super) fn warm(parts: &mut Parts<'_>) {
    let given = parts.bodies.each_ref().map(|body| body.thermal);
    let known = parts.case.bodies.each_ref().map(|body| body.made_of(MaterialCase::thermal));
    let adds = (0..2).any(|body| given[body].is_none() && known[body].is_some());
    if parts.friction.is_none() || !adds {
        return;
    }
    for (body, (given, known)) in parts.bodies.iter_mut().zip(given.into_iter().zip(known)) {
        body.thermal = given.or(known);
    }
    let heating = Heating::of(&parts.bodies, &parts.motion).ok().filter(|_| is_fast(parts));
    for (place, (body, given)) in parts.bodies.iter_mut().zip(given).enumerate() {
        let warms = heating.is_some_and(|heating| heating.warms(place));
        body.thermal = body.thermal.filter(|_| warms).or(given);
    }
}

/// Whether the surfaces pass the contact fast enough.
fn is_fast(parts: &Parts<'_>) -> bool {
    let warmth = parts.estimate(&Estimator::default(), 0.0).warmth;
    warmth.is_some_and(|warmth| warmth.peclet >= FAST)
}
