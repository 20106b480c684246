//! The place of the surface nearest to a point, and whether the point is inside.

use std::array;
use std::f64::consts::TAU;

use glam::{DMat2, DVec2, DVec3};

use super::super::patch::Patch;
use super::super::surface::Surface;
use crate::numerics::triangle::{on_triangle, solid_angle};

/// The place of the surface nearest to a point.
#[derive(Debug, Clone, Copy)]
pub(super) struct Nearest {
    pub face: usize,
    /// The mirror image it belongs to.
    pub image: DVec3,
    /// Reference coordinates on the element.
    pub reference: [f64; 2],
    /// The place (m) and how far it is from the point (m).
    pub at: DVec3,
    pub distance: f64,
    /// Length of the element (m).
    pub size: f64,
    /// Whether the surface encloses the point.
    pub inside: bool,
}

impl Nearest {
    /// A place of an element itself.
    pub fn on_element(patch: &Patch, face: usize, reference: [f64; 2]) -> Self {
        let (at, size) = (patch.at(reference), size(patch));
        Self { face, image: DVec3::ONE, reference, at, distance: 0.0, size, inside: true }
    }
}

/// Length of an element (m).
fn size(patch: &Patch) -> f64 {
    2.0 * patch.half[0].max(patch.half[1])
}

/// Improvements of the place on an element that is no parallelogram.
const STEPS: usize = 3;

/// The place of the surface and its mirror images nearest to a point; `None` without elements.
pub(super) fn nearest(surface: &Surface, point: DVec3) -> Option<Nearest> {
    let mut nearest: Option<Nearest> = None;
    let mut angle = 0.0;
    for image in surface.images() {
        let seen = image * point;
        for (face, patch) in surface.patches.iter().enumerate() {
            let place = |corner: usize| patch.corners[corner] - seen;
            angle += solid_angle([0, 1, 2].map(place));
            if !patch.triangle() {
                angle += solid_angle([0, 2, 3].map(place));
            }
            let least = nearest.map_or(f64::INFINITY, |nearest| nearest.distance);
            if seen.distance(patch.centre) - patch.radius >= least {
                continue;
            }
            let reference = on(patch, seen);
            let distance = patch.at(reference).distance(seen);
            if distance < least {
                let on = Nearest::on_element(patch, face, reference);
                nearest = Some(Nearest { image, at: image * on.at, distance, inside: false, ..on });
            }
        }
    }
    nearest.map(|nearest| Nearest { inside: angle > TAU, ..nearest })
}

/// Reference coordinates of the place on an element nearest to a point.
fn on(patch: &Patch, point: DVec3) -> [f64; 2] {
    let from = |corners: [usize; 3]| {
        let shares = on_triangle(point, corners.map(|corner| patch.corners[corner]));
        let reference: [f64; 2] = array::from_fn(|axis| {
            shares.iter().zip(corners).map(|(s, c)| s * patch.element.corners[c][axis]).sum()
        });
        (patch.at(reference).distance(point), reference)
    };
    let first = from([0, 1, 2]);
    if patch.triangle() {
        return first.1;
    }
    let second = from([0, 2, 3]);
    let mut reference = DVec2::from(if first.0 <= second.0 { first.1 } else { second.1 });
    if patch.is_parallelogram() {
        return reference.into();
    }
    for _ in 0..STEPS {
        let [s, t] = patch.tangents(reference.into());
        let away = point - patch.at(reference.into());
        let normal = DMat2::from_cols_array(&[s.dot(s), s.dot(t), s.dot(t), t.dot(t)]).inverse();
        let step = normal * DVec2::new(s.dot(away), t.dot(away));
        reference = (reference + step).clamp(DVec2::NEG_ONE, DVec2::ONE);
    }
    reference.into()
}
