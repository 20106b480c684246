//! Wear laws: how deep a surface wears where it is rubbed.
//!
//! A new law is one file here and a line in [`WEAR_LAWS`] and [`ABOUT_WEAR_LAWS`].

mod archard;
mod cross_shear;
mod energy;
mod expression;
mod layered;
mod map;
mod orthotropic;
mod power;
mod rubbing;
mod running_in;
mod t_gamma;
mod table;
mod threshold;
mod trial;

use std::fmt::Debug;

pub use archard::Archard;
pub use cross_shear::CrossShear;
pub use energy::Energy;
pub use expression::Expression;
#[doc(hidden)]
pub use expression::LookUp;
pub use layered::LayeredWear;
pub use map::Map;
pub use orthotropic::Orthotropic;
pub use power::Power;
pub use rubbing::{Columns, Rubbing};
pub use running_in::RunningIn;
pub use t_gamma::TGamma;
pub use table::{Over, Table};
pub use threshold::Threshold;
#[doc(hidden)]
pub use trial::try_out;

use crate::parameters::{About, Choice};

/// What a law takes at once.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Per {
    /// Any part of a motion: what two parts wear one after the other is what they wear as one. Unless the law asks for what
    /// was before, the depth then grows in proportion to the slip, the work and the distance rolled together. A law of their
    /// ratios, as of the work per distance rolled, does too.
    Increment,
    /// What a point goes through in a cycle of the motion: a cycle of fretting, or a passage through the contact of
    /// bodies that roll. The pressure is the mean over the slip. Where surfaces that stay slide there is no cycle.
    Cycle,
}

/// What a law may ask for besides pressure and slip. It is left out of the [`Columns`] of a law that does not ask for it;
/// a problem that does not have it is refused.
#[non_exhaustive]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Input {
    /// The work of friction, and with it the coefficient of friction.
    Friction,
    /// Slip and traction as vectors. There is no traction without friction.
    Vectors,
    /// How much the directions of slip cross each other.
    CrossShear,
    /// The speed of sliding.
    Speed,
    /// The temperature of the surfaces.
    Temperature,
    /// The distance rolled.
    Rolled,
    /// The distance slid before.
    Distance,
    /// The depth worn before.
    Depth,
}

/// Depth of wear from rubbing.
pub trait WearLaw: Debug + Send + Sync {
    /// What it asks for besides pressure and slip; a problem without is refused.
    fn inputs(&self) -> &[Input] {
        &[]
    }

    /// What it takes at once.
    fn per(&self) -> Per {
        Per::Increment
    }

    /// The hardness (Pa) of the body, where the law knows it: the largest pressure that is believed.
    fn hardness(&self) -> Option<f64> {
        None
    }

    /// Depth (m) worn off this body by the rubbing; zero without pressure or slip, must not fall as either grows.
    fn depth(&self, rubbing: Rubbing) -> f64;

    /// Derivative of the depth with respect to the pressure (m/Pa), zero or greater, the work of friction following
    /// as its limit does, all that was before as it is.
    ///
    /// The implicit wear step adds it to the compliance. By default a central difference.
    fn slope(&self, rubbing: Rubbing) -> f64 {
        let change = 1e-6 * rubbing.pressure.max(1.0);
        let at = |pressure: f64| self.depth(rubbing.under(pressure));
        let (low, high) = ((rubbing.pressure - change).max(0.0), rubbing.pressure + change);
        (at(high) - at(low)) / (high - low)
    }

    /// Depths (m) and [slopes](WearLaw::slope) (m/Pa) of many points, one value each. By default point by point; a law
    /// that is faster on whole columns says how.
    fn depths(&self, points: &Columns, depths: &mut [f64], slopes: &mut [f64]) {
        for (point, (depth, slope)) in depths.iter_mut().zip(slopes).enumerate() {
            let rubbing = points.at(point);
            (*depth, *slope) = (self.depth(rubbing), self.slope(rubbing));
        }
    }
}

/// The wear laws a case can name.
pub const WEAR_LAWS: &[Choice<Box<dyn WearLaw>>] = &[
    archard::CHOICE,
    energy::CHOICE,
    orthotropic::CHOICE,
    cross_shear::CHOICE,
    power::CHOICE,
    threshold::CHOICE,
    running_in::CHOICE,
    table::CHOICE,
    t_gamma::CHOICE,
    map::CHOICE,
    expression::CHOICE,
];

/// Where they are from, and how a case has them, in the same order.
pub const ABOUT_WEAR_LAWS: &[About] = &[
    archard::ABOUT,
    energy::ABOUT,
    orthotropic::ABOUT,
    cross_shear::ABOUT,
    power::ABOUT,
    threshold::ABOUT,
    running_in::ABOUT,
    table::ABOUT,
    t_gamma::ABOUT,
    map::ABOUT,
    expression::ABOUT,
];
