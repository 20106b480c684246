//! The flat end of a round punch.

use super::Profile;
use crate::parameters::{Choice, Invalid, Parameter, Quantity};

pub(super) const CHOICE: Choice<Box<dyn Profile>> = Choice {
    name: "flat_end",
    meaning: "a plane that ends at a circle, and beyond it lies deeper by the circle's radius",
    parameters: &[RADIUS],
    build: |values| Ok(Box::new(FlatEnd::new(values.require("radius")?)?)),
};

const RADIUS: Parameter = Parameter::required("radius", Quantity::Length, "radius of the end");

/// recess = 0 up to the radius, the radius itself beyond: too deep to touch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FlatEnd {
    radius: f64,
}

impl FlatEnd {
    /// An end of that radius (m).
    ///
    /// # Errors
    /// If the radius is not greater than zero.
    pub fn new(radius: f64) -> Result<Self, Invalid> {
        Ok(Self { radius: RADIUS.admit(radius)? })
    }
}

impl Profile for FlatEnd {
    fn recess(&self, x: f64, y: f64) -> f64 {
        if x.hypot(y) <= self.radius { 0.0 } else { self.radius }
    }

    fn sharpest(&self) -> f64 {
        0.0
    }
}
