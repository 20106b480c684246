//! The Holm-Archard law.
//!
//! R. Holm, *Electric Contacts* (1946); J. F. Archard, *J. Appl. Phys.* 24 (1953) 981: a surface
//! loses the depth k p s, with k = k_ad / H (the paper's eqs. 13 to 18).

use super::{Rubbing, WearLaw};
use crate::parameters::{Bound, Choice, Invalid, Parameter, Quantity};

pub(super) const CHOICE: Choice<Box<dyn WearLaw>> = Choice {
    name: "archard",
    meaning: "Holm-Archard: depth = k p s, k given or k = k_ad / hardness",
    parameters: &[
        Parameter::optional(
            "coefficient",
            Quantity::WearCoefficient,
            "dimensional wear coefficient k",
        )
        .bound(Bound::NonNegative),
        Parameter::optional("k_ad", Quantity::Number, "dimensionless wear coefficient")
            .bound(Bound::NonNegative),
        Parameter::optional("hardness", Quantity::Pressure, "hardness of the body"),
    ],
    build: |values| {
        let coefficient = match values.one_of("coefficient", "k_ad")? {
            (Some(coefficient), _) => coefficient,
            (None, k_ad) => {
                let hardness = values.number("hardness").ok_or_else(|| {
                    Invalid::new(
                        "k_ad",
                        "`k_ad` needs the `hardness` beside it: k = k_ad / hardness",
                    )
                })?;
                k_ad.unwrap_or_default() / hardness
            }
        };
        Ok(Box::new(Archard { coefficient }))
    },
};

/// depth = k p s.
#[derive(Debug)]
struct Archard {
    /// k (1/Pa).
    coefficient: f64,
}

impl WearLaw for Archard {
    fn depth(&self, rubbing: Rubbing) -> f64 {
        self.coefficient * rubbing.pressure * rubbing.slip
    }

    fn slope(&self, rubbing: Rubbing) -> f64 {
        self.coefficient * rubbing.slip
    }
}
