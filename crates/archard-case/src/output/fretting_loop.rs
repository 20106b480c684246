//! Force over shift, cycle by cycle.

use serde::{Deserialize, Serialize};

use super::Error;
use super::table::{Table, number};
use archard::motion::Shift;
use archard::numerics::WRITTEN;
use archard::simulation::Report;
use archard::simulation::history::{self, CYCLE, FORCE, LOAD, SHIFT, STICK_AREA};

/// What a loop holds, by the columns of the history.
const COLUMNS: [&str; 7] = [CYCLE, SHIFT[0], SHIFT[1], FORCE[0], FORCE[1], LOAD, STICK_AREA];

/// The increments of the present cycle, kept until its end shows whether they are put out: those of the
/// first cycle and of every cycle in which an output falls due are.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub(super) struct FrettingLoop {
    points: Vec<[f64; COLUMNS.len()]>,
    /// The number of the cycle, from 1 on.
    cycle: f64,
    due: bool,
}

impl FrettingLoop {
    /// Takes up a report, whose row of the history is given; says whether the loop is now complete and
    /// to be put out. Only motions that shift the bodies have one.
    pub(super) fn take(&mut self, report: &Report<'_>, row: &[(String, f64)]) -> bool {
        if !report.problem.motion.increments().is_some_and(Shift::moves) {
            return false;
        }
        let point = COLUMNS.map(|column| history::number(row, column).unwrap_or(f64::NAN));
        let cycle = (point[0] - WRITTEN).ceil();
        if cycle != self.cycle {
            // Where cycles were jumped over, the last point is not where this one begins.
            let begins = |last: &[f64; COLUMNS.len()]| (last[0] - (cycle - 1.0)).abs() < WRITTEN;
            self.points = self.points.last().copied().filter(begins).into_iter().collect();
            (self.cycle, self.due) = (cycle, cycle == 1.0);
        }
        self.points.push(point);
        self.due |= report.output;
        self.due && cycle >= 1.0 && (point[0] - cycle).abs() < WRITTEN
    }

    /// Adds the loop to a table, a row an increment, from where the cycle begins if that was computed.
    pub(super) fn write(&self, table: &mut Table) -> Result<(), Error> {
        for point in &self.points {
            let cells: Vec<_> =
                COLUMNS.into_iter().zip(point.iter().map(|value| number(*value))).collect();
            table.row(&cells)?;
        }
        table.flush()
    }
}
