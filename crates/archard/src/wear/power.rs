//! A power law of the pressure and the speed.
//!
//! depth = k p0 (p / p0)^m (v / v0)^n s, Archard's law where m = 1 and n = 0: the generalised Archard equation of
//! finite element programs (Ansys, `TB,WEAR,ARCD`; COMSOL Multiphysics, node *Wear*), whose rate of depth is
//! (K / H) p^m v^(n + 1) with n counted here beyond the distance.
//!
//! Limits: where m < 1 the formula rises infinitely steep at p = 0. Below a thousandth of p0 the depth is then a straight
//! line through zero, which wears less than the formula there.

use super::{Input, Rubbing, WearLaw};
use crate::parameters::{About, Bound, Choice, Invalid, Parameter, Quantity};

pub(super) const CHOICE: Choice<Box<dyn WearLaw>> = Choice {
    name: "power",
    meaning: "powers of pressure and speed: depth = k p0 (p / p0)^m (v / v0)^n s, Archard's with m = 1 and n = 0; any motion, with a speed exponent one at a known speed",
    parameters: &[
        COEFFICIENT,
        PRESSURE_EXPONENT,
        REFERENCE_PRESSURE,
        SPEED_EXPONENT,
        REFERENCE_SPEED,
    ],
    build: |values| {
        let [coefficient, exponent, reference] =
            ["coefficient", "pressure_exponent", "reference_pressure"]
                .map(|name| values.require(name));
        let law = Power::new(coefficient?, exponent?, reference?)?;
        Ok(Box::new(match ["speed_exponent", "reference_speed"].map(|name| values.number(name)) {
            [None, None] => law,
            [Some(exponent), Some(reference)] => law.with_speed(exponent, reference)?,
            [Some(_), None] => {
                let message = "`speed_exponent` needs `reference_speed`, too";
                return Err(Invalid::new("speed_exponent", message));
            }
            [None, Some(_)] => {
                let message = "has no effect without a `speed_exponent`";
                return Err(Invalid::new("reference_speed", message));
            }
        }))
    },
};

pub(super) const ABOUT: About = About::new(
    CHOICE.name,
    "the generalised Archard equation of finite element programs (Ansys TB,WEAR,ARCD; COMSOL Multiphysics, node Wear)",
    "{ coefficient = \"1e-6 mm^3/(N m)\", pressure_exponent = 1.5, reference_pressure = \"500 MPa\" }",
);

const COEFFICIENT: Parameter = Parameter::required(
    "coefficient",
    Quantity::WearCoefficient,
    "wear coefficient k at the reference pressure and speed",
)
.bound(Bound::NonNegative);
const PRESSURE_EXPONENT: Parameter =
    Parameter::required("pressure_exponent", Quantity::Number, "exponent m of the pressure")
        .bound(Bound::UpTo(0.0, 20.0));
const REFERENCE_PRESSURE: Parameter =
    Parameter::required("reference_pressure", Quantity::Pressure, "pressure p0 at which k holds");
const SPEED_EXPONENT: Parameter = Parameter::optional(
    "speed_exponent",
    Quantity::Number,
    "exponent n of the speed of sliding, the distance apart; 0 if not given",
)
.bound(Bound::Between(-20.0, 20.0));
const REFERENCE_SPEED: Parameter =
    Parameter::optional("reference_speed", Quantity::Speed, "speed v0 at which k holds");

/// Pressure over the reference below which a depth that rises infinitely steep is replaced by a straight line.
const LEAST: f64 = 1e-3;

/// depth = k p0 (p / p0)^m (v / v0)^n s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Power {
    coefficient: f64,
    /// m and p0 (Pa).
    pressure: [f64; 2],
    /// n and v0 (m/s).
    speed: Option<[f64; 2]>,
}

impl Power {
    /// The law with the wear coefficient k (1/Pa) at a reference pressure (Pa), and the exponent m of the pressure.
    ///
    /// # Errors
    /// If the coefficient is negative, the exponent not greater than 0 or beyond 20, or the reference not greater than 0.
    pub fn new(coefficient: f64, exponent: f64, reference: f64) -> Result<Self, Invalid> {
        Ok(Self {
            coefficient: COEFFICIENT.admit(coefficient)?,
            pressure: [PRESSURE_EXPONENT.admit(exponent)?, REFERENCE_PRESSURE.admit(reference)?],
            speed: None,
        })
    }

