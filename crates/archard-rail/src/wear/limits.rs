//! Limits of wheels in service, and how far a wheel runs until it reaches one.

use super::{COLUMNS, RouteResult, SideCourse, error_of};
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
    fn reached(&self, course: &[SideCourse], side: Side) -> Option<f64> {
        let at = COLUMNS.iter().position(|column| *column == self.column)?;
        let own = course.iter().filter(|told| told.side == side);
        // A conicity is not a number where the wheelset does not steer itself back.
        let own = own.map(|told| [told.progress, told.values[at]]);
        let own: Vec<[f64; 2]> = own.filter(|[_, value]| !value.is_nan()).collect();
        let beyond = own.iter().position(|[_, value]| self.is_reached(*value))?;
        let [to, value] = own[beyond];
        let Some([from, before]) = beyond.checked_sub(1).map(|step| own[step]) else {
            return Some(to);
        };
        Some(from + (to - from) * (self.value - before) / (value - before))
    }
}

impl RouteResult {
    /// The share of the distance at which a side reaches a limit, and its error: what half the elements and steps about twice as long
    /// change in it, infinite where the wheel does not reach it then. `None` where it is not reached.
    pub fn life(&self, limit: &Limit, side: Side) -> Option<[f64; 2]> {
        let shares = self.reached(limit, side);
        shares[0].is_finite().then(|| {
            let error = error_of(shares);
            [shares[0], if error.is_nan() { f64::INFINITY } else { error }]
        })
    }

    /// The shares of the distance at which a side reaches a limit in the three runs, in the order of [`error_of`]; infinite where it
    /// does not.
    pub fn reached(&self, limit: &Limit, side: Side) -> [f64; 3] {
        self.told.each_ref().map(|course| limit.reached(course, side).unwrap_or(f64::INFINITY))
    }
}

#[cfg(test)]
mod tests {
    use super::{COLUMNS, Limit, Side, SideCourse};
    use crate::wear::CONICITY;

    /// A conicity of 0.1, then none, then 0.3: straight over what is not a number.
    #[test]
    fn a_limit_is_reached_beyond_what_is_not_a_number() {
        let told = |(progress, conicity): (f64, f64)| {
            let mut values = vec![0.0; COLUMNS.len()];
            values[COLUMNS.len() - 1] = conicity;
            SideCourse { progress, side: Side::Right, values, thinner: vec![] }
        };
        let course = [(0.0, 0.1), (0.5, f64::NAN), (1.0, 0.3)].map(told);
        let limit = Limit { column: CONICITY, value: 0.2, below: false };
        let reached = limit.reached(&course, Side::Right).unwrap();
        assert!((reached - 0.5).abs() < 1e-12, "{reached}");
        assert_eq!(limit.reached(&course, Side::Left), None);
    }
}
