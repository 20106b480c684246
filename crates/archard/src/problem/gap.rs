//! The gap of a contact that was solved on a part of the frame.

use std::borrow::Cow;

use serde::{Deserialize, Serialize};

use crate::compliance::{Compliance, normal_displacement};
use crate::frame::Part;
use crate::numerics::vector::update;

/// The normal gap as a solve left it; [`ContactState::gap_of`](super::ContactState::gap_of) says what it is.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Gap {
    /// The gap (m), one value a pair; without the displacement by the pressures next to a part.
    pub(crate) values: Vec<f64>,
    pub(crate) part: Option<Part>,
}

impl From<Vec<f64>> for Gap {
    /// The gap (m) of all pairs.
    fn from(values: Vec<f64>) -> Self {
        Self { values, part: None }
    }
}

impl Gap {
    /// The gap (m) of all pairs under these pressures (Pa).
    pub(super) fn under(&self, pressure: &[f64], compliance: &dyn Compliance) -> Cow<'_, [f64]> {
        if self.part.is_none() {
            return Cow::Borrowed(&self.values);
        }
        Cow::Owned(self.opened_by(normal_displacement(compliance, pressure)))
    }

    /// The gap (m) of all pairs, those next to the part opened by a displacement (m) too.
    pub(crate) fn opened_by(&self, mut displacement: Vec<f64>) -> Vec<f64> {
        let Some(part) = &self.part else { return self.values.clone() };
        update(&mut displacement, [&self.values], |opened, [gap]| opened + gap);
        part.pasted(&part.cut(&self.values), displacement)
    }
}
