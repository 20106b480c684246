//! The place on a surface that lies along a direction from a point.

use glam::{DMat3, DVec3};

use super::super::patch::Patch;
use crate::numerics::WRITTEN;

/// A place on one of some elements.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Hit {
    /// Index of the element.
    pub patch: usize,
    pub at: [f64; 2],
    /// Distance (m) along the direction.
    pub distance: f64,
}

/// How far a place may lie outside of an element, relative to its size, to be taken as one of it: plane elements cut curved surfaces short,
/// and end elsewhere than they do.
const BESIDE: f64 = 0.1;

/// The nearest place, before or behind, on the line through a point along a unit vector.
pub(super) fn project(point: DVec3, direction: DVec3, patches: &[Patch]) -> Option<Hit> {
    within(point, direction, patches, WRITTEN)
}

/// The same, or one a little outside of the elements.
pub(super) fn project_beside(point: DVec3, direction: DVec3, patches: &[Patch]) -> Option<Hit> {
    let there = || within(point, direction, patches, BESIDE);
    project(point, direction, patches).or_else(there)
}

fn within(point: DVec3, direction: DVec3, patches: &[Patch], beyond: f64) -> Option<Hit> {
    let mut nearest: Option<Hit> = None;
    for (index, patch) in patches.iter().enumerate() {
        let away = patch.centre - point;
        let beside = away - away.dot(direction) * direction;
        if beside.length() > (1.0 + 4.0 * beyond) * patch.radius {
            continue;
        }
        if let Some((at, distance)) = meet(point, direction, patch, beyond)
            && nearest.is_none_or(|nearest| distance.abs() < nearest.distance.abs())
        {
            nearest = Some(Hit { patch: index, at, distance });
        }
    }
    nearest
}

/// Where a line meets an element: Newton's method on point + distance direction = place.
fn meet(point: DVec3, direction: DVec3, patch: &Patch, beyond: f64) -> Option<([f64; 2], f64)> {
    let mut at = if patch.triangle() { [1.0 / 3.0; 2] } else { [0.0; 2] };
    let mut distance = (patch.centre - point).dot(direction);
    for _ in 0..20 {
        let off = point + distance * direction - patch.at(at);
        let [along_s, along_t] = patch.tangents(at);
        let matrix = DMat3::from_cols(along_s, along_t, -direction);
        let determinant = matrix.determinant();
        if determinant == 0.0 || !determinant.is_finite() {
            return None;
        }
        let step = matrix.inverse() * off;
        at = [at[0] + step.x, at[1] + step.y];
        distance += step.z;
        if at[0].abs().max(at[1].abs()) > 10.0 {
            return None;
        }
        if step.x.abs().max(step.y.abs()) < 1e-12 {
            break;
        }
    }
    let [s, t] = at;
    let inside = if patch.triangle() {
        s >= -beyond && t >= -beyond && s + t <= 1.0 + beyond
    } else {
        s.abs() <= 1.0 + beyond && t.abs() <= 1.0 + beyond
    };
    inside.then_some((at, distance))
}
