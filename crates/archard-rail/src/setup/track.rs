//! How a rail is laid.

use glam::{DMat3, DVec3};

use crate::bounds;
use crate::curve::Curve;
use archard::parameters::Invalid;

/// How a rail is laid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Track {
    /// Distance (m) between the inner faces of both rails.
    pub gauge: f64,
    /// Depth (m) below the top of the rail down to which the inner face counts.
    pub gauge_height: f64,
    /// Inclination (rad) of the rail towards the middle of the track.
    pub cant: f64,
}

impl Track {
    /// Standard gauge: 1435 mm, taken 14 mm below the top, rails inclined by 1:40.
    pub fn standard() -> Self {
        Self { gauge: 1.435, gauge_height: 14e-3, cant: 40f64.recip().atan() }
    }

    /// Where the rail stands in the track: inclined, its top at z = 0, its innermost point down to the gauge height at half
    /// the gauge.
    ///
    /// # Errors
    /// If a length is not greater than zero, or the cant not below a right angle.
    pub fn place(&self, rail: &Curve) -> Result<RailPlacement, Invalid> {
        let half = bounds::positive("gauge", self.gauge)? / 2.0;
        let depth = bounds::positive("gauge_height", self.gauge_height)?;
        let angle = -bounds::within("cant", self.cant, std::f64::consts::FRAC_PI_2)?;
        super::short("rail", rail)?;
        let turned = rail.clone().moved(angle, [0.0; 2]);
        let places = turned.samples(2e-5);
        let top = least(&turned, &places, |point| point[1]);
        let inner =
            least(
                &turned,
                &places,
                |point| {
                    if point[1] <= top + depth { point[0] } else { f64::INFINITY }
                },
            );
        Ok(RailPlacement { angle, origin: [half - inner, -top] })
    }
}

/// Where the profile of a rail stands in the track.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RailPlacement {
    /// The turn (rad) of the profile about x, from y towards z: minus the cant.
    pub angle: f64,
    /// y and z (m) of the origin of the profile in the track.
    pub origin: [f64; 2],
}

impl RailPlacement {
    /// The rail in the track.
    pub fn curve(&self, rail: &Curve) -> Curve {
        rail.clone().moved(self.angle, self.origin)
    }

    /// The profile of a rail in the track.
    pub fn own(&self, rail: &Curve) -> Curve {
        let [y, z] = self.origin;
        rail.clone().moved(0.0, [-y, -z]).moved(-self.angle, [0.0; 2])
    }

    /// A point of the track (m) as the profile has it: x forward, y and z as in its points.
    pub fn in_rail(&self, point: DVec3) -> DVec3 {
        let [y, z] = self.origin;
        DMat3::from_rotation_x(-self.angle) * (point - DVec3::new(0.0, y, z))
    }
}

/// The least value of a function of the points of the curve, between the places too.
fn least(curve: &Curve, places: &[f64], value: impl Fn([f64; 2]) -> f64) -> f64 {
    let at = |along: f64| value(curve.point(along));
    let best = (0..places.len()).min_by(|&a, &b| at(places[a]).total_cmp(&at(places[b])));
    let best = best.unwrap_or(0);
    let (left, right) = (best.saturating_sub(1), (best + 1).min(places.len() - 1));
    let found = crate::roots::least(places[left], places[right], at);
    at(found).min(at(places[best]))
}
