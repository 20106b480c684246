//! Densities that weigh nothing.

use super::Parts;
use crate::case::definition::BodyCase;
use crate::case::key::Key;
use crate::case::problem::Problem;

/// A density of a body that does not wear, or that rolls, where sections are known and no volumes.
pub(super) fn problems(parts: &Parts<'_>) -> Vec<Problem> {
    let rolls = parts.motion.driven(0.0).is_some();
    let weighed = parts.case.bodies.iter().filter(|body| body.density.is_some());
    let doubt = |body: &BodyCase| {
        let message = match body.wears() {
            false => "has no effect on a body that does not wear",
            true if rolls => "has no effect in rolling: worn sections are known, not volumes",
            true if !body.layers.is_empty() => "weighs what is worn off the layers, too",
            true => return None,
        };
        Some(Problem::warning(Key::of(["body", &body.name, "density"]), message).at_name())
    };
    weighed.filter_map(doubt).collect()
}
