//! Partial slip of a sphere under a constant load and a tangential force.
//!
//! C. Cattaneo (1938); R. D. Mindlin, *J. Appl. Mech.* 16 (1949) 259; for forces that turn back
//! R. D. Mindlin and H. Deresiewicz, *J. Appl. Mech.* 20 (1953) 327; all in Johnson, *Contact
//! Mechanics*, sections 7.2 and 7.4. With a the radius of the contact, c that of the stick zone and
//! D the shift of the bodies at full sliding,
//!
//! ```text
//! Q / (mu P) = 1 - (c/a)^3,  shift = D [1 - (c/a)^2],  D = 3 mu P S / (16 a),
//! S = (2 - nu1)/G1 + (2 - nu2)/G2.
//! ```
//!
//! The bodies are elastically similar, so that pressing them together makes nothing slip. Tractions
//! and slip are taken along the force; the slip across it, left out by the theory, makes the exact
//! force at a given shift some 4e-4 higher for steel. A force that turns back adds to the state at
//! the turn one of twice the friction in the other direction.

mod oscillation;
#[cfg(test)]
mod tests;

use std::f64::consts::FRAC_2_PI;

use super::Hertz;
use crate::body::{Material, contact_modulus};

pub use oscillation::{Branch, Oscillation};

/// A sphere pressed on a body, about to be pushed along it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PartialSlip {
    /// Radius of the contact (m).
    pub contact_radius: f64,
    /// Pressure at the centre (Pa).
    pub peak_pressure: f64,
    /// Friction coefficient mu.
    pub friction: f64,
    /// Tangential force at which all slips, mu P (N).
    pub sliding_force: f64,
    /// Shift of the bodies from rest at which all slips (m).
    pub sliding_shift: f64,
}

impl PartialSlip {
    /// A sphere of a combined radius (m) under a normal force (N) with a friction coefficient; a body
    /// that is `None` is rigid.
    ///
    /// `None` unless radius, load and friction are all positive and finite and one body is elastic.
    pub fn new(
        radius: f64,
        materials: [Option<&Material>; 2],
        load: f64,
        friction: f64,
    ) -> Option<Self> {
        let hertz = Hertz::from_load([1.0 / radius; 2], contact_modulus(materials), load)?;
        if !(friction > 0.0 && friction.is_finite()) {
            return None;
        }
        let contact_radius = hertz.semi_axes[0];
        let sliding_force = friction * load;
        let sliding_shift =
            3.0 * sliding_force * tangential_compliance(materials) / (16.0 * contact_radius);
        let peak_pressure = hertz.peak_pressure;
        Some(Self { contact_radius, peak_pressure, friction, sliding_force, sliding_shift })
    }

    /// Radius of the stick zone (m) at a tangential force (N) that has risen from nothing; 0 when all
    /// slips.
    pub fn stick_radius(&self, force: f64) -> f64 {
        self.contact_radius * (1.0 - self.slip_share(force))
    }

    /// Shift (m) at a tangential force (N) that has risen from nothing; that of full sliding from mu P
    /// on, where the force no longer gives it.
    pub fn shift(&self, force: f64) -> f64 {
        let share = self.slip_share(force);
        force.signum() * self.sliding_shift * share * (2.0 - share)
    }

    /// Tangential force (N) at a shift (m) that has risen from nothing: the inverse of
    /// [`Self::shift`], mu P from full sliding on.
    pub fn force(&self, shift: f64) -> f64 {
        let relative = (shift / self.sliding_shift).abs().min(1.0);
        -shift.signum() * self.sliding_force * (1.5 * (-relative).ln_1p()).exp_m1()
    }

    /// Tangential force (N) that leaves a stick zone of that radius (m): the inverse of
    /// [`Self::stick_radius`].
    pub fn force_at_stick_radius(&self, stick_radius: f64) -> f64 {
        self.sliding_force * (1.0 - self.relative(stick_radius).powi(3))
    }

