//! Lengths of steps, chosen by an estimate of their error.
//!
//! A step is taken if its error is no more than what is allowed. The error of both orders that are compared grows with the square
//! of the length, so that the next length follows from the root of their ratio (Hairer, Norsett and Wanner, *Solving Ordinary
//! Differential Equations I*, 1993, II.4).

use serde::{Deserialize, Serialize};

/// How cautiously lengths change.
#[derive(Debug, Clone, Copy)]
pub struct Caution {
    /// The error that the next step aims at, relative to what is allowed.
    pub aim: f64,
    /// Least and largest change from one length to the next.
    pub change: [f64; 2],
    /// Largest change where a step is not taken.
    pub again: f64,
    /// Change after a step that could not be made.
    pub failed: f64,
}

/// Where the step before an output is shortened for it, or lengthened by as much, relative to its length.
const NEAR: f64 = 0.1;

/// The length of the next step.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Control {
    next: f64,
}

impl Control {
    /// The first step is that long.
    pub const fn first(length: f64) -> Self {
        Self { next: length }
    }

    /// The length of the next step.
    pub const fn next(&self) -> f64 {
        self.next
    }

    /// The length of a step that ends on a goal that far ahead, alone or with one more of its length, if it comes near it.
    pub fn towards(&self, ahead: f64) -> f64 {
        let count = (ahead / self.next - NEAR).ceil().max(1.0);
        if count <= 2.0 { ahead / count } else { self.next }
    }

    /// The next length after a step that could not be made.
    pub fn failed(&mut self, length: f64, caution: Caution) {
        self.next = caution.failed * length;
    }

    /// The next length after a step that is not taken.
    pub fn rejected(&mut self, length: f64, change: f64, caution: Caution) {
        self.next = length * change.min(caution.again);
    }

    /// The next length after a step that is taken. One that was shortened for an output says nothing against the length before.
    pub fn taken(&mut self, length: f64, change: f64) {
        let shortened = length < (1.0 - NEAR) * self.next && change >= 1.0;
        let next = change * length;
        self.next = if shortened { self.next.max(next) } else { next };
    }

    /// Is no shorter than that.
    pub fn at_least(&mut self, length: f64) {
        self.next = self.next.max(length);
    }
}

impl Caution {
    /// The change from a length to the next, by the error of a step relative to what is allowed and by the trend of the steps before.
    pub fn change(&self, excess: f64, trend: f64) -> f64 {
        let [least, most] = self.change;
        (trend * (self.aim / excess).sqrt()).clamp(least, most)
    }
}
