//! Limits of wheels in service, and how far a wheel runs until it reaches one.

use super::{COLUMNS, Told, Travelled, error_of};
use crate::setup::Side;

/// A bound of one of the [`COLUMNS`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limit {
    /// The column.
    pub column: &'static str,
    /// The bound (SI).
    pub value: f64,
    /// Whether the wheel is worn below it, as a flange that is too thin, and not above.
    pub below: bool,
}

impl Limit {
    /// The limits in service by the diameter (m) of a wheel, of EN 15313 as Austria's rules of operation (EisbBBV, annex 2) have them: least
    /// thickness Sd, largest height Sh and least gradient qR of the flange.
    pub fn in_service(diameter: f64) -> [Self; 3] {
        let thickness = if diameter > 0.84 { 22e-3 } else { 27.5e-3 };
        [
            Self { column: "flange_thickness_m", value: thickness, below: true },
            Self { column: "flange_height_m", value: 36e-3, below: false },
            Self { column: "flange_gradient_m", value: 6.5e-3, below: true },
        ]
    }

    /// Whether a value is at the limit or beyond it.
    pub fn is_reached(&self, value: f64) -> bool {
        if self.below { value <= self.value } else { value >= self.value }
    }

    /// The share of the distance at which a course reaches it, straight between its steps; `None` where it does not.
    fn reached(&self, course: &[Told], side: Side) -> Option<f64> {
        let at = COLUMNS.iter().position(|column| *column == self.column)?;
        let own = course.iter().filter(|told| told.side == side);
        let own: Vec<[f64; 2]> = own.map(|told| [told.progress, told.values[at]]).collect();
        let beyond = own.iter().position(|[_, value]| self.is_reached(*value))?;
        let [to, value] = own[beyond];
        let Some([from, before]) = beyond.checked_sub(1).map(|step| own[step]) else {
            return Some(to);
        };
        Some(from + (to - from) * (self.value - before) / (value - before))
    }
}

impl Travelled {
    /// The share of the distance at which a side reaches a limit, and its error: what half the elements and steps about twice as long
    /// change in it, infinite where the wheel does not reach it then. `None` where it is not reached.
    pub fn life(&self, limit: &Limit, side: Side) -> Option<[f64; 2]> {
        let [fine, coarse, hasty] =
            self.told.each_ref().map(|course| limit.reached(course, side).unwrap_or(f64::INFINITY));
        fine.is_finite().then(|| {
            let error = error_of([fine, coarse, hasty]);
            [fine, if error.is_nan() { f64::INFINITY } else { error }]
        })
    }
}
