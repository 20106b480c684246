//! A line of contact of Hertz's, and what it wears off a place that it passes.

use std::f64::consts::PI;

use archard::friction::Friction;
use archard::problem::rubbing;
use archard::wear::{Per, WearLaw};

/// Half-width (m) and peak pressure (Pa) of a line under a load (N/m), between bodies of a relative curvature (1/m) and a contact modulus
/// (Pa), E* of Hertz.
pub(crate) fn hertz(load: f64, curvature: f64, modulus: f64) -> [f64; 2] {
    let half_width = (4.0 * load / (PI * modulus * curvature)).sqrt();
    [half_width, if load > 0.0 { 2.0 * load / (PI * half_width) } else { 0.0 }]
}

/// Depth (m) by a law of a place that has lost so much (m) before, in parts of pressure (Pa) and slip (m) along a direction of that sign.
/// Laws that take a cycle at once take the mean pressure over the slip, and all of it.
pub(crate) fn worn(
    (law, friction): (&dyn WearLaw, Option<&dyn Friction>),
    sign: f64,
    whole: [f64; 2],
    parts: impl Iterator<Item = [f64; 2]>,
    before: f64,
) -> f64 {
    let depth = |[pressure, slip]: [f64; 2]| {
        law.depth(rubbing(friction, pressure, slip, [sign, 0.0]).after(0.0, before))
    };
    match law.per() {
        Per::Cycle => depth(whole),
        Per::Increment => parts.map(depth).sum(),
    }
}
