//! Friction laws: which tangential tractions a pair bears.
//!
//! A new law is one file here and a line in [`FRICTION`] and [`ABOUT_FRICTION`].

mod coulomb;
mod disc;
mod falling;
mod grip;
mod map;
mod orthotropic;
mod table;
mod tresca;

use std::fmt::Debug;

pub use coulomb::Coulomb;
#[doc(hidden)]
pub use disc::{Beyond, onto_disc};
pub use falling::FallingFriction;
pub use grip::{Circumstance, Circumstances};
#[doc(hidden)]
pub use grip::{Grip, Limits};
pub use map::Map;
pub use orthotropic::Orthotropic;
pub use table::Table;
pub use tresca::Tresca;

use crate::parameters::{About, Choice};

/// The admissible tangential tractions under a pressure: an ellipse around zero, the image of a disc.
pub trait Friction: Debug + Send + Sync {
    /// Radius of the disc (Pa) under a pressure (Pa): the largest tangential traction that a pair bears where the
    /// [map](Self::map) is the identity. It must not fall as the pressure grows, and be zero without pressure.
    fn limit(&self, pressure: f64) -> f64;

    /// Derivative of the limit with respect to the pressure, zero or greater. By default a central
    /// difference.
    fn slope(&self, pressure: f64) -> f64 {
        let change = 1e-6 * pressure.max(1.0);
        let (low, high) = ((pressure - change).max(0.0), pressure + change);
        (self.limit(high) - self.limit(low)) / (high - low)
    }

    /// What the limit depends on besides the pressure.
    fn inputs(&self) -> &[Circumstance] {
        &[]
    }

    /// What that scales the limit by, zero or greater.
    fn factor(&self, _at: Circumstances) -> f64 {
        1.0
    }

    /// What makes the ellipse of the disc, the same at all pairs and pressures. Solvers of friction see the disc alone.
    fn map(&self) -> Map {
        Map::IDENTITY
    }
}

/// The friction laws a case can name.
pub const FRICTION: &[Choice<Box<dyn Friction>>] =
    &[coulomb::CHOICE, orthotropic::CHOICE, tresca::CHOICE, falling::CHOICE, table::CHOICE];

/// Where they are from, and how a case has them, in the same order.
pub const ABOUT_FRICTION: &[About] =
    &[coulomb::ABOUT, orthotropic::ABOUT, tresca::ABOUT, falling::ABOUT, table::ABOUT];
