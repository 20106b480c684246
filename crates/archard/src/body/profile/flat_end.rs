//! The flat end of a round punch.

use super::Profile;
use crate::parameters::{Choice, Parameter, Quantity};

pub(super) const CHOICE: Choice<Box<dyn Profile>> = Choice {
    name: "flat_end",
    meaning: "a plane that ends at a circle, and beyond it lies deeper by the circle's radius",
    parameters: &[Parameter::required("radius", Quantity::Length, "radius of the end")],
    build: |values| Ok(Box::new(FlatEnd { radius: values.require("radius")? })),
};

/// recess = 0 up to the radius, the radius itself beyond: too deep to touch.
#[derive(Debug)]
struct FlatEnd {
    /// Radius of the end (m).
    radius: f64,
}

impl Profile for FlatEnd {
    fn recess(&self, x: f64, y: f64) -> f64 {
        if x.hypot(y) <= self.radius { 0.0 } else { self.radius }
    }
}