    /// Shift (m) that leaves a stick zone of that radius (m).
    pub fn shift_at_stick_radius(&self, stick_radius: f64) -> f64 {
        self.sliding_shift * (1.0 - self.relative(stick_radius).powi(2))
    }

    /// Pressure (Pa) at a distance (m) from the centre.
    pub fn pressure(&self, distance: f64) -> f64 {
        self.peak_pressure * semicircle(distance / self.contact_radius)
    }

    /// Traction (Pa) along a tangential force (N) that has risen from nothing, at a distance (m) from
    /// the centre: mu p0 [sqrt(1 - (r/a)^2) - (c/a) sqrt(1 - (r/c)^2)].
    pub fn traction(&self, distance: f64, force: f64) -> f64 {
        let stick_radius = self.stick_radius(force);
        let spared = if distance < stick_radius {
            stick_radius / self.contact_radius * semicircle(distance / stick_radius)
        } else {
            0.0
        };
        let full = semicircle(distance / self.contact_radius);
        force.signum() * self.friction * self.peak_pressure * (full - spared)
    }

    /// Slip (m) along a tangential force (N) that has risen from nothing, at a distance (m) from the
    /// centre, averaged around it; 0 in the stick zone and outside the contact.
    ///
    /// ```text
    /// D r^2/(2 a^2) {[1 - (2/pi) asin(c/r)] (1 - 2 c^2/r^2) + (2/pi) (c/r) sqrt(1 - c^2/r^2)}
    /// ```
    ///
    /// A force that swings between +Q and -Q rubs over four times the slip at Q a cycle.
    pub fn slip(&self, distance: f64, force: f64) -> f64 {
        let stick_radius = self.stick_radius(force);
        if distance <= stick_radius || distance > self.contact_radius {
            return 0.0;
        }
        let ratio = stick_radius / distance;
        let outside = FRAC_2_PI * ratio.acos();
        let edge = FRAC_2_PI * ratio * semicircle(ratio);
        let shape = outside * (1.0 - 2.0 * ratio * ratio) + edge;
        force.signum() * 0.5 * self.sliding_shift * self.relative(distance).powi(2) * shape
    }

    /// Energy (J) lost to friction in each cycle of a force between +Q and -Q (N); nothing slips all
    /// over, so Q is at most mu P.
    ///
    /// Johnson, section 7.4, where 1 - (1 - x)^(5/3) - (5x/6) [1 + (1 - x)^(2/3)] with x = Q / (mu P)
    /// is (1 - y)^3 (1 + 3y + y^2)/6 with y = c/a.
    pub fn dissipation(&self, force_amplitude: f64) -> f64 {
        let share = self.slip_share(force_amplitude);
        let stick = 1.0 - share;
        let shape = share.powi(3) * (1.0 + 3.0 * stick + stick * stick);
        0.8 * self.sliding_force * self.sliding_shift * shape
    }

    /// The states of a force that swings between +Q and -Q (N), at most mu P.
    pub fn oscillation(&self, force_amplitude: f64) -> Oscillation {
        Oscillation::new(*self, force_amplitude)
    }

    /// 1 - c/a at a force, with the digits of small forces.
    fn slip_share(&self, force: f64) -> f64 {
        let relative = (force / self.sliding_force).abs().min(1.0);
        -((-relative).ln_1p() / 3.0).exp_m1()
    }

    /// A radius over that of the contact, at most 1.
    fn relative(&self, radius: f64) -> f64 {
        (radius / self.contact_radius).clamp(0.0, 1.0)
    }
}

/// Mindlin's compliance (2 - nu)/G (1/Pa), summed over the bodies; a rigid one adds nothing.
fn tangential_compliance(materials: [Option<&Material>; 2]) -> f64 {
    let compliance = |body: &Material| (2.0 - body.poisson) / body.shear_modulus();
    materials.into_iter().flatten().map(compliance).sum()
}

/// sqrt(1 - x^2), 0 beyond 1.
fn semicircle(place: f64) -> f64 {
    (1.0 - place * place).max(0.0).sqrt()
}
