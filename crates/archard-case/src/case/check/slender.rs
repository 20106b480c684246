//! Elements longer than their body is thick, where it can bend.

use super::Parts;
use crate::case::definition::BodyCase;
use crate::case::key::Key;
use crate::case::problem::Problem;
use crate::verdict::{self, Word};
use archard::body::Finite;

/// What is doubtful about the meshes of bodies in contact.
pub(super) fn problems(parts: &Parts<'_>) -> Vec<Problem> {
    // Quadratic tetrahedra bend, and so do matrices.
    let inside = |finite: &Finite| finite.elasticity.bears();
    let meshed = parts.meshed().filter(|(body, finite)| body.is_meshed() && !inside(finite));
    let found = meshed.filter_map(|(body, finite)| {
        let longest = body.finite.as_ref()?.slenderness(&finite.meshed).ok()??;
        problem(body, longest)
    });
    found.collect()
}

/// A warning where the longest element of a body, relative to its thickness there, is too long.
pub(in crate::case) fn problem(body: &BodyCase, longest: f64) -> Option<Problem> {
    let line = verdict::slenderness(longest);
    (line.word() != Word::Good).then(|| {
        let mesh = &body.finite.as_ref().map_or("", |finite| finite.mesh.choice.name);
        let key = Key::of(["body", &body.name, "mesh", mesh]);
        let message = format!(
            "an element is {longest:.2} times as long as the body is thick, where it can bend: such elements lose the balance of moments"
        );
        Problem::warning(key, message)
            .judged(line.subject)
            .help("take elements of two thirds of the thickness at most along the body, and two across")
    })
}
