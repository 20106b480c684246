//! Bodies pressed and shifted against each other step by step, once or in cycles.

use std::f64::consts::TAU;

use super::{Control, Progress};
use crate::parameters::{Bound, Parameter, Quantity};

/// What guides the bodies along one direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Guide {
    /// The displacement of body 2 over body 1 (m); the force follows.
    Shift(f64),
    /// The force on body 1 (N); the displacement follows.
    Force(f64),
}

/// What holds the bodies at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Station {
    /// Load or approach.
    pub control: Control,
    /// What guides them along x and y.
    pub guides: [Guide; 2],
}

impl Station {
    /// Pressed together, not shifted.
    pub fn pressed(control: Control) -> Self {
        Self { control, guides: [Guide::Shift(0.0); 2] }
    }

    /// Pressed and guided by that share of all that another one is.
    pub fn share(self, share: f64) -> Self {
        let scaled = |guide: Guide| match guide {
            Guide::Shift(shift) => Guide::Shift(share * shift),
            Guide::Force(force) => Guide::Force(share * force),
        };
        Self { control: self.control.scaled(share), guides: self.guides.map(scaled) }
    }
}

/// A path of increments, gone through once or in cycles. Progress is measured in the motion's own unit.
#[derive(Debug, Clone, PartialEq)]
pub struct Shift {
    /// Ends of the increments that lead from rest to the first cycle; they count as no progress.
    pub lead: Vec<Station>,
    /// Ends of the increments of a cycle.
    pub cycle: Vec<Station>,
    /// Progress at each of them, from the beginning of the cycle on.
    pub places: Vec<f64>,
    /// Whether the bodies are taken apart before each cycle, without rubbing.
    pub released: bool,
    /// Whether all that a pair slips in an increment rubs under the pressure at its end, as in the paper's
    /// eqs. 48 and 53, instead of what it slips in contact under the mean pressure.
    pub end_pressure: bool,
    /// What progress is called.
    pub progress: Progress,
}

impl Shift {
    /// Progress of a whole cycle.
    pub fn period(&self) -> f64 {
        self.places.last().copied().unwrap_or(1.0)
    }

    /// Whether the bodies are guided anywhere.
    pub fn moves(&self) -> bool {
        let still = |guide: Guide| guide == Guide::Shift(0.0) || guide == Guide::Force(0.0);
        self.lead.iter().chain(&self.cycle).any(|station| !station.guides.into_iter().all(still))
    }

    /// The station at which the bodies are pressed together most.
    pub fn peak(&self) -> usize {
        let pressed = |station: &Station| match station.control {
            Control::Load(value) | Control::Approach(value) => value,
        };
        let mut peak = 0;
        for (index, station) in self.cycle.iter().enumerate() {
            // The last of equal ones, but for rounding: what a cycle ends with.
            if pressed(station) >= (1.0 - 1e-12) * pressed(&self.cycle[peak]) {
                peak = index;
            }
        }
        peak
    }
}

/// Cycles of a motion.
pub(super) const CYCLE_COUNT: Parameter =
    Parameter::optional("cycles", Quantity::Count, "number of cycles; 1 if not given");
/// Fixed jumps.
pub(super) const JUMP: Parameter = Parameter::optional(
    "jump",
    Quantity::Count,
    "cycles from one that is computed to the next; every cycle if neither this nor `tolerance` is given",
);
/// Jumps chosen by error.
pub(super) const JUMP_TOLERANCE: Parameter = Parameter::optional(
    "tolerance",
    Quantity::Number,
    "relative error allowed in the worn depths, to jump over cycles by",
)
.bound(Bound::Between(0.0, 1.0));

/// The sine of a share of a cycle, exact at its quarters.
pub(super) fn wave(index: usize, count: usize) -> f64 {
    match (4 * index).is_multiple_of(count).then(|| 4 * index / count % 4) {
        Some(0 | 2) => 0.0,
        Some(1) => 1.0,
        Some(_) => -1.0,
        None => (TAU * index as f64 / count as f64).sin(),
    }
}
