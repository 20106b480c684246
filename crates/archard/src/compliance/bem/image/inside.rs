//! The image field of one load, anywhere inside the body.

use rayon::prelude::*;

use super::near::{Columns, NearField};
use super::{ImageBody, NoImage, Polynomials};
use crate::compliance::bem::contact::supported;
use crate::compliance::bem::{
    AxisCondition, Condition, Conditions, Interior, Solid, Surface, TractionNode,
};

impl ImageBody<'_> {
    /// What the ends of the body add to the field of the half-space under loads (N): d m + i is that of the i-th of m polynomials along
    /// axis d.
    ///
    /// # Errors
    /// If the body is not held, or its equations have no solution.
    pub fn inside(
        &self,
        polynomials: &Polynomials,
        loads: &[f64],
    ) -> Result<Interior<'static>, NoImage> {
        let Self { finite, mesh, material } = *self;
        let surface = Surface::new(mesh, finite.interpolation, finite.mirrored);
        let columns = Columns::new(polynomials, finite.mirrored);
        let near = NearField::new(material, polynomials, &columns);
        let undone = |node: &TractionNode| {
            let [displacement, traction] = near.under(node, loads);
            let mut condition = supported(finite, node);
            for (given, unit) in condition.given.iter_mut().zip(condition.basis) {
                *given = match given {
                    AxisCondition::Displacement(_) => {
                        AxisCondition::Displacement(-displacement.dot(unit))
                    }
                    AxisCondition::Traction(_) | AxisCondition::Contact => {
                        AxisCondition::Traction(-traction.dot(unit))
                    }
                };
            }
            condition
        };
        let conditions: Vec<Condition> = surface.traction_nodes().par_iter().map(undone).collect();
        let conditions = Conditions::of(&surface, conditions, &[])?;
        let solid = Solid::new(&surface, material, &conditions, finite.tolerance)?;
        let boundary = solid.boundary(&[]);
        Ok(Interior::owning(surface, material, boundary, finite.tolerance))
    }
}
