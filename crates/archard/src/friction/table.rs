//! Coulomb's law with a coefficient from a table over the pressure.
//!
//! limit = mu(p) p, mu straight between the points of the table and held beyond the first and the last. Finite element
//! programs tabulate it in the same way (Abaqus, *frictional behavior*).
//!
//! Limits: the limit must not fall as the pressure grows.

use super::Friction;
use crate::numerics::piecewise::Piecewise;
use crate::parameters::{Choice, Invalid, Parameter, Quantity};

pub(super) const CHOICE: Choice<Box<dyn Friction>> = Choice {
    name: "table",
    meaning: "Coulomb with a coefficient from a table over the pressure: the largest traction is mu(p) p; any motion",
    parameters: &[Parameter::required(
        "file",
        Quantity::Table(&[("coefficient", Quantity::Number), ("pressure", Quantity::Pressure)]),
        "CSV with the columns `pressure`, its unit in the header, and `coefficient`",
    )],
    build: |values| {
        let columns = values.table("file").unwrap_or_default();
        let column = |name: &str| columns.iter().find(|known| known.0 == name);
        match (columns.len(), column("pressure"), column("coefficient")) {
            (2, Some((_, pressures)), Some((_, coefficients))) => {
                Ok(Box::new(Table::new(pressures, coefficients)?))
            }
            _ => Err(wrong("the columns must be `pressure` and `coefficient`")),
        }
    },
};

/// limit = mu(p) p.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    coefficients: Piecewise,
}

impl Table {
    /// The law with coefficients of friction at rising pressures (Pa).
    ///
    /// # Errors
    /// If the lists differ in length or are empty, a number is not finite or negative, pressures do not rise, or the limit
    /// of friction falls as the pressure grows.
    pub fn new(pressures: &[f64], coefficients: &[f64]) -> Result<Self, Invalid> {
        let about = |error| wrong(format!("the columns `pressure` and `coefficient`: {error}"));
        let coefficients = Piecewise::new(pressures, coefficients).map_err(about)?;
        if let Some(pressure) = coefficients.falling_product() {
            return Err(wrong(format!(
                "the coefficient falls faster than the pressure grows, below {pressure:e} Pa: more pressure would bear less"
            )));
        }
        Ok(Self { coefficients })
    }
}

impl Friction for Table {
    fn limit(&self, pressure: f64) -> f64 {
        self.coefficients.at(pressure) * pressure
    }

    fn slope(&self, pressure: f64) -> f64 {
        (self.coefficients.at(pressure) + self.coefficients.slope(pressure) * pressure).max(0.0)
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
