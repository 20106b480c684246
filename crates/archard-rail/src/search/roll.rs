//! The roll of a wheelset that stands on both rails.

use super::Search;
use crate::roots;
use crate::setup::{Attitude, Setup, Side};
use archard::parameters::Invalid;

/// Roll (rad) up to which it is looked for: the wheels of a standard gauge differ in height by 150 mm then.
const MOST: f64 = 0.1;
/// Difference of rolls (rad) that counts for nothing: a wheel goes down by less than a nanometre with it.
pub(crate) const SETTLED: f64 = 1e-9;

impl Setup {
    /// The roll (rad) at which both wheels begin to touch their rails at one height, for a shift (m) and a yaw (rad) of the
    /// wheelset: this wheel on the right, and the other as the mirror shows it.
    ///
    /// # Errors
    /// If the shift or the yaw is out of its bounds, a wheel is nowhere over its rail, or there is no such roll within 0.1 rad.
    pub fn roll(&self, left: &Self, shift: f64, yaw: f64) -> Result<f64, Invalid> {
        Attitude { shift, roll: 0.0, yaw }.checked()?;
        // Greater if the right wheel hangs over its rail while the left one stands.
        let difference = |roll: f64| {
            let onset = |side: Side| {
                let attitude = side.attitude(Attitude { shift, roll, yaw });
                let setup = if side == Side::Right { self } else { left };
                Search::first_touch(setup, attitude).ok()?.map(|onset| onset.height)
            };
            let [right, left] = [Side::Right, Side::Left].map(onset);
            right.zip(left).map_or(f64::NAN, |(right, left)| right - left)
        };
        let level = difference(0.0);
        if level.is_nan() {
            return Err(Invalid::new("shift", "a wheel does not stand over its rail"));
        }
        if level == 0.0 {
            return Ok(0.0);
        }
        // The right wheel goes down with a positive roll, and the left one up, nearly by their arms: from twice as far as that
        // says on, and farther, until they change places.
        let (mut near, mut far) = (0.0, level / self.wheelset().arm());
        while f64::abs(near) < MOST {
            far = far.clamp(-MOST, MOST);
            if difference(far) * level <= 0.0 {
                return Ok(roots::zero_within(near, far, SETTLED, difference));
            }
            (near, far) = (far, 2.0 * far);
        }
        Err(Invalid::new("roll", "no roll makes both wheels stand on their rails: give it"))
    }
}
