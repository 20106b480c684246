//! A surface of waves along x, along y, or both.

use std::f64::consts::PI;

use super::Profile;
use crate::parameters::{Bound, Choice, Invalid, Parameter, Quantity};

pub(super) const CHOICE: Choice<Box<dyn Profile>> = Choice {
    name: "wave",
    meaning: "waves of an amplitude and a length along x and y, with a crest in the middle",
    parameters: &[AMPLITUDE, LENGTH_X, LENGTH_Y],
    build: |values| {
        let lengths = ["length_x", "length_y"].map(|name| values.number(name));
        Ok(Box::new(Wave::new(values.require("amplitude")?, lengths)?))
    },
};

const AMPLITUDE: Parameter = Parameter::required(
    "amplitude",
    Quantity::Length,
    "half of the height from trough to crest, of the waves along each axis",
)
.bound(Bound::Positive);
const LENGTH_X: Parameter = Parameter::optional(
    "length_x",
    Quantity::Length,
    "length of the waves along x; none if not given",
);
const LENGTH_Y: Parameter = Parameter::optional(
    "length_y",
    Quantity::Length,
    "length of the waves along y; none if not given",
);

/// recess = a (1 - cos(2 pi x/lx)) + a (1 - cos(2 pi y/ly)).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wave {
    amplitude: f64,
    lengths: [Option<f64>; 2],
}

impl Wave {
    /// Waves of an amplitude (m) and of these lengths (m) along x and y, `None` where there are none.
    ///
    /// # Errors
    /// If one is not greater than zero, or neither length is given.
    pub fn new(amplitude: f64, [x, y]: [Option<f64>; 2]) -> Result<Self, Invalid> {
        if x.is_none() && y.is_none() {
            return Err(Invalid::new("length_x", "one of `length_x` and `length_y` is needed"));
        }
        let amplitude = AMPLITUDE.admit(amplitude)?;
        let x = x.map(|length| LENGTH_X.admit(length)).transpose()?;
        let y = y.map(|length| LENGTH_Y.admit(length)).transpose()?;
        Ok(Self { amplitude, lengths: [x, y] })
    }
}

impl Profile for Wave {
    fn recess(&self, x: f64, y: f64) -> f64 {
        // 1 - cos without cancellation.
        let below = |(length, at): (Option<f64>, f64)| {
            length.map_or(0.0, |length| 2.0 * (PI * at / length).sin().powi(2))
        };
        self.amplitude * self.lengths.into_iter().zip([x, y]).map(below).sum::<f64>()
    }
}
