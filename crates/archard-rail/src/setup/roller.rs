//! A rail that is the rim of a roller, as on a test rig.
//!
//! The profile of the rail turns about an axis across the track, so far below the top of the rail as the roller is large: a point that
//! lies z below the top moves on a circle of radius R - z. The wheelset stays above the axis, and the roller turns as fast as its top
//! passes at the speed of the wheelset: seen from the wheelset a track of endless radius does the same.

use glam::DVec3;

use crate::bounds;
use archard::parameters::Invalid;

/// The radius of a rail: that of a roller at the top of its profile, or none of a straight one.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Roller(Option<f64>);

/// Where a profile turned about the axis has come to at some x.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct Turned {
    /// z (m) in the track.
    pub z: f64,
    /// How fast z grows with x.
    pub slope: f64,
    /// The turn (rad) about y, from the profile above the axis.
    pub turn: f64,
}

impl Roller {
    /// That of a roller of that radius (m) whose profile reaches down to that z (m).
    ///
    /// # Errors
    /// If the radius is not greater than zero, or the profile reaches to the axis.
    pub fn new(radius: f64, lowest: f64) -> Result<Self, Invalid> {
        let radius = bounds::positive("rail_radius", radius)?;
        if lowest < radius {
            return Ok(Self(Some(radius)));
        }
        Err(Invalid::new("rail_radius", "the profile of the roller reaches to its axis"))
    }

    /// The radius (m) of a roller at the top of its profile; `None` of a straight rail.
    pub fn radius(self) -> Option<f64> {
        self.0
    }

    /// 1 over the radius (1/m) of a roller at z (m) of its profile, 0 of a straight rail.
    pub fn curvature(self, z: f64) -> f64 {
        self.0.map_or(0.0, |radius| (radius - z).recip())
    }

    /// Where a point at z (m) of the profile lies at that x (m); `None` where its circle does not reach.
    pub(crate) fn at(self, z: f64, x: f64) -> Option<Turned> {
        let Some(radius) = self.0 else { return Some(Turned { z, slope: 0.0, turn: 0.0 }) };
        let own = radius - z;
        let above = (own * own - x * x).sqrt();
        // In this form large radii cost no digits.
        let lower = x * x / (own + above);
        (above > 0.0).then(|| Turned { z: z + lower, slope: x / above, turn: -(x / own).asin() })
    }

    /// The velocity (m/s) of its surface at a point of the track, seen from a wheelset of that speed (m/s) along it, and its rotation (rad/s).
    pub(crate) fn moves(self, point: DVec3, speed: f64) -> [DVec3; 2] {
        let Some(radius) = self.0 else { return [DVec3::X * -speed, DVec3::ZERO] };
        let rate = speed / radius;
        // The cross product of the rotation with the way from the axis, its large part by itself.
        let velocity = DVec3::new(rate * point.z - speed, 0.0, -rate * point.x);
        [velocity, DVec3::Y * rate]
    }
}
