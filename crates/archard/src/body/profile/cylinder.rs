//! The circular cylinder lying in the plane of contact.

use super::{Profile, circle_recess};
use crate::parameters::{Bound, Choice, Invalid, Parameter, Quantity};

pub(super) const CHOICE: Choice<Box<dyn Profile>> = Choice {
    name: "cylinder",
    meaning: "a cylinder lying in the plane of contact, or a bore where the radius is negative",
    parameters: &[
        RADIUS,
        Parameter::optional(
            "axis",
            Quantity::Word(&["x", "y"]),
            "direction of its axis; y if not given",
        ),
    ],
    build: |values| {
        let radius = values.require("radius")?;
        let along_x = values.word("axis") == Some("x");
        Ok(Box::new(if along_x { Cylinder::along_x(radius) } else { Cylinder::along_y(radius) }?))
    },
};

const RADIUS: Parameter = Parameter::required(
    "radius",
    Quantity::Length,
    "radius of the cylinder; negative where it is hollow",
)
.bound(Bound::NonZero);

/// recess = R - sqrt(R^2 - d^2), d the distance from the apex; its negative in a bore.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cylinder {
    radius: f64,
    along_x: bool,
}

impl Cylinder {
    /// A cylinder of that radius (m), negative where it is hollow, whose axis runs along x.
    ///
    /// # Errors
    /// If the radius is zero.
    pub fn along_x(radius: f64) -> Result<Self, Invalid> {
        Ok(Self { radius: RADIUS.admit(radius)?, along_x: true })
    }

    /// A cylinder of that radius (m), negative where it is hollow, whose axis runs along y.
    ///
    /// # Errors
    /// If the radius is zero.
    pub fn along_y(radius: f64) -> Result<Self, Invalid> {
        Ok(Self { along_x: false, ..Self::along_x(radius)? })
    }
}

impl Profile for Cylinder {
    fn recess(&self, x: f64, y: f64) -> f64 {
        circle_recess(self.radius, if self.along_x { y } else { x })
    }

    fn extent(&self) -> [[f64; 2]; 2] {
        let half = self.radius.abs();
        let (across, along) = ([-half, half], [f64::NEG_INFINITY, f64::INFINITY]);
        if self.along_x { [along, across] } else { [across, along] }
    }

    fn curvatures(&self) -> Option<[f64; 2]> {
        let curvature = 1.0 / self.radius;
        Some(if self.along_x { [0.0, curvature] } else { [curvature, 0.0] })
    }
}
