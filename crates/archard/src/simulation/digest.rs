//! Whether two simulations are the same.

use super::setup::Simulation;

/// A hash of what the steps of a simulation follow from. Of compliances that have a matrix, which follow from meshes, it
/// takes a few entries.
pub fn digest(simulation: &Simulation) -> [u8; 32] {
    let Simulation { problem, solver, friction_solver, schedule, .. } = simulation;
    let mut hash = blake3::Hasher::new();
    for body in &problem.bodies {
        hash.update(
            format!(
                "{}{:?}{:?}{:?}{:?}",
                body.name,
                body.material,
                body.wear,
                body.curvatures(),
                body.depth
            )
            .as_bytes(),
        );
        if let Some(hardness) = body.hardness {
            hash.update(&hardness.to_le_bytes());
        }
        if let Some(thermal) = &body.thermal {
            hash.update(format!("{thermal:?}").as_bytes());
        }
    }
    hash.update(format!("{:?}{:?}{schedule:?}", problem.friction, problem.motion).as_bytes());
    hash.update(format!("{:?}{:?}", solver.settings(), friction_solver.settings()).as_bytes());
    hash.update(format!("{solver:?}{friction_solver:?}").as_bytes());
    let frame = &problem.frame;
    hash.update(
        format!("{:?}{:?}{}", frame.elements(), frame.rectangle(), frame.is_line()).as_bytes(),
    );
    let pairs = frame.len();
    let few = [0, pairs / 2, pairs.saturating_sub(1)];
    let few = problem.compliance.matrix(&few);
    let few = few.iter().flatten();
    let own = [problem.compliance.normal_self_term()];
    // Elements and size tell the places on a uniform grid.
    let listed = if frame.is_uniform() { 0 } else { pairs };
    let places = (0..listed).flat_map(|pair| frame.place(pair));
    let numbers = frame.gap().iter().chain(&own).chain(few).copied().chain(places);
    let bytes: Vec<u8> = numbers.flat_map(f64::to_le_bytes).collect();
    hash.update(&bytes);
    if let Some(wider) = &simulation.wider {
        hash.update(&wider.from.to_le_bytes());
        hash.update(&digest(&wider.simulation));
    }
    hash.finalize().into()
}
