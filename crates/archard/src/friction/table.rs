//! Coulomb's law with a coefficient from a table: over the pressure, the speed, the distance slid or the temperature.
//!
//! limit = mu(x) p, mu straight between the points of the table and held beyond the first and the last. Finite element
//! programs tabulate it in the same way (Abaqus, *frictional behavior*).
//!
//! Limits: over the pressure, the limit must not fall as the pressure grows. What else it depends on is said at
//! [`Circumstance`].

use super::{Circumstance, Circumstances, Friction};
use crate::numerics::piecewise::Piecewise;
use crate::parameters::{About, Choice, Invalid, Parameter, Quantity};

pub(super) const CHOICE: Choice<Box<dyn Friction>> = Choice {
    name: "table",
    meaning: "Coulomb with a coefficient from a table over the pressure, the speed at which the bodies slide over each other, the distance points have slid or the temperature: the largest traction is mu p; any motion that gives it",
    parameters: &[Parameter::required(
        "file",
        Quantity::Table(&[
            ("coefficient", Quantity::Number),
            ("pressure", Quantity::Pressure),
            ("speed", Quantity::Speed),
            ("distance", Quantity::Length),
            ("temperature", Quantity::Temperature),
        ]),
        "CSV with the columns `coefficient` and `pressure`, `speed`, `distance` or `temperature`, its unit in the header",
    )],
    build: |values| {
        let columns = values.table("file").unwrap_or_default();
        let column = |name: &str| columns.iter().find(|known| known.0 == name);
        let pressures = column("pressure").map(|column| (None, column));
        let over = |one: Circumstance| Some((Some(one), column(one.name())?));
        let given = pressures.or_else(|| Circumstance::ALL.into_iter().find_map(over));
        match (columns.len(), column("coefficient"), given) {
            (2, Some((_, coefficients)), Some((over, (_, places)))) => {
                Ok(Box::new(Table::read(over, places, coefficients)?))
            }
            _ => Err(wrong(
                "the columns must be `coefficient` and one of `pressure`, `speed`, `distance`, `temperature`",
            )),
        }
    },
};

pub(super) const ABOUT: About = About::new(
    CHOICE.name,
    "Coulomb's law with a tabulated coefficient, as finite element programs have it (Abaqus, frictional behavior)",
    "{ file = \"mu.csv\" }",
)
.reading(&[("mu.csv", "pressure_MPa,coefficient\n0,0.5\n1000,0.3\n")]);

/// limit = mu(x) p.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    coefficients: Piecewise,
    /// What it goes over; `None` for the pressure.
    over: Option<Circumstance>,
}

impl Table {
    /// The law with coefficients of friction at rising pressures (Pa).
    ///
    /// # Errors
    /// If the lists differ in length or are empty, a number is not finite or negative, pressures do not rise, or the limit
    /// of friction falls as the pressure grows.
    pub fn new(pressures: &[f64], coefficients: &[f64]) -> Result<Self, Invalid> {
        Self::read(None, pressures, coefficients)
    }

    /// The law with coefficients of friction at rising speeds (m/s), distances (m) or temperatures (K).
    ///
    /// # Errors
    /// If the lists differ in length or are empty, a number is not finite or negative, or places do not rise.
    pub fn over(
        circumstance: Circumstance,
        places: &[f64],
        coefficients: &[f64],
    ) -> Result<Self, Invalid> {
        Self::read(Some(circumstance), places, coefficients)
    }

    fn read(
        over: Option<Circumstance>,
        places: &[f64],
        coefficients: &[f64],
    ) -> Result<Self, Invalid> {
        let name = over.map_or("pressure", Circumstance::name);
        let about = |error| wrong(format!("the columns `{name}` and `coefficient`: {error}"));
        let coefficients = Piecewise::new(places, coefficients).map_err(about)?;
        if let (None, Some(pressure)) = (over, coefficients.falling_product()) {
            return Err(wrong(format!(
                "the coefficient falls faster than the pressure grows, below {pressure:e} Pa: more pressure would bear less"
            )));
        }
        Ok(Self { coefficients, over })
    }
}

impl Friction for Table {
    fn limit(&self, pressure: f64) -> f64 {
        if self.over.is_some() { pressure } else { self.coefficients.at(pressure) * pressure }
    }

    fn slope(&self, pressure: f64) -> f64 {
        if self.over.is_some() {
            return 1.0;
        }
        (self.coefficients.at(pressure) + self.coefficients.slope(pressure) * pressure).max(0.0)
    }

    fn inputs(&self) -> &[Circumstance] {
        self.over.as_slice()
    }

    fn factor(&self, at: Circumstances) -> f64 {
        let place = match self.over {
            None => return 1.0,
            Some(Circumstance::Speed) => at.speed,
            Some(Circumstance::Distance) => at.distance,
            Some(Circumstance::Temperature) => at.temperature,
        };
        self.coefficients.at(place)
    }
}

fn wrong(message: impl Into<String>) -> Invalid {
    Invalid::new("file", message)
}

#[cfg(test)]
mod tests {
    use super::super::Friction;
    use super::Table;

    /// mu = 0.6 - 0.1 p between 1 and 3.
    #[test]
    fn the_coefficient_is_that_of_the_table() {
        let law = Table::new(&[1.0, 3.0], &[0.5, 0.3]).unwrap();
        assert_eq!(law.limit(0.5), 0.25);
        assert!((law.limit(2.0) - 0.8).abs() < 1e-15);
        assert!((law.slope(2.0) - 0.2).abs() < 1e-15);
        assert!((law.limit(4.0) - 1.2).abs() < 1e-15);
        assert!(Table::new(&[1.0, 3.0], &[0.5, 0.1]).is_err());
    }
}
