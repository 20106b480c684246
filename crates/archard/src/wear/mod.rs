//! Wear laws: how deep a surface wears where it is rubbed.
//!
//! A new law is one file here and one line in [`WEAR_LAWS`].

mod archard;

use std::fmt::Debug;

pub use archard::Archard;

use crate::parameters::Choice;

/// What one pair of points went through during a step.
#[non_exhaustive]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rubbing {
    /// Pressure (Pa), zero or greater.
    pub pressure: f64,
    /// Distance slid while the step lasted (m), zero or greater.
    pub slip: f64,
    /// Work of friction on that slip (J/m^2).
    pub work: f64,
    /// How the largest tangential traction grows with the pressure: Coulomb's mu. Zero without friction.
    pub friction: f64,
}

impl Rubbing {
    /// Slip (m) under a pressure (Pa), without friction.
    pub fn new(pressure: f64, slip: f64) -> Self {
        Self { pressure, slip, work: 0.0, friction: 0.0 }
    }

    /// The same with friction: its work (J/m^2), and how its limit grows with the pressure.
    #[must_use]
    pub fn with_friction(self, work: f64, friction: f64) -> Self {
        Self { work, friction, ..self }
    }

    /// The same slip under another pressure (Pa); the work follows as the limit of friction does.
    #[must_use]
    pub fn under(self, pressure: f64) -> Self {
        let more = self.friction * (pressure - self.pressure) * self.slip;
        Self { pressure, work: self.work + more, ..self }
    }
}

/// What a law may ask for beside pressure and slip, and not every problem has.
#[non_exhaustive]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Input {
    /// The work of friction.
    Friction,
}

/// Depth of wear from rubbing.
pub trait WearLaw: Debug + Send + Sync {
    /// What it asks for beside pressure and slip; a problem without is refused.
    fn inputs(&self) -> &'static [Input] {
        &[]
    }

    /// Depth (m) worn off this body by the rubbing; must not fall as the pressure grows.
    fn depth(&self, rubbing: Rubbing) -> f64;

    /// Derivative of the depth with respect to the pressure (m/Pa), zero or greater, the work of friction following
    /// as its limit does.
    ///
    /// The implicit wear step adds it to the compliance. By default a central difference.
    fn slope(&self, rubbing: Rubbing) -> f64 {
        let change = 1e-6 * rubbing.pressure.max(1.0);
        let at = |pressure: f64| self.depth(rubbing.under(pressure));
        let (low, high) = ((rubbing.pressure - change).max(0.0), rubbing.pressure + change);
        (at(high) - at(low)) / (high - low)
    }
}

/// The wear laws a case can name.
pub const WEAR_LAWS: &[Choice<Box<dyn WearLaw>>] = &[archard::CHOICE];
