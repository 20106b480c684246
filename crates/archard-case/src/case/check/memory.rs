//! Whether the machine holds what a case takes.

use super::Parts;
use crate::case::chosen::ChosenPart;
use crate::case::definition::BodyCase;
use crate::case::key::Key;
use crate::case::problem::Problem;
pub(in crate::case) use crate::files::{available_to_equations, free_memory};
use archard::body::mesh::Shape;
use archard::body::{Elasticity, Finite};
use archard::compliance::bem;

/// Share of the free memory beyond which a case is worth a warning.
const LARGE: f64 = 0.5;

/// An error where that memory (bytes) is more than is free, without its key.
pub(in crate::case) fn too_large(memory: f64, free: f64) -> Option<Problem> {
    (memory > free).then(|| {
        let [memory, free] = [memory, free].map(size);
        let message = format!("the equations would take about {memory} of memory, {free} are free");
        Problem::error(Key::default(), message).help(FEWER)
    })
}

const FEWER: &str = "take fewer elements: half as many along both sides take a sixteenth; or halve the body by planes of `symmetry`, each of which leaves a quarter";

/// The same for image fields, whose elements are small against a zone near an edge.
const NEAR: &str = "make the box smaller, move the zone away from its edges, or take a mesh around it: `elasticity = \"boundary_elements\"`";

/// The same for files.
pub(in crate::case) const COARSER: &str = "take fewer `contact.elements` or a smaller box; or mesh the file coarser, in Gmsh by a larger `Mesh.MeshSizeMin` and `Mesh.MeshSizeMax`; or halve the body by planes of `symmetry`";

/// What is wrong with the memory (bytes) that a run takes.
pub(super) fn problems(parts: &Parts<'_>, memory: f64) -> Option<Problem> {
    if let Some(body) = parts.largest() {
        return of_body(body, memory);
    }
    let problem = judged(memory, free_memory())?;
    let equations = |finite: &Finite| bem::memory([Some(super::size(finite)), None]);
    let mut meshed = parts.meshed();
    if let Some((body, _)) = meshed.find(|(_, finite)| equations(finite) > 0.5 * memory)
        && let Some(finite) = &body.finite
    {
        let key = Key::of(["body", &body.name, "mesh", finite.mesh.choice.name]);
        return Some(Problem { key, ..problem }.help(NEAR));
    }
    let problem =
        Problem { message: problem.message.replace("the equations", "the run"), ..problem };
    let help = "take fewer elements: half as many along both sides take a quarter";
    Some(Problem { key: parts.frame_key("elements"), ..problem }.help(help))
}

/// What is wrong with the memory (bytes) that a case takes whose largest mesh is that of a body.
pub(in crate::case) fn of_body(body: &BodyCase, memory: f64) -> Option<Problem> {
    let finite = body.finite.as_ref()?;
    let (mesh, free) = match finite.elasticity {
        Elasticity::BoundaryElements => (&finite.mesh, available_to_equations()),
        _ => (&finite.mesh, free_memory()),
    };
    let key = key(Key::of(["body", &body.name, "mesh"]), mesh);
    let problem = judged(memory, free).map(|problem| Problem { key, ..problem })?;
    Some(match finite.mesh.values.get("path") {
        Some(_) => problem.help(COARSER),
        None => problem,
    })
}

fn judged(memory: f64, free: f64) -> Option<Problem> {
    too_large(memory, free).or_else(|| {
        (memory > LARGE * free).then(|| {
            let message = format!(
                "the equations will take about {} of memory, {} are free",
                size(memory),
                size(free)
            );
            Problem::warning(Key::default(), message).help(FEWER)
        })
    })
}

/// What to change about a mesh that is too large.
pub(in crate::case) fn key(mesh: Key, chosen: &ChosenPart<Box<dyn Shape>>) -> Key {
    let key = mesh.child(chosen.choice.name);
    let given = |name: &str| chosen.values.get(name).is_some();
    if chosen.values.section("contact").is_some() {
        key.child("contact").child("elements")
    } else if given("divisions") {
        key.child("divisions")
    } else if given("path") {
        key.child("path")
    } else {
        key
    }
}

/// A size (bytes) in words.
pub(in crate::case) fn size(bytes: f64) -> String {
    match bytes {
        _ if bytes < 1e9 => format!("{:.0} MB", 1e-6 * bytes),
        _ if bytes < 1e10 => format!("{:.1} GB", 1e-9 * bytes),
        _ => format!("{:.0} GB", 1e-9 * bytes),
    }
}

#[cfg(test)]
mod tests {
    use super::judged;
    use crate::case::problem::Severity;

    #[test]
    fn what_does_not_fit_is_refused_and_what_hardly_fits_is_said() {
        assert_eq!(judged(7e9, 16e9), None);
        let tight = judged(9e9, 16e9).expect("more than half");
        assert_eq!(tight.severity, Severity::Warning);
        let message = "the equations will take about 9.0 GB of memory, 16 GB are free";
        assert_eq!(tight.message, message);
        let beyond = judged(1.7e10, 16e9).expect("more than all");
        assert_eq!(beyond.severity, Severity::Error);
        assert!(beyond.message.contains("would take about 17 GB"));
    }
}
