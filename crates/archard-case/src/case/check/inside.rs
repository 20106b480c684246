//! Whether the points and sections where stresses are asked for lie in their bodies.

use super::Parts;
use crate::case::key::Key;
use crate::case::problem::Problem;
use archard::compliance::bem::Surface;

/// Points outside of their bodies, sections without places.
pub(super) fn problems(parts: &Parts<'_>) -> Vec<Problem> {
    let mut problems = vec![];
    let bodies = parts.case.bodies.iter().zip(&parts.case.sections);
    let mut files: Vec<String> = vec![];
    for (body, section) in
        bodies.flat_map(|(body, sections)| sections.iter().map(|one| (&body.name, one)))
    {
        let file = format!("{body}_{}", section.name);
        if files.contains(&file) {
            let key = Key::of(["output", "sections", body, &section.name]);
            let message =
                format!("another section is `sections/{file}.vtu` too: give it another name");
            problems.push(Problem::error(key, message));
        }
        files.push(file);
    }
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
