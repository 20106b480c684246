//! Archard's law with a coefficient from a table.
//!
//! k is known at points of one quantity: the distance that a point has slid, the depth it has worn, the pressure, the
//! speed or the temperature. It is straight between them and held beyond the first and the last. Over the distance it is integrated exactly;
//! over the depth it is that before the step. Finite element programs tabulate it in the same way (Abaqus, *surface wear*).
//!
//! Limits: over the depth a step has to be short against the depths of the table. Over the pressure the depth must not fall
//! as the pressure grows.

use super::{Input, Rubbing, WearLaw};
use crate::numerics::piecewise::Piecewise;
use crate::parameters::{About, Choice, Invalid, Parameter, Quantity};

pub(super) const CHOICE: Choice<Box<dyn WearLaw>> = Choice {
    name: "table",
    meaning: "Archard with a coefficient from a table over distance, depth, pressure, speed or temperature: depth = k p s; any motion that supplies it",
    parameters: &[Parameter::required(
        "file",
        Quantity::Table(&[
            ("coefficient", Quantity::WearCoefficient),
            ("distance", Quantity::Length),
            ("depth", Quantity::Length),
            ("pressure", Quantity::Pressure),
            ("speed", Quantity::Speed),
            ("temperature", Quantity::Temperature),
        ]),
        "CSV with a column `coefficient` and one of `distance`, `depth`, `pressure`, `speed` and `temperature`, units in the header",
    )],
    build: |values| {
        let columns = values.table("file").unwrap_or_default();
        let column = |name: &str| columns.iter().find(|known| known.0 == name);
        let mut given = Over::ALL.into_iter().filter_map(|over| Some((over, column(over.name())?)));
        match (columns.len(), column("coefficient"), given.next()) {
            (2, Some((_, coefficients)), Some((over, (_, places)))) => {
                Ok(Box::new(Table::new(over, places, coefficients)?))
            }
            _ => Err(wrong(
                "the columns must be `coefficient` and one of `distance`, `depth`, `pressure`, `speed` and `temperature`",
            )),
        }
    },
};

pub(super) const ABOUT: About = About::new(
    CHOICE.name,
    "Archard's law with a tabulated coefficient, as finite element programs have it (Abaqus, surface wear)",
    "{ file = \"k.csv\" }",
)
.reading(&[("k.csv", "distance_m,coefficient_1/Pa\n0,1e-14\n100,1e-15\n")]);

/// What a wear coefficient is tabulated over.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Over {
    /// The distance that a point has slid under pressure (m).
    Distance,
    /// The depth that it has worn (m).
    Depth,
    /// The pressure (Pa).
    Pressure,
    /// The speed of sliding (m/s).
    Speed,
    /// The temperature of the surfaces (K).
    Temperature,
}

impl Over {
    /// All of them.
    const ALL: [Self; 5] =
        [Self::Distance, Self::Depth, Self::Pressure, Self::Speed, Self::Temperature];

    /// The name of its column.
    fn name(self) -> &'static str {
        match self {
            Self::Distance => "distance",
            Self::Depth => "depth",
            Self::Pressure => "pressure",
            Self::Speed => "speed",
            Self::Temperature => "temperature",
        }
    }
}

/// depth = k p s, k from a table.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    over: Over,
    coefficients: Piecewise,
}

impl Table {
    /// The law with wear coefficients (1/Pa) at rising places (m, Pa, m/s or K).
    ///
    /// # Errors
    /// If the lists differ in length or are empty, a number is not finite or negative, places do not rise, or the
    /// coefficient falls faster than the pressure grows.
    pub fn new(over: Over, places: &[f64], coefficients: &[f64]) -> Result<Self, Invalid> {
        let about =
            |error| wrong(format!("the columns `{}` and `coefficient`: {error}", over.name()));
        let coefficients = Piecewise::new(places, coefficients).map_err(about)?;
        if let Some(pressure) = coefficients.falling_product().filter(|_| over == Over::Pressure) {
            return Err(wrong(format!(
                "the coefficient falls faster than the pressure grows, below {pressure:e} Pa: more pressure would wear less"
            )));
        }
        Ok(Self { over, coefficients })
    }

    /// Depth under a unit pressure (m/Pa).
    fn of_unit_pressure(&self, rubbing: Rubbing) -> f64 {
        let Rubbing { pressure, slip, speed, temperature, distance, depth, .. } = rubbing;
        match self.over {
            Over::Distance => self.coefficients.integral(distance, slip),
            Over::Depth => self.coefficients.at(depth) * slip,
            Over::Pressure => self.coefficients.at(pressure) * slip,
            Over::Speed => self.coefficients.at(speed) * slip,
            Over::Temperature => self.coefficients.at(temperature) * slip,
        }
    }
}

impl WearLaw for Table {
    fn inputs(&self) -> &'static [Input] {
        match self.over {
            Over::Distance => &[Input::Distance],
            Over::Depth => &[Input::Depth],
            Over::Pressure => &[],
            Over::Speed => &[Input::Speed],
            Over::Temperature => &[Input::Temperature],
        }
    }

    fn depth(&self, rubbing: Rubbing) -> f64 {
        self.of_unit_pressure(rubbing) * rubbing.pressure
    }

    fn slope(&self, rubbing: Rubbing) -> f64 {
        let steeper = match self.over {
            Over::Pressure => {
                self.coefficients.slope(rubbing.pressure) * rubbing.pressure * rubbing.slip
            }
            _ => 0.0,
        };
        (self.of_unit_pressure(rubbing) + steeper).max(0.0)
    }
}

fn wrong(message: impl Into<String>) -> Invalid {
    Invalid::new("file", message)
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::super::{Rubbing, WearLaw};
    use super::{Over, Table};

    fn law(over: Over) -> Table {
        Table::new(over, &[1.0, 3.0], &[2.0, 6.0]).unwrap()
    }

    /// k = 2 x between 1 and 3: held at 2 before and at 6 beyond.
    #[test]
    fn the_coefficient_is_that_of_the_table() {
        let rubbing = Rubbing::new(2.0, 4.0).at_speed(1.5).at_temperature(2.5).after(0.0, 9.0);
        // 2 over the first metre, 4 in the mean over two, 6 over the last.
        assert_relative_eq!(law(Over::Distance).depth(rubbing), 2.0 * (2.0 + 8.0 + 6.0));
        assert_relative_eq!(law(Over::Depth).depth(rubbing), 2.0 * 4.0 * 6.0);
        assert_relative_eq!(law(Over::Speed).depth(rubbing), 2.0 * 4.0 * 3.0);
        assert_relative_eq!(law(Over::Temperature).depth(rubbing), 2.0 * 4.0 * 5.0);
        assert_relative_eq!(law(Over::Pressure).depth(rubbing), 2.0 * 4.0 * 4.0);
        // (2 p^2)' = 4 p
        assert_relative_eq!(law(Over::Pressure).slope(rubbing), 4.0 * 2.0 * 4.0);
    }

    #[test]
    fn more_pressure_must_not_wear_less() {
        let refused = Table::new(Over::Pressure, &[1.0, 2.0], &[3.0, 1.0]).unwrap_err();
        assert!(refused.message.contains("more pressure would wear less"), "{refused}");
        assert!(Table::new(Over::Speed, &[1.0, 2.0], &[3.0, 1.0]).is_ok());
    }
}
