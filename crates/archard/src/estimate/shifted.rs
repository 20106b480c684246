//! Spheres that are pressed together and shifted against each other: partial slip.

use std::cell::OnceCell;

use super::{ALIKE, Course, Subject};
use crate::closed_form::cattaneo_mindlin::PartialSlip;
use crate::closed_form::fretting_wear::WornOut;
use crate::closed_form::spence::Indentation;
use crate::motion::{Control, Drive, Shift};

/// A sphere on a body of its elasticity, shifted to and fro under constant load or approach: Cattaneo
/// and Mindlin before any wear, and where the wear ends.
#[non_exhaustive]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fretting {
    /// The axis, 0 for x and 1 for y, along which it goes.
    pub axis: usize,
    /// Normal force (N).
    pub load: f64,
    /// The unworn contact, with force and shift at which all slips.
    pub contact: PartialSlip,
    /// Tangential force at the turns (N).
    pub force: f64,
    /// Shift of the bodies at the turns (m).
    pub shift: f64,
    /// Radius of the stick zone at the turns (m); zero if all slips.
    pub stick_radius: f64,
    /// Energy (J) that friction dissipates in a cycle: in partial slip, and beyond it while all slides.
    pub dissipated: f64,
    /// The wear, where bodies wear around a stick zone under constant load.
    pub wear: Option<FrettingWear>,
}

/// How a sphere wears around its stick zone.
#[non_exhaustive]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrettingWear {
    /// Volume (m^3) that the cycles so far would have worn off both bodies at the rate of the first.
    pub steady_volume: f64,
    /// The shape once the stick zone carries all of the load.
    pub end: WornOut,
}

/// A sphere that is pressed on a body of other elasticity with friction: Spence, before any wear.
#[non_exhaustive]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SphereWithFriction {
    /// Dundurs' constant.
    pub coupling: f64,
    /// mu.
    pub friction: f64,
    /// Radius of the stick zone over that of the contact.
    pub stick_ratio: f64,
    /// Approach of the bodies (m).
    pub approach: f64,
    /// Normal force (N).
    pub load: f64,
    /// Radius of the contact (m).
    pub contact_radius: f64,
}

/// What guides bodies that are moved to and fro along one axis, at its extreme, and the axis.
fn swing(shift: &Shift) -> Option<(usize, Drive)> {
    let stations = || shift.cycle.iter();
    let value = Drive::value;
    let still = |axis: usize| stations().all(|station| station.guides[axis].is_still());
    let axis = [0, 1].into_iter().find(|&axis| !still(axis) && still(1 - axis))?;
    let along = || stations().map(|station| station.guides[axis]);
    let most = along().max_by(|one, other| value(*one).total_cmp(&value(*other)))?;
    let (high, low) = (value(most), along().map(value).fold(0.0, f64::min));
    (high > 0.0 && (high + low).abs() <= 1e-9 * high).then_some((axis, most))
}

impl Fretting {
    /// What to expect; `None` unless a sphere is shifted to and fro along one axis, pressed on evenly.
    pub(super) fn of(subject: &Subject<'_>, course: &Course) -> Option<Self> {
        let shift = subject.motion.increments()?;
        let control = shift.cycle.first()?.control;
        let steady = shift.cycle.iter().all(|station| station.control == control);
        if !steady || subject.dundurs_beta().abs() >= ALIKE {
            return None;
        }
        let (load, friction) = (subject.contact(control)?.load, subject.friction_coefficient()?);
        let contact = PartialSlip::new(subject.radius()?, subject.materials(), load, friction)?;
        let (axis, guide) = swing(shift)?;
        let (shift, force) = match guide {
            Drive::Slip(shift) => (shift, contact.force(shift)),
            Drive::Force(force) if force < contact.sliding_force => (contact.shift(force), force),
            Drive::Force(_) => return None,
        };
        let slid = (shift - contact.sliding_shift).max(0.0);
        let dissipated = contact.dissipation(force) + 4.0 * contact.sliding_force * slid;
        let stick_radius = contact.stick_radius(force);
        let unworn =
            Self { axis, load, contact, force, shift, stick_radius, dissipated, wear: None };
        let wear = matches!(control, Control::Load(_)).then(|| unworn.wear(subject, course));
        Some(Self { wear: wear.flatten(), ..unworn })
    }

    /// Archard's wear of what slides and dissipates.
    fn wear(&self, subject: &Subject<'_>, course: &Course) -> Option<FrettingWear> {
        let coefficient = subject.total_wear_coefficient()?;
        let modulus = subject.contact_modulus();
        let end = WornOut::new(subject.radius()?, modulus, self.load, self.stick_radius)?;
        let cycles = course.progress / subject.motion.increments()?.period();
        let steady_volume = coefficient * self.dissipated / self.contact.friction * cycles;
        Some(FrettingWear { steady_volume, end })
    }
}

impl FrettingWear {
    /// Whether the cycles suffice to come near the end of the wear.
    pub fn ends(&self) -> bool {
        self.steady_volume > self.end.volume()
    }
}

impl SphereWithFriction {
    /// What to expect; `None` unless a sphere is pressed on more and more up to the peak of a cycle, and not shifted.
    pub(super) fn of(
        subject: &Subject<'_>,
        control: Control,
        known: &OnceCell<Option<Indentation>>,
    ) -> Option<Self> {
        const SPHERE: f64 = 2.0;
        let shift = subject.motion.increments()?;
        if subject.radius().is_none() || shift.moves() || !rises(shift) {
            return None;
        }
        let (coupling, friction) = (subject.dundurs_beta(), subject.friction_coefficient()?);
        let state = known.get_or_init(|| Indentation::at_friction(SPHERE, coupling, friction));
        let Indentation { stick_ratio, relative_load, relative_approach, .. } = state.as_ref()?;
        let relative = match control {
            Control::Load(_) => relative_load,
            Control::Approach(_) => relative_approach,
        };
        // The contact without friction that is as wide.
        let contact = subject.contact(control.scaled(1.0 / relative))?;
        Some(Self {
            coupling,
            friction,
            stick_ratio: *stick_ratio,
            approach: relative_approach * contact.approach?,
            load: relative_load * contact.load,
            contact_radius: contact.semi_axes[0],
        })
    }
}

/// Whether the bodies are pressed together more and more up to the peak of the cycle.
fn rises(shift: &Shift) -> bool {
    let rise = shift.lead.iter().chain(&shift.cycle[..=shift.peak()]);
    rise.map(|station| match station.control {
        Control::Load(value) | Control::Approach(value) => value,
    })
    .is_sorted()
}
