//! The worn surface of a body that swings, from end to end.

use super::Error;
use super::table::{Table, number};
use archard::problem::{ContactProblem, ContactState};

/// Adds a row for each place along the motion of a surface that swings: its worn section across, and the deepest wear there.
pub(super) fn write(
    table: &mut Table,
    (problem, state): (&ContactProblem, &ContactState),
    (body, axis): (usize, usize),
) -> Result<(), Error> {
    let surface = &state.surfaces[body];
    let (element, width) = (problem.frame.spacing()[axis], problem.frame.size()[1 - axis]);
    let middle = 0.5 * (surface.grid.elements()[axis] as f64 - 1.0);
    let name = &problem.bodies[body].name;
    let [section, depth] = [format!("section_{name}_m2"), format!("depth_{name}_m")];
    for (index, [mean, most]) in surface.along(axis).into_iter().enumerate() {
        let place = (index as f64 - middle) * element;
        table.row(&[
            (problem.motion.progress.column, number(state.progress)),
            (["x_m", "y_m"][axis], number(place)),
            (&section, number(width * mean)),
            (&depth, number(most)),
        ])?;
    }
    table.flush()
}
