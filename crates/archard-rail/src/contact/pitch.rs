//! The rate of turning of a wheelset that is driven, or braked, or free.
//!
//! The contacts turn the wheelset about its axle by a . sum of (Q - C) x F, where a is the direction of the axle, C its middle, Q a
//! contact and F the force on the wheel there. A moment that drives holds the balance. The faster the wheelset turns the more
//! the contacts resist, until all of them slip.

use std::cell::{Cell, RefCell};

use glam::DVec3;

use super::{Bodies, ContactError, Loaded, Operation, Pressed, Resolution};
use crate::bounds;
use crate::roots;
use crate::setup::{Setup, Side, Velocity};

/// The first share by which the wheelset turns faster or slower than one that rolls on its nominal radius. The search goes on from any:
/// this is a usual creepage.
const FIRST: f64 = 1e-3;
/// Difference of these shares that counts for nothing: a creepage of 1e-3 has six digits then.
const SETTLED: f64 = 1e-9;

/// The rate (rad/s) at which both wheels resist a moment (N m) that drives the wheelset forward, or brakes it where it is negative. The
/// operation is that of the right side, and its own rate does not count.
///
/// # Errors
/// As [`contact`](super::contact()), and if friction does not bear the moment.
pub fn pitch(
    [right, left]: [&Setup; 2],
    bodies: &Bodies,
    operation: &Operation,
    resolution: &Resolution,
    moment: f64,
) -> Result<f64, ContactError> {
    let moment = bounds::finite("axle_moment", moment)?;
    let rolls = -operation.velocity.forward / right.wheelset().nominal_radius;
    let rate = |share: f64| rolls * (1.0 + share);
    // Wheels that turn at another rate stand nearly as high.
    let sunk = [Cell::new(None), Cell::new(None)];
    let resists = |share: f64| {
        let velocity = Velocity { pitch: rate(share), ..operation.velocity };
        let turning = Operation { velocity, ..*operation };
        let of = |(setup, side): (&Setup, Side)| {
            let own = turning.of_side(side);
            let loaded = Loaded::new(setup, bodies, &own, resolution)?;
            let before: &Cell<Option<f64>> = &sunk[usize::from(side == Side::Left)];
            let guess = before.get().unwrap_or_else(|| loaded.guess());
            let (down, patches) = loaded.on(resolution.elements, guess)?;
            before.set(Some(down));
            Ok::<f64, ContactError>(
                patches.iter().map(|patch| about_the_axle(&loaded, patch)).sum(),
            )
        };
        // A mirror keeps a moment about the axis across it.
        Ok::<f64, ContactError>(of((right, Side::Right))? + of((left, Side::Left))?)
    };
    let level = resists(0.0)? - moment;
    let (mut near, mut far) = (0.0, if level > 0.0 { -FIRST } else { FIRST });
    loop {
        let found = resists(far)? - moment;
        if found * level <= 0.0 {
            break;
        }
        // Twice as fast, or not at all: everything slips long before.
        if f64::abs(far) >= 1.0 {
            return Err(ContactError::Saturated { moment, most: found + moment });
        }
        (near, far) = (far, (4.0 * far).clamp(-1.0, 1.0));
    }
    let failed = RefCell::new(None);
    let share = roots::zero_within(near, far, SETTLED, |share| match resists(share) {
        Ok(found) => found - moment,
        Err(error) => {
            *failed.borrow_mut() = Some(error);
            f64::NAN
        }
    });
    failed.into_inner().map_or(Ok(rate(share)), Err)
}

/// The moment (N m) about its axle by which a patch turns the wheelset.
fn about_the_axle(loaded: &Loaded<'_>, pressed: &Pressed) -> f64 {
    let search = loaded.search();
    let (patch, attitude) = (&pressed.patch, search.attitude());
    let [x, s] = pressed.tangential;
    let on_the_wheel = -(patch.frame() * DVec3::new(x, s, pressed.normal));
    let arm = patch.reference - search.setup().centre(attitude, patch.height);
    (attitude.rotation() * DVec3::Y).dot(arm.cross(on_the_wheel))
}
