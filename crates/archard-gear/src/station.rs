//! A place of the path of contact, and what happens there.

use std::f64::consts::PI;

use archard::friction::Friction;
use archard::wear::WearLaw;

use crate::involute::Pair;
use crate::line::{hertz, worn};

/// Points across the contact at which a wear law is asked. A choice: sums over angles are exact for depths in proportion to the pressure,
/// and converge fast for all that are smooth.
const POINTS: usize = 32;

/// A place of the path, and what a pair of teeth goes through there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Station {
    /// Distance (m) from T1 along the path.
    pub place: f64,
    /// Radii of curvature (m) of both flanks.
    pub radii: [f64; 2],
    /// Speeds of the contact over both flanks (m), over the angular speed of gear 1.
    pub speeds: [f64; 2],
    /// Load (N/m) of this pair of teeth over the width.
    pub load: f64,
    /// Half-width (m) of the contact.
    pub half_width: f64,
    /// Peak pressure (Pa).
    pub peak_pressure: f64,
}

impl Station {
    /// A place (m) under a load (N/m), between flanks of that contact modulus (Pa), E* of Hertz.
    pub fn new(pair: &Pair, place: f64, load: f64, modulus: f64) -> Self {
        let radii = pair.radii(place);
        let curvature = pair.length / (radii[0] * radii[1]);
        let [half_width, peak_pressure] = hertz(load, curvature, modulus);
        Self { place, radii, speeds: pair.speeds(place), load, half_width, peak_pressure }
    }

    /// By how much faster (m) the contact moves over flank 1 than over flank 2, over the angular speed of gear 1: how fast flank 1 slides on
    /// the other.
    pub fn sliding(&self) -> f64 {
        self.speeds[0] - self.speeds[1]
    }

    /// Distance (m) that a point of a flank slides while the contact passes it.
    pub fn slide(&self, flank: usize) -> f64 {
        2.0 * self.half_width * self.sliding().abs() / self.speeds[flank]
    }

    /// Depth (m) that a flank loses a mesh, which has lost so much (m) before, by its law.
    pub fn wear(
        &self,
        flank: usize,
        law: (&dyn WearLaw, Option<&dyn Friction>),
        before: f64,
    ) -> f64 {
        let slide = self.slide(flank);
        // The mean over the slip.
        let whole = [0.25 * PI * self.peak_pressure, slide];
        let step = PI / POINTS as f64;
        let at = |point: usize| {
            let high = (step * (point as f64 + 0.5)).sin();
            [self.peak_pressure * high, 0.5 * slide * high * step]
        };
        worn(law, self.sliding().signum(), whole, (0..POINTS).map(at), before)
    }
}
