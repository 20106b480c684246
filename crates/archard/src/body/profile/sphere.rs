//! The exact sphere.

use super::{Profile, circle_recess};
use crate::parameters::{Choice, Parameter, Quantity};

pub(super) const CHOICE: Choice<Box<dyn Profile>> = Choice {
    name: "sphere",
    meaning: "a ball or a spherical end",
    parameters: &[Parameter::required("radius", Quantity::Length, "radius of the sphere")],
    build: |values| Ok(Box::new(Sphere { radius: values.require("radius")? })),
};

/// recess = R - sqrt(R^2 - r^2).
#[derive(Debug)]
struct Sphere {
    /// Radius (m).
    radius: f64,
}

impl Profile for Sphere {
    fn recess(&self, x: f64, y: f64) -> f64 {
        circle_recess(self.radius, x.hypot(y))
    }

    fn curvatures(&self) -> Option<[f64; 2]> {
        Some([1.0 / self.radius; 2])
    }
}
