//! The flat end of a round punch, or of a ring.

use super::Profile;
use crate::parameters::{Choice, Invalid, Parameter, Quantity};

pub(super) const CHOICE: Choice<Box<dyn Profile>> = Choice {
    name: "flat_end",
    meaning: "a plane that ends at a circle, and beyond it, or in a hole, lies deeper by the circle's radius",
    parameters: &[RADIUS, HOLE],
    build: |values| {
        let end = FlatEnd::new(values.require("radius")?)?;
        Ok(Box::new(match values.number("hole") {
            Some(hole) => end.with_hole(hole)?,
            None => end,
        }))
    },
};

const RADIUS: Parameter = Parameter::required("radius", Quantity::Length, "radius of the end");

const HOLE: Parameter = Parameter::optional(
    "hole",
    Quantity::Length,
    "radius of a hole in the middle, as in a thrust washer; none if not given",
);

/// recess = 0 from the hole to the radius, the radius itself elsewhere: too deep to touch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FlatEnd {
    radius: f64,
    hole: f64,
}

impl FlatEnd {
    /// An end of that radius (m).
    ///
    /// # Errors
    /// If the radius is not greater than zero.
    pub fn new(radius: f64) -> Result<Self, Invalid> {
        Ok(Self { radius: RADIUS.admit(radius)?, hole: 0.0 })
    }

    /// The same with a hole of that radius (m) in the middle.
    ///
    /// # Errors
    /// If the radius is not greater than zero, or not less than that of the end.
    pub fn with_hole(self, radius: f64) -> Result<Self, Invalid> {
        let hole = HOLE.admit(radius)?;
        if hole >= self.radius {
            return Err(Invalid::new("hole", "is as large as the end").beside("radius"));
        }
        Ok(Self { hole, ..self })
    }
}

impl Profile for FlatEnd {
    fn recess(&self, x: f64, y: f64) -> f64 {
        if (self.hole..=self.radius).contains(&x.hypot(y)) { 0.0 } else { self.radius }
    }

    fn sharpest(&self) -> f64 {
        0.0
    }
}
