//! The disc of a twin-disc machine: it rolls along x and may be crowned across.

use super::{Profile, circle_recess};
use crate::parameters::{Choice, Invalid, Parameter, Quantity};

pub(super) const CHOICE: Choice<Box<dyn Profile>> = Choice {
    name: "disc",
    meaning: "a disc rolling along x, its rim flat or crowned along y",
    parameters: &[RADIUS, CROWN],
    build: |values| {
        let radius = values.require("radius")?;
        Ok(Box::new(match values.number("crown") {
            Some(crown) => Disc::crowned(radius, crown)?,
            None => Disc::new(radius)?,
        }))
    },
};

const RADIUS: Parameter = Parameter::required("radius", Quantity::Length, "rolling radius");
const CROWN: Parameter =
    Parameter::optional("crown", Quantity::Length, "radius of the crown; none: a flat rim");

/// Sum of the recesses of the rolling circle along x and of the crown along y.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Disc {
    radius: f64,
    crown: Option<f64>,
}

impl Disc {
    /// A disc of that rolling radius (m) with a flat rim.
    ///
    /// # Errors
    /// If the radius is not greater than zero.
    pub fn new(radius: f64) -> Result<Self, Invalid> {
        Ok(Self { radius: RADIUS.admit(radius)?, crown: None })
    }

    /// A disc of that rolling radius (m) with a crown of that radius (m).
    ///
    /// # Errors
    /// If a radius is not greater than zero.
    pub fn crowned(radius: f64, crown: f64) -> Result<Self, Invalid> {
        Ok(Self { crown: Some(CROWN.admit(crown)?), ..Self::new(radius)? })
    }
}

impl Profile for Disc {
    fn recess(&self, x: f64, y: f64) -> f64 {
        circle_recess(self.radius, x) + self.crown.map_or(0.0, |crown| circle_recess(crown, y))
    }

    fn extent(&self) -> [[f64; 2]; 2] {
        let crown = self.crown.unwrap_or(f64::INFINITY);
        [[-self.radius, self.radius], [-crown, crown]]
    }

    fn curvatures(&self) -> Option<[f64; 2]> {
        Some([1.0 / self.radius, self.crown.map_or(0.0, |crown| 1.0 / crown)])
    }
}
