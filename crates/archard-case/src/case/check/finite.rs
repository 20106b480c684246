//! How far a half-space may be from a meshed body, before anything is computed.
//!
//! At a distance r from a force F on its surface, and a depth z, a half-space is displaced along the force by
//! Boussinesq's
//!
//! ```text
//! u = (1 + nu) F / (2 pi E r) [2 (1 - nu) + (z / r)^2]
//! ```
//!
//! (K. L. Johnson, *Contact Mechanics*, Cambridge 1985, section 3.2). Where the body ends, held or free, so much
//! of the approach is there too much or is missing. Beside the approach of a round contact of radius a it is
//! 0.42 a / r on the surface, and 0.73 a / r below the contact (nu = 0.3).

use std::f64::consts::PI;

use glam::DVec3;

use super::Parts;
use super::words::{length, three};
use crate::case::key::Key;
use crate::case::problem::Problem;
use archard::body::{Elasticity, Finite, Material, Support};
use archard::compliance::bem;
use archard::estimate::Contact;

/// Faces whose normals differ by more than this from that of the contact (cosine) are where the body ends.
const TURNED: f64 = 0.5;
/// Share of the approach beyond which a half-space is doubtful.
const DOUBTFUL: f64 = 0.05;

/// What a meshed body may differ by from a half-space.
#[non_exhaustive]
#[derive(Debug, Clone, PartialEq)]
pub struct Finiteness {
    /// The body.
    pub body: String,
    /// Distance (m) from the middle of the contact to where the body ends: the nearest face that looks more than
    /// 60 degrees elsewhere, or is held.
    pub distance: f64,
    /// The most that a half-space is displaced where the body ends, relative to the approach.
    pub approach: f64,
    /// Whether the case takes a half-space for it.
    pub half_space: bool,
}

impl Finiteness {
    /// That of every meshed body, where a closed form gives the load and the approach.
    pub(super) fn of(parts: &Parts<'_>, contact: Option<&Contact>) -> Vec<Self> {
        let Some((contact, approach)) = contact.and_then(|one| Some((one, one.approach?))) else {
            return vec![];
        };
        let found = parts.meshed().filter_map(|(body, finite)| {
            let material = body.material.as_ref()?.elastic;
            let half_space = finite.elasticity == Elasticity::HalfSpace;
            let ends = ends(finite);
            let distance = ends.iter().map(|(distance, _)| *distance).min_by(f64::total_cmp)?;
            let there =
                ends.iter().map(|(distance, depth)| displacement(&material, *distance, *depth));
            let approach = contact.load * there.fold(0.0, f64::max) / approach;
            Some(Self { body: body.name.clone(), distance, approach, half_space })
        });
        found.collect()
    }

    /// A doubt about a half-space that stands for a body which ends close by.
    pub(super) fn doubt(&self) -> Option<Problem> {
        (self.half_space && self.approach > DOUBTFUL).then(|| {
            let message = format!(
                "a half-space is doubtful: the body ends {} from the contact, and a half-space is displaced there by up to {} % of the approach",
                length(self.distance),
                three(100.0 * self.approach)
            );
            Problem::warning(Key::of(["body", &self.body, "elasticity"]), message)
                .help("leave `elasticity` out to compute the body as it is")
        })
    }
}

/// Displacement (m/N) of a half-space at a distance (m) from a force, at a depth (m).
fn displacement(material: &Material, distance: f64, depth: f64) -> f64 {
    let Material { young, poisson } = *material;
    let share = 2.0 * (1.0 - poisson) + (depth / distance).powi(2);
    (1.0 + poisson) * share / (2.0 * PI * young * distance)
}

/// Distances (m) from the middle of the zone to where a body ends, and least depths (m) there.
fn ends(finite: &Finite) -> Vec<(f64, f64)> {
    let mesh = &finite.meshed.mesh;
    let held = |surface: usize| {
        finite.supports.iter().any(|&(held, support)| {
            let holds =
                matches!(support, Support::Clamped | Support::Roller | Support::Displacement(_));
            holds && held == surface
        })
    };
    let (middle, normal) = middle(finite);
    let ends = (0..mesh.faces.len()).filter(|&face| {
        let own = DVec3::from(mesh.area_vector(face)).normalize_or_zero();
        own.dot(normal) < TURNED || held(mesh.faces[face].surface)
    });
    ends.map(|face| {
        let corners = mesh.faces[face].corners.as_slice().iter();
        let corners: Vec<DVec3> = corners.map(|&corner| mesh.vertices[corner].into()).collect();
        let depths = corners.iter().map(|&corner| (middle - corner).dot(normal));
        let depth = depths.fold(f64::INFINITY, f64::min).max(0.0);
        (bem::distance(middle, &corners), depth)
    })
    .collect()
}

/// The middle of the zone (m) and the outward normal there.
fn middle(Finite { meshed, mirrored, .. }: &Finite) -> (DVec3, DVec3) {
    if !meshed.placed {
        return (DVec3::ZERO, DVec3::Z);
    }
    let (mesh, zone) = (&meshed.mesh, &meshed.zone.faces);
    let (mut place, mut normal, mut all) = (DVec3::ZERO, DVec3::ZERO, 0.0);
    for &face in zone {
        let vector = DVec3::from(mesh.area_vector(face));
        place += vector.length() * DVec3::from(mesh.centre(face));
        normal += vector;
        all += vector.length();
    }
    // Both lie on the planes of symmetry.
    let kept = DVec3::new(f64::from(!mirrored[0]), f64::from(!mirrored[1]), 1.0);
    (kept * place / all, (kept * normal).normalize_or(DVec3::Z))
}

#[cfg(test)]
mod tests {
    use super::{Finiteness, Problem, displacement};
    use archard::body::Material;

    #[test]
    fn only_half_spaces_that_end_close_by_are_doubtful() {
        let one = Finiteness {
            body: "block".to_owned(),
            distance: 0.5,
            approach: 0.07,
            half_space: true,
        };
        let Some(Problem { message, .. }) = one.doubt() else { panic!("7 % are doubtful") };
        assert!(message.contains("ends 500 mm from the contact") && message.contains("7.00 %"));
        assert!(Finiteness { approach: 0.03, ..one.clone() }.doubt().is_none());
        assert!(Finiteness { half_space: false, ..one }.doubt().is_none());
    }
    /// Beside Hertz's approach F / (4/3 E* a) of a round contact of radius a: the factors of a / r.
    #[test]
    fn the_share_of_the_approach_is_that_of_the_closed_form() {
        let material = Material { young: 1.0, poisson: 0.3 };
        let approach = 0.75 * (1.0 - 0.09);
        let on_the_surface = displacement(&material, 1.0, 0.0) / approach;
        let below = displacement(&material, 1.0, 1.0) / approach;
        assert!((on_the_surface - 4.0 / (3.0 * std::f64::consts::PI)).abs() < 1e-12);
        assert!((below / on_the_surface - 2.4 / 1.4).abs() < 1e-12);
    }
}
