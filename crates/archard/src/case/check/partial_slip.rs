//! What closed forms expect of bodies with friction that are shifted or pressed: partial slip.

use std::fmt;

use super::Parts;
use super::contact::{Contact, coefficient};
use super::creep::ALIKE;
use super::words::{length, three};
use crate::closed_form::cattaneo_mindlin::PartialSlip;
use crate::closed_form::fretting_wear::WornOut;
use crate::closed_form::spence::Indentation;
use crate::motion::{Control, Guide, Shift};

/// A sphere on a body of its elasticity, shifted to and fro under constant load or approach: Cattaneo
/// and Mindlin before any wear, and where the wear ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fretting {
    /// Radius of the stick zone at the turns (m); zero if all slips.
    pub stick_radius: f64,
    /// Shift of the bodies at the turns (m).
    pub shift: f64,
    /// Tangential force at the turns (N).
    pub force: f64,
    /// Shift from rest at which all slips (m).
    pub sliding_shift: f64,
    /// Tangential force at which all slips (N).
    pub sliding_force: f64,
    /// Energy that friction dissipates in a cycle (J).
    pub dissipated: f64,
    /// The wear, where bodies wear around a stick zone under constant load.
    pub wear: Option<FrettingWear>,
}

/// How a sphere wears around its stick zone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrettingWear {
    /// Volume (m^3) that all cycles would wear off both bodies at the rate of the first.
    pub steady_volume: f64,
    /// Volume (m^3) worn off once the stick zone carries all of the load.
    pub final_volume: f64,
    /// Depth worn off both bodies then (m), where it is greatest.
    pub final_depth: f64,
    /// Radius of the scar then (m).
    pub final_radius: f64,
}

/// What guides bodies that are moved to and fro along one axis, at its extreme.
fn swing(shift: &Shift) -> Option<Guide> {
    let extremes = [0, 1].map(|axis| {
        let values = shift.cycle.iter().map(|station| value(station.guides[axis]));
        values.fold([0.0; 2], |[low, high]: [f64; 2], value| [low.min(value), high.max(value)])
    });
    let axis = match extremes {
        [_, [0.0, 0.0]] => 0,
        [[0.0, 0.0], _] => 1,
        _ => return None,
    };
    let [low, high] = extremes[axis];
    let guide = match shift.cycle.first()?.guides[axis] {
        Guide::Shift(_) => Guide::Shift(high),
        Guide::Force(_) => Guide::Force(high),
    };
    (high > 0.0 && (high + low).abs() <= 1e-9 * high).then_some(guide)
}

/// What a guide prescribes (m or N).
fn value(guide: Guide) -> f64 {
    match guide {
        Guide::Shift(value) | Guide::Force(value) => value,
    }
}

/// The radius (m) of a sphere on a flat, or of spheres together, by their contact.
fn radius(parts: &Parts<'_>, contact: &Contact) -> Option<f64> {
    let [x, y] = contact.semi_axes;
    let round = (x - y).abs() < 1e-9 * x;
    parts.curvatures().filter(|_| round).map(|curvatures| 1.0 / curvatures[0])
}

/// Partial slip of a sphere on a body of the same material.
pub(super) fn contact_in_partial_slip(parts: &Parts<'_>, contact: &Contact) -> Option<PartialSlip> {
    let radius = radius(parts, contact).filter(|_| parts.dundurs_beta().abs() < ALIKE)?;
    let materials = parts.case.bodies.each_ref().map(|body| body.material.as_ref());
    let friction = parts.friction_coefficient(contact.peak_pressure);
    PartialSlip::new(radius, materials, contact.load, friction)
}

