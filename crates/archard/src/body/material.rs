//! Linear isotropic elasticity.

use crate::parameters::{Bound, Invalid, Parameter, Quantity, Values};

pub(super) const YOUNG: Parameter =
    Parameter::required("young", Quantity::Pressure, "Young's modulus");
/// Young's modulus where the shear modulus may stand in its place.
const YOUNG_OR_SHEAR: Parameter =
    Parameter::optional("young", Quantity::Pressure, "Young's modulus");
const SHEAR: Parameter =
    Parameter::optional("shear", Quantity::Pressure, "shear modulus, in place of `young`");
pub(super) const POISSON: Parameter =
    Parameter::required("poisson", Quantity::Number, "Poisson's ratio")
        .bound(Bound::UpTo(-1.0, 0.5));

/// An isotropic linear elastic material.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    /// Young's modulus (Pa).
    pub young: f64,
    /// Poisson's ratio.
    pub poisson: f64,
}

impl Material {
    /// What a material takes, for readers of case files.
    pub const PARAMETERS: &'static [Parameter] = &[YOUNG_OR_SHEAR, SHEAR, POISSON];

    /// A material of that Young's modulus (Pa) and Poisson's ratio.
    ///
    /// # Errors
    /// If the modulus is not greater than zero, or the ratio not between -1 and 0.5, which it may be.
    pub fn new(young: f64, poisson: f64) -> Result<Self, Invalid> {
        Ok(Self { young: YOUNG.admit(young)?, poisson: POISSON.admit(poisson)? })
    }

    /// The material that values of its [parameters](Self::PARAMETERS) say.
    ///
    /// # Errors
    /// If a value is missing, or both moduli are given.
    pub fn read(values: &Values) -> Result<Self, Invalid> {
        let poisson = values.require("poisson")?;
        match values.one_of("young", "shear")? {
            (Some(young), _) => Self::new(young, poisson),
            (None, shear) => Self::new(2.0 * (1.0 + poisson) * shear.unwrap_or_default(), poisson),
        }
    }

    /// Plane-strain compliance (1 - nu^2)/E (1/Pa); the sum over the bodies is 1/E*.
    pub fn plane_strain_compliance(&self) -> f64 {
        (1.0 - self.poisson * self.poisson) / self.young
    }

    /// Shear modulus G = E / (2 (1 + nu)) (Pa).
    pub fn shear_modulus(&self) -> f64 {
        self.young / (2.0 * (1.0 + self.poisson))
    }
}

/// Contact modulus E* (Pa) of two bodies, 1/E* = sum (1 - nu^2)/E, a rigid body (`None`) adding
/// nothing; infinite for two rigid bodies.
pub fn contact_modulus(materials: [Option<&Material>; 2]) -> f64 {
    // Not `sum`: an empty one is -0, which would make the modulus of rigid bodies negative.
    let compliances = materials.into_iter().flatten().map(Material::plane_strain_compliance);
    1.0 / compliances.fold(0.0, |sum, compliance| sum + compliance)
}

#[cfg(test)]
mod tests {
    use super::{Material, contact_modulus};

    #[test]
    fn a_rigid_body_doubles_the_contact_modulus_of_twins() {
        let steel = Material { young: 210e9, poisson: 0.3 };
        let twins = contact_modulus([Some(&steel), Some(&steel)]);
        assert_eq!(contact_modulus([None, Some(&steel)]), 2.0 * twins);
        assert_eq!(contact_modulus([None, None]), f64::INFINITY);
    }
}
