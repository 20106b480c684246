//! Which stretches of overlap are one patch.

use std::f64::consts::FRAC_PI_2;

use crate::invalid::Invalid;

/// When two stretches of overlap are one patch.
///
/// Stretches nearer than `joined_below` become one patch. From there to `apart_beyond` each keeps a patch of its own; its
/// place and its angle count the neighbour with a share that falls from 1 to 0, so that they do not jump where two
/// patches part. Stretches whose angles differ by more than `angle` never join.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Joining {
    /// Distance (m) from edge to edge up to which two stretches are one.
    pub joined_below: f64,
    /// Distance (m) from edge to edge beyond which neither knows of the other.
    pub apart_beyond: f64,
    /// Difference (rad) of the contact angles up to which stretches join.
    pub angle: f64,
}

impl Default for Joining {
    /// Joined below 4 mm, apart beyond 8 mm, up to a right angle.
    fn default() -> Self {
        Self { joined_below: 4e-3, apart_beyond: 8e-3, angle: FRAC_PI_2 }
    }
}

impl Joining {
    /// The same, checked.
    ///
    /// # Errors
    /// If a value is negative or not finite, or if `apart_beyond` is less than `joined_below`.
    pub fn checked(self) -> Result<Self, Invalid> {
        let least = [
            ("joined_below", self.joined_below, 0.0),
            ("apart_beyond", self.apart_beyond, self.joined_below),
            ("angle", self.angle, 0.0),
        ];
        for (parameter, value, least) in least {
            if Invalid::finite(parameter, value)? < least {
                let message = format!("{value} has to be {least} or more");
                return Err(Invalid::new(parameter, message));
            }
        }
        Ok(self)
    }

    /// How much a stretch at that distance (m) counts: from 1 where stretches join to 0 where they are apart.
    pub(super) fn share(&self, distance: f64) -> f64 {
        let range = self.apart_beyond - self.joined_below;
        if range > 0.0 { ((self.apart_beyond - distance) / range).clamp(0.0, 1.0) } else { 0.0 }
    }
}
