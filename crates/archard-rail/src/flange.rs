//! The dimensions of a flange that decide whether a wheel may run (EN 15313).

use crate::curve::Curve;
use crate::roots;

/// How far (m) beyond the datum on the tread the thickness is measured, towards the tip.
const LEVEL: f64 = 10e-3;
/// How far (m) before the tip the gradient begins.
const BEFORE_TIP: f64 = 2e-3;
/// Distance (m) between the places at which a profile is looked at.
const STEP: f64 = 1e-4;

/// Thickness Sd (m) that no flange exceeds (EN 15313; the same in national rules of operation, as Austria's EisbBBV, annex 2).
pub const THICKEST: f64 = 33e-3;

/// The tip of the flange (y and z, m), the lowest point of a wheel; `None` where the profile ends there and has no flange.
pub fn tip(wheel: &Curve) -> Option<[f64; 2]> {
    let places = wheel.nodes();
    let z = |at: &usize| wheel.point(places[*at])[1];
    let lowest = (0..places.len()).max_by(|one, other| z(one).total_cmp(&z(other)))?;
    (lowest > 0 && lowest + 1 < places.len()).then(|| wheel.point(places[lowest]))
}

/// The dimensions of the flange of a wheel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flange {
    /// Height Sh (m): from the tread at the datum, y = 0, to the tip.
    pub height: f64,
    /// Thickness Sd (m): from the back to the face of the flange, 10 mm beyond the tread at the datum.
    pub thickness: f64,
    /// Gradient qR (m): along the axle, from 2 mm before the tip to where the thickness is measured.
    pub gradient: f64,
}

impl Flange {
    /// Of the profile of a wheel whose back lies at that y (m); `None` where it has no flange, or no tread.
    pub fn of(wheel: &Curve, back: f64) -> Option<Self> {
        let places = wheel.samples(STEP);
        let y = |along: f64| wheel.point(along)[0];
        let z = |along: f64| wheel.point(along)[1];
        // y falls from the tread to the flange.
        let tread = places.windows(2).find(|pair| y(pair[0]) >= 0.0 && y(pair[1]) < 0.0)?;
        let tread = roots::zero(tread[0], tread[1], y);
        let flange: Vec<f64> = places.into_iter().filter(|&along| along > tread).collect();
        let lowest = (1..flange.len().checked_sub(1)?)
            .max_by(|&a, &b| z(flange[a]).total_cmp(&z(flange[b])))?;
        let tip = roots::least(flange[lowest - 1], flange[lowest + 1], |along| -z(along));
        // Where the face of the flange passes a level, first from the tread.
        let face = |level: f64| {
            let passes = |pair: &&[f64]| z(pair[0]) < level && z(pair[1]) >= level;
            let pair = flange.windows(2).find(passes).filter(|pair| pair[0] < tip)?;
            Some(y(roots::zero(pair[0], pair[1], |along| z(along) - level)))
        };
        let thick = face(z(tread) + LEVEL)?;
        Some(Self {
            height: z(tip) - z(tread),
            thickness: thick - back,
            gradient: thick - face(z(tip) - BEFORE_TIP)?,
        })
    }
}
