//! All that the compliance of a body depends on, as bytes: bodies with the same have the same compliance.

use glam::DVec3;

use super::Job;
use crate::body::{Finite, Material};
use crate::compliance::bem::AxisCondition;

impl Job<'_> {
    /// Number of rows of the compliance: three a contact node.
    pub fn size(&self) -> usize {
        3 * self.conditions.contact.len()
    }

    /// Hands over every number the compliance follows from, in a fixed order.
    pub fn fingerprint(&self, finite: &Finite, material: &Material, take: &mut dyn FnMut(&[u8])) {
        let mut number = |value: f64| take(&value.to_bits().to_le_bytes());
        number(material.young);
        number(material.poisson);
        number(finite.tolerance);
        for mirrored in self.surface.mirrored {
            number(f64::from(mirrored));
        }
        let mut vector = |vector: DVec3| vector.to_array().into_iter().for_each(&mut number);
        for patch in &self.surface.patches {
            vector(DVec3::new(
                f64::from(patch.element.continuous),
                patch.corners.len() as f64,
                0.0,
            ));
            patch.corners.iter().for_each(|corner| vector(*corner));
        }
        for condition in &self.conditions.tractions {
            condition.basis.into_iter().for_each(&mut vector);
            vector(DVec3::from_array(condition.given.map(|given| match given {
                AxisCondition::Traction(traction) => traction,
                AxisCondition::Displacement(_) => f64::INFINITY,
                AxisCondition::Contact => f64::NEG_INFINITY,
            })));
            vector(DVec3::from_array(condition.given.map(|given| match given {
                AxisCondition::Displacement(displacement) => displacement,
                AxisCondition::Traction(_) | AxisCondition::Contact => 0.0,
            })));
        }
        for &contact in &self.conditions.contact {
            take(&(contact as u64).to_le_bytes());
        }
    }
}
