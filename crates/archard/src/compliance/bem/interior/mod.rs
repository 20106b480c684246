//! Displacements and stresses inside a body, from what is known on its surface.
//!
//! Somigliana's identity gives them as integrals of the displacements and tractions on the surface:
//!
//! ```text
//! u_i(x)     = integral of U_ij t_j - T_ij u_j
//! sigma_ij(x) = integral of D_kij t_k - S_kij u_k
//! ```
//!
//! (C. A. Brebbia, J. C. F. Telles and L. C. Wrobel, *Boundary Element Techniques*, Springer 1984, eqs. 5.26
//! and 5.64.) The kernels grow as 1/r, 1/r^2, 1/r^2 and 1/r^3 towards x. A displacement that is linear in the
//! place and its uniform stress satisfy the identity by themselves. Those of the nearest place of the surface
//! are taken off before the integration and added after it: what is left is small where the kernels are large,
//! and fields that are linear everywhere come out exactly.

use crate::numerics::WRITTEN;

mod hooke;
mod nearest;
mod slopes;
mod somigliana;
#[cfg(test)]
mod tests;

use std::borrow::Cow;

use glam::{DMat3, DVec3};
use rayon::prelude::*;

use super::curvature::{Share, curvatures};
use super::element::{CURVATURES, evaluate};
use super::rules::{Places, Rules};
use super::solid::Boundary;
use super::surface::Surface;
use crate::body::Material;
use hooke::{Hooke, Linear};
use nearest::{Nearest, nearest};
use slopes::{Fit, fits};
use somigliana::{Kernels, Source};

/// How far outside a point may lie, relative to the size of the nearest element, to be taken as one of the
/// surface: plane elements cut curved surfaces short. A point inside has to be as far away from all other sides.
const OUTSIDE: f64 = 0.1;
/// Least depth at which the identity gives stresses, relative to the size of the nearest element.
const SHALLOW: f64 = 0.25;

/// Displacement and stress at a point of a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Response {
    /// Displacement along x, y and z (m).
    pub displacement: DVec3,
    /// Stress along x, y and z (Pa), positive in tension; symmetric.
    pub stress: DMat3,
}

/// The inside of a body whose displacements and tractions are known all over its surface.
///
/// Displacements are as accurate as those of the surface, at any depth. Stresses are from a depth of a quarter of the
/// nearest element on; above that the identity would show the steps and edges between elements rather than the
/// body. Stresses there lie on the line through those at that depth and at twice as much, with the known traction at
/// the surface: an error of second order in the size of the elements. Where another side is too close for that, at edges and in thin walls, they are found
/// between those of the identity and those that follow at the surface from the traction and the slopes of the
/// displacement.
#[derive(Debug)]
pub struct Interior<'a> {
    surface: Cow<'a, Surface>,
    boundary: Cow<'a, Boundary>,
    hooke: Hooke,
    kernels: Kernels,
    rules: Rules,
    slopes: Vec<Option<Fit>>,
    /// Second derivatives of the displacement of each element along s and t.
    bends: Vec<[DVec3; CURVATURES]>,
}

impl<'a> Interior<'a> {
    /// The inside of a body, integrals to that relative tolerance.
    pub fn new(
        surface: &'a Surface,
        material: &Material,
        boundary: &'a Boundary,
        tolerance: f64,
    ) -> Self {
        Self::of((Cow::Borrowed(surface), Cow::Borrowed(boundary)), material, tolerance)
    }

    fn of(
        (surface, boundary): (Cow<'a, Surface>, Cow<'a, Boundary>),
        material: &Material,
        tolerance: f64,
    ) -> Self {
        let bends = curvatures(&surface).iter().map(|shares| bends(shares, &boundary)).collect();
        let mut interior = Self {
            hooke: Hooke::new(material),
            kernels: Kernels::new(material),
            rules: Rules::new(tolerance),
            slopes: vec![None; surface.patches.len()],
            bends,
            surface,
            boundary,
        };
        let patches = interior.surface.patches.iter().enumerate();
        let gradients: Vec<DMat3> = patches
            .map(|(face, patch)| interior.on(face, patch.middle_reference()).gradient)
            .collect();
        interior.slopes = fits(&interior.surface, &gradients);
        interior
    }

