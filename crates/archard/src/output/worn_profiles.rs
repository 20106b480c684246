//! The transverse profiles of surfaces that pass, before and after wear.

use super::Error;
use super::fields::height;
use super::table::{Table, number};
use crate::frame::{Direction, Line};
use crate::problem::{ContactProblem, ContactState};

/// The bodies across the direction of rolling, on the line through the middle of the frame.
pub(super) struct WornProfiles<'a> {
    problem: &'a ContactProblem,
    state: &'a ContactState,
    direction: Direction,
}

impl<'a> WornProfiles<'a> {
    /// The profiles of a state; `None` unless surfaces pass and may wear while they do.
    pub(super) fn of(problem: &'a ContactProblem, state: &'a ContactState) -> Option<Self> {
        Some(Self { problem, state, direction: problem.motion.worn_along()?.0 })
    }

    /// Adds the profiles to a table, a row a line of rolling.
    pub(super) fn write(&self, table: &mut Table) -> Result<(), Error> {
        let Self { problem, state, direction } = *self;
        let (axis, frame) = (direction.axis, &problem.frame);
        let progress = (problem.motion.progress().column.to_owned(), state.progress);
        let Ok(flow) = frame.flow(direction) else { return Ok(()) };
        let lines = flow.lines();
        let mut places: Vec<(&Line, f64)> = lines.iter().map(|line| (line, line.place)).collect();
        if frame.mirrored()[1 - axis] {
            places.extend(lines.iter().map(|line| (line, -line.place)));
            places.sort_by(|a, b| a.1.total_cmp(&b.1));
        }
        for (line, across) in places {
            let mut place = [0.0; 2];
            place[1 - axis] = across;
            let mut row = vec![progress.clone()];
            row.push((["y_m", "x_m"][axis].to_owned(), place[1 - axis]));
            for (index, body) in problem.bodies.iter().enumerate() {
                let (name, worn) = (&body.name, line.mean(&state.worn[index]));
                row.push((format!("height_{name}_before_m"), height(problem, index, place, 0.0)));
                row.push((format!("height_{name}_m"), height(problem, index, place, worn)));
                row.push((format!("wear_{name}_m"), worn));
            }
            let cells: Vec<_> =
                row.iter().map(|(column, value)| (column.as_str(), number(*value))).collect();
            table.row(&cells)?;
        }
        table.flush()
    }
}
