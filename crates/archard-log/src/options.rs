//! What a user adds to a log.

use crate::error::Error;
use crate::roles;
use crate::unit::{self, Measure};

/// What a user adds to a log: columns by role, values by name.
#[derive(Debug, Clone, Default)]
pub struct Options {
    /// Role and title: `wear`, `Displacement [um]`; `-` before the title turns its sign.
    pub columns: Vec<(String, String)>,
    /// `load`, `radius`, `speed`, `rotation`, `stroke` or `from`, and a quantity: `5 N`, or one for each step: `5 N; 10 N`.
    pub values: Vec<(String, String)>,
    /// Whether a profile across the track says what was worn.
    pub profile: bool,
}

const VALUES: [(&str, Measure); 6] = [
    ("load", Measure::Force),
    ("radius", Measure::Length),
    ("speed", Measure::Speed),
    ("rotation", Measure::Rotation),
    ("stroke", Measure::Length),
    ("from", Measure::Length),
];

impl Options {
    /// The values (SI) of a name, one for each of so many steps.
    pub(crate) fn each(&self, name: &str, steps: usize) -> Result<Option<Vec<f64>>, Error> {
        let Some((_, text)) = self.values.iter().find(|(known, _)| known == name) else {
            return Ok(None);
        };
        let wrong = |help: String| Error::Option { option: format!("{name}={text}"), help };
        let measure = VALUES.iter().find(|known| known.0 == name).map(|known| known.1);
        let value = |part: &str| match unit::quantity(part) {
            Some((of, value)) if Some(of) == measure && value > 0.0 => Ok(value),
            Some((Measure::Mass, mass)) if name == "load" && mass > 0.0 => {
                Ok(mass * unit::FREE_FALL)
            }
            _ => Err(wrong(
                "write a value greater than zero and its unit, like load=\"5 N\" or from=\"100 m\""
                    .into(),
            )),
        };
        let values: Vec<f64> = text.split(';').map(value).collect::<Result<_, _>>()?;
        match values[..] {
            [one] => Ok(Some(vec![one; steps])),
            _ if values.len() == steps => Ok(Some(values)),
            _ => Err(wrong(format!("there are {} values and {steps} steps", values.len()))),
        }
    }

    /// Whether all names are known.
    pub(crate) fn check(&self) -> Result<(), Error> {
        let role = |name: &str| roles::ROLES.iter().any(|known| known.0 == name);
        let names = |all: Vec<&str>| format!("there are {}", all.join(", "));
        if let Some((name, _)) = self.columns.iter().find(|(name, _)| !role(name)) {
            let help = names(roles::ROLES.iter().map(|known| known.0).collect());
            return Err(Error::Option { option: format!("--column {name}"), help });
        }
        let known = |name: &str| VALUES.iter().any(|known| known.0 == name);
        if let Some((name, _)) = self.values.iter().find(|(name, _)| !known(name)) {
            let help = names(VALUES.iter().map(|known| known.0).collect());
            return Err(Error::Option { option: format!("--set {name}"), help });
        }
        Ok(())
    }
}
