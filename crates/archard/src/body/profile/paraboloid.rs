//! The elliptic paraboloid, the shape of Hertz's theory.

use super::Profile;
use crate::parameters::{Bound, Choice, Parameter, Quantity};

pub(super) const CHOICE: Choice<Box<dyn Profile>> = Choice {
    name: "paraboloid",
    meaning: "a surface with two radii of curvature; negative where it is hollow",
    parameters: &[
        Parameter::required("radius_x", Quantity::Length, "radius of curvature along x")
            .bound(Bound::Any),
        Parameter::required("radius_y", Quantity::Length, "radius of curvature along y")
            .bound(Bound::Any),
    ],
    build: |values| {
        let curvature = |name| match values.require(name)? {
            0.0 => Err(crate::parameters::Invalid::new(name, format!("`{name}` cannot be zero"))),
            radius => Ok(1.0 / radius),
        };
        Ok(Box::new(Paraboloid { curvatures: [curvature("radius_x")?, curvature("radius_y")?] }))
    },
};

/// recess = x^2 / (2 Rx) + y^2 / (2 Ry).
#[derive(Debug)]
struct Paraboloid {
    /// 1/Rx and 1/Ry (1/m).
    curvatures: [f64; 2],
}

impl Profile for Paraboloid {
    fn recess(&self, x: f64, y: f64) -> f64 {
        0.5 * (self.curvatures[0] * x * x + self.curvatures[1] * y * y)
    }

    fn curvatures(&self) -> Option<[f64; 2]> {
        Some(self.curvatures)
    }
}
