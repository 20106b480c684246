//! The flash temperature of bodies that slide on a track, or that roll and slip all over.

use super::{Contact, Course, RollingEstimate, Subject};
use crate::closed_form::flash_temperature::{FAST, semi_ellipse, semi_ellipsoid};
use crate::problem::Heating;

/// What closed forms say of the warmth of the unworn contact.
#[non_exhaustive]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Warmth {
    /// Peclet number.
    pub peclet: f64,
    /// Largest and mean rise of the temperature of the surfaces over the contact (K), below Hertz's pressures; `None` where a
    /// part sticks, or the [Peclet number](FAST) is small.
    pub rise: Option<[f64; 2]>,
}

impl Warmth {
    /// Of a contact after Hertz; `None` where no surface that conducts heat streams through it.
    pub(super) fn of(
        subject: &Subject<'_>,
        course: &Course,
        (contact, rolled): (Contact, Option<RollingEstimate>),
    ) -> Option<Self> {
        let heating = Heating::of(subject.bodies, subject.motion).ok()?;
        let axis = heating.direction().axis;
        let half_length = Some(contact.semi_axes[axis]).filter(|one| one.is_finite())?;
        let drives = subject.motion.driven(course.progress);
        let creepage = drives.map_or(0.0, |drives| drives.longitudinal.slip());
        let peclet = heating.peclet(half_length, creepage);
        // Speed of slip over that of the stream, and how much it grows from the middle to the trailing edge.
        let slip = match drives {
            None => Some((1.0, 0.0)),
            Some(_) => rolled
                .and_then(|rolled| rolled.relative_creepage)
                .filter(|relative| relative.abs() >= 1.0)
                .map(|relative| (creepage.abs(), 1.0 / relative.abs())),
        };
        let friction = subject.friction_coefficient();
        let rise =
            slip.zip(friction).filter(|_| peclet >= FAST).map(|((slip, grows), friction)| {
                let heat = friction * contact.peak_pressure * slip * heating.speed();
                let across = contact.semi_axes[1 - axis];
                let shape =
                    if across.is_finite() { semi_ellipsoid(grows) } else { semi_ellipse(grows) };
                shape.map(|factor| factor * heat * half_length.sqrt() * heating.rise(creepage))
            });
        Some(Self { peclet, rise })
    }
}
