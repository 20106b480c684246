//! The whole surface of a body with an image field under the tractions of a contact.

use rayon::prelude::*;

use super::{DeformedBody, PressedHalfSpace, Response};
use crate::compliance::Balance;

impl PressedHalfSpace {
    /// Displacements, tractions and stresses at the nodes of the elements on the surface of a body that ends somewhere; `None` of a
    /// half-space, and where not all are known.
    pub fn on_surface(&self) -> Option<DeformedBody> {
        let surface = self.ends.as_ref()?.surface().clone();
        let nodes = surface.traction_nodes();
        let at = |[x, y, z]: [f64; 3]| self.at([x, y, z.min(0.0)]);
        let found: Vec<Response> =
            nodes.par_iter().map(|node| at(node.place.into())).collect::<Option<_>>()?;
        let count = nodes.iter().map(|own| own.node + 1).max().unwrap_or(0);
        let (mut displacement, mut traction) = (vec![[0.0; 3]; count], vec![]);
        let mut forces = vec![[0.0; 3]; surface.names().len()];
        for (node, Response { displacement: moved, stress }) in nodes.iter().zip(&found) {
            displacement[node.node] = *moved;
            let normal = node.normal.to_array();
            let own: [f64; 3] =
                [0, 1, 2].map(|axis| (0..3).map(|i| stress[i][axis] * normal[i]).sum());
            forces[node.surface].iter_mut().zip(own).for_each(|(sum, own)| *sum += node.area * own);
            traction.push(own);
        }
        Some(DeformedBody {
            displacement,
            traction,
            stress: found.iter().map(|own| own.stress).collect(),
            points: vec![],
            sections: vec![],
            worn: vec![],
            balance: Balance::default(),
            forces,
            surface,
        })
    }
}
