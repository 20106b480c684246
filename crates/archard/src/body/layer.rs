//! Layers on a body: coatings, liners, rubber on a rigid base.

use super::material::{Material, POISSON, YOUNG};
use crate::parameters::{Bound, Invalid, Parameter, Quantity};

const THICKNESS: Parameter =
    Parameter::required("thickness", Quantity::Length, "thickness of the layer")
        .bound(Bound::Positive);

/// A layer of even thickness, bonded to what is below it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Layer {
    /// What it is made of.
    pub material: Material,
    /// How thick it is (m).
    pub thickness: f64,
}

impl Layer {
    /// What a layer takes, for readers of case files.
    pub const PARAMETERS: &'static [Parameter] = &[THICKNESS, YOUNG, POISSON];

    /// A layer of that material and thickness (m).
    ///
    /// # Errors
    /// If the thickness is not greater than zero.
    pub fn new(material: Material, thickness: f64) -> Result<Self, Invalid> {
        Ok(Self { material, thickness: THICKNESS.admit(thickness)? })
    }
}