    /// The response at a point (m); `None` outside the body. A point outside by less than a tenth of the nearest
    /// element is taken for the nearest one of the surface.
    pub fn at(&self, point: DVec3) -> Option<Response> {
        let place = self.surface.locate(point)?;
        let fitted = self.linear(&place);
        let on_surface = self.hooke.stress(fitted.gradient);
        if !place.inside || place.distance <= WRITTEN * place.size {
            let normal = place.image * self.surface.patches[place.face].normal(place.reference);
            let stress = self.shallow(&place, -normal, 0.0).unwrap_or(on_surface);
            return Some(Response { displacement: fitted.displacement, stress });
        }
        let response = self.integrate(point, &fitted);
        let share = place.distance / (SHALLOW * place.size);
        if share >= 1.0 {
            return Some(response);
        }
        let inward = (point - place.at) / place.distance;
        let between = || on_surface + share * (response.stress - on_surface);
        let stress = self.shallow(&place, inward, share).unwrap_or_else(between);
        Some(Response { stress, ..response })
    }

    /// The stress (Pa) on the surface, a value a node of tractions; the mean over the elements that share it.
    pub fn surface_stress(&self) -> Vec<DMat3> {
        let stresses = |face: usize| -> Vec<(f64, DMat3)> {
            let patch = &self.surface.patches[face];
            let stress = |&at: &[f64; 2]| {
                let place = Nearest::on_element(patch, face, at);
                let fitted = || self.hooke.stress(self.on(face, at).gradient);
                let stress = self.shallow(&place, -patch.normal(at), 0.0).unwrap_or_else(fitted);
                (patch.area_vector(at).length(), stress)
            };
            patch.element.nodes.iter().map(stress).collect()
        };
        let faces = 0..self.surface.patches.len();
        let all: Vec<Vec<(f64, DMat3)>> = faces.into_par_iter().map(stresses).collect();
        let mut sums = vec![(0.0, DMat3::ZERO); self.surface.tractions.len()];
        for (face, stresses) in all.into_iter().enumerate() {
            for (node, (weight, stress)) in self.surface.tractions_of(face).zip(stresses) {
                sums[node].0 += weight;
                sums[node].1 += weight * stress;
            }
        }
        sums.into_iter().map(|(weight, sum)| sum * weight.recip()).collect()
    }

    /// The stress (Pa) in that part of the least depth below a place of the surface: on the line through the
    /// stresses at that depth and at twice as much, from where it meets the surface corrected by the traction
    /// there; `None` where these are too close to another side.
    fn shallow(&self, place: &Nearest, inward: DVec3, share: f64) -> Option<DMat3> {
        let step = SHALLOW * place.size;
        let below = |times: f64| {
            let point = place.at + times * step * inward;
            let nearest = self.surface.locate(point)?;
            let deep = nearest.inside && nearest.distance >= OUTSIDE * place.size;
            deep.then(|| self.integrate(point, &self.linear(&nearest)).stress)
        };
        let (first, second) = (below(1.0)?, below(2.0)?);
        let surface = self.bearing(place, first + (first - second));
        Some(surface + share * (first - surface))
    }

    /// The stress (Pa) at a place of the surface with the traction there, which is known, for what the stress
    /// says of it.
    fn bearing(&self, place: &Nearest, stress: DMat3) -> DMat3 {
        let normal = place.image * self.surface.patches[place.face].normal(place.reference);
        let [_, traction] = self.values(place.face, place.reference);
        let missing = place.image * traction - stress * normal;
        let outer = |a: DVec3, b: DVec3| DMat3::from_cols(b.x * a, b.y * a, b.z * a);
        let both = outer(missing, normal) + outer(normal, missing);
        stress + both - missing.dot(normal) * outer(normal, normal)
    }

    /// Displacement and traction at a place of an element.
    fn values(&self, face: usize, at: [f64; 2]) -> [DVec3; 2] {
        let shape = self.surface.patches[face].element.shape;
        let mut values = [DVec3::ZERO; 2];
        for (polynomial, local) in shape.iter().zip(self.surface.local[face]) {
            let share = evaluate(polynomial, at);
            values[0] += share * self.boundary.displacement[local.node];
            values[1] += share * self.boundary.traction[local.traction];
        }
        if let Some(square) = self.surface.patches[face].element.curvature {
            for (bend, at) in self.bends[face].iter().zip(at) {
                values[0] += 0.5 * (at * at - square) * *bend;
            }
        }
        values
    }

