//! The exact sphere.

use std::f64::consts::FRAC_1_SQRT_2;

use super::{Profile, circle_recess};
use crate::parameters::{Bound, Choice, Invalid, Parameter, Quantity};

pub(super) const CHOICE: Choice<Box<dyn Profile>> = Choice {
    name: "sphere",
    meaning: "a ball or a spherical end, or a spherical socket where the radius is negative",
    parameters: &[RADIUS],
    build: |values| Ok(Box::new(Sphere::new(values.require("radius")?)?)),
};

const RADIUS: Parameter = Parameter::required(
    "radius",
    Quantity::Length,
    "radius of the sphere; negative where it is hollow",
)
.bound(Bound::NonZero);

/// recess = R - sqrt(R^2 - r^2); its negative in a hollow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sphere {
    radius: f64,
}

impl Sphere {
    /// A sphere of that radius (m), negative where it is hollow.
    ///
    /// # Errors
    /// If the radius is zero.
    pub fn new(radius: f64) -> Result<Self, Invalid> {
        Ok(Self { radius: RADIUS.admit(radius)? })
    }
}

impl Profile for Sphere {
    fn recess(&self, x: f64, y: f64) -> f64 {
        circle_recess(self.radius, x.hypot(y))
    }

    fn extent(&self) -> [[f64; 2]; 2] {
        let half = self.radius.abs() * FRAC_1_SQRT_2;
        [[-half, half]; 2]
    }

    fn curvatures(&self) -> Option<[f64; 2]> {
        Some([1.0 / self.radius; 2])
    }
}
