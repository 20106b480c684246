//! How the error of a case behaves in the size of its elements, by its bodies, its motion and its laws.

use crate::body::Body;
use crate::case::check::Parts;
use crate::case::definition::{BuildError, Case, FrameCase};
use crate::friction::Friction;
use crate::motion::Motion;
use crate::problem::{GROWS, steepness};
use crate::simulation::history::{BODY_DEPTH, WEAR_DEPTH, of_body};
use crate::simulation::{Kind, Tip};

/// Elements over which a tip has to be worn before it counts as blunt.
const BLUNT: f64 = 2.0;
/// The pressure (Pa) at which friction is taken to be what it is in the contact.
const PRESSURE: f64 = 1e8;
/// How many times the peak pressure is divided by the root of two to find where friction is bounded.
const SHARES: u32 = 20;
/// How far a tip may lie from the middle of the frame, relative to an element, to lie alike among the elements of other grids.
const ALIKE: f64 = 0.01;

/// What says how errors follow from differences between grids, for a case on its elements.
pub(super) fn kind(case: &Case) -> Result<Kind, BuildError> {
    let parts = Parts::of(case)?;
    let (friction, speed) = (parts.friction.as_deref(), parts.motion.speed().unwrap_or_default());
    let laws = parts.bodies.iter().filter_map(|body| body.wear.as_deref());
    let peak = parts.subject().contact(parts.schedule.control).map(|contact| contact.peak_pressure);
    let powers = laws.map(|law| steepness(law, (friction, speed), peak));
    let grip = friction.map_or(0.0, |law| law.limit(PRESSURE) / PRESSURE);
    Ok(Kind {
        order: order(&parts),
        tip: tip(&parts, &case.frame),
        areas: areas(case),
        slips_partly: slips_partly(&parts),
        steepness: powers
            .fold([1.0; 2], |[least, most], [low, high]| [least.min(low), most.max(high)]),
        passes: parts.motion.passing().is_some() || parts.motion.swing().is_some(),
        coupled: parts.subject().dundurs_beta().abs().min(0.5 * grip),
        grows: friction.map_or(f64::INFINITY, |law| grows(law, peak.unwrap_or(PRESSURE))),
        line: case.frame.line,
        period: parts.motion.period(),
    })
}

/// The pressure, relative to a peak (Pa), up to which the limit of friction grows as from an edge on: at twice the distance, under
/// the root of two of the pressure, it is larger by the ratio that [ties](GROWS) ask for.
fn grows(law: &dyn Friction, peak: f64) -> f64 {
    let mut shares = (0..=SHARES).rev().map(|times| 0.5f64.powf(0.5 * f64::from(times)));
    let bounded = |share: &f64| {
        let [first, next] = [1.0, 2f64.sqrt()].map(|farther| law.limit(farther * share * peak));
        first > GROWS * next
    };
    shares.find(bounded).unwrap_or(f64::INFINITY)
}

/// From where on elements have which area (m^2).
fn areas(case: &Case) -> Vec<[f64; 2]> {
    let places = [0.0].into_iter().chain(case.doubles.iter().copied());
    let area = |doubled| case.frame_after(doubled).spacing().iter().product();
    places.enumerate().map(|(doubled, from)| [from, area(doubled)]).collect()
}

/// The order of the error.
pub(super) fn order(parts: &Parts<'_>) -> f64 {
    let has_edge = parts.bodies.iter().any(|body| body.profile.sharpest() == 0.0);
    let frets = parts.motion.period().is_some() && parts.friction.is_some();
    if has_edge || frets { 1.0 } else { 2.0 }
}

/// Whether friction decides what slips.
pub(super) fn slips_partly(parts: &Parts<'_>) -> bool {
    parts.motion.slips_partly() && parts.friction.is_some()
}

/// Whether a body is sharp, but not along an edge: most happens at the middle of the contact, where elements must not miss it.
pub(super) fn has_tip(parts: &Parts<'_>) -> bool {
    let sharpest = parts.bodies.iter().map(|body| body.profile.sharpest());
    let sharpest = sharpest.fold(2.0, f64::min);
    sharpest > 0.0 && sharpest < 2.0
}

/// Where a body is sharp, on the elements of a frame.
fn tip(parts: &Parts<'_>, frame: &FrameCase) -> Option<Tip> {
    let [one, other] = &parts.bodies;
    let sharper = usize::from(other.profile.sharpest() < one.profile.sharpest());
    let Body { name, profile, .. } = &parts.bodies[sharper];
    let exponent = profile.sharpest();
    let stay = staying(&parts.motion, sharper);
    let wearing =
        parts.bodies.iter().zip(stay).filter(|(body, stays)| *stays && body.wear.is_some());
    let mut columns: Vec<_> = wearing.map(|(body, _)| of_body(BODY_DEPTH, &body.name)).collect();
    if !columns.is_empty() {
        columns.push(WEAR_DEPTH.to_owned());
    }
    let spacing = frame.spacing();
    let [x, y] = spacing.map(|size| BLUNT * size);
    (exponent < 2.0).then(|| Tip {
        exponent,
        stay: columns,
        depth: if stay == [true; 2] { WEAR_DEPTH.to_owned() } else { of_body(BODY_DEPTH, name) },
        centred: (0..2).all(|axis| frame.centre[axis].abs() <= ALIKE * spacing[axis]),
        blunt: if exponent > 0.0 { profile.recess(x, y) } else { 0.0 },
    })
}

/// Bodies of which one point stays in the middle of the contact: of surfaces that swing without a track it is the sharper one that
/// takes the contact along.
fn staying(motion: &Motion, sharper: usize) -> [bool; 2] {
    let track = motion.sliding().and_then(|sliding| sliding.track);
    match (track, motion.swing()) {
        (Some(track), _) => [0, 1].map(|body| body != track.body),
        (None, Some(_)) => [0, 1].map(|body| body == sharper),
        (None, None) => [motion.passing().is_none(); 2],
    }
}
