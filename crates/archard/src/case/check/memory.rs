//! Whether the machine holds what a case takes.

use super::Parts;
use crate::body::mesh::Shape;
use crate::case::chosen::Chosen;
use crate::case::definition::BodyCase;
use crate::case::key::Key;
use crate::case::problem::Problem;

/// Memory (bytes) taken for free where the system does not say.
const UNKNOWN: f64 = 16e9;
/// Share of the free memory beyond which a case is worth a warning.
const LARGE: f64 = 0.5;

/// Memory (bytes) that is free.
pub(in crate::case) fn available() -> f64 {
    let said = std::fs::read_to_string("/proc/meminfo").ok();
    said.and_then(|text| free_in(&text)).unwrap_or(UNKNOWN)
}

/// The free memory (bytes) in the words of Linux: "MemAvailable:   12345 kB".
fn free_in(text: &str) -> Option<f64> {
    let line = text.lines().find_map(|line| line.strip_prefix("MemAvailable:"))?;
    let kilobytes: f64 = line.split_whitespace().next()?.parse().ok()?;
    Some(1024.0 * kilobytes)
}

/// An error where that memory (bytes) is more than is free, without its key.
pub(in crate::case) fn too_large(memory: f64, free: f64) -> Option<Problem> {
    (memory > free).then(|| {
        let message = format!(
            "the equations would take about {} of memory, {} are free",
            size(memory),
            size(free)
        );
        Problem::error(Key::default(), message).help(FEWER)
    })
}

const FEWER: &str = "take fewer elements: half as many along both sides take a sixteenth; or halve the body by planes of `symmetry`, each of which leaves a quarter";

/// What is wrong with the memory (bytes) that meshed bodies take.
pub(super) fn problems(parts: &Parts<'_>, memory: f64) -> Option<Problem> {
    parts.largest().and_then(|body| of_body(body, memory))
}

/// A solver whose matrices (bytes) are too large.
pub(super) fn of_solver(parts: &Parts<'_>, memory: f64) -> Option<Problem> {
    let problem = too_large(memory, available())?;
    let key = Key::of(["solver", parts.case.solver.choice.name]);
    let help = "leave it out: the default needs no matrix; or take fewer elements";
    Some(Problem { key, ..problem }.at_name().help(help))
}

/// What is wrong with the memory (bytes) that a case takes whose largest mesh is that of a body.
pub(in crate::case) fn of_body(body: &BodyCase, memory: f64) -> Option<Problem> {
    let mesh = &body.finite.as_ref()?.mesh;
    let key = key(Key::of(["body", &body.name, "mesh"]), mesh);
    judged(memory, available()).map(|problem| Problem { key, ..problem })
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
pub(in crate::case) fn key(mesh: Key, chosen: &Chosen<Box<dyn Shape>>) -> Key {
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
fn size(bytes: f64) -> String {
    match bytes {
        _ if bytes < 1e9 => format!("{:.0} MB", 1e-6 * bytes),
        _ if bytes < 1e10 => format!("{:.1} GB", 1e-9 * bytes),
        _ => format!("{:.0} GB", 1e-9 * bytes),
    }
}

#[cfg(test)]
mod tests {
    use super::{free_in, judged};
    use crate::case::problem::Severity;

    #[test]
    fn free_memory_is_read() {
        let text = "MemTotal:       24537084 kB\nMemFree: 1 kB\nMemAvailable:   23000000 kB\n";
        assert_eq!(free_in(text), Some(23000000.0 * 1024.0));
        assert_eq!(free_in("MemTotal: 1 kB\n"), None);
    }

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
