//! Spheres that are pressed together and shifted against each other.

use std::cell::OnceCell;

use serde_json::{Value, json};

use super::Contact;
use crate::closed_form::Hertz;
use crate::closed_form::cattaneo_mindlin::PartialSlip;
use crate::closed_form::fretting_wear::WornOut;
use crate::closed_form::spence::{Indentation, coupling};
use crate::motion::{Control, Guide, Shift, Station};
use crate::output::coefficients;
use crate::simulation::Report;

/// Differences, relative to what differs, that only rounding makes.
const ROUNDING: f64 = 1e-9;

impl Contact<'_> {
    /// Blocks of bodies that are pressed and shifted.
    pub(super) fn shifted(
        &self,
        report: &Report<'_>,
        shift: &Shift,
        spence: &OnceCell<Option<Indentation>>,
    ) -> Vec<(&'static str, Option<Value>)> {
        let fretting = self.fretting(report, shift);
        vec![
            ("fretting_wear", fretting.as_ref().and_then(|fretting| self.worn_out(fretting))),
            ("cattaneo_mindlin", fretting.map(|fretting| fretting.block())),
            ("spence", self.spence(report, shift, spence)),
        ]
    }

    /// Similar bodies under a constant load that are guided to and fro along one axis.
    fn fretting(&self, report: &Report<'_>, shift: &Shift) -> Option<Fretting> {
        let friction = coefficients::of_friction(self.problem)?;
        let (axis, swing) = Swing::of(shift)?;
        let materials = self.problem.bodies.each_ref().map(|body| body.material.as_ref());
        let control = constant(&shift.cycle)?;
        // The load at a given approach falls as the bodies wear.
        let steady = matches!(control, Control::Load(_)) || !self.problem.wears();
        if !steady || coupling(materials).abs() > ROUNDING {
            return None;
        }
        let load = report.state.load;
        let contact = PartialSlip::new(self.radius()?, materials, load, friction)?;
        swing.fits(&contact).then_some(Fretting { axis, load, contact, swing })
    }

    /// Where the wear of a stick zone's surroundings ends.
    fn worn_out(&self, fretting: &Fretting) -> Option<Value> {
        let stick_radius = fretting.stick_radius();
        let end = WornOut::new(self.radius()?, self.modulus, fretting.load, stick_radius)?;
        self.problem.wears().then(|| {
            json!({
                "stick_radius_m": end.stick_radius,
                "approach_m": end.approach,
                "scar_radius_m": end.scar_radius,
                "wear_depth_m": end.greatest_depth(),
                "worn_volume_m3": end.volume(),
            })
        })
    }

    /// Unlike bodies that are only pressed together, more and more.
    fn spence(
        &self,
        report: &Report<'_>,
        shift: &Shift,
        known: &OnceCell<Option<Indentation>>,
    ) -> Option<Value> {
        let (radius, approach) = (self.radius()?, report.state.approach);
        let friction = coefficients::of_friction(self.problem)?;
        let materials = self.problem.bodies.each_ref().map(|body| body.material.as_ref());
        let coupling = coupling(materials);
        let unlike = coupling.abs() > ROUNDING;
        if shift.moves() || self.problem.wears() || !unlike || !rises(&shift.cycle) {
            return None;
        }
        let pressed = known.get_or_init(|| Indentation::at_friction(2.0, coupling, friction));
        let pressed = pressed.as_ref()?;
        let frictionless = approach / pressed.relative_approach;
        let hertz = Hertz::from_approach([1.0 / radius; 2], self.modulus, frictionless)?;
        Some(json!({
            "coupling": coupling,
            "friction_coefficient": friction,
            "stick_ratio": pressed.stick_ratio,
            "approach_m": approach,
            "load_N": pressed.relative_load * hertz.load,
            "contact_radius_m": hertz.semi_axes[0],
        }))
    }
}

/// How bodies are guided between two opposite extremes.
enum Swing {
    /// Amplitude of the displacement (m).
    Shift(f64),
    /// Amplitude of the force (N).
    Force(f64),
}

impl Swing {
    /// Along which axis a motion goes to and fro, if it is one only, and how far.
    fn of(shift: &Shift) -> Option<(usize, Self)> {
        let stations = || shift.cycle.iter();
        let still = |axis: usize| stations().all(|station| value(station.guides[axis]) == 0.0);
        let axis = [0, 1].into_iter().find(|&axis| !still(axis) && still(1 - axis))?;
        let along = || stations().map(|station| station.guides[axis]);
        let most = along().map(value).fold(0.0, f64::max);
        let least = along().map(value).fold(0.0, f64::min);
        if (most + least).abs() > ROUNDING * most {
            return None;
        }
        let forces = along().any(|guide| matches!(guide, Guide::Force(_)));
        Some((axis, if forces { Self::Force(most) } else { Self::Shift(most) }))
    }

    /// Whether friction bears it.
    fn fits(&self, contact: &PartialSlip) -> bool {
        match self {
            Self::Shift(_) => true,
            Self::Force(force) => *force < contact.sliding_force,
        }
    }
}

/// A displacement (m) or a force (N).
fn value(guide: Guide) -> f64 {
    match guide {
        Guide::Shift(value) | Guide::Force(value) => value,
    }
}

/// The load or approach of all stations, if it is the same.
fn constant(stations: &[Station]) -> Option<Control> {
    let first = stations.first()?.control;
    stations.iter().all(|station| station.control == first).then_some(first)
}

/// Whether the bodies are pressed together more from station to station.
fn rises(stations: &[Station]) -> bool {
    stations.windows(2).all(|pair| match (pair[0].control, pair[1].control) {
        (Control::Load(one), Control::Load(next))
        | (Control::Approach(one), Control::Approach(next)) => one <= next,
        _ => false,
    })
}

/// A sphere in partial slip.
struct Fretting {
    axis: usize,
    /// Normal force (N).
    load: f64,
    contact: PartialSlip,
    swing: Swing,
}

impl Fretting {
    /// Amplitude of the force (N).
    fn force(&self) -> f64 {
        match self.swing {
            Swing::Shift(shift) => self.contact.force(shift),
            Swing::Force(force) => force,
        }
    }

    /// Amplitude of the displacement (m).
    fn shift(&self) -> f64 {
        match self.swing {
            Swing::Shift(shift) => shift,
            Swing::Force(force) => self.contact.shift(force),
        }
    }

    /// Radius of what sticks at the extremes (m).
    fn stick_radius(&self) -> f64 {
        self.contact.stick_radius(self.force())
    }

    /// Energy lost in a cycle (J): in partial slip, and beyond it while all slides.
    fn dissipation(&self) -> f64 {
        let slid = (self.shift() - self.contact.sliding_shift).max(0.0);
        self.contact.dissipation(self.force()) + 4.0 * self.contact.sliding_force * slid
    }

    fn block(&self) -> Value {
        json!({
            "axis": (["x", "y"][self.axis]),
            "load_N": self.load,
            "friction_coefficient": self.contact.friction,
            "contact_radius_m": self.contact.contact_radius,
            "peak_pressure_Pa": self.contact.peak_pressure,
            "sliding_force_N": self.contact.sliding_force,
            "sliding_shift_m": self.contact.sliding_shift,
            "force_amplitude_N": self.force(),
            "shift_amplitude_m": self.shift(),
            "stick_radius_m": self.stick_radius(),
            "dissipated_per_cycle_J": self.dissipation(),
        })
    }
}