impl Fretting {
    /// What to expect of the parts; `None` unless they are shifted to and fro along one axis under one
    /// load.
    pub(super) fn of(parts: &Parts<'_>, contact: &Contact) -> Option<Self> {
        let shift = parts.motion.shift()?;
        let control = parts.schedule.control;
        let steady = shift.cycle.iter().all(|station| station.control == control);
        let slip = contact_in_partial_slip(parts, contact).filter(|_| steady)?;
        let (amplitude, force) = match swing(shift)? {
            Guide::Shift(amplitude) => (amplitude, slip.force(amplitude)),
            Guide::Force(force) if force < slip.sliding_force => (slip.shift(force), force),
            Guide::Force(_) => return None,
        };
        let beyond = (amplitude - slip.sliding_shift).max(0.0);
        let stick_radius = slip.stick_radius(force);
        let dissipated = slip.dissipation(force) + 4.0 * slip.sliding_force * beyond;
        Some(Self {
            stick_radius,
            shift: amplitude,
            force,
            sliding_shift: slip.sliding_shift,
            sliding_force: slip.sliding_force,
            dissipated,
            wear: FrettingWear::of(parts, contact, stick_radius, dissipated),
        })
    }
}

impl FrettingWear {
    /// Archard's wear of what slides and dissipates that energy (J) a cycle.
    fn of(
        parts: &Parts<'_>,
        contact: &Contact,
        stick_radius: f64,
        dissipated: f64,
    ) -> Option<Self> {
        let Control::Load(load) = parts.schedule.control else { return None };
        let coefficient = coefficient(parts, contact.peak_pressure);
        let radius = radius(parts, contact).filter(|_| coefficient > 0.0)?;
        let last = WornOut::new(radius, parts.contact_modulus(), load, stick_radius)?;
        let friction = parts.friction_coefficient(contact.peak_pressure);
        let cycles = parts.schedule.extent / parts.motion.shift()?.period();
        Some(Self {
            steady_volume: coefficient * dissipated / friction * cycles,
            final_volume: last.volume(),
            final_depth: last.greatest_depth(),
            final_radius: last.scar_radius,
        })
    }

    /// Whether the cycles suffice to come near the end of the wear.
    pub(super) fn ends(&self) -> bool {
        self.steady_volume > self.final_volume
    }
}

/// Share of the contact radius that sticks where a sphere is pressed on a body of other elasticity
/// (Spence); `None` where there is no such closed form.
pub(super) fn stick_ratio(parts: &Parts<'_>, contact: &Contact) -> Option<f64> {
    const SPHERE: f64 = 2.0;
    let shift = parts.motion.shift()?;
    let pressed = |control: Control| match control {
        Control::Load(value) | Control::Approach(value) => value,
    };
    let rise = &shift.cycle[..=shift.peak()];
    let rises = rise.windows(2).all(|pair| pressed(pair[0].control) <= pressed(pair[1].control));
    let friction = parts.friction_coefficient(contact.peak_pressure);
    radius(parts, contact).filter(|_| rises && shift.lead.is_empty() && !shift.moves())?;
    Indentation::at_friction(SPHERE, parts.dundurs_beta(), friction).map(|state| state.stick_ratio)
}

impl fmt::Display for Fretting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let stick = match self.stick_radius {
            0.0 => "none at the turns: gross slip".to_owned(),
            radius => format!("radius {} at the turns", length(radius)),
        };
        writeln!(f, "stick zone        {stick} (Cattaneo-Mindlin)")?;
        let [shift, sliding] = [self.shift, self.sliding_shift].map(length);
        writeln!(f, "shift             {shift} at the turns, all slips from {sliding} on")?;
        let [force, sliding] = [self.force, self.sliding_force].map(three);
        writeln!(f, "tangential force  {force} N at the turns, {sliding} N if all slips")?;
        writeln!(f, "dissipated        {} J a cycle", three(self.dissipated))
    }
}

impl fmt::Display for FrettingWear {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [steady, last] = [self.steady_volume, self.final_volume].map(|v| three(v * 1e9));
        writeln!(f, "worn volume       {steady} mm^3 at the rate of the first cycle")?;
        writeln!(f, "                  {last} mm^3 at most, once the stick zone bears the load")?;
        let [depth, radius] = [self.final_depth, self.final_radius].map(length);
        writeln!(f, "scar              {depth} deep, radius {radius} then")
    }
}