    /// The linear field that fits at a place of an element.
    fn on(&self, face: usize, at: [f64; 2]) -> Linear {
        let patch = &self.surface.patches[face];
        let [displacement, traction] = self.values(face, at);
        let tangents = patch.tangents(at);
        let slopes = match &self.slopes[face] {
            Some(fit) => tangents.map(|tangent| fit.at(patch.at(at)) * tangent),
            None => self.slopes_of(face, at),
        };
        let gradient = self.hooke.gradient(tangents, slopes, traction);
        Linear { place: patch.at(at), displacement, gradient }
    }

    /// The derivatives of an element's own displacement with respect to s and t.
    fn slopes_of(&self, face: usize, at: [f64; 2]) -> [DVec3; 2] {
        let mut slopes = [DVec3::ZERO; 2];
        let shape = self.surface.patches[face].element.shape;
        for ([_, s, t, both], local) in shape.iter().zip(self.surface.local[face]) {
            let value = self.boundary.displacement[local.node];
            slopes[0] += (s + both * at[1]) * value;
            slopes[1] += (t + both * at[0]) * value;
        }
        for curvature in 0..CURVATURES {
            slopes[curvature] += at[curvature] * self.bends[face][curvature];
        }
        slopes
    }

    /// The linear field that fits at the place nearest to a point.
    fn linear(&self, nearest: &Nearest) -> Linear {
        self.on(nearest.face, nearest.reference).mirrored(nearest.image)
    }

    /// Somigliana's identity, with that field taken off the surface and added inside.
    fn integrate(&self, point: DVec3, fitted: &Linear) -> Response {
        let stress = self.hooke.stress(fitted.gradient);
        let images = self.surface.images();
        let parts = (0..self.surface.patches.len()).into_par_iter().map(|face| {
            let patch = &self.surface.patches[face];
            let mut places = Places::default();
            let mut sum = [DMat3::ZERO, DMat3::ZERO];
            for image in &images {
                let seen = *image * point;
                places.clear();
                self.rules.near(patch, seen, &mut places);
                for ((&s, &t), weight) in places.s.iter().zip(&places.t).zip(&places.weight) {
                    let place = *image * patch.at([s, t]);
                    let area_vector = *weight * *image * patch.area_vector([s, t]);
                    let (area, [u, traction]) = (area_vector.length(), self.values(face, [s, t]));
                    let source = Source {
                        r: place - point,
                        area_vector,
                        displacement: *image * u - fitted.at(place),
                        force: area * *image * traction - stress * area_vector,
                    };
                    let Response { displacement, stress } = self.kernels.response(&source);
                    sum[0].x_axis += displacement;
                    sum[1] += stress;
                }
            }
            sum
        });
        // Added in order, so that results do not depend on the number of threads.
        let parts: Vec<[DMat3; 2]> = parts.collect();
        let sum =
            parts.iter().fold([DMat3::ZERO; 2], |sum, part| [sum[0] + part[0], sum[1] + part[1]]);
        Response { displacement: fitted.at(point) + sum[0].x_axis, stress: stress + sum[1] }
    }
}

impl Interior<'static> {
    /// The same of a surface that nobody else keeps.
    pub(super) fn owning(
        surface: Surface,
        material: &Material,
        boundary: Boundary,
        tolerance: f64,
    ) -> Self {
        Self::of((Cow::Owned(surface), Cow::Owned(boundary)), material, tolerance)
    }
}

/// Second derivatives of a displacement from those of the nodes around.
fn bends(shares: &[Share], boundary: &Boundary) -> [DVec3; CURVATURES] {
    let mut bends = [DVec3::ZERO; CURVATURES];
    for Share { node, image, curvatures } in shares {
        for (bend, share) in bends.iter_mut().zip(curvatures) {
            *bend += *share * *image * boundary.displacement[*node];
        }
    }
    bends
}

impl Surface {
    /// Where a point (m) lies; `None` if it is outside of the body and not even on its surface.
    fn locate(&self, point: DVec3) -> Option<Nearest> {
        nearest(self, point).filter(|place| place.inside || place.distance <= OUTSIDE * place.size)
    }

    /// How deep a point lies below the surface (m), zero on it; `None` outside of the body, mirror images
    /// included. A point outside by less than a tenth of the nearest element counts as one of the surface.
    pub fn depth(&self, point: DVec3) -> Option<f64> {
        let place = self.locate(point)?;
        Some(if place.inside { place.distance } else { 0.0 })
    }
}
