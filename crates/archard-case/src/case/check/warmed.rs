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
    for body in 0..2 {
        parts.bodies[body].thermal = given[body].or(known[body]);
    }
    let heating = Heating::of(&parts.bodies, &parts.motion).ok().filter(|_| is_fast(parts));
    for body in 0..2 {
        let warms = heating.is_some_and(|heating| heating.warms(body));
        parts.bodies[body].thermal = parts.bodies[body].thermal.filter(|_| warms).or(given[body]);
    }
}

/// Whether the surfaces pass the contact fast enough.
fn is_fast(parts: &Parts<'_>) -> bool {
    let warmth = parts.estimate(&Estimator::default(), 0.0).warmth;
    warmth.is_some_and(|warmth| warmth.peclet >= FAST)
}
