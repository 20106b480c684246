//! Whether the points and sections where stresses are asked for lie in their bodies.

use super::Parts;
use crate::case::key::Key;
use crate::case::problem::Problem;
use crate::compliance::bem::Surface;

/// Points outside of their bodies, sections without places.
pub(super) fn problems(parts: &Parts<'_>) -> Vec<Problem> {
    let mut problems = vec![];
    let wanted = parts.case.points.iter().zip(&parts.case.sections);
    for (body, (points, sections)) in parts.bodies.iter().zip(wanted) {
        let any = !points.is_empty() || !sections.is_empty();
        let Some(finite) = body.finite.as_ref().filter(|_| any) else { continue };
        let surface = Surface::new(&finite.meshed.mesh, finite.interpolation, finite.mirrored);
        for point in points {
            if surface.depth(point.place.into()).is_none() {
                let key = Key::of(["output", "points", &body.name, &point.name]);
                problems.push(Problem::error(key, "lies outside of the body"));
            }
        }
        for section in sections {
            if let Err(cause) = section.check(&surface) {
                let key = ["output", "sections", &body.name, &section.name, cause.parameter()];
                problems.push(Problem::error(Key::of(key), cause.to_string()));
            }
        }
    }
    problems
}
