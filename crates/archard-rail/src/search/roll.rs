//! The roll of a wheelset that stands on both rails.

use super::Search;
use crate::roots;
use crate::setup::{Attitude, Setup, Side};
use archard::parameters::Invalid;

/// Roll (rad) up to which it is looked for: the wheels of a standard gauge differ in height by 150 mm then.
const MOST: f64 = 0.1;
/// Intervals in which a change of sign is looked for, from no roll outwards, each twice as long as the one before.
const INTERVALS: i32 = 12;

impl Setup {
    /// The roll (rad) at which both wheels begin to touch their rails at one height, for a shift (m) and a yaw (rad) of the
    /// wheelset; alike wheels on alike rails.
    ///
    /// # Errors
    /// If the shift or the yaw is out of its bounds, a wheel is nowhere over its rail, or there is no such roll within 0.1 rad.
    pub fn roll(&self, shift: f64, yaw: f64) -> Result<f64, Invalid> {
        Attitude { shift, roll: 0.0, yaw }.checked()?;
        // Greater if the right wheel hangs over its rail while the left one stands.
        let difference = |roll: f64| {
            let onset = |side: Side| {
                let attitude = side.attitude(Attitude { shift, roll, yaw });
                Search::new(self, attitude).ok()?.onset().map(|onset| onset.height)
            };
            let [right, left] = [Side::Right, Side::Left].map(onset);
            right.zip(left).map_or(f64::NAN, |(right, left)| right - left)
        };
        let level = difference(0.0);
        if level.is_nan() {
            return Err(Invalid::new("shift", "a wheel does not stand over its rail"));
        }
        // The right wheel goes down with a positive roll.
        let mut near = 0.0;
        for interval in 0..=INTERVALS {
            let far = level.signum() * MOST * 0.5f64.powi(INTERVALS - interval);
            if difference(far) * level <= 0.0 {
                return Ok(roots::zero(near, far, difference));
            }
            near = far;
        }
        Err(Invalid::new("roll", "no roll makes both wheels stand on their rails: give it"))
    }
}
