//! The elliptic paraboloid, the shape of Hertz's theory.

use super::Profile;
use crate::parameters::{Bound, Choice, Invalid, Parameter, Quantity};

pub(super) const CHOICE: Choice<Box<dyn Profile>> = Choice {
    name: "paraboloid",
    meaning: "a surface with two radii of curvature; negative where it is hollow",
    parameters: &RADII,
    build: |values| {
        let radii = [values.require("radius_x")?, values.require("radius_y")?];
        Ok(Box::new(Paraboloid::new(radii)?))
    },
};

const RADII: [Parameter; 2] = [
    Parameter::required("radius_x", Quantity::Length, "radius of curvature along x")
        .bound(Bound::NonZero),
    Parameter::required("radius_y", Quantity::Length, "radius of curvature along y")
        .bound(Bound::NonZero),
];

/// recess = x^2 / (2 Rx) + y^2 / (2 Ry).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Paraboloid {
    /// 1/Rx and 1/Ry (1/m).
    curvatures: [f64; 2],
}

impl Paraboloid {
    /// A surface of these radii of curvature along x and y (m), negative where it is hollow.
    ///
    /// # Errors
    /// If a radius is zero.
    pub fn new(radii: [f64; 2]) -> Result<Self, Invalid> {
        let curvature = |axis: usize| RADII[axis].admit(radii[axis]).map(f64::recip);
        Ok(Self { curvatures: [curvature(0)?, curvature(1)?] })
    }
}

impl Profile for Paraboloid {
    fn recess(&self, x: f64, y: f64) -> f64 {
        0.5 * (self.curvatures[0] * x * x + self.curvatures[1] * y * y)
    }

    fn curvatures(&self) -> Option<[f64; 2]> {
        Some(self.curvatures)
    }
}
