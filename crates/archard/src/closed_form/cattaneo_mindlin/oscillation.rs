//! Partial slip under a force that goes to and fro.

use super::PartialSlip;

/// A way of a force that swings between its extremes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Branch {
    /// From +Q to -Q.
    Unloading,
    /// From -Q to +Q.
    Reloading,
}

impl Branch {
    /// The sign of the force the branch comes from.
    fn origin(self) -> f64 {
        match self {
            Self::Unloading => 1.0,
            Self::Reloading => -1.0,
        }
    }
}

/// A tangential force that swings between two opposite extremes: Johnson, section 7.4.
///
/// On the way from the extreme Q* the state is that at Q* less twice the one that a force of
/// (Q* - Q)/2 raises from nothing; it ends as the opposite of that at Q*. Forces and shifts beyond
/// the extremes count as the nearer one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Oscillation {
    contact: PartialSlip,
    force_amplitude: f64,
}

impl Oscillation {
    pub(super) fn new(contact: PartialSlip, force_amplitude: f64) -> Self {
        Self { contact, force_amplitude: force_amplitude.abs().min(contact.sliding_force) }
    }

    /// The extreme of the force (N).
    pub fn force_amplitude(&self) -> f64 {
        self.force_amplitude
    }

    /// The extreme of the shift (m).
    pub fn shift_amplitude(&self) -> f64 {
        self.contact.shift(self.force_amplitude)
    }

    /// Shift (m) at a force (N) on a branch.
    pub fn shift(&self, branch: Branch, force: f64) -> f64 {
        let back = self.half_way_back(branch, force);
        branch.origin() * (self.shift_amplitude() - 2.0 * self.contact.shift(back))
    }

    /// Force (N) at a shift (m) on a branch: the inverse of [`Self::shift`].
    pub fn force(&self, branch: Branch, shift: f64) -> f64 {
        let amplitude = self.shift_amplitude();
        let back = 0.5 * (amplitude - (branch.origin() * shift).clamp(-amplitude, amplitude));
        branch.origin() * (self.force_amplitude - 2.0 * self.contact.force(back))
    }

    /// Traction (Pa) at a distance (m) from the centre, at a force (N) on a branch.
    pub fn traction(&self, branch: Branch, distance: f64, force: f64) -> f64 {
        let back = self.half_way_back(branch, force);
        let at_turn = self.contact.traction(distance, self.force_amplitude);
        branch.origin() * (at_turn - 2.0 * self.contact.traction(distance, back))
    }

    /// Radius (m) beyond which the branch has slipped back by the time it reaches a force (N).
    pub fn stick_radius(&self, branch: Branch, force: f64) -> f64 {
        self.contact.stick_radius(self.half_way_back(branch, force))
    }

    /// Half the force (N) taken back since the turn.
    fn half_way_back(&self, branch: Branch, force: f64) -> f64 {
        let extreme = self.force_amplitude;
        0.5 * (extreme - (branch.origin() * force).clamp(-extreme, extreme))
    }
}
