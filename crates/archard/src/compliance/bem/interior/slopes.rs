//! How displacements grow along the surface.
//!
//! The derivatives of an element's own displacements are accurate in its middle and of first order elsewhere. A
//! field that is linear in the place, equal to those in the middle and fitted to those in the middles of its
//! neighbours on the same surface, is of second order everywhere (O. C. Zienkiewicz and J. Z. Zhu, *International Journal for
//! Numerical Methods in Engineering* 33 (1992), 1331-1364).

use std::collections::HashMap;

use glam::{DMat2, DMat3, DVec2, DVec3};

use super::super::surface::Surface;

/// Least part of the largest possible determinant that says that neighbours lie around an element, not in a row.
const SPREAD: f64 = 1e-3;

/// A gradient of displacement that is linear in the place.
#[derive(Debug, Clone, Copy)]
pub(super) struct Fit {
    centre: DVec3,
    /// Directions along the surface.
    axes: [DVec3; 2],
    /// The gradient in the centre and its change a length along each direction.
    values: [DMat3; 3],
}

impl Fit {
    /// The gradient at a place (m) near the element.
    pub fn at(&self, place: DVec3) -> DMat3 {
        let [x, y] = self.axes.map(|axis| axis.dot(place - self.centre));
        self.values[0] + x * self.values[1] + y * self.values[2]
    }

    /// The fit to gradients at places around an element, which keeps that of its own middle; `None` where these
    /// do not lie around it.
    fn new(
        (centre, own): (DVec3, DMat3),
        normal: DVec3,
        around: &[(DVec3, DMat3)],
    ) -> Option<Self> {
        let first = normal.any_orthonormal_vector();
        let axes = [first, normal.cross(first)];
        let mut moments = DMat2::ZERO;
        let mut values = [DMat3::ZERO; 2];
        for (place, gradient) in around {
            let row = DVec2::from(axes.map(|axis| axis.dot(*place - centre)));
            moments += DMat2::from_cols(row * row.x, row * row.y);
            values[0] += row.x * (*gradient - own);
            values[1] += row.y * (*gradient - own);
        }
        let most = moments.x_axis.x * moments.y_axis.y;
        if most <= 0.0 || moments.determinant() <= SPREAD * most {
            return None;
        }
        let inverse = moments.inverse();
        let solved =
            [inverse.x_axis, inverse.y_axis].map(|row| row.x * values[0] + row.y * values[1]);
        Some(Self { centre, axes, values: [own, solved[0], solved[1]] })
    }
}

/// A fit for every element, from the gradients in the middles of all.
pub(super) fn fits(surface: &Surface, gradients: &[DMat3]) -> Vec<Option<Fit>> {
    let side = |face: usize| surface.tractions[surface.local[face][0].traction].surface;
    let mut faces_at: HashMap<(usize, usize), Vec<usize>> = HashMap::new();
    for (face, corners) in surface.corners.iter().enumerate() {
        for &vertex in corners.as_slice() {
            faces_at.entry((vertex, side(face))).or_default().push(face);
        }
    }
    let fit = |face: usize| {
        let corners = surface.corners[face].as_slice().iter();
        let mut around: Vec<usize> =
            corners.flat_map(|&vertex| &faces_at[&(vertex, side(face))]).copied().collect();
        around.sort_unstable();
        around.dedup();
        let samples: Vec<(DVec3, DMat3)> = around
            .into_iter()
            .map(|face| (surface.patches[face].middle(), gradients[face]))
            .collect();
        let patch = &surface.patches[face];
        let normal = patch.normal(patch.middle_reference());
        Fit::new((patch.middle(), gradients[face]), normal, &samples)
    };
    (0..surface.patches.len()).map(fit).collect()
}
