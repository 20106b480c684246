//! The roll of a wheelset that is carried by both rails.

use super::{Bodies, ContactError, Operation, Resolution, contact};
use crate::search::SETTLED;
use crate::setup::{Attitude, Setup, Side};

/// Secants in which it is.
const MOST: usize = 12;

/// The roll (rad) at which both wheels carry the load of the operation at one height of the wheelset, for equal wheels on
/// equal rails; the operation is that of the right side, and its own roll does not count.
///
/// # Errors
/// As [`contact`], and if there is no such roll near that at which both wheels begin to touch.
pub fn roll(
    setup: &Setup,
    bodies: &Bodies,
    operation: &Operation,
    resolution: &Resolution,
) -> Result<f64, ContactError> {
    let Attitude { shift, yaw, .. } = operation.attitude;
    let difference = |roll: f64| {
        let height = |side: Side| {
            let rolled = Operation { attitude: Attitude { shift, roll, yaw }, ..*operation };
            let patches = contact(setup, bodies, &rolled.of_side(side), resolution)?;
            patches.first().map(|patch| patch.values.z_wheel).ok_or(ContactError::NoContact)
        };
        Ok::<f64, ContactError>(height(Side::Right)? - height(Side::Left)?)
    };
    let mut before = setup.roll(setup, shift, yaw)?;
    let mut off = difference(before)?;
    // The right wheel goes down with the roll by its arm, the left one up.
    let mut now = before + 0.5 * off / setup.wheelset().arm();
    for _ in 0..MOST {
        let next = difference(now)?;
        if next == off || (now - before).abs() <= SETTLED {
            return Ok(now);
        }
        let step = -next * (now - before) / (next - off);
        (before, off, now) = (now, next, now + step);
    }
    Err(ContactError::NoRoll)
}
