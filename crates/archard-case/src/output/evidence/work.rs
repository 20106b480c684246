//! Work that the motion does on the bodies in a cycle, against what friction dissipates in it.
//!
//! Over a closed cycle the elastic energy is as before, so that the area of the loops of forces over displacements is
//! what friction takes. The displacements are prescribed, or the forces. The first cycle begins from rest and is left
//! out; others are closed by their own last state, which is that of the cycle before but for a cycle's wear.

use serde::{Deserialize, Serialize};

use archard::motion::Shift;
use archard::numerics::WRITTEN;
use archard::simulation::Report;
use archard::simulation::history::{APPROACH, FORCE, LOAD, SHIFT, number};

/// Dissipation relative to the rectangle around a loop below which it is compared with the rectangle: all sticks.
const NOTHING: f64 = 0.02;

/// The increments of the present cycle: displacement and force along x and y, and normal.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub(super) struct Cycle {
    points: Vec<[[f64; 2]; 3]>,
    number: f64,
}

impl Cycle {
    /// Takes up a report and its row; at the end of a cycle, how far work and dissipation are apart.
    pub fn take(&mut self, report: &Report<'_>, row: &[(String, f64)]) -> Option<f64> {
        let shift = report.problem.motion.increments().filter(|shift| Shift::moves(shift))?;
        report.problem.friction.as_ref()?;
        if shift.released || shift.end_pressure {
            return None;
        }
        let value = |column| number(row, column).unwrap_or(f64::NAN);
        let cycle = report.state.progress / shift.period();
        let number = (cycle - WRITTEN).ceil();
        if number != self.number {
            (self.points, self.number) = (vec![], number);
        }
        self.points.push([
            [SHIFT[0], FORCE[0]].map(value),
            [SHIFT[1], FORCE[1]].map(value),
            [APPROACH, LOAD].map(value),
        ]);
        let whole = (cycle - number).abs() < WRITTEN && self.points.len() == shift.cycle.len();
        (whole && number > 1.0).then(|| self.off(report.effort.dissipated[0]))
    }

    fn off(&self, dissipated: f64) -> f64 {
        let count = self.points.len();
        let area = |axis: usize| -> f64 {
            let side = |index: usize| {
                let [[u, f], [v, g]] =
                    [self.points[(index + count - 1) % count], self.points[index]].map(|p| p[axis]);
                0.5 * (f + g) * (v - u)
            };
            (0..count).map(side).sum()
        };
        let range = |axis: usize, part: usize| {
            let values = self.points.iter().map(|point| point[axis][part]);
            let (low, high) =
                values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
            high - low
        };
        let rectangle: f64 = (0..2).map(|axis| range(axis, 0) * range(axis, 1)).sum();
        let work: f64 = (0..3).map(area).sum();
        let scale = dissipated.max(NOTHING * rectangle);
        if work == dissipated { 0.0 } else { (work - dissipated).abs() / scale }
    }
}