    /// The same law that depends on the speed too, with an exponent n, and the speed (m/s) at which k holds.
    ///
    /// # Errors
    /// If the exponent is not between -20 and 20, or the speed not greater than zero.
    pub fn with_speed(self, exponent: f64, reference: f64) -> Result<Self, Invalid> {
        let speed = [SPEED_EXPONENT.admit(exponent)?, REFERENCE_SPEED.admit(reference)?];
        Ok(Self { speed: Some(speed), ..self })
    }

    /// Depth at the reference pressure (m), per unit of it (m/Pa).
    fn scale(&self, rubbing: Rubbing) -> f64 {
        let speed = match self.speed {
            Some([exponent, reference]) if rubbing.slip > 0.0 => {
                (rubbing.speed / reference).powf(exponent)
            }
            _ => 1.0,
        };
        self.coefficient * speed * rubbing.slip
    }
}

impl WearLaw for Power {
    fn inputs(&self) -> &'static [Input] {
        if self.speed.is_some() { &[Input::Speed] } else { &[] }
    }

    fn depth(&self, rubbing: Rubbing) -> f64 {
        let [exponent, reference] = self.pressure;
        let ratio = rubbing.pressure / reference;
        let power = if exponent < 1.0 && ratio < LEAST {
            LEAST.powf(exponent - 1.0) * ratio
        } else {
            ratio.powf(exponent)
        };
        self.scale(rubbing) * reference * power
    }

    fn slope(&self, rubbing: Rubbing) -> f64 {
        let [exponent, reference] = self.pressure;
        let ratio = rubbing.pressure / reference;
        let slope = if exponent < 1.0 && ratio < LEAST {
            LEAST.powf(exponent - 1.0)
        } else {
            exponent * ratio.powf(exponent - 1.0)
        };
        self.scale(rubbing) * slope
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::super::{Archard, Input, Rubbing, WearLaw};
    use super::Power;

    #[test]
    fn with_an_exponent_of_one_it_is_archards() {
        let (power, archard) = (Power::new(1e-13, 1.0, 3e7).unwrap(), Archard::new(1e-13).unwrap());
        for pressure in [0.0, 1e3, 1e8, 2e9] {
            let rubbing = Rubbing::new(pressure, 0.3);
            let [one, other] = [power.depth(rubbing), archard.depth(rubbing)].map(|d| 1e9 * d);
            assert_relative_eq!(one, other, max_relative = 1e-14);
            assert_relative_eq!(1e13 * power.slope(rubbing), 0.3, max_relative = 1e-14);
        }
    }

    /// k p0 (p / p0)^m (v / v0)^n s: four times the pressure and twice the speed, 4^1.5 / 2.
    #[test]
    fn pressure_and_speed_have_exponents() {
        let law = Power::new(1e-13, 1.5, 1e8).unwrap().with_speed(-1.0, 0.1).unwrap();
        assert_eq!(law.inputs(), [Input::Speed]);
        let depth = law.depth(Rubbing::new(4e8, 2.0).at_speed(0.2));
        assert_relative_eq!(1e5 * depth, 1e5 * 1e-13 * 1e8 * 8.0 * 0.5 * 2.0, max_relative = 1e-14);
        assert_eq!(law.depth(Rubbing::new(4e8, 0.0)), 0.0);
    }

    /// Below a thousandth of p0 a straight line that meets the formula there.
    #[test]
    fn a_slope_without_end_is_capped() {
        let law = Power::new(1.0, 0.5, 1.0).unwrap();
        let depth = |pressure| law.depth(Rubbing::new(pressure, 1.0));
        assert_relative_eq!(depth(1e-3), 1e-3f64.sqrt(), max_relative = 1e-14);
        assert_relative_eq!(depth(0.5e-3), 0.5 * 1e-3f64.sqrt(), max_relative = 1e-14);
        assert_relative_eq!(law.slope(Rubbing::new(0.0, 1.0)), 1e3f64.sqrt(), max_relative = 1e-14);
        assert_eq!(depth(0.0), 0.0);
    }

    #[test]
    fn without_an_exponent_pressure_would_not_matter() {
        assert!(Power::new(1e-13, 0.0, 1e8).is_err());
        assert!(Power::new(1e-13, -1.0, 1e8).is_err());
    }
}
