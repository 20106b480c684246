//! What a body does with the heat of friction.

use crate::parameters::{Bound, Invalid, Parameter, Quantity, Values};

const CONDUCTIVITY: Parameter = Parameter::required(
    "conductivity",
    Quantity::Measured { name: "a thermal conductivity", unit: "W/(m K)" },
    "thermal conductivity",
);
const DIFFUSIVITY: Parameter = Parameter::required(
    "diffusivity",
    Quantity::Measured { name: "a thermal diffusivity", unit: "m^2/s" },
    "thermal diffusivity: conductivity over density and specific heat",
);
const SHARE: Parameter = Parameter::optional(
    "share",
    Quantity::Number,
    "share of the heat of friction that flows into this body, where the other one has no `thermal` table",
)
.bound(Bound::UpTo(0.0, 1.0));
const TEMPERATURE: Parameter = Parameter::optional(
    "temperature",
    Quantity::Temperature,
    "temperature of the body away from the contact, for laws that go by the temperature",
);

/// How a body conducts heat, and how warm it is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Thermal {
    /// Thermal conductivity (W/(m K)).
    pub conductivity: f64,
    /// Thermal diffusivity (m^2/s).
    pub diffusivity: f64,
    /// Share of the heat of friction that flows into this body; `None` where it follows from both bodies.
    pub share: Option<f64>,
    /// Temperature away from the contact (K).
    pub temperature: Option<f64>,
}

impl Thermal {
    /// What it takes, for readers of case files.
    pub const PARAMETERS: &'static [Parameter] = &[CONDUCTIVITY, DIFFUSIVITY, SHARE, TEMPERATURE];

    /// A body of that thermal conductivity (W/(m K)) and diffusivity (m^2/s).
    ///
    /// # Errors
    /// If one of them is not greater than zero.
    pub fn new(conductivity: f64, diffusivity: f64) -> Result<Self, Invalid> {
        Ok(Self {
            conductivity: CONDUCTIVITY.admit(conductivity)?,
            diffusivity: DIFFUSIVITY.admit(diffusivity)?,
            share: None,
            temperature: None,
        })
    }

    /// The same, that share of the heat of friction flowing into it.
    ///
    /// # Errors
    /// If the share is not greater than zero, or more than one.
    pub fn with_share(self, share: f64) -> Result<Self, Invalid> {
        Ok(Self { share: Some(SHARE.admit(share)?), ..self })
    }

    /// The same, at that temperature (K) away from the contact.
    ///
    /// # Errors
    /// If the temperature is not above absolute zero.
    pub fn at(self, temperature: f64) -> Result<Self, Invalid> {
        Ok(Self { temperature: Some(TEMPERATURE.admit(temperature)?), ..self })
    }

    /// From values that passed the declaration.
    pub fn read(values: &Values) -> Result<Self, Invalid> {
        let given = |name: &str| values.number(name);
        let mut thermal =
            Self::new(values.require("conductivity")?, values.require("diffusivity")?)?;
        if let Some(share) = given("share") {
            thermal = thermal.with_share(share)?;
        }
        given("temperature").map_or(Ok(thermal), |temperature| thermal.at(temperature))
    }

    /// Its values by the names of the [parameters](Self::PARAMETERS), those that are given.
    pub fn values(&self) -> impl Iterator<Item = (&'static Parameter, f64)> {
        let Self { conductivity, diffusivity, share, temperature } = *self;
        let values = [Some(conductivity), Some(diffusivity), share, temperature];
        Self::PARAMETERS
            .iter()
            .zip(values)
            .filter_map(|(parameter, value)| Some((parameter, value?)))
    }

    /// Thermal effusivity k / sqrt(chi) (J/(m^2 K s^(1/2))): what a surface takes up in a short time.
    pub fn effusivity(&self) -> f64 {
        self.conductivity / self.diffusivity.sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::Thermal;

    /// Steel of 50 W/(m K), 7850 kg/m^3 and 475 J/(kg K): sqrt(k rho c) = 13 654.
    #[test]
    fn the_effusivity_is_that_of_conductivity_density_and_heat() {
        let steel = Thermal::new(50.0, 50.0 / (7850.0 * 475.0)).unwrap();
        let expected = (50.0f64 * 7850.0 * 475.0).sqrt();
        assert!((steel.effusivity() / expected - 1.0).abs() < 1e-14);
    }

    #[test]
    fn what_no_body_has_is_refused() {
        let steel = Thermal::new(50.0, 13e-6).unwrap();
        assert!(Thermal::new(0.0, 13e-6).is_err());
        assert!(steel.with_share(1.0).is_ok() && steel.with_share(1.1).is_err());
        assert!(steel.at(-20.0).unwrap_err().message.contains("absolute zero"));
    }
}
