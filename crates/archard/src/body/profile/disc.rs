//! The disc of a twin-disc machine: it rolls along x and may be crowned across.

use super::{Profile, circle_recess};
use crate::parameters::{Choice, Parameter, Quantity};

pub(super) const CHOICE: Choice<Box<dyn Profile>> = Choice {
    name: "disc",
    meaning: "a disc rolling along x, its rim flat or crowned along y",
    parameters: &[
        Parameter::required("radius", Quantity::Length, "rolling radius"),
        Parameter::optional("crown", Quantity::Length, "radius of the crown; none: a flat rim"),
    ],
    build: |values| {
        Ok(Box::new(Disc { radius: values.require("radius")?, crown: values.number("crown") }))
    },
};

/// Sum of the recesses of the rolling circle along x and of the crown along y.
#[derive(Debug)]
struct Disc {
    /// Rolling radius (m).
    radius: f64,
    /// Radius of the crown (m), if it has one.
    crown: Option<f64>,
}

impl Profile for Disc {
    fn recess(&self, x: f64, y: f64) -> f64 {
        circle_recess(self.radius, x) + self.crown.map_or(0.0, |crown| circle_recess(crown, y))
    }

    fn curvatures(&self) -> Option<[f64; 2]> {
        Some([1.0 / self.radius, self.crown.map_or(0.0, |crown| 1.0 / crown)])
    }
}
