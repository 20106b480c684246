//! What the progress of a motion is, and how it is shown.

use crate::parameters::Quantity;

/// How the progress of a motion is called and shown.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Progress {
    /// What it is, for people: "distance".
    pub name: &'static str,
    /// The result column, unit included: "distance_m".
    pub column: &'static str,
    /// What it measures.
    pub quantity: Quantity,
}

impl Progress {
    /// Distance slid (m).
    pub const DISTANCE: Self =
        Self { name: "distance", column: "distance_m", quantity: Quantity::Length };
    /// Revolutions of body 1.
    pub const REVOLUTIONS: Self =
        Self { name: "revolution", column: "revolutions", quantity: Quantity::Number };
    /// Cycles gone through.
    pub const CYCLES: Self = Self { name: "cycle", column: "cycle", quantity: Quantity::Number };
    /// Time (s).
    pub const TIME: Self = Self { name: "time", column: "time_s", quantity: Quantity::Time };
    /// Share of what is raised: a load, an approach, creepages.
    pub const SHARE: Self = Self { name: "share", column: "share", quantity: Quantity::Number };
    /// What the progress of some motion is.
    pub const ALL: [Self; 5] =
        [Self::DISTANCE, Self::REVOLUTIONS, Self::CYCLES, Self::TIME, Self::SHARE];

    /// A value of it (SI) in words: "distance 0.05 m".
    pub fn at(&self, value: f64) -> String {
        format!("{} {}", self.name, self.length(value))
    }

    /// A difference of two values (SI) in words: "0.05 m".
    pub fn length(&self, value: f64) -> String {
        // Seven digits: a sum of steps is not shown with what rounding made of it.
        let rounded: f64 = format!("{value:.6e}").parse().unwrap_or(value);
        match self.quantity {
            Quantity::Length => format!("{rounded:?} m"),
            Quantity::Time => format!("{rounded:?} s"),
            _ => format!("{rounded:?}"),
        }
    }
}
