//! What raises or lowers the limits of friction besides the pressure: their *grip*, a factor at each pair.

use serde::{Deserialize, Serialize};

use super::{Friction, Map};

/// What a law may go by besides the pressure.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Circumstance {
    /// Speed (m/s) at which the bodies slide over each other at the pair as rigid ones, whether it sticks or slips.
    Speed,
    /// Distance (m) that the points of the pair slid under pressure, of both the longer.
    Distance,
    /// Temperature of the surfaces (K).
    Temperature,
}

impl Circumstance {
    /// All of them.
    pub(super) const ALL: [Self; 3] = [Self::Speed, Self::Distance, Self::Temperature];

    /// What it is called.
    pub fn name(self) -> &'static str {
        match self {
            Self::Speed => "speed",
            Self::Distance => "distance",
            Self::Temperature => "temperature",
        }
    }
}

/// The circumstances of a pair; those that no law asks for may be zero.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Circumstances {
    /// Speed of the rigid bodies over each other (m/s).
    pub speed: f64,
    /// Distance slid so far (m).
    pub distance: f64,
    /// Temperature (K).
    pub temperature: f64,
}

/// Factors on the limits of friction, one a pair; one everywhere where the law depends on the pressure alone.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Grip(Vec<f64>);

impl Grip {
    /// Those of a law under circumstances, one a pair.
    pub fn of(law: &dyn Friction, pairs: impl Iterator<Item = Circumstances>) -> Self {
        Self(pairs.map(|pair| law.factor(pair)).collect())
    }

    /// The factor at a pair.
    pub fn at(&self, pair: usize) -> f64 {
        self.0.get(pair).copied().unwrap_or(1.0)
    }

    /// The same with all factors made into others at once.
    pub fn map(&self, change: impl FnOnce(&[f64]) -> Vec<f64>) -> Self {
        if self.0.is_empty() { Self::default() } else { Self(change(&self.0)) }
    }

    /// The greatest difference from another one.
    pub fn apart(&self, other: &Self) -> f64 {
        let apart = |(one, other): (&f64, &f64)| (one - other).abs();
        self.0.iter().zip(&other.0).map(apart).fold(0.0, f64::max)
    }

    /// That share of the way from here to another one.
    pub fn towards(&self, other: &Self, share: f64) -> Self {
        let part = |(one, other): (&f64, &f64)| one + share * (other - one);
        Self(self.0.iter().zip(&other.0).map(part).collect())
    }
}

/// The largest tangential tractions of pairs: those of a law, times the grip.
#[derive(Debug, Clone, Copy)]
pub struct Limits<'a> {
    law: &'a dyn Friction,
    grip: &'a Grip,
}

impl<'a> Limits<'a> {
    /// Of a law with a grip.
    pub fn new(law: &'a dyn Friction, grip: &'a Grip) -> Self {
        Self { law, grip }
    }

    /// Radius of the disc (Pa) of a pair under a pressure (Pa).
    pub fn at(&self, pair: usize, pressure: f64) -> f64 {
        self.grip.at(pair) * self.law.limit(pressure)
    }

    /// Derivative of it with respect to the pressure.
    pub fn slope(&self, pair: usize, pressure: f64) -> f64 {
        self.grip.at(pair) * self.law.slope(pressure)
    }

    /// Radii (Pa) of all pairs under pressures (Pa).
    pub fn all(&self, pressure: &[f64]) -> Vec<f64> {
        pressure.iter().enumerate().map(|(pair, &pressure)| self.at(pair, pressure)).collect()
    }

    /// What makes ellipses of the discs.
    pub fn map(&self) -> Map {
        self.law.map()
    }
}
