//! Which positions a step goes through: by what the surfaces do.

use super::position::Positions;
use super::recurring::Recurring;
use super::stations::Stations;
use super::swing::{Swing, count};
use super::turning::Turning;
use crate::motion::{Motion, Passage};
use crate::problem::ContactProblem;

/// Those of a problem; `None` where a step sees the surfaces in one position.
pub(super) fn positions<'a>(problem: &'a ContactProblem) -> Option<Box<dyn Positions + 'a>> {
    let motion = &problem.motion;
    if let Some(table) = motion.table() {
        return Some(Box::new(Stations::of(problem, table)));
    }
    if let Some(joint) = motion.joint() {
        return Some(Box::new(Turning::of(problem, joint)?));
    }
    if let Some(moves) = motion.surfaces.iter().position(|one| *one == Passage::Recurs) {
        return Some(Box::new(Recurring::of(problem, moves)));
    }
    Some(Box::new(Swing::of(problem)?))
}

/// Contact solves of a step on elements of a length (m), so many along the motion: one a position of the surfaces, with a contact of
/// that length (m); `None` where there is one position.
pub fn solves_of_a_step(
    motion: &Motion,
    (element, elements): (f64, usize),
    contact: Option<f64>,
) -> Option<u64> {
    let stations = motion.table().map(|table| table.rows().len());
    let positions = match stations.or(motion.joint().map(|joint| joint.turns().len())) {
        Some(stations) => stations as u64,
        None if motion.surfaces.contains(&Passage::Recurs) => elements as u64,
        None => count(motion, element, contact)?,
    };
    // And the contact that is shown.
    Some(positions + 1)
}
