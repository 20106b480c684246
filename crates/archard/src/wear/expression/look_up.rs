//! Tables that formulas look values up in: `table("file.csv", x)`.

use crate::numerics::piecewise::{NoFunction, Piecewise};
use crate::parameters::Columns;
use crate::units::{Dimension, Scale};

/// A function given by points, straight between them and held beyond the first and the last.
#[derive(Debug, Clone, PartialEq)]
pub struct LookUp {
    /// What the places and the values measure.
    pub(super) dimensions: [Dimension; 2],
    /// Whether the places are absolute temperatures.
    pub(super) absolute: bool,
    pub(super) function: Piecewise,
}

impl LookUp {
    /// Values (SI) at rising places (SI), none of them negative, and what the places and the values measure.
    ///
    /// # Errors
    /// If the lists differ in length or are empty, a number is not finite or negative, or places do not rise.
    pub fn new(
        places: &[f64],
        values: &[f64],
        dimensions: [Dimension; 2],
    ) -> Result<Self, NoFunction> {
        Ok(Self { dimensions, absolute: false, function: Piecewise::new(places, values)? })
    }

    /// From the columns of a file; a message where they make no table.
    pub(super) fn of(columns: &Columns) -> Result<Self, String> {
        let [places, values] = &columns.columns[..] else {
            let found = columns.columns.len();
            return Err(format!("a table has two columns, places and values; found {found}"));
        };
        let measured = |unit: &str| Scale::read_any(unit).map_err(|error| error.to_string());
        let [(place, over), (value, of)] = [measured(&places.unit)?, measured(&values.unit)?];
        if value.is_absolute() {
            return Err("values cannot be in degrees Celsius: write them in K".to_owned());
        }
        let function = Piecewise::new(&places.values, &values.values).map_err(|error| {
            format!("the columns `{}` and `{}`: {error}", places.name, values.name)
        })?;
        Ok(Self { dimensions: [over, of], absolute: place.is_absolute(), function })
    }
}
