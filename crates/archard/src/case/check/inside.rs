//! Whether the points where stresses are asked for lie in their bodies.

use super::Parts;
use crate::case::key::Key;
use crate::case::problem::Problem;
use crate::compliance::bem::Surface;

/// Points outside of their bodies.
pub(super) fn problems(parts: &Parts<'_>) -> Vec<Problem> {
    let mut problems = vec![];
    let bodies = parts.case.bodies.iter().zip(&parts.meshes).zip(&parts.case.points);
    for ((body, made), points) in bodies {
        let (Some(finite), Some(made), false) = (&body.finite, made, points.is_empty()) else {
            continue;
        };
        let surface = Surface::new(&made.meshed.mesh, finite.interpolation, finite.mirrored);
        for point in points {
            if surface.depth(point.place.into()).is_none() {
                let key = Key::of(["output", "points", &body.name, &point.name]);
                problems.push(Problem::error(key, "lies outside of the body"));
            }
        }
    }
    problems
}
