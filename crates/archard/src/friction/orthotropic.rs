//! Friction with two axes, as of ground surfaces or fibres: an ellipse of admissible tractions.
//!
//! With t_1, t_2 the tractions along the axes, (t_1 / mu_1)^2 + (t_2 / mu_2)^2 <= p^2, and where a pair slips the slip is
//! normal to the ellipse, s parallel to (t_1 / mu_1^2, t_2 / mu_2^2): the slip of maximum dissipation. Z. Mroz and
//! S. Stupkiewicz, *Int. J. Solids Struct.* 31 (1994) 1113; with boundary elements, C. Julia and L. Rodriguez-Tembleque, *Int.
//! J. Mech. Sci.* (2022), doi 10.1016/j.ijmecsci.2022.107695.

use super::{Friction, Map};
use crate::parameters::{About, Bound, Choice, Invalid, Parameter, Quantity};

pub(super) const CHOICE: Choice<Box<dyn Friction>> = Choice {
    name: "orthotropic",
    meaning: "an ellipse: the largest traction is mu1 times the pressure along one axis, mu2 times across; any motion",
    parameters: &[COEFFICIENTS, ANGLE],
    build: |values| {
        let coefficients = values
            .pair("coefficients")
            .ok_or_else(|| Invalid::new("coefficients", "`coefficients` is missing"))?;
        Ok(Box::new(Orthotropic::new(coefficients, values.number("angle").unwrap_or(0.0))?))
    },
};

pub(super) const ABOUT: About = About::new(
    CHOICE.name,
    "Z. Mroz and S. Stupkiewicz, Int. J. Solids Struct. 31 (1994) 1113; C. Julia and L. Rodriguez-Tembleque, Int. J. Mech. Sci. (2022), doi 10.1016/j.ijmecsci.2022.107695",
    "{ coefficients = [0.2, 0.4], angle = \"30 deg\" }",
);

const COEFFICIENTS: Parameter = Parameter::required(
    "coefficients",
    Quantity::Pair(&Quantity::Number),
    "coefficients of friction mu1 and mu2 along the first axis and across it",
);
const ANGLE: Parameter = Parameter::optional(
    "angle",
    Quantity::Angle,
    "of the first axis from x, counterclockwise; 0 if not given",
)
.bound(Bound::Any);

/// The largest ratio of the coefficients: solvers of friction take many more iterations beyond.
const MOST: f64 = 100.0;

/// limit = sqrt(mu1 mu2) p, the radius of the disc of the same area.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Orthotropic {
    /// sqrt(mu1 mu2).
    mean: f64,
    /// To the ellipse from that disc.
    map: Map,
}

impl Orthotropic {
    /// The law with these coefficients of friction, the first of them along an axis at an angle (rad) from x,
    /// counterclockwise, the second across it.
    ///
    /// # Errors
    /// If a coefficient is not greater than zero, or one is more than 100 times the other.
    pub fn new(coefficients: [f64; 2], angle: f64) -> Result<Self, Invalid> {
        for coefficient in coefficients {
            COEFFICIENTS.admit(coefficient)?;
        }
        let [first, second] = coefficients;
        if first.max(second) > MOST * first.min(second) {
            let message = format!("one is more than {MOST} times the other");
            return Err(Invalid::new("coefficients", message));
        }
        let mean = (first * second).sqrt();
        let map = Map::ellipse([first / mean, second / mean], ANGLE.admit(angle)?);
        Ok(Self { mean, map })
    }
}

impl Friction for Orthotropic {
    fn limit(&self, pressure: f64) -> f64 {
        self.mean * pressure
    }

    fn slope(&self, _pressure: f64) -> f64 {
        self.mean
    }

    fn map(&self) -> Map {
        self.map
    }
}
