//! Whether the points where stresses are asked for lie in their bodies.

use super::Parts;
use crate::case::key::Key;
use crate::case::problem::Problem;
use crate::compliance::bem::Surface;

/// Points outside of their bodies.
pub(super) fn problems(parts: &Parts<'_>) -> Vec<Problem> {
    let mut problems = vec![];
    for (body, points) in parts.bodies.iter().zip(&parts.case.points) {
        let Some(finite) = body.finite.as_ref().filter(|_| !points.is_empty()) else { continue };
        let surface = Surface::new(&finite.meshed.mesh, finite.interpolation, finite.mirrored);
        for point in points {
            if surface.depth(point.place.into()).is_none() {
                let key = Key::of(["output", "points", &body.name, &point.name]);
                problems.push(Problem::error(key, "lies outside of the body"));
            }
        }
    }
    problems
}
