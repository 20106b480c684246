//! Friction and wear of two bodies whose contact is a line that passes.

use std::sync::Arc;

use archard::body::Material;
use archard::friction::Friction;
use archard::parameters::Invalid;
use archard::wear::{Input, WearLaw};

/// Why two bodies do not fit each other, or are not worn.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{}`{}`: {}", .body.map_or_else(String::new, |body| format!("body {}: ", body + 1)), .cause.parameter, .cause.message)]
pub struct Misfit {
    /// The body whose value is wrong, 0 or 1; `None` where it is one of both.
    pub body: Option<usize>,
    /// What is wrong.
    pub cause: Box<Invalid>,
}

impl Misfit {
    /// Of a value of a body.
    pub fn of(body: usize, cause: Invalid) -> Self {
        Self { body: Some(body), cause: Box::new(cause) }
    }
}

impl From<Invalid> for Misfit {
    fn from(cause: Invalid) -> Self {
        Self { body: None, cause: Box::new(cause) }
    }
}

/// Friction, and how both bodies wear; `None` where none exists.
pub type Laws = (Option<Arc<dyn Friction>>, [Option<Arc<dyn WearLaw>>; 2]);

/// Contact modulus (Pa), E* of Hertz, of two materials.
pub(crate) fn contact_modulus(materials: [&Material; 2]) -> f64 {
    let softness = |material: &Material| (1.0 - material.poisson.powi(2)) / material.young;
    (softness(materials[0]) + softness(materials[1])).recip()
}

/// Laws that ask for what is known of a line that passes, and of nothing else.
pub(crate) fn checked((friction, laws): &Laws) -> Result<(), Misfit> {
    for (body, law) in laws.iter().enumerate() {
        let known = |input: &Input| {
            matches!(input, Input::Friction | Input::Vectors | Input::Depth | Input::CrossShear)
        };
        let Some(law) = law else { continue };
        if !law.inputs().iter().all(known) {
            let message = "the law asks for the speed, the temperature, or the distance slid or rolled, which are not followed along a \
                           line that passes";
            return Err(Misfit::of(body, Invalid::new("wear", message)));
        }
        if law.inputs().contains(&Input::Friction) && friction.is_none() {
            let message = "the law asks for the friction, and there is none";
            return Err(Misfit::of(body, Invalid::new("wear", message)));
        }
    }
    if friction.as_ref().is_some_and(|law| !law.inputs().is_empty()) {
        let message = "depends on the speed, the temperature or the distance slid, which are not followed along a line that passes";
        return Err(Invalid::new("friction", message).into());
    }
    Ok(())
}
