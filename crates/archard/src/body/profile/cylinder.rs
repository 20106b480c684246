//! The circular cylinder lying in the plane of contact.

use super::{Profile, circle_recess};
use crate::parameters::{Choice, Parameter, Quantity};

pub(super) const CHOICE: Choice<Box<dyn Profile>> = Choice {
    name: "cylinder",
    meaning: "a cylinder lying in the plane of contact",
    parameters: &[
        Parameter::required("radius", Quantity::Length, "radius of the cylinder"),
        Parameter::optional(
            "axis",
            Quantity::Word(&["x", "y"]),
            "direction of its axis; y if not given",
        ),
    ],
    build: |values| {
        Ok(Box::new(Cylinder {
            radius: values.require("radius")?,
            along_x: values.word("axis") == Some("x"),
        }))
    },
};

/// recess = R - sqrt(R^2 - d^2), d the distance from the axis.
#[derive(Debug)]
struct Cylinder {
    /// Radius (m).
    radius: f64,
    /// Whether the axis runs along x.
    along_x: bool,
}

impl Profile for Cylinder {
    fn recess(&self, x: f64, y: f64) -> f64 {
        circle_recess(self.radius, if self.along_x { y } else { x })
    }

    fn curvatures(&self) -> Option<[f64; 2]> {
        let curvature = 1.0 / self.radius;
        Some(if self.along_x { [0.0, curvature] } else { [curvature, 0.0] })
    }
}
