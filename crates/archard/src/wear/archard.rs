//! The Holm-Archard law.
//!
//! R. Holm, *Electric Contacts* (1946); J. F. Archard, *J. Appl. Phys.* 24 (1953) 981: a surface
//! loses the depth k p s, with k = k_ad / H (the paper's eqs. 13 to 18).

use super::{Rubbing, WearLaw};
use crate::parameters::{About, Bound, Choice, Invalid, Parameter, Quantity};

pub(super) const CHOICE: Choice<Box<dyn WearLaw>> = Choice {
    name: "archard",
    meaning: "Holm-Archard: depth = k p s, k given or k = k_ad / hardness; any motion",
    parameters: &[COEFFICIENT, K_AD, HARDNESS],
    build: |values| {
        let hardness = values.number("hardness");
        Ok(Box::new(match values.one_of("coefficient", "k_ad")? {
            (Some(coefficient), _) => Archard { hardness, ..Archard::new(coefficient)? },
            (None, k_ad) => {
                let hardness = hardness.ok_or_else(|| {
                    Invalid::new("k_ad", "`k_ad` needs `hardness`, too: k = k_ad / hardness")
                })?;
                Archard::with_hardness(k_ad.unwrap_or_default(), hardness)?
            }
        }))
    },
};

pub(super) const ABOUT: About = About::new(
    CHOICE.name,
    "R. Holm, Electric Contacts (1946); J. F. Archard, J. Appl. Phys. 24 (1953) 981",
    "{ k_ad = 1.1e-4, hardness = \"2.7 GPa\" }",
);

const COEFFICIENT: Parameter =
    Parameter::optional("coefficient", Quantity::WearCoefficient, "dimensional wear coefficient k")
        .bound(Bound::NonNegative);
const K_AD: Parameter =
    Parameter::optional("k_ad", Quantity::Number, "dimensionless wear coefficient")
        .bound(Bound::NonNegative);
const HARDNESS: Parameter =
    Parameter::optional("hardness", Quantity::Pressure, "hardness of the body");

/// depth = k p s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Archard {
    coefficient: f64,
    hardness: Option<f64>,
}

impl Archard {
    /// The law with that coefficient k (1/Pa, the same as m^3/(N m)).
    ///
    /// # Errors
    /// If the coefficient is negative.
    pub fn new(coefficient: f64) -> Result<Self, Invalid> {
        Ok(Self { coefficient: COEFFICIENT.admit(coefficient)?, hardness: None })
    }

    /// The law with k = k_ad / hardness, from a number k_ad and the hardness (Pa) of the body.
    ///
    /// # Errors
    /// If k_ad is negative, or the hardness not greater than zero.
    pub fn with_hardness(k_ad: f64, hardness: f64) -> Result<Self, Invalid> {
        let coefficient = K_AD.admit(k_ad)? / HARDNESS.admit(hardness)?;
        Ok(Self { coefficient, hardness: Some(hardness) })
    }
}

impl WearLaw for Archard {
    fn hardness(&self) -> Option<f64> {
        self.hardness
    }

    fn depth(&self, rubbing: Rubbing) -> f64 {
        self.coefficient * rubbing.pressure * rubbing.slip
    }

    fn slope(&self, rubbing: Rubbing) -> f64 {
        self.coefficient * rubbing.slip
    }
}
