//! The transverse profiles of bodies before and after wear, where a surface passes.
//!
//! A surface that passes is worn equally along the motion: its profile is the mean over each line. A body that stays under the
//! contact has a section of its own at each place along the motion; the profile is that through the middle.

use super::Error;
use super::fields::height;
use super::table::{Table, number};
use archard::frame::{Direction, Line};
use archard::numerics::WRITTEN;
use archard::problem::{ContactProblem, ContactState};

/// The bodies across the direction of motion, on the line through the middle of the frame.
pub(super) struct WornProfiles<'a> {
    problem: &'a ContactProblem,
    state: &'a ContactState,
    direction: Direction,
    /// Which bodies pass.
    passes: [bool; 2],
}

impl<'a> WornProfiles<'a> {
    /// The profiles of a state; `None` unless surfaces pass and may wear while they do.
    pub(super) fn of(problem: &'a ContactProblem, state: &'a ContactState) -> Option<Self> {
        let (direction, passes) = problem.motion.grooves()?;
        Some(Self { problem, state, direction, passes })
    }

    /// Adds the profiles to a table, a row a line of rolling.
    pub(super) fn write(&self, table: &mut Table) -> Result<(), Error> {
        let Self { problem, state, direction, .. } = *self;
        let (axis, frame) = (direction.axis, &problem.frame);
        let progress = (problem.motion.progress.column.to_owned(), state.progress);
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
                let (name, worn) = (&body.name, self.depth(line, index));
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

    /// How deep (m) a body is worn on a line.
    fn depth(&self, line: &Line, body: usize) -> f64 {
        let (frame, worn) = (&self.problem.frame, self.state.worn(body));
        if self.passes[body] {
            return line.mean(&worn);
        }
        // The middle runs through a pair of the line, or between two.
        let axis = self.direction.axis;
        let away = |pair: usize| frame.place(pair)[axis].abs();
        let nearest = line.passages.iter().map(|one| away(one.pair)).fold(f64::INFINITY, f64::min);
        let within = nearest + WRITTEN * frame.spacing()[axis];
        let middle = line.passages.iter().filter(|one| away(one.pair) <= within);
        let [sum, share] = middle.fold([0.0; 2], |[sum, share], one| {
            [sum + one.share * worn[one.pair], share + one.share]
        });
        if share > 0.0 { sum / share } else { 0.0 }
    }
}
