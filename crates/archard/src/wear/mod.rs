//! Wear laws: how deep a surface wears where it is rubbed.
//!
//! A new law is one file here and one line in [`WEAR_LAWS`].

mod archard;

use std::fmt::Debug;

use crate::parameters::Choice;

/// What one pair of points went through during a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rubbing {
    /// Pressure (Pa), zero or greater.
    pub pressure: f64,
    /// Distance slid while the step lasted (m), zero or greater.
    pub slip: f64,
}

/// Depth of wear from rubbing.
pub trait WearLaw: Debug + Send + Sync {
    /// Depth (m) worn off this body by the rubbing; must not fall as the pressure grows.
    fn depth(&self, rubbing: Rubbing) -> f64;

    /// Derivative of the depth with respect to the pressure (m/Pa), zero or greater.
    ///
    /// The implicit wear step adds it to the compliance. By default a central difference.
    fn slope(&self, rubbing: Rubbing) -> f64 {
        let change = 1e-6 * rubbing.pressure.max(1.0);
        let at = |pressure: f64| self.depth(Rubbing { pressure: pressure.max(0.0), ..rubbing });
        let (low, high) = ((rubbing.pressure - change).max(0.0), rubbing.pressure + change);
        (at(high) - at(low)) / (high - low)
    }
}

/// The wear laws a case can name.
pub const WEAR_LAWS: &[Choice<Box<dyn WearLaw>>] = &[archard::CHOICE];
