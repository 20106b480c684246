//! Wear laws: how deep a surface wears where it is rubbed.
//!
//! A new law is one file here and one line in [`WEAR_LAWS`].

mod archard;

use std::fmt::Debug;

use serde::{Deserialize, Serialize};

use crate::parameters::Choice;

/// What one pair of points went through during a step.
#[non_exhaustive]
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
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

    /// This and what comes after it, together: the pressure is the mean over the slip.
    #[must_use]
    pub fn then(self, next: Self) -> Self {
        let slip = self.slip + next.slip;
        let mean = |one: f64, other: f64| {
            if slip > 0.0 { (one * self.slip + other * next.slip) / slip } else { other }
        };
        Self {
            pressure: mean(self.pressure, next.pressure),
            slip,
            work: self.work + next.work,
            friction: mean(self.friction, next.friction),
        }
    }

    /// The same slip under another pressure (Pa); the work follows as the limit of friction does.
    #[must_use]
    pub fn under(self, pressure: f64) -> Self {
        let more = self.friction * (pressure - self.pressure) * self.slip;
        Self { pressure, work: self.work + more, ..self }
    }
}

/// What many points went through: the values of [`Rubbing`], one a point.
#[non_exhaustive]
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Columns {
    /// Pressure (Pa).
    pub pressure: Vec<f64>,
    /// Distance slid (m).
    pub slip: Vec<f64>,
    /// Work of friction (J/m^2).
    pub work: Vec<f64>,
    /// How the largest tangential traction grows with the pressure.
    pub friction: Vec<f64>,
}

impl Columns {
    /// Number of points.
    pub fn len(&self) -> usize {
        self.pressure.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.pressure.is_empty()
    }

    /// What one of them went through.
    pub fn at(&self, point: usize) -> Rubbing {
        let Self { pressure, slip, work, friction } = self;
        let [pressure, slip, work, friction] =
            [pressure, slip, work, friction].map(|column| column[point]);
        Rubbing { pressure, slip, work, friction }
    }
}

impl FromIterator<Rubbing> for Columns {
    fn from_iter<I: IntoIterator<Item = Rubbing>>(points: I) -> Self {
        let mut columns = Self::default();
        for Rubbing { pressure, slip, work, friction } in points {
            columns.pressure.push(pressure);
            columns.slip.push(slip);
            columns.work.push(work);
            columns.friction.push(friction);
        }
        columns
    }
}

/// What a law takes at once.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Per {
    /// Any part of a motion: what two parts wear one after the other is what they wear as one, so that the depth grows
    /// in proportion to the slip, and to the work with it.
    Increment,
    /// What a point goes through in a cycle of the motion: a cycle of fretting, or a passage through the contact of
    /// bodies that roll. The pressure is the mean over the slip. Where surfaces that stay slide there is no cycle.
    Cycle,
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

    /// What it takes at once.
    fn per(&self) -> Per {
        Per::Increment
    }

    /// Depth (m) worn off this body by the rubbing; zero without pressure or slip, must not fall as either grows.
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
pub const WEAR_LAWS: &[Choice<Box<dyn WearLaw>>] = &[archard::CHOICE];
