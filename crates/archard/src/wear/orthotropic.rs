//! Archard's law with two axes, as of ground surfaces or fibres.
//!
//! depth = p sqrt((i1 s1)^2 + (i2 s2)^2), with s1 and s2 the slip along the axes: sliding along the first axis wears by i1,
//! across it by i2. With boundary elements, C. Julia and L. Rodriguez-Tembleque, *Int. J. Mech. Sci.* (2022), doi
//! 10.1016/j.ijmecsci.2022.107695.
//!
//! Limits: the axes keep their direction in the frame, as on flat surfaces and on bodies that roll along an axis.

use super::{Input, Rubbing, WearLaw};
use crate::parameters::{About, Bound, Choice, Invalid, Parameter, Quantity};

pub(super) const CHOICE: Choice<Box<dyn WearLaw>> = Choice {
    name: "orthotropic",
    meaning: "Archard with two axes: depth = p sqrt((i1 s1)^2 + (i2 s2)^2), s1 and s2 the slip along them; any motion",
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
    "C. Julia and L. Rodriguez-Tembleque, Int. J. Mech. Sci. (2022), doi 10.1016/j.ijmecsci.2022.107695",
    "{ coefficients = [\"1e-6 mm^3/(N m)\", \"3e-6 mm^3/(N m)\"], angle = \"30 deg\" }",
);

const COEFFICIENTS: Parameter = Parameter::required(
    "coefficients",
    Quantity::Pair(&Quantity::WearCoefficient),
    "wear coefficients i1 and i2 of slip along the first axis and across it",
)
.bound(Bound::NonNegative);
const ANGLE: Parameter = Parameter::optional(
    "angle",
    Quantity::Angle,
    "of the first axis from x, counterclockwise; 0 if not given",
)
.bound(Bound::Any);

/// depth = p sqrt((i1 s1)^2 + (i2 s2)^2).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Orthotropic {
    coefficients: [f64; 2],
    /// Unit vector of the first axis.
    axis: [f64; 2],
}

impl Orthotropic {
    /// The law with these wear coefficients (1/Pa), the first of slip along an axis at an angle (rad) from x,
    /// counterclockwise, the second of slip across it.
    ///
    /// # Errors
    /// If a coefficient is negative, or the angle not finite.
    pub fn new(coefficients: [f64; 2], angle: f64) -> Result<Self, Invalid> {
        for coefficient in coefficients {
            COEFFICIENTS.admit(coefficient)?;
        }
        let (sin, cos) = ANGLE.admit(angle)?.sin_cos();
        Ok(Self { coefficients, axis: [cos, sin] })
    }

    /// Depth (m) under a unit pressure (Pa).
    fn rate(&self, rubbing: &Rubbing) -> f64 {
        let ([x, y], [cos, sin]) = (rubbing.slip_vector, self.axis);
        let [first, second] = self.coefficients;
        (first * (cos * x + sin * y)).hypot(second * (cos * y - sin * x))
    }
}

impl WearLaw for Orthotropic {
    fn inputs(&self) -> &'static [Input] {
        &[Input::Vectors]
    }

    fn depth(&self, rubbing: Rubbing) -> f64 {
        match self.coefficients {
            // Archard's, to the last bit.
            [first, second] if first == second => first * rubbing.pressure * rubbing.slip,
            _ => self.rate(&rubbing) * rubbing.pressure,
        }
    }

    fn slope(&self, rubbing: Rubbing) -> f64 {
        match self.coefficients {
            [first, second] if first == second => first * rubbing.slip,
            _ => self.rate(&rubbing),
        }
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_6;

    use approx::assert_relative_eq;

    use super::super::{Rubbing, WearLaw};
    use super::Orthotropic;

    #[test]
    fn axes_wear_by_their_own_coefficients() {
        let law = Orthotropic::new([4e-13, 1e-13], FRAC_PI_6).unwrap();
        let depth = |degrees: f64| {
            let (sin, cos) = degrees.to_radians().sin_cos();
            let slips = [2.0 * cos, 2.0 * sin];
            law.depth(Rubbing::new(1e7, 2.0).with_vectors(slips, [0.0; 2]))
        };
        assert_relative_eq!(1e6 * depth(30.0), 8.0, max_relative = 1e-14);
        assert_relative_eq!(1e6 * depth(120.0), 2.0, max_relative = 1e-14);
        assert_relative_eq!(1e6 * depth(75.0), 34f64.sqrt(), max_relative = 1e-14);
    }

    #[test]
    fn equal_coefficients_are_archards() {
        let law = Orthotropic::new([2e-13; 2], 0.3).unwrap();
        let rubbing = Rubbing::new(3e8, 0.05).with_vectors([0.03, -0.04], [0.0; 2]);
        assert_relative_eq!(1e6 * law.depth(rubbing), 3.0, max_relative = 1e-14);
        let close = Orthotropic::new([2e-13, 2e-13 * (1.0 + 1e-15)], 0.3).unwrap();
        assert_relative_eq!(1e6 * close.depth(rubbing), 3.0, max_relative = 1e-14);
    }
}
